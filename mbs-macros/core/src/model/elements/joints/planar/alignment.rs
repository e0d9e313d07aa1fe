//! The condition that keeps the angle between two frames.

use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::{Condition, HeldAngle};
use crate::model::geometry::{Attachment, Frame, Point, Vector};
use crate::model::mobilizer::{Freedom, Mobilizer};
use crate::symbolic::{Expr, Graph};

/// Two frames that keep an angle.
#[derive(Debug)]
pub(super) struct Alignment {
    parent: Frame,
    child: Frame,
    angle: Expr,
}

/// Reads the frames behind two points, and `angle =`.
pub(super) fn read(arguments: &mut Arguments, parent: &Point, child: &Point) -> Option<Alignment> {
    for (field, point) in [("parent", parent), ("child", child)] {
        if arguments.is_particle(point.owner) {
            let name = arguments.owner_name(point.owner);
            return arguments.fail(field, format!("`{name}` is a particle and has no orientation to hold; use a Body, or PointOnLine or Revolute"));
        }
    }
    if parent.owner == child.owner {
        let owner = arguments.owner_name(parent.owner);
        return arguments.fail(
            "child",
            format!("both points belong to `{owner}`: a joint holds two different parts"),
        );
    }
    let angle = arguments.scalar_or("angle", 0.0)?;
    Some(Alignment {
        parent: arguments.frame(parent.owner),
        child: arguments.frame(child.owner),
        angle,
    })
}

impl Alignment {
    /// The freedoms of two points whose frames keep this angle: sliding along `axis` (in the parent's axes), or none.
    pub(super) fn mobilizer(
        &self,
        graph: &mut Graph,
        points: [&Point; 2],
        axis: Option<Vector>,
    ) -> Mobilizer {
        let x = axis.unwrap_or_else(|| graph.ground_axes()[0]);
        let turned = graph.direction(self.angle);
        let turned = graph.planar_axes(turned);
        let directions = [x, graph.components(&turned, x)];
        let frames = [&self.parent, &self.child];
        let [parent, child] = [0, 1].map(|side| {
            let local = graph.planar_axes(directions[side]);
            Attachment {
                point: points[side].clone(),
                axes: graph.compose(&frames[side].axes, &local),
                local,
            }
        });
        let freedoms: Vec<Freedom> = axis.iter().map(|_| Freedom::Slide(0)).collect();
        Mobilizer {
            offset: Some(self.angle),
            ..Mobilizer::new(&parent, &child, freedoms)
        }
    }

    /// What the condition holds.
    pub(super) fn held_angle(&self, points: [&Point; 2]) -> HeldAngle {
        let [parent, child] = points.map(|point| point.owner);
        HeldAngle {
            parent,
            child,
            angle: self.angle,
        }
    }

    /// θ_child − θ_parent − angle if both frames have an angle; otherwise its sine, from the directions. Either way the
    /// multiplier is the torque on the child.
    pub(super) fn condition(&self, graph: &mut Graph) -> Condition {
        let expr = match (self.parent.angle, self.child.angle) {
            (Some(parent), Some(child)) => {
                let relative = graph.sub(child, parent);
                graph.sub(relative, self.angle)
            }
            _ => {
                let offset = graph.direction(self.angle);
                let expected = graph.turn(&self.parent.axes, offset);
                graph.planar_cross(expected, self.child.axes[0])
            }
        };
        Condition::position("angle", expr, Dimension::NONE)
    }
}
