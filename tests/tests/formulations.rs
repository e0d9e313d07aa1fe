//! The same motion in all coordinates: each description converges to the reference with second order, through singular
//! poses, and has the same outputs and reactions.

use mbs_examples::scene::Scene;
use mbs_examples::scenes::scenes;
use mbs_runtime::{AnySimulation, Mechanism, Settings, Simulation};
use mbs_tests::reference::{self, deviation};

include!(concat!(env!("OUT_DIR"), "/formulations.rs"));

/// Velocities and rows of a description.
type Size = (usize, usize);

struct Case {
    scene: &'static str,
    /// The coarser of two steps, the other half as long, s.
    step: f64,
    until: f64,
    /// Largest deviation with the finer one.
    error: f64,
}

const PENDULUM: Case = Case {
    scene: "pendulum",
    step: 5e-3,
    until: 3.0,
    error: 7e-4,
};
const SLIDER_CRANK: Case = Case {
    scene: "slider-crank",
    step: 2.5e-3,
    until: 2.0,
    error: 5e-4,
};
const DOUBLE_FOUR_BAR: Case = Case {
    scene: "double-four-bar",
    step: 5e-3,
    until: 3.0,
    error: 3e-3,
};
const HEAVY_TOP: Case = Case {
    scene: "heavy-top",
    step: 1e-3,
    until: 0.2,
    error: 1e-3,
};
const BRICARD: Case = Case {
    scene: "bricard",
    step: 1.25e-2,
    until: 3.0,
    error: 1e-4,
};
const FLYBALL_GOVERNOR: Case = Case {
    scene: "flyball-governor",
    step: 5e-3,
    until: 1.0,
    error: 2e-3,
};

fn check<M>(
    case: &Case,
    (velocities, rows): Size,
    build: impl Fn(Settings) -> Box<dyn AnySimulation>,
) where
    M: Mechanism,
{
    assert_eq!(
        (M::MODEL.velocities.len(), M::MODEL.rows.len()),
        (velocities, rows)
    );
    let scene: &Scene = scenes()
        .iter()
        .find(|scene| scene.name == case.scene)
        .expect("a scene");
    let names = |model: &mbs_runtime::Model| -> Vec<_> {
        model.outputs.iter().map(|output| output.name).collect()
    };
    assert_eq!(names(M::MODEL), names(scene.model));
    let table = reference::table(scene.reference.as_ref().expect("a reference").file);
    let errors = [1.0, 0.5].map(|part| {
        let settings = Settings {
            step: part * case.step,
            ..Settings::default()
        };
        let mut simulation = build(settings);
        let error = deviation(&mut *simulation, scene, &table, case.until);
        println!(
            "h = {:e}: {error:e}; {:?}",
            settings.step,
            simulation.report()
        );
        error
    });
    let slope = (errors[0] / errors[1]).log2();
    assert!((1.8..=2.2).contains(&slope), "slope {slope}: {errors:?}");
    assert!(errors[1] <= case.error, "{errors:?}");
}

macro_rules! cases {
    ($($test:ident: $mechanism:ty, $case:ident, $size:expr;)*) => {
        $(#[test]
        fn $test() {
            check::<$mechanism>(&$case, $size, |settings| {
                Box::new(
                    Simulation::with_settings(<$mechanism>::default(), settings)
                        .expect(stringify!($mechanism)),
                )
            });
        })*
    };
}

cases! {
    pendulum_natural: natural::Pendulum, PENDULUM, (2, 1);
    pendulum_joint: joint::Pendulum, PENDULUM, (1, 0);
    slider_crank_natural: natural::SliderCrank, SLIDER_CRANK, (3, 2);
    slider_crank_reference: reference_points::SliderCrank, SLIDER_CRANK, (6, 5);
    slider_crank_joint: joint::SliderCrank, SLIDER_CRANK, (2, 1);
    double_four_bar_natural: natural::DoubleFourBar, DOUBLE_FOUR_BAR, (6, 5);
    double_four_bar_reference: reference_points::DoubleFourBar, DOUBLE_FOUR_BAR, (15, 14);
    double_four_bar_joint: joint::DoubleFourBar, DOUBLE_FOUR_BAR, (5, 4);
    heavy_top_reference: reference_points::HeavyTop, HEAVY_TOP, (6, 3);
    heavy_top_joint: joint::HeavyTop, HEAVY_TOP, (3, 0);
    bricard_reference: reference_points::Bricard, BRICARD, (30, 30);
    bricard_joint: joint::Bricard, BRICARD, (5, 5);
    flyball_governor_reference: reference_points::FlyballGovernor, FLYBALL_GOVERNOR, (24, 20);
    flyball_governor_joint: joint::FlyballGovernor, FLYBALL_GOVERNOR, (4, 0);
}

/// Reactions are the same, too, where they are unique.
#[test]
fn the_same_reactions() {
    fn reaction<M, S, const Q: usize, const N: usize, const R: usize>(joint: &str) -> Vec<f64>
    where
        M: Mechanism<System = S> + Default,
        S: mbs_runtime::System<Q, N, R>,
    {
        let settings = Settings {
            step: 1e-4,
            ..Settings::default()
        };
        let mut simulation =
            Simulation::<S, Q, N, R>::with_settings(M::default(), settings).expect("it assembles");
        simulation.run_until(0.1).expect("it runs");
        let reactions = simulation.reactions().expect("they are known");
        let names = M::MODEL.reactions.iter();
        let values = names.zip(&reactions.values);
        values
            .filter(|(reaction, _)| reaction.joint == joint)
            .map(|(_, value)| *value)
            .collect()
    }
    let close = |a: Vec<f64>, b: Vec<f64>| {
        assert!(!a.is_empty());
        assert_eq!(a.len(), b.len());
        let size = a.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
        for (a, b) in a.iter().zip(&b) {
            assert!((a - b).abs() <= 2e-4 * size, "{a} and {b}, size {size}");
        }
    };
    close(
        reaction::<natural::Pendulum, _, _, _, _>("pivot"),
        reaction::<joint::Pendulum, _, _, _, _>("pivot"),
    );
    close(
        reaction::<reference_points::HeavyTop, _, _, _, _>("pivot"),
        reaction::<joint::HeavyTop, _, _, _, _>("pivot"),
    );
    for hinge in ["bearing", "right_hinge"] {
        close(
            reaction::<reference_points::FlyballGovernor, _, _, _, _>(hinge),
            reaction::<joint::FlyballGovernor, _, _, _, _>(hinge),
        );
    }
}
