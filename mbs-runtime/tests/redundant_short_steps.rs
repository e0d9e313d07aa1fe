//! Redundant rows in short steps: their multipliers stay as large as the forces.

use mbs_runtime::{Settings, Simulation, mechanism};

mechanism!(Bennett {
    doc: "Four bodies in a loop that only its special axes let move: three of its rows follow from the others.",
    world: Spatial(
        gravity = [0.0, 0.0, -9.81_m_per_s2],
        coordinates = Reference
    ),
    one: Body(
        mass = 1.0_kg,
        inertia = diag(0.02, 0.03, 0.025),
        at = [0.043412044416732604, 0.24620193825305201, 0.0]
    ),
    two: Body(
        mass = 1.0_kg,
        inertia = diag(0.02, 0.03, 0.025),
        at = [-0.10490018406208018, 0.20384099094128061, 0.116385746205799]
    ),
    three: Body(
        mass = 1.0_kg,
        inertia = diag(0.02, 0.03, 0.025),
        at = [
            -0.51378777849919866,
            -0.042360947311771251,
            0.116385746205799
        ]
    ),
    j0: Revolute(ground, one, at = [0.0, 0.0, 0.0], axis = [0.0, 0.0, 1]),
    j1: Revolute(
        one,
        two,
        at = [0.086824088833465207, 0.49240387650610401, 0.0],
        axis = [
            0.63302222155948895,
            -0.11161889704894969,
            0.76604444311897801
        ]
    ),
    j2: Revolute(
        two,
        three,
        at = [
            -0.29662445695762557,
            -0.084721894623542793,
            0.232771492411598
        ],
        axis = [
            -0.31845015678697797,
            0.52887609041857986,
            0.78668899739726061
        ]
    ),
    j3: Revolute(
        ground,
        three,
        at = [-0.73095110004077168, 2.9143354396410359e-16, 0.0],
        axis = [
            4.4408920985006262e-16,
            0.93969262078590832,
            0.34202014332566882
        ]
    ),
});

/// Their extrapolation grew to 1e9 N, and steps failed or gained energy.
#[test]
fn multipliers_of_redundant_rows_do_not_grow() {
    for step in [1e-3, 2e-4, 1.342e-4, 5e-5] {
        let settings = Settings {
            step,
            ..Settings::default()
        };
        let mut simulation = Simulation::with_settings(Bennett::default(), settings).unwrap();
        // Between two singular poses, where forces are below 20 N; beside them they are 1e4 N.
        simulation
            .run_until(1.6)
            .unwrap_or_else(|error| panic!("{step}: {error}"));
        let most = simulation.state().multipliers.amax();
        let report = simulation.report();
        println!("{step}: {most:.1} N, {report:?}");
        assert!(most < 100.0, "{step}: {most} N");
        assert_eq!(report.rejected_steps, 0, "{step}");
        // Second order: 48 h².
        let bound = 60.0 * step * step;
        assert!(report.energy_error < bound, "{step}: {report:?}");
    }
}
