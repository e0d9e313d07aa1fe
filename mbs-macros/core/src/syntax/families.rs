//! Families: one entry stands for many, `name: Each(0..5, |i| Kind(…))`. They become ordinary entries here; later stages
//! know their names only.

use super::bindings::{Bindings, Bound, names};
use super::name::Name;
use super::ranges::{Over, ranges};
use quote::quote;
use std::ops::Range;
use syn::spanned::Spanned;
use syn::{Error, Expr, ExprCall, ExprClosure, Ident, Pat, parse_quote_spanned};

/// The word of a family.
pub const EACH: &str = "Each";

/// The most members of a family.
pub const MOST_MEMBERS: usize = 10_000;

/// A family as declared.
#[derive(Debug, Clone)]
pub struct Family {
    /// Its name, without indices.
    pub name: Name,
    /// The range of each index.
    pub ranges: Vec<Range<usize>>,
}

impl Family {
    /// Whether these may be the indices of a member.
    pub fn contains(&self, indices: &[i64]) -> bool {
        let pairs = self.ranges.iter().zip(indices);
        let mut within =
            pairs.map(|(range, &index)| usize::try_from(index).is_ok_and(|i| range.contains(&i)));
        indices.len() == self.ranges.len() && within.all(|within| within)
    }

    /// The numbers of members along each index, for an array of all.
    pub fn sizes(&self) -> Vec<usize> {
        self.ranges.iter().map(|range| range.end).collect()
    }

    /// How a member is written.
    pub fn example(&self) -> String {
        let letters = ["i", "j", "k"].into_iter().chain(std::iter::repeat("n"));
        let indices = self.ranges.iter().zip(letters);
        indices.fold(self.name.to_string(), |text, (_, letter)| {
            text + &format!("[{letter}]")
        })
    }

    /// Its first and its last member.
    pub fn ends(&self) -> [String; 2] {
        let of = |end: fn(&Range<usize>) -> usize| {
            let indices = self.ranges.iter().map(end);
            indices.fold(self.name.to_string(), |text, index| {
                text + &format!("[{index}]")
            })
        };
        [
            of(|range| range.start),
            of(|range| range.end.saturating_sub(1)),
        ]
    }
}

/// A family that has been read, but not expanded.
pub(super) struct Written<'e> {
    pub(super) family: Family,
    over: Vec<Over<'e>>,
    parameters: Vec<&'e Pat>,
    body: &'e Expr,
}

/// Whether a call declares a family.
pub(super) fn is_family(call: &ExprCall) -> bool {
    matches!(&*call.func, Expr::Path(path) if path.path.is_ident(EACH))
}

/// `Param([x, y, z], …)` or `Param(value = [x, y, z], …)` as the family that it stands for: `Each([x, y, z], |value| Param(value, …))`.
pub(super) fn of_list(call: &ExprCall) -> Option<ExprCall> {
    let is_parameter = matches!(&*call.func, Expr::Path(path) if path.path.is_ident("Param"));
    let mut arguments = call.args.iter();
    let list = match arguments.next()? {
        Expr::Assign(first) if matches!(&*first.left, Expr::Path(name) if name.path.is_ident("value")) => {
            &first.right
        }
        first => first,
    };
    if !matches!(list, Expr::Array(_)) {
        return None;
    }
    let (kind, span) = (&call.func, call.func.span());
    let each = Ident::new(EACH, span);
    is_parameter.then(|| {
        parse_quote_spanned! { span => #each(#list, |value| #kind(value, #( #arguments ),*)) }
    })
}

impl<'e> Written<'e> {
    /// Reads `Each(ranges, |i| …)`.
    ///
    /// # Errors
    /// It is not of this form.
    pub(super) fn read(name: &Name, call: &'e ExprCall) -> syn::Result<Written<'e>> {
        let arguments: Vec<&Expr> = call.args.iter().collect();
        let [over, closure] = arguments.as_slice() else {
            return Err(Error::new_spanned(
                &call.func,
                format!(
                    "`{EACH}` takes a range and a closure: `{name}: {EACH}(0..5, |i| Kind(…))`"
                ),
            ));
        };
        let over = ranges(name, over)?;
        let ranges: Vec<Range<usize>> = over.iter().map(Over::range).collect();
        let sizes = ranges.iter().map(|range| Some(range.end - range.start));
        let members = sizes.reduce(|all, size| all?.checked_mul(size?)).flatten();
        if members.is_none_or(|members| members > MOST_MEMBERS) {
            let members = members.map_or("too many".to_owned(), |members| members.to_string());
            return Err(Error::new_spanned(
                arguments[0],
                format!(
                    "this family has {members} members, and {MOST_MEMBERS} are the most; declare fewer"
                ),
            ));
        }
        let closure = closure_of(name, closure)?;
        let parameters: Vec<&Pat> = closure.inputs.iter().collect();
        check_count(&over, closure)?;
        Ok(Written {
            family: Family {
                name: name.clone(),
                ranges,
            },
            over,
            parameters,
            body: &closure.body,
        })
    }

    /// Names that the closure gives to its parameters.
    pub(super) fn parameters(&self) -> Vec<&'e Ident> {
        let mut list = Vec::new();
        for pattern in &self.parameters {
            names(pattern, &mut list);
        }
        list
    }

    /// The members in order, the last index first: name and what it is. Those that an `if` leaves out have none.
    pub(super) fn members(&self) -> impl Iterator<Item = (Name, syn::Result<Option<Expr>>)> {
        let mut indices: Vec<usize> = self.family.ranges.iter().map(|range| range.start).collect();
        let mut is_over = false;
        std::iter::from_fn(move || {
            if is_over {
                return None;
            }
            let member = (
                Name::of_member(&self.family.name, &indices),
                self.member(&indices),
            );
            is_over = !self.advance(&mut indices);
            Some(member)
        })
    }

    /// To the next member; whether there is one.
    fn advance(&self, indices: &mut [usize]) -> bool {
        for (index, range) in indices.iter_mut().zip(&self.family.ranges).rev() {
            *index += 1;
            if *index < range.end {
                return true;
            }
            *index = range.start;
        }
        false
    }

    fn member(&self, indices: &[usize]) -> syn::Result<Option<Expr>> {
        let values = self
            .over
            .iter()
            .zip(indices)
            .map(|(over, &index)| match over {
                Over::Range(_) => Bound::Index(index),
                Over::List(items) => Bound::Item(items[index]),
            });
        let mut values: Vec<Bound> = values.collect();
        if self.parameters.len() > values.len() {
            values.insert(0, Bound::Index(indices[0]));
        }
        let pairs = self.parameters.iter().copied().zip(values);
        Bindings::new(pairs)?.body(self.body)
    }
}

fn closure_of<'e>(name: &Name, expr: &'e Expr) -> syn::Result<&'e ExprClosure> {
    let expected = || {
        format!(
            "expected a closure that says what each member is: `{name}: {EACH}(0..5, |i| Kind(…))`"
        )
    };
    let Expr::Closure(closure) = expr else {
        return Err(Error::new_spanned(expr, expected()));
    };
    let ExprClosure {
        lifetimes,
        constness,
        movability,
        asyncness,
        capture,
        output,
        ..
    } = closure;
    let written = quote! { #lifetimes #constness #movability #asyncness #capture #output };
    match written.is_empty() {
        true => Ok(closure),
        false => Err(Error::new_spanned(
            written,
            "the closure of a family has parameters and what each member is, as in `|i| Kind(…)`; leave this out",
        )),
    }
}

/// One parameter for each range; for a list alone also its index.
fn check_count(over: &[Over], closure: &ExprClosure) -> syn::Result<()> {
    let parameters = closure.inputs.len();
    let (fits, expected) = match over {
        [Over::List(_)] => (
            matches!(parameters, 1 | 2),
            "a list gives items, or indices and items: write `|x| …` or `|i, x| …`",
        ),
        [Over::Range(_)] => (
            parameters == 1,
            "a range gives one index: write `|i| …`; two ranges in parentheses give two",
        ),
        several => (
            parameters == several.len(),
            "each range gives an index: write as many as there are ranges, as in `|i, j| …`",
        ),
    };
    match fits {
        true => Ok(()),
        false => {
            let (first, last) = (&closure.or1_token, &closure.or2_token);
            let inputs = &closure.inputs;
            Err(Error::new_spanned(
                quote! { #first #inputs #last },
                expected,
            ))
        }
    }
}
