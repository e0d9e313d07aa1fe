//! Which functions are long, and what of them is written out.

use super::Parts;
use crate::dag::{ALL_TANGENTS, Function, Program};

/// A function of more operations and outputs is divided: the compiler of the generated code needs more than proportional
/// time and stack for longer ones. Parts need more instructions: those of a chain of ten bodies half as many again.
const LONGEST_BODY: usize = 8000;

/// The same for functions that are evaluated once in a step, or only if somebody asks.
const LONGEST_COLD_BODY: usize = 1200;

/// A longer function is not written out beside another that computes the same and more.
const LONGEST_TWICE: usize = 1000;

/// These functions.
const COLD: [&str; 7] = [
    "affinities",
    "points",
    "kinetic_energy",
    "potential_energy",
    "nonconservative_power",
    "outputs",
    "reactions",
];

impl Function {
    /// Whether it is too long for one body.
    pub fn is_long(&self) -> bool {
        let is_short = COLD.contains(&self.name) || self.name == "partitioned_accelerations";
        let longest = match is_short {
            true => LONGEST_COLD_BODY,
            false => LONGEST_BODY,
        };
        self.operations.len() + self.outputs.len() > longest
    }

    /// Whether a function that is evaluated at most once in a step is long by its outputs alone.
    pub(in crate::dag) fn is_long_by(outputs: usize) -> bool {
        outputs > LONGEST_COLD_BODY
    }
}

/// Whether parts are shorter than one body, or that would be too long for any function.
fn pays(function: &Function, parts: &Parts) -> bool {
    let (divided, whole) = (parts.operations(), function.operations.len());
    whole > LONGEST_BODY || 2 * divided < whole
}

impl Program {
    /// For a function that is not short the one that computes the same and more: the balance is called for the forces.
    pub fn whole_of(&self, function: &Function) -> Option<&Function> {
        let whole = match function.name {
            "forces" => self.function("balance"),
            "force_tangents" => self
                .function("balance_tangents")
                .or(self.all_tangents.as_ref()),
            "applied_force_tangents" => self.all_tangents.as_ref(),
            _ => None,
        };
        whole.filter(|_| function.operations.len() > LONGEST_TWICE)
    }

    /// The terms of F that f has not, where F is f and these.
    pub fn turning_of(&self, function: &Function) -> Option<&Function> {
        let turning = self.turning.as_ref();
        turning.filter(|_| function.name == "forces")
    }

    /// A long function as parts, unless another is called for it.
    pub fn parts(&self, function: &Function) -> Option<Parts> {
        let is_divided = function.is_long()
            && self.whole_of(function).is_none()
            && self.turning_of(function).is_none();
        let parts = is_divided.then(|| Parts::of(function, &self.labels));
        parts.filter(|parts| pays(function, parts))
    }

    /// How many operations of a function are written out; `parts` are its own.
    pub fn written(&self, function: &Function, parts: Option<&Parts>) -> usize {
        match parts {
            Some(parts) => parts.operations(),
            None => match self.whole_of(function) {
                Some(whole) if whole.name == ALL_TANGENTS && function.name == "force_tangents" => {
                    Parts::of(whole, &self.labels).operations()
                }
                Some(_) => 0,
                None => self
                    .turning_of(function)
                    .unwrap_or(function)
                    .operations
                    .len(),
            },
        }
    }
}
