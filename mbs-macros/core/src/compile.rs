//! The pipeline, one line per stage.

use crate::analysis::Analysis;
use crate::assemblies::{self, Gathered};
use crate::choose::Search;
use crate::diagnostics::{Errors, Failure};
use crate::home::Home;
use crate::syntax::{self, Declaration};
use crate::{budget, dag, derivatives, emit, equations, mobility, model};
use proc_macro2::TokenStream;

/// Compiles a declaration to Rust. If it has errors, its correct parts are emitted all the same (for completion in
/// editors), with one `compile_error!` per error.
pub fn compile(tokens: TokenStream) -> TokenStream {
    guarded(|| at_home(tokens, compile_checked))
}

/// Compiles an assembly: `assembly!`.
pub fn compile_assembly(tokens: TokenStream) -> TokenStream {
    guarded(|| at_home(tokens, assemblies::compile))
}

/// Runs a compiler whose code finds the runtime where the tokens say.
fn at_home(tokens: TokenStream, run: fn(TokenStream, &Home) -> TokenStream) -> TokenStream {
    let tokens = syntax::plain(tokens);
    match Home::of(&tokens) {
        Ok(home) => home.put(run(tokens, &home)),
        Err(error) => error.to_compile_error(),
    }
}

fn guarded(run: impl FnOnce() -> TokenStream) -> TokenStream {
    // A panic is always a defect of this compiler; it must not look like a mistake of the user.
    std::panic::catch_unwind(std::panic::AssertUnwindSafe(run)).unwrap_or_else(|_| {
        let message = "the compiler of `mechanism!` panicked: this is a defect; please report this declaration";
        quote::quote! { compile_error!(#message); }
    })
}

fn compile_checked(tokens: TokenStream, home: &Home) -> TokenStream {
    let tokens = match assemblies::gather(tokens, "mechanism") {
        Gathered::Asked(tokens) => return tokens,
        Gathered::All(tokens) => home.strip(tokens),
    };
    if emit::is_editor() {
        // First, so that the place of a token in it does not depend on what else is emitted.
        let mut items = emit::sketch(&tokens, model::kinds());
        items.extend(compile_gathered(tokens));
        return items;
    }
    compile_gathered(tokens)
}

fn compile_gathered(tokens: TokenStream) -> TokenStream {
    // An assembly that is wrong says so where it is declared.
    if syntax::is_broken(&tokens) {
        let declaration = syntax::parse(tokens, model::kinds(), &mut Errors::new());
        return declaration
            .as_ref()
            .map_or_else(TokenStream::new, emit::fallback);
    }
    match analyse(tokens) {
        (Some(declaration), Ok(analysis)) => {
            if let Err(failure) = check_families(&declaration, &analysis) {
                return refused(&declaration, &failure);
            }
            let (items, size) = emit::written(&declaration, &analysis, &analysis.program); // 6
            match budget::check(&declaration, &analysis, &size) {
                Ok(()) => items,
                Err(failure) => refused(&declaration, &failure),
            }
        }
        (Some(declaration), Err(failure)) => refused(&declaration, &failure),
        (None, Err(failure)) => failure.to_compile_errors(),
        (None, Ok(_)) => TokenStream::new(),
    }
}

/// Refuses families that are an array of the program, and have members of different types.
fn check_families(declaration: &Declaration, analysis: &Analysis) -> Result<(), Failure> {
    let mut errors = Errors::new();
    for (name, what) in emit::uneven_families(declaration, analysis) {
        errors.at(
            name.span(),
            format!("the members of `{name}` have different {what}, and an array has members of one type: give them the same, or declare them one by one"),
        );
    }
    errors.stop_if_any()
}

fn refused(declaration: &Declaration, failure: &Failure) -> TokenStream {
    let errors = failure.to_compile_errors_of(declaration.name.span());
    let fallback = emit::fallback(declaration);
    quote::quote! { #errors #fallback }
}

/// Stages 1 to 5.
pub fn analyse(tokens: TokenStream) -> (Option<Declaration>, Result<Analysis, Failure>) {
    let mut errors = Errors::new();
    let declaration = syntax::parse(tokens, model::kinds(), &mut errors); // 1
    if let Err(failure) = errors.stop_if_any() {
        return (declaration, Err(failure));
    }
    let Some(declaration) = declaration else {
        return (None, Err(Failure::unexplained()));
    };
    let outcome = analyse_cheapest(&declaration);
    (Some(declaration), outcome)
}

/// Stages 2 to 5 for each description of the search.
fn analyse_cheapest(declaration: &Declaration) -> Result<Analysis, Failure> {
    let mut search = Search::new(declaration);
    while let Some(description) = search.next() {
        let model = model::resolve(declaration, &description, search.errors()); // 2
        let Some(model) = search.admit(model) else {
            continue;
        };
        let (outline, mut system) = equations::derive(model); // 3
        if !search.reads(&system) || !search.moves(mobility::massless(&outline, &system)) {
            continue;
        }
        let mobility = mobility::analyse(&outline, &system);
        let Some(mobility) = search.settle(&outline, &system, mobility) else {
            continue;
        };
        if !search.holds(mobility::held(&outline, &mut system)) {
            continue;
        }
        let derived = derivatives::derive(system, mobility::dependent(mobility.as_ref())); // 4
        let program = dag::lower(&derived); // 5
        search.consider(Analysis {
            outline,
            derived,
            mobility,
            program,
            candidates: Vec::new(),
        });
    }
    search.finish()
}
