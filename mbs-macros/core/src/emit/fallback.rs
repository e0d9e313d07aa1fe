//! What is emitted beside the errors of a wrong declaration: the type and its parameters, so that the rest of the user's
//! program keeps resolving and the only errors shown are those of the declaration.

use crate::syntax::Declaration;
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// The parameters that could be read, and a mechanism without equations.
pub fn fallback(declaration: &Declaration) -> TokenStream {
    let visibility = declaration
        .visibility
        .as_ref()
        .map_or_else(|| quote! { pub }, |visibility| quote! { #visibility });
    let name = &declaration.name;
    let read = declaration
        .entries
        .iter()
        .filter(|entry| entry.kind == "Param")
        .map(|entry| &entry.name);
    let mut fields: Vec<&Ident> = Vec::new();
    for field in read.chain(&declaration.lost) {
        if !fields.contains(&field) {
            fields.push(field);
        }
    }
    quote! {
        #[derive(Debug, Clone, Copy, PartialEq, Default)]
        #visibility struct #name {
            #( pub #fields: f64, )*
        }

        impl ::mbs_runtime::Mechanism for #name {
            type System = ::mbs_runtime::generated::Unfinished;
            const MODEL: &'static ::mbs_runtime::Model = ::mbs_runtime::generated::UNFINISHED;

            fn prepare(&self) -> ::core::result::Result<Self::System, ::mbs_runtime::ParameterError> {
                ::core::result::Result::Ok(::mbs_runtime::generated::Unfinished)
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
