//! Orientations in the home pose: turns, a quaternion, two axes, or those of another part.

use super::Arguments;
use crate::diagnostics::Place;
use crate::dimension::Dimension;
use crate::model::value::Value;
use crate::model::{Axes, Vector};
use crate::symbolic::{Expr, Graph};
use syn::{Expr as Syntax, ExprCall};

const EXPECTED: &str = "expected `turn(axis, angle)`, such as `turn(Z, 30.0_deg)`, `quaternion(w, x, y, z)`, `axes(x, y)`, a part, or a list of these";

/// Axes nearer than this to parallel, by the square of their sine, span no plane.
const PARALLEL: f64 = 1e-12;

impl Arguments<'_, '_> {
    /// The axes of an orientation, or of a list of them, each in the axes that those before have turned.
    pub fn orientation(&mut self, field: &str) -> Option<Axes> {
        let mut axes = self.graph().ground_axes();
        let Some(syntax) = self.syntax(field) else {
            return Some(axes);
        };
        let parts: Vec<&Syntax> = match syntax {
            Syntax::Array(list) => list.elems.iter().collect(),
            single => vec![single],
        };
        for part in parts {
            let next = self.at_home(|arguments| arguments.rotation(field, part))?;
            axes = match next {
                Rotation::About(axis, angle) => self.graph().turned_about(&axes, axis, angle),
                Rotation::Axes(inner) => self.graph().compose(&axes, &inner),
            };
        }
        Some(axes)
    }

    fn rotation(&mut self, field: &str, syntax: &Syntax) -> Option<Rotation> {
        let Syntax::Call(call) = syntax else {
            return match self.resolver.evaluate(syntax)? {
                Value::Frame(owner) => Some(Rotation::Axes(self.resolver.home(owner).axes)),
                _ => self.resolver.fail(Place::of(syntax), EXPECTED),
            };
        };
        let name = match &*call.func {
            Syntax::Path(path) => path.path.get_ident().map(ToString::to_string),
            _ => None,
        };
        match (name.as_deref(), call.args.len()) {
            (Some("turn"), 2) => {
                let axis = self.direction_of(field, &call.args[0])?;
                let angle = self.pure_number(field, &call.args[1])?;
                Some(Rotation::About(axis, angle))
            }
            (Some("quaternion"), 4) => self.quaternion(field, call).map(Rotation::Axes),
            (Some("axes"), 2) => self.two_axes(field, call).map(Rotation::Axes),
            _ => self.resolver.fail(Place::of(syntax), EXPECTED),
        }
    }

    fn pure_number(&mut self, field: &str, syntax: &Syntax) -> Option<Expr> {
        let (number, dimension) = self.resolver.scalar(syntax)?;
        self.check_dimension(field, dimension, Dimension::NONE, Place::of(syntax))?;
        self.check_known(field, syntax, &[number])?;
        Some(number)
    }

    /// The axes of q/|q|.
    fn quaternion(&mut self, field: &str, call: &ExprCall) -> Option<Axes> {
        let mut numbers = Vec::new();
        for argument in &call.args {
            numbers.push(self.pure_number(field, argument)?);
        }
        let q: [Expr; 4] = numbers.try_into().ok()?;
        if q.iter().all(|&x| self.by_default(x) == 0.0) {
            return self.resolver.fail(
                Place::of(call),
                "the quaternion 0 is no rotation; for none write quaternion(1.0, 0.0, 0.0, 0.0)",
            );
        }
        Some(rotated(self.graph(), q))
    }

    /// x along the first vector, y in its plane with the second.
    fn two_axes(&mut self, field: &str, call: &ExprCall) -> Option<Axes> {
        let x = self.direction_of(field, &call.args[0])?;
        let towards = self.direction_of(field, &call.args[1])?;
        let graph = self.graph();
        let normal = graph.cross(x, towards);
        let square = graph.dot(normal, normal);
        if self.by_default(square) < PARALLEL {
            return self.resolver.fail(
                Place::of(&call.args[1]),
                "the second axis is parallel to the first, so that they span no plane; give another second axis",
            );
        }
        let graph = self.graph();
        let z = graph.unit(normal);
        let y = graph.cross(z, x);
        Some([x, y, z])
    }
}

/// A rotation, with its axis where that is known.
enum Rotation {
    About(Vector, Expr),
    Axes(Axes),
}

/// The axes that a quaternion (w, x, y, z) of any length turns to, in those before.
fn rotated(graph: &mut Graph, [w, x, y, z]: [Expr; 4]) -> Axes {
    let squares = [w, x, y, z].map(|component| graph.square(component));
    let length = graph.sum(squares.to_vec());
    // 2/|q|².
    let two = graph.constant(2.0);
    let factor = graph.div(two, length);
    let mut entry = |a: [Expr; 2], b: [Expr; 2], sign: f64| {
        let (first, second) = (graph.mul(a[0], a[1]), graph.mul(b[0], b[1]));
        let sum = graph.linear(0.0, &[(first, 1.0), (second, sign)]);
        graph.mul(factor, sum)
    };
    let off = [
        [entry([x, y], [w, z], 1.0), entry([x, z], [w, y], -1.0)],
        [entry([x, y], [w, z], -1.0), entry([y, z], [w, x], 1.0)],
        [entry([x, z], [w, y], 1.0), entry([y, z], [w, x], -1.0)],
    ];
    let diagonal = [([y, y], [z, z]), ([x, x], [z, z]), ([x, x], [y, y])];
    let diagonal = diagonal.map(|(a, b)| entry(a, b, 1.0));
    let one = graph.one();
    let [a, b, c] = diagonal.map(|x| graph.sub(one, x));
    [
        [a, off[0][0], off[0][1]],
        [off[1][0], b, off[1][1]],
        [off[2][0], off[2][1], c],
    ]
}
