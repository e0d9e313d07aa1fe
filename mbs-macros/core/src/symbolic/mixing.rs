//! Hashes: a multiplication and a rotation per word, the same in every run.

use std::hash::{Hash, Hasher};

/// The hash of one key.
pub(crate) fn hash(key: impl Hash) -> u64 {
    let mut mixer = Mixer::default();
    key.hash(&mut mixer);
    mixer.finish()
}

/// A hash of what had the hash `all`, and a text, many bytes at a time.
pub(crate) fn mixed_text(all: u64, text: &str) -> u64 {
    mixed_bytes(mixed(all, text.len() as u64), text.as_bytes())
}

fn mixed_bytes(mut all: u64, bytes: &[u8]) -> u64 {
    let (words, rest) = bytes.as_chunks::<8>();
    for &word in words {
        all = mixed(all, u64::from_le_bytes(word));
    }
    for &byte in rest {
        all = mixed(all, u64::from(byte));
    }
    all
}

/// A hash of what had the hash `all`, and one more word.
#[inline(always)]
// `rotate_left` is a call where nothing is optimised.
#[allow(clippy::manual_rotate)]
pub(crate) fn mixed(all: u64, word: u64) -> u64 {
    // An odd number without a pattern: the hexadecimal digits of π after the point.
    ((all << 5 | all >> 59) ^ word).wrapping_mul(0x243f_6a88_85a3_08d3)
}

#[derive(Default)]
struct Mixer(u64);

impl Hasher for Mixer {
    fn write(&mut self, bytes: &[u8]) {
        self.0 = mixed_bytes(self.0, bytes);
    }

    fn write_u32(&mut self, word: u32) {
        self.0 = mixed(self.0, u64::from(word));
    }

    fn write_usize(&mut self, word: usize) {
        self.0 = mixed(self.0, word as u64);
    }

    fn write_isize(&mut self, word: isize) {
        self.0 = mixed(self.0, word as u64);
    }

    fn write_u64(&mut self, word: u64) {
        self.0 = mixed(self.0, word);
    }

    fn finish(&self) -> u64 {
        // Multiplication mixes upwards; tables use the low bits, too.
        self.0.rotate_left(26)
    }
}
