//! Where values are kept that are too large for small stacks: on the heap, or without the feature `std` in place.
//!
//! Both have the same names, so that the code of a step does not know which of them it uses.

#[cfg(feature = "std")]
mod heap;
#[cfg(not(feature = "std"))]
mod in_place;

#[cfg(feature = "std")]
pub use heap::*;
#[cfg(not(feature = "std"))]
pub use in_place::*;
