//! Maps with small keys (indices, symbols, nodes).
//!
//! Procedural macros run unoptimised in users' builds, where the standard hasher, which is secure but slow, takes most
//! of the time of a derivation. A multiplication and a rotation per word serve as well here, and make every run the
//! same.

use std::collections::{HashMap, HashSet};
use std::hash::{BuildHasher, BuildHasherDefault, Hasher};

pub(crate) type Map<K, V> = HashMap<K, V, BuildHasherDefault<Mixer>>;
pub(crate) type Set<K> = HashSet<K, BuildHasherDefault<Mixer>>;

/// The hash of one key.
pub(crate) fn hash(key: impl std::hash::Hash) -> u64 {
    BuildHasherDefault::<Mixer>::default().hash_one(key)
}

/// A hash of what had the hash `all`, and a text, many bytes at a time.
pub(crate) fn mixed_text(all: u64, text: &str) -> u64 {
    let (words, rest) = text.as_bytes().as_chunks::<8>();
    let mut all = mixed(all, text.len() as u64);
    for &word in words {
        all = mixed(all, u64::from_le_bytes(word));
    }
    rest.iter()
        .fold(all, |all, &byte| mixed(all, u64::from(byte)))
}

/// A hash of what had the hash `all`, and one more word.
pub(crate) fn mixed(all: u64, word: u64) -> u64 {
    // An odd number without a pattern: the hexadecimal digits of π after the point.
    (all.rotate_left(5) ^ word).wrapping_mul(0x243f_6a88_85a3_08d3)
}

#[derive(Default)]
pub(crate) struct Mixer(u64);

impl Hasher for Mixer {
    fn write(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.write_u64(u64::from(byte));
        }
    }

    fn write_u32(&mut self, word: u32) {
        self.write_u64(u64::from(word));
    }

    fn write_usize(&mut self, word: usize) {
        self.write_u64(word as u64);
    }

    fn write_u64(&mut self, word: u64) {
        self.0 = mixed(self.0, word);
    }

    fn finish(&self) -> u64 {
        // Multiplication mixes upwards; tables use the low bits, too.
        self.0.rotate_left(26)
    }
}
