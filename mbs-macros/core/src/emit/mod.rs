//! Stage 6: program → Rust.
//!
//! Two types: the declared one with the parameters as public fields, and the hidden system in which everything that
//! depends on parameters has been computed; inputs and outputs as fields, and a name for the simulation. One file for each emitted item; nothing outside this folder writes Rust.

mod abridged;
mod access;
mod arrays;
mod blocks;
mod body;
mod checks;
mod copies;
mod editor;
mod fallback;
mod fields;
mod items;
mod likely;
mod long_array;
mod member_loops;
mod metadata;
mod methods;
mod motion;
mod names;
mod parameters;
mod parts;
mod progressions;
mod row_layout;
mod size;
mod sparse;
mod states;
mod system;
mod tables;
mod text;
mod writes;

use crate::analysis::Analysis;
use crate::dag::Program;
use crate::model::Quantity;
use crate::syntax::{Declaration, Port};
use proc_macro2::TokenStream;
use quote::quote;

pub use arrays::uneven_families;
pub use editor::{is_editor, sketch};
pub use fallback::fallback;
pub use size::{Size, statements};

/// All generated items.
pub fn mechanism(declaration: &Declaration, analysis: &Analysis, program: &Program) -> TokenStream {
    written(declaration, analysis, program).0
}

/// The struct of an assembly's parameters.
pub fn assembly(declaration: &Declaration, ports: &[Port], parameters: &[Quantity]) -> TokenStream {
    parameters::of_assembly(declaration, ports, parameters)
}

/// All generated items, and how many statements they have.
pub fn written(
    declaration: &Declaration,
    analysis: &Analysis,
    program: &Program,
) -> (TokenStream, Size) {
    let mut size = Size::default();
    let graph = &analysis.derived.system.graph;
    let parameters = parameters::emit(declaration, analysis, program);
    let mechanism = parameters::emit_mechanism(declaration, analysis, program, &mut size);
    let metadata = metadata::emit(analysis, program);
    let model = (&analysis.outline, graph, program);
    let system = system::emit(
        declaration,
        model,
        &analysis.derived.system,
        &metadata,
        &mut size,
    );
    let access = access::emit(declaration, &analysis.outline, program);
    let items = quote! {
        #parameters
        #access
        #mechanism
        #system
    };
    (items, size)
}
