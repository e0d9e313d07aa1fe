//! Time of a step: hand-written and generated double four-bar in one run, and the other scenes.
//!
//! `cargo bench -p mbs-examples --bench step_time`

#[allow(clippy::needless_range_loop)]
mod handwritten;

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use mbs_examples::scenes::double_four_bar::DoubleFourBar;
use mbs_runtime::{Mechanism, Settings, Simulation, TwoLevelStepper};
use std::hint::black_box;

const STEP: f64 = 1e-3;

/// Both repeat the same second of motion, through the first singular pose.
const STEPS: u64 = 1000;

fn double_four_bar(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("double four-bar");
    group.throughput(Throughput::Elements(STEPS));
    group.bench_function("hand-written", |bencher| {
        let run = |mut mechanism: handwritten::DoubleFourBar| {
            (0..STEPS).for_each(|_| mechanism.step(black_box(STEP)));
            assert!(
                (mechanism.energy() - 35.835).abs() < 1e-3,
                "the yardstick lost its way"
            );
            mechanism
        };
        bencher.iter_batched(handwritten::DoubleFourBar::new, run, BatchSize::SmallInput);
    });
    group.bench_function("generated", |bencher| {
        let settings = Settings {
            step: STEP,
            ..Settings::default()
        };
        let start = || {
            let simulation = Simulation::with_settings(DoubleFourBar::default(), settings)
                .expect("it assembles");
            let system = DoubleFourBar::default()
                .prepare()
                .expect("its parameters are fine");
            TwoLevelStepper::new(system, simulation.state().clone(), &settings)
                .expect("its settings are fine")
        };
        let run = |mut stepper: TwoLevelStepper<_, 6, 6, 5>| {
            (0..STEPS).for_each(|_| stepper.step(black_box(STEP)).expect("it converges"));
            stepper
        };
        bencher.iter_batched(start, run, BatchSize::SmallInput);
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
