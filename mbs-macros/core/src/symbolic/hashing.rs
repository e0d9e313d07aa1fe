//! The hashes of nodes: loops over arrays, because compilers run unoptimised.

use super::{Node, hash, mixed};

impl Node {
    /// What it is looked up by.
    pub(super) fn hashed(&self) -> u32 {
        let all = match self {
            Node::Sum { constant, terms } => {
                let mut all = mixed(1, constant.bits());
                let mut at = 0;
                while at < terms.len() {
                    let (term, coefficient) = terms[at];
                    all = mixed(mixed(all, u64::from(term.0)), coefficient.bits());
                    at += 1;
                }
                all
            }
            Node::Product(factors) => {
                let mut all = 2;
                let mut at = 0;
                while at < factors.len() {
                    let (factor, power) = factors[at];
                    all = mixed(mixed(all, u64::from(factor.0)), power as u64);
                    at += 1;
                }
                all
            }
            Node::Constant(number) => mixed(3, number.bits()),
            other => hash(other),
        };
        // Multiplication mixes upwards.
        (all >> 32) as u32
    }
}
