//! Rotations by unit quaternions (w, x, y, z), which take body axes to space axes.

#[cfg(not(feature = "std"))]
use crate::elementary::Elementary as _;

/// Squared half angles below which sine and cosine are series: their first neglected terms are below 3e-17.
const SMALL: f64 = 1e-2;

/// cos √s and sin √s / √s.
#[inline]
fn cosine_and_sinc(s: f64) -> (f64, f64) {
    if s < SMALL {
        let cosine = 1.0 - s * (0.5 - s * (1.0 / 24.0 - s * (1.0 / 720.0 - s * (1.0 / 40_320.0))));
        let sinc =
            1.0 - s * (1.0 / 6.0 - s * (1.0 / 120.0 - s * (1.0 / 5_040.0 - s * (1.0 / 362_880.0))));
        (cosine, sinc)
    } else {
        let root = s.sqrt();
        let (sine, cosine) = root.sin_cos();
        (cosine, sine / root)
    }
}

/// The unit quaternion of a rotation by the vector 2u, for its half u.
#[inline]
pub(super) fn exponential(u: [f64; 3]) -> [f64; 4] {
    let (cosine, sinc) = cosine_and_sinc(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    [cosine, sinc * u[0], sinc * u[1], sinc * u[2]]
}

/// Cosine and sine of x.
#[inline]
pub(super) fn cosine_and_sine(x: f64) -> (f64, f64) {
    let (cosine, sinc) = cosine_and_sinc(x * x);
    (cosine, sinc * x)
}

/// a ∘ b.
#[inline]
pub(super) fn product(a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
    [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    ]
}

/// q / |q|. A product of unit quaternions is off by round-off only: one Newton step for 1/√n is then exact.
#[inline]
pub(super) fn normalised(q: [f64; 4]) -> [f64; 4] {
    let square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    if (square - 1.0).abs() < 1e-8 {
        // A rounded scale would be rounded up or down in many steps.
        let missing = 0.5 - 0.5 * square;
        q.map(|value| value + missing * value)
    } else {
        let scale = 1.0 / square.sqrt();
        q.map(|value| scale * value)
    }
}

/// q ∘ exp(h ω/2), renormalised: the rotation q (w, x, y, z) after h seconds of the angular velocity ω in body axes,
/// rad/s.
#[inline]
pub fn turned(q: [f64; 4], omega: [f64; 3], h: f64) -> [f64; 4] {
    normalised(product(q, exponential(omega.map(|w| 0.5 * h * w))))
}

/// The rotation vector in body axes, rad, of the shortest way from one rotation to another:
/// `turned(from, rotation_between(from, to), 1.0)` is `to`, or −`to`, which is the same rotation.
#[inline]
pub fn rotation_between(from: [f64; 4], to: [f64; 4]) -> [f64; 3] {
    let [w, x, y, z] = product([from[0], -from[1], -from[2], -from[3]], to);
    let sine = (x * x + y * y + z * z).sqrt();
    // Of q and −q the one within half a turn.
    let sign = if w < 0.0 { -1.0 } else { 1.0 };
    // Scales cancel, so that the two need not be normalised.
    let factor = if sine < 1e-8 * w.abs() {
        2.0 / w.abs()
    } else {
        2.0 * sine.atan2(w.abs()) / sine
    };
    [x, y, z].map(|value| sign * factor * value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: &[f64], b: &[f64], tolerance: f64) -> bool {
        a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance)
    }

    #[test]
    fn series_and_functions_meet() {
        for s in [0.0, 1e-20, 1e-6, 0.9999 * SMALL, 1.0001 * SMALL, 2.0] {
            let (cosine, sinc) = cosine_and_sinc(s);
            let root: f64 = s.sqrt();
            assert!((cosine - root.cos()).abs() < 3e-16);
            assert!((sinc * root - root.sin()).abs() < 3e-16);
        }
    }

    #[test]
    fn a_turn_leads_back_by_its_opposite() {
        let q = normalised([0.3, -0.5, 0.7, 0.2]);
        for size in [1e-9, 1e-3, 0.3, 2.5] {
            let omega = [0.6 * size, -0.48 * size, 0.64 * size];
            let there = turned(q, omega, 1.0);
            assert!(close(&turned(there, omega, -1.0), &q, 4e-16));
            assert!(close(&rotation_between(q, there), &omega, 1e-15));
            assert!(close(
                &rotation_between(q, there.map(|x| -x)),
                &omega,
                1e-15
            ));
        }
    }

    #[test]
    fn a_quarter_about_z_takes_x_to_y() {
        let q = turned(
            [1.0, 0.0, 0.0, 0.0],
            [0.0, 0.0, 1.0],
            core::f64::consts::FRAC_PI_2,
        );
        let x = product(
            product(q, [0.0, 1.0, 0.0, 0.0]),
            [q[0], -q[1], -q[2], -q[3]],
        );
        assert!(close(&x, &[0.0, 0.0, 1.0, 0.0], 4e-16));
    }

    #[test]
    fn half_a_turn_has_a_vector() {
        let vector = rotation_between([1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]);
        assert!(close(&vector, &[0.0, core::f64::consts::PI, 0.0], 1e-15));
        assert_eq!(
            rotation_between([1.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0]),
            [0.0; 3]
        );
    }
}
