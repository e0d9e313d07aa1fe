//! The states: a constant, and a field of the system where their scales follow from parameters.

use super::body::{Body, number};
use super::metadata::quantity_text;
use crate::contract::Capability;
use crate::dag::Program;
use crate::equations::System;
use crate::model::Outline;
use proc_macro2::TokenStream;
use quote::quote;

/// The constant `STATES`, and what the system has in place of it; nothing where there is no state.
pub(super) fn constant(outline: &Outline, system: &System) -> String {
    if outline.states.is_empty() {
        return String::new();
    }
    let places = system.layout.states.iter();
    let texts = outline.states.iter().zip(places).map(|(state, &velocity)| {
        format!(
            "::mbs_runtime::ScalarState {{ quantity: {}, scale: {}, coordinate: {}, velocity: {velocity} }}",
            quantity_text(&state.quantity),
            number(state.scale),
            system.layout.slots[velocity],
        )
    });
    let texts: Vec<String> = texts.collect();
    format!(
        "const STATES: &'static [::mbs_runtime::ScalarState] = &[{}];\n{}",
        texts.join(", "),
        match system.scales.is_empty() {
            true => "",
            false =>
                "#[inline] fn states(&self) -> &[::mbs_runtime::ScalarState] { &self.states }\n",
        }
    )
}

/// The field with the scales that follow from parameters.
pub(super) fn field(system: &System) -> Option<TokenStream> {
    let count = system.scales.len();
    (count > 0).then(|| quote! { states: [::mbs_runtime::ScalarState; #count], })
}

/// The statement of `prepare` that computes this field; `equations` is their type.
pub(super) fn preparation(system: &System, program: &Program, equations: &str) -> String {
    if system.scales.is_empty() {
        return String::new();
    }
    let body = Body::of_preparation(&system.graph, &program.scales, equations);
    let (statements, values) = (body.statements(), body.values().join(", "));
    let observables = Capability::Observables.name(program);
    format!(
        "let states = {{ {statements} ::mbs_runtime::generated::with_scales(<{equations} as ::mbs_runtime::{observables}>::STATES, [{values}]) }};\n"
    )
}
