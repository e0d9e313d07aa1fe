//! The motions of both kinds of scenes in one coordinate: which branch a run should be on.

use super::equations::GRAVITY;

/// Steps of the classical method for the motion in one coordinate.
const STEPS: u32 = 100_000;

/// Angle and rate of a crank at a time, from θ̈ = f(θ, θ̇).
fn motion(start: [f64; 2], time: f64, acceleration: impl Fn(f64, f64) -> f64) -> [f64; 2] {
    let h = time / f64::from(STEPS);
    let slope = |[angle, rate]: [f64; 2]| [rate, acceleration(angle, rate)];
    let moved = |from: [f64; 2], by: f64, [a, b]: [f64; 2]| [from[0] + by * a, from[1] + by * b];
    (0..STEPS).fold(start, |now, _| {
        let first = slope(now);
        let second = slope(moved(now, 0.5 * h, first));
        let third = slope(moved(now, 0.5 * h, second));
        let fourth = slope(moved(now, h, third));
        let end = moved(moved(now, h / 6.0, first), h / 6.0, fourth);
        moved(moved(end, h / 3.0, second), h / 3.0, third)
    })
}

/// The crank of the slider-crank whose rods stay mirror images.
pub fn slider_crank(time: f64) -> f64 {
    let angle = std::f64::consts::FRAC_PI_4;
    let start = [angle, 4.0 / (2.0 * angle.sin())];
    motion(start, time, |angle, rate| {
        let inertia = 5.0 / 3.0 - (2.0 * angle).cos();
        (-(2.0 * angle).sin() * rate * rate - GRAVITY * angle.cos()) / inertia
    })[0]
}

/// The cranks of a row of parallelograms.
pub fn cranks(loops: usize, time: f64) -> f64 {
    let (cranks, couplers) = (loops as f64 + 1.0, loops as f64);
    let factor = GRAVITY * (0.5 * cranks + couplers) / (cranks / 3.0 + couplers);
    let start = [std::f64::consts::FRAC_PI_2, -1.0];
    motion(start, time, |angle, _| -factor * angle.cos())[0]
}
