//! The inertia terms of Lagrange's equations compared with the equations of Newton and Euler: m a of every centre of
//! mass and J ω̇ + ω × J ω of every body, with masses and tensors written here and accelerations from differences along
//! the motion. Also: the power is dE/dt.

use mbs_examples::scenes;
use mbs_macros_core::Analysis;
use mbs_macros_core::symbolic::{Evaluator, Symbol};
use mbs_runtime::nalgebra::{Matrix3, SMatrix, SVector, Vector3};
use mbs_runtime::{Mechanism, System, TensorSink};
use mbs_tests::fixtures;
use mbs_tests::interpreted::analysis;
use mbs_tests::random::{Arguments, Random};
use mbs_tests::tampered::Tampered;

/// Half the width of the stencils is four of these: their error is then some 1e-12 of a motion at a few rad/s.
const STEP: f64 = 2e-2;
/// Required agreement, relative to the largest component.
const TOLERANCE: f64 = 1e-9;
/// Central differences of eighth order, for s = 1…4: the slope, and the curvature with its weight of the centre.
const SLOPE: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
const CURVATURE: [f64; 4] = [8.0 / 5.0, -1.0 / 5.0, 8.0 / 315.0, -1.0 / 560.0];
const CENTRE: f64 = -205.0 / 72.0;

/// Value, slope and curvature at 0.
fn jet<const A: usize, const B: usize>(
    curve: impl Fn(f64) -> SMatrix<f64, A, B>,
) -> [SMatrix<f64, A, B>; 3] {
    let centre = curve(0.0);
    let (mut slope, mut curvature) = (SMatrix::zeros(), CENTRE * centre);
    for k in 0..4 {
        let s = STEP * (k + 1) as f64;
        let (left, right) = (curve(-s), curve(s));
        slope += SLOPE[k] * (right - left);
        curvature += CURVATURE[k] * (right + left);
    }
    [centre, slope / STEP, curvature / (STEP * STEP)]
}

fn diag(x: f64, y: f64, z: f64) -> Matrix3<f64> {
    Matrix3::from_diagonal(&Vector3::new(x, y, z))
}

/// A box of edges a, b, c.
fn cuboid(mass: f64, a: f64, b: f64, c: f64) -> Matrix3<f64> {
    let side = |x: f64, y: f64| mass * (x * x + y * y) / 12.0;
    diag(side(b, c), side(a, c), side(a, b))
}

/// A round bar along x.
fn round(mass: f64, length: f64, radius: f64) -> Matrix3<f64> {
    let across = mass * (length * length / 12.0 + radius * radius / 4.0);
    diag(0.5 * mass * radius * radius, across, across)
}

/// The vector of the skew part of Rᵀ B: ω in body axes for B = Ṙ, ω̇ for B = R̈.
fn turning(r: &Matrix3<f64>, b: &Matrix3<f64>) -> Vector3<f64> {
    let product = r.tr_mul(b);
    Vector3::from_fn(|i, _| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        0.5 * (product[(k, j)] - product[(j, k)])
    })
}

/// The local coordinates of the parts, by name, for any coordinates of the mechanism.
struct Named<'a> {
    analysis: &'a Analysis,
    q: &'a [f64],
}

impl<'a> Named<'a> {
    fn new(analysis: &'a Analysis, q: &'a [f64]) -> Self {
        Named { analysis, q }
    }

    fn local(&self, name: &str) -> u32 {
        let locals = &self.analysis.outline.locals;
        let index = locals.iter().position(|local| local.name == name);
        index.unwrap_or_else(|| panic!("no coordinate `{name}` in {locals:?}")) as u32
    }

    fn value(&self, symbol: Symbol) -> f64 {
        let Analysis {
            outline, derived, ..
        } = self.analysis;
        let system = &derived.system;
        let expr = system.reduction.get(symbol).expect("every part is placed");
        let symbols = |symbol: Symbol| match symbol {
            Symbol::Parameter(i) => outline.parameters[i as usize].default,
            other => system.layout.value(other, self.q).expect("a position"),
        };
        let laws = |_: u32, _: &[f64]| unreachable!("no law places a part");
        Evaluator::new(&system.graph, &symbols, &laws).value(expr)
    }

    fn get(&self, name: &str) -> f64 {
        // A coordinate declared by hand is a local of its own.
        self.value(Symbol::LocalPosition(self.local(name)))
    }

    fn point(&self, name: &str) -> Vector3<f64> {
        let axes = ["x", "y", "z"];
        axes.map(|axis| self.get(&format!("{name}.{axis}"))).into()
    }

    fn axes(&self, name: &str) -> Matrix3<f64> {
        let first = self.local(&format!("{name}.rotation.x"));
        Matrix3::from_fn(|i, j| self.value(Symbol::LocalRotation(first, (3 * i + j) as u8)))
    }
}

/// A part with mass.
enum Matter {
    /// A body with its tensor about the centre of mass, in its axes.
    Rigid(&'static str, f64, Matrix3<f64>),
    Point(f64, fn(&Named) -> Vector3<f64>),
    /// A slender bar between two points.
    Slender(f64, [&'static str; 2]),
}

/// A point or a frame with its inertia, for the equations of Newton and Euler.
struct Piece<'a> {
    mass: f64,
    tensor: Matrix3<f64>,
    place: Box<dyn Fn(&Named) -> Vector3<f64> + 'a>,
    axes: Box<dyn Fn(&Named) -> Matrix3<f64> + 'a>,
}

impl Matter {
    fn pieces(&self) -> Vec<Piece<'_>> {
        let point = |mass: f64, place: Box<dyn Fn(&Named) -> Vector3<f64>>| Piece {
            mass,
            tensor: Matrix3::zeros(),
            place,
            axes: Box::new(|_| Matrix3::identity()),
        };
        match *self {
            Matter::Rigid(name, mass, tensor) => vec![Piece {
                mass,
                tensor,
                place: Box::new(move |q| q.point(name)),
                axes: Box::new(move |q| q.axes(name)),
            }],
            Matter::Point(mass, place) => vec![point(mass, Box::new(place))],
            // Half the mass at each of Gauss' two points: exact for functions that are quadratic along the bar.
            Matter::Slender(mass, [a, b]) => [-1.0, 1.0]
                .map(|side: f64| 0.5 + side / 12f64.sqrt())
                .map(|part| {
                    let place = move |q: &Named| {
                        let (a, b) = (q.point(a), q.point(b));
                        a + part * (b - a)
                    };
                    point(0.5 * mass, Box::new(place))
                })
                .into(),
        }
    }
}

/// Γ v v, as Γ comes.
struct Convective<'a, const N: usize> {
    v: &'a SVector<f64, N>,
    sum: SVector<f64, N>,
}

impl<const N: usize> TensorSink for Convective<'_, N> {
    fn set(&mut self, i: usize, j: usize, k: usize, value: f64) {
        self.sum[i] += value * self.v[j] * self.v[k];
    }
}

/// The motion with velocity v and acceleration v̇ at s = 0; a further term would be of third order.
fn motion<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    q: &SVector<f64, Q>,
    v: &SVector<f64, N>,
    acceleration: &SVector<f64, N>,
    s: f64,
) -> SVector<f64, Q> {
    let way = s * (v + 0.5 * s * acceleration);
    system.advance(q, &way, 1.0)
}

/// The disagreements at an instant.
fn findings<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    matter: &[Matter],
    at: &Arguments<Q, N, R>,
) -> Vec<String> {
    let Arguments {
        time,
        q,
        v,
        acceleration,
        ..
    } = at;
    let mut findings = Vec::new();
    let mut compare = |what: &str, given: f64, expected: f64, size: f64| {
        let agrees = (given - expected).abs() <= TOLERANCE * size;
        if !agrees {
            findings.push(format!(
                "{what}: {given:e}, but {expected:e} is expected, size {size:e}"
            ));
        }
    };

    let analysis = analysis(S::MODEL.declaration);
    let (mut inertial, mut energy) = (SVector::<f64, N>::zeros(), 0.0);
    for piece in matter.iter().flat_map(Matter::pieces) {
        let along = |v: &SVector<f64, N>, acceleration: &SVector<f64, N>| {
            let moved = |s: f64| motion(system, q, v, acceleration, s);
            let place = jet(|s| (piece.place)(&Named::new(&analysis, moved(s).as_slice())));
            let axes = jet(|s| (piece.axes)(&Named::new(&analysis, moved(s).as_slice())));
            let spin = turning(&axes[0], &axes[1]);
            (place, spin, turning(&axes[0], &axes[2]))
        };
        let ([_, velocity, linear], omega, angular) = along(v, acceleration);
        let momentum = piece.tensor * omega;
        let torque = piece.tensor * angular + omega.cross(&momentum);
        energy += 0.5 * (piece.mass * velocity.norm_squared() + omega.dot(&momentum));
        for j in 0..N {
            let direction = SVector::from_fn(|i, _| f64::from(u8::from(i == j)));
            let ([_, way, _], turn, _) = along(&direction, &SVector::zeros());
            inertial[j] += piece.mass * way.dot(&linear) + turn.dot(&torque);
        }
    }

    let mut mass = Box::new(SMatrix::<f64, N, N>::zeros());
    system.mass_matrix(q, &mut mass);
    let mut quadratic = Convective {
        v,
        sum: SVector::zeros(),
    };
    system.affinities(q, &mut quadratic);
    let quadratic = quadratic.sum;
    let size = inertial.iter().fold(1e-3, |size: f64, x| size.max(x.abs()));
    let given = *mass * acceleration + quadratic;
    for i in 0..N {
        let what = format!("M v̇ + Γ v v along {}", S::MODEL.velocities[i].name);
        compare(&what, given[i], inertial[i], size);
    }
    compare("T", system.kinetic_energy(q, v), energy, energy);

    let Some(factor) = system.factor_mass(q) else {
        findings.push("M is not positive definite".to_owned());
        return findings;
    };
    let mut free = SVector::zeros();
    system.applied_forces(*time, q, v, &mut free);
    let work = free.component_mul(v).abs().sum();
    free -= quadratic;
    system.solve_mass(&factor, &mut free);
    // Light bodies have large accelerations: with a shorter time the error of the stencil is smaller.
    let fastest = free.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
    let scale = 1.0 / fastest.sqrt();
    let [_, rate, _] = jet(|s| {
        let s = scale * s;
        let q = motion(system, q, v, &free, s);
        let v = v + s * free;
        SVector::from([system.kinetic_energy(&q, &v) + system.potential_energy(&q)])
    });
    let power = system.nonconservative_power(*time, q, v);
    let total = system.kinetic_energy(q, v) + system.potential_energy(q).abs();
    let size = work.max(total / scale);
    compare("dE/dt", rate[0] / scale, power, size);
    findings
}

fn random_states<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: &M,
) -> (S, Vec<Arguments<Q, N, R>>)
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let mut random = Random::of(S::MODEL.name);
    let system = mechanism.prepare().expect("default parameters are good");
    let states = (0..3)
        .map(|_| Arguments::near(&system, &mut random))
        .collect();
    (system, states)
}

fn check<M, S, const Q: usize, const N: usize, const R: usize>(matter: &[Matter])
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let (system, states) = random_states(&M::default());
    for at in &states {
        let findings = findings(&system, matter, at);
        assert!(findings.is_empty(), "{findings:#?}");
    }
}

/// A bar of 1 kg and 1 m with a square section of 0.1 m.
fn square_rod(name: &'static str) -> Matter {
    Matter::Rigid(name, 1.0, cuboid(1.0, 1.0, 0.1, 0.1))
}

fn bricard() -> Vec<Matter> {
    ["rod1", "rod2", "rod3", "rod4", "rod5"]
        .map(square_rod)
        .into()
}

fn flyball_governor() -> Vec<Matter> {
    // A rod with a ball at its end: both about the common centre of mass.
    let (rod, ball) = (0.3, 5.0);
    let reach = (0.5 * rod + ball) / (rod + ball);
    let own = cuboid(rod, 1.0, 0.01, 0.01);
    let across = own[(1, 1)] + rod * (reach - 0.5f64).powi(2) + ball * (1.0 - reach).powi(2);
    let arm = diag(own[(0, 0)], across, across);
    vec![
        Matter::Rigid("shaft", rod, own),
        Matter::Rigid("slider", 3.0, cuboid(3.0, 0.1, 0.1, 0.1)),
        Matter::Rigid("right", rod + ball, arm),
        Matter::Rigid("left", rod + ball, arm),
    ]
}

fn workshop() -> Vec<Matter> {
    let (span, load) = (0.4, 1.5);
    let sphere = 0.4 * load * 0.1f64.powi(2);
    let drum = load * span * span;
    let cylinder = round(load, 0.05, 0.2);
    vec![
        Matter::Rigid("table", 4.0 * load, cuboid(4.0 * load, span, 0.3, 0.1)),
        Matter::Rigid("spindle", load, round(load, 0.32f64.sqrt(), 0.04)),
        // about y
        Matter::Rigid(
            "wheel",
            load,
            diag(cylinder[(1, 1)], cylinder[(0, 0)], cylinder[(1, 1)]),
        ),
        Matter::Rigid("nut", load, diag(sphere, sphere, sphere)),
        Matter::Rigid(
            "carriage",
            load,
            Matrix3::from([
                [0.03, 0.002, 0.001],
                [0.002, 0.04, 0.003],
                [0.001, 0.003, 0.05],
            ]),
        ),
        Matter::Rigid("drum", load, diag(0.02 * drum, 0.03 * drum, 0.025 * drum)),
        Matter::Rigid("plate", load, diag(0.02, 0.02, 0.02)),
        Matter::Rigid("shaft", load, round(load, 0.14f64.sqrt(), 0.03)),
        Matter::Rigid("tool", load, diag(0.01, 0.01, 0.01)),
        Matter::Slender(0.5 * load, ["link.a", "link.b"]),
        Matter::Point(0.2 * load, |q| q.point("rod.b")),
        Matter::Point(load, |q| {
            let twist = q.get("twist");
            0.4 * Vector3::new(twist.cos(), 0.5 * twist.sin(), 0.2 * twist)
        }),
    ]
}

#[test]
fn a_bricard() {
    check::<scenes::bricard::Bricard, _, _, _, _>(&bricard());
}

#[test]
fn a_flyball_governor() {
    check::<scenes::flyball_governor::FlyballGovernor, _, _, _, _>(&flyball_governor());
}

#[test]
fn a_heavy_top() {
    let tensor = diag(0.234375, 0.46875, 0.234375);
    check::<scenes::heavy_top::HeavyTop, _, _, _, _>(&[Matter::Rigid("top", 15.0, tensor)]);
}

#[test]
fn a_rolling_disk() {
    // m r²/4 across, m r²/2 about its axis
    let tensor = diag(0.1, 0.2, 0.1);
    check::<scenes::rolling_disk::RollingDisk, _, _, _, _>(&[Matter::Rigid("disk", 2.5, tensor)]);
}

#[test]
fn a_rattleback() {
    // Principal moments, turned by the skew about z.
    let (sin, cos) = 2f64.to_radians().sin_cos();
    let (roll, pitch) = (2e-4, 1.6e-3);
    let off = (roll - pitch) * sin * cos;
    let tensor = Matrix3::from([
        [roll * cos * cos + pitch * sin * sin, off, 0.0],
        [off, roll * sin * sin + pitch * cos * cos, 0.0],
        [0.0, 0.0, 1.7e-3],
    ]);
    check::<scenes::rattleback::Rattleback, _, _, _, _>(&[Matter::Rigid("stone", 1.0, tensor)]);
}

#[test]
fn a_cardan_shaft() {
    let shaft = |name, length| Matter::Rigid(name, 2.0, round(2.0, length, 0.05));
    check::<scenes::cardan_shaft::CardanShaft, _, _, _, _>(&[
        shaft("input", 0.3),
        shaft("middle", 0.6),
        shaft("output", 0.3),
    ]);
}

#[test]
fn a_spherical_pendulum() {
    let bob = Matter::Point(2.0, |q| q.point("rod.b"));
    check::<scenes::spherical_pendulum::SphericalPendulum, _, _, _, _>(&[bob]);
}

#[test]
fn a_workshop() {
    check::<fixtures::Workshop, _, _, _, _>(&workshop());
}

#[test]
fn a_vice() {
    check::<fixtures::Vice, _, _, _, _>(&[
        Matter::Rigid("bed", 2.0, diag(0.1, 0.2, 0.15)),
        Matter::Rigid("jaw", 1.0, diag(0.05, 0.04, 0.06)),
        Matter::Rigid("handle", 0.6, diag(0.01, 0.02, 0.025)),
    ]);
}

/// A small error is found.
#[test]
fn an_error_in_inertia_or_power_is_found() {
    let (system, states) = random_states(&fixtures::Workshop::default());
    let matter = workshop();
    let finds = |wrong: &'static str| {
        let tampered = Tampered::new(system.clone(), wrong);
        !findings(&tampered, &matter, &states[0]).is_empty()
    };
    for wrong in ["mass", "affinities", "T", "V", "f", "power"] {
        assert!(finds(wrong), "an error in `{wrong}` is not found");
    }
    assert!(!finds("nothing"));
}
