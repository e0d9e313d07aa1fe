//! The procedural macro `mechanism!`. Everything it does is in `mbs-macros-core`, an ordinary library.

use proc_macro::TokenStream;

/// Declares a mechanism; see the crate `mbs-runtime` for the language and what is generated.
#[proc_macro]
pub fn mechanism(declaration: TokenStream) -> TokenStream {
    mbs_macros_core::compile(declaration.into()).into()
}
