//! The pipeline, one line per stage.

use crate::choose::{Candidate, choose};
use crate::dag::{self, Program};
use crate::derivatives::Derived;
use crate::diagnostics::{Errors, Failure};
use crate::emit;
use crate::mobility::Mobility;
use crate::model::{self, Model};
use crate::syntax::{self, Declaration};
use proc_macro2::TokenStream;

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
        (Some(declaration), Ok(mut analysis)) => {
            let counted = analysis.program.take();
            let program = counted.unwrap_or_else(|| dag::lower(&analysis.derived));
            emit::mechanism(&declaration, &analysis, &program)
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
    /// The descriptions that were considered; empty where one was asked for.
    pub candidates: Vec<Candidate>,
    /// Its program, where the choice has made it to count its operations.
    pub program: Option<Program>,
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
    let requested = model::requested(&declaration, &mut errors);
    let analysis = choose(&declaration, requested, &mut errors);
    if let Err(failure) = errors.stop_if_any() {
        return (Some(declaration), Err(failure));
    }
    let outcome = analysis.ok_or_else(Failure::unexplained);
    (Some(declaration), outcome)
}
