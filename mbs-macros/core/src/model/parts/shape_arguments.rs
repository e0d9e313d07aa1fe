//! Shapes as they are declared, and their inertia.

use super::shape::Shape;
use crate::diagnostics::{Place, nearest};
use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::geometry::Tensor;
use crate::model::requirements::Wanted;
use crate::model::value::Value;
use crate::symbolic::Expr;
use syn::Expr as Syntax;

const POSITIVE_SIZE: &str = "the size of a shape has to be positive";

impl Arguments<'_, '_> {
    /// `shape =`, for pictures only.
    pub(super) fn drawn_shape(&mut self) -> Option<Option<Shape>> {
        let Some(syntax) = self.syntax("shape") else {
            return Some(None);
        };
        match self.shape("shape", syntax) {
            Some(shape) => Some(Some(shape?)),
            None => self.fail(
                "shape",
                "expected `Cuboid(x, y, z)`, `Cylinder(radius, length, axis)` or `Sphere(radius)`",
            ),
        }
    }

    /// The shape that this calls, if it calls one; the inner `None` after an error.
    pub(super) fn shape(&mut self, field: &str, syntax: &Syntax) -> Option<Option<Shape>> {
        let Syntax::Call(call) = syntax else {
            return None;
        };
        let Syntax::Path(path) = &*call.func else {
            return None;
        };
        let name = path.path.get_ident()?.to_string();
        let name = name.as_str();
        let (usage, counts) = match name {
            "Cuboid" => ("Cuboid(x, y, z)", 3..=3),
            "Cylinder" => (
                "Cylinder(radius, length) or Cylinder(radius, length, axis)",
                2..=3,
            ),
            "Sphere" => ("Sphere(radius)", 1..=1),
            // Functions begin with a small letter.
            _ if name.starts_with(char::is_uppercase) => {
                let meant = nearest(name, ["Cuboid", "Cylinder", "Sphere"])?;
                return Some(self.fail_at(
                    Place::of(path),
                    format!("there is no shape `{name}`; did you mean `{meant}`? (shapes: Cuboid(x, y, z), Cylinder(radius, length), Sphere(radius))"),
                ));
            }
            _ => return None,
        };
        let named = call
            .args
            .iter()
            .any(|argument| matches!(argument, Syntax::Assign(_)));
        if named || !counts.contains(&call.args.len()) {
            return Some(self.fail_at(Place::of(call), format!("expected `{usage}`")));
        }
        let lengths = match name {
            "Cylinder" => 2,
            _ => call.args.len(),
        };
        let mut sizes = Vec::new();
        for argument in call.args.iter().take(lengths) {
            match self.positive_length(field, argument) {
                Some(size) => sizes.push(size),
                None => return Some(None),
            }
        }
        Some(match (name, sizes.as_slice()) {
            ("Cuboid", &[x, y, z]) => Some(Shape::Cuboid([x, y, z])),
            ("Cylinder", &[radius, length]) => {
                let axis = match call.args.get(2) {
                    None => Some(2),
                    Some(axis) => self.axis_index(axis),
                };
                axis.map(|axis| Shape::Cylinder(radius, length, axis))
            }
            (_, sizes) => sizes.first().map(|&radius| Shape::Sphere(radius)),
        })
    }

    /// `X`, `Y` or `Z`.
    fn axis_index(&mut self, syntax: &Syntax) -> Option<usize> {
        let found = match syntax {
            Syntax::Path(path) => ["X", "Y", "Z"]
                .iter()
                .position(|axis| path.path.is_ident(axis)),
            _ => None,
        };
        match found {
            Some(axis) => Some(axis),
            None => self.fail_at(
                Place::of(syntax),
                "the axis of a cylinder is `X`, `Y` or `Z`",
            ),
        }
    }

    fn positive_length(&mut self, field: &str, syntax: &Syntax) -> Option<Expr> {
        let (expr, dimension) = match self.evaluate(syntax)? {
            Value::Scalar(x, dimension) => (x, dimension),
            other => {
                let what = other.describe();
                return self.fail_at(
                    Place::of(syntax),
                    format!("the size of a shape is a length, but this is {what}"),
                );
            }
        };
        self.check_dimension("size", dimension, Dimension::LENGTH, Place::of(syntax))?;
        self.check_known("size", syntax, &[expr])?;
        if self.by_default(expr) <= 0.0 {
            return self.fail_at(Place::of(syntax), POSITIVE_SIZE);
        }
        self.require(field, &[expr], Wanted::Positive(POSITIVE_SIZE));
        Some(expr)
    }

    pub(super) fn shape_inertia(&mut self, shape: Shape, mass: Expr) -> Tensor {
        let graph = self.graph();
        let mut part = |factor: f64, squares: &[(Expr, f64)]| {
            let terms: Vec<_> = squares
                .iter()
                .map(|&(x, weight)| (graph.square(x), weight))
                .collect();
            let sum = graph.linear(0.0, &terms);
            let product = graph.mul(mass, sum);
            graph.scale(factor, product)
        };
        let moments = match shape {
            Shape::Cuboid([x, y, z]) => {
                [[y, z], [z, x], [x, y]].map(|[a, b]| part(1.0 / 12.0, &[(a, 1.0), (b, 1.0)]))
            }
            Shape::Cylinder(radius, length, axis) => {
                let along = part(0.5, &[(radius, 1.0)]);
                let across = part(1.0 / 12.0, &[(radius, 3.0), (length, 1.0)]);
                std::array::from_fn(|k| if k == axis { along } else { across })
            }
            Shape::Sphere(radius) => [part(0.4, &[(radius, 1.0)]); 3],
        };
        self.diagonal(moments)
    }
}
