//! A force on a point, and a torque on its part.

use super::action::Action;
use super::observer::Observer;
use crate::model::elements::force::Load;
use crate::model::{Owner, Point, Vector};
use crate::symbolic::Graph;

/// The force against the velocity of the point, the torque against the angular velocity of its part.
pub(super) fn action(
    graph: &mut Graph,
    observer: Observer,
    on: &Point,
    force: Vector,
    torque: Option<Vector>,
) -> Action {
    let velocity = observer.velocity(graph, on);
    let mut action = against(graph, velocity, force);
    if let Some(torque) = torque {
        let spin = observer.spin(graph, on.owner);
        action.loads.extend(against(graph, spin, torque).loads);
    }
    action
}

/// A torque on a part and back on another, against their relative angular velocity.
pub(super) fn torque(
    graph: &mut Graph,
    observer: Observer,
    between: [Owner; 2],
    torque: Vector,
) -> Action {
    let [spin, back] = between.map(|owner| observer.spin(graph, owner));
    let relative = graph.vector_sub(spin, back);
    against(graph, relative, torque)
}

/// Each component of a force against its own rate.
fn against(graph: &mut Graph, rates: Vector, force: Vector) -> Action {
    let pairs = rates.into_iter().zip(force);
    let acting = pairs.filter(|&(_, force)| !graph.is_zero(force));
    Action {
        potential: None,
        loads: acting.map(|(rate, force)| Load { rate, force }).collect(),
    }
}
