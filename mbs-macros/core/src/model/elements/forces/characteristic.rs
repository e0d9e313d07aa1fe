//! The characteristic of a spring and damper, as declared.

use crate::model::arguments::Arguments;
use crate::model::elements::force::Characteristic;

/// Reads `stiffness`, `damping` and the free deflection, or `law`.
pub(super) fn read(arguments: &mut Arguments, free: &str) -> Option<Characteristic> {
    if arguments.names_table("law") {
        if arguments.has("stiffness") {
            return arguments.fail(
                "stiffness",
                "a table takes the place of the stiffness; keep one of them",
            );
        }
        let table = arguments.force_table("law", free);
        let damping = arguments.scalar_or("damping", 0.0);
        let free = arguments.scalar_or(free, 0.0);
        return Some(Characteristic::Table {
            table: table?,
            damping: damping?,
            free: free?,
        });
    }
    if arguments.has("law") {
        if let Some(field) = ["stiffness", "damping", free]
            .into_iter()
            .find(|field| arguments.has(field))
        {
            return arguments.fail(
                field,
                "a law takes the place of stiffness, damping and free length; keep one of them",
            );
        }
        return arguments.law("law", 2).map(Characteristic::Law);
    }
    if !arguments.has("stiffness") && !arguments.has("damping") {
        return arguments.fail(
            "",
            "this element does nothing; give it `stiffness =`, `damping =` or `law =`",
        );
    }
    let stiffness = arguments.scalar_or("stiffness", 0.0);
    let damping = arguments.scalar_or("damping", 0.0);
    let free = arguments.scalar_or(free, 0.0);
    Some(Characteristic::Linear {
        stiffness: stiffness?,
        damping: damping?,
        free: free?,
    })
}
