//! Stage 6: program → Rust.
//!
//! Two types: the declared one with the parameters as public fields, and the hidden system in which everything that
//! depends on parameters has been computed; inputs and outputs as fields, and a name for the simulation. One file for each emitted item; nothing outside this folder writes Rust.

mod access;
mod blocks;
mod body;
mod copies;
mod fallback;
mod items;
mod metadata;
mod methods;
mod motion;
mod names;
mod parameters;
mod parts;
mod sparse;
mod system;
mod text;
mod writes;

use crate::analysis::Analysis;
use crate::dag::Program;
use crate::syntax::Declaration;
use proc_macro2::TokenStream;
use quote::quote;

pub use fallback::fallback;

/// All generated items.
pub fn mechanism(declaration: &Declaration, analysis: &Analysis, program: &Program) -> TokenStream {
    let graph = &analysis.derived.system.graph;
    let parameters = parameters::emit(declaration, analysis, program);
    let mechanism = parameters::emit_mechanism(declaration, analysis, program);
    let metadata = metadata::emit(analysis, program);
    let system = system::emit(declaration, &analysis.outline, graph, program, &metadata);
    let access = access::emit(declaration, &analysis.outline, program);
    quote! {
        #parameters
        #access
        #mechanism
        #system
    }
}
