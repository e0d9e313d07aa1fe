//! The prepared system: its fields, and the implementation of `System`.

use super::items::{self, visibility};
use super::parts::LongFunctions;
use super::size::Size;
use super::text::{doc, tokens};
use super::{metadata, methods, sparse, states, tables};
use crate::contract::Capability;
use crate::dag::Program;
use crate::equations::System;
use crate::model::Outline;
use crate::symbolic::Graph;
use crate::syntax::Declaration;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// The struct and `impl System`.
pub(super) fn emit(
    declaration: &Declaration,
    (outline, graph, program): (&Outline, &Graph, &Program),
    equations: &System,
    metadata: &str,
    written: &mut Size,
) -> TokenStream {
    let (name, parameters) = (items::system(declaration), &declaration.name);
    let visibility = visibility(declaration);
    let size = program.size;
    let inputs = outline.inputs.len();
    let rotations: Vec<usize> = program.rotations.iter().map(|r| r.velocity).collect();
    let count = rotations.len();
    let spins = (count > 0).then(|| quote! { spins: [::mbs_runtime::generated::Spin; #count], });
    let inverse = program.constant_mass.is_some().then(|| {
        let matrix = quote! { ::mbs_runtime::nalgebra::SMatrix<f64, #size, #size> };
        match items::boxes_inverse(size) {
            _ if items::factors_mass(program) => {
                quote! { inverse_mass: ::mbs_runtime::generated::FactoredMass<#size>, }
            }
            true => quote! { inverse_mass: ::mbs_runtime::generated::Box<#matrix>, },
            false => quote! { inverse_mass: #matrix, },
        }
    });
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
                // Another signature is an error at the path.
                let law: fn([f64; #count]) -> (f64, [f64; #count]) = #path;
                law(arguments)
            }
        }
    });
    let tables = tables::constants(&outline.tables);
    let measured = tables::fields(&outline.tables);
    let scaled = states::field(equations);
    let doc = doc(&format!(
        "The equations of [`{parameters}`] for one set of parameters."
    ));
    let structure = metadata::structure(program);
    let (elimination, eliminating) = sparse::emit(program);
    let rotations = format!("const ROTATIONS: &'static [usize] = &{rotations:?};\n");
    let (inputs_type, outputs_type) = items::inputs_and_outputs(declaration);
    let associated = [
        (Capability::Configuration, rotations),
        (Capability::Inertia, mass_type(program)),
        (Capability::Loads, format!("type Inputs = {inputs_type};\n")),
        (
            Capability::Observables,
            format!(
                "type Outputs = {outputs_type};\n{}{}",
                metadata::held(&equations.held),
                states::constant(outline, equations) + metadata::acceleration_level(program)
            ),
        ),
        (
            Capability::System,
            format!(
                "const MODEL: &'static ::mbs_runtime::Model = __MBS_MODEL;\nconst STRUCTURE: ::mbs_runtime::Structure = {structure};\n{}",
                metadata::partitioned(program)
            ),
        ),
    ];
    let implementations = |functions: &dyn Fn(Capability) -> String| {
        let blocks = Capability::ALL.into_iter().map(|capability| {
            let own = associated.iter().find(|(of, _)| *of == capability);
            let own = own.map_or("", |(_, text)| text);
            format!(
                "#[allow(clippy::all, clippy::pedantic, clippy::nursery, unused_variables, unused_parens)]\nimpl ::mbs_runtime::{} for {name} {{\n{own}{}}}\n",
                capability.name(program),
                functions(capability)
            )
        });
        tokens(&blocks.collect::<String>())
    };
    let long = LongFunctions::new(program);
    let bodies = Capability::ALL
        .map(|capability| methods::bodies(graph, program, &long, capability, written));
    let full = implementations(&|capability| {
        let mut all = Capability::ALL.iter().zip(&bodies);
        let own = all.find(|(of, _)| **of == capability);
        let own = own.map_or("", |(_, text)| text);
        match capability {
            Capability::Constraints => elimination.clone() + own,
            _ => own.to_owned(),
        }
    });
    let stubs = implementations(&|capability| methods::stubs(program, capability));
    written.add("elimination", &eliminating);
    let eliminating = eliminating + &long.items(graph, written);
    let eliminating = (!eliminating.is_empty()).then(|| {
        let functions = tokens(&eliminating);
        quote! {
            #[allow(clippy::all, clippy::pedantic, clippy::nursery, unused)]
            impl #name {
                #functions
            }
        }
    });
    let model = tokens(metadata);
    quote! {
        #doc
        #[doc(hidden)]
        #[derive(Debug, Clone)]
        #[allow(clippy::all, clippy::pedantic, clippy::nursery, dead_code)]
        #visibility struct #name {
            parameters: #parameters,
            inputs: [f64; #inputs],
            #inverse
            #spins
            #scaled
            #( #measured )*
            #( #constants )*
        }

        #[allow(clippy::all, clippy::pedantic, clippy::nursery, dead_code)]
        impl #name {
            #( #laws )*
            #( #tables )*
        }

        // An `allow` reaches the `cfg`s inside its item, not its own; the user's crate need not know this one.
        #[allow(unexpected_cfgs)]
        const _: () = {
            #[allow(unused_imports)]
            use ::core::iter::{IntoIterator as _, Iterator as _};
            #[allow(unused_imports)]
            use ::mbs_runtime::generated::{Elementary as _, entries, entries_mut, rows, rows_mut};
            #[allow(unused_imports)]
            use ::mbs_runtime::nalgebra::{SMatrix, SVector};

            #[allow(clippy::all, clippy::pedantic, clippy::nursery)]
            const __MBS_MODEL: &'static ::mbs_runtime::Model = #model;

            #[cfg(not(rust_analyzer))]
            const _: () = {
                #full
                #eliminating
            };

            // Editors resolve names against these signatures and never see the long bodies.
            #[cfg(rust_analyzer)]
            const _: () = {
                #stubs
            };
        };
    }
}

fn mass_type(program: &Program) -> String {
    match (&program.constant_mass, program.factor_entries()) {
        (Some(_), _) => "type Mass = ();\n".to_owned(),
        (None, Some((_, entries))) => format!("type Mass = [f64; {entries}];\n"),
        (None, None) => format!(
            "type Mass = ::mbs_runtime::generated::Cholesky<{}>;\n",
            program.size
        ),
    }
}

/// As much of a formula as fits a comment of one line.
fn start(formula: &str) -> String {
    match formula.char_indices().nth(90) {
        Some((end, _)) => format!("{} …", &formula[..end]),
        None => formula.to_owned(),
    }
}
