//! The arguments of an entry, read according to the schema.

mod attachments;
mod checks;
mod columns;
mod numbers;
mod orientation;
mod places;
mod requirements;

use super::resolver::Resolver;
use super::value::Value;
use crate::diagnostics::Place;
use crate::dimension::Dimension;
use crate::schema::{self, Expects, Kind, World};
use crate::symbolic::{Expr, Graph};
use crate::syntax::{Entry, exactly};
use syn::Expr as Syntax;

/// Reads the arguments of one entry. Every reader returns `None` if the argument is absent or wrong (then the error
/// is recorded).
pub struct Arguments<'r, 'd> {
    resolver: &'r mut Resolver<'d>,
    entry: &'r Entry,
}

impl<'r, 'd> Arguments<'r, 'd> {
    pub(super) fn new(resolver: &'r mut Resolver<'d>, entry: &'r Entry) -> Self {
        Arguments { resolver, entry }
    }

    /// The state of the stage.
    pub(in crate::model) fn resolver(&mut self) -> &mut Resolver<'d> {
        self.resolver
    }

    /// The plane or space.
    pub fn world(&self) -> World {
        self.resolver.world
    }

    /// The name of the entry.
    pub fn entry_name(&self) -> String {
        self.entry.name.to_string()
    }

    /// The name of the entry's kind.
    pub fn kind_name(&self) -> String {
        self.entry.kind.to_string()
    }

    fn kind(&self) -> Option<&'static Kind> {
        let name = self.kind_name();
        match self.entry.name == "world" {
            true => Some(schema::world(&name)?.kind()),
            false => self.resolver.kinds.kind(self.resolver.world, &name),
        }
    }

    /// Whether the entry holds the orientation of its partners.
    fn holds_orientation(&self) -> bool {
        self.kind()
            .is_some_and(|kind| kind.traits().holds_orientation)
    }

    /// The value of an expression.
    pub(in crate::model) fn evaluate(&mut self, syntax: &Syntax) -> Option<Value> {
        self.resolver.evaluate(syntax)
    }

    /// The value of the entry itself, if it has one.
    pub(in crate::model) fn own_value(&mut self) -> Option<Value> {
        self.resolver.value_of(self.entry)
    }

    /// The graph to build expressions in.
    pub fn graph(&mut self) -> &mut Graph {
        &mut self.resolver.graph
    }

    /// Records an error at an argument (or at the entry, where it is absent).
    pub fn fail<T>(&mut self, field: &str, message: impl std::fmt::Display) -> Option<T> {
        let place = self
            .syntax(field)
            .map_or(self.entry.span().into(), Place::of);
        self.resolver.fail(place, message)
    }

    /// The argument, by position or by name; of an initial value that is held what `Exactly(…)` holds.
    pub fn syntax(&self, field: &str) -> Option<&'r Syntax> {
        let written = self.written(field)?;
        match self.is_initial(field) {
            true => Some(exactly(written).unwrap_or(written)),
            false => Some(written),
        }
    }

    /// Whether an initial value is held.
    pub(in crate::model) fn is_held(&self, field: &str) -> bool {
        self.written(field).and_then(exactly).is_some()
    }

    fn is_initial(&self, field: &str) -> bool {
        let kind = self.kind();
        let mut fields = kind.iter().flat_map(|kind| kind.fields);
        fields.any(|known| known.name == field && known.initial.is_some())
    }

    /// The argument as written.
    fn written(&self, field: &str) -> Option<&'r Syntax> {
        if let Some(argument) = self.entry.named(field) {
            return Some(&argument.value);
        }
        let kind = self.kind()?;
        let slot = kind
            .fields
            .iter()
            .filter(|f| f.positional)
            .position(|f| f.name == field)?;
        self.entry.positional.get(slot)
    }

    /// Whether the argument was given.
    pub fn has(&self, field: &str) -> bool {
        self.syntax(field).is_some()
    }

    /// Whether some arguments have wrong names or places, after an error: an absent one may be one of them.
    pub(in crate::model) fn are_misplaced(&self) -> bool {
        self.resolver.misplaced.contains(self.entry.name.as_str())
    }

    pub(in crate::model) fn expects(&self, field: &str) -> Option<Expects> {
        self.kind()?
            .fields
            .iter()
            .find(|f| f.name == field)
            .map(|f| f.expects)
    }

    /// A law, and the values of its arguments after the first `count`: `friction` has none, `friction(dry, within)` two.
    pub fn law_of(&mut self, field: &str, count: usize) -> Option<(u32, Vec<Expr>)> {
        let syntax = self.syntax(field)?;
        let Syntax::Call(call) = syntax else {
            return Some((self.resolver.law(syntax, count)?, Vec::new()));
        };
        let values = call.args.iter().map(|x| self.resolver.scalar(x));
        let values: Vec<_> = values.collect();
        let values: Option<Vec<_>> = values.into_iter().collect();
        let values: Vec<Expr> = values?.into_iter().map(|(value, _)| value).collect();
        let law = self.resolver.law(&call.func, count + values.len())?;
        Some((law, values))
    }

    /// `true` or `false`; false if absent.
    pub fn flag(&mut self, field: &str) -> bool {
        let Some(syntax) = self.syntax(field) else {
            return false;
        };
        if let Syntax::Lit(literal) = syntax
            && let syn::Lit::Bool(flag) = &literal.lit
        {
            return flag.value;
        }
        self.resolver
            .fail::<()>(Place::of(syntax), format!("`{field}` is true or false"));
        false
    }

    /// Scalars of a condition with their places: one expression, a vector, or a list.
    pub fn conditions(&mut self, field: &str) -> Option<Vec<(Place, Expr, Option<Dimension>)>> {
        let syntax = self.syntax(field)?;
        let items: Vec<&Syntax> = match syntax {
            Syntax::Array(array) => array.elems.iter().collect(),
            single => vec![single],
        };
        let mut conditions = Vec::new();
        for item in items {
            match self.resolver.evaluate(item)? {
                Value::Scalar(x, dimension) => conditions.push((Place::of(item), x, dimension)),
                Value::Vector(v, dimension) => {
                    let count = self.resolver.world.dimension();
                    let components = v.into_iter().take(count);
                    conditions.extend(components.map(|x| (Place::of(item), x, dimension)))
                }
                other => {
                    let what = other.describe();
                    return self.resolver.fail(Place::of(item), format!("a condition is a scalar or vector that is to be zero, but this is {what}"));
                }
            }
        }
        Some(conditions)
    }

    /// Records an error at a place.
    pub fn fail_at<T>(&mut self, place: Place, message: impl std::fmt::Display) -> Option<T> {
        self.resolver.fail(place, message)
    }
}
