//! Names of entries.

use crate::names;
use proc_macro2::{Ident, Span};
use std::fmt;

/// The name of an entry: a word, for a member of a family with its indices, and in an assembly after the assembly's name:
/// `crank`, `crank[3]`, `front.arm`.
#[derive(Debug, Clone)]
pub struct Name {
    word: Ident,
    text: String,
}

impl Name {
    /// The name of a member.
    pub(super) fn of_member(family: &Name, indices: &[usize]) -> Name {
        let indices = indices.iter();
        let text = indices.fold(family.text.clone(), |text, index| {
            text + &format!("[{index}]")
        });
        Name {
            word: family.word.clone(),
            text,
        }
    }

    /// The name of an entry of the assembly of this name.
    pub(super) fn within(&self, assembly: &Name) -> Name {
        Name {
            word: self.word.clone(),
            text: format!("{assembly}.{}", self.text),
        }
    }

    /// Without indices, and without the assembly.
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

    /// Without the last indices.
    pub fn base(&self) -> &str {
        names::base(&self.text)
    }

    /// The name of the assembly that it is in; empty for none.
    pub fn assembly(&self) -> &str {
        self.text
            .rsplit_once('.')
            .map_or("", |(assembly, _)| assembly)
    }

    /// Whether it is in an assembly.
    pub fn is_nested(&self) -> bool {
        self.text.contains('.')
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
