//! The equations as LaTeX, derived again from the text of the declaration.

use crate::Model;

impl Model {
    /// The equations of motion as LaTeX (a fragment for the package amsmath): q, M, V, f, the rows and their Jacobian. With
    /// the feature `latex`, which adds the compiler of `mechanism!` to the program; the derivation takes as long as at
    /// compile time.
    ///
    /// # Errors
    /// The messages of a declaration that cannot be compiled from its text: one with assemblies, which it does not contain.
    pub fn latex(&self) -> Result<String, String> {
        mbs_macros_core::explain::latex(self.declaration).map_err(|messages| {
            format!(
                "the equations of `{}` cannot be derived from the text of its declaration, which has no assemblies: {messages}",
                self.name
            )
        })
    }
}
