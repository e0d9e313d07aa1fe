//! The common code of the tests across the workspace; the tests themselves are in `tests/`. The pages below are
//! compiled and run as documentation tests.

pub mod compiled;
pub mod dense;
pub mod differences;
pub mod fixtures;
pub mod flips;
pub mod formulas;
pub mod instant;
pub mod interpreted;
pub mod laws;
pub mod mechanisms;
pub mod pages;
pub mod random;
pub mod reference;
pub mod small;
pub mod stages;
pub mod table;
pub mod tampered;
pub mod units;
pub mod values;

#[doc = include_str!("../../README.md")]
mod readme {}

#[doc = include_str!("../../book/src/first-mechanism.md")]
mod first_mechanism {}

#[doc = include_str!("../../book/src/into-space.md")]
mod into_space {}

#[doc = include_str!("../../book/src/redundancy.md")]
mod redundancy {}

#[doc = include_str!("../../book/src/coordinates.md")]
mod coordinates {}

#[doc = include_str!("../../book/src/driving.md")]
mod driving {}

#[doc = include_str!("../../book/src/stops-and-friction.md")]
mod stops_and_friction {}

#[doc = include_str!("../../book/src/families.md")]
mod families {}

#[doc = include_str!("../../book/src/assemblies.md")]
mod assemblies {}

#[doc = include_str!("../../book/src/reactions.md")]
mod reactions {}

#[doc = include_str!("../../book/src/assembly.md")]
mod assembly {}

#[doc = include_str!("../../book/src/realtime.md")]
mod realtime {}

#[doc = include_str!("../../book/src/control.md")]
mod control {}

#[doc = include_str!("../../book/src/recording.md")]
mod recording {}

#[doc = include_str!("../../book/src/accuracy.md")]
mod accuracy {}

/// Runs a test on a larger stack: unoptimised code copies the matrices of the largest scene, and the thread of a test
/// has only 2 MiB.
pub fn with_room<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(32 << 20);
        let running = thread.spawn_scoped(scope, work).expect("a thread");
        running
            .join()
            .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    })
}
