//! Places that are free for other values.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// Free places as the longest ranges of them, so that the first range of a length is found without a look at all places.
#[derive(Default)]
pub(super) struct FreePlaces {
    /// The end of each range, by its start.
    ends: BTreeMap<u32, u32>,
    /// The starts of the ranges of each length.
    starts: BTreeMap<u32, BTreeSet<u32>>,
}

impl FreePlaces {
    pub(super) fn put(&mut self, place: u32) {
        let mut range = place..place + 1;
        let before = self.ends.range(..place).next_back();
        if let Some((&start, &end)) = before
            && end == place
        {
            self.remove(start..end);
            range.start = start;
        }
        if let Some(&end) = self.ends.get(&range.end) {
            self.remove(range.end..end);
            range.end = end;
        }
        self.insert(range);
    }

    /// The first places of this number, one after the other.
    pub(super) fn take(&mut self, count: u32) -> Option<Range<u32>> {
        let long_enough = self.starts.range(count..);
        let first = long_enough.filter_map(|(_, starts)| starts.first()).min();
        let start = *first?;
        let end = self.ends[&start];
        self.remove(start..end);
        let taken = start..start + count;
        if taken.end < end {
            self.insert(taken.end..end);
        }
        Some(taken)
    }

    fn insert(&mut self, range: Range<u32>) {
        let length = range.end - range.start;
        self.ends.insert(range.start, range.end);
        self.starts.entry(length).or_default().insert(range.start);
    }

    fn remove(&mut self, range: Range<u32>) {
        let length = range.end - range.start;
        self.ends.remove(&range.start);
        let starts = self.starts.entry(length).or_default();
        starts.remove(&range.start);
        if starts.is_empty() {
            self.starts.remove(&length);
        }
    }
}
