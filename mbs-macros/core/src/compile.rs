//! The pipeline, one line per stage.

use crate::derivatives::{self, Derived};
use crate::diagnostics::{Errors, Failure};
use crate::mobility::{self, Mobility, Open};
use crate::model::{self, Model};
use crate::syntax::{self, Declaration, Entry};
use crate::{dag, emit, equations};
use proc_macro2::{Span, TokenStream};

/// Compiles a declaration to Rust. Where it is wrong, what could be understood is emitted all the same (so that editors
/// keep completing), with one `compile_error!` per mistake.
pub fn compile(tokens: TokenStream) -> TokenStream {
    // A panic is always a defect of this compiler; it must not look like a mistake of the user.
    std::panic::catch_unwind(|| compile_checked(tokens)).unwrap_or_else(|_| {
        let message = "the compiler of `mechanism!` panicked: this is a defect; please report this declaration";
        quote::quote! { compile_error!(#message); }
    })
}

fn compile_checked(tokens: TokenStream) -> TokenStream {
    let (declaration, outcome) = analyse(tokens);
    match (declaration, outcome) {
        (Some(declaration), Ok(analysis)) => {
            let graph = analysis.derived.system.graph.clone();
            let program = dag::lower(analysis.derived);
            emit::mechanism(
                &declaration,
                &analysis.model,
                analysis.mobility.as_ref(),
                &graph,
                &program,
            )
        }
        (Some(declaration), Err(failure)) => {
            let errors = failure.to_compile_errors();
            let fallback = emit::fallback(&declaration);
            quote::quote! { #errors #fallback }
        }
        (None, Err(failure)) => failure.to_compile_errors(),
        (None, Ok(_)) => TokenStream::new(),
    }
}

/// A declaration after stages 2 to 4.
#[derive(Debug)]
pub struct Analysis {
    /// Names, parts, reductions.
    pub model: Model,
    /// Everything that is computed.
    pub derived: Derived,
    /// Rank and redundant rows near the guess, where a pose could be assembled there.
    pub mobility: Option<Mobility>,
}

/// Stages 1 to 4.
pub fn analyse(tokens: TokenStream) -> (Option<Declaration>, Result<Analysis, Failure>) {
    let mut errors = Errors::new();
    let declaration = syntax::parse(tokens, &mut errors);
    if let Err(failure) = errors.stop_if_any() {
        return (declaration, Err(failure));
    }
    let Some(declaration) = declaration else {
        return (None, Err(Failure::unexplained()));
    };

    let mut errors = Errors::new();
    let model = model::resolve(&declaration, &mut errors);
    if let Err(failure) = errors.stop_if_any() {
        return (Some(declaration), Err(failure));
    }
    let Some(mut model) = model else {
        return (Some(declaration), Err(Failure::unexplained()));
    };

    let system = equations::derive(&mut model);
    let derived = derivatives::derive(system);
    let mut errors = Errors::new();
    let mobility = mobility::analyse(&model, &derived).unwrap_or_else(|open| {
        refuse_open(&declaration, &open, &mut errors);
        None
    });
    if let (true, Some(mobility)) = (declaration.deny_redundant, &mobility) {
        refuse_redundant(&declaration, mobility, &derived, &mut errors);
    }
    if let Err(failure) = errors.stop_if_any() {
        return (Some(declaration), Err(failure));
    }
    (
        Some(declaration),
        Ok(Analysis {
            model,
            derived,
            mobility,
        }),
    )
}

/// Where the entry of this name is; its part or the mechanism, if it has none.
fn place_of(declaration: &Declaration, name: &str) -> Span {
    let entry = declaration.entries.iter().find(|entry| entry.name == name);
    entry.map_or_else(|| declaration.name.span(), Entry::span)
}

fn refuse_open(declaration: &Declaration, open: &Open, errors: &mut Errors) {
    let gaps = open.gaps.join(", ");
    errors.at(
        place_of(declaration, &open.entry),
        format!("this loop cannot close: with the defaults of all parameters, where everything comes closest to fitting, these are still off: {gaps}; check lengths, places and axes"),
    );
}

fn refuse_redundant(
    declaration: &Declaration,
    mobility: &Mobility,
    derived: &Derived,
    errors: &mut Errors,
) {
    let redundancies = mobility::redundancies(mobility, &derived.system.rows);
    for (entry, sentence) in &redundancies {
        errors.at(
            place_of(declaration, entry),
            format!("{sentence}, which `deny: Redundant()` refuses; let this joint hold less"),
        );
    }
}
