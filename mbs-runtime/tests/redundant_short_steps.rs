//! Redundant rows in short steps: their multipliers stay as large as the forces.

use crate::common;
use mbs_runtime::{Settings, Simulation};

common::bennett::bennett!(Reference);

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
