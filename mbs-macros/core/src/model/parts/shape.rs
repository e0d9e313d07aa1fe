//! Shapes: an inertia for a mass, and what an animation draws.

use crate::model::geometry::Vector;
use crate::symbolic::{Expr, Graph};
use std::f64::consts::TAU;

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
