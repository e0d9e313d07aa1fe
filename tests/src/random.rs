//! Deterministic numbers that look random.

use mbs_runtime::System;
use mbs_runtime::nalgebra::SVector;

/// SplitMix64.
#[derive(Debug, Clone)]
pub struct Random(u64);

impl Random {
    /// Numbers that depend on a text only.
    pub fn of(text: &str) -> Self {
        // FNV-1a
        Random(text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        }))
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let x = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    }

    /// A number in [−size, size).
    pub fn within(&mut self, size: f64) -> f64 {
        size * ((self.next() >> 11) as f64 / (1u64 << 52) as f64 - 1.0)
    }

    /// A number from the first to the last.
    pub fn between(&mut self, first: usize, last: usize) -> usize {
        first + (self.next() % (last - first + 1) as u64) as usize
    }

    /// Numbers in [−size, size).
    pub fn vector<const N: usize>(&mut self, size: f64) -> SVector<f64, N> {
        SVector::from_fn(|_, _| self.within(size))
    }
}

/// Arguments of the equations.
#[derive(Debug, Clone)]
pub struct Arguments<const Q: usize, const N: usize, const R: usize> {
    /// t
    pub time: f64,
    /// q
    pub q: SVector<f64, Q>,
    /// v
    pub v: SVector<f64, N>,
    /// v̇
    pub acceleration: SVector<f64, N>,
    /// λ
    pub lambda: SVector<f64, R>,
}

impl<const Q: usize, const N: usize, const R: usize> Arguments<Q, N, R> {
    /// Arguments near the guess of q; constraints are not respected, since derivatives hold everywhere.
    pub fn near<S: System<Q, N, R>>(system: &S, random: &mut Random) -> Self {
        let (guess, _) = system.guess();
        let way = random.vector(0.4);
        Arguments {
            time: 0.7 + random.within(0.6),
            q: system.advance(&guess, &way, 1.0),
            v: random.vector(1.5),
            acceleration: random.vector(2.0),
            lambda: random.vector(2.0),
        }
    }
}
