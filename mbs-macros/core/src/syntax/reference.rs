//! What an expression names: the one place that reads a name out of an expression.

use super::children::inner;
use super::whole::whole;
use proc_macro2::Ident;
use syn::Expr;

/// The name of an entry, or of a member of a family: `crank`, `crank[3]`, `rod[3][4]`.
#[derive(Debug)]
pub struct Reference<'e> {
    /// Without indices.
    pub word: &'e Ident,
    /// The indices, in order. They need not be those of a member.
    pub indices: Vec<i64>,
}

impl Reference<'_> {
    /// As `Name` writes it.
    pub fn text(&self) -> String {
        let word = self.word.to_string();
        let indices = self.indices.iter();
        indices.fold(word, |text, index| text + &format!("[{index}]"))
    }
}

/// The name that an expression is; `None` if it is none.
///
/// # Errors
/// An index is no whole number.
pub fn reference(expr: &Expr) -> Option<syn::Result<Reference<'_>>> {
    match inner(expr) {
        Expr::Path(path) => path.path.get_ident().map(|word| {
            Ok(Reference {
                word,
                indices: Vec::new(),
            })
        }),
        Expr::Index(index) => {
            let of = reference(&index.expr)?;
            Some(of.and_then(|mut of| {
                of.indices.push(whole(&index.index)?);
                Ok(of)
            }))
        }
        _ => None,
    }
}
