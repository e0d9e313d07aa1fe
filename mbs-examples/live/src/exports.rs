//! The functions that the page calls.
//!
//! Numbers go both ways through one buffer of [`ROOM`] numbers that stays in place, texts come by pointer and length.
//! Each function returns how many numbers, bytes or steps there are; a negative result −n means that the call failed,
//! and that the reason is a text of n bytes.

use crate::description::describe;
use crate::{Figure, MECHANISMS, Refusal};
use std::cell::Cell;

/// Numbers in the buffer.
pub const ROOM: usize = 512;

struct Page {
    figure: Figure,
    buffer: [f64; ROOM],
    text: String,
}

thread_local! {
    // Taken by the call that runs and put back at its end.
    static PAGE: Cell<Option<Box<Page>>> = const { Cell::new(None) };
}

fn with<T>(work: impl FnOnce(&mut Page) -> T) -> T {
    let mut page = PAGE.take().unwrap_or_else(|| {
        Box::new(Page {
            figure: Figure::default(),
            buffer: [0.0; ROOM],
            text: String::new(),
        })
    });
    let result = work(&mut page);
    PAGE.set(Some(page));
    result
}

fn answer(work: impl FnOnce(&mut Page) -> Result<usize, Refusal>) -> i32 {
    with(|page| match work(page) {
        Ok(count) => i32::try_from(count).unwrap_or(i32::MAX),
        Err(refusal) => {
            page.text = refusal.to_string();
            -i32::try_from(page.text.len()).unwrap_or(i32::MAX)
        }
    })
}

/// Where the buffer is.
#[unsafe(no_mangle)]
pub extern "C" fn live_buffer() -> *const f64 {
    with(|page| page.buffer.as_ptr())
}

/// Where the last text is, UTF-8.
#[unsafe(no_mangle)]
pub extern "C" fn live_text() -> *const u8 {
    with(|page| page.text.as_ptr())
}

/// Makes the [description](crate::description) of a mechanism the text; its length.
#[unsafe(no_mangle)]
pub extern "C" fn live_describe(mechanism: u32) -> i32 {
    answer(|page| {
        let index = mechanism as usize;
        let chosen = MECHANISMS.get(index).ok_or(Refusal::Mechanism(index))?;
        page.text = describe(chosen);
        Ok(page.text.len())
    })
}

/// [`Figure::start`] with the first `count` numbers of the buffer as parameters.
#[unsafe(no_mangle)]
pub extern "C" fn live_start(run: u32, mechanism: u32, method: u32, step: f64, count: u32) -> i32 {
    answer(|page| {
        let parameters = &page.buffer[..ROOM.min(count as usize)];
        let [run, mechanism, method] = [run, mechanism, method].map(|index| index as usize);
        let started = page.figure.start(run, mechanism, method, step, parameters);
        started.map(|()| 0)
    })
}

/// [`Figure::advance`].
#[unsafe(no_mangle)]
pub extern "C" fn live_advance(run: u32, time: f64, most: u32) -> i32 {
    answer(|page| page.figure.advance(run as usize, time, most as usize))
}

/// [`Figure::read`] into the buffer.
#[unsafe(no_mangle)]
pub extern "C" fn live_read(run: u32) -> i32 {
    answer(|page| page.figure.read(run as usize, &mut page.buffer))
}
