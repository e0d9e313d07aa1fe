//! Full turns of angles.

use super::{Expr, Function, Graph};
use std::f64::consts::TAU;

impl Graph {
    /// round(angle/2π).
    pub fn full_turns(&mut self, angle: Expr) -> Expr {
        let turns = self.scale(1.0 / TAU, angle);
        self.function(Function::Round, turns)
    }

    /// angle − 2π round(angle/2π).
    pub fn within_half_turn(&mut self, angle: Expr) -> Expr {
        let turns = self.full_turns(angle);
        self.linear(0.0, &[(angle, 1.0), (turns, -TAU)])
    }
}
