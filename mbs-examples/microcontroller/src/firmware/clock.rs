//! Instructions, by the SysTick timer of an emulator that takes one nanosecond for each.
//!
//! The processor of the board has 25 MHz, so that the timer counts once in 40 ns, which are 40 instructions with
//! `-icount shift=0`. An emulator has no pipeline and no flash: it counts instructions, not cycles.

/// Instructions in a count of the timer.
const INSTRUCTIONS: u32 = 40;

/// Control, reload and current value.
const SYSTICK: *mut u32 = 0xE000_E010 as *mut u32;

/// The timer counts down in 24 bits.
const MOST: u32 = 0x00FF_FFFF;

/// Starts the timer with the clock of the processor, and waits for its first count: until then it is zero.
pub fn start() {
    // SAFETY: the registers of SysTick exist in every Cortex-M4, and nothing else uses them.
    unsafe {
        SYSTICK.wrapping_add(1).write_volatile(MOST);
        SYSTICK.wrapping_add(2).write_volatile(0);
        SYSTICK.write_volatile(0b101);
        while SYSTICK.wrapping_add(2).read_volatile() == 0 {}
    }
}

/// Counts since the start; in a run of less than 0.67 s they do not wrap.
pub fn now() -> u32 {
    // SAFETY: as above.
    MOST - unsafe { SYSTICK.wrapping_add(2).read_volatile() }
}

/// Counts as instructions.
pub fn instructions(counts: u32) -> u32 {
    counts * INSTRUCTIONS
}
