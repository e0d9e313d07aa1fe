//! Functions by name.

use crate::diagnostics::{Place, did_you_mean, meant};
use crate::dimension::Dimension;
use crate::model::readings::is_at_acceleration_level;
use crate::model::resolver::Resolver;
use crate::model::value::{Value, unify};
use crate::schema::World;
use crate::symbolic::{Expr, Function, Symbol};
use proc_macro2::Span;
use syn::Expr as Syntax;

/// Elementary functions by name: what their argument and result are.
const FUNCTIONS: &[(&str, Function, Shape)] = &[
    ("sin", Function::Sin, Shape::Number),
    ("cos", Function::Cos, Shape::Number),
    ("tan", Function::Tan, Shape::Number),
    ("asin", Function::Asin, Shape::Number),
    ("acos", Function::Acos, Shape::Number),
    ("atan", Function::Atan, Shape::Number),
    ("exp", Function::Exp, Shape::Number),
    ("ln", Function::Ln, Shape::Number),
    ("sinh", Function::Sinh, Shape::Number),
    ("cosh", Function::Cosh, Shape::Number),
    ("tanh", Function::Tanh, Shape::Number),
    ("sqrt", Function::Sqrt, Shape::Root),
    ("abs", Function::Abs, Shape::Same),
    ("sign", Function::Sign, Shape::Dimensionless),
    ("step", Function::Step, Shape::Dimensionless),
];

/// Functions that are not elementary.
const OTHER_FUNCTIONS: &[&str] = &[
    "dot", "cross", "norm", "unit", "reject", "diag", "rate", "atan2", "hypot", "min", "max",
    "law", "powi", "powf",
];

/// Functions by their names in other programs.
const ELSEWHERE: [(&str, &str); 4] = [
    ("log", "ln"),
    ("der", "rate"),
    ("derivative", "rate"),
    ("diff", "rate"),
];

/// Whether the language has a function of this name.
pub(in crate::model) fn is_function(name: &str) -> bool {
    OTHER_FUNCTIONS.contains(&name) || FUNCTIONS.iter().any(|(known, ..)| *known == name)
}

#[derive(Clone, Copy, PartialEq)]
enum Shape {
    /// Pure number in and out.
    Number,
    /// Square root of the dimension.
    Root,
    /// The dimension stays.
    Same,
    /// Any dimension in, a pure number out.
    Dimensionless,
}

impl Resolver<'_> {
    pub(super) fn call(
        &mut self,
        name: &str,
        span: Span,
        arguments: Vec<&Syntax>,
    ) -> Option<Value> {
        if let Some(&(_, function, shape)) = FUNCTIONS.iter().find(|(known, ..)| *known == name) {
            let [argument] = self.take(arguments, name, span)?;
            return self.elementary(name, function, shape, argument);
        }
        match name {
            "dot" | "cross" => {
                let [a, b] = self.take(arguments, name, span)?;
                let ((a, da), (b, db)) = (self.vector(a)?, self.vector(b)?);
                let dimension = self.product(&a, da, &b, db, Dimension::times);
                if name == "dot" {
                    return Some(Value::Scalar(self.graph.dot(a, b), dimension));
                }
                let product = self.graph.cross(a, b);
                Some(match self.world {
                    World::Planar => Value::Scalar(product[2], dimension),
                    World::Spatial => Value::Vector(product, dimension),
                })
            }
            // The part of a vector that is perpendicular to another.
            "reject" => {
                let [a, from] = self.take(arguments, name, span)?;
                let ((a, dimension), (from, _)) = (self.vector(a)?, self.vector(from)?);
                let (inner, square) = (self.graph.dot(a, from), self.graph.dot(from, from));
                let share = self.graph.div(inner, square);
                let along = self.graph.vector_scale(share, from);
                Some(Value::Vector(self.graph.vector_sub(a, along), dimension))
            }
            "Exactly" if arguments.len() != 1 => self.fail(
                span,
                format!(
                    "`Exactly` takes one value, not {}; a vector is a list, as in `at = Exactly([0.1_m, 0.2_m])`",
                    arguments.len()
                ),
            ),
            "Exactly" => self.fail(
                span,
                "`Exactly` goes around the initial value of a part or `Coordinate`, as in `angle = Exactly(0.4_rad)`; all other values are exact as they are",
            ),
            "diag" if self.world == World::Spatial => {
                let list = self.take::<3>(arguments, name, span)?;
                let zero = self.graph.zero();
                let mut tensor = [[zero; 3]; 3];
                let mut common = None;
                for (k, syntax) in list.into_iter().enumerate() {
                    let (x, dimension) = self.scalar(syntax)?;
                    tensor[k][k] = x;
                    let Ok(dimension) = unify(common, dimension) else {
                        return self.fail(span, "the arguments of `diag` differ in dimension");
                    };
                    common = dimension;
                }
                Some(Value::Tensor(tensor, common))
            }
            "norm" => {
                let [a] = self.take(arguments, name, span)?;
                let (a, dimension) = self.vector(a)?;
                Some(Value::Scalar(self.graph.norm(a), dimension))
            }
            "unit" => {
                let [a] = self.take(arguments, name, span)?;
                let (a, _) = self.vector(a)?;
                Some(Value::Vector(self.graph.unit(a), Some(Dimension::NONE)))
            }
            "rate" => {
                let [a] = self.take(arguments, name, span)?;
                self.rate(a)
            }
            "atan2" | "hypot" | "min" | "max" => {
                let [a, b] = self.take(arguments, name, span)?;
                self.of_two(name, a, b, span)
            }
            "powi" | "powf" => {
                let [base, exponent] = self.take(arguments, name, span)?;
                self.power(base, exponent, name == "powi")
            }
            "law" => self.law_call(arguments, span),
            _ => {
                let hint = match (self.world, name) {
                    (_, "turn") => "; `turn(axis, angle)` stands in `orientation =` only",
                    (World::Spatial, "Cuboid" | "Cylinder" | "Sphere") => {
                        "; a shape stands alone, in `inertia =`"
                    }
                    (World::Planar, "diag" | "Cuboid" | "Cylinder" | "Sphere") => {
                        "; in the plane an inertia is one number"
                    }
                    _ => "",
                };
                if !hint.is_empty() {
                    return self.fail(span, format!("there is no function `{name}`{hint}"));
                }
                let known = FUNCTIONS
                    .iter()
                    .map(|(name, ..)| *name)
                    .chain(OTHER_FUNCTIONS.iter().copied())
                    .filter(|name| *name != "diag" || self.world == World::Spatial);
                let hint = match meant(name, &ELSEWHERE) {
                    Some(own) => format!("; did you mean `{own}`?"),
                    None => did_you_mean(name, known.clone()),
                };
                self.fail(
                    span,
                    format!(
                        "there is no function `{name}`{hint} (functions: {})",
                        known.collect::<Vec<_>>().join(", ")
                    ),
                )
            }
        }
    }

    fn elementary(
        &mut self,
        name: &str,
        function: Function,
        shape: Shape,
        argument: &Syntax,
    ) -> Option<Value> {
        let (x, dimension) = self.scalar(argument)?;
        let result = match (shape, dimension) {
            (Shape::Number, Some(d)) if d != Dimension::NONE => {
                return self.fail(
                    Place::of(argument),
                    format!("`{name}` takes a pure number or an angle, but this is {d}"),
                );
            }
            (Shape::Number, d) => d,
            (Shape::Root, Some(d)) => match d.root() {
                Some(root) => Some(root),
                None => {
                    return self.fail(Place::of(argument), format!("{d} has no square root"));
                }
            },
            (Shape::Root | Shape::Same, d) => d,
            (Shape::Dimensionless, _) => Some(Dimension::NONE),
        };
        Some(Value::Scalar(self.graph.function(function, x), result))
    }

    fn rate(&mut self, a: &Syntax) -> Option<Value> {
        let value = self.evaluate(a)?;
        if is_at_acceleration_level(&value, &self.graph) {
            return self.fail(
                Place::of(a),
                "this has accelerations or reactions, whose rates are not known",
            );
        }
        if value.depends_on(&self.graph, Symbol::is_velocity) {
            self.check_acceleration_level(
                Place::of(a),
                "rate(…) of an expression that has velocities is an acceleration",
            )?;
        }
        let is_input = |symbol| matches!(symbol, Symbol::Input(_));
        if value.depends_on(&self.graph, is_input) {
            let place = self.blame(a, &is_input);
            return self.fail(
                place,
                "this follows an input, whose rate is unknown: take it out of the rate(…), and give its rate by an `Input` of its own",
            );
        }
        let partial = |x: Expr| self.graph.contains_partial(x);
        if value.expressions().into_iter().any(partial) {
            return self.fail(
                Place::of(a),
                "a law gives value and first partials, and this rate needs second ones: write the expression out",
            );
        }
        match value {
            Value::Scalar(x, d) => Some(Value::Scalar(
                self.graph.rate(x),
                d.map(|d| d.over(Dimension::TIME)),
            )),
            Value::Vector(v, d) => Some(Value::Vector(
                self.graph.vector_rate(v),
                d.map(|d| d.over(Dimension::TIME)),
            )),
            Value::Point(point) => Some(Value::Vector(
                self.graph.vector_rate(point.position),
                Some(Dimension::VELOCITY),
            )),
            other => self.fail(Place::of(a), format!("{} has no rate", other.describe())),
        }
    }

    /// The functions of two numbers of the same dimension.
    fn of_two(&mut self, name: &str, a: &Syntax, b: &Syntax, span: Span) -> Option<Value> {
        let ((a, da), (b, db)) = (self.scalar(a)?, self.scalar(b)?);
        let Ok(dimension) = unify(da, db) else {
            return self.fail(
                span,
                format!("the arguments of `{name}` differ in dimension"),
            );
        };
        Some(match name {
            "atan2" => Value::Scalar(self.graph.atan2(a, b), Some(Dimension::NONE)),
            "hypot" => Value::Scalar(self.planar_norm(a, b), dimension),
            "max" => Value::Scalar(self.graph.larger(a, b), dimension),
            _ => Value::Scalar(self.graph.smaller(a, b), dimension),
        })
    }

    fn planar_norm(&mut self, a: Expr, b: Expr) -> Expr {
        let zero = self.graph.zero();
        self.graph.norm([a, b, zero])
    }

    fn power(&mut self, base: &Syntax, exponent: &Syntax, is_whole: bool) -> Option<Value> {
        let (x, dimension) = self.scalar(base)?;
        let (exponent_expr, of_exponent) = self.scalar(exponent)?;
        if let Some(found) = of_exponent.filter(|found| *found != Dimension::NONE) {
            return self.fail(
                Place::of(exponent),
                format!("an exponent is a number without unit, but this is {found}"),
            );
        }
        let Some(exponent_value) = self.graph.as_constant(exponent_expr) else {
            return self.fail(Place::of(exponent), "the exponent must be a number");
        };
        if is_whole && exponent_value.fract() != 0.0 {
            return self.fail(
                Place::of(exponent),
                format!("`powi` takes a whole number; write `powf({exponent_value})`"),
            );
        }
        if exponent_value.abs() > 1000.0 {
            return self.fail(
                Place::of(exponent),
                "this exponent is too large; exponents go up to 1000",
            );
        }
        let dimension = match dimension {
            Some(d) if d != Dimension::NONE => {
                if exponent_value.fract() != 0.0 || exponent_value.abs() > 20.0 {
                    return self.fail(
                        Place::of(exponent),
                        format!("{d} can only be raised to a small integer"),
                    );
                }
                Some(d.power(exponent_value as i8))
            }
            other => other,
        };
        Some(Value::Scalar(
            self.graph.power(x, exponent_value),
            dimension,
        ))
    }

    fn law_call(&mut self, arguments: Vec<&Syntax>, span: Span) -> Option<Value> {
        let Some((path, arguments)) = arguments.split_first() else {
            return self.fail(span, "expected `law(path, argument, …)`");
        };
        if arguments.is_empty() {
            return self.fail(
                span,
                "a law needs at least one argument: `law(path, argument, …)`",
            );
        }
        let values: Option<Vec<_>> = arguments
            .iter()
            .map(|x| self.scalar(x).map(|(expr, _)| expr))
            .collect();
        let law = self.law(path, arguments.len())?;
        let expr = self.graph.law(law, &values?);
        Some(Value::Scalar(expr, None))
    }

    /// Exactly K arguments.
    pub(super) fn take<'s, const K: usize>(
        &mut self,
        arguments: Vec<&'s Syntax>,
        name: &str,
        span: Span,
    ) -> Option<[&'s Syntax; K]> {
        let count = arguments.len();
        match arguments.try_into() {
            Ok(array) => Some(array),
            Err(_) => self.fail(
                span,
                format!(
                    "`{name}` takes {K} argument{}, not {count}",
                    if K == 1 { "" } else { "s" }
                ),
            ),
        }
    }
}
