//! A force and a torque on a point of a body.

use super::{Action, Force, Load, force_in};
use crate::model::{Arguments, Axes, Frame, Owner, Point, Vector};
use crate::symbolic::Graph;

#[derive(Debug)]
struct Wrench {
    on: Point,
    frame: Frame,
    axes: Axes,
    force: Vector,
    torque: Vector,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Force>> {
    let on = arguments.point("on")?;
    let name = arguments.owner_name(on.owner);
    if on.owner == Owner::Ground {
        return arguments.fail(
            "on",
            "a wrench on the ground does nothing; apply it to a moving point",
        );
    }
    if arguments.is_particle(on.owner) {
        return arguments.fail(
            "on",
            format!("`{name}` is a particle: a torque cannot turn it; use `Force`"),
        );
    }
    if !arguments.has("force") && !arguments.has("torque") {
        return arguments.fail(
            "",
            "this wrench does nothing; give it `force =` or `torque =`",
        );
    }
    let zero = arguments.graph().zero_vector();
    let mut component = |field: &str| match arguments.has(field) {
        true => arguments.vector(field),
        false => Some(zero),
    };
    let (force, torque) = (component("force")?, component("torque")?);
    let axes = force_in(arguments)?;
    Some(Box::new(Wrench {
        frame: arguments.frame(on.owner),
        on,
        axes,
        force,
        torque,
    }))
}

impl Force for Wrench {
    fn action(&self, graph: &mut Graph) -> Action {
        let velocity = graph.vector_rate(self.on.position);
        let mut loads = Vec::new();
        for (rate, value) in [(velocity, self.force), (self.frame.spin, self.torque)] {
            let rates = graph.components(&self.axes, rate);
            let pairs = rates.into_iter().zip(value);
            loads.extend(
                pairs
                    .filter(|&(_, force)| !graph.is_zero(force))
                    .map(|(rate, force)| Load { rate, force }),
            );
        }
        Action {
            potential: None,
            loads,
        }
    }

    fn points(&self) -> Vec<&Point> {
        vec![&self.on]
    }
}
