//! Scenes of space: closed forms, constants of motion, and long runs with coarse steps.

use mbs_examples::scenes::bricard::BricardReference;
use mbs_examples::scenes::cardan_shaft::CardanShaft;
use mbs_examples::scenes::flyball_governor::FlyballGovernor;
use mbs_examples::scenes::heavy_top::HeavyTop;
use mbs_examples::scenes::passages::THREEFOLD;
use mbs_examples::scenes::rattleback::Rattleback;
use mbs_examples::scenes::spherical_pendulum::SphericalPendulum;
use mbs_runtime::{Mechanism, Settings, Simulation, System};
use mbs_tests::with_room;

const GRAVITY: f64 = 9.81;

fn simulation<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    step: f64,
) -> Simulation<S, Q, N, R>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let settings = Settings {
        step,
        ..Settings::default()
    };
    Simulation::with_settings(mechanism, settings).expect("it assembles")
}

/// The errors with a step and half of it fall by a factor of four, to `finest` at least.
fn of_second_order(what: &str, errors: [f64; 2], finest: f64) {
    let slope = (errors[0] / errors[1]).log2();
    println!("{what}: {errors:?}, slope {slope}");
    assert!(
        (1.8..=2.2).contains(&slope),
        "{what}: slope {slope} of {errors:?}"
    );
    assert!(errors[1] <= finest, "{what}: {errors:?}");
}

/// dθ₂/dθ of tan θ₂ = cos β tan θ.
fn ratio(bend: f64, angle: f64) -> f64 {
    bend.cos() / (angle.cos().powi(2) + (bend.cos() * angle.sin()).powi(2))
}

/// ω(θ) from the constant kinetic energy ½ J ω² (2 + (dθ₂/dθ)²).
fn cardan_rate(shaft: &CardanShaft, angle: f64) -> f64 {
    let inertia = |angle: f64| 2.0 + ratio(shaft.bend, angle).powi(2);
    shaft.rate * (inertia(0.0) / inertia(angle)).sqrt()
}

/// The time at which the input has turned by `angle`: ∫ dθ/ω by Simpson's rule, which is accurate for this smooth and
/// periodic integrand.
fn cardan_time(shaft: &CardanShaft, angle: f64) -> f64 {
    let intervals = 4000;
    let width = angle / f64::from(intervals);
    let sum: f64 = (0..=intervals)
        .map(|i| {
            let weight = match i {
                0 => 1.0,
                i if i == intervals => 1.0,
                i if i % 2 == 1 => 4.0,
                _ => 2.0,
            };
            weight / cardan_rate(shaft, width * f64::from(i))
        })
        .sum();
    sum * width / 3.0
}

#[test]
fn the_second_joint_of_a_cardan_shaft_undoes_what_the_first_does() {
    let errors = [2e-3, 1e-3].map(|step| {
        let shaft = CardanShaft::default();
        let mut simulation = simulation(shaft, step);
        let mut worst: f64 = 0.0;
        for instant in 0..=20 {
            simulation
                .run_until(0.05 * f64::from(instant))
                .expect("it turns");
            let [input, output, rate, middle] =
                ["input_angle", "output_angle", "input_rate", "middle_rate"]
                    .map(|name| simulation.output(name).expect("declared"));
            assert!((output - input).abs() <= 1e-11, "{output} after {input}");
            let expected = ratio(shaft.bend, input) * rate;
            assert!(
                (middle - expected).abs() <= 1e-10,
                "{middle} rad/s instead of {expected} at {input} rad"
            );
            let late = cardan_time(&shaft, input) - simulation.time();
            worst = worst
                .max((rate - cardan_rate(&shaft, input)).abs())
                .max((late * rate).abs());
        }
        let turned = simulation.output("input_angle").expect("declared");
        assert!(turned > std::f64::consts::TAU, "{turned}");
        worst
    });
    // By two angles for each joint; by bodies and rows the error is a fifth of this, and the step several times as long.
    of_second_order("cardan shaft", errors, 2e-5);
}

/// The complete elliptic integral K(k), by the arithmetic and the geometric mean.
fn elliptic(k: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - k * k).sqrt());
    for _ in 0..10 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    std::f64::consts::FRAC_PI_2 / a
}

/// ż² = 2g (z − low)(high − z)(third − z) on a rod of one metre, from a horizontal rod: high = 0.
#[test]
fn a_spherical_pendulum_runs_between_two_roots() {
    let pendulum = SphericalPendulum::default();
    assert_eq!(pendulum.length, 1.0);
    let squared = pendulum.speed.powi(2);
    // g z² − (v²/2) z − g = 0
    let root = (squared * squared / 16.0 + GRAVITY * GRAVITY).sqrt();
    let (low, third) = (
        (0.25 * squared - root) / GRAVITY,
        (0.25 * squared + root) / GRAVITY,
    );
    let k = (-low / (third - low)).sqrt();
    let period = 4.0 / (2.0 * GRAVITY * (third - low)).sqrt() * elliptic(k);
    // z = low − low sn², and sn² of half of K is 1/(1 + k').
    let between = low - low / (1.0 + (1.0 - k * k).sqrt());
    let momentum = pendulum.mass * pendulum.length * pendulum.speed;
    let runs = [2e-3, 1e-3].map(|step| {
        let mut simulation = simulation(pendulum, step);
        let (mut worst, mut lowest, mut highest): (f64, f64, f64) = (0.0, 0.0, -1.0);
        for half in 1..=12 {
            // A separate grid for each half period: none of its instants is a multiple of the step.
            for part in 1..=20 {
                simulation
                    .run_until(0.5 * period * (f64::from(half - 1) + f64::from(part) / 20.0))
                    .expect("it swings");
                let kept = simulation.output("momentum_z").expect("declared");
                assert!((kept - momentum).abs() <= 1e-12, "{kept} of {momentum}");
                let z = simulation.output("bob_position.z").expect("declared");
                if part == 10 {
                    worst = worst.max((z - between).abs());
                }
                lowest = lowest.min(z);
                highest = highest.max(z);
            }
            let [x, y, z] = ["x", "y", "z"].map(|axis| {
                simulation
                    .output(&format!("bob_position.{axis}"))
                    .expect("declared")
            });
            assert!((x.hypot(y).hypot(z) - 1.0).abs() <= 1e-11);
            let turning = if half % 2 == 1 { low } else { 0.0 };
            worst = worst.max((z - turning).abs());
        }
        assert!(
            lowest > low - 1e-4 && highest < 1e-4,
            "{lowest} to {highest}"
        );
        [worst, simulation.report().energy_error]
    });
    of_second_order("spherical pendulum", runs.map(|run| run[0]), 1e-4);
    of_second_order("its energy", runs.map(|run| run[1]), 1e-4);
}

#[test]
fn a_heavy_top_keeps_its_spin_and_its_momentum_about_the_vertical() {
    for step in [1e-3, 5e-4] {
        let top = HeavyTop::default();
        let momentum =
            top.precession * top.transverse + top.mass * top.height.powi(2) * top.precession;
        let mut simulation = simulation(top, step);
        let spin = HeavyTop::MODEL
            .velocities
            .iter()
            .position(|velocity| velocity.name == "top.omega.y")
            .expect("the spin is a velocity");
        for _ in 0..1000 {
            simulation.step().expect("it spins");
            let kept = simulation.output("momentum_z").expect("declared");
            assert!((kept - momentum).abs() <= 1e-10, "{kept} of {momentum}");
            let kept = simulation.velocities()[spin];
            assert!((kept - top.spin).abs() <= 1e-10, "{kept} of {}", top.spin);
        }
    }
}

/// When the spin about the vertical changes its sign for the first time.
fn reversal(step: f64) -> f64 {
    let mut simulation = simulation(Rattleback::default(), step);
    let mut before = simulation.output("spin_rate").expect("declared");
    assert!(before < 0.0);
    while simulation.time() < 10.0 {
        simulation.step().expect("it rattles");
        let after = simulation.output("spin_rate").expect("declared");
        if after > 0.0 {
            return simulation.time() - step * after / (after - before);
        }
        before = after;
    }
    panic!("the spin never turned round")
}

#[test]
fn a_rattleback_turns_round() {
    let times = [1e-3, 5e-4, 2.5e-4].map(reversal);
    println!("rattleback: {times:?}");
    of_second_order(
        "rattleback",
        [times[0] - times[1], times[1] - times[2]].map(f64::abs),
        1e-2,
    );
    let errors = [1e-3, 5e-4].map(|step| {
        let mut simulation = simulation(Rattleback::default(), step);
        simulation.run_until(times[2]).expect("it rattles");
        simulation.report().energy_error
    });
    of_second_order("energy of the rattleback", errors, 3e-5);
}

#[test]
fn spinning_the_right_way_a_rattleback_goes_on() {
    with_room(|| {
        let stone = Rattleback {
            spin: 5.0,
            ..Rattleback::default()
        };
        let mut simulation = simulation(stone, 1e-3);
        simulation.run_until(3.0).expect("it turns");
        assert!(simulation.output("spin_rate").expect("declared") > 0.0);
    });
}

/// The last value of a reference.
fn last(file: &str, column: &str) -> f64 {
    let table = mbs_tests::reference::table(file);
    assert_eq!(table.times().last(), Some(&10.0));
    *table.column(column).last().expect("rows")
}

/// Springs of 8e5 N/m and dampers of 4e4 N s/m at 3 kg: an explicit method would be unstable above 2 m/2C = 75 µs.
#[test]
fn stiffness_does_not_limit_the_step_of_the_governor() {
    with_room(|| {
        let governor = FlyballGovernor::default();
        let stable = governor.slider_mass / governor.damping;
        assert!(stable < 1e-4);
        let step = 2e-2;
        let mut simulation = simulation(governor, step);
        simulation.run_until(10.0).expect("it turns");
        let report = simulation.report();
        assert_eq!(report.rejected_steps, 0, "{report:?}");
        let height = simulation.output("height").expect("declared");
        // The expected error, by convergence of second order from steps of 1 ms.
        let error = (height - last("a05_flyball_governor.csv", "s_m")).abs();
        assert!(error <= 50.0 * step * step, "{height}");
    });
}

/// Ten seconds with 50 steps a second and all rows: at rest again, after two swings, in the pose of the start.
#[test]
fn bricard_swings_with_coarse_steps() {
    with_room(|| {
        let mut simulation = simulation(BricardReference::default(), 2e-2);
        simulation.run_until(10.0).expect("it swings");
        let report = simulation.report();
        assert!(report.energy_error <= 2e-3, "{report:?}");
        assert!(report.holonomic_error <= 1e-10, "{report:?}");
        assert_eq!((report.rank, report.rejected_steps), (29, 0));
        for axis in ["x", "y", "z"] {
            let expected = last("a04_bricard_square_rods.csv", &format!("p3{axis}_m"));
            let found = simulation
                .output(&format!("corner3.{axis}"))
                .expect("declared");
            assert!((found - expected).abs() <= 1e-4, "{axis}: {found}");
        }
    });
}

/// Newton's method may oscillate without end in steps in which a disk turns several times.
#[test]
fn steps_that_are_far_too_long_come_to_an_end() {
    let scene = &mbs_examples::scenes::rolling_disk::TILTED;
    for step in [0.2, 0.1, 0.04, 0.02] {
        let settings = Settings {
            step,
            ..Settings::default()
        };
        let mut simulation = (scene.build)(&[], settings).expect("it assembles");
        let outcome = simulation.run_until(scene.duration);
        let report = simulation.report();
        assert!(
            report.stages < 100_000,
            "h = {step}: {outcome:?} {report:?}"
        );
    }
}

/// Bricard's linkage of threefold symmetry has a row that follows from the others, and a brake, so that its steps are implicit.
/// Off the rows, within Newton's iteration, that row has a small pivot; and what is extrapolated along the combination of
/// multipliers without force is answered by no row. Steps of any length lost a twentieth of the energy each in some poses.
#[test]
fn implicit_steps_leave_out_redundant_rows() {
    let error = |step| {
        let settings = Settings {
            step,
            ..Settings::default()
        };
        let mut simulation = (THREEFOLD.build)(&[("rate".to_owned(), 20.0)], settings).unwrap();
        simulation.run_until(5.0).unwrap();
        simulation.report().energy_error
    };
    let [coarse, fine] = [2e-3, 1e-3].map(error);
    assert!(
        fine < 2e-3 && (3.5..4.5).contains(&(coarse / fine)),
        "{coarse:.1e}, {fine:.1e}"
    );
}
