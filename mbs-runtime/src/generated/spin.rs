//! The free rotation of a rigid body.

use super::principal::principal_axes;
use super::rotation::{cosine_and_sine, exponential, normalised, product};
use crate::ParameterError;

/// Principal moments that differ by less than this part of them count as equal.
const EQUAL: f64 = 1e-14;
/// How far, relative to the largest, principal moments may violate the triangle inequality (plates meet it with equality).
const TRIANGLE: f64 = 1e-9;

/// Principal moments and axes of a body.
#[derive(Debug, Clone)]
pub struct Spin {
    kind: Kind,
    /// Where the inertia is not diagonal: the principal axes as columns, and as a quaternion.
    axes: Option<Principal>,
}

type Moments = [f64; 3];
type Principal = ([[f64; 3]; 3], [f64; 4]);

#[derive(Debug, Clone)]
enum Kind {
    /// All moments are equal: ω stays.
    Spherical,
    /// Two moments a are equal, the third is c about `axis` (unit vector, body axes); `excess` is c/a − 1.
    Symmetric { axis: [f64; 3], excess: f64 },
    /// Moments about the principal axes.
    General {
        moments: [f64; 3],
        inverse: [f64; 3],
    },
}

/// Principal moments, axes that are not the given ones, and the largest moment, of an inertia that a body can have.
pub(super) fn possible(
    inertia: &[[f64; 3]; 3],
    body: &'static str,
) -> Result<(Moments, Option<Principal>, f64), ParameterError> {
    let (moments, axes) = principal_axes(inertia);
    let mut sorted = moments;
    sorted.sort_unstable_by(f64::total_cmp);
    let [least, middle, most] = sorted;
    if !(least > 1e-14 * most && most.is_finite()) {
        return Err(ParameterError::InertiaNotPositive { body, moments });
    }
    if least + middle < most * (1.0 - TRIANGLE) {
        return Err(ParameterError::InertiaTriangle { body, moments });
    }
    Ok((moments, axes, most))
}

impl Spin {
    /// From the inertia about the centre of mass in body axes, kg m².
    ///
    /// # Errors
    /// An inertia that is not positive definite, or that no body has: each principal moment is at most the sum of the
    /// other two.
    pub fn new(inertia: &[[f64; 3]; 3], body: &'static str) -> Result<Spin, ParameterError> {
        let (moments, axes, most) = possible(inertia, body)?;
        let equal = |i: usize, j: usize| (moments[i] - moments[j]).abs() <= EQUAL * most;
        let column = |k: usize| match &axes {
            Some((axes, _)) => [axes[0][k], axes[1][k], axes[2][k]],
            None => core::array::from_fn(|i| if i == k { 1.0 } else { 0.0 }),
        };
        let symmetric = [(0, 1, 2), (1, 2, 0), (2, 0, 1)]
            .into_iter()
            .find(|&(i, j, _)| equal(i, j));
        let (kind, axes) = match symmetric {
            Some((i, j, k)) if equal(i, k) && equal(j, k) => (Kind::Spherical, None),
            Some((i, j, k)) => {
                let excess = 2.0 * moments[k] / (moments[i] + moments[j]) - 1.0;
                let axis = column(k);
                (Kind::Symmetric { axis, excess }, None)
            }
            None => {
                let inverse = moments.map(|moment| 1.0 / moment);
                (Kind::General { moments, inverse }, axes)
            }
        };
        Ok(Spin { kind, axes })
    }

    /// Rotation (w, x, y, z) and angular velocity in body axes, rad/s, after h seconds without torque.
    ///
    /// Angular momentum in space is kept to round-off. Tops with two equal moments move exactly; for others it is the
    /// symmetric splitting into rotations about the principal axes, of second order in h and reversible.
    #[inline]
    pub fn flight(&self, q: [f64; 4], omega: [f64; 3], h: f64) -> ([f64; 4], [f64; 3]) {
        let (q, omega) = match &self.kind {
            Kind::Spherical => (product(q, exponential(omega.map(|w| 0.5 * h * w))), omega),
            Kind::Symmetric { axis, excess } => symmetric(*axis, *excess, q, omega, h),
            Kind::General { moments, inverse } => match &self.axes {
                None => splitting(moments, inverse, q, omega, h),
                Some((axes, turn)) => {
                    let own = core::array::from_fn(|k| (0..3).map(|i| axes[i][k] * omega[i]).sum());
                    let (q, after) = splitting(moments, inverse, product(q, *turn), own, h);
                    let back = [turn[0], -turn[1], -turn[2], -turn[3]];
                    // The change is turned back, so that the round-off of the axes does not add up step by step.
                    let change: [f64; 3] = core::array::from_fn(|k| after[k] - own[k]);
                    let turned = |i: usize| (0..3).map(|k| axes[i][k] * change[k]).sum::<f64>();
                    (
                        product(q, back),
                        core::array::from_fn(|i| omega[i] + turned(i)),
                    )
                }
            },
        };
        (normalised(q), omega)
    }
}

/// The motion of a symmetric top: the body turns about its angular momentum, at |L|/a, and about its own axis n, at
/// λ = −(c/a − 1) n·ω. With ω the latter turns backwards in the body.
#[inline]
fn symmetric(n: [f64; 3], excess: f64, q: [f64; 4], w: [f64; 3], h: f64) -> ([f64; 4], [f64; 3]) {
    let half = 0.5 * h;
    let along = n[0] * w[0] + n[1] * w[1] + n[2] * w[2];
    // L/a, half of the turn about it.
    let precession = core::array::from_fn(|i| half * (w[i] + excess * along * n[i]));
    let (cosine, sine) = cosine_and_sine(-half * excess * along);
    let own = [cosine, sine * n[0], sine * n[1], sine * n[2]];
    let q = product(product(q, exponential(precession)), own);
    // w ← w − sin θ n × w + (1 − cos θ) n × (n × w) for the angle θ = h λ.
    let (sin, versine) = (2.0 * sine * cosine, 2.0 * sine * sine);
    let across = [
        n[1] * w[2] - n[2] * w[1],
        n[2] * w[0] - n[0] * w[2],
        n[0] * w[1] - n[1] * w[0],
    ];
    let twice = core::array::from_fn::<f64, 3, _>(|i| along * n[i] - w[i]);
    let w = core::array::from_fn(|i| w[i] - sin * across[i] + versine * twice[i]);
    (q, w)
}

/// Half a step about x, half about y, one about z, half about y, half about x, principal axes.
#[inline]
fn splitting(
    moments: &[f64; 3],
    inverse: &[f64; 3],
    mut q: [f64; 4],
    omega: [f64; 3],
    h: f64,
) -> ([f64; 4], [f64; 3]) {
    let start: [f64; 3] = core::array::from_fn(|i| moments[i] * omega[i]);
    let mut l = start;
    turn::<0>(&mut q, &mut l, 0.25 * h * inverse[0]);
    turn::<1>(&mut q, &mut l, 0.25 * h * inverse[1]);
    turn::<2>(&mut q, &mut l, 0.5 * h * inverse[2]);
    turn::<1>(&mut q, &mut l, 0.25 * h * inverse[1]);
    turn::<0>(&mut q, &mut l, 0.25 * h * inverse[0]);
    // The change of ω: moments and their reciprocals have products that are off by the same round-off in every step.
    let changed = |i: usize| omega[i] + inverse[i] * (l[i] - start[i]);
    (q, core::array::from_fn(changed))
}

/// Turns the body about its axis I; `half` times L_I is half the angle. L stays in space.
///
/// Its changes are added, so that what is rounded is a sum, by chance up or down. A rounded cosine would be the same in
/// many steps, and change the length of L each time in the same way. (That of q is restored.)
#[inline(always)]
fn turn<const I: usize>(q: &mut [f64; 4], l: &mut [f64; 3], half: f64) {
    let (j, k) = ((I + 1) % 3, (I + 2) % 3);
    let (cosine, sine) = cosine_and_sine(half * l[I]);
    let [w, i] = [q[0], q[I + 1]];
    q[0] = cosine * w - sine * i;
    q[I + 1] = cosine * i + sine * w;
    let (y, z) = (q[j + 1], q[k + 1]);
    q[j + 1] = cosine * y + sine * z;
    q[k + 1] = cosine * z - sine * y;
    let (sin, versine) = (2.0 * sine * cosine, 2.0 * sine * sine);
    let (y, z) = (l[j], l[k]);
    l[j] = y + (sin * z - versine * y);
    l[k] = z - (versine * z + sin * y);
}

#[cfg(test)]
mod tests;
