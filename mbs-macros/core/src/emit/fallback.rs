//! What is emitted beside the errors of a wrong declaration: the type and its parameters, so that the rest of the user's
//! program keeps resolving and the only errors shown are those of the declaration.

use super::fields::{array_of, filled};
use super::items::{self, visibility};
use crate::schema::PRIMITIVES;
use crate::syntax::{Declaration, Family};
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use std::collections::HashSet;

/// The parameters that could be read, and a mechanism without equations.
pub fn fallback(declaration: &Declaration) -> TokenStream {
    let visibility = visibility(declaration);
    let name = &declaration.name;
    // A type of this name would only bring errors about its own fields.
    if PRIMITIVES.contains(&name.to_string().as_str()) {
        return TokenStream::new();
    }
    let of_kind = |kind: &'static str| {
        let entries = declaration.entries.iter();
        let own = entries.filter(move |entry| entry.kind == kind);
        own.map(|entry| entry.name.word())
    };
    let parameters = zeros(declaration, name, of_kind("Param").chain(&declaration.lost));
    let (inputs, outputs) = items::inputs_and_outputs(declaration);
    let named = [(&inputs, "Input"), (&outputs, "Output")];
    let named = named.map(|(name, kind)| {
        let values = zeros(declaration, name, of_kind(kind));
        quote! {
            #[allow(dead_code)]
            #values

            impl ::mbs_runtime::NamedValues for #name {
                fn from_values(_: impl ::core::ops::FnOnce(&mut [f64])) -> Self {
                    Self::default()
                }

                fn with_values<T>(&self, read: impl ::core::ops::FnOnce(&[f64]) -> T) -> T {
                    read(&[])
                }
            }
        }
    });
    let unfinished = quote! { ::mbs_runtime::generated::Unfinished<#inputs, #outputs> };
    let alias = items::simulation(declaration);
    quote! {
        #parameters

        #[allow(dead_code)]
        #visibility type #alias = ::mbs_runtime::Simulation<#unfinished, 0, 0, 0>;

        #( #named )*

        impl ::mbs_runtime::Mechanism for #name {
            type System = #unfinished;
            const MODEL: &'static ::mbs_runtime::Model = ::mbs_runtime::generated::UNFINISHED;

            fn prepare(&self) -> ::core::result::Result<Self::System, ::mbs_runtime::ParameterError> {
                ::core::result::Result::Ok(::core::default::Default::default())
            }

            fn parameter(&self, _: &str) -> ::core::option::Option<f64> {
                ::core::option::Option::None
            }

            fn set_parameter(&mut self, _: &str, _: f64) -> ::core::result::Result<(), ::mbs_runtime::UnknownName> {
                ::core::result::Result::Ok(())
            }
        }
    }
}

/// A struct of numbers and arrays of them, all zero by default.
fn zeros<'d>(
    declaration: &'d Declaration,
    name: &Ident,
    fields: impl Iterator<Item = &'d Ident>,
) -> TokenStream {
    let visibility = visibility(declaration);
    let mut seen: HashSet<String> = HashSet::new();
    let fields: Vec<(&Ident, Vec<usize>)> = fields
        .filter(|field| seen.insert(field.to_string()))
        .map(|field| {
            let family = declaration.family(&field.to_string());
            (field, family.map_or_else(Vec::new, Family::sizes))
        })
        .collect();
    let declared = fields.iter().map(|(field, sizes)| {
        let kind = array_of(sizes, quote! { f64 });
        quote! { pub #field: #kind, }
    });
    let values = fields.iter().map(|(field, sizes)| {
        let value = filled(sizes, quote! { 0.0 });
        quote! { #field: #value, }
    });
    quote! {
        #[derive(Debug, Clone, Copy, PartialEq)]
        #visibility struct #name {
            #( #declared )*
        }

        impl ::core::default::Default for #name {
            fn default() -> Self {
                Self { #( #values )* }
            }
        }
    }
}
