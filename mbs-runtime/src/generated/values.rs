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
///
/// What it holds at the beginning is left from other functions: a function writes each value before it reads it.
#[cfg(feature = "std")]
pub struct Values<const LENGTH: usize> {
    buffer: Vec<f64>,
}

#[cfg(feature = "std")]
impl<const LENGTH: usize> Values<LENGTH> {
    /// The array of this thread, or a new one of zeros.
    #[inline]
    pub fn take() -> Self {
        let mut buffer = LONGEST.take();
        if buffer.len() < LENGTH {
            buffer.resize(LENGTH, 0.0);
        }
        Values { buffer }
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

#[cfg(feature = "std")]
impl<const LENGTH: usize> Deref for Values<LENGTH> {
    type Target = [f64; LENGTH];

    #[inline]
    fn deref(&self) -> &[f64; LENGTH] {
        self.buffer.first_chunk().expect("a buffer of this length")
    }
}

#[cfg(feature = "std")]
impl<const LENGTH: usize> DerefMut for Values<LENGTH> {
    #[inline]
    fn deref_mut(&mut self) -> &mut [f64; LENGTH] {
        let buffer = self.buffer.first_chunk_mut();
        buffer.expect("a buffer of this length")
    }
}

/// The same without the standard library: in place.
#[cfg(not(feature = "std"))]
pub struct Values<const LENGTH: usize>([f64; LENGTH]);

#[cfg(not(feature = "std"))]
impl<const LENGTH: usize> Values<LENGTH> {
    /// An array of zeros.
    pub fn take() -> Self {
        Values([0.0; LENGTH])
    }
}

#[cfg(not(feature = "std"))]
impl<const LENGTH: usize> Deref for Values<LENGTH> {
    type Target = [f64; LENGTH];

    fn deref(&self) -> &[f64; LENGTH] {
        &self.0
    }
}

#[cfg(not(feature = "std"))]
impl<const LENGTH: usize> DerefMut for Values<LENGTH> {
    fn deref_mut(&mut self) -> &mut [f64; LENGTH] {
        &mut self.0
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
