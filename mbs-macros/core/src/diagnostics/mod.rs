//! Errors are collected within a stage and stop the compiler between stages.

mod spelling;

use crate::names::is_one_of_many;
use proc_macro2::{Span, TokenStream, TokenTree};
use quote::ToTokens;

pub use spelling::{did_you_mean, did_you_mean_kind, meant, nearest};

/// Where a mistake is: from the start of one token to the end of another. (On stable compilers spans cannot be joined,
/// so that both ends have to be carried along to point at a whole expression.)
#[derive(Debug, Clone, Copy)]
pub struct Place {
    first: Span,
    last: Span,
}

impl Place {
    /// All of some tokens.
    pub fn of(tokens: &impl ToTokens) -> Self {
        let mut spans = tokens
            .to_token_stream()
            .into_iter()
            .map(|token| token.span());
        let first = spans.next().unwrap_or_else(Span::call_site);
        Place {
            first,
            last: spans.last().unwrap_or(first),
        }
    }

    fn error(self, message: impl std::fmt::Display) -> syn::Error {
        let ends = [self.first, self.last].map(|span| {
            let mut token =
                TokenTree::Punct(proc_macro2::Punct::new('.', proc_macro2::Spacing::Alone));
            token.set_span(span);
            token
        });
        syn::Error::new_spanned(TokenStream::from_iter(ends), message)
    }
}

impl From<Span> for Place {
    fn from(span: Span) -> Self {
        Place {
            first: span,
            last: span,
        }
    }
}

/// The errors of one stage.
#[derive(Debug, Default)]
#[must_use = "call `stop_if_any` at the end of the stage"]
pub struct Errors {
    list: Vec<Recorded>,
    /// The member of a family that is being read.
    member: Option<String>,
    /// Whether they are all about parts that move without mass.
    of_mass: bool,
}

/// An error, and the members of a family that have it.
#[derive(Debug)]
struct Recorded {
    error: syn::Error,
    /// The first member, if it is one of a family.
    member: Option<String>,
    /// The last member.
    last: Option<String>,
    /// How many have it beside the first.
    others: usize,
    /// What it has in common with the same error of other members.
    likeness: String,
}

impl Errors {
    /// No errors yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Records an error at `place`; the message says what to do.
    pub fn at(&mut self, place: impl Into<Place>, message: impl std::fmt::Display) {
        self.push(place.into().error(message));
    }

    /// The same about an entry, which may be a member of a family.
    pub fn about(&mut self, entry: &str, place: impl Into<Place>, message: impl std::fmt::Display) {
        let before = self.enter(entry);
        self.at(place, message);
        self.leave(before);
    }

    /// Records an error made elsewhere. The same error in several members of a family is one error.
    pub fn push(&mut self, error: syn::Error) {
        let member = self.member.clone();
        let likeness = likeness(&error);
        if member.is_some() {
            let mut known = self.list.iter_mut();
            let known = known.find(|known| known.member.is_some() && known.likeness == likeness);
            if let Some(known) = known {
                known.others += usize::from(known.last != member);
                known.last = member;
                return;
            }
        }
        self.list.push(Recorded {
            error,
            last: member.clone(),
            member,
            others: 0,
            likeness,
        });
    }

    /// What follows is about this entry; returns what it was about before.
    pub fn enter(&mut self, entry: &str) -> Option<String> {
        let member = is_one_of_many(entry).then(|| entry.to_owned());
        std::mem::replace(&mut self.member, member)
    }

    /// The entry that `enter` was called for has been read.
    pub fn leave(&mut self, before: Option<String>) {
        self.member = before;
    }

    /// All of them are about parts that move without mass in this description.
    pub fn are_of_mass(&mut self) {
        self.of_mass = true;
    }

    /// Whether all of them are: another description may move them with others.
    pub fn is_of_mass(&self) -> bool {
        self.of_mass && !self.list.is_empty()
    }

    /// Whether one of them is at these tokens.
    pub fn are_at(&self, place: Place) -> bool {
        let text = |error: &syn::Error| format!("{:?}", error.span());
        let place = text(&place.error(""));
        self.list.iter().any(|known| text(&known.error) == place)
    }

    /// The number of errors so far.
    pub fn count(&self) -> usize {
        self.list.len()
    }

    /// Whether nothing went wrong so far.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Ends the stage.
    ///
    /// # Errors
    /// All errors of the stage, if there are any.
    pub fn stop_if_any(self) -> Result<(), Failure> {
        if self.list.is_empty() {
            return Ok(());
        }
        let errors = self.list.into_iter().map(Recorded::into_error);
        Err(Failure {
            errors: errors.collect(),
        })
    }
}

impl Recorded {
    /// With the member and the number of others in the message.
    fn into_error(self) -> syn::Error {
        let Some(member) = self.member else {
            return self.error;
        };
        let message = self.error.to_string();
        let about = match message.contains(&format!("`{member}`")) {
            true => String::new(),
            false => format!("in `{member}`: "),
        };
        let others = match self.others {
            0 => String::new(),
            1 => " (and the same in another member)".to_owned(),
            others => format!(" (and the same in {others} other members)"),
        };
        Place::of(&self.error.to_compile_error()).error(format!("{about}{message}{others}"))
    }
}

/// Members have the same error if it is at the same tokens and reads the same but for numbers.
fn likeness(error: &syn::Error) -> String {
    let message = error.to_string();
    let words = message
        .chars()
        .filter(|c| !c.is_ascii_digit() && *c != '-' && *c != '.');
    format!("{:?} {}", error.span(), words.collect::<String>())
}

/// The errors that stopped the compiler.
#[derive(Debug)]
pub struct Failure {
    errors: Vec<syn::Error>,
}

impl Failure {
    /// A stage that stopped without an error: a defect of the compiler, which the message states.
    pub fn unexplained() -> Self {
        let message = "the compiler stopped without saying why; please report this declaration";
        Failure {
            errors: vec![syn::Error::new(Span::call_site(), message)],
        }
    }

    /// The messages with their positions (line, column of the first character, column after the last one).
    pub fn messages(&self) -> Vec<(String, std::ops::Range<proc_macro2::LineColumn>)> {
        self.errors
            .iter()
            .map(|error| (error.to_string(), error.span().start()..error.span().end()))
            .collect()
    }

    /// The errors as `compile_error!` invocations, each at its token.
    pub fn to_compile_errors(&self) -> TokenStream {
        self.errors
            .iter()
            .map(syn::Error::to_compile_error)
            .collect()
    }

    /// The same for a declaration whose name is at `home`. rustc shows tokens of another crate where they are used, so
    /// that the message of an error in another file says where it is.
    pub fn to_compile_errors_of(&self, home: Span) -> TokenStream {
        let errors = self.errors.iter().map(|error| {
            let span = error.span();
            if span.file() == home.file() {
                return error.to_compile_error();
            }
            let (line, column) = (span.start().line, span.start().column + 1);
            let message = format!("{error} ({}:{line}:{column})", span.file());
            let place = Place::of(&error.to_compile_error());
            place.error(message).to_compile_error()
        });
        errors.collect()
    }
}
