//! Shapes: an inertia for a mass, and what an animation draws.

use super::Tensor;
use crate::diagnostics::{Place, nearest};
use crate::model::value::Value;
use crate::model::{Arguments, Dimension, Vector};
use crate::symbolic::{Expr, Graph};
use std::f64::consts::TAU;
use syn::Expr as Syntax;

/// Points of a circle.
const CIRCLE: usize = 24;

/// A shape about the centre of mass; all in parameters.
#[derive(Debug, Clone, Copy)]
pub enum Shape {
    /// Edges along the axes.
    Cuboid([Expr; 3]),
    /// Radius, length, and the index of its axis.
    Cylinder(Expr, Expr, usize),
    /// Radius.
    Sphere(Expr),
}

impl Shape {
    /// Corners from the centre, and edges between them.
    pub(in crate::model) fn wireframe(
        self,
        graph: &mut Graph,
    ) -> (Vec<Vector>, Vec<(usize, usize)>) {
        match self {
            Shape::Cuboid(edges) => {
                let corner = |index: usize, graph: &mut Graph| {
                    std::array::from_fn(|k| {
                        let side = if index >> k & 1 == 1 { 0.5 } else { -0.5 };
                        graph.scale(side, edges[k])
                    })
                };
                let corners = (0..8).map(|index| corner(index, graph)).collect();
                let pairs = (0..8).flat_map(|a| (0..3).map(move |k| (a, a | 1 << k)));
                (corners, pairs.filter(|(a, b)| a != b).collect())
            }
            Shape::Cylinder(radius, length, axis) => {
                let mut corners = circle(graph, radius, axis, length, -0.5);
                corners.extend(circle(graph, radius, axis, length, 0.5));
                let mut edges = ring(0);
                edges.extend(ring(CIRCLE));
                // A few lines along it and across its ends, so that its turning can be seen.
                edges.extend((0..CIRCLE).step_by(CIRCLE / 4).map(|k| (k, CIRCLE + k)));
                edges.extend([0, CIRCLE].map(|end| (end, end + CIRCLE / 2)));
                (corners, edges)
            }
            Shape::Sphere(radius) => {
                let zero = graph.zero();
                let (mut corners, mut edges) = (Vec::new(), Vec::new());
                for axis in 0..3 {
                    edges.extend(ring(corners.len()));
                    corners.extend(circle(graph, radius, axis, zero, 0.0));
                }
                (corners, edges)
            }
        }
    }
}

/// A circle about an axis, at a part of the length along it.
fn circle(graph: &mut Graph, radius: Expr, axis: usize, length: Expr, part: f64) -> Vec<Vector> {
    let along = graph.scale(part, length);
    let mut points = Vec::new();
    for k in 0..CIRCLE {
        let (sin, cos) = (TAU * k as f64 / CIRCLE as f64).sin_cos();
        // Quarter turns are exact, so that their zeros fold.
        let [sin, cos] = [sin, cos].map(|x| if x.abs() < 1e-12 { 0.0 } else { x });
        let mut point = [along; 3];
        point[(axis + 1) % 3] = graph.scale(cos, radius);
        point[(axis + 2) % 3] = graph.scale(sin, radius);
        points.push(point);
    }
    points
}

/// The edges of a circle whose points begin at `first`.
fn ring(first: usize) -> Vec<(usize, usize)> {
    (0..CIRCLE)
        .map(|k| (first + k, first + (k + 1) % CIRCLE))
        .collect()
}

impl Arguments<'_, '_> {
    /// `shape =`, for pictures only.
    pub(super) fn drawn_shape(&mut self) -> Option<Option<Shape>> {
        let Some(syntax) = self.syntax("shape") else {
            return Some(None);
        };
        match self.shape(syntax) {
            Some(shape) => Some(Some(shape?)),
            None => self.fail(
                "shape",
                "expected `Cuboid(x, y, z)`, `Cylinder(radius, length, axis)` or `Sphere(radius)`",
            ),
        }
    }

    /// The shape that this calls, if it calls one; the inner `None` after an error.
    pub(super) fn shape(&mut self, syntax: &Syntax) -> Option<Option<Shape>> {
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
            match self.positive_length(argument) {
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

    fn positive_length(&mut self, syntax: &Syntax) -> Option<Expr> {
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
            return self.fail_at(Place::of(syntax), "the size of a shape is positive");
        }
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
