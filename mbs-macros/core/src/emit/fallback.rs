//! What is emitted beside the errors of a wrong declaration: the type and its parameters, so that the rest of the user's
//! program keeps resolving and the only errors shown are those of the declaration.

use super::fields::{array_of, filled};
use super::items::{self, visibility};
use super::likely;
use crate::schema::PRIMITIVES;
use crate::syntax::{Declaration, Entry, Family, Instance};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use std::collections::HashSet;

/// The parameters that could be read, and a mechanism without equations.
pub fn fallback(declaration: &Declaration) -> TokenStream {
    let visibility = visibility(declaration);
    let name = &declaration.name;
    // A type of this name would only bring errors about its own fields.
    if PRIMITIVES.contains(&name.to_string().as_str()) {
        return TokenStream::new();
    }
    let parameters = zeros(declaration, name, "Param", "");
    let (inputs, outputs) = items::inputs_and_outputs(declaration);
    let named = [(&inputs, "Input"), (&outputs, "Output")];
    let named = named.map(|(name, kind)| {
        let values = zeros(declaration, name, kind, "");
        quote! {
            #values

            impl ::mbs_runtime::NamedValues for #name {
                fn from_values(_: impl ::core::ops::FnOnce(&mut [f64])) -> Self {
                    ::core::default::Default::default()
                }

                fn with_values<T>(&self, read: impl ::core::ops::FnOnce(&[f64]) -> T) -> T {
                    read(&[])
                }
            }
        }
    });
    let unfinished = quote! { ::mbs_runtime::generated::Unfinished<#inputs, #outputs> };
    let size = quote! { { ::mbs_runtime::generated::UNFINISHED_SIZE } };
    let alias = items::simulation(declaration);
    let fixed_steps = items::fixed_step_simulation(declaration);
    quote! {
        #parameters

        #[allow(dead_code)]
        #visibility type #alias = ::mbs_runtime::Simulation<#unfinished, #size, #size, 0>;

        #[allow(dead_code)]
        #visibility type #fixed_steps = ::mbs_runtime::FixedStepSimulation<#unfinished, #size, #size, 0>;

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

/// A struct of the values of this kind in an assembly, or outside all of them: numbers, zero by default, and arrays.
fn zeros(declaration: &Declaration, name: &Ident, kind: &str, assembly: &str) -> TokenStream {
    let visibility = visibility(declaration);
    let own = declaration.entries.iter();
    let own = own.filter(|entry| gives(entry, kind) && entry.name.assembly() == assembly);
    let lost = declaration.lost.iter();
    let lost = lost.filter(|_| kind == "Param" && assembly.is_empty());
    let own = own.map(|entry| (entry.name.word(), type_of(declaration, entry)));
    let lost = lost.map(|word| (word, quote! { f64 }));
    let mut fields: Vec<(&Ident, TokenStream)> = own.chain(lost).collect();
    let mut inner = Vec::new();
    for instance in inside(declaration, kind, assembly) {
        let path = &instance.path;
        let of = match kind {
            "Param" => quote! { #path },
            _ => {
                let of = format_ident!("{name}Of{}", instance.definition.name, span = name.span());
                inner.push(zeros(declaration, &of, kind, instance.name.as_str()));
                quote! { #of }
            }
        };
        fields.push((instance.name.word(), of));
    }
    let mut seen: HashSet<String> = HashSet::new();
    fields.retain(|(field, _)| seen.insert(field.to_string()));
    inner.sort_by_key(TokenStream::to_string);
    inner.dedup_by_key(|item| item.to_string());
    let (declared, values): (Vec<TokenStream>, Vec<TokenStream>) = fields
        .iter()
        .map(|(field, kind)| {
            let family = match assembly {
                "" => declaration.family(&field.to_string()),
                outer => declaration.family(&format!("{outer}.{field}")),
            };
            let sizes = family.map_or_else(Vec::new, Family::sizes);
            let zero = filled(
                &sizes,
                quote! { <#kind as ::core::default::Default>::default() },
            );
            let kind = array_of(&sizes, kind.clone());
            (quote! { pub #field: #kind, }, quote! { #field: #zero, })
        })
        .unzip();
    quote! {
        #( #inner )*

        #[allow(dead_code, non_snake_case)]
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

/// The type of a value outside a family.
fn type_of(declaration: &Declaration, entry: &Entry) -> TokenStream {
    let is_output = entry.kind == "Output";
    match is_output.then(|| likely::components(declaration, entry)) {
        Some(Some(size)) => quote! { ::mbs_runtime::nalgebra::SVector<f64, #size> },
        _ => quote! { f64 },
    }
}

/// The assemblies in this one, or outside all, that have a value of this kind.
fn inside<'d>(
    declaration: &'d Declaration,
    kind: &str,
    assembly: &str,
) -> impl Iterator<Item = &'d Instance> {
    let instances = declaration.instances.iter();
    instances.filter(move |instance| {
        let within = format!("{}.", instance.name);
        let mut entries = declaration.entries.iter();
        instance.name.assembly() == assembly
            && entries.any(|entry| gives(entry, kind) && entry.name.as_str().starts_with(&within))
    })
}

/// Whether an entry is a value of this kind: a state is an output, too.
fn gives(entry: &Entry, kind: &str) -> bool {
    entry.kind == kind || kind == "Output" && entry.kind == "State"
}
