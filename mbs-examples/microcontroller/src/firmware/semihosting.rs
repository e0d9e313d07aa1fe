//! Texts and the end of the program, by semihosting: a breakpoint that the emulator or the debugger serves.

use core::arch::asm;
use core::fmt;

const WRITE_TEXT: u32 = 0x04;
const EXIT: u32 = 0x18;
const APPLICATION_EXIT: usize = 0x2_0026;
const RUN_TIME_ERROR: usize = 0x2_0023;

/// The standard output of the host.
pub struct Host;

impl fmt::Write for Host {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        // The call takes text that ends with a zero: in pieces from the stack.
        for part in text.as_bytes().chunks(63) {
            let mut buffer = [0; 64];
            buffer[..part.len()].copy_from_slice(part);
            call(WRITE_TEXT, buffer.as_ptr() as usize);
        }
        Ok(())
    }
}

/// Ends the emulation.
pub fn exit(well: bool) -> ! {
    let reason = if well {
        APPLICATION_EXIT
    } else {
        RUN_TIME_ERROR
    };
    loop {
        call(EXIT, reason);
    }
}

fn call(operation: u32, argument: usize) {
    // SAFETY: both operations read their argument and return in r0.
    unsafe {
        asm!("bkpt 0xAB", inout("r0") operation => _, in("r1") argument);
    }
}
