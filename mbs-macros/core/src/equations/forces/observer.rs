//! Motion as seen from the axes of a part.
//!
//! A part's own velocities need no rotation in its own axes: RᵀR is never multiplied out.

use crate::model::{Model, Owner, Part, Point, Vector};
use crate::symbolic::{Expr, Graph, Symbol};

/// The ground or a part, in whose axes components are given.
#[derive(Clone, Copy)]
pub(super) struct Observer<'a> {
    owner: Owner,
    /// A part that turns in space; `None` for the ground and all other parts.
    rigid: Option<&'a Part>,
    model: &'a Model,
}

impl<'a> Observer<'a> {
    pub(super) fn new(model: &'a Model, owner: Owner) -> Observer<'a> {
        let part = owner.part().map(|part| &model.outline.parts[part]);
        let rigid = part.filter(|part| part.rotation().is_some());
        Observer {
            owner,
            rigid,
            model,
        }
    }

    /// A vector of the ground's axes in components of these.
    fn components(&self, graph: &mut Graph, vector: Vector) -> Vector {
        match self.owner.part() {
            Some(part) => graph.components(&self.model.outline.parts[part].frame.axes, vector),
            None => vector,
        }
    }

    /// Where a point is, from the centre of mass of a part that turns in space and from the ground's origin otherwise.
    pub(super) fn place(&self, graph: &mut Graph, point: &Point) -> Vector {
        let Some(part) = self.rigid else {
            return self.components(graph, point.position);
        };
        if point.owner == self.owner {
            return graph.vector_sub(point.local, part.center);
        }
        let center = symbols(graph, part, 0, Symbol::LocalPosition);
        let gap = graph.vector_sub(point.position, center);
        self.components(graph, gap)
    }

    /// The velocity of a point.
    pub(super) fn velocity(&self, graph: &mut Graph, point: &Point) -> Vector {
        match self.rigid {
            Some(part) if point.owner == self.owner => {
                let own = part.own_velocity(graph);
                let arm = graph.vector_sub(point.local, part.center);
                let turning = self.own_spin(graph);
                let swing = graph.cross(turning, arm);
                graph.vector_add(own, swing)
            }
            _ => {
                let velocity = graph.vector_rate(point.position);
                self.components(graph, velocity)
            }
        }
    }

    /// The rate of a point's place, where the axes turn with the observer: Rᵀ(ẋ − ċ) − ω × place.
    pub(super) fn rate(&self, graph: &mut Graph, point: &Point, place: Vector) -> Vector {
        let Some(part) = self.rigid else {
            return graph.vector_rate(place);
        };
        if point.owner == self.owner {
            return graph.zero_vector();
        }
        let mut velocity = graph.vector_rate(point.position);
        let is_carried = self.owner.part().is_some_and(|part| self.carries(part));
        if !is_carried {
            let center = symbols(graph, part, 0, Symbol::LocalVelocity);
            velocity = graph.vector_sub(velocity, center);
        }
        let mut rate = self.components(graph, velocity);
        if is_carried {
            let own = part.own_velocity(graph);
            rate = graph.vector_sub(rate, own);
        }
        let turning = self.own_spin(graph);
        let swing = graph.cross(turning, place);
        graph.vector_sub(rate, swing)
    }

    fn carries(&self, part: usize) -> bool {
        let mut joints = self.model.outline.tree.joints.iter();
        joints.any(|joint| joint.child == part)
    }

    /// The angular velocity of the ground or a part.
    pub(super) fn spin(&self, graph: &mut Graph, owner: Owner) -> Vector {
        match owner {
            Owner::Ground => graph.zero_vector(),
            _ if owner == self.owner && self.rigid.is_some() => self.own_spin(graph),
            Owner::Part(part) => self.components(graph, self.model.outline.parts[part].frame.spin),
        }
    }

    fn own_spin(&self, graph: &mut Graph) -> Vector {
        match self.rigid {
            Some(part) => symbols(graph, part, 3, Symbol::LocalVelocity),
            None => graph.zero_vector(),
        }
    }
}

/// Three consecutive locals of a part, from the given one on.
fn symbols(graph: &mut Graph, part: &Part, first: usize, of: fn(u32) -> Symbol) -> [Expr; 3] {
    [0, 1, 2].map(|k| graph.symbol(of(part.locals[first + k])))
}
