//! Values on the heap.

mod on_demand;

pub use on_demand::OnDemand;

use bytemuck::Zeroable;

/// A value with an address of its own.
pub type Box<T> = std::boxed::Box<T>;

/// The most stages of a step: more than any order has.
pub const MOST_STAGES: usize = 1 << 16;

/// The most points of a mechanism: more than any has.
pub const MOST_POINTS: usize = 1 << 16;

/// A list with an entry for each stage of a step.
pub type StageList<T> = Vec<T>;

/// A copy of a list with the same capacity.
pub(crate) fn cloned_with_room<T: Clone>(list: &Vec<T>) -> Vec<T> {
    let mut copy = Vec::with_capacity(list.capacity());
    copy.extend_from_slice(list);
    copy
}

/// A value of zeros, which never was on the stack.
pub fn zeroed<T: Zeroable>() -> Box<T> {
    bytemuck::zeroed_box()
}

/// What `read` makes of the points that `fill` writes over zeros.
pub fn with_points<T>(
    count: usize,
    fill: impl FnOnce(&mut [[f64; 3]]),
    read: impl FnOnce(&[[f64; 3]]) -> T,
) -> T {
    let mut points = vec![[0.0; 3]; count];
    fill(&mut points);
    read(&points)
}
