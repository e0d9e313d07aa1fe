//! What force elements mean: a potential energy, and forces against rates.

mod action;
mod bushing;
mod spring;
mod wrench;

use crate::model::elements::force::ForceElement;
use crate::symbolic::Graph;

pub(super) use action::Action;

/// What a force element contributes, in local coordinates.
pub(super) fn action(graph: &mut Graph, element: &ForceElement) -> Action {
    match element {
        ForceElement::Spring {
            from,
            to,
            characteristic,
        } => {
            let difference = graph.vector_sub(*to, *from);
            let length = graph.norm(difference);
            let rate = graph.rate(length);
            spring::action(graph, characteristic, length, rate)
        }
        ForceElement::TorsionSpring {
            angles,
            rates,
            characteristic,
        } => {
            let [angle, rate] = [angles, rates].map(|[child, parent]| graph.sub(*child, *parent));
            spring::action(graph, characteristic, angle, rate)
        }
        ForceElement::Wrench {
            at,
            force,
            torque,
            axes,
        } => wrench::action(graph, *at, *force, *torque, axes),
        ForceElement::Loads(loads) => Action {
            potential: None,
            loads: loads.clone(),
        },
        ForceElement::Bushing(bushing) => bushing::action(graph, bushing),
    }
}
