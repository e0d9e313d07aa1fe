//! Mechanisms written by hand, as an engineer would write them for this one mechanism: the yardsticks of the generated
//! code. Keep them as they are.

// Each bench uses its own part.
#![allow(dead_code)]

mod andrews;
mod double_four_bar;

pub use andrews::Andrews;
pub use double_four_bar::DoubleFourBar;
