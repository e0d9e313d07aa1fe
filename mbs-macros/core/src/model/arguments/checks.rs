//! What an argument may not be.

use super::Arguments;
use crate::diagnostics::Place;
use crate::dimension::Dimension;
use crate::model::resolver::Resolver;
use crate::model::value::Value;
use crate::schema::{Group, World};
use crate::symbolic::{Expr, Symbol};
use crate::syntax::{children, reference};
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

    /// Refuses laws where a force needs their second partials.
    pub fn refuse_laws_in_force(&mut self, field: &str) -> Option<()> {
        let syntax = self.syntax(field)?;
        let value = self.resolver.evaluate(syntax)?;
        let graph = &self.resolver.graph;
        if value.expressions().iter().any(|&x| graph.contains_law(x)) {
            let place = self.resolver.blame_law(syntax);
            return self.resolver.fail(place, "a law gives value and first partials, and what this force acts on needs second ones: write the expression out");
        }
        Some(())
    }

    /// Refuses a joint or one of its reactions as the value of a force.
    pub fn refuse_reaction(&mut self, field: &str) -> Option<()> {
        let syntax = self.syntax(field)?;
        if let Some(joint) = self.resolver.reaction_in(syntax) {
            let message = format!(
                "`{field}` cannot be the reaction of a joint: it follows from the accelerations, and these follow from the friction. Give a number, a parameter or an expression, or an `Input` that the program sets from the reaction of the step before"
            );
            return self.resolver.fail(joint, message);
        }
        Some(())
    }

    /// Refuses tables whose slope jumps, where the derivative of this order must not.
    pub fn refuse_kinks(&mut self, field: &str, order: i8) -> Option<()> {
        let syntax = self.syntax(field)?;
        let value = self.resolver.evaluate(syntax)?;
        self.resolver
            .without_kinks(syntax, &value.expressions(), order)
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
            let may = match (field, self.resolver.world) {
                _ if self.resolver.in_home_pose => {
                    "numbers, parameters, and points and axes of parts, which are then those of the home pose"
                }
                ("at" | "from" | "to", World::Planar) => {
                    "numbers and parameters only; a place that several entries share is a `Point`, and a point of a part, alone, stands for where it is at the start"
                }
                _ => "numbers and parameters only",
            };
            return self.resolver.fail(
                place,
                format!("`{field}` must be known before the motion starts: it may use {may}"),
            );
        }
        self.resolver.known_without_laws(syntax, exprs, field)
    }

    pub(super) fn check_configuration(
        &mut self,
        field: &str,
        syntax: &Syntax,
        exprs: &[Expr],
    ) -> Option<()> {
        let wrong =
            |symbol: Symbol| !symbol.is_local_position() && !matches!(symbol, Symbol::Parameter(_));
        if exprs
            .iter()
            .any(|&x| self.resolver.graph.depends_on(x, wrong))
        {
            let place = self.resolver.blame(syntax, &wrong);
            return self.resolver.fail(
                place,
                format!("`{field}` follows coordinates and parameters only; to prescribe a motion in time use a `Drive`"),
            );
        }
        // The rows of velocities and accelerations need its second partials.
        if exprs.iter().any(|&x| self.resolver.graph.contains_law(x)) {
            let place = self.resolver.blame_law(syntax);
            return self.resolver.fail(
                place,
                "a law gives value and first partials, and what follows a coordinate needs more: write the expression out",
            );
        }
        self.resolver.without_kinks(syntax, exprs, 0)
    }
}

impl Resolver<'_> {
    /// Where a joint is named for anything but its motion.
    fn reaction_in(&mut self, syntax: &Syntax) -> Option<Place> {
        let joint = |syntax: &Syntax| {
            let name = reference(syntax)?.ok()?.text();
            let kind = self.kind_of(self.entry(*self.names.get(&name)?))?;
            matches!(kind.group, Group::Joint | Group::Constraint).then_some(())
        };
        let found = match syntax {
            Syntax::Field(field) => joint(&field.base),
            other => joint(other),
        };
        if found.is_some() {
            let value = self.silently(|resolver| resolver.evaluate(syntax));
            return (!matches!(value, Some(Value::Scalar(..)))).then(|| Place::of(syntax));
        }
        children(syntax)
            .into_iter()
            .find_map(|child| self.reaction_in(child))
    }

    /// Refuses values that jump, and tables whose slope jumps, and their derivatives, from one of an order on.
    fn without_kinks(&mut self, syntax: &Syntax, exprs: &[Expr], order: i8) -> Option<()> {
        if exprs.iter().any(|&x| self.graph.jumps(x)) {
            return self.fail(
                Place::of(syntax),
                "this jumps, and positions or velocities would have to jump with it: use a value that changes steadily, an `Input` that the program sets, or a force",
            );
        }
        if !exprs.iter().any(|&x| self.graph.contains_kink(x, order)) {
            return Some(());
        }
        let place = self.blame_kink(syntax, order);
        self.fail(
            place,
            "the slope of this table jumps, and velocities would jump with it: leave `interpolation = Linear` out, or use the table in a force",
        )
    }

    /// Refuses laws in a value that is known before the motion: the compiler checks it with the defaults of all
    /// parameters, and cannot call functions of the program.
    pub(in crate::model) fn known_without_laws(
        &mut self,
        syntax: &Syntax,
        exprs: &[Expr],
        what: &str,
    ) -> Option<()> {
        if !exprs.iter().any(|&x| self.graph.contains_law(x)) {
            return Some(());
        }
        let place = self.blame_law(syntax);
        self.fail(
            place,
            format!("`{what}` must be known before the motion starts, and a law is called during the motion: make this a `Param` and let the program compute it, or write the expression out"),
        )
    }
}
