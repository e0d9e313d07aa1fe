//! Dry friction with the Stribeck effect, made smooth, and viscous friction.

use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::force::{Force, ForceElement, Load};
use crate::model::requirements::Wanted;
use crate::symbolic::{Expr, Function, Symbol};

pub(super) fn read(arguments: &mut Arguments) -> Option<Force> {
    let (speed, dimension) = arguments.quantity("speed")?;
    if !arguments.graph().depends_on(speed, Symbol::is_velocity) {
        return arguments.fail(
            "speed",
            "this does not depend on any velocity: name the speed of sliding, for a position x `rate(x)`",
        );
    }
    arguments.refuse_laws_in_force("speed")?;
    if !arguments.graph().is_affine_in_velocities(speed) {
        return arguments.fail(
            "speed",
            "the speed of sliding has a sign and is affine in the velocities: a component of a velocity, not its norm",
        );
    }
    // Power is force times speed.
    let of_force = dimension.map(|d| Dimension::TORQUE.over(Dimension::TIME).over(d));
    arguments.refuse_reaction("load")?;
    let load = arguments.of_dimension("load", of_force)?;
    arguments.refuse_negative("load", load)?;
    let coefficient = friction_coefficient(arguments, speed, dimension)?;
    let within = arguments.of_dimension("regularization_velocity", dimension)?;
    let message = "`regularization_velocity` has to be positive";
    arguments.refuse_not_positive("regularization_velocity", within, message)?;
    let viscous = of_force
        .zip(dimension)
        .map(|(force, speed)| force.over(speed));
    let damping = arguments.not_negative("damping", viscous)?;
    let graph = arguments.graph();
    let ratio = graph.div(speed, within);
    let sign = graph.function(Function::Tanh, ratio);
    let dry = graph.mul(load, coefficient);
    let dry = graph.mul(dry, sign);
    let viscous = graph.mul(damping, speed);
    let friction = graph.add(dry, viscous);
    let force = graph.neg(friction);
    // What the surface moves by itself is no motion of the mechanism.
    let surface = graph.without_velocities(speed);
    let rate = graph.sub(speed, surface);
    Some(Force {
        points: Vec::new(),
        owners: Vec::new(),
        element: ForceElement::Load {
            load: Load { rate, force },
            dimension: of_force,
        },
    })
}

/// μ + (μₛ − μ) exp(−(speed/v)²).
fn friction_coefficient(
    arguments: &mut Arguments,
    speed: Expr,
    dimension: Option<Dimension>,
) -> Option<Expr> {
    let kinetic = arguments.not_negative("coefficient", Some(Dimension::NONE))?;
    let pair = ["static_coefficient", "stribeck_velocity"];
    match pair.map(|field| arguments.has(field)) {
        [false, false] => return Some(kinetic),
        [true, true] => {}
        [true, false] => {
            return arguments.fail(pair[0], "a static coefficient takes a `stribeck_velocity =`, too: the speed with which friction falls from it");
        }
        [false, true] => {
            return arguments.fail(
                pair[1],
                "a Stribeck velocity takes a `static_coefficient =`, too: friction falls from it",
            );
        }
    }
    let at_rest = arguments.not_negative(pair[0], Some(Dimension::NONE))?;
    if arguments.by_default(at_rest) < arguments.by_default(kinetic) {
        return arguments.fail(
            pair[0],
            "the static coefficient is smaller than the kinetic one; give it the value of `coefficient` at least",
        );
    }
    let more = arguments.graph().sub(at_rest, kinetic);
    arguments.require(
        "static_coefficient - coefficient",
        &[more],
        Wanted::NotNegative,
    );
    let decay = arguments.of_dimension(pair[1], dimension)?;
    arguments.refuse_not_positive(pair[1], decay, "`stribeck_velocity` has to be positive")?;
    let graph = arguments.graph();
    let ratio = graph.div(speed, decay);
    let square = graph.square(ratio);
    let exponent = graph.neg(square);
    let share = graph.function(Function::Exp, exponent);
    let more = graph.mul(more, share);
    Some(graph.add(kinetic, more))
}
