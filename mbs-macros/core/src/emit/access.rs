//! Typed access: the simulation of a mechanism by one name, and its inputs and outputs as fields.

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
    let inputs = fields(
        declaration,
        &items::inputs_and_outputs(declaration).0,
        &outline.inputs,
        "inputs",
    );
    let outputs = fields(
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

/// A field of one number, or of the components of a vector.
struct Field {
    name: Ident,
    about: TokenStream,
    /// Names for its numbers, in order.
    numbers: Vec<Ident>,
    is_vector: bool,
}

fn fields(declaration: &Declaration, name: &Ident, list: &[Quantity], what: &str) -> TokenStream {
    let visibility = visibility(declaration);
    let mechanism = &declaration.name;
    let about = doc(&format!("The {what} of [`{mechanism}`]."));
    let mut fields: Vec<Field> = Vec::new();
    for (index, quantity) in list.iter().enumerate() {
        let (entry, component) = match quantity.name.split_once('.') {
            Some((entry, _)) => (entry, true),
            None => (quantity.name.as_str(), false),
        };
        let number = format_ident!("value_{index}");
        match fields.last_mut() {
            Some(last) if component && last.is_vector && last.name == entry => {
                last.numbers.push(number);
            }
            _ => fields.push(Field {
                name: items::field(declaration, entry),
                about: doc(&items::documented(&quantity.doc, &quantity.unit)),
                numbers: vec![number],
                is_vector: component,
            }),
        }
    }
    let declared = fields.iter().map(
        |Field {
             name,
             about,
             numbers,
             is_vector,
         }| {
            let count = numbers.len();
            let kind = match is_vector {
                true => quote! { ::mbs_runtime::nalgebra::SVector<f64, #count> },
                false => quote! { f64 },
            };
            quote! { #about pub #name: #kind, }
        },
    );
    let made = fields.iter().map(
        |Field {
             name,
             numbers,
             is_vector,
             ..
         }| match is_vector {
            true => quote! { #name: ::mbs_runtime::nalgebra::SVector::from([#(#numbers),*]), },
            false => quote! { #name: #(#numbers)*, },
        },
    );
    let read = fields.iter().flat_map(
        |Field {
             name,
             numbers,
             is_vector,
             ..
         }| {
            let numbers = numbers.iter().enumerate();
            numbers.map(move |(i, _)| match is_vector {
                true => quote! { self.#name[#i], },
                false => quote! { self.#name, },
            })
        },
    );
    let numbers = fields.iter().flat_map(|field| &field.numbers);
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
                read(&[#( #read )*])
            }
        }
    }
}
