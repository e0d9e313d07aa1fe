//! The length of a bar in natural coordinates.

use super::distance::{AREA, half_square_difference};
use crate::model::elements::joint::{Condition, Joint, ReactionComponent};
use crate::model::parts::Part;
use crate::symbolic::{Expr, Graph, Symbol};

/// The condition that keeps the length of a bar.
pub(in crate::model) fn bar_length(part: &Part, length: Expr, graph: &mut Graph) -> Joint {
    let mut difference = graph.zero_vector();
    let (a, b) = part.locals.split_at(part.locals.len() / 2);
    for (x, (&a, &b)) in difference.iter_mut().zip(a.iter().zip(b)) {
        let [a, b] = [a, b].map(|end| graph.symbol(Symbol::LocalPosition(end)));
        *x = graph.sub(b, a);
    }
    let expr = half_square_difference(graph, difference, length);
    // The multiplier is a physical force only if the bar has no inertia: its tension, −λ L.
    let reactions = match graph.is_zero(part.mass) {
        true => {
            let coefficient = graph.neg(length);
            vec![ReactionComponent::force("tension", 0, coefficient)]
        }
        false => Vec::new(),
    };
    Joint {
        conditions: vec![Condition::position("length", expr, AREA)],
        reactions,
        ..Joint::default()
    }
}
