//! Moments of inertia: numbers, tensors, shapes.

use crate::diagnostics::{Place, nearest};
use crate::model::value::Value;
use crate::model::{Arguments, Dimension};
use crate::symbolic::Expr;
use syn::Expr as Syntax;

/// A symmetric tensor, both triangles.
pub type Tensor = [[Expr; 3]; 3];

/// A shape, for pictures; all in parameters.
#[derive(Debug, Clone, Copy)]
pub enum Shape {
    /// Edges along the axes.
    Cuboid([Expr; 3]),
    /// Radius, length, and the index of its axis.
    Cylinder(Expr, Expr, usize),
    /// Radius.
    Sphere(Expr),
}

impl Arguments<'_, '_> {
    /// An inertia: a number, `diag(a, b, c)`, three rows, or a shape of the part's mass.
    pub fn inertia(&mut self, field: &str, mass: Expr) -> Option<(Tensor, Option<Shape>)> {
        let syntax = self.syntax(field)?;
        if let Syntax::Call(call) = syntax
            && let Syntax::Path(path) = &*call.func
            && let Some(name) = path.path.get_ident()
            && let Some(shape) = self.shape(&name.to_string(), call)
        {
            let shape = shape?;
            return Some((self.shape_inertia(shape, mass), Some(shape)));
        }
        if let Syntax::Call(call) = syntax
            && let Some(meant) = misspelt_shape(call)
        {
            let what = quote::ToTokens::to_token_stream(&call.func);
            return self.fail_at(
                Place::of(&call.func),
                format!(
                    "there is no shape `{what}`; did you mean `{meant}`? (shapes: {})",
                    SHAPES.join(", ")
                ),
            );
        }
        let value = self.evaluate(syntax)?;
        let (tensor, dimension) = match value {
            Value::Scalar(x, dimension) => (self.diagonal([x; 3]), dimension),
            Value::Tensor(tensor, dimension) => (tensor, dimension),
            Value::Vector(..) => {
                return self.fail(
                    field,
                    "for the three principal moments write `diag(a, b, c)`",
                );
            }
            other => {
                let what = other.describe();
                return self.fail(field, format!("`{field}` is a moment of inertia, `diag(a, b, c)`, three rows, or a shape such as `Cylinder(radius, length)`, but this is {what}"));
            }
        };
        self.check_dimension(field, dimension, Dimension::INERTIA, Place::of(syntax))?;
        self.check_known(field, syntax, tensor.as_flattened())?;
        self.check_inertia(field, &tensor)?;
        Some((tensor, None))
    }

    /// That of a bar: by `inertia =`, or of a cylinder of `radius =`.
    pub fn bar_inertia(&mut self, mass: Expr, length: Expr) -> Option<(Tensor, Option<Shape>)> {
        if self.has("inertia") {
            if self.has("radius") {
                return self.fail(
                    "radius",
                    "`inertia` says it all; keep one of `radius` and `inertia`",
                );
            }
            return self.inertia("inertia", mass);
        }
        let radius = self.scalar("radius")?;
        self.refuse_no_length(
            "radius",
            radius,
            "a round bar has a positive radius; for a slender one leave it out",
        )?;
        let shape = Shape::Cylinder(radius, length, 0);
        Some((self.shape_inertia(shape, mass), Some(shape)))
    }

    /// A slender bar has its ends only: these arguments would say more.
    pub fn slender_bar(&mut self, fields: &[&str]) -> Option<()> {
        match fields.iter().find(|field| self.has(field)) {
            Some(field) => self.fail(field, format!("a slender bar takes its velocities from its joints; for `{field}` give it a `radius =` or `inertia =`")),
            None => Some(()),
        }
    }

    /// The shape of this name, if it is one.
    fn shape(&mut self, name: &str, call: &syn::ExprCall) -> Option<Option<Shape>> {
        let (usage, counts) = match name {
            "Cuboid" => ("Cuboid(x, y, z)", 3..=3),
            "Cylinder" => (
                "Cylinder(radius, length) or Cylinder(radius, length, axis)",
                2..=3,
            ),
            "Sphere" => ("Sphere(radius)", 1..=1),
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

    fn shape_inertia(&mut self, shape: Shape, mass: Expr) -> Tensor {
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

    pub(in crate::model) fn diagonal(&mut self, moments: [Expr; 3]) -> Tensor {
        let zero = self.graph().zero();
        let mut tensor = [[zero; 3]; 3];
        for (k, moment) in moments.into_iter().enumerate() {
            tensor[k][k] = moment;
        }
        tensor
    }

    /// Symmetric and, with the defaults of its parameters, positive definite and possible for a body: no principal moment
    /// exceeds the sum of the other two.
    fn check_inertia(&mut self, field: &str, tensor: &Tensor) -> Option<()> {
        let value = tensor.map(|row| row.map(|x| self.by_default(x)));
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            if tensor[i][j] != tensor[j][i] && value[i][j] != value[j][i] {
                return self.fail(
                    field,
                    format!(
                        "an inertia is symmetric, but entry [{i}][{j}] is {} and [{j}][{i}] is {}",
                        value[i][j], value[j][i]
                    ),
                );
            }
        }
        let found = format!("{value:?}");
        let trace = value[0][0] + value[1][1] + value[2][2];
        if (0..3).any(|k| value[k][k] == 0.0) {
            return self.fail(field, format!("this inertia is zero about an axis about which the body is free to turn ({found}); give it a positive value, or use a `Particle` or slender `Bar`"));
        }
        if !positive_definite(&value) {
            return self.fail(
                field,
                format!("this inertia is not positive definite ({found}): about some axis the body would have no inertia or a negative one; check signs, and that products of inertia are smaller than moments"),
            );
        }
        // J ↦ ½ tr(J) − J are the second moments of the mass, which no body has negative.
        let moments: [[f64; 3]; 3] = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let half_trace = if i == j { (0.5 + 1e-12) * trace } else { 0.0 };
                half_trace - value[i][j]
            })
        });
        if !positive_semidefinite(&moments, trace) {
            return self.fail(field, format!("no body has this inertia: one principal moment exceeds the sum of the other two ({found}); check the order of its entries, and that it is about the centre of mass"));
        }
        Some(())
    }
}

const SHAPES: [&str; 3] = [
    "Cuboid(x, y, z)",
    "Cylinder(radius, length)",
    "Sphere(radius)",
];

/// The shape that a call may mean: those of functions begin with a small letter.
fn misspelt_shape(call: &syn::ExprCall) -> Option<&'static str> {
    let Syntax::Path(path) = &*call.func else {
        return None;
    };
    let name = path.path.get_ident()?.to_string();
    if !name.starts_with(char::is_uppercase) {
        return None;
    }
    nearest(&name, ["Cuboid", "Cylinder", "Sphere"])
}

fn positive_definite(m: &[[f64; 3]; 3]) -> bool {
    let minor = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    m[0][0] > 0.0 && minor > 0.0 && determinant(m) > 0.0
}

fn positive_semidefinite(m: &[[f64; 3]; 3], scale: f64) -> bool {
    let small = 1e-9 * scale;
    let minors = [(0, 1), (0, 2), (1, 2)].map(|(i, j)| m[i][i] * m[j][j] - m[i][j] * m[j][i]);
    (0..3).all(|k| m[k][k] >= -small)
        && minors.iter().all(|minor| *minor >= -small * scale)
        && determinant(m) >= -small * scale * scale
}

fn determinant(m: &[[f64; 3]; 3]) -> f64 {
    m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
        - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
}
