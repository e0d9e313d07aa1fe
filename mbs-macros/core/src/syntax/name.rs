//! Names of entries.

use crate::names;
use proc_macro2::{Ident, Span};
use std::fmt;

/// The name of an entry: a word, and for a member of a family its indices: `crank[3]`, `rod[3][4]`.
#[derive(Debug, Clone)]
pub struct Name {
    word: Ident,
    text: String,
}

impl Name {
    /// The name of a member.
    pub(super) fn of_member(word: &Ident, indices: &[usize]) -> Name {
        let text = indices
            .iter()
            .fold(word.to_string(), |text, index| text + &format!("[{index}]"));
        Name {
            word: word.clone(),
            text,
        }
    }

    /// Without indices.
    pub fn word(&self) -> &Ident {
        &self.word
    }

    /// Where it is declared; all members of a family are at the name of the family.
    pub fn span(&self) -> Span {
        self.word.span()
    }

    /// With indices.
    pub fn as_str(&self) -> &str {
        &self.text
    }

    /// Whether it has indices.
    pub fn is_member(&self) -> bool {
        names::is_member(&self.text)
    }
}

impl From<Ident> for Name {
    fn from(word: Ident) -> Name {
        let text = word.to_string();
        Name { word, text }
    }
}

impl fmt::Display for Name {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter.write_str(&self.text)
    }
}

impl<T: AsRef<str> + ?Sized> PartialEq<T> for Name {
    fn eq(&self, other: &T) -> bool {
        self.text == other.as_ref()
    }
}
