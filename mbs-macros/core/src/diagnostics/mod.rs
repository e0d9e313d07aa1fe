//! Errors are collected within a stage and stop the compiler between stages.

use proc_macro2::{Span, TokenStream, TokenTree};
use quote::ToTokens;

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
    list: Vec<syn::Error>,
}

impl Errors {
    /// No errors yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Records an error at `place`; the message says what to do.
    pub fn at(&mut self, place: impl Into<Place>, message: impl std::fmt::Display) {
        self.list.push(place.into().error(message));
    }

    /// Records an error made elsewhere.
    pub fn push(&mut self, error: syn::Error) {
        self.list.push(error);
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
            Ok(())
        } else {
            Err(Failure { errors: self.list })
        }
    }
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
}

/// "; did you mean `x`?" for the candidate nearest to `name`, or nothing if none is near.
pub fn did_you_mean<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> String {
    nearest(name, candidates).map_or_else(String::new, |candidate| {
        format!("; did you mean `{candidate}`?")
    })
}

/// The candidate that `name` may be a misspelling of.
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let length = name.chars().count();
    // The distance is no less than the difference of the lengths.
    let is_near = |candidate: &&str| candidate.chars().count().abs_diff(length) <= 1 + length / 3;
    let (distance, candidate) = candidates
        .into_iter()
        .filter(is_near)
        .map(|candidate| (distance(name, candidate), candidate))
        .min()?;
    // Names of one letter are not suggested for each other.
    (distance <= 1 + length / 3 && distance < length).then_some(candidate)
}

/// Levenshtein distance.
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, &y) in b.iter().enumerate() {
            let substitute = diagonal + usize::from(x.to_lowercase().ne(y.to_lowercase()));
            diagonal = row[j + 1];
            row[j + 1] = substitute.min(row[j] + 1).min(row[j + 1] + 1);
        }
    }
    row[b.len()]
}
