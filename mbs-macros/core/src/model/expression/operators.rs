//! Signs, lists, and + − * /.

use crate::diagnostics::Place;
use crate::dimension::Dimension;
use crate::model::resolver::Resolver;
use crate::model::value::{Value, unify};
use crate::symbolic::Expr;
use proc_macro2::Span;
use syn::spanned::Spanned;
use syn::{BinOp, Expr as Syntax};

/// What to write for `x ^ 2` and `x ** 2`.
pub(super) const POWERS: &str = "for powers use x.powi(2) or x.powf(1.5)";

/// How an operator between quantities is written, if it compares them.
pub(super) fn comparison(op: &BinOp) -> Option<&'static str> {
    match op {
        BinOp::Eq(_) => Some("=="),
        BinOp::Ne(_) => Some("!="),
        BinOp::Lt(_) => Some("<"),
        BinOp::Le(_) => Some("<="),
        BinOp::Gt(_) => Some(">"),
        BinOp::Ge(_) => Some(">="),
        _ => None,
    }
}

impl Resolver<'_> {
    pub(super) fn negate(&mut self, value: Value, place: Place) -> Option<Value> {
        match self.placed(value) {
            Value::Scalar(x, dimension) => Some(Value::Scalar(self.graph.neg(x), dimension)),
            Value::Vector(v, dimension) => {
                Some(Value::Vector(v.map(|x| self.graph.neg(x)), dimension))
            }
            Value::Tensor(rows, dimension) => {
                let rows = rows.map(|row| row.map(|x| self.graph.neg(x)));
                Some(Value::Tensor(rows, dimension))
            }
            other => self.fail(place, format!("{} has no negative", other.describe())),
        }
    }

    pub(super) fn list(&mut self, items: Vec<Value>, place: Place) -> Option<Value> {
        if items.is_empty() {
            return self.fail(place, "this list is empty");
        }
        // As many scalars of one dimension as space has are a vector; three vectors in space are the rows of a tensor.
        // (A list of conditions may mix dimensions. The user of the value decides.)
        if items.len() != self.world.dimension() {
            return Some(Value::List(items));
        }
        let zero = self.graph.zero();
        let mut vector = [zero; 3];
        let mut rows = [[zero; 3]; 3];
        let mut common: Option<Dimension> = None;
        let (mut scalars, mut vectors) = (0, 0);
        for (slot, item) in items.iter().enumerate() {
            let dimension = match item {
                Value::Scalar(x, dimension) => {
                    vector[slot] = *x;
                    scalars += 1;
                    *dimension
                }
                Value::Vector(v, dimension) => {
                    rows[slot] = *v;
                    vectors += 1;
                    *dimension
                }
                _ => return Some(Value::List(items)),
            };
            match unify(common, dimension) {
                Ok(dimension) => common = dimension,
                Err(()) => return Some(Value::List(items)),
            }
        }
        Some(match (scalars == items.len(), vectors) {
            (true, _) => Value::Vector(vector, common),
            (_, 3) => Value::Tensor(rows, common),
            _ => Value::List(items),
        })
    }

    /// A value in a sum, a product or a negative, where a point stands for its position.
    pub(super) fn placed(&mut self, value: Value) -> Value {
        match value {
            Value::Point(point) => Value::Vector(self.position(&point), Some(Dimension::LENGTH)),
            other => other,
        }
    }

    pub(super) fn combine(
        &mut self,
        left: Value,
        op: &BinOp,
        right: Value,
        syntax: &Syntax,
    ) -> Option<Value> {
        let [left, right] = [left, right].map(|value| self.placed(value));
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
            (BinOp::Mul(_), Value::Scalar(x, a), Value::Tensor(y, b))
            | (BinOp::Mul(_), Value::Tensor(y, b), Value::Scalar(x, a)) => {
                let dimension = self.product(&[*x], *a, y.as_flattened(), *b, Dimension::times);
                let scaled = y.map(|row| self.graph.vector_scale(*x, row));
                Some(Value::Tensor(scaled, dimension))
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
                format!("only + − * / can combine quantities; {POWERS}"),
            ),
        }
    }

    /// Refuses an equation or an inequality between quantities.
    pub(super) fn compared<T>(&mut self, operator: &str, place: Place) -> Option<T> {
        self.fail(
            place,
            format!(
                "quantities are not compared: write the difference `a - b` in place of `a {operator} b`; a condition holds it at zero, and an event is where it passes through zero"
            ),
        )
    }

    fn mismatch(&mut self, span: Span, left: &Value, right: &Value) -> Option<Value> {
        self.fail(
            span,
            format!(
                "dimensions differ: {} against {}",
                left.with_unit(),
                right.with_unit()
            ),
        )
    }

    /// The dimension of a product or quotient. A bare literal counts as a pure number there (two of them stay bare); a
    /// parameter declared without unit may be anything, and so may its products.
    pub(super) fn product(
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
