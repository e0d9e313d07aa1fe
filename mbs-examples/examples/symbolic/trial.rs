//! The rival's candidates for a scene.

use super::candidate::{BOUNDS, Candidate, Outcome, Steps, measured};
use super::equations::Equations;
use super::rival::{Projection, Rival};
use cpu_time::ProcessTime;
use std::hint::black_box;

/// s
pub const DURATION: f64 = 10.0;
/// Steps between projections, and the motion of an angle that asks for another pass, rad.
const EVERY: [u32; 5] = [1, 2, 3, 5, 10];
const LIMITS: [f64; 2] = [1e-5, 1e-1];
/// A crank that ends this far from its motion, rad, is on another branch.
const ASTRAY: f64 = 0.3;

/// All settings of the rival. `exact` is where the angles end.
pub fn candidates<'c, E: Equations<N> + 'c, const N: usize>(
    exact: [f64; N],
    grid: Steps,
) -> Vec<Candidate<'c>> {
    let mut candidates = Vec::new();
    for (family, order) in [("symbolic 8", 8), ("symbolic 4", 4)] {
        for every in EVERY {
            for limit in LIMITS {
                let projection = Projection { every, limit };
                candidates.push(Candidate {
                    family,
                    setting: format!("projection every {every}; limit {limit:e}"),
                    grid: grid.grid(),
                    name: |steps| format!("{steps} steps"),
                    check: Box::new(move |steps| check::<E, N>(projection, order, steps, &exact)),
                    time: Box::new(move |steps| time::<E, N>(projection, order, steps)),
                });
            }
        }
    }
    candidates
}

/// A run with its energy after each step.
fn check<E: Equations<N>, const N: usize>(
    projection: Projection,
    order: u8,
    steps: u32,
    exact: &[f64; N],
) -> Outcome {
    let h = DURATION / f64::from(steps);
    let begun = ProcessTime::now();
    let mut rival = Rival::<E, N>::new(projection);
    let initial = E::energy(&rival.q, &rival.v);
    let mut error: f64 = 0.0;
    for _ in 0..steps {
        match order {
            8 => rival.step8(h),
            _ => rival.step4(h),
        }
        let now = (E::energy(&rival.q, &rival.v) - initial).abs();
        if !(now <= BOUNDS[0]) {
            error = f64::INFINITY;
            break;
        }
        error = error.max(now);
    }
    let off = |(angle, exact): (&f64, &f64)| {
        let [now, end] = [angle, exact].map(|angle| angle.sin_cos());
        (now.0 - end.0).hypot(now.1 - end.1)
    };
    // Written so that NaN is astray.
    if !rival.q.iter().zip(exact).map(off).all(|off| off < ASTRAY) {
        error = f64::INFINITY;
    }
    let seconds = begun.elapsed().as_secs_f64();
    let calls = if order == 8 { 12 } else { 4 } * u64::from(steps);
    Outcome {
        error,
        seconds,
        steps: u64::from(steps),
        calls: Some(calls),
    }
}

fn time<E: Equations<N>, const N: usize>(projection: Projection, order: u8, steps: u32) -> f64 {
    let h = DURATION / f64::from(steps);
    let mut rival = Rival::<E, N>::new(projection);
    let seconds = measured(&mut || {
        match order {
            8 => (0..steps).for_each(|_| rival.step8(black_box(h))),
            _ => (0..steps).for_each(|_| rival.step4(black_box(h))),
        }
        true
    });
    black_box(&rival.q);
    seconds
}

/// The angles after `time` by many steps of order 8, for a comparison of the equations.
pub fn after<E: Equations<N>, const N: usize>(time: f64, steps: u32) -> [f64; N] {
    let mut rival = Rival::<E, N>::new(Projection {
        every: 1,
        limit: 1e-9,
    });
    (0..steps).for_each(|_| rival.step8(time / f64::from(steps)));
    rival.q
}

/// |dE/dt|, W, at angles off any symmetry and rates that satisfy the rows: zero, also where the angles do not.
pub fn power<E: Equations<N>, const N: usize>() -> f64 {
    /// Of the central difference, s.
    const SHORT: f64 = 1e-5;
    let mut equations = E::default();
    let q: [f64; N] = std::array::from_fn(|i| (1.0 + 1.7 * i as f64).sin());
    let mut v: [f64; N] = std::array::from_fn(|i| (2.0 + 2.3 * i as f64).sin());
    equations.place(&q);
    let missing = equations.missing_velocities(&v);
    for i in 0..N {
        v[i] += missing[i];
    }
    let mut slopes = [0.0; N];
    equations.accelerations(&v, &mut slopes);
    let energy = |time: f64| {
        let moved = std::array::from_fn(|i| q[i] + time * v[i]);
        let faster = std::array::from_fn(|i| v[i] + time * slopes[i]);
        E::energy(&moved, &faster)
    };
    ((energy(SHORT) - energy(-SHORT)) / (2.0 * SHORT)).abs()
}
