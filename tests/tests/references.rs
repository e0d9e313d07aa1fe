//! Every scene with a reference converges to it with second order, on the right branch, and its energy error and
//! residuals stay within bounds.

use mbs_examples::scene::Scene;
use mbs_examples::scenes::{self, scenes};
use mbs_runtime::{Mechanism, Settings, Simulation, State, System};
use mbs_tests::reference::{self, deviation};
use mbs_tests::with_room;

/// The requirements on a scene.
struct Case {
    scene: &'static str,
    /// The coarsest of three steps, each half the one before, s. It divides the spacing of the reference.
    step: f64,
    /// s
    until: f64,
    order: Order,
    /// Bound of the energy error with the coarsest step, J.
    energy: f64,
}

enum Order {
    /// The observed slopes lie in [1.8, 2.2]; the error with the finest step is below this.
    Second { finest: f64 },
    /// The motion is prescribed, so that the rows alone determine positions and velocities.
    Exact { error: f64 },
}

fn find(name: &str) -> &'static Scene {
    scenes()
        .iter()
        .find(|scene| scene.name == name)
        .unwrap_or_else(|| panic!("no scene `{name}`"))
}

fn check(case: &Case) {
    let scene = find(case.scene);
    let table = reference::table(scene.reference.as_ref().expect("a reference").file);
    let mut errors = Vec::new();
    for halvings in 0..3 {
        let settings = Settings {
            step: case.step / f64::from(1 << halvings),
            ..Settings::default()
        };
        let mut simulation = (scene.build)(&[], settings).expect(case.scene);
        errors.push(deviation(&mut *simulation, scene, &table, case.until));
        let report = simulation.report();
        println!(
            "{} h = {:.2e}: error {:.3e}; {report:?}",
            case.scene, settings.step, errors[halvings]
        );
        assert!(
            report.holonomic_error <= 1e-10,
            "{}: {report:?}",
            case.scene
        );
        assert!(report.velocity_error <= 1e-10, "{}: {report:?}", case.scene);
        assert!(
            report.energy_error <= case.energy,
            "{}: {report:?}",
            case.scene
        );
    }
    match case.order {
        Order::Second { finest } => {
            for pair in errors.windows(2) {
                let slope = (pair[0] / pair[1]).log2();
                assert!(
                    (1.8..=2.2).contains(&slope),
                    "{}: slope {slope} of {errors:?}",
                    case.scene
                );
            }
            assert!(errors[2] <= finest, "{}: {errors:?}", case.scene);
        }
        Order::Exact { error } => {
            assert!(
                errors.iter().all(|e| *e <= error),
                "{}: {errors:?}",
                case.scene
            );
        }
    }
}

/// One list makes the tests and says which references have one.
macro_rules! cases {
    ($($test:ident: $case:expr;)*) => {
        $(#[test]
        fn $test() {
            with_room(|| check(&$case));
        })*

        const CASES: &[Case] = &[$($case),*];
    };
}

cases! {
    pendulum: Case {
        scene: "pendulum",
        step: 1e-2,
        until: 3.0,
        order: Order::Second { finest: 7e-4 },
        energy: 5e-3,
    };
    pendulum_by_angle: Case {
        scene: "pendulum-angle",
        step: 1e-2,
        until: 3.0,
        order: Order::Second { finest: 1.5e-4 },
        energy: 3e-3,
    };
    slider_crank: Case {
        scene: "slider-crank",
        step: 5e-3,
        until: 2.0,
        order: Order::Second { finest: 5e-5 },
        energy: 8e-3,
    };
    driven_slider_crank: Case {
        scene: "driven-slider-crank",
        step: 2e-4,
        until: 0.06,
        order: Order::Exact { error: 1e-9 },
        energy: 4e-2,
    };
    double_four_bar: Case {
        scene: "double-four-bar",
        step: 1e-2,
        until: 3.0,
        order: Order::Second { finest: 1.5e-3 },
        energy: 6e-2,
    };
    four_bar_40: Case {
        scene: "four-bar-40",
        step: 2e-2,
        until: 2.0,
        order: Order::Second { finest: 2.5e-3 },
        energy: 4.0,
    };
    andrews: Case {
        scene: "andrews",
        step: 1e-5,
        until: 0.01,
        order: Order::Second { finest: 4e-7 },
        energy: 1e-6,
    };
    andrews_iftomm: Case {
        scene: "andrews-iftomm",
        step: 1e-5,
        until: 0.01,
        order: Order::Second { finest: 4e-7 },
        energy: 1e-6,
    };
    chaplygin_sleigh: Case {
        scene: "chaplygin-sleigh",
        step: 2.5e-2,
        until: 4.0,
        order: Order::Second { finest: 8e-5 },
        energy: 1e-11,
    };
    knife_edge: Case {
        scene: "knife-edge",
        step: 2.5e-2,
        until: 4.0,
        order: Order::Second { finest: 5e-4 },
        energy: 1e-11,
    };
    knife_edge_moving: Case {
        scene: "knife-edge-moving",
        step: 2.5e-2,
        until: 4.0,
        order: Order::Second { finest: 4e-4 },
        energy: 1e-11,
    };
    heavy_top: Case {
        scene: "heavy-top",
        step: 1e-3,
        until: 0.2,
        order: Order::Second { finest: 8e-6 },
        energy: 1.2e-2,
    };
    bricard: Case {
        scene: "bricard",
        step: 2.5e-2,
        until: 3.0,
        order: Order::Second { finest: 1e-4 },
        energy: 3e-3,
    };
    bricard_slender: Case {
        scene: "bricard-slender",
        step: 2.5e-2,
        until: 3.0,
        order: Order::Second { finest: 1e-4 },
        energy: 3e-3,
    };
    bricard_reference: Case {
        scene: "bricard-reference",
        step: 2.5e-2,
        until: 3.0,
        order: Order::Second { finest: 5e-5 },
        energy: 3e-3,
    };
    flyball_governor: Case {
        scene: "flyball-governor",
        step: 1e-2,
        until: 1.0,
        order: Order::Second { finest: 2e-4 },
        energy: 0.2,
    };
    rolling_disk: Case {
        scene: "rolling-disk",
        step: 1e-2,
        until: 3.0,
        order: Order::Second { finest: 1e-4 },
        energy: 2e-4,
    };
    rolling_disk_tilted: Case {
        scene: "rolling-disk-tilted",
        step: 1e-3,
        until: 0.3,
        order: Order::Second { finest: 1.5e-4 },
        energy: 5e-4,
    };
}

#[test]
fn no_reference_is_forgotten() {
    for scene in scenes().iter().filter(|scene| scene.reference.is_some()) {
        assert!(
            CASES.iter().any(|case| case.scene == scene.name),
            "`{}` has a reference, but no case in this file",
            scene.name
        );
    }
}

/// Forwards, velocities turned round, and back: the start.
fn returns<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    step: f64,
    steps: usize,
) where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let settings = Settings {
        step,
        ..Settings::default()
    };
    let mut forth = Simulation::with_settings(mechanism.clone(), settings).expect(S::MODEL.name);
    let start = forth.state().clone();
    for _ in 0..steps {
        forth.step().expect(S::MODEL.name);
    }
    let there = forth.state();
    let moved = (0..N)
        .map(|i| (there.positions[i] - start.positions[i]).abs())
        .fold(0.0, f64::max);
    assert!(moved > 1e-2, "{} did not go anywhere", S::MODEL.name);
    let turned = State::new(0.0, there.positions, there.velocities.map(|v| -v));
    let mut back = Simulation::resume(mechanism, settings, turned).expect(S::MODEL.name);
    for _ in 0..steps {
        back.step().expect(S::MODEL.name);
    }
    let speed = start
        .velocities
        .iter()
        .fold(1.0, |speed: f64, v| speed.max(v.abs()));
    let worst = (0..N).fold(0.0, |worst: f64, i| {
        let q = (back.positions()[i] - start.positions[i]).abs();
        let v = (back.velocities()[i] + start.velocities[i]).abs() / speed;
        worst.max(q).max(v)
    });
    println!("{}: back to within {worst:e}", S::MODEL.name);
    assert!(worst <= 1e-9, "{}: {worst:e} from the start", S::MODEL.name);
}

/// All scenes but the driven one, whose drive does not turn round, and the governor, whose dampers do not.
#[test]
fn time_can_be_reversed() {
    with_room(|| {
        returns(scenes::pendulum::Pendulum::default(), 1e-2, 200);
        returns(scenes::pendulum::PendulumByAngle::default(), 1e-2, 200);
        returns(
            scenes::double_pendulum::DoublePendulum::default(),
            5e-3,
            100,
        );
        returns(scenes::slider_crank::SliderCrank::default(), 5e-3, 150);
        returns(scenes::double_four_bar::DoubleFourBar::default(), 1e-2, 100);
        returns(scenes::four_bar_40::FourBar40::default(), 1e-2, 50);
        returns(scenes::andrews::Andrews::default(), 1e-5, 500);
        returns(
            scenes::chaplygin_sleigh::ChaplyginSleigh::default(),
            2e-2,
            150,
        );
        returns(scenes::knife_edge::KnifeEdge::default(), 2e-2, 150);
        returns(
            scenes::spherical_pendulum::SphericalPendulum::default(),
            1e-2,
            100,
        );
        returns(scenes::heavy_top::HeavyTop::default(), 1e-3, 100);
        returns(scenes::bricard::Bricard::default(), 1e-2, 50);
        returns(scenes::cardan_shaft::CardanShaft::default(), 1e-2, 50);
        returns(scenes::rolling_disk::RollingDisk::default(), 1e-2, 150);
        returns(scenes::rattleback::Rattleback::default(), 1e-3, 500);
    });
}
