//! The run on a Cortex-M4, with the count of its instructions and of its stack.

#![no_std]
#![no_main]

mod clock;
mod semihosting;
mod stack;
mod startup;

use core::fmt::Write;
use core::panic::PanicInfo;
use semihosting::Host;

/// The program, called by the start-up.
#[unsafe(no_mangle)]
extern "C" fn run() -> ! {
    clock::start();
    let outcome = mbs_microcontroller::run(clock::now);
    // Before texts are made, which need a stack of their own.
    let stack = stack::used();
    let written = match &outcome {
        Ok(outcome) => writeln!(
            Host,
            "{outcome}steps {}\ninstructions a step {}\ninstructions of the longest step {}\nsimulation {} bytes\nstack {stack} bytes\nstatic memory {} bytes",
            mbs_microcontroller::STEPS,
            clock::instructions(outcome.total) / mbs_microcontroller::STEPS,
            clock::instructions(outcome.longest),
            size_of::<mbs_microcontroller::SliderCrankFixedStepSimulation>(),
            stack::static_memory(),
        ),
        Err(error) => writeln!(Host, "the run failed: {error}"),
    };
    semihosting::exit(outcome.is_ok() && written.is_ok())
}

#[panic_handler]
fn panic(about: &PanicInfo<'_>) -> ! {
    // There is nobody else to tell.
    let _ = writeln!(Host, "{about}");
    semihosting::exit(false)
}
