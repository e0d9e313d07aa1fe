//! Generated text as tokens.

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
