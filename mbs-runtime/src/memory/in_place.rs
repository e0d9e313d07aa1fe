//! Values in place: in the value that holds them, for targets without a heap.

use bytemuck::Zeroable;
use core::ops::{Deref, DerefMut};

/// The most stages of a step: that of second order. Lists for more would take half of the memory of a small mechanism.
pub const MOST_STAGES: usize = 1;

/// The most points of a mechanism; an array of them is on the stack while a simulation is made.
pub const MOST_POINTS: usize = 64;

/// A value in place of a pointer to it.
#[derive(Debug, Clone, PartialEq)]
pub struct Box<T: ?Sized>(T);

impl<T> Box<T> {
    /// The value.
    #[inline(always)]
    pub const fn new(value: T) -> Self {
        Box(value)
    }
}

impl<T: ?Sized> Deref for Box<T> {
    type Target = T;
    #[inline(always)]
    fn deref(&self) -> &T {
        &self.0
    }
}

impl<T: ?Sized> DerefMut for Box<T> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut T {
        &mut self.0
    }
}

/// A value of zeros.
pub type OnDemand<T> = Box<T>;

impl<T: Zeroable> Box<T> {
    /// Zeros.
    pub fn zeros() -> Self {
        Box(T::zeroed())
    }
}

/// A value of zeros.
pub fn zeroed<T: Zeroable>() -> Box<T> {
    Box(T::zeroed())
}

/// What `read` makes of the points that `fill` writes over zeros; there are at most [`MOST_POINTS`].
pub fn with_points<T>(
    count: usize,
    fill: impl FnOnce(&mut [[f64; 3]]),
    read: impl FnOnce(&[[f64; 3]]) -> T,
) -> T {
    let mut points = [[0.0; 3]; MOST_POINTS];
    let points = &mut points[..count];
    fill(points);
    read(points)
}

/// A list with an entry for each stage of a step. Steps with more of them than [`MOST_STAGES`] are refused.
#[derive(Debug, Clone, PartialEq)]
pub struct StageList<T> {
    items: [Option<T>; MOST_STAGES],
    length: usize,
}

impl<T> StageList<T> {
    /// An empty list.
    pub const fn new() -> Self {
        StageList {
            items: [const { None }; MOST_STAGES],
            length: 0,
        }
    }

    /// An empty list, in which there is room for [`MOST_STAGES`].
    pub const fn with_capacity(_: usize) -> Self {
        Self::new()
    }

    /// The most entries.
    pub const fn capacity(&self) -> usize {
        MOST_STAGES
    }

    /// Nothing to do: the room is always the same.
    pub fn reserve(&mut self, _: usize) {}

    /// The number of entries.
    pub const fn len(&self) -> usize {
        self.length
    }

    /// Whether there is no entry.
    pub const fn is_empty(&self) -> bool {
        self.length == 0
    }

    /// Removes all entries.
    pub fn clear(&mut self) {
        *self = Self::new();
    }

    /// Adds an entry; there is room, as no step has more stages.
    pub fn push(&mut self, item: T) {
        self.items[self.length] = Some(item);
        self.length += 1;
    }

    /// The entry of a stage.
    pub fn get(&self, stage: usize) -> Option<&T> {
        self.items.get(stage)?.as_ref()
    }

    /// The entry of a stage, to be changed.
    pub fn get_mut(&mut self, stage: usize) -> Option<&mut T> {
        self.items.get_mut(stage)?.as_mut()
    }

    /// The last entry.
    pub fn last(&self) -> Option<&T> {
        self.iter().last()
    }

    /// All entries.
    pub fn iter(&self) -> impl Iterator<Item = &T> + Clone {
        self.items.iter().flatten()
    }
}

impl<T> FromIterator<T> for StageList<T> {
    fn from_iter<I: IntoIterator<Item = T>>(items: I) -> Self {
        let mut list = Self::new();
        items.into_iter().for_each(|item| list.push(item));
        list
    }
}

impl<'a, T> IntoIterator for &'a StageList<T> {
    type Item = &'a T;
    type IntoIter = core::iter::Flatten<core::slice::Iter<'a, Option<T>>>;
    fn into_iter(self) -> Self::IntoIter {
        self.items.iter().flatten()
    }
}
