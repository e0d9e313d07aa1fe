//! Time of a step: hand-written and generated double four-bar in one run, and the other scenes.
//!
//! `cargo bench -p mbs-examples --bench step_time`

#[allow(clippy::needless_range_loop)]
mod handwritten;

use criterion::{Criterion, criterion_group, criterion_main};
use mbs_examples::scenes::double_four_bar::DoubleFourBar;
use mbs_runtime::{Mechanism, Settings, Simulation, TwoLevelStepper};
use std::hint::black_box;

const STEP: f64 = 1e-3;

fn double_four_bar(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("double four-bar");
    group.bench_function("hand-written", |bencher| {
        let mut mechanism = handwritten::DoubleFourBar::new();
        bencher.iter(|| mechanism.step(black_box(STEP)));
        assert!((mechanism.energy() - 35.835).abs() < 1e-2);
    });
    group.bench_function("generated", |bencher| {
        let Ok(system) = DoubleFourBar::default().prepare() else {
            return;
        };
        let Ok(simulation) = Simulation::new(DoubleFourBar::default()) else {
            return;
        };
        let settings = Settings {
            step: STEP,
            ..Settings::default()
        };
        let Ok(mut stepper) = TwoLevelStepper::new(system, simulation.state().clone(), &settings)
        else {
            return;
        };
        bencher.iter(|| stepper.step(black_box(STEP)));
    });
    group.finish();
}

fn scenes(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("simulated step with energy ledger");
    for scene in mbs_examples::scenes::scenes() {
        let settings = Settings {
            step: scene.step,
            ..Settings::default()
        };
        let Ok(mut simulation) = (scene.build)(&[], settings) else {
            continue;
        };
        group.bench_function(scene.name, |bencher| bencher.iter(|| simulation.step()));
    }
    group.finish();
}

criterion_group!(benches, double_four_bar, scenes);
criterion_main!(benches);
