//! Compiled derivatives compared with differences of the functions from which they are derived.

use crate::random::{Arguments, Random};
use mbs_runtime::System;

/// Steps of the differences. Each slope is computed with all of them, and the value that agrees best with its neighbour
/// counts: so neither the curvature in a mechanism of centimetres nor the round-off in one of metres matters.
const STEPS: [f64; 5] = [1e-2, 2e-3, 4e-4, 8e-5, 1.6e-5];
/// Required agreement, relative to the largest component of the slope and of the function.
const TOLERANCE: f64 = 2e-7;
/// Required agreement of identities without differences.
const EXACT: f64 = 1e-11;

/// d/ds of a vector function at s = 0, by central differences of fourth order.
fn slope(function: &dyn Fn(f64) -> Vec<f64>) -> (Vec<f64>, f64) {
    let centre = function(0.0);
    let slopes: Vec<Vec<f64>> = STEPS
        .iter()
        .map(|&h| {
            let [far_left, left, right, far_right] =
                [-2.0, -1.0, 1.0, 2.0].map(|steps| function(steps * h));
            (0..centre.len())
                .map(|i| (far_left[i] - far_right[i] + 8.0 * (right[i] - left[i])) / (12.0 * h))
                .collect()
        })
        .collect();
    let best: Vec<f64> = (0..centre.len())
        .map(|i| {
            let pair = (1..STEPS.len())
                .min_by(|&a, &b| {
                    let change = |k: usize| (slopes[k][i] - slopes[k - 1][i]).abs();
                    change(a).total_cmp(&change(b))
                })
                .expect("more than one step");
            slopes[pair][i]
        })
        .collect();
    let size = centre
        .iter()
        .chain(&best)
        .fold(0.0, |size: f64, x| size.max(x.abs()));
    (best, size)
}

/// The quantities that do not agree.
struct Findings(Vec<String>);

impl Findings {
    fn compare(&mut self, what: &str, given: &[f64], expected: &[f64], tolerance: f64) {
        assert_eq!(given.len(), expected.len(), "{what}");
        for (i, (given, expected)) in given.iter().zip(expected).enumerate() {
            // A NaN is a disagreement, too.
            let agrees = (given - expected).abs() <= tolerance;
            if !agrees {
                self.0.push(format!(
                    "{what}[{i}]: {given:e}, but {expected:e} is expected to within {tolerance:.1e}"
                ));
            }
        }
    }

    /// `given` is d/ds of `function`.
    fn derivative(&mut self, what: &str, given: &[f64], function: &dyn Fn(f64) -> Vec<f64>) {
        let (expected, size) = slope(function);
        self.compare(what, given, &expected, TOLERANCE * size.max(1e-3));
    }

    fn identity(&mut self, what: &str, given: &[f64], expected: &[f64]) {
        let size = expected
            .iter()
            .chain(given)
            .fold(1e-3, |size: f64, x| size.max(x.abs()));
        self.compare(what, given, expected, EXACT * size);
    }
}

/// All functions of a system in dense form, because closures of their arguments would be long.
struct Dense<'a, S, const Q: usize, const N: usize, const R: usize>(&'a S);

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Dense<'_, S, Q, N, R> {
    fn mass(&self, q: &[f64; Q]) -> Vec<f64> {
        let mut mass = Box::new([[0.0; N]; N]);
        self.0.mass_matrix(q, &mut *mass);
        mass.as_flattened().to_vec()
    }
    fn momentum(&self, q: &[f64; Q], v: &[f64; N]) -> Vec<f64> {
        let mut p = [0.0; N];
        self.0.momentum(q, v, &mut p);
        p.to_vec()
    }
    fn holonomic(&self, t: f64, q: &[f64; Q]) -> Vec<f64> {
        let mut phi = [0.0; R];
        self.0.holonomic(t, q, &mut phi);
        phi.to_vec()
    }
    /// φ, A by rows, b.
    fn constraints(&self, t: f64, q: &[f64; Q]) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
        let (mut phi, mut a, mut b) = ([0.0; R], Box::new([[0.0; N]; R]), [0.0; R]);
        self.0.constraints(t, q, &mut phi, &mut *a, &mut b);
        (phi.to_vec(), a.as_flattened().to_vec(), b.to_vec())
    }
    /// A v + b.
    fn rates(&self, t: f64, q: &[f64; Q], v: &[f64; N]) -> Vec<f64> {
        let (_, a, b) = self.constraints(t, q);
        (0..R).map(|i| b[i] + dot(&a[i * N..][..N], v)).collect()
    }
    fn constraint_rates(&self, t: f64, q: &[f64; Q], v: &[f64; N]) -> (Vec<f64>, Vec<f64>) {
        let (mut rate, mut gamma) = (Box::new([[0.0; N]; R]), [0.0; R]);
        self.0.constraint_rates(t, q, v, &mut *rate, &mut gamma);
        (rate.as_flattened().to_vec(), gamma.to_vec())
    }
    fn applied(&self, t: f64, q: &[f64; Q], v: &[f64; N]) -> Vec<f64> {
        let mut f = [0.0; N];
        self.0.applied_forces(t, q, v, &mut f);
        f.to_vec()
    }
    fn total(&self, t: f64, q: &[f64; Q], v: &[f64; N]) -> Vec<f64> {
        let mut f = [0.0; N];
        self.0.forces(t, q, v, &mut f);
        f.to_vec()
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// x + s·direction.
fn along<const N: usize>(x: &[f64; N], s: f64, direction: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|i| x[i] + s * direction[i])
}

fn unit<const N: usize>(i: usize) -> [f64; N] {
    std::array::from_fn(|j| f64::from(u8::from(i == j)))
}

fn column<const N: usize>(matrix: &[[f64; N]], j: usize) -> Vec<f64> {
    matrix.iter().map(|row| row[j]).collect()
}

/// All disagreements at an instant.
pub fn findings<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    at: &Arguments<Q, N, R>,
    random: &mut Random,
) -> Vec<String> {
    let mut findings = Findings(Vec::new());
    motion(&mut findings, system, at);
    constraints(&mut findings, system, at);
    forces(&mut findings, system, at);
    tangents(&mut findings, system, at);
    inertia(&mut findings, system, at);
    kernels(&mut findings, system, at, random);
    findings.0
}

/// (p × ω)_j if v_j is a component of an angular velocity: the term of F in addition to f and ∂T/∂q.
fn gyroscopic<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    p: &[f64],
    v: &[f64; N],
) -> [f64; N] {
    let mut torque = [0.0; N];
    for &first in S::ROTATIONS {
        for i in 0..3 {
            let (j, k) = (first + (i + 1) % 3, first + (i + 2) % 3);
            torque[first + i] = p[j] * v[k] - p[k] * v[j];
        }
    }
    torque
}

/// ⊕, its inverse and free flight.
fn motion<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    findings: &mut Findings,
    system: &S,
    at: &Arguments<Q, N, R>,
) {
    let (q, v) = (&at.q, &at.v);
    findings.identity(
        "q ⊕ v ⊖ q",
        &system.difference(q, &system.advance(q, v, 1.0)),
        v,
    );
    let back = system.advance(&system.advance(q, v, 0.7), v, -0.7);
    findings.identity("q ⊕ h v ⊕ −h v", &back, q);
    let flight = |h: f64| {
        let (mut q, mut v) = (*q, *v);
        system.free_flight(&mut q, &mut v, h);
        (q, v)
    };
    findings.identity("flight of no time", &flight(0.0).1, v);
    for j in 0..N {
        // All of G, not only G v.
        let (rate, _) = slope(&|s| system.advance(q, &unit(j), s).to_vec());
        findings.derivative(&format!("G, column {j}"), &rate, &|s| {
            let mut q = *q;
            system.free_flight(&mut q, &mut unit(j), s);
            q.to_vec()
        });
    }
    if S::STRUCTURE.constant_mass {
        let dense = Dense(system);
        let p = dense.momentum(q, v);
        let torque = gyroscopic::<S, Q, N, R>(&p, v);
        findings.derivative("torque-free motion", &torque, &|s| {
            let (q, v) = flight(s);
            dense.momentum(&q, &v)
        });
        let energy = |(q, v): ([f64; Q], [f64; N])| system.kinetic_energy(&q, &v);
        findings.derivative("T in free flight", &[0.0], &|s| vec![energy(flight(s))]);
    }
}

fn constraints<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    findings: &mut Findings,
    system: &S,
    at: &Arguments<Q, N, R>,
) {
    let dense = Dense(system);
    let (t, q, v) = (at.time, &at.q, &at.v);
    let holonomic = S::STRUCTURE.holonomic_rows;
    let (phi, a, b) = dense.constraints(t, q);
    findings.identity(
        "phi",
        &dense.holonomic(t, q)[..holonomic],
        &phi[..holonomic],
    );
    for j in 0..N {
        let entries: Vec<f64> = (0..holonomic).map(|i| a[i * N + j]).collect();
        findings.derivative(&format!("A, column {j}"), &entries, &|s| {
            dense.holonomic(t, &system.advance(q, &unit(j), s))[..holonomic].to_vec()
        });
    }
    findings.derivative("b", &b[..holonomic], &|s| {
        dense.holonomic(t + s, q)[..holonomic].to_vec()
    });
    let (a_rate, gamma) = dense.constraint_rates(t, q, v);
    findings.derivative("rate of A", &a_rate, &|s| {
        dense.constraints(t + s, &system.advance(q, v, s)).1
    });
    findings.derivative("gamma", &gamma, &|s| {
        dense.rates(t + s, &system.advance(q, v, s), v)
    });
}

/// f + ∂V/∂q is the force without potential.
fn forces<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    findings: &mut Findings,
    system: &S,
    at: &Arguments<Q, N, R>,
) {
    let dense = Dense(system);
    let (t, q, v) = (at.time, &at.q, &at.v);
    let f = dense.applied(t, q, v);
    let power = system.nonconservative_power(t, q, v);
    findings.derivative("f·v − power", &[dot(&f, v) - power], &|s| {
        vec![-system.potential_energy(&system.advance(q, v, s))]
    });
    if !S::STRUCTURE.velocity_forces && power == 0.0 {
        for j in 0..N {
            findings.derivative(&format!("f[{j}]"), &[f[j]], &|s| {
                vec![-system.potential_energy(&system.advance(q, &unit(j), s))]
            });
        }
    }
    let total = dense.total(t, q, v);
    let torque = gyroscopic::<S, Q, N, R>(&dense.momentum(q, v), v);
    let inertial: Vec<f64> = (0..N).map(|j| total[j] - f[j] - torque[j]).collect();
    for j in 0..N {
        // With large applied forces the difference has their round-off.
        let round_off = 1e-8 * f[j];
        findings.derivative(&format!("F − f, {j}"), &[inertial[j], 0.0], &|s| {
            let energy = system.kinetic_energy(&system.advance(q, &unit(j), s), v);
            vec![energy, round_off]
        });
    }
}

fn tangents<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    findings: &mut Findings,
    system: &S,
    at: &Arguments<Q, N, R>,
) {
    let dense = Dense(system);
    let (t, q, v) = (at.time, &at.q, &at.v);
    let (mut f_q, mut f_v) = (Box::new([[0.0; N]; N]), Box::new([[0.0; N]; N]));
    system.applied_force_tangents(t, q, v, &mut *f_q, &mut *f_v);
    let (mut total_q, mut total_v, mut p_q) = (
        Box::new([[0.0; N]; N]),
        Box::new([[0.0; N]; N]),
        Box::new([[0.0; N]; N]),
    );
    system.force_tangents(t, q, v, &mut *total_q, &mut *total_v, &mut *p_q);
    for j in 0..N {
        findings.derivative(&format!("∂f/∂q, column {j}"), &column(&*f_q, j), &|s| {
            dense.applied(t, &system.advance(q, &unit(j), s), v)
        });
        findings.derivative(&format!("∂f/∂v, column {j}"), &column(&*f_v, j), &|s| {
            dense.applied(t, q, &along(v, s, &unit(j)))
        });
        findings.derivative(
            &format!("∂F/∂q, column {j}"),
            &column(&*total_q, j),
            &|s| dense.total(t, &system.advance(q, &unit(j), s), v),
        );
        findings.derivative(
            &format!("∂F/∂v, column {j}"),
            &column(&*total_v, j),
            &|s| dense.total(t, q, &along(v, s, &unit(j))),
        );
        findings.derivative(&format!("∂p/∂q, column {j}"), &column(&*p_q, j), &|s| {
            dense.momentum(&system.advance(q, &unit(j), s), v)
        });
    }
}

fn inertia<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    findings: &mut Findings,
    system: &S,
    at: &Arguments<Q, N, R>,
) {
    let dense = Dense(system);
    let (q, v) = (&at.q, &at.v);
    let mass = dense.mass(q);
    let transposed: Vec<f64> = (0..N * N).map(|i| mass[(i % N) * N + i / N]).collect();
    findings.identity("M, transposed", &transposed, &mass);
    let p = dense.momentum(q, v);
    let expected: Vec<f64> = (0..N).map(|i| dot(&mass[i * N..][..N], v)).collect();
    findings.identity("p", &p, &expected);
    findings.identity("T", &[system.kinetic_energy(q, v)], &[0.5 * dot(v, &p)]);

    let mut gamma = vec![[[0.0; N]; N]; N];
    let mut sink = Affinities(&mut gamma);
    system.affinities(q, &mut sink);
    if S::STRUCTURE.constant_mass && !S::ROTATIONS.is_empty() {
        let product = |i: usize| (0..N).map(|j| v[j] * dot(&gamma[i][j], v)).sum::<f64>();
        let given: Vec<f64> = (0..N).map(product).collect();
        let expected = gyroscopic::<S, Q, N, R>(&p, v).map(|torque| -torque);
        findings.identity("affinities", &given, &expected);
        return;
    }
    if S::STRUCTURE.constant_mass {
        let none = gamma
            .as_flattened()
            .as_flattened()
            .iter()
            .all(|&entry| entry == 0.0);
        findings.identity("affinities", &[f64::from(u8::from(none))], &[1.0]);
        return;
    }
    let slopes: Vec<(Vec<f64>, f64)> = (0..N)
        .map(|k| slope(&|s| dense.mass(&system.advance(q, &unit(k), s))))
        .collect();
    let size = slopes
        .iter()
        .fold(0.0, |size: f64, (_, other)| size.max(*other));
    // (p × ω)_i of a rotation is Σ M_bj v_j ω_k with (i, b, k) an even permutation, less the same with an odd one.
    let turning = |i: usize, j: usize, k: usize| {
        let first = S::ROTATIONS
            .iter()
            .find(|&&first| (first..first + 3).contains(&i) && (first..first + 3).contains(&k));
        first.map_or(0.0, |&first| {
            let (a, c) = (i - first, k - first);
            if a == c {
                return 0.0;
            }
            let b = 3 - a - c;
            let sign = if (a + 1) % 3 == b { 1.0 } else { -1.0 };
            sign * mass[(first + b) * N + j]
        })
    };
    for i in 0..N {
        for j in 0..N {
            let expected: Vec<f64> = (0..N)
                .map(|k| {
                    let slope = |i: usize, j: usize, k: usize| slopes[k].0[i * N + j];
                    0.5 * (slope(i, j, k) + slope(i, k, j) - slope(j, k, i))
                        - 0.5 * (turning(i, j, k) + turning(i, k, j))
                })
                .collect();
            let what = format!("affinities[{i}][{j}]");
            findings.compare(&what, &gamma[i][j], &expected, TOLERANCE * size);
        }
    }
}

struct Affinities<'a, const N: usize>(&'a mut [[[f64; N]; N]]);

impl<const N: usize> mbs_runtime::TensorSink for Affinities<'_, N> {
    fn set(&mut self, i: usize, j: usize, k: usize, value: f64) {
        self.0[i][j][k] = value;
    }
}

fn kernels<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    findings: &mut Findings,
    system: &S,
    at: &Arguments<Q, N, R>,
    random: &mut Random,
) {
    let dense = Dense(system);
    let q = &at.q;
    let mass = dense.mass(q);
    let times_mass =
        |x: &[f64; N]| -> [f64; N] { std::array::from_fn(|i| dot(&mass[i * N..][..N], x)) };
    let Some(factor) = system.factor_mass(q) else {
        findings.0.push("M is not positive definite".to_owned());
        return;
    };
    let x: [f64; N] = random.array(1.0);
    let mut y = times_mass(&x);
    system.solve_mass(&factor, &mut y);
    // The condition number of M limits the digits.
    findings.compare("M⁻¹ M x", &y, &x, 1e-8);

    let mut a = Box::new([[0.0; N]; R]);
    system.constraints(at.time, q, &mut [0.0; R], &mut *a, &mut [0.0; R]);
    // Any rows with the zeros of A.
    a.as_flattened_mut()
        .iter_mut()
        .filter(|entry| **entry != 0.0)
        .for_each(|entry| {
            *entry = 0.5 + random.within(1.0);
        });
    let mut rates = [0.0; R];
    system.row_rates(&a, &x, &mut rates);
    let expected: Vec<f64> = a.iter().map(|row| dot(row, &x)).collect();
    findings.identity("A v", &rates, &expected);
    let mut w = Box::new([[0.0; N]; R]);
    system.solve_mass_rows(&factor, &a, &mut w);
    for i in 0..R {
        let mut expected = a[i];
        system.solve_mass(&factor, &mut expected);
        findings.identity(&format!("row {i} of M⁻¹ a"), &w[i], &expected);
    }
    let mut delassus = Box::new([[0.0; R]; R]);
    system.delassus(&a, &w, &mut delassus);
    for i in 0..R {
        let expected: Vec<f64> = (0..R).map(|j| dot(&a[i], &w[j])).collect();
        findings.identity(
            &format!("row {i} of the Gram matrix"),
            &delassus[i],
            &expected,
        );
    }
    let mut a = Box::new([[0.0; N]; R]);
    system.constraints(at.time, q, &mut [0.0; R], &mut *a, &mut [0.0; R]);
    let mut w = Box::new([[0.0; N]; R]);
    system.metric(&factor, at.time, q, &a, &mut w, &mut delassus);
    for i in 0..R {
        let mut expected = a[i];
        system.solve_mass(&factor, &mut expected);
        findings.identity(&format!("row {i} of W of the metric"), &w[i], &expected);
    }
    for i in 0..R {
        let expected: Vec<f64> = (0..R).map(|j| dot(&a[i], &w[j])).collect();
        findings.identity(
            &format!("row {i} of A W of the metric"),
            &delassus[i],
            &expected,
        );
    }
    let mut explicit = [0.0; N];
    system.acceleration(at.time, q, &mut explicit);
    if S::STRUCTURE.constant_mass && !S::STRUCTURE.velocity_forces {
        let mut expected = [0.0; N];
        system.applied_forces(at.time, q, &at.v, &mut expected);
        system.solve_mass(&factor, &mut expected);
        findings.identity("M⁻¹ f", &explicit, &expected);
    }
    accelerations(findings, system, at, random, &mass);
}

/// M v̇ + ṗ|_v = F + Aᵀλ, and A v̇ + γ + correction = 0 for every selected row.
fn accelerations<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    findings: &mut Findings,
    system: &S,
    at: &Arguments<Q, N, R>,
    random: &mut Random,
    mass: &[f64],
) {
    let (t, q, v) = (at.time, &at.q, &at.v);
    let correction = random.array(1.0);
    let (mut acceleration, mut lambda, mut weakness) = ([0.0; N], [0.0; R], [0.0; R]);
    let into = (&mut acceleration, &mut lambda, &mut weakness);
    if !system.accelerations(t, q, v, &correction, into.0, into.1, into.2) {
        return;
    }
    let mut a = Box::new([[0.0; N]; R]);
    system.constraints(t, q, &mut [0.0; R], &mut *a, &mut [0.0; R]);
    let mut f = [0.0; N];
    system.forces(t, q, v, &mut f);
    let [mut f_q, mut f_v, mut p_q] = [(); 3].map(|()| Box::new([[0.0; N]; N]));
    system.force_tangents(t, q, v, &mut *f_q, &mut *f_v, &mut *p_q);
    let inertial: Vec<f64> = (0..N)
        .map(|i| dot(&mass[i * N..][..N], &acceleration) + dot(&p_q[i], v))
        .collect();
    let driving: Vec<f64> = (0..N)
        .map(|i| f[i] + (0..R).map(|r| a[r][i] * lambda[r]).sum::<f64>())
        .collect();
    let size = |list: &[f64]| list.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
    let tolerance = 1e-9 * size(&inertial).max(size(&lambda));
    findings.compare("M v̇ + ṗ against F + Aᵀλ", &inertial, &driving, tolerance);
    let mut gamma = [0.0; R];
    system.constraint_rates(
        t,
        q,
        v,
        &mut Box::new([[0.0; N]; R]) as &mut [[f64; N]; R],
        &mut gamma,
    );
    let redundant = S::MODEL.mobility.as_ref();
    let asked = |r: &usize| {
        let name = S::MODEL.rows[*r].name;
        !redundant.is_some_and(|found| found.redundant.iter().any(|row| row.row == name))
    };
    let rows: Vec<usize> = (0..R).filter(asked).collect();
    let met: Vec<f64> = rows.iter().map(|&r| dot(&a[r], &acceleration)).collect();
    let wanted: Vec<f64> = rows.iter().map(|&r| -gamma[r] - correction[r]).collect();
    findings.compare("A v̇ + γ", &met, &wanted, 1e-9 * size(&wanted));
}
