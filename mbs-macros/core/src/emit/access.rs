//! Typed access: the simulation of a mechanism by one name, and its inputs and outputs as fields.

use super::fields::{fields, places};
use super::items::{self, visibility};
use super::text::{doc, tokens};
use crate::contract::Capability;
use crate::dag::Program;
use crate::model::{Outline, Quantity};
use crate::syntax::Declaration;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// The alias of the simulation, and the two structs.
pub(super) fn emit(declaration: &Declaration, outline: &Outline, program: &Program) -> TokenStream {
    let (name, system) = (&declaration.name, items::system(declaration));
    let visibility = visibility(declaration);
    let alias = items::simulation(declaration);
    let sizes = tokens(&Capability::System.sizes(program));
    let about = doc(&format!("A simulation of [`{name}`]."));
    let inputs = values(
        declaration,
        &items::inputs_and_outputs(declaration).0,
        &outline.inputs,
        "inputs",
    );
    let outputs = values(
        declaration,
        &items::inputs_and_outputs(declaration).1,
        &outline.outputs,
        "outputs",
    );
    quote! {
        #about
        #[allow(dead_code)]
        #visibility type #alias = ::mbs_runtime::Simulation<#system, #sizes>;

        #inputs
        #outputs
    }
}

fn values(declaration: &Declaration, name: &Ident, list: &[Quantity], what: &str) -> TokenStream {
    let visibility = visibility(declaration);
    let mechanism = &declaration.name;
    let about = doc(&format!("The {what} of [`{mechanism}`]."));
    let fields = fields(declaration, list);
    let number = |place: usize| format_ident!("value_{place}");
    let declared = fields.iter().map(|field| {
        let (name, kind) = (&field.name, field.kind());
        let about = field.about(|_| String::new());
        quote! { #about pub #name: #kind, }
    });
    let made = fields.iter().map(|field| {
        let name = &field.name;
        let value = field.value(|place, _| {
            let number = number(place);
            quote! { #number }
        });
        quote! { #name: #value, }
    });
    let read = places(&fields);
    let numbers = (0..list.len()).map(number);
    let count = list.len();
    quote! {
        #about
        #[derive(Debug, Clone, Copy, PartialEq)]
        #[allow(dead_code, non_snake_case)]
        #visibility struct #name {
            #( #declared )*
        }

        impl ::mbs_runtime::NamedValues for #name {
            fn from_values(fill: impl ::core::ops::FnOnce(&mut [f64])) -> Self {
                let mut values = [0.0; #count];
                fill(&mut values);
                let [#( #numbers ),*] = values;
                Self { #( #made )* }
            }

            fn with_values<T>(&self, read: impl ::core::ops::FnOnce(&[f64]) -> T) -> T {
                read(&[#( #read, )*])
            }
        }
    }
}
