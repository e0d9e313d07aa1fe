//! Factors that turn with the bodies.
//!
//! J changes mainly because bodies turn: what a bushing adds to it has the axes of its bodies, not those of the world. With
//! D the turn of a body since the factors were made, and T the block-diagonal matrix of the D that act on velocities along the
//! axes of the world (angular velocities have the axes of the body already),
//!
//! ```text
//! J ≈ T J̃ Tᵀ,    J⁻¹ ≈ T J̃⁻¹ Tᵀ.
//! ```
//!
//! What is left is of the size of the turns between neighbours. Corotational finite elements separate the two in the same
//! way. Rows have axes of their own, so that this is done without rows only.

use crate::{Model, System};
use nalgebra::{Quaternion, Rotation3, SVector, UnitQuaternion, Vector3};

/// The free bodies of a mechanism without rows, and their turns.
#[derive(Clone)]
pub(super) struct Turns {
    bodies: Vec<Body>,
}

#[derive(Clone)]
struct Body {
    /// The first of its three velocities along the axes of the world.
    velocity: usize,
    /// The first component of its quaternion.
    quaternion: usize,
    /// D.
    turn: Rotation3<f64>,
}

impl Turns {
    pub(super) fn new<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>() -> Self
    {
        let rotations = if R == 0 { S::ROTATIONS } else { &[] };
        let bodies = rotations.iter().filter_map(|&at| body(S::MODEL, at));
        Turns {
            bodies: bodies.collect(),
        }
    }

    /// For factors that were made at one configuration and are used at another.
    pub(super) fn set<const Q: usize>(&mut self, made: &SVector<f64, Q>, used: &SVector<f64, Q>) {
        for Body {
            quaternion: at,
            turn,
            ..
        } in &mut self.bodies
        {
            let [made, used] = [made, used].map(|q| {
                let [w, x, y, z] = std::array::from_fn(|k| q[*at + k]);
                UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z))
            });
            *turn = (used * made.inverse()).to_rotation_matrix();
        }
    }

    /// x ← Tᵀ x.
    pub(super) fn undo(&self, x: &mut [f64]) {
        self.act(x, Rotation3::inverse_transform_vector);
    }

    /// x ← T x.
    pub(super) fn redo(&self, x: &mut [f64]) {
        self.act(x, Rotation3::transform_vector);
    }

    fn act(&self, x: &mut [f64], of: fn(&Rotation3<f64>, &Vector3<f64>) -> Vector3<f64>) {
        for Body { velocity, turn, .. } in &self.bodies {
            let x = &mut x[*velocity..velocity + 3];
            let turned = of(turn, &Vector3::from_column_slice(x));
            x.copy_from_slice(turned.as_slice());
        }
    }
}

/// The body whose angular velocity begins at an index, if its position has coordinates of its own.
fn body(model: &Model, rotation: usize) -> Option<Body> {
    let name = model.velocities.get(rotation)?.name;
    let part = name.strip_suffix(".omega.x")?;
    let velocity = rotation.checked_sub(3)?;
    let own = model.velocities[velocity..rotation].iter();
    let own = own.map(|velocity| velocity.name.strip_prefix(part));
    if !own.eq([".x'", ".y'", ".z'"].map(Some)) {
        return None;
    }
    let is_quaternion = |name: &str| name.strip_prefix(part) == Some(".qw");
    // Each rotation before it has one coordinate more than it has velocities.
    let mut coordinates = model.coordinates.get(rotation..)?.iter();
    let beyond = coordinates.position(|coordinate| is_quaternion(coordinate.name))?;
    Some(Body {
        velocity,
        quaternion: rotation + beyond,
        turn: Rotation3::identity(),
    })
}
