//! Names, visibility and documentation of emitted items.

use crate::dag::Program;
use crate::syntax::Declaration;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// The declared visibility; by default `pub`.
pub(super) fn visibility(declaration: &Declaration) -> TokenStream {
    let declared = declaration.visibility.as_ref();
    declared.map_or_else(|| quote! { pub }, |visibility| quote! { #visibility })
}

/// The name of the hidden type.
pub(super) fn system(declaration: &Declaration) -> Ident {
    format_ident!(
        "{}Equations",
        declaration.name,
        span = declaration.name.span()
    )
}

/// M⁻¹ of more velocities is on the heap: the system is passed by value while a simulation is made.
const MOST_IN_PLACE: usize = 32;

/// Whether M⁻¹ is a box.
pub(super) fn boxes_inverse(size: usize) -> bool {
    size > MOST_IN_PLACE
}

/// From so many velocities and rows on M⁻¹ is not computed: the factor of a long M without its zeros is shorter.
const FEWEST_OF_LONG: usize = 300;

/// Whether a constant M is kept as its factor.
pub(super) fn factors_mass(program: &Program) -> bool {
    program.size + program.rows.len() >= FEWEST_OF_LONG && !program.reads_inverse_mass()
}

/// The name of the simulation.
pub(super) fn simulation(declaration: &Declaration) -> Ident {
    let name = &declaration.name;
    format_ident!("{name}Simulation", span = name.span())
}

/// The name of the simulation by steps of one length.
pub(super) fn fixed_step_simulation(declaration: &Declaration) -> Ident {
    let name = &declaration.name;
    format_ident!("{name}FixedStepSimulation", span = name.span())
}

/// The structs of inputs and outputs.
pub(super) fn inputs_and_outputs(declaration: &Declaration) -> (Ident, Ident) {
    let of = |suffix: &str| {
        format_ident!(
            "{}{suffix}",
            declaration.name,
            span = declaration.name.span()
        )
    };
    (of("Inputs"), of("Outputs"))
}

/// The documentation of a value, and its unit in parentheses.
pub(super) fn documented(text: &str, unit: &str) -> String {
    let unit = match unit {
        "" => "dimensionless".to_owned(),
        unit => format!("in {unit}"),
    };
    match text {
        "" => format!("({unit})"),
        // A paragraph of its own: the last line may be the end of a block of code.
        text if text.contains('\n') => format!("{text}\n\n({unit})"),
        text => format!("{text} ({unit})"),
    }
}
