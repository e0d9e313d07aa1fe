//! The exact motion of the pendulum: released from the horizontal, an elliptic function of time.
//!
//! With θ from the downward vertical and ω² = m g l/(m l² + J), sin(θ/2) = k sn(K − ω t, k), k = sin 45° (Whittaker, *A
//! Treatise on the Analytical Dynamics of Particles and Rigid Bodies*, section 44); sn by descending Landen transformations
//! (Abramowitz and Stegun 16.4).

use super::column::Column;

const GRAVITY: f64 = 9.81;
/// Moment of inertia of the scene, kg m²; mass and length are 1.
const INERTIA: f64 = 1e-4;
const LANDEN: usize = 8;

/// The numbers of the exact motion at time t, s.
pub fn pendulum(t: f64, column: &Column) -> Option<f64> {
    let square = GRAVITY / (1.0 + INERTIA);
    let k = 0.5_f64.sqrt();
    let half = k * sn(square.sqrt() * t, k);
    // Released on the left: θ = −90° at first.
    let (sin, cos) = (
        -2.0 * half * (1.0 - half * half).sqrt(),
        1.0 - 2.0 * half * half,
    );
    let [rate_square, acceleration] = [2.0 * square * cos, -square * sin];
    Some(match column {
        Column::EnergyError | Column::Energy => 0.0,
        Column::Output("x") => sin,
        Column::Output("y") => -cos,
        // m (a − g) of the bob at (sin θ, −cos θ).
        Column::Reaction("pivot", "fx") => acceleration * cos - rate_square * sin,
        Column::Reaction("pivot", "fy") => acceleration * sin + rate_square * cos + GRAVITY,
        _ => return None,
    })
}

/// sn(K − u, k) = cd(u, k).
fn sn(u: f64, k: f64) -> f64 {
    let (mut a, mut c) = ([1.0; LANDEN + 1], [k; LANDEN + 1]);
    let mut b = (1.0 - k * k).sqrt();
    for i in 0..LANDEN {
        a[i + 1] = 0.5 * (a[i] + b);
        c[i + 1] = 0.5 * (a[i] - b);
        b = (a[i] * b).sqrt();
    }
    let quarter = std::f64::consts::FRAC_PI_2 / a[LANDEN];
    let mut phase = f64::from(1 << LANDEN) * a[LANDEN] * (quarter - u);
    for i in (1..=LANDEN).rev() {
        phase = 0.5 * (phase + (c[i] / a[i] * phase.sin()).asin());
    }
    phase.sin()
}
