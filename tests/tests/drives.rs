//! Drives that follow inputs.

use mbs_examples::scene::Scene;
use mbs_examples::scenes::scenes;
use mbs_runtime::{AnySimulation, FixedStepSimulation, Settings, Simulation, mechanism};
use mbs_tests::with_room;

// A hoist of 2 kg, and a rotor of 3 kg m² whose speed is driven.
mechanism!(Plant {
    world: Planar(gravity = [0.0, -10.0_m_per_s2]),
    height: Input(0.0_m),
    climb: Input(0.0_m_per_s),
    push: Input(0.0_m_per_s2),
    set_at: Input(0.0_s),
    speed: Input(0.0_rad_per_s),

    cage: Body(mass = 2.0_kg, inertia = 1.0_kg_m2),
    shaft: Prismatic(ground.origin, cage.origin, axis = Y),
    hoist: Drive(
        shaft.stroke,
        value = height,
        rate = climb,
        acceleration = push,
        since = set_at
    ),
    rotor: Body(mass = 1.0_kg, inertia = 3.0_kg_m2),
    bearing: Revolute(ground.origin, rotor.origin),
    motor: Drive(bearing.rate, value = speed),

    lifted: Output(shaft.stroke),
    lifting: Output(shaft.speed),
    turned: Output(bearing.angle),
});

fn plant() -> PlantSimulation {
    let settings = Settings {
        step: 1e-2,
        ..Settings::default()
    };
    Simulation::with_settings(Plant::default(), settings).expect("it assembles")
}

/// Position and rates of a program, set once in five steps.
#[test]
fn the_hoist_follows_a_program() {
    let mut plant = plant();
    for tick in 0..40 {
        let t = f64::from(tick) * 0.05;
        let mut inputs = plant.inputs_mut();
        inputs.height = 0.5 * t.powi(2);
        inputs.climb = t;
        inputs.push = 1.0;
        inputs.set_at = t;
        drop(inputs);
        plant.run_until(t + 0.05).expect("it runs");
    }
    assert!((plant.outputs().lifted - 2.0).abs() < 1e-12);
    assert!((plant.outputs().lifting - 2.0).abs() < 1e-12);
    // Weight and inertia.
    let force = plant.reaction("hoist", "force").expect("it has one");
    assert!((force - 22.0).abs() < 1e-9, "{force}");
    // m g h + m v²/2.
    let energy = plant.energy();
    assert!((energy.drive_work - 44.0).abs() < 1e-9, "{energy:?}");
    assert!(energy.error.abs() < 1e-9, "{energy:?}");
}

/// A jump takes the mechanism along at once, and the drive does its work.
#[test]
fn jumps_are_work_of_the_drive() {
    let mut plant = plant();
    plant.set_input("height", 0.3).expect("it is reached");
    assert!((plant.outputs().lifted - 0.3).abs() < 1e-12);
    assert!((plant.energy().drive_work - 6.0).abs() < 1e-9);
    plant.set_input("speed", 4.0).expect("it is reached");
    assert!((plant.energy().drive_work - 30.0).abs() < 1e-9);
    plant.run_until(1.0).expect("it runs");
    assert!((plant.outputs().turned - 4.0).abs() < 1e-9);
    assert!((plant.outputs().lifted - 0.3).abs() < 1e-12);
    assert!(plant.energy().error.abs() < 1e-9, "{:?}", plant.energy());
}

mechanism!(Reach {
    world: Planar(),
    wanted: Input(0.5_m),
    arm: Bar(mass = 1.0_kg, length = 1.0_m, angle = 60.0_deg),
    pivot: Revolute(ground.origin, arm.a),
    drive: Drive(arm.b.x, value = wanted),
    tip: Output(arm.b.x),
});

/// Where no pose follows, input and state stay as they were.
#[test]
fn what_cannot_be_reached_is_refused() {
    let mut reach = Simulation::new(Reach::default()).expect("it assembles");
    let refused = reach.set_input("wanted", 1.5);
    let text = refused.expect_err("the arm is shorter").to_string();
    assert!(
        text.starts_with(
            "no pose near the present one fits these inputs; these rows pull apart: `"
        ),
        "{text}"
    );
    assert!(
        text.ends_with("; the inputs keep their values: give others, nearer to the present ones"),
        "{text}"
    );
    assert_eq!(reach.inputs().wanted, 0.5);
    reach.set_input("wanted", 0.7).expect("it is reached");
    reach.run_until(0.1).expect("it runs");
    assert!((reach.outputs().tip - 0.7).abs() < 1e-9);
}

mechanism!(Domain {
    world: Planar(),
    part: Input(0.0),
    arm: Bar(mass = 1.0_kg, length = 1.0_m, angle = 60.0_deg),
    pivot: Revolute(ground.origin, arm.a),
    drive: Drive(arm.b.x, value = 0.5_m * sqrt(1.0 - part)),
    tip: Output(arm.b.x),
});

/// Rows that are no numbers are told as such, and change nothing.
#[test]
fn what_leads_a_drive_out_of_its_domain_is_refused() {
    let mut domain = Simulation::new(Domain::default()).expect("it assembles");
    let refused = domain.set_inputs(DomainInputs { part: 2.0 });
    assert_eq!(
        refused.expect_err("no root").to_string(),
        "no pose near the present one fits these inputs; these rows have no finite values there: `drive`; the inputs keep their values: give others, nearer to the present ones"
    );
    assert_eq!(domain.inputs().part, 0.0);
    domain.run_until(0.1).expect("it goes on as before");
    assert!((domain.outputs().tip - 0.5).abs() < 1e-9);
}

/// A constant of Rust; its nominal value is another one, so that the test shows which is used.
const SPEED: f64 = 2.0;

mechanism!(Tug {
    world: Planar(),
    speed: Param(SPEED, nominal = 1.5_m_per_s),
    load: Particle(mass = 1.0_kg, velocity = [2.0, 0.0]),
    track: PointOnLine(load, ground.origin),
    winch: Drive(track.speed, value = speed),
    brake: Force(track, value = -5.0_N),
});

/// A velocity row with a constant part does work, although nothing depends on time.
#[test]
fn a_constant_speed_does_work() {
    let mut tug = Simulation::new(Tug::default()).expect("it assembles");
    tug.run_until(1.0).expect("it runs");
    assert!(
        (tug.energy().drive_work - 10.0).abs() < 1e-9,
        "{:?}",
        tug.energy()
    );
    assert!(tug.energy().error.abs() < 1e-9, "{:?}", tug.energy());
}

fn driven_slider_crank() -> &'static Scene {
    let mut scenes = scenes().iter();
    let scene = scenes.find(|scene| scene.name == "driven-slider-crank");
    scene.expect("it is in the list")
}

/// Rows determine the whole motion, so that positions are exact with steps of any length. The work of the drive is not.
#[test]
fn the_work_of_a_drive_has_the_accuracy_of_the_run() {
    with_room(|| {
        let scene = driven_slider_crank();
        for (accuracy, stages) in [(1e-3, 240), (1e-6, 480), (1e-9, 1000)] {
            let settings = Settings {
                step: scene.step,
                ..Settings::accuracy(accuracy)
            };
            // Embedded methods, whose errors the rows take back, would ask for a quarter more.
            let mut whole = (scene.build)(&[], settings).expect("it assembles");
            whole.run_until(scene.duration).expect("it runs");
            assert!(whole.report().stages < stages, "{:?}", whole.report());
            let mut simulation = (scene.build)(&[], settings).expect("it assembles");
            let mut kinetic = 0.0_f64;
            for instant in 1..=20 {
                let time = f64::from(instant) / 20.0 * scene.duration;
                simulation.run_until(time).expect("no pose is singular");
                kinetic = kinetic.max(simulation.energy().kinetic);
            }
            let error = simulation.report().energy_error / kinetic;
            println!("{accuracy:e}: {error:.1e} of {kinetic:.0} J");
            assert!(error < accuracy, "{accuracy:e}: {error:e}");
        }
    });
}

/// Where steps are long, those to instants between their ends are others.
#[test]
fn the_work_of_a_drive_is_right_between_the_ends_of_two_level_steps() {
    with_room(|| {
        let scene = driven_slider_crank();
        for tolerance in [1e-4, 1e-5] {
            let settings = Settings {
                step: scene.step,
                order: 8,
                tolerance: Some(tolerance),
                ..Settings::default()
            };
            let mut simulation = (scene.build)(&[], settings).expect("it assembles");
            for instant in 1..100 {
                let time = f64::from(instant) / 100.0 * scene.duration;
                let end = scene.duration;
                simulation.run_past(time, end).expect("it runs");
                let mut look = |seen: &dyn AnySimulation| {
                    let energy = seen.energy();
                    let error = energy.error.abs() / energy.kinetic;
                    assert!(error < 10.0 * tolerance, "{time}: {energy:?}");
                };
                simulation.look_at(time, &mut look).expect("an instant");
            }
        }
    });
}

/// The rows of such a state are satisfied with its inputs alone.
#[test]
fn a_state_is_resumed_where_inputs_have_driven_it() {
    let mut plant = Simulation::new(Plant::default()).expect("it assembles");
    plant.set_input("height", 0.3).expect("it is reached");
    plant.set_input("speed", 4.0).expect("it is reached");
    plant.run_until(0.1).expect("it runs");
    let state = plant.state().clone();
    let settings = *plant.settings();
    let mut resumed = Simulation::resume(Plant::default(), settings, state.clone())
        .expect("it is one of this mechanism");
    plant.run_until(0.2).expect("it runs");
    resumed.run_until(0.2).expect("it runs");
    assert_eq!(resumed.state(), plant.state());
    let mut fixed =
        FixedStepSimulation::resume(Plant::default(), settings, state).expect("the same");
    assert_eq!(fixed.inputs().height, 0.3);
    fixed.step().expect("it runs");
}

mechanism!(TwoReach {
    world: Planar(),
    near: Input(0.5_m),
    far: Input(0.0_m),
    arm: Bar(mass = 1.0_kg, length = 1.0_m, angle = 60.0_deg),
    pivot: Revolute(ground.origin, arm.a),
    drive: Drive(arm.b.x, value = near + far),
});

/// One after the other they passed 1.2 m, out of reach.
#[test]
fn inputs_that_are_set_together_pass_no_pose_between() {
    let mut reach = Simulation::new(TwoReach::default()).expect("it assembles");
    reach
        .set_input_values(&[0.9, -0.4])
        .expect("it is where it was");
    reach
        .set_input_values(&[1.6, -1.1])
        .expect("it is where it was");
    assert!(reach.energy().drive_work.abs() < 1e-9);
    let before = reach.state().clone();
    assert!(reach.set_input_values(&[1.6, 0.3]).is_err());
    assert_eq!(reach.input_values(), [1.6, -1.1]);
    assert_eq!(reach.state().positions, before.positions);
}

/// A four-bar whose crank stands where an input wants it.
macro_rules! four_bar {
    ($name:ident, $coordinates:ident) => {
        mechanism!($name {
            world: Planar(coordinates = $coordinates),
            wanted: Input(1.0_rad),
            crank: Bar(mass = 1.0_kg, length = 0.1_m, angle = 1.0_rad),
            coupler: Bar(mass = 1.0_kg, length = 0.3_m, angle = 20.0_deg),
            rocker: Bar(mass = 1.0_kg, length = 0.25_m, angle = 100.0_deg),
            foot: Revolute(ground.origin, crank.a),
            pin: Revolute(crank.b, coupler.a),
            top: Revolute(coupler.b, rocker.b),
            heel: Revolute(ground.point(0.3_m, 0.0_m), rocker.a),
            drive: Drive(foot.angle, value = wanted),
            turned: Output(foot.angle),
            swung: Output(heel.angle),
            tip: Output(rocker.b),
        });
    };
}

four_bar!(ByAngles, Reference);
four_bar!(ByPoints, Natural);
four_bar!(ByJoints, Joint);

/// Newton's method from the old pose ended in the other assembly, or with full turns.
#[test]
fn a_long_jump_ends_where_many_short_ones_do() {
    macro_rules! ends {
        ($mechanism:ident, $jump:expr) => {
            [1, 400].map(|parts| {
                let mut four_bar = Simulation::new($mechanism::default()).expect("it assembles");
                for part in 1..=parts {
                    let wanted = 1.0 + $jump * f64::from(part) / f64::from(parts);
                    four_bar.set_input("wanted", wanted).expect("it is reached");
                }
                let out = four_bar.outputs();
                [out.turned, out.swung, out.tip[0], out.tip[1]]
            })
        };
    }
    for jump in [
        0.5, 1.0, 2.0, 3.0, 4.0, 6.0, 20.0, -1.0, -2.0, -3.0, -5.0, -20.0,
    ] {
        for (name, [at_once, slowly]) in [
            ("by angles", ends!(ByAngles, jump)),
            ("by points", ends!(ByPoints, jump)),
            ("by joints", ends!(ByJoints, jump)),
        ] {
            let apart = (0..4).map(|i| (at_once[i] - slowly[i]).abs());
            let apart = apart.fold(0.0, f64::max);
            assert!(apart < 1e-6, "{name}, {jump} rad: {at_once:?} {slowly:?}");
        }
    }
}
