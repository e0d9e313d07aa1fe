//! Every scene in other units of length, mass and time: each bit of the dimensionless motion and every count of the
//! report is the same, so that no absolute number decides.

use mbs_examples::scenes;
use mbs_runtime::{Mechanism, Settings, Simulation, System};
use mbs_tests::units::{InUnits, Units};

/// Steps of a run: those of the scene with thirty velocities and dense arrays take ten times as long as those of any
/// other.
const fn steps(velocities: usize) -> u32 {
    if velocities == 30 { 24 } else { 60 }
}
/// A step with which the chains of four-bars pass their first singular pose in a run, s.
const LONG: f64 = 0.02;

/// The dimensionless motion, and the counts of the report.
fn run<M, S, const Q: usize, const N: usize, const R: usize>(
    units: Units,
    settings: Settings,
) -> (Vec<f64>, [u64; 5])
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let settings = Settings {
        step: settings.step * units.time,
        ..settings
    };
    let mechanism = InUnits::<M>::new(units);
    let mut simulation = Simulation::<_, Q, N, R>::with_settings(mechanism, settings)
        .unwrap_or_else(|error| panic!("{units:?}: {error}"));
    let mut states = Vec::new();
    for part in 1..=3 {
        let time = f64::from(part * steps(N) / 3) * settings.step;
        (simulation.run_until(time)).unwrap_or_else(|error| panic!("{units:?}: {error}"));
        let q = simulation.positions().iter().zip(M::MODEL.coordinates);
        let v = simulation.velocities().iter().zip(M::MODEL.velocities);
        let state = q.chain(v);
        states.extend(state.map(|(value, quantity)| value / units.factor(quantity.unit)));
        states.push(simulation.energy().error / units.energy());
    }
    let report = simulation.report();
    let counts = [
        report.steps,
        report.stages,
        report.rejected_steps,
        report.placed_steps,
        report.iterations,
    ];
    (states, counts)
}

fn compare<M, S, const Q: usize, const N: usize, const R: usize>(name: &str)
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let mut scenes = scenes::scenes().iter();
    let step = scenes.find(|scene| scene.name == name).expect(name).step;
    let with_tolerance = Settings {
        step,
        ..Settings::for_tolerance(1e-5)
    };
    let of_order = |order| Settings {
        order,
        step,
        ..Settings::default()
    };
    let mut all = vec![of_order(2), of_order(8), with_tolerance];
    if S::ELIMINATION.is_some() {
        // Through a singular pose, which sparse and dense steps share.
        all.extend([2, 8].map(|order| Settings {
            step: LONG,
            ..of_order(order)
        }));
    }
    let mut compared = 0;
    for settings in all {
        let accepted = Simulation::<S, Q, N, R>::with_settings(M::default(), settings).is_ok();
        if !accepted {
            continue;
        }
        let expected = run::<M, S, Q, N, R>(Units::powers_of_four(0, 0, 0), settings);
        for (length, mass, time) in [
            (-10, 0, 0),
            (0, -20, 0),
            (0, 0, -5),
            (12, 10, 4),
            (-20, 10, 4),
        ] {
            let units = Units::powers_of_four(length, mass, time);
            let found = run::<M, S, Q, N, R>(units, settings);
            assert_eq!(found, expected, "{units:?}, order {}", settings.order);
        }
        compared += 1;
    }
    assert!(compared > 0, "{name}: all settings were refused");
}

macro_rules! scenes {
    ($($name:literal, $test:ident: $mechanism:ty;)*) => {
        $(#[test]
        fn $test() {
            mbs_tests::with_room(|| compare::<$mechanism, _, _, _, _>($name));
        })*

        #[test]
        fn no_scene_is_forgotten() {
            let names = [$(<$mechanism as Mechanism>::MODEL.name),*];
            for scene in scenes::scenes() {
                assert!(names.contains(&scene.model.name), "{}", scene.name);
            }
        }
    };
}

scenes! {
    "pendulum", pendulum: scenes::pendulum::Pendulum;
    "pendulum-angle", pendulum_by_angle: scenes::pendulum::PendulumByAngle;
    "double-pendulum", double_pendulum: scenes::double_pendulum::DoublePendulum;
    "knife-edge", knife_edge: scenes::knife_edge::KnifeEdge;
    "slider-crank", slider_crank: scenes::slider_crank::SliderCrank;
    "double-four-bar", double_four_bar: scenes::double_four_bar::DoubleFourBar;
    "four-bar-10", four_bar_10: scenes::four_bar_10::FourBar10;
    "four-bar-40", four_bar_40: scenes::four_bar_40::FourBar40;
    "andrews", andrews: scenes::andrews::Andrews;
    "chaplygin-sleigh", chaplygin_sleigh: scenes::chaplygin_sleigh::ChaplyginSleigh;
    "driven-slider-crank", driven_slider_crank: scenes::driven_slider_crank::DrivenSliderCrank;
    "spherical-pendulum", spherical_pendulum: scenes::spherical_pendulum::SphericalPendulum;
    "heavy-top", heavy_top: scenes::heavy_top::HeavyTop;
    "bricard", bricard: scenes::bricard::Bricard;
    "bricard-reference", bricard_reference: scenes::bricard::BricardReference;
    "flyball-governor", flyball_governor: scenes::flyball_governor::FlyballGovernor;
    "cardan-shaft", cardan_shaft: scenes::cardan_shaft::CardanShaft;
    "rolling-disk", rolling_disk: scenes::rolling_disk::RollingDisk;
    "rattleback", rattleback: scenes::rattleback::Rattleback;
}
