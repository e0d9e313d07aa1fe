//! Two points keep their distance, as if joined by a massless rod.

use super::{Joint, JointEquations, ReactionComponent, row};
use crate::model::{Arguments, Dimension, Point, Vector};
use crate::schema::World;
use crate::symbolic::{Expr, Graph};

#[derive(Debug)]
struct Distance {
    parent: Point,
    child: Point,
    length: Expr,
    /// Components of a force.
    components: usize,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    let (parent, child) = (arguments.point("parent"), arguments.point("child"));
    let (parent, child) = (parent?, child?);
    let length = arguments.scalar("length")?;
    arguments.refuse_no_length(
        "length",
        length,
        match arguments.world() {
            World::Planar => {
                "the distance must be positive; to hold two points together use `Revolute`"
            }
            World::Spatial => {
                "the distance must be positive; to hold two points together use `Spherical`"
            }
        },
    )?;
    if parent.owner == child.owner {
        let owner = arguments.owner_name(parent.owner);
        return arguments.fail(
            "child",
            format!("both points belong to `{owner}`: their distance is fixed already"),
        );
    }
    Some(Box::new(Distance {
        parent,
        child,
        length,
        components: arguments.world().dimension(),
    }))
}

impl Joint for Distance {
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        let difference = graph.vector_sub(self.child.position, self.parent.position);
        let force = |name, d| ReactionComponent {
            name,
            dimension: Dimension::FORCE,
            terms: vec![(0, d)],
        };
        JointEquations {
            rows: vec![row(
                "",
                half_square_difference(graph, difference, self.length),
                Dimension([2, 0, 0, 0]),
            )],
            reactions: ["fx", "fy", "fz"]
                .into_iter()
                .zip(difference)
                .take(self.components)
                .map(|(name, d)| force(name, d))
                .collect(),
        }
    }

    fn points(&self) -> Vec<&Point> {
        vec![&self.parent, &self.child]
    }
}

/// (d·d − L²)/2: quadratic, so that its Jacobian is d itself; λ d is the force on the second point.
pub(super) fn half_square_difference(graph: &mut Graph, difference: Vector, length: Expr) -> Expr {
    let square = graph.dot(difference, difference);
    let length_square = graph.square(length);
    let gap = graph.sub(square, length_square);
    graph.scale(0.5, gap)
}
