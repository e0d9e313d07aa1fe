//! The arguments of an entry, read as what the schema says they are.

use super::dimension::Dimension;
use super::geometry::{Frame, Owner, Point, Vector};
use super::resolve::Resolver;
use super::value::Value;
use crate::diagnostics::Place;
use crate::schema::{self, Expects};
use crate::symbolic::{Evaluator, Expr, Graph, Symbol};
use crate::syntax::Entry;
use syn::Expr as Syntax;

/// Reads the arguments of one entry. Every reader answers `None` where the argument is absent or wrong (and then the
/// error is recorded).
pub struct Arguments<'r, 'd> {
    resolver: &'r mut Resolver<'d>,
    entry: &'r Entry,
}

impl<'r, 'd> Arguments<'r, 'd> {
    pub(super) fn new(resolver: &'r mut Resolver<'d>, entry: &'r Entry) -> Self {
        Arguments { resolver, entry }
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

    /// The argument as written, by position or by name.
    pub fn syntax(&self, field: &str) -> Option<&'r Syntax> {
        if let Some(argument) = self.entry.named(field) {
            return Some(&argument.value);
        }
        let kind = schema::kind(&self.entry.kind.to_string())
            .or_else(|| schema::world(&self.entry.kind.to_string()))?;
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

    fn expects(&self, field: &str) -> Option<Expects> {
        let kind = schema::kind(&self.entry.kind.to_string())
            .or_else(|| schema::world(&self.entry.kind.to_string()))?;
        kind.fields
            .iter()
            .find(|f| f.name == field)
            .map(|f| f.expects)
    }

    /// A scalar of the dimension that the schema asks for.
    pub fn scalar(&mut self, field: &str) -> Option<Expr> {
        let syntax = self.syntax(field)?;
        let (expr, dimension) = self.resolver.scalar(syntax)?;
        let expects = self.expects(field)?;
        if let Expects::Known(expected) | Expects::Moving(expected) = expects {
            self.check_dimension(field, dimension, expected, Place::of(syntax))?;
        }
        if matches!(expects, Expects::Known(_) | Expects::KnownAny) {
            self.check_known(field, syntax, &[expr])?;
        }
        Some(expr)
    }

    /// A mass or inertia: 0 if it was not given, and not negative.
    pub fn mass(&mut self, field: &str) -> Option<Expr> {
        let value = self.scalar_or(field, 0.0)?;
        if self.by_default(value) < 0.0 {
            let found = self.found(value);
            return self.fail(
                field,
                format!("`{field}` is negative{found}; give it a positive value"),
            );
        }
        Some(value)
    }

    /// Refuses a length that is not positive.
    pub fn refuse_no_length(&mut self, field: &str, length: Expr, message: &str) -> Option<()> {
        if self.by_default(length) <= 0.0 {
            let found = self.found(length);
            return self.fail(field, format!("{message}{found}"));
        }
        Some(())
    }

    /// The value with the defaults of all parameters; NaN if it depends on anything else.
    fn by_default(&self, expr: Expr) -> f64 {
        let symbols = |symbol| match symbol {
            Symbol::Parameter(index) => self.resolver.parameters[index as usize].default,
            _ => f64::NAN,
        };
        let laws = |_, arguments: &[f64]| (f64::NAN, vec![f64::NAN; arguments.len()]);
        Evaluator::new(&self.resolver.graph, &symbols, &laws).value(expr)
    }

    /// What a message adds where the value follows from parameters.
    fn found(&self, expr: Expr) -> String {
        match self.resolver.graph.as_constant(expr) {
            Some(_) => String::new(),
            None => format!(
                " (with the defaults of its parameters it is {})",
                self.by_default(expr)
            ),
        }
    }

    /// A scalar, or a number if it was not given. `None` only after an error.
    pub fn scalar_or(&mut self, field: &str, default: f64) -> Option<Expr> {
        if self.has(field) {
            self.scalar(field)
        } else {
            Some(self.resolver.graph.constant(default))
        }
    }

    /// A scalar with its dimension.
    pub fn quantity(&mut self, field: &str) -> Option<(Expr, Option<Dimension>)> {
        let syntax = self.syntax(field)?;
        let (expr, dimension) = self.resolver.scalar(syntax)?;
        if self.expects(field) == Some(Expects::KnownAny) {
            self.check_known(field, syntax, &[expr])?;
        }
        Some((expr, dimension))
    }

    /// A number that is known now, with its dimension; `unit =` may state the latter.
    pub fn number(&mut self, field: &str) -> Option<(f64, Option<Dimension>)> {
        let (value, mut dimension) = match self.syntax(field) {
            None => (0.0, None),
            Some(syntax) => {
                let (expr, dimension) = self.resolver.scalar(syntax)?;
                match self.resolver.graph.as_constant(expr) {
                    Some(value) if value.is_finite() => (value, dimension),
                    _ => {
                        return self
                            .resolver
                            .fail(Place::of(syntax), "expected a finite number, such as `0.15_m`; what follows from parameters is a `Let`");
                    }
                }
            }
        };
        if let Some(stated) = self.unit()? {
            self.check_unit(dimension, stated)?;
            dimension = Some(stated);
        }
        Some((value, dimension))
    }

    /// A stated unit fits the value beside it.
    pub(super) fn check_unit(&mut self, value: Option<Dimension>, stated: Dimension) -> Option<()> {
        match value {
            Some(value) if value != stated => self.fail(
                "unit",
                format!(
                    "this unit is that of {stated}, but the value is {value}; keep one of them"
                ),
            ),
            _ => Some(()),
        }
    }

    /// `unit = N_per_m`; the outer `None` after an error.
    pub(super) fn unit(&mut self) -> Option<Option<Dimension>> {
        let Some(syntax) = self.syntax("unit") else {
            return Some(None);
        };
        let name = match syntax {
            Syntax::Path(path) => path.path.get_ident().map(ToString::to_string),
            _ => None,
        };
        match name.as_deref().and_then(super::unit) {
            Some((1.0, dimension)) => Some(Some(dimension)),
            Some(_) => self.resolver.fail(
                Place::of(syntax),
                "state an SI unit here, such as `N` or `m_per_s`: values are SI",
            ),
            None => self.resolver.fail(
                Place::of(syntax),
                "expected a unit, such as `N` or `N_s_per_m`",
            ),
        }
    }

    /// Two components of the dimension that the schema asks for.
    pub fn vector(&mut self, field: &str) -> Option<Vector> {
        let syntax = self.syntax(field)?;
        let (vector, dimension) = self.resolver.vector(syntax)?;
        let expects = self.expects(field)?;
        if let Expects::KnownVector(expected) | Expects::MovingVector(expected) = expects {
            self.check_dimension(field, dimension, expected, Place::of(syntax))?;
        }
        if matches!(expects, Expects::KnownVector(_)) {
            self.check_known(field, syntax, &vector)?;
        }
        Some(vector)
    }

    /// A point; a particle stands for its own.
    pub fn point(&mut self, field: &str) -> Option<Point> {
        let syntax = self.syntax(field)?;
        match self.resolver.evaluate(syntax)? {
            Value::Point(point) => Some(point),
            Value::Frame(owner) => {
                let names = self.resolver.point_names(owner);
                if names == ["origin"] && owner != Owner::Ground {
                    return self.resolver.named_point(owner, "origin");
                }
                let name = self.resolver.owner_name(owner).to_owned();
                let examples: Vec<_> = names
                    .iter()
                    .map(|point| format!("`{name}.{point}`"))
                    .collect();
                self.resolver.fail(
                    Place::of(syntax),
                    format!(
                        "`{field}` is a point: name one of `{name}`, such as {}",
                        examples.join(" or ")
                    ),
                )
            }
            other => {
                let what = other.describe();
                self.resolver.fail(Place::of(syntax), format!("`{field}` is a point, such as `crank.b` or `ground.origin`, but this is {what}"))
            }
        }
    }

    /// A part or the ground.
    pub fn part(&mut self, field: &str) -> Option<Owner> {
        let syntax = self.syntax(field)?;
        match self.resolver.evaluate(syntax)? {
            Value::Frame(owner) => Some(owner),
            other => {
                let what = other.describe();
                self.resolver.fail(
                    Place::of(syntax),
                    format!("`{field}` is a part or `ground`, but this is {what}"),
                )
            }
        }
    }

    /// The frame of the ground or of a part.
    pub fn frame(&mut self, owner: Owner) -> Frame {
        self.resolver.frame(owner)
    }

    /// The part of this index is a particle, which has no orientation.
    pub fn is_particle(&self, owner: Owner) -> bool {
        matches!(owner, Owner::Part(part) if self.resolver.parts[part].kind == "Particle")
    }

    /// The name of a part.
    pub fn owner_name(&self, owner: Owner) -> String {
        self.resolver.owner_name(owner).to_owned()
    }

    /// The length of a bar.
    pub fn bar_length(&self, owner: Owner) -> Option<Expr> {
        self.resolver.bar_length(owner)
    }

    /// A direction of unit length, turned into the ground's axes from those of `owner`.
    pub fn axis(&mut self, field: &str, owner: Owner) -> Option<Vector> {
        let components = match self.syntax(field) {
            None => [self.resolver.graph.one(), self.resolver.graph.zero()],
            Some(syntax) => {
                let (vector, dimension) = self.resolver.vector(syntax)?;
                self.check_known(field, syntax, &vector)?;
                self.check_dimension(field, dimension, Dimension::NONE, Place::of(syntax))?;
                if vector.iter().all(|&x| self.resolver.graph.is_zero(x)) {
                    return self.resolver.fail(
                        Place::of(syntax),
                        "this axis has no length; give it a direction, such as X or [1.0, 1.0]",
                    );
                }
                let norm = self.resolver.graph.norm(vector);
                let one = self.resolver.graph.one();
                let inverse = self.resolver.graph.div(one, norm);
                self.resolver.graph.vector_scale(inverse, vector)
            }
        };
        let frame = self.resolver.frame(owner);
        Some(self.resolver.graph.turn(frame.axis, components))
    }

    /// A law of `count` arguments.
    pub fn law(&mut self, field: &str, count: usize) -> Option<u32> {
        let syntax = self.syntax(field)?;
        self.resolver.law(syntax, count)
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

    /// `Frame([x, y], angle)`.
    pub fn prescribed_frame(&mut self, field: &str) -> Option<(Vector, Expr)> {
        let syntax = self.syntax(field)?;
        let expected = "expected `Frame([x, y], angle)`";
        let Syntax::Call(call) = syntax else {
            return self.resolver.fail(Place::of(syntax), expected);
        };
        let is_frame = matches!(&*call.func, Syntax::Path(path) if path.path.is_ident("Frame"));
        if !is_frame || call.args.len() != 2 {
            return self.resolver.fail(Place::of(syntax), expected);
        }
        let (position, dimension) = self.resolver.vector(&call.args[0])?;
        self.check_dimension(
            field,
            dimension,
            Dimension::LENGTH,
            Place::of(&call.args[0]),
        )?;
        let (angle, dimension) = self.resolver.scalar(&call.args[1])?;
        self.check_dimension(field, dimension, Dimension::NONE, Place::of(&call.args[1]))?;
        for (syntax, exprs) in [
            (&call.args[0], position.to_vec()),
            (&call.args[1], vec![angle]),
        ] {
            self.check_configuration(syntax, &exprs)?;
        }
        Some((position, angle))
    }

    /// A position as an expression of coordinates.
    pub fn prescribed_position(&mut self, field: &str) -> Option<Vector> {
        let position = self.vector(field)?;
        let syntax = self.syntax(field)?;
        self.check_configuration(syntax, &position)?;
        Some(position)
    }

    fn check_configuration(&mut self, syntax: &Syntax, exprs: &[Expr]) -> Option<()> {
        let wrong =
            |symbol: Symbol| !matches!(symbol, Symbol::LocalPosition(_) | Symbol::Parameter(_));
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
                    conditions.extend(v.map(|x| (Place::of(item), x, dimension)))
                }
                other => {
                    let what = other.describe();
                    return self.resolver.fail(Place::of(item), format!("a condition is a scalar or vector that is to be zero, but this is {what}"));
                }
            }
        }
        Some(conditions)
    }

    /// Refuses expressions that depend on a symbol for which `wrong` holds, at the smallest offending subexpression.
    pub fn refuse(
        &mut self,
        field: &str,
        wrong: &dyn Fn(Symbol) -> bool,
        message: &str,
    ) -> Option<()> {
        let syntax = self.syntax(field)?;
        let value = self.resolver.evaluate(syntax)?;
        if value
            .expressions()
            .into_iter()
            .any(|x| self.resolver.graph.depends_on(x, wrong))
        {
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

    /// The part that an expression names, if it does.
    pub fn part_of(&mut self, syntax: &Syntax) -> Option<Owner> {
        match self
            .resolver
            .silently(|resolver| resolver.evaluate(syntax))?
        {
            Value::Frame(owner) => {
                self.resolver
                    .used
                    .insert(self.resolver.owner_name(owner).to_owned());
                Some(owner)
            }
            _ => None,
        }
    }

    /// Records an error at a place.
    pub fn fail_at<T>(&mut self, place: Place, message: impl std::fmt::Display) -> Option<T> {
        self.resolver.fail(place, message)
    }

    fn check_dimension(
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

    fn check_known(&mut self, field: &str, syntax: &Syntax, exprs: &[Expr]) -> Option<()> {
        let moving = |symbol: Symbol| !symbol.is_parameter_like();
        if exprs
            .iter()
            .any(|&x| self.resolver.graph.depends_on(x, moving))
        {
            let place = self.resolver.blame(syntax, &moving);
            return self.resolver.fail(
                place,
                format!("`{field}` must be known before the motion starts: it may use numbers and parameters only"),
            );
        }
        Some(())
    }
}
