//! The compiler behind `mechanism!`.

/// Compiles a declaration to Rust.
pub fn compile(_declaration: proc_macro2::TokenStream) -> proc_macro2::TokenStream {
    proc_macro2::TokenStream::new()
}
