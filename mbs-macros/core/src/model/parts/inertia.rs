//! Moments of inertia: numbers, tensors, shapes.

use super::shape::Shape;
use crate::diagnostics::Place;
use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::geometry::Tensor;
use crate::model::requirements::Wanted;
use crate::model::value::Value;
use crate::symbolic::Expr;

impl Arguments<'_, '_> {
    /// An inertia: a number, `diag(a, b, c)`, three rows, or a shape of the part's mass.
    pub fn inertia(&mut self, field: &str, mass: Expr) -> Option<(Tensor, Option<Shape>)> {
        let syntax = self.syntax(field)?;
        if let Some(shape) = self.shape(field, syntax) {
            let shape = shape?;
            return Some((self.shape_inertia(shape, mass), Some(shape)));
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
        let [[xx, xy, xz], [_, yy, yz], [.., zz]] = tensor;
        self.require(field, &[xx, xy, xz, yy, yz, zz], Wanted::Inertia);
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
        self.refuse_not_positive(
            "radius",
            radius,
            "a round bar has a positive radius; for a slender one leave it out",
        )?;
        let shape = Shape::Cylinder(radius, length, 0);
        Some((self.shape_inertia(shape, mass), Some(shape)))
    }

    /// A slender bar has only its ends, so that these arguments do not apply.
    pub fn slender_bar(&mut self, fields: &[&str]) -> Option<()> {
        match fields.iter().find(|field| self.has(field)) {
            Some(field) => self.fail(field, format!("a slender bar takes its velocities from its joints; for `{field}` give it a `radius =` or `inertia =`")),
            None => Some(()),
        }
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
            return self.fail(field, format!("this inertia is zero about an axis ({found}); a body has a positive one about every axis, also where joints hold it; give it that, or use a `Particle` or slender `Bar`"));
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
