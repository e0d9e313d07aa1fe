//! Times in messages.

use core::fmt::{self, Write};

/// A time as a sum of steps, without the round-off of the sum: to twelve digits.
pub(super) fn clock(time: f64) -> f64 {
    let mut text = Text::default();
    let written = write!(text, "{time:.11e}");
    let read = core::str::from_utf8(&text.bytes[..text.length]);
    match (written, read) {
        (Ok(()), Ok(read)) => read.parse().unwrap_or(time),
        _ => time,
    }
}

/// A length of time: with an exponent where it has many zeros.
pub(super) struct Short(pub(super) f64);

impl fmt::Display for Short {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match has_few_zeros(self.0) {
            true => fmt::Display::fmt(&clock(self.0), out),
            false => write!(out, "{:.1e}", self.0),
        }
    }
}

/// A given number with all of its digits: with an exponent where it has many zeros.
pub(super) struct Whole(pub(super) f64);

impl fmt::Display for Whole {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match has_few_zeros(self.0) {
            true => fmt::Display::fmt(&self.0, out),
            false => fmt::LowerExp::fmt(&self.0, out),
        }
    }
}

fn has_few_zeros(value: f64) -> bool {
    value == 0.0 || (1e-4..1e5).contains(&value.abs())
}

/// Room for a number of twelve digits with its exponent.
#[derive(Default)]
struct Text {
    bytes: [u8; 24],
    length: usize,
}

impl Write for Text {
    fn write_str(&mut self, part: &str) -> fmt::Result {
        let end = self.length + part.len();
        let place = self.bytes.get_mut(self.length..end).ok_or(fmt::Error)?;
        place.copy_from_slice(part.as_bytes());
        self.length = end;
        Ok(())
    }
}
