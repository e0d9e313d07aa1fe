//! Sets of labels, each known by a number, so that they can be keys.

use crate::symbolic::{Index, Map, mixed};

/// The number of the empty set.
pub(in crate::dag) const EMPTY: u32 = 0;

/// Sets of labels, each known by a number.
#[derive(Debug, Default)]
pub(in crate::dag) struct Sets {
    list: Vec<Bits>,
    index: Index,
    /// The set of each label alone.
    single: Map<u32, u32>,
    unions: Map<(u32, u32), u32>,
}

/// Labels as bits, without the words of zeros before and after: most sets are of a few parts that follow each other.
#[derive(Debug, Clone, Default, PartialEq)]
struct Bits {
    /// How many words there would be before.
    first: usize,
    words: Vec<u64>,
}

impl Bits {
    fn union(&self, other: &Bits) -> Bits {
        let first = self.first.min(other.first);
        let end = |bits: &Bits| bits.first + bits.words.len();
        let mut words = vec![0; end(self).max(end(other)) - first];
        for bits in [self, other] {
            let own = &mut words[bits.first - first..];
            let mut at = 0;
            while at < bits.words.len() {
                own[at] |= bits.words[at];
                at += 1;
            }
        }
        Bits { first, words }
    }

    fn hash(&self) -> u32 {
        let mut all = mixed(0, self.first as u64);
        for &word in &self.words {
            all = mixed(all, word);
        }
        // Multiplication mixes upwards.
        (all >> 32) as u32
    }
}

impl Sets {
    fn number(&mut self, bits: Bits) -> u32 {
        if self.list.is_empty() {
            let empty = Bits::default();
            self.index.insert(EMPTY, empty.hash());
            self.list.push(empty);
        }
        let hash = bits.hash();
        let is_it = |number: u32| self.list[number as usize] == bits;
        if let Some(known) = self.index.find(hash, is_it) {
            return known;
        }
        let next = self.list.len() as u32;
        self.list.push(bits);
        self.index.insert(next, hash);
        next
    }

    pub(in crate::dag) fn of_label(&mut self, label: u32) -> u32 {
        if let Some(&known) = self.single.get(&label) {
            return known;
        }
        let number = self.number(Bits {
            first: label as usize / 64,
            words: vec![1 << (label % 64)],
        });
        self.single.insert(label, number);
        number
    }

    /// The labels of a set.
    pub(super) fn labels(&self, set: u32) -> impl Iterator<Item = u32> + '_ {
        let sets = self.list.get(set as usize).into_iter();
        let words = sets.flat_map(|bits| (bits.first..).zip(&bits.words));
        words.flat_map(|(k, &word)| {
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
        let number = self.number(self.list[a as usize].union(&self.list[b as usize]));
        self.unions.insert(key, number);
        number
    }
}
