//! The columns of a table: its arguments, and its values.

use super::Arguments;
use crate::diagnostics::Place;
use crate::dimension::Dimension;
use crate::model::value::{Value, unify};
use crate::symbolic::{Datum, Expr, Node, Symbol};
use crate::syntax::reference;
use syn::Expr as Syntax;

/// Numbers and parameters of one dimension.
pub(in crate::model) struct Column {
    pub data: Vec<Datum>,
    /// With the defaults of the parameters.
    pub numbers: Vec<f64>,
    pub dimension: Option<Dimension>,
}

/// An item with its place.
type Item = (Place, Expr, Option<Dimension>);

impl Arguments<'_, '_> {
    /// A column: a list, or a family.
    pub(in crate::model) fn column(&mut self, field: &str) -> Option<Column> {
        let items = match self.syntax(field)? {
            Syntax::Array(array) => self.listed(array.elems.iter())?,
            other => self.members(field, other)?,
        };
        let mut column = Column {
            data: Vec::new(),
            numbers: Vec::new(),
            dimension: None,
        };
        for (place, x, dimension) in items {
            let datum = match *self.graph().node(x) {
                Node::Constant(number) => Datum::Number(number),
                Node::Symbol(symbol @ Symbol::Parameter(_)) => Datum::Parameter(symbol),
                _ => {
                    return self.fail_at(
                        place,
                        "expected a number, such as `0.15_m`, or a parameter: the points of a table do not change during a run, and the program gives them one by one",
                    );
                }
            };
            if let (Some(common), Some(dimension)) = (column.dimension, dimension)
                && common != dimension
            {
                let message = format!("this is {dimension}, but a value before it is {common}");
                return self.fail_at(place, message);
            }
            column.dimension = unify(column.dimension, dimension).ok()?;
            column.data.push(datum);
            column.numbers.push(self.by_default(x));
        }
        Some(column)
    }

    fn listed<'s>(&mut self, items: impl Iterator<Item = &'s Syntax>) -> Option<Vec<Item>> {
        let items = items.map(|item| {
            let (x, dimension) = self.resolver().scalar(item)?;
            Some((Place::of(item), x, dimension))
        });
        items.collect()
    }

    /// The members of a family in order; of two indices, `curve[1]` gives the first.
    fn members(&mut self, field: &str, syntax: &Syntax) -> Option<Vec<Item>> {
        let named = reference(syntax).and_then(Result::ok);
        let declaration = self.resolver().declaration;
        let family = named.and_then(|named| Some((declaration.family(&named.base)?, named)));
        let Some((family, named)) =
            family.filter(|(family, named)| family.ranges.len() == named.indices.len() + 1)
        else {
            return self.fail(
                field,
                "expected a list, such as `[0.0_m, 0.1_m, 0.2_m]`, or a family of parameters with one index",
            );
        };
        let first = named.text() + "[";
        let names = declaration.entries.iter().map(|entry| entry.name.as_str());
        let names: Vec<&str> = names.filter(|name| name.starts_with(&first)).collect();
        if names.is_empty() {
            let ([first, last], word) = (family.ends(), &family.name);
            let message = format!(
                "there is no `{}`; the members of `{word}` go from `{first}` to `{last}`",
                named.text()
            );
            return self.fail(field, message);
        }
        let place = Place::of(syntax);
        let items = names.into_iter().map(|name| {
            let value = self.resolver().value_named(name, place)?;
            match value {
                Value::Scalar(x, dimension) => Some((place, x, dimension)),
                other => {
                    let what = other.describe();
                    let message =
                        format!("a table takes numbers and parameters, but `{name}` is {what}");
                    self.fail_at(place, message)
                }
            }
        });
        items.collect()
    }

    /// Where an item of a list is.
    pub(in crate::model) fn item(&self, field: &str, index: usize) -> Place {
        match self.syntax(field) {
            Some(Syntax::Array(array)) => Place::of(&array.elems[index]),
            other => Place::of(&other),
        }
    }
}
