//! Numbers and units.

use super::Arguments;
use crate::diagnostics::Place;
use crate::dimension::Dimension;
use crate::model::requirements::Wanted;
use crate::schema::Expects;
use crate::symbolic::Expr;
use crate::syntax::{CONSTANT_IN_ASSEMBLY, is_constant, path_text, reference};
use syn::Expr as Syntax;

impl Arguments<'_, '_> {
    /// A scalar of the dimension in the schema.
    pub fn scalar(&mut self, field: &str) -> Option<Expr> {
        match self.expects(field)? {
            // In space lengths may be distances of the home pose.
            expects @ Expects::Known(Dimension::LENGTH) => {
                self.at_home(|arguments| arguments.scalar_as(field, expects))
            }
            expects => self.scalar_as(field, expects),
        }
    }

    fn scalar_as(&mut self, field: &str, expects: Expects) -> Option<Expr> {
        let syntax = self.syntax(field)?;
        let (expr, dimension) = self.resolver.scalar(syntax)?;
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
        self.refuse_negative(field, value)?;
        Some(value)
    }

    /// Refuses a value that is negative.
    pub fn refuse_negative(&mut self, field: &str, value: Expr) -> Option<()> {
        if self.by_default(value) < 0.0 {
            let found = self.found(value);
            return self.fail(
                field,
                format!("`{field}` is negative{found}; give it a positive value"),
            );
        }
        self.require(field, &[value], Wanted::NotNegative);
        Some(())
    }

    /// Refuses a value that is not positive.
    pub fn refuse_not_positive(
        &mut self,
        field: &str,
        value: Expr,
        message: &'static str,
    ) -> Option<()> {
        if self.by_default(value) <= 0.0 {
            let found = self.found(value);
            return self.fail(field, format!("{message}{found}"));
        }
        self.require(field, &[value], Wanted::Positive(message));
        Some(())
    }

    /// The value with the defaults of all parameters; NaN if it depends on anything else.
    pub fn by_default(&self, expr: Expr) -> f64 {
        self.resolver.by_default(expr)
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

    /// The rate of an expression of positions.
    pub fn rate_of(&mut self, expr: Expr) -> Expr {
        self.resolver.rate_of(expr)
    }

    /// A scalar with its dimension.
    pub fn quantity(&mut self, field: &str) -> Option<(Expr, Option<Dimension>)> {
        let syntax = self.syntax(field)?;
        let (expr, dimension) = self.resolver.scalar(syntax)?;
        if matches!(
            self.expects(field),
            Some(Expects::KnownAny | Expects::Known(_))
        ) {
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
                    _ => return self.resolver.fail(Place::of(syntax), self.no_number()),
                }
            }
        };
        if let Some(stated) = self.unit()? {
            self.check_unit(dimension, stated)?;
            dimension = Some(stated);
        }
        Some((value, dimension))
    }

    /// The constant of Rust that a parameter takes its default from, where there is a `nominal =`; the outer `None` after
    /// an error.
    pub(in crate::model) fn constant(&mut self) -> Option<Option<syn::ExprPath>> {
        if !self.has("nominal") {
            return match self.syntax("value") {
                Some(syntax @ Syntax::Path(path))
                    if path.path.get_ident().is_none() && !self.names_entry(syntax) =>
                {
                    self.fail("value", self.without_nominal(path))
                }
                _ => Some(None),
            };
        }
        if self.entry.name.is_nested() {
            return self.fail("value", CONSTANT_IN_ASSEMBLY);
        }
        match self.syntax("value") {
            Some(Syntax::Path(path)) => Some(Some(path.clone())),
            _ => self.fail(
                "value",
                "a parameter with `nominal =` takes the path of a constant, such as `LENGTH`; leave `nominal =` out for a number",
            ),
        }
    }

    /// Whether a path is what putting an assembly in place made of a name, and this is no constant of Rust.
    fn names_entry(&self, syntax: &Syntax) -> bool {
        let Some(Ok(reference)) = reference(syntax) else {
            return false;
        };
        let name = reference.text();
        self.resolver.is_declared(&name) || !(name.contains('.') || is_constant(&name))
    }

    /// The message at what is no finite number.
    fn no_number(&self) -> String {
        let name = &self.entry.name;
        match self.entry.kind == "Param" && name.is_nested() {
            true => format!(
                "the default of a parameter is a number; to give a quantity of the mechanism, let `{}` be a port of the assembly",
                name.word()
            ),
            false => "expected a finite number, such as `0.15_m`; what follows from parameters is a `Let`".to_owned(),
        }
    }

    /// The message at the path of a constant alone.
    fn without_nominal(&self, path: &syn::ExprPath) -> String {
        // An assembly alone has no world.
        if self.entry.name.is_nested() || self.resolver.declaration.world.is_none() {
            return CONSTANT_IN_ASSEMBLY.to_owned();
        }
        let path = path_text(path);
        format!(
            "the compiler does not know the value of this constant: give about its value, with its unit, as in `Param({path}, nominal = 1.0_kg)`"
        )
    }

    /// A stated unit fits the value beside it.
    pub(in crate::model) fn check_unit(
        &mut self,
        value: Option<Dimension>,
        stated: Dimension,
    ) -> Option<()> {
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
    pub(in crate::model) fn unit(&mut self) -> Option<Option<Dimension>> {
        let Some(syntax) = self.syntax("unit") else {
            return Some(None);
        };
        let name = match syntax {
            Syntax::Path(path) => path.path.get_ident().map(ToString::to_string),
            _ => None,
        };
        match name.as_deref().and_then(crate::dimension::unit) {
            Some((1.0, dimension)) => Some(Some(dimension)),
            Some((_, Dimension::NONE)) => self.resolver.fail(
                Place::of(syntax),
                "state an SI unit here, `rad` for an angle: values are SI",
            ),
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
}
