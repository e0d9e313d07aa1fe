//! What an argument may not be.

use super::Arguments;
use crate::diagnostics::Place;
use crate::dimension::Dimension;
use crate::symbolic::{Expr, Symbol};
use syn::Expr as Syntax;

impl Arguments<'_, '_> {
    /// Refuses expressions that depend on a symbol for which `wrong` holds, at the smallest offending subexpression.
    pub fn refuse(
        &mut self,
        field: &str,
        wrong: &dyn Fn(Symbol) -> bool,
        message: &str,
    ) -> Option<()> {
        let syntax = self.syntax(field)?;
        let value = self.resolver.evaluate(syntax)?;
        if value.depends_on(&self.resolver.graph, wrong) {
            let place = self.resolver.blame(syntax, wrong);
            return self.resolver.fail(place, message);
        }
        Some(())
    }

    /// Refuses laws, where derivatives beyond the first would be needed.
    pub fn refuse_laws(&mut self, field: &str) -> Option<()> {
        let syntax = self.syntax(field)?;
        let value = self.resolver.evaluate(syntax)?;
        if value
            .expressions()
            .into_iter()
            .any(|x| self.resolver.graph.contains_law(x))
        {
            return self.fail(field, "a law gives value and first partials; a constraint needs more: use it in a force, or write the expression out");
        }
        Some(())
    }

    pub(in crate::model) fn check_dimension(
        &mut self,
        field: &str,
        found: Option<Dimension>,
        expected: Dimension,
        place: Place,
    ) -> Option<()> {
        match found {
            Some(found) if found != expected => self.resolver.fail(
                place,
                format!("`{field}` is {expected}, but this is {found}"),
            ),
            _ => Some(()),
        }
    }

    pub(in crate::model) fn check_known(
        &mut self,
        field: &str,
        syntax: &Syntax,
        exprs: &[Expr],
    ) -> Option<()> {
        let moving = |symbol: Symbol| !symbol.is_parameter_like();
        if exprs
            .iter()
            .any(|&x| self.resolver.graph.depends_on(x, moving))
        {
            let place = self.resolver.blame(syntax, &moving);
            let hint = match field {
                "at" => "; a place that several entries share is a `Point`",
                _ => "",
            };
            return self.resolver.fail(
                place,
                format!("`{field}` must be known before the motion starts: it may use numbers and parameters only{hint}"),
            );
        }
        Some(())
    }

    pub(super) fn check_configuration(&mut self, syntax: &Syntax, exprs: &[Expr]) -> Option<()> {
        let wrong =
            |symbol: Symbol| !symbol.is_local_position() && !matches!(symbol, Symbol::Parameter(_));
        if exprs
            .iter()
            .any(|&x| self.resolver.graph.depends_on(x, wrong))
        {
            let place = self.resolver.blame(syntax, &wrong);
            return self.resolver.fail(
                place,
                "a frame follows coordinates and parameters only; to prescribe a motion in time use a `Drive`",
            );
        }
        Some(())
    }
}
