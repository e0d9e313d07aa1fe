//! The angles of two parts against the ground keep a ratio.

use super::{Joint, JointEquations, affine_relation, row, torque};
use crate::model::{Arguments, Dimension, Owner};
use crate::symbolic::{Expr, Graph};

#[derive(Debug)]
struct Gear {
    owners: [Owner; 2],
    parent: Expr,
    child: Expr,
    ratio: Expr,
    offset: Expr,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    let (parent, child) = (arguments.part("parent"), arguments.part("child"));
    let owners = [parent?, child?];
    if owners[0] == owners[1] {
        return arguments.fail(
            "child",
            "a gear couples two different parts; name another part",
        );
    }
    let mut angles = [None; 2];
    for (slot, field) in ["parent", "child"].into_iter().enumerate() {
        let owner = owners[slot];
        let angle = arguments
            .frame(owner)
            .angle
            .filter(|_| !arguments.is_particle(owner));
        if angle.is_none() {
            let name = arguments.owner_name(owner);
            return arguments.fail(
                field,
                format!("`{name}` has no angle that a gear could couple; use a Body or a Bar"),
            );
        }
        angles[slot] = angle;
    }
    let (ratio, offset) = (
        arguments.scalar("ratio"),
        arguments.scalar_or("offset", 0.0),
    );
    Some(Box::new(Gear {
        owners,
        parent: angles[0]?,
        child: angles[1]?,
        ratio: ratio?,
        offset: offset?,
    }))
}

impl Joint for Gear {
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        let expr = affine_relation(graph, self.parent, self.child, self.ratio, self.offset);
        JointEquations {
            rows: vec![row("", expr, Dimension::NONE)],
            reactions: vec![torque(graph, 0)],
        }
    }

    fn owners(&self) -> Vec<Owner> {
        self.owners.to_vec()
    }
}
