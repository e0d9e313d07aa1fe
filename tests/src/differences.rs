//! Compiled derivatives compared with differences of the functions from which they are derived.

mod dense;

use self::dense::{Dense, list, unit, zeros};
use crate::random::{Arguments, Random};
use mbs_runtime::System;
use mbs_runtime::nalgebra::{SMatrix, SVector, Vector3};

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
    p: &SVector<f64, N>,
    v: &SVector<f64, N>,
) -> SVector<f64, N> {
    let mut torque = SVector::<f64, N>::zeros();
    for &first in S::ROTATIONS {
        let [p, v] = [p, v].map(|x| Vector3::from_column_slice(&x.as_slice()[first..][..3]));
        torque.as_mut_slice()[first..][..3].copy_from_slice(p.cross(&v).as_slice());
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
        system.difference(q, &system.advance(q, v, 1.0)).as_slice(),
        v.as_slice(),
    );
    let back = system.advance(&system.advance(q, v, 0.7), v, -0.7);
    findings.identity("q ⊕ h v ⊕ −h v", back.as_slice(), q.as_slice());
    let flight = |h: f64| {
        let (mut q, mut v) = (*q, *v);
        system.free_flight(&mut q, &mut v, h);
        (q, v)
    };
    findings.identity("flight of no time", flight(0.0).1.as_slice(), v.as_slice());
    for j in 0..N {
        // All of G, and not only along v.
        let (rate, _) = slope(&|s| list(&system.advance(q, &unit(j), s)));
        findings.derivative(&format!("G, column {j}"), &rate, &|s| {
            let mut q = *q;
            system.free_flight(&mut q, &mut unit(j), s);
            list(&q)
        });
    }
    if S::STRUCTURE.constant_mass {
        let dense = Dense(system);
        let p = dense.momentum(q, v);
        let torque = gyroscopic::<S, Q, N, R>(&p, v);
        findings.derivative("torque-free motion", torque.as_slice(), &|s| {
            let (q, v) = flight(s);
            list(&dense.momentum(&q, &v))
        });
        let energy = |(q, v): (SVector<f64, Q>, SVector<f64, N>)| system.kinetic_energy(&q, &v);
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
        &list(&dense.holonomic(t, q))[..holonomic],
        &phi.as_slice()[..holonomic],
    );
    for j in 0..N {
        let entries = a.column(j);
        let entries = &entries.as_slice()[..holonomic];
        findings.derivative(&format!("A, column {j}"), entries, &|s| {
            let phi = dense.holonomic(t, &system.advance(q, &unit(j), s));
            phi.as_slice()[..holonomic].to_vec()
        });
    }
    findings.derivative("b", &b.as_slice()[..holonomic], &|s| {
        dense.holonomic(t + s, q).as_slice()[..holonomic].to_vec()
    });
    let (a_rate, gamma) = dense.constraint_rates(t, q, v);
    findings.derivative("rate of A", a_rate.as_slice(), &|s| {
        list(&dense.constraints(t + s, &system.advance(q, v, s)).1)
    });
    findings.derivative("gamma", gamma.as_slice(), &|s| {
        list(&dense.rates(t + s, &system.advance(q, v, s), v))
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
    let motion = without_states::<S, Q, N, R>(v);
    findings.derivative("f·v − power", &[f.dot(&motion) - power], &|s| {
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
    let inertial = total - f - torque;
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
    let [mut f_q, mut f_v] = [(); 2].map(|()| zeros::<N, N>());
    system.applied_force_tangents(t, q, v, &mut f_q, &mut f_v);
    let [mut total_q, mut total_v, mut p_q] = [(); 3].map(|()| zeros::<N, N>());
    system.force_tangents(t, q, v, &mut total_q, &mut total_v, &mut p_q);
    let mut free = SVector::zeros();
    system.free_forces(t, q, v, &mut free);
    let expected = dense.total(t, q, v) - *p_q * v;
    findings.identity("F − ṗ|_v", free.as_slice(), expected.as_slice());
    for j in 0..N {
        let mut column =
            |what: &str, matrix: &SMatrix<f64, N, N>, function: &dyn Fn(f64) -> SVector<f64, N>| {
                let given = matrix.column(j).into_owned();
                let what = format!("{what}, column {j}");
                findings.derivative(&what, given.as_slice(), &|s| list(&function(s)));
            };
        column("∂f/∂q", &f_q, &|s| {
            dense.applied(t, &system.advance(q, &unit(j), s), v)
        });
        column("∂f/∂v", &f_v, &|s| {
            dense.applied(t, q, &(v + s * unit(j)))
        });
        column("∂F/∂q", &total_q, &|s| {
            dense.total(t, &system.advance(q, &unit(j), s), v)
        });
        column("∂F/∂v", &total_v, &|s| {
            dense.total(t, q, &(v + s * unit(j)))
        });
        column("∂p/∂q", &p_q, &|s| {
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
    findings.identity(
        "M, transposed",
        mass.transpose().as_slice(),
        mass.as_slice(),
    );
    let p = dense.momentum(q, v);
    findings.identity("p", p.as_slice(), (*mass * v).as_slice());
    let motion = without_states::<S, Q, N, R>(v);
    findings.identity("T", &[system.kinetic_energy(q, v)], &[0.5 * motion.dot(&p)]);

    let mut gamma = vec![[[0.0; N]; N]; N];
    let mut sink = Affinities(&mut gamma);
    system.affinities(q, &mut sink);
    if S::STRUCTURE.constant_mass && !S::ROTATIONS.is_empty() {
        let row = |i: usize, j: usize| SVector::from(gamma[i][j]).dot(v);
        let product = |i: usize| (0..N).map(|j| v[j] * row(i, j)).sum::<f64>();
        let given: Vec<f64> = (0..N).map(product).collect();
        let expected = -gyroscopic::<S, Q, N, R>(&p, v);
        findings.identity("affinities", &given, expected.as_slice());
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
        .map(|k| slope(&|s| list(&dense.mass(&system.advance(q, &unit(k), s)))))
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
            sign * mass[(first + b, j)]
        })
    };
    for i in 0..N {
        for j in 0..N {
            let expected: Vec<f64> = (0..N)
                .map(|k| {
                    let slope = |i: usize, j: usize, k: usize| slopes[k].0[j * N + i];
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
    let Some(factor) = system.factor_mass(q) else {
        findings.0.push("M is not positive definite".to_owned());
        return;
    };
    let solved = |mut x: SVector<f64, N>| {
        system.solve_mass(&factor, &mut x);
        x
    };
    let x: SVector<f64, N> = random.vector(1.0);
    // The condition number of M decides about the digits.
    findings.compare("M⁻¹ M x", solved(*mass * x).as_slice(), x.as_slice(), 1e-8);

    let metric = |findings: &mut Findings,
                  of: &str,
                  a: &SMatrix<f64, N, R>,
                  w: &SMatrix<f64, N, R>,
                  delassus: &SMatrix<f64, R, R>| {
        for i in 0..R {
            let expected = solved(a.column(i).into_owned());
            let what = format!("row {i} of M⁻¹ a{of}");
            findings.identity(&what, w.column(i).as_slice(), expected.as_slice());
        }
        for i in 0..R {
            let expected = w.tr_mul(&a.column(i));
            let what = format!("row {i} of A W{of}");
            findings.identity(&what, delassus.column(i).as_slice(), expected.as_slice());
        }
    };
    // Aᵀ; any rows with the zeros of A.
    let rows = Box::new(dense.constraints(at.time, q).1.transpose());
    let a = Box::new(rows.map(|entry| match entry {
        0.0 => 0.0,
        _ => 0.5 + random.within(1.0),
    }));
    let mut rates = SVector::zeros();
    system.row_rates(&a, &x, &mut rates);
    findings.identity("A v", rates.as_slice(), a.tr_mul(&x).as_slice());
    let (mut w, mut delassus) = (zeros(), zeros());
    system.solve_mass_rows(&factor, &a, &mut w);
    system.delassus(&a, &w, &mut delassus);
    metric(findings, "", &a, &w, &delassus);
    w.fill(0.0);
    system.metric(&factor, at.time, q, &rows, &mut w, &mut delassus);
    metric(findings, " of the metric", &rows, &w, &delassus);

    let mut explicit = SVector::zeros();
    system.acceleration(at.time, q, &mut explicit);
    if S::STRUCTURE.constant_mass && !S::STRUCTURE.velocity_forces {
        let expected = solved(dense.applied(at.time, q, &at.v));
        findings.identity("M⁻¹ f", explicit.as_slice(), expected.as_slice());
    }
    accelerations(findings, system, at, random, &mass);
}

/// M v̇ + ṗ|_v = F + Aᵀλ, and A v̇ + γ + correction = 0 for every selected row.
fn accelerations<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    findings: &mut Findings,
    system: &S,
    at: &Arguments<Q, N, R>,
    random: &mut Random,
    mass: &SMatrix<f64, N, N>,
) {
    let dense = Dense(system);
    let (t, q, v) = (at.time, &at.q, &at.v);
    let correction = random.vector(1.0);
    let mut acceleration = SVector::zeros();
    let (mut lambda, mut inverse_pivot) = (SVector::zeros(), SVector::zeros());
    let (_, a, _) = dense.constraints(t, q);
    partitioned(findings, system, at, (&correction, &a, mass));
    let into = (&mut acceleration, &mut lambda, &mut inverse_pivot);
    if !system.accelerations(t, q, v, &correction, into.0, into.1, into.2) {
        return;
    }
    let [mut f_q, mut f_v, mut p_q] = [(); 3].map(|()| zeros::<N, N>());
    system.force_tangents(t, q, v, &mut f_q, &mut f_v, &mut p_q);
    let inertial = mass * acceleration + *p_q * v;
    let driving = dense.total(t, q, v) + a.tr_mul(&lambda);
    let size = |list: &[f64]| list.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
    let tolerance = 1e-9 * size(inertial.as_slice()).max(size(lambda.as_slice()));
    findings.compare(
        "M v̇ + ṗ against F + Aᵀλ",
        inertial.as_slice(),
        driving.as_slice(),
        tolerance,
    );
    let (_, gamma) = dense.constraint_rates(t, q, v);
    let redundant = S::MODEL.mobility.as_ref();
    let asked = |r: &usize| {
        let name = S::MODEL.rows[*r].name;
        !redundant.is_some_and(|found| found.redundant.iter().any(|row| row.row == name))
    };
    let rows: Vec<usize> = (0..R).filter(asked).collect();
    let (met, wanted) = (*a * acceleration, -gamma - correction);
    let [met, wanted] = [met, wanted].map(|x| rows.iter().map(|&r| x[r]).collect::<Vec<_>>());
    findings.compare("A v̇ + γ", &met, &wanted, 1e-9 * size(&wanted));
}

/// A v̇ + γ + correction = 0 for every row, and M v̇ + ṗ|_v − F has no part along velocities that the rows allow.
fn partitioned<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    findings: &mut Findings,
    system: &S,
    at: &Arguments<Q, N, R>,
    (correction, a, mass): (&SVector<f64, R>, &SMatrix<f64, R, N>, &SMatrix<f64, N, N>),
) {
    let dense = Dense(system);
    let (t, q, v) = (at.time, &at.q, &at.v);
    let (mut acceleration, mut weakness) = (SVector::zeros(), SVector::zeros());
    let into = (&mut acceleration, &mut weakness);
    let available = system.partitioned_accelerations(t, q, v, correction, into.0, into.1);
    assert_eq!(available, S::PARTITIONED);
    let weakest = weakness.max();
    if !available || weakest > 1e4 {
        return;
    }
    let size = |list: &[f64]| list.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
    let (_, gamma) = dense.constraint_rates(t, q, v);
    let (met, wanted) = (a * acceleration, -gamma - correction);
    let tolerance = 1e-10 * weakest.max(1.0) * size(wanted.as_slice());
    let (met, wanted) = (met.as_slice(), wanted.as_slice());
    findings.compare("A v̇ + γ by independent velocities", met, wanted, tolerance);
    let [mut f_q, mut f_v, mut p_q] = [(); 3].map(|()| zeros::<N, N>());
    system.force_tangents(t, q, v, &mut f_q, &mut f_v, &mut p_q);
    let left = mass * acceleration + *p_q * v - dense.total(t, q, v);
    // What is left is Aᵀλ with the λ of the normal equations.
    let normal = a * a.transpose();
    let Some(normal) = normal.cholesky() else {
        return;
    };
    let lambda = normal.solve(&(a * left));
    let pushes = a.tr_mul(&lambda);
    let tolerance = 1e-8 * weakest.max(1.0) * size(left.as_slice());
    let (left, pushes) = (left.as_slice(), pushes.as_slice());
    findings.compare("M v̇ + ṗ − F against Aᵀλ", left, pushes, tolerance);
}

/// The velocities without states, which have no energy.
fn without_states<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    v: &SVector<f64, N>,
) -> SVector<f64, N> {
    let mut motion = *v;
    for state in S::STATES {
        motion[state.velocity] = 0.0;
    }
    motion
}
