//! What force elements mean: a potential energy, and forces against rates.

mod action;
mod bushing;
mod observer;
mod spring;
mod stop;
mod wrench;

use crate::model::Model;
use crate::model::elements::force::ForceElement;
use crate::model::elements::laws::distance;
use crate::symbolic::Graph;

use observer::Observer;

pub(super) use action::{Action, Potential};

/// What a force element contributes, in local coordinates.
pub(super) fn action(graph: &mut Graph, model: &Model, element: &ForceElement) -> Action {
    match element {
        ForceElement::Spring {
            from,
            to,
            characteristic,
        } => {
            let [length, rate] = distance(graph, *from, *to);
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
            on,
            force,
            torque,
            axes,
        } => wrench::action(graph, Observer::new(model, *axes), on, *force, *torque),
        ForceElement::Torque {
            between,
            torque,
            axes,
        } => wrench::torque(graph, Observer::new(model, *axes), *between, *torque),
        ForceElement::Stop(stop) => stop::action(graph, stop),
        ForceElement::Load { load, .. } => Action {
            potential: None,
            loads: vec![*load],
        },
        ForceElement::Bushing(bushing) => bushing::action(graph, model, bushing),
    }
}
