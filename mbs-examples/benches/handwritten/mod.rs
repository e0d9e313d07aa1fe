//! Equations written by hand, as an engineer would write them for one mechanism, for comparison with the generated
//! code. Do not change them.

// Each benchmark uses a part of this module.
#![allow(dead_code, unused_imports)]

mod andrews;
mod double_four_bar;

pub use andrews::Andrews;
pub use double_four_bar::DoubleFourBar;
