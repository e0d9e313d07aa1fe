//! An elastic joint: V = ½ u·K u + ½ e·K_r e + u·C s with the displacement u, the turning e = 2 n sin(ψ/2) and the axial vector
//! s = n sin ψ, in the parent's axes. (At half a turn e changes its sign, which V does not see, but u·C e would.)

use super::force::Bushing;
use crate::model::geometry::{Axes, Tensor, Vector};
use crate::symbolic::{Expr, Graph};

/// How the child is against the parent, in the parent's axes.
pub struct Displaced {
    /// The place of the child's origin from the parent's.
    pub displacement: Vector,
    /// Its rate in these axes.
    pub rate: Vector,
    /// The child's axes.
    pub rotation: Tensor,
    /// The angular velocity of the child against the parent.
    pub spin: Vector,
}

impl Bushing {
    /// The force on the child's origin, −K u − C s − D u̇, in the parent's axes.
    pub fn force(&self, graph: &mut Graph, now: &Displaced) -> Vector {
        let twice = twice_axial(graph, &now.rotation);
        let axial = twice.map(|x| graph.scale(0.5, x));
        let gains = [self.stiffness, self.cross_stiffness, self.damping];
        opposed(graph, &gains, &[now.displacement, axial, now.rate])
    }

    /// The torque on the child, in the parent's axes: −∂V/∂θ against turns δθ about these, for which δR = δθ × R of each axis of
    /// the child, and −D_r ω.
    pub fn torque(&self, graph: &mut Graph, now: &Displaced) -> Vector {
        let drag = opposed(graph, &[self.torsion_damping], &[now.spin]);
        let axes = graph.ground_axes();
        std::array::from_fn(|k| {
            let turned = turned(graph, axes[k], &now.rotation);
            let torsion = linear_in_rotation(graph, &self.torsion_stiffness, &turned, 0.0);
            let twice = twice_axial(graph, &turned);
            let cross = quadratic(graph, &self.cross_stiffness, now.displacement, twice, 0.5);
            graph.linear(0.0, &[(torsion, -1.0), (cross, -1.0), (drag[k], 1.0)])
        })
    }
}

/// −Σ gain · amount.
fn opposed(graph: &mut Graph, gains: &[Tensor], amounts: &[Vector]) -> Vector {
    std::array::from_fn(|k| {
        let pairs = gains.iter().zip(amounts);
        let terms = pairs.map(|(gain, amount)| graph.dot(gain[k], *amount));
        let terms: Vec<Expr> = terms.collect();
        let sum = graph.sum(terms);
        graph.neg(sum)
    })
}

/// direction × R, column by column.
fn turned(graph: &mut Graph, direction: Vector, rotation: &Tensor) -> Tensor {
    let columns: [Vector; 3] = std::array::from_fn(|column| {
        let axis = rotation.map(|row| row[column]);
        graph.cross(direction, axis)
    });
    std::array::from_fn(|row| columns.map(|column| column[row]))
}

/// factor · a·K b.
pub fn quadratic(graph: &mut Graph, gain: &Tensor, a: Vector, b: Vector, factor: f64) -> Expr {
    let image = gain.map(|row| graph.dot(row, b));
    let energy = graph.dot(a, image);
    graph.scale(factor, energy)
}

/// The rotation of the child in the axes of the parent.
pub fn relative_rotation(graph: &mut Graph, parent: &Axes, child: &Axes) -> Tensor {
    parent.map(|row| child.map(|column| graph.dot(row, column)))
}

/// constant + factor · trace of a tensor.
pub fn trace(graph: &mut Graph, tensor: &Tensor, constant: f64, factor: f64) -> Expr {
    let terms: Vec<_> = (0..3).map(|k| (tensor[k][k], factor)).collect();
    graph.linear(constant, &terms)
}

/// 2 n sin ψ, twice the axial vector of a rotation.
pub fn twice_axial(graph: &mut Graph, rotation: &Tensor) -> Vector {
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        graph.sub(rotation[j][i], rotation[i][j])
    })
}

/// ½ Σ K (R + Rᵀ + (constant − trace R) 1), which for the constant 1 is ½ e·K e, because e eᵀ = R + Rᵀ + (1 − trace R) 1.
pub fn linear_in_rotation(
    graph: &mut Graph,
    gain: &Tensor,
    rotation: &Tensor,
    constant: f64,
) -> Expr {
    let rest = trace(graph, rotation, constant, -1.0);
    let mut terms = Vec::new();
    for i in 0..3 {
        terms.push(graph.mul(gain[i][i], rest));
        for k in 0..3 {
            let sum = graph.add(rotation[i][k], rotation[k][i]);
            terms.push(graph.mul(gain[i][k], sum));
        }
    }
    let sum = graph.sum(terms);
    graph.scale(0.5, sum)
}
