//! Arrays that large systems need only beside singular poses, if at all.

use super::{Box, zeroed};
use bytemuck::{Pod, Zeroable};
use core::hint::unreachable_unchecked;
use core::ops::{Deref, DerefMut};
use core::ptr::copy_nonoverlapping;
use std::sync::OnceLock;

/// Values of more bytes are allocated when they are first used: with less than 128 × 128 numbers it is done at once, so
/// that no step of a small mechanism allocates.
const MOST_AT_ONCE: usize = 128 * 128 * size_of::<f64>();

/// A value of zeros on the heap; a large one is allocated when it is first used.
#[derive(Debug)]
pub struct OnDemand<T> {
    /// The value, once it has been written to.
    value: Option<Box<T>>,
    /// The same as long as it has only been read.
    read: OnceLock<Box<T>>,
}

impl<T> OnDemand<T> {
    /// A test of each access would be a twentieth of the instructions of a small step.
    const AT_ONCE: bool = size_of::<T>() <= MOST_AT_ONCE;
}

impl<T: Zeroable> OnDemand<T> {
    /// Zeros.
    pub fn zeros() -> Self {
        OnDemand {
            value: Self::AT_ONCE.then(zeroed),
            read: OnceLock::new(),
        }
    }

    #[cold]
    fn late(&self) -> &T {
        self.read.get_or_init(zeroed)
    }
}

impl<T: Zeroable> Deref for OnDemand<T> {
    type Target = T;

    #[inline(always)]
    fn deref(&self) -> &T {
        if const { Self::AT_ONCE } {
            match &self.value {
                Some(value) => return value,
                // SAFETY: the value of such a type is there from the beginning, and nothing takes it away.
                None => unsafe { unreachable_unchecked() },
            }
        }
        match &self.value {
            Some(value) => value,
            None => self.late(),
        }
    }
}

impl<T: Zeroable> DerefMut for OnDemand<T> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut T {
        if const { Self::AT_ONCE } {
            match &mut self.value {
                Some(value) => return value,
                // SAFETY: as above.
                None => unsafe { unreachable_unchecked() },
            }
        }
        let read = &mut self.read;
        self.value
            .get_or_insert_with(|| read.take().unwrap_or_else(zeroed))
    }
}

impl<T: Pod> Clone for OnDemand<T> {
    /// An assignment may make a copy on the stack first, which large values would overflow; this one does not.
    fn clone(&self) -> Self {
        let mut copy = Self::zeros();
        if let Some(value) = self.value.as_ref().or(self.read.get()) {
            let (from, to) = (&raw const **value, &raw mut *copy);
            // SAFETY: both are valid values in allocations of their own, and may be copied bit by bit.
            unsafe { copy_nonoverlapping(from, to, 1) }
        }
        copy
    }
}

#[cfg(test)]
mod tests {
    use super::OnDemand;

    type Large = [[f64; 200]; 200];

    #[test]
    fn large_values_are_allocated_when_they_are_used() {
        let mut large = OnDemand::<Large>::zeros();
        assert!(large.value.is_none() && large.read.get().is_none());
        assert!(large.clone().value.is_none());
        assert_eq!(large[199][199], 0.0);
        let read: *const Large = &*large;
        large[1][2] = 3.0;
        assert!(std::ptr::eq(read, &*large));
        assert_eq!((large[1][2], large.clone()[1][2]), (3.0, 3.0));
        assert!(OnDemand::<[f64; 9]>::zeros().value.is_some());
    }

    /// Values of 32 MB on a stack of 1 MB, without optimisation, too.
    #[test]
    fn large_values_are_never_on_the_stack() {
        let work = || {
            let mut large = OnDemand::<[[f64; 2000]; 2000]>::zeros();
            assert_eq!(large.clone()[0][0], 0.0);
            large[7][8] = 9.0;
            large.clone()[7][8]
        };
        let thread = std::thread::Builder::new().stack_size(1 << 20).spawn(work);
        assert_eq!(thread.unwrap().join().unwrap(), 9.0);
    }
}
