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

/// The field `word` of a parameter, input or output of this name, or of a family of them, with the span of its
/// declaration.
pub(super) fn field(declaration: &Declaration, name: &str, word: &str) -> Ident {
    let family = declaration.family(name).map(|family| &family.name);
    let entry = || declaration.entries.iter().find(|entry| entry.name == name);
    let instance = || declaration.instance(name).map(|instance| &instance.name);
    let declared = family
        .or_else(|| entry().map(|entry| &entry.name))
        .or_else(instance);
    declared.map_or_else(|| format_ident!("{word}"), |name| name.word().clone())
}

/// The documentation of a value, and its unit in parentheses.
pub(super) fn documented(text: &str, unit: &str) -> String {
    let unit = match unit {
        "" => "dimensionless".to_owned(),
        unit => format!("in {unit}"),
    };
    match text {
        "" => format!("({unit})"),
        text => format!("{text} ({unit})"),
    }
}
