//! An elastic joint: springs and dampers in all six directions.

use crate::model::arguments::Arguments;
use crate::model::elements::force::{Bushing, Force, ForceElement};

pub(super) fn read(arguments: &mut Arguments) -> Option<Force> {
    let frames = arguments.own_frames()?;
    let fields = [
        "stiffness",
        "damping",
        "torsion_stiffness",
        "torsion_damping",
        "cross_stiffness",
    ];
    if fields.iter().all(|field| !arguments.has(field)) {
        return arguments.fail(
            "",
            "this bushing does nothing; give it a `stiffness`, `damping`, `torsion_stiffness` or `torsion_damping`",
        );
    }
    let mut gains = Vec::new();
    for field in fields {
        gains.push(arguments.gains(field)?);
    }
    let [
        stiffness,
        damping,
        torsion_stiffness,
        torsion_damping,
        cross_stiffness,
    ] = gains.try_into().ok()?;
    let points = frames.points();
    let bushing = Bushing {
        parent: frames.parent,
        child: frames.child,
        stiffness,
        damping,
        torsion_stiffness,
        torsion_damping,
        cross_stiffness,
    };
    Some(Force {
        points,
        owners: Vec::new(),
        element: ForceElement::Bushing(Box::new(bushing)),
    })
}
