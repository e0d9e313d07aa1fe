//! Andrews' squeezer mechanism written by hand: M, forces and rows in the seven angles of the test set (Hairer, Wanner:
//! Solving Ordinary Differential Equations II, section VII.7), for the integrator that runs the generated equations,
//! too. M has three blocks of two and one of one; it varies only with three sines. The rows are the differences between
//! E on each of three chains and E on the first chain. Zeros are left out, and constants are precomputed.

use mbs_examples::scenes::andrews::Andrews as Generated;
use mbs_runtime::generated::{rows, rows_mut};
use mbs_runtime::nalgebra::{SMatrix, SVector};
use mbs_runtime::{
    Configuration, Constraints, Inertia, Loads, MatrixSink, Mechanism, Model, Observables,
    Structure, System, TensorSink,
};

/// β, θ, γ, φ, δ, Ω, ε.
const N: usize = 7;
/// E on three chains.
const R: usize = 6;

// Positions, m.
const XA: f64 = -0.06934;
const YA: f64 = -0.00227;
const XB: f64 = -0.03635;
const YB: f64 = 0.03273;
const XC: f64 = 0.014;
const YC: f64 = 0.072;
// Lengths, m.
const RR: f64 = 0.007;
const D: f64 = 0.028;
const SS: f64 = 0.035;
const E: f64 = 0.02;
const ZT: f64 = 0.04;
const ZF: f64 = 0.02;
const U: f64 = 0.04;
/// D from B, m.
const SD: f64 = 0.02;
const SC: f64 = 0.018;
/// Motor, N m.
const MOTOR: f64 = 0.033;
/// Spring, N/m and m.
const STIFFNESS: f64 = 4530.0;
const FREE_LENGTH: f64 = 0.07785;
/// B − C, m.
const KX: f64 = XB - XC;
const KY: f64 = YB - YC;
const SPRING: f64 = KX * KX + KY * KY + SD * SD + SC * SC;

// M = [[M_AA − 2 C_A s, M_AB − C_A s], [·, M_BB]] for each pair of angles.
const OF_FE: Pair = Pair {
    outer: 0.04325 * 0.00092 * 0.00092
        + 2.194e-6
        + 0.00365 * (RR * RR + 0.0115 * 0.0115)
        + 4.410e-7,
    inner: 0.00365 * 0.0115 * 0.0115 + 4.410e-7,
    coupling: 0.00365 * 0.0115 * RR,
};
const BDE: f64 = 0.02373 * (0.01874 * 0.01874 + 0.01043 * 0.01043) + 5.255e-6;
const AG_GE: Pair = Pair {
    outer: 0.00706 * (ZT * ZT + 0.00579 * 0.00579)
        + 0.07050 * (0.02308 * 0.02308 + 0.00916 * 0.00916)
        + 5.667e-7
        + 1.169e-5,
    inner: 0.00706 * 0.00579 * 0.00579 + 5.667e-7,
    coupling: 0.00706 * ZT * 0.00579,
};
const AH_HE: Pair = Pair {
    outer: 0.00706 * (U * U + 0.00579 * 0.00579)
        + 0.05498 * (0.01228 * 0.01228 + 0.00449 * 0.00449)
        + 5.667e-7
        + 1.912e-5,
    inner: 0.00706 * 0.00579 * 0.00579 + 5.667e-7,
    coupling: 0.00706 * U * 0.00579,
};

/// Where the first and the second angle of each pair are stored, beside how its coupling varies with the second:
/// −cos θ, sin φ, −sin Ω.
const PAIRS: [(usize, usize, Pair); 3] = [(0, 1, OF_FE), (4, 3, AG_GE), (6, 5, AH_HE)];
const GAMMA: usize = 2;

/// Two bars, the second at the end of the first, in the angle of the first and the angle between them: M = [[outer + 2
/// C s, inner + C s], [inner + C s, inner]].
#[derive(Clone, Copy)]
struct Pair {
    outer: f64,
    inner: f64,
    coupling: f64,
}

/// C s of each pair, and its derivative.
fn couplings(q: &SVector<f64, N>) -> [(f64, f64); 3] {
    let ((st, ct), (sp, cp), (so, co)) = (q[1].sin_cos(), q[3].sin_cos(), q[5].sin_cos());
    let [a, b, c] = PAIRS.map(|(.., pair)| pair.coupling);
    [(-a * ct, a * st), (b * sp, b * cp), (-c * so, -c * co)]
}

/// M⁻¹ of each pair, (outer, mixed, inner).
#[derive(Clone)]
pub struct Inverse([[f64; 3]; 3]);

/// The mechanism.
#[derive(Clone)]
pub struct Andrews;

/// −cos and −sin of an angle, by lengths: the directions of the rows.
struct Places {
    /// R cos β, R sin β, and D cos(β + θ), D sin(β + θ).
    crank: [f64; 2],
    fe: [f64; 2],
    gamma: [f64; 2],
    ge: [f64; 2],
    delta: [f64; 2],
    he: [f64; 2],
    epsilon: [f64; 2],
}

impl Places {
    fn new(q: &SVector<f64, N>) -> Self {
        let by = |length: f64, angle: f64| {
            let (s, c) = angle.sin_cos();
            [length * c, length * s]
        };
        Places {
            crank: by(RR, q[0]),
            fe: by(D, q[0] + q[1]),
            gamma: by(SS, q[2]),
            ge: by(E, q[3] + q[4]),
            delta: by(ZT, q[4]),
            he: by(ZF, q[5] + q[6]),
            epsilon: by(U, q[6]),
        }
    }

    fn rows(&self, phi: &mut SVector<f64, R>) {
        let (ex, ey) = (self.crank[0] - self.fe[0], self.crank[1] - self.fe[1]);
        phi[0] = ex - self.gamma[1] - XB;
        phi[1] = ey + self.gamma[0] - YB;
        phi[2] = ex - self.ge[1] - self.delta[0] - XA;
        phi[3] = ey + self.ge[0] - self.delta[1] - YA;
        phi[4] = ex - self.he[0] - self.epsilon[1] - XA;
        phi[5] = ey - self.he[1] + self.epsilon[0] - YA;
    }
}

/// The spring's moment on γ with its derivative: V = ½ c (L − l)², L² = |r + k|² with r = D − B, k = B − C.
fn spring(gamma: f64) -> (f64, f64) {
    let (s, c) = gamma.sin_cos();
    let along = KX * (SD * c + SC * s) + KY * (SD * s - SC * c);
    let across = KX * (SC * c - SD * s) + KY * (SD * c + SC * s);
    let square = SPRING + 2.0 * along;
    let slack = FREE_LENGTH / square.sqrt();
    let pull = STIFFNESS * (1.0 - slack);
    let stiffening = STIFFNESS * slack / square * across * across;
    (-pull * across, pull * along - stiffening)
}

fn motor(f: &mut SVector<f64, N>) {
    f[0] = MOTOR;
}

impl Configuration<N, N> for Andrews {
    const ROTATIONS: &'static [usize] = &[];

    fn guess(&self) -> (SVector<f64, N>, SVector<f64, N>) {
        (SVector::zeros(), SVector::zeros())
    }
    #[inline]
    fn advance(&self, q: &SVector<f64, N>, v: &SVector<f64, N>, h: f64) -> SVector<f64, N> {
        q + h * v
    }
    fn difference(&self, from: &SVector<f64, N>, to: &SVector<f64, N>) -> SVector<f64, N> {
        to - from
    }
    fn free_flight(&self, q: &mut SVector<f64, N>, v: &mut SVector<f64, N>, h: f64) {
        *q = self.advance(q, v, h);
    }
}

impl Inertia<N, N> for Andrews {
    type Mass = Inverse;

    #[inline]
    fn mass_matrix(&self, q: &SVector<f64, N>, mass: &mut impl MatrixSink) {
        write_mass(&couplings(q), mass);
    }
    #[inline]
    fn factor_mass(&self, q: &SVector<f64, N>) -> Option<Inverse> {
        let couplings = couplings(q);
        let blocks: [[f64; 3]; 3] = std::array::from_fn(|k| {
            let (pair, c) = (PAIRS[k].2, couplings[k].0);
            let (outer, mixed) = (pair.outer + 2.0 * c, pair.inner + c);
            let inverse = 1.0 / (outer * pair.inner - mixed * mixed);
            [inverse * pair.inner, -inverse * mixed, inverse * outer]
        });
        Some(Inverse(blocks))
    }
    #[inline]
    fn solve_mass(&self, mass: &Inverse, x: &mut SVector<f64, N>) {
        for ((i, j, _), block) in PAIRS.iter().zip(&mass.0) {
            let (a, b) = (x[*i], x[*j]);
            x[*i] = block[0] * a + block[1] * b;
            x[*j] = block[1] * a + block[2] * b;
        }
        x[GAMMA] *= 1.0 / BDE;
    }
    #[inline]
    fn momentum(&self, q: &SVector<f64, N>, v: &SVector<f64, N>, p: &mut SVector<f64, N>) {
        momentum(&couplings(q), v, p);
    }
    fn affinities(&self, _: &SVector<f64, N>, _: &mut impl TensorSink) {}
    fn kinetic_energy(&self, _: &SVector<f64, N>, _: &SVector<f64, N>) -> f64 {
        0.0
    }
}

impl Constraints<N, N, R> for Andrews {
    #[inline]
    fn holonomic(&self, _: f64, q: &SVector<f64, N>, phi: &mut SVector<f64, R>) {
        Places::new(q).rows(phi);
    }
    #[inline]
    fn constraints(
        &self,
        _: f64,
        q: &SVector<f64, N>,
        phi: &mut SVector<f64, R>,
        a: &mut impl MatrixSink,
        _: &mut SVector<f64, R>,
    ) {
        let places = Places::new(q);
        places.rows(phi);
        let [c, s] = places.fe;
        let (bx, by) = (s - places.crank[1], places.crank[0] - c);
        for k in [0, 2, 4] {
            a.set(k, 0, bx);
            a.set(k, 1, s);
            a.set(k + 1, 0, by);
            a.set(k + 1, 1, -c);
        }
        a.set(0, 2, -places.gamma[0]);
        a.set(1, 2, -places.gamma[1]);
        a.set(2, 3, -places.ge[0]);
        a.set(2, 4, places.delta[1] - places.ge[0]);
        a.set(3, 3, -places.ge[1]);
        a.set(3, 4, -places.ge[1] - places.delta[0]);
        a.set(4, 5, places.he[1]);
        a.set(4, 6, places.he[1] - places.epsilon[0]);
        a.set(5, 5, -places.he[0]);
        a.set(5, 6, -places.he[0] - places.epsilon[1]);
    }
    fn constraint_rates(
        &self,
        _: f64,
        _: &SVector<f64, N>,
        _: &SVector<f64, N>,
        _: &mut impl MatrixSink,
        _: &mut SVector<f64, R>,
    ) {
    }
    #[inline]
    fn row_rates(&self, a: &SMatrix<f64, N, R>, v: &SVector<f64, N>, rates: &mut SVector<f64, R>) {
        let a = rows(a);
        for i in 0..2 {
            let shared = a[i][0] * v[0] + a[i][1] * v[1];
            rates[i] = shared + a[i][2] * v[2];
            rates[i + 2] = shared + a[i + 2][3] * v[3] + a[i + 2][4] * v[4];
            rates[i + 4] = shared + a[i + 4][5] * v[5] + a[i + 4][6] * v[6];
        }
    }
    #[inline]
    fn solve_mass_rows(&self, mass: &Inverse, a: &SMatrix<f64, N, R>, w: &mut SMatrix<f64, N, R>) {
        let (a, w) = (rows(a), rows_mut(w));
        for r in 0..R {
            // Each row holds OF and FE, and one of the others.
            let pair = |(i, j, _): (usize, usize, Pair), block: &[f64; 3], w: &mut [f64; N]| {
                w[i] = block[0] * a[r][i] + block[1] * a[r][j];
                w[j] = block[1] * a[r][i] + block[2] * a[r][j];
            };
            pair(PAIRS[0], &mass.0[0], &mut w[r]);
            match r / 2 {
                0 => w[r][GAMMA] = a[r][GAMMA] * (1.0 / BDE),
                k => pair(PAIRS[k], &mass.0[k], &mut w[r]),
            }
        }
    }
    #[inline]
    fn delassus(
        &self,
        a: &SMatrix<f64, N, R>,
        w: &SMatrix<f64, N, R>,
        delassus: &mut SMatrix<f64, R, R>,
    ) {
        let (a, w, delassus) = (rows(a), rows(w), rows_mut(delassus));
        for i in 0..R {
            for j in 0..R {
                let mut sum = a[i][0] * w[j][0] + a[i][1] * w[j][1];
                if i / 2 == j / 2 {
                    sum += match i / 2 {
                        0 => a[i][2] * w[j][2],
                        1 => a[i][3] * w[j][3] + a[i][4] * w[j][4],
                        _ => a[i][5] * w[j][5] + a[i][6] * w[j][6],
                    };
                }
                delassus[i][j] = sum;
            }
        }
    }
}

impl Loads<N, N> for Andrews {
    fn inputs(&self) -> &[f64] {
        &[]
    }
    fn inputs_mut(&mut self) -> &mut [f64] {
        &mut []
    }
    #[inline]
    fn applied_forces(
        &self,
        _: f64,
        q: &SVector<f64, N>,
        _: &SVector<f64, N>,
        f: &mut SVector<f64, N>,
    ) {
        motor(f);
        f[GAMMA] = spring(q[GAMMA]).0;
    }
    #[inline]
    fn forces(&self, _: f64, q: &SVector<f64, N>, v: &SVector<f64, N>, f: &mut SVector<f64, N>) {
        forces(&couplings(q), q, v, f);
    }
    fn applied_force_tangents(
        &self,
        _: f64,
        q: &SVector<f64, N>,
        _: &SVector<f64, N>,
        f_q: &mut impl MatrixSink,
        _: &mut impl MatrixSink,
    ) {
        f_q.set(GAMMA, GAMMA, spring(q[GAMMA]).1);
    }
    #[inline]
    fn force_tangents(
        &self,
        _: f64,
        q: &SVector<f64, N>,
        v: &SVector<f64, N>,
        f_q: &mut impl MatrixSink,
        f_v: &mut impl MatrixSink,
        p_q: &mut impl MatrixSink,
    ) {
        tangents(&couplings(q), q, v, f_q, f_v, p_q);
    }
    #[inline]
    fn balance(
        &self,
        _: f64,
        q: &SVector<f64, N>,
        v: &SVector<f64, N>,
        p: &mut SVector<f64, N>,
        f: &mut SVector<f64, N>,
    ) {
        let couplings = couplings(q);
        momentum(&couplings, v, p);
        forces(&couplings, q, v, f);
    }
    #[inline]
    fn balance_tangents(
        &self,
        _: f64,
        q: &SVector<f64, N>,
        v: &SVector<f64, N>,
        mass: &mut impl MatrixSink,
        f_q: &mut impl MatrixSink,
        f_v: &mut impl MatrixSink,
        p_q: &mut impl MatrixSink,
    ) {
        let couplings = couplings(q);
        write_mass(&couplings, mass);
        tangents(&couplings, q, v, f_q, f_v, p_q);
    }
    fn acceleration(&self, _: f64, _: &SVector<f64, N>, _: &mut SVector<f64, N>) {}
    fn potential_energy(&self, _: &SVector<f64, N>) -> f64 {
        0.0
    }
    fn nonconservative_power(&self, _: f64, _: &SVector<f64, N>, _: &SVector<f64, N>) -> f64 {
        0.0
    }
}

// A stepper does not ask for these.
impl Observables<N, N, R> for Andrews {
    fn outputs(&self, _: f64, _: &SVector<f64, N>, _: &SVector<f64, N>, _: &mut [f64]) {}
    fn events(&self, _: f64, _: &SVector<f64, N>, _: &SVector<f64, N>, _: &mut [f64]) {}
    fn points(&self, _: f64, _: &SVector<f64, N>, _: &mut [[f64; 3]]) {}
    fn reactions(
        &self,
        _: f64,
        _: &SVector<f64, N>,
        _: &SVector<f64, N>,
        _: &SVector<f64, N>,
        _: &SVector<f64, R>,
        _: &mut [f64],
    ) {
    }
}

impl System<N, N, R> for Andrews {
    const MODEL: &'static Model = Generated::MODEL;
    const STRUCTURE: Structure = Generated::MODEL.structure;
}

#[inline]
fn write_mass(couplings: &[(f64, f64); 3], mass: &mut impl MatrixSink) {
    for (&(i, j, pair), &(c, _)) in PAIRS.iter().zip(couplings) {
        mass.set(i, i, pair.outer + 2.0 * c);
        mass.set(i, j, pair.inner + c);
        mass.set(j, i, pair.inner + c);
        mass.set(j, j, pair.inner);
    }
    mass.set(GAMMA, GAMMA, BDE);
}

#[inline]
fn momentum(couplings: &[(f64, f64); 3], v: &SVector<f64, N>, p: &mut SVector<f64, N>) {
    for (&(i, j, pair), &(c, _)) in PAIRS.iter().zip(couplings) {
        let both = v[i] + v[j];
        p[j] = pair.inner * both + c * v[i];
        p[i] = (pair.outer - pair.inner) * v[i] + p[j] + c * both;
    }
    p[GAMMA] = BDE * v[GAMMA];
}

#[inline]
fn forces(
    couplings: &[(f64, f64); 3],
    q: &SVector<f64, N>,
    v: &SVector<f64, N>,
    f: &mut SVector<f64, N>,
) {
    motor(f);
    f[4] = 0.0;
    f[6] = 0.0;
    for (&(i, j, _), &(_, slope)) in PAIRS.iter().zip(couplings) {
        f[j] = slope * v[i] * (v[i] + v[j]);
    }
    f[GAMMA] = spring(q[GAMMA]).0;
}

/// ∂F/∂q, ∂F/∂v and ∂p/∂q. (The second derivative of C s is −C s.)
#[inline]
fn tangents(
    couplings: &[(f64, f64); 3],
    q: &SVector<f64, N>,
    v: &SVector<f64, N>,
    f_q: &mut impl MatrixSink,
    f_v: &mut impl MatrixSink,
    p_q: &mut impl MatrixSink,
) {
    for (&(i, j, _), &(c, slope)) in PAIRS.iter().zip(couplings) {
        let first = slope * v[i];
        let twice = slope * (2.0 * v[i] + v[j]);
        f_q.set(j, j, -c * v[i] * (v[i] + v[j]));
        f_v.set(j, i, twice);
        f_v.set(j, j, first);
        p_q.set(i, j, twice);
        p_q.set(j, j, first);
    }
    f_q.set(GAMMA, GAMMA, spring(q[GAMMA]).1);
}
