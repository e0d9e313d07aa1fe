//! Stops of a position.

use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::force::{Force, ForceElement, Side, Stop};
use crate::model::requirements::Wanted;
use crate::symbolic::{Expr, Symbol};

pub(super) fn read(arguments: &mut Arguments) -> Option<Force> {
    let (target, dimension) = arguments.quantity("target")?;
    arguments.refuse(
        "target",
        &Symbol::is_velocity,
        "a stop acts on a position; what acts against a rate is a `Friction` or a damper",
    )?;
    arguments.refuse(
        "target",
        &|symbol| matches!(symbol, Symbol::Time | Symbol::Input(_)),
        "a stop has a potential energy, which follows positions and parameters only: let a part move with a `Drive`, and measure from it",
    )?;
    arguments.refuse_laws_in_force("target")?;
    let moves = |symbol: Symbol| symbol.is_local_position();
    if !arguments.graph().depends_on(target, moves) {
        return arguments.fail(
            "target",
            "this does not depend on any position: name what the stop limits",
        );
    }
    let sides = sides(arguments, dimension)?;
    // Energy is half the stiffness times the square of the target.
    let stiffness = dimension.map(|d| Dimension::TORQUE.over(d).over(d));
    let rate = dimension.map(|d| d.over(Dimension::TIME));
    let stop = Stop {
        target,
        rate: arguments.rate_of(target),
        dimension: dimension.map(|d| Dimension::TORQUE.over(d)),
        sides,
        stiffness: positive(
            arguments,
            "stiffness",
            stiffness,
            "`stiffness` of a stop has to be positive",
        )?,
        onset: positive(
            arguments,
            "onset",
            dimension,
            "`onset` of a stop has to be positive",
        )?,
        dissipation: arguments
            .not_negative("dissipation", rate.map(|r| Dimension::NONE.over(r)))?,
    };
    Some(Force {
        points: Vec::new(),
        owners: Vec::new(),
        element: ForceElement::Stop(Box::new(stop)),
    })
}

fn sides(arguments: &mut Arguments, dimension: Option<Dimension>) -> Option<Vec<Side>> {
    let (mut sides, mut bounds) = (Vec::new(), Vec::new());
    for (field, is_upper) in [("lower", false), ("upper", true)] {
        if arguments.has(field) {
            let begin = arguments.of_dimension(field, dimension)?;
            bounds.push(begin);
            sides.push(Side { begin, is_upper });
        }
    }
    match bounds[..] {
        [] => return arguments.fail("", "a stop needs `lower =`, `upper =` or both"),
        [lower, upper] => {
            let room = arguments.graph().sub(upper, lower);
            if !(arguments.by_default(room) > 0.0) {
                return arguments.fail(
                    "upper",
                    "the upper stop begins where the lower one does, or below it; give `upper =` a larger value than `lower =`",
                );
            }
            let wanted = Wanted::Positive("the upper stop has to begin above the lower one");
            arguments.require("upper - lower", &[room], wanted);
        }
        _ => {}
    }
    Some(sides)
}

fn positive(
    arguments: &mut Arguments,
    field: &str,
    wanted: Option<Dimension>,
    message: &'static str,
) -> Option<Expr> {
    let value = arguments.of_dimension(field, wanted)?;
    arguments.refuse_not_positive(field, value, message)?;
    Some(value)
}
