//! Stage 6: program → Rust.
//!
//! Two types: the declared one with the parameters as public fields, and the hidden system in which everything that
//! depends on parameters has been computed. One file for each emitted item; nothing outside this folder writes Rust.

mod body;
mod fallback;
mod metadata;
mod methods;
mod motion;
mod names;
mod parameters;
mod sparse;
mod system;

use crate::compile::Analysis;
use crate::dag::Program;
use crate::syntax::Declaration;
use proc_macro2::TokenStream;
use quote::quote;

pub use fallback::fallback;

/// All generated items.
pub fn mechanism(declaration: &Declaration, analysis: &Analysis, program: &Program) -> TokenStream {
    let (model, mobility) = (&analysis.model, analysis.mobility.as_ref());
    let graph = &analysis.derived.system.graph;
    let parameters = parameters::emit(declaration, model, mobility, program);
    let mechanism = parameters::emit_mechanism(declaration, model, graph, program);
    let metadata = metadata::emit(analysis, program);
    let system = system::emit(declaration, model, graph, program, &metadata);
    quote! {
        #parameters
        #mechanism
        #system
    }
}

/// Documentation as `///` would give it.
fn doc(text: &str) -> TokenStream {
    let lines = text.lines().map(|line| match line {
        "" => String::new(),
        line => format!(" {line}"),
    });
    quote! { #( #[doc = #lines] )* }
}

/// Generated text as tokens.
///
/// Bodies are written as text: they are long, regular, and cheaper to write so in an unoptimised compiler.
fn tokens(text: &str) -> TokenStream {
    match text.parse() {
        Ok(tokens) => tokens,
        Err(error) => {
            let message = format!(
                "the compiler wrote Rust that does not parse ({error}); please report this declaration"
            );
            quote! { compile_error!(#message) }
        }
    }
}
