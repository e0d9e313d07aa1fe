//! Springs with dampers.

use super::action::Action;
use crate::model::elements::force::{Characteristic, Damping, Load};
use crate::symbolic::{Expr, Graph, INTEGRAL};

/// The action that opposes a growing deflection.
pub(super) fn action(
    graph: &mut Graph,
    characteristic: &Characteristic,
    deflection: Expr,
    rate: Expr,
) -> Action {
    match *characteristic {
        Characteristic::Linear {
            stiffness,
            ref damping,
            free,
        } => {
            let stretch = graph.sub(deflection, free);
            let square = graph.square(stretch);
            let energy = graph.mul(stiffness, square);
            let energy = graph.scale(0.5, energy);
            elastic(graph, energy, damping, rate)
        }
        Characteristic::Table {
            ref table,
            ref damping,
            free,
        } => {
            let stretch = graph.sub(deflection, free);
            let energy = graph.table(table, INTEGRAL, stretch);
            elastic(graph, energy, damping, rate)
        }
        Characteristic::Law(..) => {
            let tension = characteristic.tension(graph, deflection, rate);
            let force = graph.neg(tension);
            Action {
                potential: None,
                loads: vec![Load { rate, force }],
            }
        }
    }
}

/// A potential energy, and a damper against the rate.
fn elastic(graph: &mut Graph, energy: Expr, damping: &Damping, rate: Expr) -> Action {
    let drag = damping.drag(graph, rate);
    let force = graph.neg(drag);
    let loads = if graph.is_zero(force) {
        Vec::new()
    } else {
        vec![Load { rate, force }]
    };
    Action {
        potential: (!graph.is_zero(energy)).then_some(energy.into()),
        loads,
    }
}
