//! Generated text as tokens.

use crate::syntax::Declaration;
use proc_macro2::TokenStream;
use quote::quote;

/// Documentation as `///` would give it.
pub(super) fn doc(text: &str) -> TokenStream {
    let lines = text.lines().map(|line| match line {
        "" => String::new(),
        line => format!(" {line}"),
    });
    quote! { #( #[doc = #lines] )* }
}

/// Generated text as tokens.
///
/// Bodies are written as text: they are long, regular, and cheaper to write so in an unoptimised compiler.
pub(super) fn tokens(text: &str) -> TokenStream {
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

/// The visibility that was declared; `pub` where none was.
pub(super) fn visibility(declaration: &Declaration) -> TokenStream {
    let declared = declaration.visibility.as_ref();
    declared.map_or_else(|| quote! { pub }, |visibility| quote! { #visibility })
}
