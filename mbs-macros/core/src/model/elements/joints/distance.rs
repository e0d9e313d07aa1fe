//! Two points keep their distance, as if joined by a massless rod.

use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::{Condition, Joint, ReactionComponent};
use crate::model::elements::kind::JointKind;
use crate::model::geometry::Vector;
use crate::schema::World;
use crate::schema::common::{CHILD, PARENT};
use crate::schema::{Absent, Expects, Group, JointTraits, Kind, field};
use crate::symbolic::{Expr, Graph};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "Distance",
        group: Group::Joint,
        fields: &[
            PARENT,
            CHILD,
            field(
                "length",
                Expects::Known(Dimension::LENGTH),
                Absent::Required,
                "the distance kept; not zero (use Revolute)",
            ),
        ],
        doc: "Two points keep their distance, as if joined by a massless rod.",
        joint: Some(JointTraits::NONE),
    },
    read,
};

/// The dimension of a difference of squares of lengths.
pub(super) const AREA: Dimension = Dimension([2, 0, 0, 0]);

fn read(arguments: &mut Arguments) -> Option<Joint> {
    let (parent, child) = (arguments.point("parent"), arguments.point("child"));
    let (parent, child) = (parent?, child?);
    let length = arguments.scalar("length")?;
    arguments.refuse_not_positive(
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
    let components = arguments.world().dimension();
    let graph = arguments.graph();
    let difference = graph.vector_sub(child.position, parent.position);
    let expr = half_square_difference(graph, difference, length);
    let forces = ["fx", "fy", "fz"].into_iter().zip(difference);
    let forces = forces.take(components);
    Some(Joint {
        conditions: vec![Condition::position("", expr, AREA)],
        reactions: forces
            .map(|(name, d)| ReactionComponent::force(name, 0, d))
            .collect(),
        points: vec![parent, child],
        ..Joint::default()
    })
}

/// (d·d − L²)/2: quadratic, so that its Jacobian is d itself; λ d is the force on the second point.
pub(super) fn half_square_difference(graph: &mut Graph, difference: Vector, length: Expr) -> Expr {
    let square = graph.dot(difference, difference);
    let length_square = graph.square(length);
    let gap = graph.sub(square, length_square);
    graph.scale(0.5, gap)
}
