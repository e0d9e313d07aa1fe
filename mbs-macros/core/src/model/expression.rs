//! Expressions of the declaration → symbolic values, with dimensions.

use super::dimension::{Dimension, UNITS, unit};
use super::geometry::{Owner, Point};
use super::resolve::Resolver;
use super::value::{Value, unify};
use crate::diagnostics::{Place, did_you_mean};
use crate::symbolic::{Expr, Function, Node, Symbol};
use crate::syntax::{MAX_DEPTH, TOO_DEEP};
use proc_macro2::Span;
use syn::spanned::Spanned;
use syn::{BinOp, Expr as Syntax, Lit, Member, UnOp};

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
    "dot", "cross", "norm", "unit", "rate", "atan2", "hypot", "min", "max", "law", "powi", "powf",
];

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
    /// The value of an expression; `None` after recording what is wrong with it.
    pub(super) fn evaluate(&mut self, syntax: &Syntax) -> Option<Value> {
        if self.depth > MAX_DEPTH {
            return self.fail(Place::of(syntax), TOO_DEEP);
        }
        self.depth += 1;
        let value = self.evaluate_any(syntax);
        self.depth -= 1;
        let value = value?;
        let finite = |x: Expr| match *self.graph.node(x) {
            Node::Constant(number) => number.value().is_finite(),
            Node::Sum {
                constant,
                ref terms,
            } => {
                let coefficients = terms.iter().map(|&(_, coefficient)| coefficient);
                coefficients
                    .chain([constant])
                    .all(|number| number.value().is_finite())
            }
            // Where these have a value, they have become that number.
            Node::Function(_, x) | Node::Power(x, _) => self.graph.as_constant(x).is_none(),
            _ => true,
        };
        if !value.expressions().into_iter().all(finite) {
            return self.fail(
                Place::of(syntax),
                "the result of this is no finite number; check its arguments",
            );
        }
        Some(value)
    }

    fn evaluate_any(&mut self, syntax: &Syntax) -> Option<Value> {
        match syntax {
            Syntax::Paren(inner) => self.evaluate(&inner.expr),
            Syntax::Group(inner) => self.evaluate(&inner.expr),
            Syntax::Lit(literal) => self.literal(&literal.lit),
            Syntax::Path(path) => match path.path.get_ident() {
                Some(name) => self.lookup(&name.to_string(), name.span()),
                None => self.fail(
                    Place::of(path),
                    "only names of this mechanism can stand here; paths go into `law(path, …)`",
                ),
            },
            Syntax::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => {
                let value = self.evaluate(&unary.expr)?;
                self.negate(value, Place::of(unary))
            }
            Syntax::Binary(binary) => {
                let (left, right) = (self.evaluate(&binary.left), self.evaluate(&binary.right));
                self.combine(left?, &binary.op, right?, syntax)
            }
            Syntax::Array(array) => {
                let items: Vec<_> = array.elems.iter().map(|item| self.evaluate(item)).collect();
                let items: Option<Vec<_>> = items.into_iter().collect();
                self.list(items?, Place::of(array))
            }
            Syntax::Call(call) => match &*call.func {
                Syntax::Path(path) if path.path.get_ident().is_some() => {
                    let name = path
                        .path
                        .get_ident()
                        .map(ToString::to_string)
                        .unwrap_or_default();
                    self.call(&name, path.span(), call.args.iter().collect())
                }
                other => self.fail(Place::of(other), "expected the name of a function"),
            },
            Syntax::MethodCall(call) => {
                let name = call.method.to_string();
                if name == "point" || name == "velocity_at" {
                    let arguments: Vec<_> = call.args.iter().collect();
                    return self.frame_method(
                        &call.receiver,
                        &name,
                        call.method.span(),
                        &arguments,
                    );
                }
                let mut arguments = vec![&*call.receiver];
                arguments.extend(&call.args);
                self.call(&name, call.method.span(), arguments)
            }
            Syntax::Field(field) => {
                let value = self.evaluate(&field.base)?;
                match &field.member {
                    Member::Named(name) => self.member(&value, &name.to_string(), name.span()),
                    Member::Unnamed(index) => {
                        self.fail(index.span, "expected a name after the dot")
                    }
                }
            }
            other => self.fail(
                Place::of(other),
                "this cannot be part of an expression here",
            ),
        }
    }

    /// A scalar with its dimension.
    pub(super) fn scalar(&mut self, syntax: &Syntax) -> Option<(Expr, Option<Dimension>)> {
        match self.evaluate(syntax)? {
            Value::Scalar(expr, dimension) => Some((expr, dimension)),
            other => self.fail(
                Place::of(syntax),
                format!("expected a number, but this is {}", other.describe()),
            ),
        }
    }

    fn literal(&mut self, literal: &Lit) -> Option<Value> {
        let (digits, suffix) = match literal {
            Lit::Float(number) => (
                number.base10_digits().to_owned(),
                number.suffix().to_owned(),
            ),
            Lit::Int(number) => (
                number.base10_digits().to_owned(),
                number.suffix().to_owned(),
            ),
            other => return self.fail(Place::of(other), "expected a number"),
        };
        let number = match digits.parse::<f64>() {
            Ok(number) if number.is_finite() => number,
            _ => {
                return self.fail(
                    Place::of(literal),
                    "this number is too large; numbers go up to 1e308",
                );
            }
        };
        if suffix.is_empty() {
            let expr = self.graph.constant(number);
            return Some(Value::Scalar(expr, None));
        }
        let Some((factor, dimension)) = unit(&suffix) else {
            let name = suffix.trim_start_matches('_');
            let known = UNITS.iter().map(|(name, ..)| *name);
            let hint = did_you_mean(name, known.clone());
            return self.fail(
                Place::of(literal),
                format!(
                    "there is no unit `{name}`{hint} (units: {}; joined by `_`, divided after `per`, as in `9.81_m_per_s2`)",
                    known.collect::<Vec<_>>().join(", ")
                ),
            );
        };
        let expr = self.graph.constant(number * factor);
        Some(Value::Scalar(expr, Some(dimension)))
    }

    fn negate(&mut self, value: Value, place: Place) -> Option<Value> {
        match value {
            Value::Scalar(x, dimension) => Some(Value::Scalar(self.graph.neg(x), dimension)),
            Value::Vector([x, y], dimension) => Some(Value::Vector(
                [self.graph.neg(x), self.graph.neg(y)],
                dimension,
            )),
            other => self.fail(place, format!("{} has no negative", other.describe())),
        }
    }

    fn list(&mut self, items: Vec<Value>, place: Place) -> Option<Value> {
        match items.as_slice() {
            [Value::Scalar(x, a), Value::Scalar(y, b)] => match unify(*a, *b) {
                Ok(dimension) => Some(Value::Vector([*x, *y], dimension)),
                // A list of conditions may mix dimensions; a vector may not. The user of the value decides.
                Err(()) => Some(Value::List(items)),
            },
            [] => self.fail(place, "this list is empty"),
            _ => Some(Value::List(items)),
        }
    }

    fn combine(&mut self, left: Value, op: &BinOp, right: Value, syntax: &Syntax) -> Option<Value> {
        // A point in a sum stands for its position.
        let position = |value: Value| match value {
            Value::Point(point) => Value::Vector(point.position, Some(Dimension::LENGTH)),
            other => other,
        };
        let (left, right) = (position(left), position(right));
        let span = op.span();
        match (op, &left, &right) {
            (BinOp::Add(_) | BinOp::Sub(_), Value::Scalar(x, a), Value::Scalar(y, b)) => {
                let Ok(dimension) = unify(*a, *b) else {
                    return self.mismatch(span, &left, &right);
                };
                let sum = if matches!(op, BinOp::Add(_)) {
                    self.graph.add(*x, *y)
                } else {
                    self.graph.sub(*x, *y)
                };
                Some(Value::Scalar(sum, dimension))
            }
            (BinOp::Add(_) | BinOp::Sub(_), Value::Vector(x, a), Value::Vector(y, b)) => {
                let Ok(dimension) = unify(*a, *b) else {
                    return self.mismatch(span, &left, &right);
                };
                let sum = if matches!(op, BinOp::Add(_)) {
                    self.graph.vector_add(*x, *y)
                } else {
                    self.graph.vector_sub(*x, *y)
                };
                Some(Value::Vector(sum, dimension))
            }
            (BinOp::Mul(_), Value::Scalar(x, a), Value::Scalar(y, b)) => {
                let dimension = self.product(&[*x], *a, &[*y], *b, Dimension::times);
                Some(Value::Scalar(self.graph.mul(*x, *y), dimension))
            }
            (BinOp::Mul(_), Value::Scalar(x, a), Value::Vector(y, b))
            | (BinOp::Mul(_), Value::Vector(y, b), Value::Scalar(x, a)) => {
                let dimension = self.product(&[*x], *a, y, *b, Dimension::times);
                Some(Value::Vector(self.graph.vector_scale(*x, *y), dimension))
            }
            (BinOp::Div(_), _, Value::Scalar(y, _)) if self.graph.is_zero(*y) => {
                self.fail(Place::of(syntax), "division by zero")
            }
            (BinOp::Div(_), Value::Scalar(x, a), Value::Scalar(y, b)) => {
                let dimension = self.product(&[*x], *a, &[*y], *b, Dimension::over);
                Some(Value::Scalar(self.graph.div(*x, *y), dimension))
            }
            (BinOp::Div(_), Value::Vector(x, a), Value::Scalar(y, b)) => {
                let one = self.graph.one();
                let inverse = self.graph.div(one, *y);
                let dimension = self.product(x, *a, &[*y], *b, Dimension::over);
                Some(Value::Vector(
                    self.graph.vector_scale(inverse, *x),
                    dimension,
                ))
            }
            (BinOp::Mul(_), Value::Vector(..), Value::Vector(..)) => self.fail(
                span,
                "two vectors have no `*`; use dot(a, b) or cross(a, b)",
            ),
            (BinOp::Add(_) | BinOp::Sub(_) | BinOp::Mul(_) | BinOp::Div(_), ..) => self.fail(
                span,
                format!(
                    "{} and {} cannot be combined here",
                    left.describe(),
                    right.describe()
                ),
            ),
            _ => self.fail(
                span,
                "only + − * / can combine quantities; for powers use x.powi(2) or x.powf(1.5)",
            ),
        }
    }

    fn mismatch(&mut self, span: Span, left: &Value, right: &Value) -> Option<Value> {
        self.fail(
            span,
            format!(
                "dimensions differ: {} against {}",
                left.describe(),
                right.describe()
            ),
        )
    }

    fn call(&mut self, name: &str, span: Span, arguments: Vec<&Syntax>) -> Option<Value> {
        if let Some((_, function, shape)) = FUNCTIONS.iter().find(|(known, ..)| *known == name) {
            let [argument] = self.take(arguments, name, span)?;
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
            return Some(Value::Scalar(self.graph.function(*function, x), result));
        }
        match name {
            "dot" | "cross" => {
                let [a, b] = self.take(arguments, name, span)?;
                let ((a, da), (b, db)) = (self.vector(a)?, self.vector(b)?);
                let result = if name == "dot" {
                    self.graph.dot(a, b)
                } else {
                    self.graph.cross(a, b)
                };
                let dimension = self.product(&a, da, &b, db, Dimension::times);
                Some(Value::Scalar(result, dimension))
            }
            "norm" => {
                let [a] = self.take(arguments, name, span)?;
                let (a, dimension) = self.vector(a)?;
                Some(Value::Scalar(self.graph.norm(a), dimension))
            }
            "unit" => {
                let [a] = self.take(arguments, name, span)?;
                let (a, _) = self.vector(a)?;
                let one = self.graph.one();
                let norm = self.graph.norm(a);
                let inverse = self.graph.div(one, norm);
                Some(Value::Vector(
                    self.graph.vector_scale(inverse, a),
                    Some(Dimension::NONE),
                ))
            }
            "rate" => {
                let [a] = self.take(arguments, name, span)?;
                let value = self.evaluate(a)?;
                if value
                    .expressions()
                    .into_iter()
                    .any(|x| self.graph.depends_on(x, Symbol::is_velocity))
                {
                    return self.fail(Place::of(a), "rate(…) of an expression that has velocities would be an acceleration; accelerations cannot appear in a declaration");
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
            "atan2" | "hypot" | "min" | "max" => {
                let [a, b] = self.take(arguments, name, span)?;
                let ((a, da), (b, db)) = (self.scalar(a)?, self.scalar(b)?);
                let Ok(dimension) = unify(da, db) else {
                    return self.fail(
                        span,
                        format!("the arguments of `{name}` differ in dimension"),
                    );
                };
                Some(match name {
                    "atan2" => Value::Scalar(self.graph.atan2(a, b), Some(Dimension::NONE)),
                    "hypot" => Value::Scalar(self.graph.norm([a, b]), dimension),
                    // max(a, b) = b + (a − b) step(a − b)
                    _ => {
                        let difference = if name == "max" {
                            self.graph.sub(a, b)
                        } else {
                            self.graph.sub(b, a)
                        };
                        let step = self.graph.function(Function::Step, difference);
                        let forward = self.graph.sub(a, b);
                        let change = self.graph.mul(forward, step);
                        Value::Scalar(self.graph.add(b, change), dimension)
                    }
                })
            }
            "powi" | "powf" => {
                let [base, exponent] = self.take(arguments, name, span)?;
                let (x, dimension) = self.scalar(base)?;
                let (exponent_expr, _) = self.scalar(exponent)?;
                let Some(exponent_value) = self.graph.as_constant(exponent_expr) else {
                    return self.fail(Place::of(exponent), "the exponent must be a number");
                };
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
            "law" => self.law_call(arguments, span),
            _ => {
                let known = FUNCTIONS
                    .iter()
                    .map(|(name, ..)| *name)
                    .chain(OTHER_FUNCTIONS.iter().copied());
                let hint = did_you_mean(name, known.clone());
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

    fn take<'s, const K: usize>(
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

    /// A vector, or a point as its position.
    pub(super) fn vector(&mut self, syntax: &Syntax) -> Option<(super::Vector, Option<Dimension>)> {
        match self.evaluate(syntax)? {
            Value::Vector(v, dimension) => Some((v, dimension)),
            Value::Point(point) => Some((point.position, Some(Dimension::LENGTH))),
            other => self.fail(
                Place::of(syntax),
                format!("expected a vector [x, y], but this is {}", other.describe()),
            ),
        }
    }

    fn frame_method(
        &mut self,
        receiver: &Syntax,
        name: &str,
        span: Span,
        arguments: &[&Syntax],
    ) -> Option<Value> {
        let value = self.evaluate(receiver)?;
        let Value::Frame(owner) = value else {
            return self.fail(
                Place::of(receiver),
                format!(
                    "`{name}` belongs to parts and the ground, but this is {}",
                    value.describe()
                ),
            );
        };
        if name == "point" {
            let [x, y] = self.take(arguments.to_vec(), name, span)?;
            let ((x, dx), (y, dy)) = (self.scalar(x)?, self.scalar(y)?);
            for (dimension, argument) in [(dx, arguments[0]), (dy, arguments[1])] {
                if dimension.is_some_and(|d| d != Dimension::LENGTH) {
                    return self.fail(
                        Place::of(argument),
                        "the coordinates of a point are lengths (m)",
                    );
                }
            }
            for (expr, argument) in [(x, arguments[0]), (y, arguments[1])] {
                if self
                    .graph
                    .depends_on(expr, |symbol| !symbol.is_parameter_like())
                {
                    return self.fail(
                        Place::of(argument),
                        "a point is fixed in its part: its coordinates may use parameters only",
                    );
                }
            }
            let label = format!(
                "{}.point({}, {})",
                self.owner_name(owner),
                self.graph.text(x),
                self.graph.text(y)
            );
            return Some(Value::Point(self.point_of(owner, [x, y], label)));
        }
        let [at] = self.take(arguments.to_vec(), name, span)?;
        let (at, _) = self.vector(at)?;
        let frame = self.frame(owner);
        let arm = self.graph.vector_sub(at, frame.origin);
        let turned = self.graph.perpendicular(arm);
        let swing = self.graph.vector_scale(frame.rate, turned);
        let velocity = self.graph.vector_rate(frame.origin);
        Some(Value::Vector(
            self.graph.vector_add(velocity, swing),
            Some(Dimension::VELOCITY),
        ))
    }

    fn member(&mut self, value: &Value, member: &str, span: Span) -> Option<Value> {
        match (value, member) {
            (Value::Point(point), "x" | "y") => {
                let slot = usize::from(member == "y");
                Some(Value::Scalar(point.position[slot], Some(Dimension::LENGTH)))
            }
            (Value::Point(point), "velocity") => Some(Value::Vector(
                self.graph.vector_rate(point.position),
                Some(Dimension::VELOCITY),
            )),
            (Value::Point(_), _) => {
                self.unknown_member(value, member, &["x", "y", "velocity"], span)
            }
            (Value::Vector(v, dimension), "x" | "y") => {
                Some(Value::Scalar(v[usize::from(member == "y")], *dimension))
            }
            (Value::Vector(..), _) => self.unknown_member(value, member, &["x", "y"], span),
            (Value::Scalar(x, dimension), "rate") => match self.graph.node(*x) {
                crate::symbolic::Node::Symbol(Symbol::LocalPosition(i)) => {
                    let rate = self.graph.symbol(Symbol::LocalVelocity(*i));
                    Some(Value::Scalar(
                        rate,
                        dimension.map(|d| d.over(Dimension::TIME)),
                    ))
                }
                _ => self.fail(
                    span,
                    "only a coordinate has `.rate`; for an expression write rate(…)",
                ),
            },
            (Value::Frame(owner), _) => self.frame_member(*owner, member, span),
            (other, _) => self.fail(span, format!("{} has no `{member}`", other.describe())),
        }
    }

    fn frame_member(&mut self, owner: Owner, member: &str, span: Span) -> Option<Value> {
        if let Some(point) = self.named_point(owner, member) {
            return Some(Value::Point(point));
        }
        let frame = self.frame(owner);
        match member {
            "x" => Some(Value::Vector(frame.axis, Some(Dimension::NONE))),
            "y" => Some(Value::Vector(
                self.graph.perpendicular(frame.axis),
                Some(Dimension::NONE),
            )),
            "rate" => Some(Value::Scalar(frame.rate, Some(Dimension::RATE))),
            "velocity" => Some(Value::Vector(
                self.graph.vector_rate(frame.origin),
                Some(Dimension::VELOCITY),
            )),
            "angle" => {
                let angle = match frame.angle {
                    Some(angle) => angle,
                    None => self.graph.atan2(frame.axis[1], frame.axis[0]),
                };
                Some(Value::Scalar(angle, Some(Dimension::NONE)))
            }
            "length" if self.bar_length(owner).is_some() => self
                .bar_length(owner)
                .map(|length| Value::Scalar(length, Some(Dimension::LENGTH))),
            _ => {
                let mut known: Vec<&str> = self.point_names(owner).to_vec();
                known.extend(["angle", "rate", "velocity", "x", "y"]);
                self.unknown_member(&Value::Frame(owner), member, &known, span)
            }
        }
    }

    fn unknown_member(
        &mut self,
        value: &Value,
        member: &str,
        known: &[&str],
        span: Span,
    ) -> Option<Value> {
        let what = match value {
            Value::Frame(owner) => format!("`{}`", self.owner_name(*owner)),
            other => other.describe(),
        };
        let hint = did_you_mean(member, known.iter().copied());
        self.fail(
            span,
            format!(
                "{what} has no `{member}`{hint} (it has: {})",
                known.join(", ")
            ),
        )
    }

    /// The smallest subexpression for whose value `predicate` holds.
    pub(super) fn blame(&mut self, syntax: &Syntax, predicate: &dyn Fn(Symbol) -> bool) -> Place {
        let children: Vec<&Syntax> = match syntax {
            Syntax::Paren(inner) => vec![&inner.expr],
            Syntax::Unary(unary) => vec![&unary.expr],
            Syntax::Binary(binary) => vec![&binary.left, &binary.right],
            Syntax::Array(array) => array.elems.iter().collect(),
            Syntax::Call(call) => call.args.iter().collect(),
            Syntax::MethodCall(call) => {
                std::iter::once(&*call.receiver).chain(&call.args).collect()
            }
            _ => Vec::new(),
        };
        for child in children {
            if let Some(value) = self.silently(|resolver| resolver.evaluate(child))
                && value
                    .expressions()
                    .into_iter()
                    .any(|x| self.graph.depends_on(x, predicate))
            {
                return self.blame(child, predicate);
            }
        }
        Place::of(syntax)
    }

    /// A point of a part or of the ground given by its local coordinates.
    pub(super) fn point_of(&mut self, owner: Owner, local: super::Vector, label: String) -> Point {
        let frame = self.frame(owner);
        let offset = self.graph.turn(frame.axis, local);
        let position = self.graph.vector_add(frame.origin, offset);
        Point {
            position,
            owner,
            local,
            free: None,
            label,
        }
    }

    /// The dimension of a product or quotient. A bare literal counts as a pure number there (two of them stay bare); a
    /// parameter declared without unit may be anything, and so may its products.
    fn product(
        &self,
        a: &[Expr],
        da: Option<Dimension>,
        b: &[Expr],
        db: Option<Dimension>,
        combine: impl Fn(Dimension, Dimension) -> Dimension,
    ) -> Option<Dimension> {
        let pure = |x: &[Expr]| x.iter().all(|&x| self.graph.as_constant(x).is_some());
        match (da, db) {
            (Some(a), Some(b)) => Some(combine(a, b)),
            (Some(known), None) if pure(b) => Some(combine(known, Dimension::NONE)),
            (None, Some(known)) if pure(a) => Some(combine(Dimension::NONE, known)),
            _ => None,
        }
    }
}
