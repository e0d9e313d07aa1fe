//! The largest extent of the stack, from the paint that is left below it.

/// What the start-up paints the stack with.
const PAINT: u32 = 0xC5C5_C5C5;

unsafe extern "C" {
    static data_start: u32;
    static bss_end: u32;
    static stack_top: u32;
}

/// The bytes that the stack has held so far.
pub fn used() -> usize {
    let (mut lowest, top) = (&raw const bss_end, &raw const stack_top);
    // SAFETY: the linker script reserves the words between the two symbols for the stack, aligned to 8 bytes.
    while lowest < top && unsafe { lowest.read_volatile() } == PAINT {
        lowest = lowest.wrapping_add(1);
    }
    top as usize - lowest as usize
}

/// The bytes of static values.
pub fn static_memory() -> usize {
    &raw const bss_end as usize - &raw const data_start as usize
}
