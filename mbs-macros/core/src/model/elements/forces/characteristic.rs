//! The characteristic of a spring and damper, as declared.

use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::force::{Characteristic, Damping};
use crate::schema::Expects;
use crate::symbolic::Table;
use std::sync::Arc;

/// Reads `stiffness`, `damping` and the free deflection, or `law`.
pub(super) fn read(arguments: &mut Arguments, free: &str) -> Option<Characteristic> {
    if arguments.names_table("law") {
        if arguments.has("stiffness") {
            return arguments.fail(
                "stiffness",
                "a table takes the place of the stiffness; keep one of them",
            );
        }
        let table = table_over(arguments, "law", free, None);
        let damping = damping(arguments, free);
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
        let (law, others) = arguments.law_of("law", 2)?;
        return Some(Characteristic::Law(law, others));
    }
    if !arguments.has("stiffness") && !arguments.has("damping") {
        return arguments.fail(
            "",
            "this element does nothing; give it `stiffness =`, `damping =` or `law =`",
        );
    }
    let stiffness = arguments.scalar_or("stiffness", 0.0);
    let damping = damping(arguments, free);
    let free = arguments.scalar_or(free, 0.0);
    Some(Characteristic::Linear {
        stiffness: stiffness?,
        damping: damping?,
        free: free?,
    })
}

/// A number, or a table of force over rate.
fn damping(arguments: &mut Arguments, free: &str) -> Option<Damping> {
    if arguments.names_table("damping") {
        return table_over(arguments, "damping", free, Some(Dimension::TIME)).map(Damping::Table);
    }
    arguments.scalar_or("damping", 0.0).map(Damping::Linear)
}

/// A table of force over deflection, or over deflection per time; `free` is a field of the deflection's dimension.
fn table_over(
    arguments: &mut Arguments,
    field: &str,
    free: &str,
    per: Option<Dimension>,
) -> Option<Arc<Table>> {
    let expected = ["stiffness", free].map(|field| arguments.expects(field));
    let [
        Some(Expects::Known(stiffness)),
        Some(Expects::Known(deflection)),
    ] = expected
    else {
        return None;
    };
    let takes = per.map_or(deflection, |per| deflection.over(per));
    arguments.table(field, [takes, stiffness.times(deflection)])
}
