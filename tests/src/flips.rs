//! Derived expressions with one sign flipped.

use mbs_macros_core::Analysis;
use mbs_macros_core::derivatives::Derived;
use mbs_macros_core::symbolic::Expr;

/// The derived quantities, by their symbols.
pub const QUANTITIES: [&str; 15] = [
    "M",
    "p",
    "T",
    "Γ",
    "A",
    "b",
    "Ȧ",
    "γ",
    "f",
    "F",
    "∂f/∂q",
    "∂f/∂v",
    "∂F/∂q",
    "∂F/∂v",
    "∂p/∂q",
];

/// The expressions of a quantity.
fn expressions<'a>(derived: &'a mut Derived, quantity: &str) -> Vec<&'a mut Expr> {
    let matrix = match quantity {
        "M" => &mut derived.system.mass,
        "A" => &mut derived.jacobian,
        "Ȧ" => &mut derived.jacobian_rate,
        "∂f/∂q" => &mut derived.applied.by_position,
        "∂f/∂v" => &mut derived.applied.by_velocity,
        "∂F/∂q" => &mut derived.total.by_position,
        "∂F/∂v" => &mut derived.total.by_velocity,
        "∂p/∂q" => &mut derived.momentum_by_position,
        "Γ" => {
            let affinities = derived.affinities.iter_mut();
            return affinities.flat_map(|list| list.values_mut()).collect();
        }
        "T" => return vec![&mut derived.kinetic],
        "p" => return derived.momentum.iter_mut().collect(),
        "b" => return derived.rheonomic.iter_mut().collect(),
        "γ" => return derived.convective.iter_mut().collect(),
        "f" => return derived.system.forces.iter_mut().collect(),
        "F" => return derived.total_forces.iter_mut().collect(),
        other => panic!("`{other}` is not a quantity"),
    };
    matrix.values_mut().collect()
}

/// An entry with its sign flipped.
#[derive(Debug, Clone, Copy)]
pub struct Flip {
    /// The symbol of the quantity.
    pub quantity: &'static str,
    /// Which entry of it.
    pub entry: usize,
    /// The entry with its right sign.
    pub expr: Expr,
}

/// Calls `examine` with every entry of every quantity that is not zero, its sign flipped.
pub fn flip_each(analysis: &mut Analysis, mut examine: impl FnMut(Flip, &Analysis)) {
    for quantity in QUANTITIES {
        let count = expressions(&mut analysis.derived, quantity).len();
        for entry in 0..count {
            let expr = *expressions(&mut analysis.derived, quantity)[entry];
            let graph = &mut analysis.derived.system.graph;
            if graph.is_zero(expr) {
                continue;
            }
            let flipped = graph.neg(expr);
            *expressions(&mut analysis.derived, quantity)[entry] = flipped;
            let flip = Flip {
                quantity,
                entry,
                expr,
            };
            examine(flip, analysis);
            *expressions(&mut analysis.derived, quantity)[entry] = expr;
        }
    }
}
