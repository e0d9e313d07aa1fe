//! A position prescribed as a function of time: a rheonomic row.

use super::conditions;
use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::{Condition, Joint, Level, ReactionComponent};
use crate::model::elements::kind::JointKind;
use crate::model::geometry::{Owner, Vector};
use crate::schema::World;
use crate::schema::{Absent, Expects, Group, JointTraits, Kind, field, positional};
use crate::symbolic::{Expr, Symbol};
use syn::{Expr as Syntax, Member};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "Drive",
        group: Group::Constraint,
        fields: &[
            positional(
                "target",
                Expects::Driven,
                Absent::Required,
                "an angle, length or other expression of the positions",
            ),
            field(
                "value",
                Expects::MovingAny,
                Absent::Required,
                "its value as a function of `t`",
            ),
        ],
        doc: "Prescribes a position as a function of time.",
        joint: Some(JointTraits::NONE),
    },
    read,
};

enum Target {
    Expression(Expr),
    /// The direction of a bar that has no angle among its coordinates.
    Direction(Vector),
}

fn read(arguments: &mut Arguments) -> Option<Joint> {
    let (value, of_value) = arguments.quantity("value")?;
    arguments.refuse(
        "value",
        &|symbol| !matches!(symbol, Symbol::Time | Symbol::Parameter(_)),
        "a drive follows time and parameters only; a relation between positions is a `Holonomic` or `Coupling`",
    )?;
    arguments.refuse_laws("value")?;
    arguments.refuse_kinks("value", 0)?;
    let owner = bar_angle(arguments);
    let (target, of_target) = match owner {
        Some(owner) => (
            Target::Direction(arguments.frame(owner).axes[0]),
            Some(Dimension::NONE),
        ),
        None => {
            conditions::check(arguments, "target")?;
            let (target, dimension) = arguments.quantity("target")?;
            if !conditions::moves(arguments, target) {
                return arguments.fail(
                    "target",
                    "this does not depend on any position: name what is to be driven, such as `crank.angle`",
                );
            }
            (Target::Expression(target), dimension)
        }
    };
    if let (Some(target), Some(value)) = (of_target, of_value)
        && target != value
    {
        return arguments.fail(
            "value",
            format!("the target is {target}, but this is {value}"),
        );
    }
    // target − value(t); for a direction sin(θ − value), whose multiplier is the same torque.
    let graph = arguments.graph();
    let expr = match target {
        Target::Expression(target) => graph.sub(target, value),
        Target::Direction(axis) => {
            let wanted = graph.direction(value);
            graph.planar_cross(wanted, axis)
        }
    };
    let condition = Condition {
        suffix: String::new(),
        level: Level::Position,
        expr,
        dimension: of_target.or(of_value),
    };
    let dimension = condition.multiplier_dimension();
    let name = match dimension {
        Dimension::TORQUE => "torque",
        Dimension::FORCE => "force",
        _ => "lambda",
    };
    let reaction = ReactionComponent {
        name,
        dimension,
        terms: vec![(0, graph.one())],
    };
    Some(Joint {
        conditions: vec![condition],
        reactions: vec![reaction],
        owners: owner.into_iter().collect(),
        ..Joint::default()
    })
}

/// Whether the target is `bar.angle` of a bar in natural coordinates.
fn bar_angle(arguments: &mut Arguments) -> Option<Owner> {
    let Syntax::Field(field) = arguments.syntax("target")? else {
        return None;
    };
    match &field.member {
        Member::Named(name) if name == "angle" => {}
        _ => return None,
    }
    if arguments.world() == World::Spatial {
        return None;
    }
    let owner = arguments.part_of(&field.base)?;
    arguments.frame(owner).angle.is_none().then_some(owner)
}
