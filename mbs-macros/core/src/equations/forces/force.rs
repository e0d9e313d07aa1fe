//! A force on a point.

use super::{Action, Force, Load, force_in};
use crate::model::{Arguments, Axes, Owner, Point, Vector};
use crate::symbolic::Graph;

#[derive(Debug)]
struct PointForce {
    on: Point,
    value: Vector,
    axes: Axes,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Force>> {
    let (on, value) = (arguments.point("on"), arguments.vector("value"));
    let (on, value) = (on?, value?);
    if on.owner == Owner::Ground {
        return arguments.fail(
            "on",
            "a force on the ground does nothing; apply it to a moving point",
        );
    }
    let axes = force_in(arguments)?;
    Some(Box::new(PointForce { on, value, axes }))
}

impl Force for PointForce {
    fn action(&self, graph: &mut Graph) -> Action {
        let velocity = graph.vector_rate(self.on.position);
        let rates = graph.components(&self.axes, velocity);
        let loads = rates
            .into_iter()
            .zip(self.value)
            .filter(|&(_, force)| !graph.is_zero(force))
            .map(|(rate, force)| Load { rate, force })
            .collect();
        Action {
            potential: None,
            loads,
        }
    }

    fn points(&self) -> Vec<&Point> {
        vec![&self.on]
    }
}
