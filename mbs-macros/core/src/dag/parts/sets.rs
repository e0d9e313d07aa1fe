//! Sets of labels, each known by a number, so that they can be keys.

use crate::symbolic::Map;

/// The number of the empty set.
pub(in crate::dag) const EMPTY: u32 = 0;

/// Sets of labels, each known by a number.
#[derive(Debug, Default)]
pub(in crate::dag) struct Sets {
    /// The labels as bits.
    list: Vec<Vec<u64>>,
    index: Map<Vec<u64>, u32>,
    /// The set of each label alone.
    single: Map<u32, u32>,
    unions: Map<(u32, u32), u32>,
}

impl Sets {
    fn number(&mut self, bits: Vec<u64>) -> u32 {
        if self.list.is_empty() {
            self.list.push(Vec::new());
            self.index.insert(Vec::new(), EMPTY);
        }
        if let Some(&known) = self.index.get(&bits) {
            return known;
        }
        let next = self.list.len() as u32;
        self.list.push(bits.clone());
        self.index.insert(bits, next);
        next
    }

    pub(in crate::dag) fn of_label(&mut self, label: u32) -> u32 {
        if let Some(&known) = self.single.get(&label) {
            return known;
        }
        let mut bits = vec![0; label as usize / 64 + 1];
        bits[label as usize / 64] = 1 << (label % 64);
        let number = self.number(bits);
        self.single.insert(label, number);
        number
    }

    /// The labels of a set.
    pub(super) fn labels(&self, set: u32) -> impl Iterator<Item = u32> + '_ {
        let words = self.list.get(set as usize).into_iter().flatten();
        words.enumerate().flat_map(|(k, &word)| {
            let bits = (0..64).filter(move |bit| word >> bit & 1 == 1);
            bits.map(move |bit| 64 * k as u32 + bit)
        })
    }

    pub(in crate::dag) fn union(&mut self, a: u32, b: u32) -> u32 {
        if a == b || b == EMPTY {
            return a;
        }
        if a == EMPTY {
            return b;
        }
        let key = (a.min(b), a.max(b));
        if let Some(&known) = self.unions.get(&key) {
            return known;
        }
        let (a, b) = (&self.list[a as usize], &self.list[b as usize]);
        let (long, short) = if a.len() < b.len() { (b, a) } else { (a, b) };
        let mut bits = long.clone();
        bits.iter_mut()
            .zip(short)
            .for_each(|(word, other)| *word |= other);
        let number = self.number(bits);
        self.unions.insert(key, number);
        number
    }
}
