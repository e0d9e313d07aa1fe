//! Random mechanisms in all descriptions: the same freedoms, energies, motion of points and reactions, from the derived
//! expressions without compiling them. `MECHANISMS=…` is their number.

use mbs_macros_core::{Analysis, analyse};
use mbs_tests::instant::Instant;
use mbs_tests::mechanisms::{planar, spatial};

/// Required agreement, relative to the largest value of its kind.
const TOLERANCE: f64 = 1e-8;
/// Beside a singular pose accelerations have fewer digits.
const SINGULAR: f64 = 1e-6;

fn count(default: usize) -> usize {
    let wanted = std::env::var("MECHANISMS");
    wanted
        .ok()
        .and_then(|text| text.parse().ok())
        .unwrap_or(default)
}

/// The analysis; the messages of a refusal.
fn analysed(text: &str) -> Result<Analysis, Vec<String>> {
    let tokens = text.parse().expect("these are tokens");
    let messages = |list: Vec<(String, _)>| list.into_iter().map(|(text, _)| text).collect();
    analyse(tokens)
        .1
        .map_err(|failure| messages(failure.messages()))
}

/// The largest difference of two lists, relative to their largest value.
fn apart<'a>(a: impl Iterator<Item = (&'a f64, &'a f64)>) -> f64 {
    let (mut most, mut size) = (0.0_f64, 1.0_f64);
    for (a, b) in a {
        let difference = (a - b).abs();
        most = if difference <= most { most } else { difference };
        size = size.max(a.abs());
    }
    most / size
}

fn compare(kind: &str, make: fn(usize, &str) -> String, mechanisms: usize) {
    let (mut compared, mut refused) = (0, 0);
    for number in 0..mechanisms {
        let mut found: Vec<(&str, Analysis)> = Vec::new();
        for coordinates in ["Reference", "Joint", "Natural", "Auto"] {
            match analysed(&make(number, coordinates)) {
                Ok(analysis) => found.push((coordinates, analysis)),
                Err(messages) => {
                    println!("{kind} {number} {coordinates}: {messages:?}");
                    refused += 1;
                }
            }
        }
        let [(_, first), others @ ..] = &found[..] else {
            continue;
        };
        let expected = Instant::after_rest(first, 0.1);
        let freedoms =
            |analysis: &Analysis, instant: &Instant| analysis.derived.system.size - instant.rank;
        for (coordinates, other) in others {
            let what = format!(
                "{kind} {number} in {coordinates}: {}",
                make(number, coordinates)
            );
            let instant = Instant::after_rest(other, 0.1);
            if instant.margin.min(expected.margin) < SINGULAR {
                println!("{what}: beside a singular pose");
                continue;
            }
            assert!(instant.open() < 1e-9, "{what}: {}", instant.open());
            assert_eq!(
                freedoms(other, &instant),
                freedoms(first, &expected),
                "{what}"
            );
            let [a, b] = [&expected, &instant].map(Instant::quantities);
            let error = apart(a.iter().zip(&b));
            assert!(error < TOLERANCE, "{what}: {error:e}\n{a:?}\n{b:?}");
            let [a, b] = [&expected, &instant].map(Instant::reactions);
            let both = || a.keys().filter(|name| b.contains_key(*name));
            let error = apart(both().map(|name| (&a[name], &b[name])));
            assert!(error < TOLERANCE, "{what}: {error:e}\n{a:#?}\n{b:#?}");
            let [a, b] = [&a, &b].map(|list| list.keys().collect::<Vec<_>>());
            assert_eq!(a, b, "{what}: other reactions are determined");
            compared += 1;
        }
    }
    println!("{kind}: {compared} compared, {refused} refused");
    assert!(compared >= mechanisms, "{kind}: {compared} compared");
}

#[test]
fn in_the_plane() {
    compare("planar", planar, count(40));
}

#[test]
fn in_space() {
    compare("spatial", spatial, count(30));
}
