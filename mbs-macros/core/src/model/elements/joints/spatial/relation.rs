//! Two joints whose angles or strokes are related by a third one.

use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::{Condition, Joint, ReactionComponent};
use crate::model::elements::joints::relation;
use crate::model::joint_frames::JointFrames;
use crate::symbolic::Expr;

/// second − ratio · first − offset = 0
pub(super) struct Relation {
    pub joints: [JointFrames; 2],
    /// Their angles or strokes.
    pub variables: [Expr; 2],
    pub ratio: Expr,
    pub offset: Expr,
    pub unit: Dimension,
    pub reaction: (&'static str, Dimension),
}

impl Relation {
    pub fn joint(self, arguments: &mut Arguments) -> Joint {
        let graph = arguments.graph();
        let [first, second] = self.variables;
        let expr = relation::affine(graph, first, second, self.ratio, self.offset);
        let (name, dimension) = self.reaction;
        let owners = self.joints.iter().flat_map(JointFrames::owners);
        Joint {
            conditions: vec![Condition::position("", expr, self.unit)],
            reactions: vec![ReactionComponent {
                name,
                dimension,
                terms: vec![(0, graph.one())],
            }],
            owners: owners.collect(),
            ..Joint::default()
        }
    }
}

/// A joint that turns.
pub(super) fn turning(arguments: &mut Arguments, field: &str) -> Option<JointFrames> {
    let joint = arguments.joint(field)?;
    if !joint.turns {
        let (kind, name) = (&joint.kind, &joint.name);
        let others = arguments.joints_that(|traits| traits.turns);
        return arguments.fail(
            field,
            format!("`{name}` is a `{kind}`, which has no angle; name a {others}"),
        );
    }
    Some(joint)
}
