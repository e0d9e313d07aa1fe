use super::super::rotation::turned;
use super::*;

const ASYMMETRIC: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.5]];
const SKEW: [[f64; 3]; 3] = [[2.0, -0.3, 0.1], [-0.3, 3.0, 0.25], [0.1, 0.25, 2.5]];
const TOP: [[f64; 3]; 3] = [[2.0, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, 2.0]];

fn rotated(q: [f64; 4], x: [f64; 3]) -> [f64; 3] {
    let back = [q[0], -q[1], -q[2], -q[3]];
    let [_, x, y, z] = product(product(q, [0.0, x[0], x[1], x[2]]), back);
    [x, y, z]
}

fn momentum(inertia: &[[f64; 3]; 3], q: [f64; 4], w: [f64; 3]) -> [f64; 3] {
    let l = core::array::from_fn(|i| (0..3).map(|j| inertia[i][j] * w[j]).sum());
    rotated(q, l)
}

fn difference(a: &[f64], b: &[f64]) -> f64 {
    a.iter()
        .zip(b)
        .fold(0.0, |most, (a, b)| most.max((a - b).abs()))
}

fn start() -> ([f64; 4], [f64; 3]) {
    (
        turned([1.0, 0.0, 0.0, 0.0], [0.3, -0.8, 0.5], 1.0),
        [1.0, -2.0, 0.7],
    )
}

fn fly(inertia: &[[f64; 3]; 3], steps: usize, h: f64) -> ([f64; 4], [f64; 3]) {
    let spin = Spin::new(inertia, "body").unwrap();
    let (mut q, mut w) = start();
    for _ in 0..steps {
        (q, w) = spin.flight(q, w, h);
    }
    (q, w)
}

#[test]
fn angular_momentum_stays_in_space_and_time_runs_back() {
    for inertia in [
        ASYMMETRIC,
        SKEW,
        TOP,
        [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]],
    ] {
        let spin = Spin::new(&inertia, "body").unwrap();
        let (q0, w0) = start();
        let before = momentum(&inertia, q0, w0);
        let (mut q, mut w) = (q0, w0);
        for _ in 0..1000 {
            (q, w) = spin.flight(q, w, 0.05);
        }
        let drift = difference(&momentum(&inertia, q, w), &before);
        assert!(drift < 1e-12, "{inertia:?}: {drift:e}");
        assert!((q.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-15);
        for _ in 0..1000 {
            (q, w) = spin.flight(q, w, -0.05);
        }
        assert!(difference(&q, &q0) < 1e-11 && difference(&w, &w0) < 1e-11);
    }
}

#[test]
fn tops_move_exactly() {
    let one = fly(&TOP, 1, 2.0);
    let many = fly(&TOP, 1000, 2e-3);
    assert!(difference(&one.0, &many.0) < 1e-13 && difference(&one.1, &many.1) < 1e-13);
    // The same top, its principal axes turned.
    let turn = turned([1.0, 0.0, 0.0, 0.0], [0.4, 0.2, -0.9], 1.0);
    let columns: [[f64; 3]; 3] =
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| rotated(turn, axis));
    let inertia = core::array::from_fn(|i| {
        core::array::from_fn(|j| {
            (0..3)
                .map(|k| columns[k][i] * TOP[k][k] * columns[k][j])
                .sum()
        })
    });
    let spin = Spin::new(&inertia, "body").unwrap();
    assert!(matches!(spin.kind, Kind::Symmetric { .. }));
    let (q, w) = start();
    let own = [turn[0], -turn[1], -turn[2], -turn[3]];
    let (q, w) = spin.flight(product(q, own), rotated(turn, w), 2.0);
    assert!(difference(&product(q, turn), &one.0) < 1e-13);
    assert!(difference(&rotated(own, w), &one.1) < 1e-13);
}

/// A top whose moments are not quite equal is split; it must follow the exact motion of the symmetric one.
#[test]
fn the_splitting_is_of_second_order() {
    for inertia in [ASYMMETRIC, SKEW] {
        let exact = fly(&inertia, 20_000, 1e-4);
        let error = |steps: usize| {
            let (q, w) = fly(&inertia, steps, 2.0 / steps as f64);
            difference(&q, &exact.0).max(difference(&w, &exact.1))
        };
        let (coarse, fine) = (error(50), error(100));
        assert!((3.7..4.3).contains(&(coarse / fine)), "{coarse} {fine}");
    }
    let mut nearly = TOP;
    nearly[0][0] += 1e-10;
    let (split, exact) = (fly(&nearly, 20_000, 1e-4), fly(&TOP, 1, 2.0));
    assert!(difference(&split.0, &exact.0) < 1e-7 && difference(&split.1, &exact.1) < 1e-7);
}

#[test]
fn impossible_inertias_are_named() {
    let error = |inertia: [[f64; 3]; 3]| Spin::new(&inertia, "rotor").unwrap_err().to_string();
    let negative = error([[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]);
    assert!(
        negative.contains("rotor") && negative.contains("positive definite"),
        "{negative}"
    );
    let long = error([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 3.0]]);
    assert!(long.contains("rotor") && long.contains("sum"), "{long}");
    let nan = error([[f64::NAN, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    assert!(nan.contains("positive definite"), "{nan}");
    // A plate, to round-off.
    assert!(
        Spin::new(
            &[[0.1, 0.0, 0.0], [0.0, 0.2, 0.0], [0.0, 0.0, 0.3]],
            "plate"
        )
        .is_ok()
    );
}
