//! The length of a bar in natural coordinates.

use super::distance::half_square_difference;
use super::{Joint, JointEquations, ReactionComponent, row};
use crate::model::{Dimension, Part};
use crate::symbolic::{Expr, Graph, Symbol};

#[derive(Debug)]
struct BarLength {
    ends: Vec<u32>,
    length: Expr,
    massless: bool,
}

/// The row that keeps the length of a bar.
pub fn bar_length(part: &Part, length: Expr, graph: &Graph) -> Box<dyn Joint> {
    Box::new(BarLength {
        ends: part.locals.clone(),
        length,
        massless: graph.is_zero(part.mass),
    })
}

impl Joint for BarLength {
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        let mut difference = graph.zero_vector();
        let (a, b) = self.ends.split_at(self.ends.len() / 2);
        for (x, (&a, &b)) in difference.iter_mut().zip(a.iter().zip(b)) {
            let [a, b] = [a, b].map(|end| graph.symbol(Symbol::LocalPosition(end)));
            *x = graph.sub(b, a);
        }
        let rows = vec![row(
            "length",
            half_square_difference(graph, difference, self.length),
            Dimension([2, 0, 0, 0]),
        )];
        // The multiplier is a physical force only where the bar has no inertia of its own: its tension, −λ L.
        let reactions = match self.massless {
            true => {
                let coefficient = graph.neg(self.length);
                vec![ReactionComponent {
                    name: "tension",
                    dimension: Dimension::FORCE,
                    terms: vec![(0, coefficient)],
                }]
            }
            false => Vec::new(),
        };
        JointEquations { rows, reactions }
    }
}
