//! A force on a point, and a torque on its part.

use super::action::Action;
use crate::model::elements::force::Load;
use crate::model::{Axes, Vector};
use crate::symbolic::Graph;

/// The force against the velocity of the point, the torque against the angular velocity.
pub(super) fn action(
    graph: &mut Graph,
    at: Vector,
    force: Vector,
    torque: Option<[Vector; 2]>,
    axes: &Axes,
) -> Action {
    let velocity = graph.vector_rate(at);
    let mut loads = Vec::new();
    for [rate, value] in [Some([velocity, force]), torque].into_iter().flatten() {
        let rates = graph.components(axes, rate);
        let pairs = rates.into_iter().zip(value);
        let acting = pairs.filter(|&(_, force)| !graph.is_zero(force));
        loads.extend(acting.map(|(rate, force)| Load { rate, force }));
    }
    Action {
        potential: None,
        loads,
    }
}
