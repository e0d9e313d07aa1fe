//! The module of the book compared with this crate as a native program: the same steps, digit by digit; the same
//! refusals; no panic in either; and a small page.

mod module;

use mbs_live::{Figure, HEAD, MECHANISMS, METHODS, description};
use module::{Page, folder};
use std::{fs, thread};

/// Numbers of [`Figure::read`].
const ROOM: usize = 512;

/// A run in the module and the same natively.
struct Both {
    page: Page,
    figure: Figure,
}

/// An answer of both, which has to be the same.
fn agreed<T: PartialEq + std::fmt::Debug>(
    module: Result<T, String>,
    native: Result<T, mbs_live::Refusal>,
) -> Result<T, String> {
    assert_eq!(module, native.map_err(|refusal| refusal.to_string()));
    module
}

impl Both {
    fn new() -> Self {
        Both {
            page: Page::open(),
            figure: Figure::default(),
        }
    }

    fn start(
        &mut self,
        mechanism: usize,
        method: usize,
        step: f64,
        parameters: &[f64],
    ) -> Result<(), String> {
        let native = self.figure.start(0, mechanism, method, step, parameters);
        let module = self.page.start(0, mechanism, method, step, parameters);
        agreed(module, native)
    }

    fn step(&mut self) -> Result<usize, String> {
        let native = self.figure.advance(0, f64::INFINITY, 1);
        agreed(self.page.advance(0, f64::INFINITY, 1), native)
    }

    /// Where the runs are: in the module, natively.
    fn read(&mut self) -> [Vec<f64>; 2] {
        let mut native = vec![0.0; ROOM];
        let count = self.figure.read(0, &mut native).expect("it was started");
        native.truncate(count);
        let module = self.page.read(0).expect("it was started");
        assert_eq!(module.len(), native.len());
        [module, native]
    }
}

fn index(name: &str) -> usize {
    let found = MECHANISMS.iter().position(|m| m.scene.name == name);
    found.expect("a mechanism")
}

fn same_bits(one: &[f64], other: &[f64]) -> bool {
    one.iter()
        .zip(other)
        .all(|(x, y)| x.to_bits() == y.to_bits())
}

/// The largest difference of two instants, relative to numbers above 1.
fn difference(one: &[f64], other: &[f64]) -> f64 {
    let differences = one
        .iter()
        .zip(other)
        .map(|(x, y)| (x - y).abs() / y.abs().max(1.0));
    differences.fold(0.0, f64::max)
}

/// Steps of 10 ms that are compared, and how many.
const STEP: f64 = 1e-2;
const STEPS: usize = 1000;

/// Points of bars as coordinates: a step has no sine and no cosine, and ten seconds agree to the last bit, with every
/// method and through the singular poses.
#[test]
fn the_slider_crank_has_the_same_digits() {
    let mut both = Both::new();
    for (method, (name, _)) in METHODS.iter().enumerate() {
        both.start(index("slider-crank"), method, STEP, &[])
            .expect("it starts");
        for step in 1..=STEPS {
            both.step().expect("it goes on");
            let [module, native] = both.read();
            assert!(
                same_bits(&module, &native),
                "{name}, step {step}: {module:?} and {native:?}"
            );
        }
    }
}

/// The angle as coordinate: a step takes its sine and its cosine. Digits agree up to the first angle for which the two
/// libraries round one of them differently. From there on the torque may be off by an ulp ε of its size at each step, which
/// comes to ½ T² g/l ε = 1.1e-13 rad after T = 10 s if it never averages out, and to some times that in the energy, whose
/// terms are of 10 J.
#[test]
fn the_pendulum_has_the_same_digits_until_a_sine_is_rounded_differently() {
    let mut both = Both::new();
    both.start(index("pendulum"), 0, STEP, &[])
        .expect("it starts");
    let (mut alike, mut count, mut worst) = (true, 0, 0.0_f64);
    for step in 1..=STEPS {
        both.step().expect("it goes on");
        let [module, native] = both.read();
        let angle = native[native.len() - 2];
        alike &= libm::sin(angle).to_bits() == angle.sin().to_bits()
            && libm::cos(angle).to_bits() == angle.cos().to_bits();
        if alike {
            count = step;
            assert!(same_bits(&module, &native), "step {step}");
        }
        worst = worst.max(difference(&module, &native));
    }
    println!("pendulum: {count} steps to the last bit, then within {worst:.1e}");
    assert!(worst < 1e-12, "{worst:e}");
}

/// The same with five angles and an implicit step, so with many sines and cosines in each. Against the C library of GNU
/// one of them is first rounded differently in step 31, or 30; a module of another runtime differs in its first step.
#[test]
fn bricard_has_the_same_digits_but_for_roundings_of_sines() {
    let mut both = Both::new();
    for method in 0..2 {
        both.start(index("bricard"), method, STEP, &[])
            .expect("it starts");
        let (mut first, mut worst) = (None, 0.0_f64);
        for step in 1..=STEPS {
            both.step().expect("it goes on");
            let [module, native] = both.read();
            if !same_bits(&module, &native) {
                first.get_or_insert(step);
            }
            worst = worst.max(difference(&module, &native));
        }
        println!(
            "bricard, {}: first in step {first:?}, within {worst:.1e}",
            METHODS[method].0
        );
        assert!(worst < 1e-11, "{worst:e}");
        let soon = cfg!(target_env = "gnu") && first.is_some_and(|step| step < 10);
        assert!(!soon, "not the same runtime: build the module anew");
    }
}

#[test]
fn the_module_knows_the_same_mechanisms() {
    let mut page = Page::open();
    for (index, mechanism) in MECHANISMS.iter().enumerate() {
        assert_eq!(page.describe(index), description::describe(mechanism));
        let parameters = mechanism.scene.model.parameters;
        assert_eq!(mechanism.ranges.len(), parameters.len());
        for (parameter, [least, most]) in parameters.iter().zip(mechanism.ranges) {
            assert!(
                (*least..=*most).contains(&parameter.default),
                "{parameter:?}"
            );
        }
        let quantities = HEAD + 3 * mechanism.scene.model.points.len() + 64;
        assert!(
            quantities < ROOM,
            "the buffer is too small for {quantities} numbers"
        );
    }
}

#[test]
fn what_cannot_be_is_answered_with_a_sentence() {
    let mut both = Both::new();
    let mut refused = |mechanism, method, step, parameters: &[f64], word: &str| {
        let answer = both.start(mechanism, method, step, parameters);
        let text = answer.expect_err("it cannot be");
        assert!(text.contains(word), "{text}");
        // No run is active.
        assert!(both.step().is_err() && both.page.read(0).is_err());
    };
    refused(9, 0, 1e-3, &[], "no mechanism 9");
    refused(0, 9, 1e-3, &[], "no method 9");
    for step in [0.0, -1e-3, f64::NAN, f64::INFINITY, 1e-12, 1e6] {
        refused(1, 0, step, &[], "the step cannot be");
    }
    refused(1, 0, 1e-3, &[f64::NAN], "`length`");
    refused(1, 0, 1e-3, &[1.0, -1.0], "is negative (-1)");
    refused(2, 0, 1e-3, &[1.0, 0.0], "not positive definite");
}

/// Both sides of one mechanism with parameters at and beyond the ends of its sliders, and meaningless ones: how many starts
/// were taken, and how many refused.
fn with_hostile_values(index: usize) -> (usize, usize) {
    const HOSTILE: [f64; 9] = [
        0.0,
        -1.0,
        f64::NAN,
        f64::INFINITY,
        1e-300,
        1e300,
        1e-9,
        1e9,
        1e-160,
    ];
    let (mut page, mut figure, mut out) = (Page::open(), Figure::default(), [0.0; ROOM]);
    let (mut ran, mut refused) = (0, 0);
    let mechanism = &MECHANISMS[index];
    let defaults = mechanism.scene.model.parameters.iter().map(|p| p.default);
    let defaults: Vec<f64> = defaults.collect();
    for (place, range) in mechanism.ranges.iter().enumerate() {
        for value in HOSTILE.iter().chain(range) {
            let mut parameters = defaults.clone();
            parameters[place] = *value;
            for method in 0..METHODS.len() {
                // In steps of a millisecond nothing more happens in 20 of them than in a few.
                for (step, count) in [(1e-3, 4), (0.2, 20)] {
                    let native = figure.start(0, index, method, step, &parameters);
                    let module = page.start(0, index, method, step, &parameters);
                    // The module is older: it measures lengths in metres, native code in the mechanism. They may
                    // disagree about a size whose square is no number.
                    let size = value.abs();
                    if !(size > 0.0) || (1e-150..1e150).contains(&size) {
                        assert_eq!(native.is_ok(), module.is_ok(), "{parameters:?}");
                    }
                    match native {
                        Ok(()) => ran += 1,
                        Err(_) => refused += 1,
                    }
                    // If the outcome depends on rounding, a run may stop on one side only.
                    let _ = figure.advance(0, f64::INFINITY, count);
                    let _ = page.advance(0, f64::INFINITY, count);
                    let _ = (figure.read(0, &mut out), page.read(0));
                }
            }
        }
    }
    (ran, refused)
}

/// Either side may refuse or stop; neither panics, and both have the same messages, except for the digits of residuals
/// that are round-off. A thread for each mechanism: one alone would keep the other
/// processors waiting at the end of this program.
#[test]
fn no_value_makes_a_panic() {
    let (ran, refused) = thread::scope(|scope| {
        let threads: Vec<_> = (0..MECHANISMS.len())
            .map(|index| scope.spawn(move || with_hostile_values(index)))
            .collect();
        let counts = threads
            .into_iter()
            .map(|thread| thread.join().expect("no panic"));
        counts.fold((0, 0), |sum, count| (sum.0 + count.0, sum.1 + count.1))
    });
    assert!(
        ran > 300 && refused > 300,
        "{ran} ran, {refused} were refused"
    );
}

/// The results of a run that the page states.
struct Told {
    mechanism: &'static str,
    method: &'static str,
    step: f64,
    /// Times, s, and the largest energy error up to them, J.
    errors: &'static [(f64, f64)],
}

const TOLD: [Told; 6] = [
    Told {
        mechanism: "pendulum",
        method: "two-level",
        step: 0.1,
        errors: &[(10.0, 0.20), (300.0, 0.20)],
    },
    Told {
        mechanism: "pendulum",
        method: "baumgarte",
        step: 0.1,
        errors: &[(10.0, 7.1e-3), (60.0, 0.043), (300.0, 0.21)],
    },
    Told {
        mechanism: "slider-crank",
        method: "two-level",
        step: 0.05,
        errors: &[(10.0, 0.60), (300.0, 0.60)],
    },
    Told {
        mechanism: "slider-crank",
        method: "projected",
        step: 0.05,
        errors: &[(10.0, 0.33), (60.0, 1.4)],
    },
    Told {
        mechanism: "bricard",
        method: "two-level",
        step: 0.05,
        errors: &[(10.0, 9.7e-3), (300.0, 9.7e-3)],
    },
    Told {
        mechanism: "bricard",
        method: "projected",
        step: 0.05,
        errors: &[(10.0, 2.0e-5), (300.0, 3.5e-4)],
    },
];

fn method(name: &str) -> usize {
    let found = METHODS.iter().position(|(known, _)| *known == name);
    found.expect("a method")
}

#[test]
fn the_numbers_of_the_page_are_so() {
    let (mut figure, mut head) = (Figure::default(), [0.0; HEAD]);
    for told in &TOLD {
        let [mechanism, method] = [index(told.mechanism), method(told.method)];
        let started = figure.start(0, mechanism, method, told.step, &[]);
        started.expect("it starts");
        let mut largest = 0.0_f64;
        for &(time, error) in told.errors {
            let arrived = figure.advance(0, time, usize::MAX);
            arrived.expect("it goes on");
            figure.read(0, &mut head).expect("it was started");
            largest = largest.max(head[2]);
            let close = (largest / error - 1.0).abs() < 0.05;
            assert!(close, "{} {}: {largest:e} J", told.mechanism, told.method);
        }
    }
}

/// The statements of the page about methods that fail.
#[test]
fn methods_stop_where_the_page_says() {
    let (mut figure, mut head) = (Figure::default(), [0.0; HEAD]);
    let slider_crank = index("slider-crank");
    let started = figure.start(0, slider_crank, method("baumgarte"), 0.05, &[]);
    started.expect("it starts");
    figure.advance(0, 10.0, usize::MAX).expect("ten seconds");
    figure.read(0, &mut head).expect("it was started");
    assert!((6e-4..1e-3).contains(&head[3]), "{:e}", head[3]);
    assert!(figure.advance(0, 60.0, usize::MAX).is_err());

    let started = figure.start(0, index("bricard"), method("rattle"), 0.05, &[]);
    started.expect("it starts");
    assert!(figure.advance(0, 0.2, usize::MAX).is_err());
}

/// The size of all files that the page adds to the book.
#[test]
fn the_page_is_small_and_asks_for_nothing() {
    let (mut size, mut scripts) = (0, 0);
    for entry in fs::read_dir(folder()).expect("the folder of the page") {
        let text = fs::read_to_string(entry.expect("readable").path()).expect("UTF-8");
        size += text.len();
        if !text.contains("LIVE_MODULE = ") {
            scripts += 1;
            for address in ["http:", "https:", "url(", "@import", "import(", "fetch("] {
                assert!(!text.contains(address), "{address}");
            }
        }
    }
    println!("the page: {size} bytes");
    assert!(scripts >= 4 && size < 440_000, "{size} bytes");
}
