//! Inertia as the derivation by Lagrange has it, against Newton and Euler: m a of every centre of mass and J ω̇ + ω × J ω of
//! every body, with masses and tensors written here and accelerations by differences along the motion. And power is dE/dt.

use mbs_examples::scenes;
use mbs_macros_core::Analysis;
use mbs_macros_core::symbolic::{Evaluator, Symbol};
use mbs_runtime::{Mechanism, System, TensorSink};
use mbs_tests::fixtures;
use mbs_tests::interpreted::analysis;
use mbs_tests::random::{Arguments, Random};
use mbs_tests::tampered::Tampered;

/// Half the width of the stencils is four of these: their error is then some 1e-12 of a motion at a few rad/s.
const STEP: f64 = 2e-2;
/// Agreement asked for, relative to the largest component.
const TOLERANCE: f64 = 1e-9;
/// Central differences of eighth order, for s = 1…4: the slope, and the curvature with its weight of the centre.
const SLOPE: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
const CURVATURE: [f64; 4] = [8.0 / 5.0, -1.0 / 5.0, 8.0 / 315.0, -1.0 / 560.0];
const CENTRE: f64 = -205.0 / 72.0;

type Vector = [f64; 3];
type Tensor = [Vector; 3];

/// Value, slope and curvature at 0.
fn jet<const K: usize>(curve: impl Fn(f64) -> [f64; K]) -> [[f64; K]; 3] {
    let centre = curve(0.0);
    let (mut slope, mut curvature) = ([0.0; K], centre.map(|x| CENTRE * x));
    for k in 0..4 {
        let s = STEP * (k + 1) as f64;
        let (left, right) = (curve(-s), curve(s));
        for i in 0..K {
            slope[i] += SLOPE[k] * (right[i] - left[i]);
            curvature[i] += CURVATURE[k] * (right[i] + left[i]);
        }
    }
    let squared = STEP * STEP;
    [
        centre,
        slope.map(|x| x / STEP),
        curvature.map(|x| x / squared),
    ]
}

fn dot<const K: usize>(a: &[f64; K], b: &[f64; K]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j] * b[k] - a[k] * b[j]
    })
}

fn times(tensor: &Tensor, x: &Vector) -> Vector {
    std::array::from_fn(|i| dot(&tensor[i], x))
}

fn diag(x: f64, y: f64, z: f64) -> Tensor {
    [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]]
}

/// A box of edges a, b, c.
fn cuboid(mass: f64, a: f64, b: f64, c: f64) -> Tensor {
    let side = |x: f64, y: f64| mass * (x * x + y * y) / 12.0;
    diag(side(b, c), side(a, c), side(a, b))
}

/// A round bar along x.
fn round(mass: f64, length: f64, radius: f64) -> Tensor {
    let across = mass * (length * length / 12.0 + radius * radius / 4.0);
    diag(0.5 * mass * radius * radius, across, across)
}

/// Axes that never turn, by rows.
const UNTURNED: [f64; 9] = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];

/// The vector of the skew part of Rᵀ B: ω in body axes for B = Ṙ, ω̇ for B = R̈.
fn turning(r: &[f64; 9], b: &[f64; 9]) -> Vector {
    let product = |i: usize, j: usize| -> f64 { (0..3).map(|k| r[3 * k + i] * b[3 * k + j]).sum() };
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        0.5 * (product(k, j) - product(j, k))
    })
}

/// Coordinates of the parts on their own, by name, whatever the mechanism's coordinates are.
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

    fn point(&self, name: &str) -> Vector {
        ["x", "y", "z"].map(|axis| self.get(&format!("{name}.{axis}")))
    }

    fn axes(&self, name: &str) -> [f64; 9] {
        let first = self.local(&format!("{name}.rotation.x"));
        std::array::from_fn(|entry| self.value(Symbol::LocalRotation(first, entry as u8)))
    }
}

/// What has mass.
enum Matter {
    /// A body with its tensor about the centre of mass, in its axes.
    Rigid(&'static str, f64, Tensor),
    Point(f64, fn(&Named) -> Vector),
    /// A slender bar between two points.
    Slender(f64, [&'static str; 2]),
}

/// A point, or a frame, with its inertia: what Newton and Euler speak about.
struct Piece<'a> {
    mass: f64,
    tensor: Tensor,
    place: Box<dyn Fn(&Named) -> Vector + 'a>,
    axes: Box<dyn Fn(&Named) -> [f64; 9] + 'a>,
}

impl Matter {
    fn pieces(&self) -> Vec<Piece<'_>> {
        let point = |mass: f64, place: Box<dyn Fn(&Named) -> Vector>| Piece {
            mass,
            tensor: diag(0.0, 0.0, 0.0),
            place,
            axes: Box::new(|_| UNTURNED),
        };
        match *self {
            Matter::Rigid(name, mass, tensor) => vec![Piece {
                mass,
                tensor,
                place: Box::new(move |q| q.point(name)),
                axes: Box::new(move |q| q.axes(name)),
            }],
            Matter::Point(mass, place) => vec![point(mass, Box::new(place))],
            // Half the mass at each of Gauss' two points: exact for what is quadratic along the bar.
            Matter::Slender(mass, [a, b]) => [-1.0, 1.0]
                .map(|side: f64| 0.5 + side / 12f64.sqrt())
                .map(|part| {
                    let place = move |q: &Named| {
                        let (a, b) = (q.point(a), q.point(b));
                        std::array::from_fn(|i| a[i] + part * (b[i] - a[i]))
                    };
                    point(0.5 * mass, Box::new(place))
                })
                .into(),
        }
    }
}

struct Affinities<'a, const N: usize>(&'a mut [[[f64; N]; N]]);

impl<const N: usize> TensorSink for Affinities<'_, N> {
    fn set(&mut self, i: usize, j: usize, k: usize, value: f64) {
        self.0[i][j][k] = value;
    }
}

/// Γ v v.
fn convective<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    q: &[f64; Q],
    v: &[f64; N],
) -> [f64; N] {
    let mut gamma = vec![[[0.0; N]; N]; N];
    system.affinities(q, &mut Affinities(&mut gamma));
    std::array::from_fn(|i| (0..N).map(|j| v[j] * dot(&gamma[i][j], v)).sum())
}

/// The motion with velocity v and acceleration v̇ at s = 0; a further term would be of third order.
fn motion<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    q: &[f64; Q],
    v: &[f64; N],
    acceleration: &[f64; N],
    s: f64,
) -> [f64; Q] {
    let way = std::array::from_fn(|i| s * (v[i] + 0.5 * s * acceleration[i]));
    system.advance(q, &way, 1.0)
}

/// What does not agree at an instant.
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
    let (mut inertial, mut energy) = ([0.0; N], 0.0);
    for piece in matter.iter().flat_map(Matter::pieces) {
        let along = |v: &[f64; N], acceleration: &[f64; N]| {
            let moved = |s: f64| motion(system, q, v, acceleration, s);
            let place = jet(|s| (piece.place)(&Named::new(&analysis, &moved(s))));
            let axes = jet(|s| (piece.axes)(&Named::new(&analysis, &moved(s))));
            let spin = turning(&axes[0], &axes[1]);
            (place, spin, turning(&axes[0], &axes[2]))
        };
        let ([_, velocity, linear], omega, angular) = along(v, acceleration);
        let momentum = times(&piece.tensor, &omega);
        let gyroscopic = cross(&omega, &momentum);
        let euler = times(&piece.tensor, &angular);
        let torque: Vector = std::array::from_fn(|i| euler[i] + gyroscopic[i]);
        energy += 0.5 * (piece.mass * dot(&velocity, &velocity) + dot(&omega, &momentum));
        for j in 0..N {
            let direction = std::array::from_fn(|i| f64::from(u8::from(i == j)));
            let ([_, way, _], turn, _) = along(&direction, &[0.0; N]);
            inertial[j] += piece.mass * dot(&way, &linear) + dot(&turn, &torque);
        }
    }

    let mut mass = Box::new([[0.0; N]; N]);
    system.mass_matrix(q, &mut *mass);
    let quadratic = convective(system, q, v);
    let size = inertial.iter().fold(1e-3, |size: f64, x| size.max(x.abs()));
    for i in 0..N {
        let given = dot(&mass[i], acceleration) + quadratic[i];
        let what = format!("M v̇ + Γ v v along {}", S::MODEL.velocities[i].name);
        compare(&what, given, inertial[i], size);
    }
    compare("T", system.kinetic_energy(q, v), energy, energy);

    let Some(factor) = system.factor_mass(q) else {
        findings.push("M is not positive definite".to_owned());
        return findings;
    };
    let mut free = [0.0; N];
    system.applied_forces(*time, q, v, &mut free);
    let work = free.iter().zip(v).map(|(f, v)| (f * v).abs()).sum::<f64>();
    for i in 0..N {
        free[i] -= quadratic[i];
    }
    system.solve_mass(&factor, &mut free);
    // Light bodies are thrown about: the shorter the time, the smaller what the stencil leaves out.
    let fastest = free.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
    let scale = 1.0 / fastest.sqrt();
    let [_, [rate], _] = jet(|s| {
        let s = scale * s;
        let q = motion(system, q, v, &free, s);
        let v = std::array::from_fn(|i| v[i] + s * free[i]);
        [system.kinetic_energy(&q, &v) + system.potential_energy(&q)]
    });
    let power = system.nonconservative_power(*time, q, v);
    let total = system.kinetic_energy(q, v) + system.potential_energy(q).abs();
    let size = work.max(total / scale);
    compare("dE/dt", rate / scale, power, size);
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
    let across = own[1][1] + rod * (reach - 0.5f64).powi(2) + ball * (1.0 - reach).powi(2);
    let arm = diag(own[0][0], across, across);
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
            diag(cylinder[1][1], cylinder[0][0], cylinder[1][1]),
        ),
        Matter::Rigid("nut", load, diag(sphere, sphere, sphere)),
        Matter::Rigid(
            "carriage",
            load,
            [
                [0.03, 0.002, 0.001],
                [0.002, 0.04, 0.003],
                [0.001, 0.003, 0.05],
            ],
        ),
        Matter::Rigid("drum", load, diag(0.02 * drum, 0.03 * drum, 0.025 * drum)),
        Matter::Rigid("plate", load, diag(0.02, 0.02, 0.02)),
        Matter::Rigid("shaft", load, round(load, 0.14f64.sqrt(), 0.03)),
        Matter::Rigid("tool", load, diag(0.01, 0.01, 0.01)),
        Matter::Slender(0.5 * load, ["link.a", "link.b"]),
        Matter::Point(0.2 * load, |q| q.point("rod.b")),
        Matter::Point(load, |q| {
            let twist = q.get("twist");
            [twist.cos(), 0.5 * twist.sin(), 0.2 * twist].map(|x| 0.4 * x)
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
    let tensor = [
        [roll * cos * cos + pitch * sin * sin, off, 0.0],
        [off, roll * sin * sin + pitch * cos * cos, 0.0],
        [0.0, 0.0, 1.7e-3],
    ];
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

/// What is slightly wrong is found.
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
