//! Over what a family goes: ranges of indices, and lists of data.

use super::children::inner;
use super::name::Name;
use super::whole::whole;
use std::ops::Range;
use syn::{Error, Expr, RangeLimits};

/// What one index of a family goes over.
pub(super) enum Over<'e> {
    Range(Range<usize>),
    /// Items, with the indices 0, 1, 2, …
    List(Vec<&'e Expr>),
}

impl Over<'_> {
    /// The indices.
    pub(super) fn range(&self) -> Range<usize> {
        match self {
            Over::Range(range) => range.clone(),
            Over::List(items) => 0..items.len(),
        }
    }
}

/// `a..b`, `a..=b`, `[x, y, z]`, or several of them in parentheses.
///
/// # Errors
/// It is none of these, or empty.
pub(super) fn ranges<'e>(family: &Name, expr: &'e Expr) -> syn::Result<Vec<Over<'e>>> {
    match inner(expr) {
        Expr::Tuple(tuple) if !tuple.elems.is_empty() => {
            let ranges = tuple.elems.iter().map(|expr| over(family, expr));
            ranges.collect()
        }
        _ => Ok(vec![over(family, expr)?]),
    }
}

fn over<'e>(family: &Name, expr: &'e Expr) -> syn::Result<Over<'e>> {
    match inner(expr) {
        Expr::Range(range) => {
            let (Some(start), Some(end)) = (&range.start, &range.end) else {
                return Err(Error::new_spanned(
                    expr,
                    "a family has both ends of its range, as in `0..5` or `1..=5`",
                ));
            };
            let first = index(start)?;
            let last = match range.limits {
                RangeLimits::HalfOpen(_) => index(end)?,
                RangeLimits::Closed(_) => index(end)?.saturating_add(1),
            };
            match first < last {
                true => Ok(Over::Range(first..last)),
                false => Err(Error::new_spanned(
                    expr,
                    format!("this range is empty: `{family}` would have no members"),
                )),
            }
        }
        Expr::Array(array) if array.elems.is_empty() => Err(Error::new_spanned(
            expr,
            format!("this list is empty: `{family}` would have no members"),
        )),
        Expr::Array(array) => Ok(Over::List(array.elems.iter().collect())),
        _ => Err(Error::new_spanned(
            expr,
            "expected a range such as `0..5` or `1..=5`, a list `[x, y, z]`, or several of them: `(0..5, 0..3)`",
        )),
    }
}

/// An end of a range.
fn index(end: &Expr) -> syn::Result<usize> {
    let number = whole(end)?;
    usize::try_from(number).map_err(|_| {
        Error::new_spanned(
            end,
            "the indices of a family are not negative: begin its range at 0 or above",
        )
    })
}
