//! The prepared system: its fields, and the implementation of `System`.

use super::text::{doc, tokens};
use super::{metadata, methods, sparse};
use crate::dag::Program;
use crate::model::Outline;
use crate::symbolic::Graph;
use crate::syntax::Declaration;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// The name of the hidden type.
pub(super) fn name(declaration: &Declaration) -> Ident {
    format_ident!("{}System", declaration.name, span = declaration.name.span())
}

/// The struct and `impl System`.
pub(super) fn emit(
    declaration: &Declaration,
    outline: &Outline,
    graph: &Graph,
    program: &Program,
    metadata: &str,
) -> TokenStream {
    let (name, parameters) = (name(declaration), &declaration.name);
    let visibility = declaration
        .visibility
        .as_ref()
        .map_or_else(|| quote! { pub }, |visibility| quote! { #visibility });
    let (coordinates, size) = (program.coordinates, program.size);
    let (rows, inputs) = (program.rows.len(), outline.inputs.len());
    let rotations: Vec<usize> = program.rotations.iter().map(|r| r.velocity).collect();
    let count = rotations.len();
    let spins = (count > 0).then(|| quote! { spins: [::mbs_runtime::generated::Spin; #count], });
    let inverse = program
        .constant_mass
        .is_some()
        .then(|| quote! { inverse_mass: [[f64; #size]; #size], });
    let constants = program
        .constants
        .iter()
        .enumerate()
        .map(|(slot, constant)| {
            let (field, doc) = (format_ident!("k{slot}"), doc(&start(&constant.text)));
            quote! { #doc #field: f64, }
        });
    let laws = outline.laws.iter().enumerate().map(|(index, law)| {
        let (function, path, count) = (format_ident!("law_{index}"), &law.path, law.arguments);
        quote! {
            #[inline]
            fn #function(arguments: [f64; #count]) -> (f64, [f64; #count]) {
                #path(arguments)
            }
        }
    });
    let doc = doc(&format!(
        "The equations of [`{parameters}`] for one set of parameters."
    ));
    let full = methods::bodies(graph, program);
    let stubs = tokens(&methods::stubs(program));
    let structure = tokens(&metadata::structure(program));
    let (metadata, full) = (tokens(metadata), tokens(&full));
    let mass = mass_type(program);
    let (elimination, eliminating) = sparse::emit(program);
    let elimination = tokens(&elimination);
    let eliminating = (!eliminating.is_empty()).then(|| {
        let functions = tokens(&eliminating);
        quote! {
            #[allow(clippy::all, unused)]
            #[cfg(not(rust_analyzer))]
            impl #name {
                #functions
            }
        }
    });
    quote! {
        #doc
        #[doc(hidden)]
        #[derive(Debug, Clone)]
        #[allow(dead_code)]
        #visibility struct #name {
            parameters: #parameters,
            inputs: [f64; #inputs],
            #inverse
            #spins
            #( #constants )*
        }

        #[allow(clippy::all, dead_code)]
        impl #name {
            #( #laws )*
        }

        // An `allow` reaches the `cfg`s inside its item, not its own; the user's crate need not know this one.
        #[allow(unexpected_cfgs)]
        const _: () = {
            #[allow(clippy::all, unused_variables, unused_parens)]
            #[cfg(not(rust_analyzer))]
            impl ::mbs_runtime::System<#coordinates, #size, #rows> for #name {
                const MODEL: &'static ::mbs_runtime::Model = #metadata;
                const STRUCTURE: ::mbs_runtime::Structure = #structure;
                const ROTATIONS: &'static [usize] = &[#( #rotations ),*];
                #mass
                #elimination
                #full
            }

            #eliminating

            // Editors resolve names against these signatures and never see the long bodies.
            #[cfg(rust_analyzer)]
            impl ::mbs_runtime::System<#coordinates, #size, #rows> for #name {
                const MODEL: &'static ::mbs_runtime::Model = #metadata;
                const STRUCTURE: ::mbs_runtime::Structure = #structure;
                const ROTATIONS: &'static [usize] = &[#( #rotations ),*];
                #mass
                #stubs
            }
        };
    }
}

fn mass_type(program: &Program) -> TokenStream {
    let size = program.size;
    match (&program.constant_mass, program.factor_entries()) {
        (Some(_), _) => quote! { type Mass = (); },
        (None, Some((_, entries))) => quote! { type Mass = [f64; #entries]; },
        (None, None) => quote! { type Mass = ::mbs_runtime::generated::Cholesky<#size>; },
    }
}

/// As much of a formula as fits a comment of one line.
fn start(formula: &str) -> String {
    match formula.char_indices().nth(90) {
        Some((end, _)) => format!("{} …", &formula[..end]),
        None => formula.to_owned(),
    }
}
