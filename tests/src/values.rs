//! The values of the compiled functions at a state without symmetry, as text: every flipped sign changes it.

use crate::compiled;
use crate::fixtures;
use crate::random::{Arguments, Random};
use crate::tampered::Tampered;
use mbs_examples::scenes;
use mbs_runtime::{Mechanism, System};
use std::collections::BTreeMap;
use std::fmt::Write;

/// A quantity: its symbol, its name in [`Tampered`], and the function and argument that it comes from.
type Quantity = (&'static str, &'static str, &'static str, &'static str);

/// The quantities, in the order of the text.
pub const QUANTITIES: [Quantity; 15] = [
    ("M", "mass", "mass_matrix", "mass"),
    ("p", "p", "momentum", "p"),
    ("Γ", "affinities", "affinities", "gamma"),
    ("φ", "holonomic", "holonomic", "phi"),
    ("A", "a", "constraints", "a"),
    ("b", "b", "constraints", "b"),
    ("Ȧ", "a_rate", "constraint_rates", "a_rate"),
    ("γ", "gamma", "constraint_rates", "gamma"),
    ("f", "f", "applied_forces", "f"),
    ("F", "F", "forces", "f"),
    ("∂f/∂q", "f_q", "applied_force_tangents", "f_q"),
    ("∂f/∂v", "f_v", "applied_force_tangents", "f_v"),
    ("∂F/∂q", "F_q", "force_tangents", "f_q"),
    ("∂F/∂v", "F_v", "force_tangents", "f_v"),
    ("∂p/∂q", "p_q", "force_tangents", "p_q"),
];

/// Smaller values, relative to the largest entry of the quantity, are round-off.
const ROUND_OFF: f64 = 1e-12;

/// The values of each mechanism of the list below, by its name.
pub fn texts() -> Vec<(&'static str, String)> {
    mechanisms().into_iter().map(|m| (m.name, m.text)).collect()
}

/// How many entries of each quantity were given the opposite sign, and which of these changes do not change the text.
pub fn flips() -> (BTreeMap<&'static str, usize>, Vec<String>) {
    let (mut counts, mut unseen) = (BTreeMap::new(), Vec::new());
    for Values {
        name,
        text,
        with_sign_flipped,
    } in mechanisms()
    {
        for (symbol, entry, flipped) in with_sign_flipped() {
            *counts.entry(symbol).or_default() += 1;
            if flipped == text {
                unseen.push(format!("{name}: {symbol}{entry:?}"));
            }
        }
    }
    (counts, unseen)
}

struct Values {
    name: &'static str,
    text: String,
    /// For each entry that is not zero: its symbol, its place, and the text with its sign flipped.
    with_sign_flipped: fn() -> Vec<(&'static str, [usize; 3], String)>,
}

macro_rules! mechanisms {
    ($($name:literal: $mechanism:ty;)*) => {
        fn mechanisms() -> Vec<Values> {
            vec![$(Values {
                name: $name,
                text: text_of::<$mechanism, _, _, _, _>(),
                with_sign_flipped: flipped::<$mechanism, _, _, _, _>,
            }),*]
        }
    };
}

mechanisms! {
    "slider-crank": scenes::slider_crank::SliderCrank;
    "driven-slider-crank": scenes::driven_slider_crank::DrivenSliderCrank;
    "andrews": scenes::andrews::Andrews;
    "bricard": scenes::bricard::Bricard;
    "rolling-disk": scenes::rolling_disk::RollingDisk;
    "sled": fixtures::Sled;
}

fn prepare<M, S, const Q: usize, const N: usize, const R: usize>() -> (S, Arguments<Q, N, R>)
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let mechanism = M::default();
    let system = mechanism.prepare().expect("default parameters are good");
    let state = Arguments::near(&system, &mut Random::of(<M as Mechanism>::MODEL.name));
    (system, state)
}

fn text_of<M, S, const Q: usize, const N: usize, const R: usize>() -> String
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let (system, state) = prepare::<M, _, _, _, _>();
    text(&system, &state)
}

fn flipped<M, S, const Q: usize, const N: usize, const R: usize>()
-> Vec<(&'static str, [usize; 3], String)>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let (system, state) = prepare::<M, _, _, _, _>();
    let mut list = Vec::new();
    for ((symbol, name, ..), entries) in entries(&system, &state) {
        for (place, value) in entries {
            if value != 0.0 {
                let tampered = Tampered::with_sign_flipped(system.clone(), name, place);
                list.push((symbol, place, text(&tampered, &state)));
            }
        }
    }
    list
}

/// All quantities at a state, with 0 for round-off.
fn entries<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    at: &Arguments<Q, N, R>,
) -> Vec<(Quantity, Vec<([usize; 3], f64)>)> {
    let table = compiled::table(system, at);
    QUANTITIES
        .into_iter()
        .map(|quantity| {
            let mut entries = table.of(quantity.2, quantity.3);
            let sizes = entries.iter().map(|(_, value)| value.abs());
            let largest = sizes.fold(0.0, f64::max);
            for (_, value) in &mut entries {
                if value.abs() <= ROUND_OFF * largest {
                    *value = 0.0;
                }
            }
            (quantity, entries)
        })
        .collect()
}

fn text<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    at: &Arguments<Q, N, R>,
) -> String {
    let mut out = format!("t = {}\n", number(at.time));
    for (symbol, values) in [("q", at.q.as_slice()), ("v", at.v.as_slice())] {
        for (i, &value) in values.iter().enumerate() {
            let _ = writeln!(out, "{symbol}[{i}] = {}", number(value));
        }
    }
    for ((symbol, _, function, sink), entries) in entries(system, at) {
        let indices = match (sink, function) {
            ("gamma", "affinities") => 3,
            ("mass" | "a" | "a_rate" | "f_q" | "f_v" | "p_q", _) => 2,
            _ => 1,
        };
        for (place, value) in entries {
            let place: String = place[..indices].iter().map(|i| format!("[{i}]")).collect();
            let _ = writeln!(out, "{symbol}{place} = {}", number(value));
        }
    }
    out
}

/// Ten digits: more would depend on the machine's elementary functions.
fn number(value: f64) -> String {
    match value {
        0.0 => "0".to_owned(),
        value => format!("{value:.9e}"),
    }
}
