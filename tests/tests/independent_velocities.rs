//! Accelerations by independent velocities: which mechanisms have them, and that dead points do no harm.

use mbs_runtime::nalgebra::SVector;
use mbs_runtime::{
    BaselineStepper, BaumgarteSettings, Mechanism, Method, Settings, Simulation, State, System,
    mechanism,
};
use mbs_tests::dense::Dense;

// The rocker is declared first, so that its velocity is the independent one. Where crank and coupler are in line it does not
// determine theirs: a dead point, though no singular pose. Lengths 1, 4, 3 and a base of 4; the crank begins at `start`.
mechanism!(CrankRocker {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Natural),
    start: Param(1.0_rad),
    rate: Param(2.0_rad_per_s),
    rocker: Bar(mass = 3.0_kg, length = 3.0_m, angle = 100.0_deg),
    coupler: Bar(mass = 4.0_kg, length = 4.0_m, angle = 30.0_deg),
    crank: Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = Exactly(start),
        rate = Exactly(rate)
    ),
    foot: Revolute(ground.point(4.0_m, 0.0), rocker.a),
    shaft: Revolute(ground.origin, crank.a),
    head: Revolute(coupler.b, rocker.b),
    pin: Revolute(crank.b, coupler.a),
});

// Four velocities, two of them independent: M with its rows takes fewer operations.
mechanism!(DoublePendulum {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Natural),
    upper: Bar(mass = 1.0_kg, length = 1.0_m, angle = 10.0_deg),
    lower: Bar(mass = 1.0_kg, length = 1.0_m, angle = -20.0_deg),
    pivot: Revolute(ground.origin, upper.a),
    elbow: Revolute(upper.b, lower.a),
});

// The crank-rocker with a bead on both lines through the origin, where it is declared: its row vanishes there, and no other
// pose can be compared with that one.
mechanism!(Crossing {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Natural),
    rocker: Bar(mass = 3.0_kg, length = 3.0_m, angle = 100.0_deg),
    coupler: Bar(mass = 4.0_kg, length = 4.0_m, angle = 30.0_deg),
    crank: Bar(mass = 1.0_kg, length = 1.0_m, angle = 1.0_rad),
    bead: Particle(mass = 1.0_kg),
    foot: Revolute(ground.point(4.0_m, 0.0), rocker.a),
    shaft: Revolute(ground.origin, crank.a),
    head: Revolute(coupler.b, rocker.b),
    pin: Revolute(crank.b, coupler.a),
    lines: Holonomic(bead.origin.x * bead.origin.x - bead.origin.y * bead.origin.y),
});

fn is_partitioned<M, S, const Q: usize, const N: usize, const R: usize>(_: &M) -> bool
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    S::PARTITIONED
}

#[test]
fn mechanisms_of_one_degree_of_freedom_have_them() {
    assert!(is_partitioned(&CrankRocker::default()));
    assert!(!is_partitioned(&DoublePendulum::default()));
    assert!(!is_partitioned(&Crossing::default()));
    assert!(!is_partitioned(&Dense(CrankRocker::default())));
}

/// What a Runge–Kutta step without terms of Baumgarte adds to the velocities of a state.
fn gained<S, const Q: usize, const N: usize, const R: usize>(
    system: S,
    state: State<Q, N, R>,
) -> Vec<f64>
where
    S: System<Q, N, R>,
{
    const STEP: f64 = 1e-5;
    let settings = Settings {
        method: Method::Baumgarte(BaumgarteSettings {
            gain: 0.0,
            ..BaumgarteSettings::default()
        }),
        order: 4,
        step: STEP,
        ..Settings::default()
    };
    let before = state.velocities;
    let mut stepper = BaselineStepper::new(system, state, &settings).expect("a stepper");
    stepper.step(STEP).expect("a step");
    (stepper.state().velocities - before).as_slice().to_vec()
}

/// The largest weakness of a block: 1 about as far from dead points as the declared guess, without limit beside them.
fn weakness<S, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    state: &State<Q, N, R>,
) -> f64
where
    S: System<Q, N, R>,
{
    let (q, v) = (&state.positions, &state.velocities);
    let (mut acceleration, mut weakness) = (SVector::zeros(), SVector::zeros());
    let into = (&mut acceleration, &mut weakness);
    assert!(system.partitioned_accelerations(0.0, q, v, &SVector::zeros(), into.0, into.1));
    weakness.max()
}

/// From a tenth of a radian beside the pose in which crank and coupler are in line to a hundred-millionth.
#[test]
fn dead_points_do_no_harm() {
    // They are 5 m long there: a triangle with the base and the rocker.
    let dead = ((25.0 + 16.0 - 9.0) / (2.0 * 5.0 * 4.0_f64)).acos();
    for power in 1..=8 {
        for side in [-1.0, 1.0] {
            let start = dead + side * 0.1_f64.powi(power);
            let rocker = CrankRocker {
                start,
                ..CrankRocker::default()
            };
            let simulation = Simulation::new(rocker).expect("assembled");
            let state = simulation.state();
            let system = rocker.prepare().expect("a system");
            let weakness = weakness(&system, state);
            // About the reciprocal of the square of the distance, and such blocks are not used.
            let expected = 100.0_f64.powi(power);
            assert!(
                (0.1..10.0).contains(&(weakness / expected)),
                "{start}: {weakness:e}"
            );
            let partitioned = gained(system, state.clone());
            let rocker = Dense(rocker).prepare().expect("a system");
            let dense = gained(rocker, state.clone());
            let size = dense.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
            let errors = partitioned.iter().zip(&dense).map(|(a, b)| (a - b).abs());
            let error = errors.fold(0.0, f64::max) / size;
            println!("{:+.0e}: {weakness:.1e}, {error:.1e}", start - dead);
            assert!(error < 1e-9, "{start}: {error:e}");
        }
    }
}
