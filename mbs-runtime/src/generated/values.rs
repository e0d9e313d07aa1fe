//! The values that pass between the parts of a long function.

use core::ops::{Deref, DerefMut};

#[cfg(feature = "std")]
use std::{cell::Cell, vec::Vec};

#[cfg(feature = "std")]
thread_local! {
    /// The longest array so far, while no function uses it.
    static LONGEST: Cell<Vec<f64>> = const { Cell::new(Vec::new()) };
}

/// An array that is too long for the stack: of each thread one is kept, so that only the first evaluation allocates.
/// (Without the feature `std` it is in place.)
///
/// What it holds at the beginning is left from other functions: a function writes each value before it reads it.
pub struct Values<const LENGTH: usize> {
    #[cfg(feature = "std")]
    buffer: Vec<f64>,
    #[cfg(not(feature = "std"))]
    buffer: [f64; LENGTH],
}

impl<const LENGTH: usize> Values<LENGTH> {
    /// The array of this thread, or a new one of zeros.
    #[cfg(feature = "std")]
    #[inline]
    pub fn take() -> Self {
        let mut buffer = LONGEST.take();
        if buffer.len() < LENGTH {
            buffer.resize(LENGTH, 0.0);
        }
        Values { buffer }
    }

    /// An array of zeros.
    #[cfg(not(feature = "std"))]
    pub fn take() -> Self {
        Values {
            buffer: [0.0; LENGTH],
        }
    }
}

#[cfg(feature = "std")]
impl<const LENGTH: usize> Drop for Values<LENGTH> {
    #[inline]
    fn drop(&mut self) {
        // While a thread ends there is no place for it any more.
        let _ = LONGEST.try_with(|longest| longest.set(std::mem::take(&mut self.buffer)));
    }
}

impl<const LENGTH: usize> Deref for Values<LENGTH> {
    type Target = [f64; LENGTH];

    #[inline]
    fn deref(&self) -> &[f64; LENGTH] {
        self.buffer.first_chunk().expect("a buffer of this length")
    }
}

impl<const LENGTH: usize> DerefMut for Values<LENGTH> {
    #[inline]
    fn deref_mut(&mut self) -> &mut [f64; LENGTH] {
        let buffer = self.buffer.first_chunk_mut();
        buffer.expect("a buffer of this length")
    }
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::Values;

    #[test]
    fn one_array_serves_all_functions_and_another_one_within() {
        let first = {
            let mut values = Values::<3000>::take();
            values[2999] = 1.0;
            values.as_ptr()
        };
        let again = Values::<2000>::take();
        assert_eq!(first, again.as_ptr());
        let within = Values::<2000>::take();
        assert_ne!(first, within.as_ptr());
        assert_eq!(again.len(), 2000);
    }
}
