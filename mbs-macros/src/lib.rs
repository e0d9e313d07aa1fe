//! The procedural macro `mechanism!`. Everything it does is in `mbs-macros-core`, an ordinary library.

use proc_macro::TokenStream;

/// Declares a mechanism: generates a struct of its parameters that implements `mbs_runtime::Mechanism`, and behind it the
/// equations, derived symbolically.
///
#[doc = include_str!("../LANGUAGE.md")]
#[proc_macro]
pub fn mechanism(declaration: TokenStream) -> TokenStream {
    mbs_macros_core::compile(declaration.into()).into()
}

/// Declares an assembly: parts, joints and forces that mechanisms have as often as they want by
/// `name: Assembly(Name, port = …)`. Generates a struct of its parameters, and a macro of the same name by which it
/// reaches them.
#[proc_macro]
pub fn assembly(declaration: TokenStream) -> TokenStream {
    mbs_macros_core::compile_assembly(declaration.into()).into()
}
