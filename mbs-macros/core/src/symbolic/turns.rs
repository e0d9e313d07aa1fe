//! Angles within half a turn.

use super::{Expr, Function, Graph};
use std::f64::consts::TAU;

impl Graph {
    /// angle − 2π round(angle/2π).
    pub fn within_half_turn(&mut self, angle: Expr) -> Expr {
        let turns = self.scale(1.0 / TAU, angle);
        let turns = self.function(Function::Round, turns);
        self.linear(0.0, &[(angle, 1.0), (turns, -TAU)])
    }
}
