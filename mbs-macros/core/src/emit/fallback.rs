//! What is emitted beside the errors of a wrong declaration: the type and its parameters, so that the rest of the user's
//! program keeps resolving and the only errors shown are those of the declaration.

use super::items::{self, visibility};
use crate::schema::PRIMITIVES;
use crate::syntax::Declaration;
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// The parameters that could be read, and a mechanism without equations.
pub fn fallback(declaration: &Declaration) -> TokenStream {
    let visibility = visibility(declaration);
    let name = &declaration.name;
    // A type of this name would only bring errors about its own fields.
    if PRIMITIVES.contains(&name.to_string().as_str()) {
        return TokenStream::new();
    }
    let of_kind = |kind: &'static str| -> Vec<&Ident> {
        let entries = declaration.entries.iter();
        let own = entries.filter(|entry| entry.kind == kind);
        own.map(|entry| &entry.name).collect()
    };
    let mut fields: Vec<&Ident> = Vec::new();
    for field in of_kind("Param").into_iter().chain(&declaration.lost) {
        if !fields.contains(&field) {
            fields.push(field);
        }
    }
    let (inputs, outputs) = items::inputs_and_outputs(declaration);
    let named = [(&inputs, of_kind("Input")), (&outputs, of_kind("Output"))];
    let named = named.map(|(name, fields)| {
        quote! {
            #[derive(Debug, Clone, Copy, PartialEq, Default)]
            #[allow(dead_code)]
            #visibility struct #name {
                #( pub #fields: f64, )*
            }

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
        #[derive(Debug, Clone, Copy, PartialEq, Default)]
        #visibility struct #name {
            #( pub #fields: f64, )*
        }

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
