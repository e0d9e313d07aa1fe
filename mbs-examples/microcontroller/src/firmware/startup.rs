//! From reset to `run`: the vector table, the floating-point unit, static values, and a painted stack.

use core::arch::global_asm;

global_asm!(
    r#"
    .section .vectors, "a"
    .word   stack_top
    .word   reset
    .rept   14
    .word   fault
    .endr

    .section .text.reset, "ax"
    .thumb_func
    .global reset
reset:
    // CPACR: access to the floating-point unit, which holds arguments and results.
    ldr     r0, =0xE000ED88
    ldr     r1, [r0]
    orr     r1, r1, #(0xF << 20)
    str     r1, [r0]
    dsb
    isb
    ldr     r0, =data_start
    ldr     r1, =data_end
    ldr     r2, =data_source
1:  cmp     r0, r1
    bhs     2f
    ldr     r3, [r2], #4
    str     r3, [r0], #4
    b       1b
2:  ldr     r1, =bss_end
    movs    r3, #0
3:  cmp     r0, r1
    bhs     4f
    str     r3, [r0], #4
    b       3b
    // What the stack overwrites tells its size afterwards.
4:  ldr     r3, =0xC5C5C5C5
5:  cmp     r0, sp
    bhs     6f
    str     r3, [r0], #4
    b       5b
6:  bl      run

    .thumb_func
fault:
    // ADP_Stopped_InternalError, to the host.
    movs    r0, #0x18
    ldr     r1, =0x20024
    bkpt    0xAB
    b       fault
"#
);
