//! Tables: as they are declared, and where they are used.

use super::arguments::Arguments;
use super::expression::functions::is_function;
use super::resolver::Resolver;
use super::value::Value;
use crate::diagnostics::{Place, did_you_mean};
use crate::dimension::Dimension;
use crate::schema::Expects;
use crate::symbolic::{Beyond, Interpolation, Table};
use crate::syntax::{Entry, Reference, reference};
use std::sync::Arc;
use syn::Expr as Syntax;

impl Resolver<'_> {
    /// The value of an entry `Table`.
    pub(super) fn table(&mut self, entry: &Entry) -> Option<Value> {
        let (word, name) = (entry.name.word(), entry.name.to_string());
        if is_function(&word.to_string()) {
            return self.fail(
                word.span(),
                format!("`{word}` is a function of the language; give the table another name"),
            );
        }
        let mut arguments = Arguments::new(self, entry);
        let x = arguments.column("arguments")?;
        let y = arguments.column("values")?;
        let interpolation = match arguments.word("interpolation")? {
            "Linear" => Interpolation::Linear,
            _ => Interpolation::Cubic,
        };
        let beyond = match arguments.word("beyond")? {
            "Constant" => Beyond::Constant,
            "Periodic" => Beyond::Periodic,
            _ => Beyond::Linear,
        };
        let [of_x, of_y] = [x.dimension, y.dimension];
        let (points, [x, y]) = ([x.data, y.data], [x.numbers, y.numbers]);
        if x.len() < 2 {
            return arguments.fail("arguments", "a table takes at least two arguments");
        }
        if x.len() != y.len() {
            let message = format!(
                "a table has a value for each argument, but there are {} arguments and {} values",
                x.len(),
                y.len()
            );
            return arguments.fail("values", message);
        }
        if let Some(k) = (1..x.len()).find(|&k| x[k] <= x[k - 1]) {
            let place = arguments.item("arguments", k);
            return arguments.fail_at(
                place,
                "the arguments of a table have to increase, but this one is not larger than the one before; list the points in the order of their arguments, each once",
            );
        }
        if beyond == Beyond::Periodic && y[0] != y[y.len() - 1] {
            let message = format!(
                "a periodic table ends with the value with which it begins, but these are {} and {}, in SI units: add a point a period after the first one, with its value",
                y[0],
                y[y.len() - 1]
            );
            return arguments.fail("values", message);
        }
        let table = Table::new((self.tables.len(), name), &x, &y, interpolation, beyond);
        if !table.pieces().flatten().all(f64::is_finite) {
            return Arguments::new(self, entry).fail(
                "values",
                "the curve through these values is not finite: give smaller values, or arguments farther apart",
            );
        }
        let table = Arc::new(table.with_data(points, interpolation, beyond));
        self.tables.push(table.clone());
        Some(Value::Table(table, [of_x, of_y]))
    }

    /// Whether an entry of this name is a table.
    pub(super) fn is_table(&self, name: &str) -> bool {
        let index = self.names.get(name);
        index.is_some_and(|&index| self.entry(index).kind == "Table")
    }

    /// The table that an expression names.
    pub(super) fn table_named(&self, syntax: &Syntax) -> Option<String> {
        let name = reference(syntax)?.ok()?.text();
        self.is_table(&name).then_some(name)
    }

    /// Whether a call of this name may be that of a table: it is one, or a family.
    pub(super) fn may_be_table(&self, name: &str) -> bool {
        !is_function(name) && (self.is_table(name) || self.declaration.family(name).is_some())
    }

    /// `name(x)`.
    pub(super) fn table_call(
        &mut self,
        callee: &Reference,
        place: Place,
        arguments: Vec<&Syntax>,
    ) -> Option<Value> {
        let (table, [takes, gives]) = match self.lookup(callee, place)? {
            Value::Table(table, dimensions) => (table, dimensions),
            other => {
                let what = other.describe();
                return self.fail(
                    place,
                    format!("only a `Table` is called, but this is {what}"),
                );
            }
        };
        let &[argument] = arguments.as_slice() else {
            let (name, count) = (&table.name, arguments.len());
            return self.fail(place, format!("`{name}` takes 1 argument, not {count}"));
        };
        let (x, dimension) = self.scalar(argument)?;
        if let (Some(takes), Some(dimension)) = (takes, dimension)
            && takes != dimension
        {
            let name = &table.name;
            return self.fail(
                Place::of(argument),
                format!("`{name}` takes {takes}, but this is {dimension}"),
            );
        }
        Some(Value::Scalar(self.graph.table(&table, 0, x), gives))
    }
}

impl Arguments<'_, '_> {
    /// Whether the argument is the name of a table.
    pub(in crate::model) fn names_table(&mut self, field: &str) -> bool {
        let syntax = self.syntax(field);
        syntax.is_some_and(|syntax| self.resolver().table_named(syntax).is_some())
    }

    /// A table that takes and gives these.
    pub(in crate::model) fn table(
        &mut self,
        field: &str,
        wanted: [Dimension; 2],
    ) -> Option<Arc<Table>> {
        let syntax = self.syntax(field)?;
        let Value::Table(table, found) = self.resolver().evaluate(syntax)? else {
            return None;
        };
        for ((found, wanted), what) in found.into_iter().zip(wanted).zip(["takes", "gives"]) {
            if let Some(found) = found.filter(|&found| found != wanted) {
                let message = format!("`{}` {what} {found}, but here it is {wanted}", table.name);
                return self.fail(field, message);
            }
        }
        Some(table)
    }

    /// One of the words of the schema; the first if it was not given.
    fn word(&mut self, field: &str) -> Option<&'static str> {
        let Some(Expects::Word(words)) = self.expects(field) else {
            return None;
        };
        let Some(syntax) = self.syntax(field) else {
            return words.first().copied();
        };
        let found = reference(syntax).and_then(Result::ok);
        let found = found.map_or_else(String::new, |found| found.text());
        let known = words.iter().find(|word| **word == found);
        if known.is_none() {
            let hint = did_you_mean(&found, words.iter().copied());
            let words: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
            return self.fail(field, format!("expected {}{hint}", words.join(" or ")));
        }
        known.copied()
    }
}
