//! Joints of the plane as values of expressions: what `angle`, `rate`, `stroke` and `speed` are measured between.

use super::arguments::Arguments;
use super::geometry::{Attachment, Point};
use super::joint_frames::JointFrames;
use super::resolver::{Resolver, State};
use super::value::Value;
use crate::schema::{Group, World};
use crate::symbolic::Expr;
use crate::syntax::Entry;

impl Resolver<'_> {
    /// Whether an entry is a joint of the plane that leaves a turn or a slide free.
    pub(super) fn is_planar_joint(&self, entry: &Entry) -> bool {
        self.world == World::Planar
            && self.kind_of(entry).is_some_and(|kind| {
                let traits = kind.traits();
                kind.group == Group::Joint && (traits.turns || traits.slides)
            })
    }

    /// Whether the value of a joint of the plane was asked for, and has an error, which is recorded.
    pub(super) fn is_wrong_joint(&self, entry: &Entry) -> bool {
        let state = self.names.get(entry.name.as_str());
        let state = state.map(|&index| &self.states[index]);
        self.is_planar_joint(entry) && matches!(state, Some(State::Done(None)))
    }

    /// A joint of the plane as a value.
    pub(super) fn planar_joint(&mut self, entry: &Entry) -> Option<Value> {
        let kind = self.kind_of(entry)?;
        let (traits, is_line) = (kind.traits(), kind.fields.iter().any(|f| f.name == "line"));
        let sides = match is_line {
            true => ["line", "point"],
            false => ["parent", "child"],
        };
        let mut arguments = Arguments::new(self, entry);
        let [parent, child] = sides.map(|side| arguments.point(side));
        let (parent, child) = (parent?, child?);
        let along = match traits.slides {
            true => arguments.axis("axis", parent.owner)?,
            false => arguments.graph().zero_vector(),
        };
        let [parent, child] = [parent, child].map(|point| self.with_axes(point));
        Some(Value::Joint(Box::new(JointFrames {
            name: entry.name.to_string(),
            kind: entry.kind.to_string(),
            turns: traits.turns,
            slides: traits.slides,
            along,
            parent,
            child,
            letters: ["x", "y", "z"],
        })))
    }

    fn with_axes(&mut self, point: Point) -> Attachment {
        Attachment {
            local: self.graph.ground_axes(),
            axes: self.frame(point.owner).axes,
            point,
        }
    }

    /// The angle of the child against the parent, counted over full turns.
    pub(super) fn relative_angle(&mut self, joint: &JointFrames) -> Expr {
        let [parent, child] = joint.owners().map(|owner| self.part_angle(owner));
        self.graph.sub(child, parent)
    }
}
