//! Where each entry of a list is: each node of the arena, each key of a map.
//!
//! Every expression that is made is looked up, and compilers run unoptimised: a table of numbers and loops over arrays
//! take a fraction of the time of a map whose keys are nodes, and a node is stored once.

/// A slot that is free.
const FREE: u32 = u32::MAX;
/// Slots at the beginning.
const FIRST: usize = 32;

/// Hashes of entries with their numbers in the list, by open addressing; less than half of the slots are taken.
#[derive(Debug, Clone, Default)]
pub(crate) struct Index {
    /// Their number is a power of two.
    slots: Vec<(u32, u32)>,
    taken: usize,
}

impl Index {
    /// The number of the entry with this hash that `is_it` tells from others.
    pub(crate) fn find(&self, hash: u32, is_it: impl Fn(u32) -> bool) -> Option<u32> {
        // A slice is indexed without a call.
        let slots = self.slots.as_slice();
        if slots.is_empty() {
            return None;
        }
        let mask = slots.len() - 1;
        let mut at = hash as usize & mask;
        loop {
            let (own, number) = slots[at];
            if number == FREE {
                return None;
            }
            if own == hash && is_it(number) {
                return Some(number);
            }
            at = (at + 1) & mask;
        }
    }

    /// Adds an entry that is not there.
    pub(crate) fn insert(&mut self, number: u32, hash: u32) {
        if 2 * self.taken >= self.slots.len() {
            let length = FIRST.max(2 * self.slots.len());
            let slots = std::mem::replace(&mut self.slots, vec![(0, FREE); length]);
            for (hash, number) in slots {
                if number != FREE {
                    self.put(hash, number);
                }
            }
        }
        self.put(hash, number);
        self.taken += 1;
    }

    fn put(&mut self, hash: u32, number: u32) {
        let slots = self.slots.as_mut_slice();
        let mask = slots.len() - 1;
        let mut at = hash as usize & mask;
        while slots[at].1 != FREE {
            at = (at + 1) & mask;
        }
        slots[at] = (hash, number);
    }
}
