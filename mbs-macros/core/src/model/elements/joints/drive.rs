//! A position or velocity prescribed as a function of time and inputs.

use super::conditions;
use crate::diagnostics::Place;
use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::{Condition, HeldAngle, Joint, Level, ReactionComponent};
use crate::model::elements::kind::JointKind;
use crate::model::geometry::{Owner, Vector};
use crate::schema::World;
use crate::schema::{Absent, Expects, Group, JointTraits, Kind, field, positional};
use crate::symbolic::{Expr, Function, Symbol};
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
                "an angle, length or other expression of the positions, or of the velocities",
            ),
            field(
                "value",
                Expects::ScheduledAny,
                Absent::Required,
                "its value as a function of `t`, parameters and inputs",
            ),
            field(
                "rate",
                Expects::ScheduledAny,
                Absent::Assumed("0"),
                "how fast the value goes on from `since`: value + rate · (t − since)",
            ),
            field(
                "acceleration",
                Expects::ScheduledAny,
                Absent::Assumed("0"),
                "how fast the rate goes on: + acceleration · (t − since)²/2",
            ),
            field(
                "since",
                Expects::ScheduledAny,
                Absent::Assumed("none"),
                "the time of the value and the rate, as an input; needed with them",
            ),
        ],
        doc: "Prescribes a position or a velocity as a function of time and inputs.",
        joint: Some(JointTraits::NONE),
    },
    read,
};

enum Target {
    Expression(Expr),
    /// The direction of a bar that has no angle among its coordinates, and the vector between its ends.
    Direction(Vector, Vector),
}

fn read(arguments: &mut Arguments) -> Option<Joint> {
    let (value, of_value) = value(arguments)?;
    let owner = bar_angle(arguments);
    let (target, of_target) = match owner {
        Some(owner) => (direction(arguments, owner), Some(Dimension::NONE)),
        None => expression(arguments)?,
    };
    if let (Some(target), Some(value)) = (of_target, of_value)
        && target != value
    {
        return arguments.fail(
            "value",
            format!("the target is {target}, but this is {value}"),
        );
    }
    // target − value(t). For a direction and a constant value it is sin(θ − value), linear in the coordinates, whose multiplier is the
    // same torque. Otherwise it is the angle within half a turn: after a large change the sine may lead to its other zero.
    let graph = arguments.graph();
    let mut level = Level::Position;
    let expr = match target {
        Target::Expression(target) => {
            if graph.depends_on(target, Symbol::is_velocity) {
                level = Level::Velocity;
            }
            graph.sub(target, value)
        }
        Target::Direction(axis, _) if !graph.depends_on(value, varies) => {
            let wanted = graph.direction(value);
            graph.planar_cross(wanted, axis)
        }
        Target::Direction(_, between) => {
            let angle = graph.atan2(between[1], between[0]);
            // Reduced first: the round-off of a large value is not added to the angle.
            let value = graph.within_half_turn(value);
            let value = graph.function(Function::Apart, value);
            let difference = graph.sub(angle, value);
            graph.within_half_turn(difference)
        }
    };
    let condition = Condition {
        suffix: String::new(),
        level,
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
        held_angle: owner.map(|child| HeldAngle {
            parent: Owner::Ground,
            child,
            angle: value,
        }),
        ..Joint::default()
    })
}

fn direction(arguments: &mut Arguments, bar: Owner) -> Target {
    let axis = arguments.frame(bar).axes[0];
    let length = arguments.length(bar);
    let graph = arguments.graph();
    let between = length.map_or(axis, |length| axis.map(|x| graph.mul(length, x)));
    Target::Direction(axis, between)
}

/// Whether a value changes during a run.
fn varies(symbol: Symbol) -> bool {
    matches!(symbol, Symbol::Time | Symbol::Input(_))
}

/// value + rate · (t − since) + acceleration · (t − since)²/2.
fn value(arguments: &mut Arguments) -> Option<(Expr, Option<Dimension>)> {
    let (mut value, dimension) = known(arguments, "value")?;
    if arguments.has("since") && !arguments.has("rate") && !arguments.has("acceleration") {
        return arguments.fail(
            "since",
            "`since =` is the time of `rate =` and `acceleration =`; give one of them, or leave it out".to_owned(),
        );
    }
    let mut factor = 1.0;
    for (field, order) in [("rate", 1), ("acceleration", 2)] {
        if !arguments.has(field) {
            continue;
        }
        if !arguments.has("since") {
            return arguments.fail(
                field,
                format!("a drive with `{field} =` takes `since =`, too: the time at which its values were set, such as an `Input(0.0_s)`"),
            );
        }
        let (slope, found) = known(arguments, field)?;
        let wanted = dimension.map(|d| (0..order).fold(d, |d, _| d.over(Dimension::TIME)));
        check(arguments, field, found, wanted)?;
        let (since, found) = known(arguments, "since")?;
        check(arguments, "since", found, Some(Dimension::TIME))?;
        factor /= f64::from(order);
        let graph = arguments.graph();
        let time = graph.symbol(Symbol::Time);
        let passed = graph.sub(time, since);
        let term = graph.product(&[(slope, 1), (passed, order)]);
        let term = graph.scale(factor, term);
        value = graph.add(value, term);
    }
    Some((value, dimension))
}

/// What is known of time, parameters and inputs.
fn known(arguments: &mut Arguments, field: &str) -> Option<(Expr, Option<Dimension>)> {
    let found = arguments.quantity(field)?;
    arguments.refuse(
        field,
        &|symbol| {
            !matches!(
                symbol,
                Symbol::Time | Symbol::Parameter(_) | Symbol::Input(_)
            )
        },
        "a drive follows time, parameters and inputs only; a relation between positions is a `Holonomic` or `Coupling`",
    )?;
    arguments.refuse_laws(field)?;
    arguments.refuse_kinks(field, 0)?;
    Some(found)
}

fn check(
    arguments: &mut Arguments,
    field: &str,
    found: Option<Dimension>,
    wanted: Option<Dimension>,
) -> Option<()> {
    match (arguments.syntax(field), wanted) {
        (Some(syntax), Some(wanted)) => {
            arguments.check_dimension(field, found, wanted, Place::of(syntax))
        }
        _ => Some(()),
    }
}

/// A position, or a velocity that is affine in the velocities.
fn expression(arguments: &mut Arguments) -> Option<(Target, Option<Dimension>)> {
    let (target, dimension) = arguments.quantity("target")?;
    if arguments.graph().depends_on(target, Symbol::is_velocity) {
        arguments.refuse_laws("target")?;
        arguments.refuse_kinks("target", 1)?;
        if !arguments.graph().is_affine_in_velocities(target) {
            return arguments.fail(
                "target",
                "a velocity that is driven must be affine in the velocities: a component, not a norm",
            );
        }
        return Some((Target::Expression(target), dimension));
    }
    conditions::check(arguments, "target")?;
    if !conditions::moves(arguments, target) {
        return arguments.fail(
            "target",
            "this does not depend on any position: name what is to be driven, such as `crank.angle`",
        );
    }
    Some((Target::Expression(target), dimension))
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
