//! Random mechanisms in all descriptions: the same freedoms, energies, motion of points and reactions, from the derived
//! expressions without compiling them. The first 40 of each kind take seven seconds; `MECHANISMS=125`, or any number of
//! each kind, compares 500, and `FIRST=…` is the first of them: what differs is named by its number.

use mbs_macros_core::{Analysis, analyse};
use mbs_tests::flips::flip_each;
use mbs_tests::instant::Instant;
use mbs_tests::mechanisms::{planar, planar_conditioned, spatial, spatial_conditioned};
use std::cell::OnceCell;
use std::collections::BTreeMap;

/// Mechanisms of each kind.
const COUNT: usize = 40;
/// Required agreement at the start, relative to the largest value of its kind.
const TOLERANCE: f64 = 1e-8;
/// The same later, and the multiple of what the integration expects of itself.
const LATER: f64 = 1e-6;
const DOUBTFUL: f64 = 100.0;
/// Times to the second instant, s: the first at which both are known well enough.
const TIMES: [f64; 3] = [0.05, 0.015, 0.005];
/// Drives beside a singular pose ask for velocities of any size: more kinetic energy than this, J, leaves few digits.
const FAST: f64 = 1e3;
/// Beside a singular pose accelerations have fewer digits.
const SINGULAR: f64 = 1e-6;
/// No velocity satisfies rows of this residual, m/s or rad/s.
const CONTRADICTION: f64 = 1e-7;

fn number(name: &str, default: usize) -> usize {
    let wanted = std::env::var(name);
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

/// What came of a comparison.
enum Verdict {
    Same,
    /// Beside a singular pose, or without a velocity that satisfies the rows.
    Skipped(&'static str),
    Different(String),
}

/// A description, and its instants as far as they were needed.
struct Motion<'a> {
    analysis: &'a Analysis,
    start: Instant<'a>,
    later: [OnceCell<Instant<'a>>; TIMES.len()],
}

impl<'a> Motion<'a> {
    fn new(analysis: &'a Analysis) -> Self {
        Motion {
            analysis,
            start: Instant::at_start(analysis),
            later: Default::default(),
        }
    }

    fn contradicts_itself(&self) -> bool {
        self.start.contradiction > CONTRADICTION
    }

    fn later(&self, index: usize) -> &Instant<'a> {
        self.later[index].get_or_init(|| self.start.later(TIMES[index]))
    }
}

/// Compares two descriptions, at the start and later.
fn compare(first: &Motion, other: &Motion) -> Verdict {
    let contradictory = [first.contradicts_itself(), other.contradicts_itself()];
    if contradictory == [true, true] {
        return Verdict::Skipped("contradictory rows");
    }
    let singular = |instants: [&Instant; 2]| instants.iter().any(|x| x.margin < SINGULAR);
    let start = [&first.start, &other.start];
    if singular(start) {
        return Verdict::Skipped("beside a singular pose");
    }
    if contradictory != [false, false] {
        return Verdict::Different(format!("contradictory rows: {contradictory:?}"));
    }
    if start.iter().any(|instant| instant.kinetic() > FAST) {
        return Verdict::Skipped("a fast motion");
    }
    let analyses = [first.analysis, other.analysis];
    if let Err(difference) = agree(analyses, start, TOLERANCE) {
        return Verdict::Different(format!("at the start: {difference}"));
    }
    for (index, time) in TIMES.iter().enumerate() {
        let later = [first.later(index), other.later(index)];
        let doubt = later.iter().fold(0.0_f64, |most, x| most.max(x.doubt));
        if singular(later) || !(doubt < LATER) {
            continue;
        }
        return match agree(analyses, later, LATER.max(DOUBTFUL * doubt)) {
            Ok(()) => Verdict::Same,
            Err(difference) => Verdict::Different(format!("after {time} s: {difference}")),
        };
    }
    Verdict::Skipped("a fast motion")
}

/// Compares two descriptions at an instant.
fn agree(
    [first, other]: [&Analysis; 2],
    [a, b]: [&Instant; 2],
    tolerance: f64,
) -> Result<(), String> {
    for instant in [a, b] {
        let open = instant.open();
        if !(open < 0.1 * tolerance) {
            return Err(format!("the position rows are open by {open:e}"));
        }
        let [rate, power, size] = instant.power();
        let error = (rate - power).abs();
        if !(error < tolerance * size.max(1.0)) {
            return Err(format!("dE/dt is {rate:e}, but the power is {power:e}"));
        }
    }
    let freedoms = |analysis: &Analysis, x: &Instant| analysis.derived.system.size - x.rank;
    let counted = [freedoms(first, a), freedoms(other, b)];
    if counted[0] != counted[1] {
        return Err(format!("freedoms {counted:?}"));
    }
    let values = [a, b].map(Instant::quantities);
    let error = apart(values[0].iter().zip(&values[1]));
    if !(error < tolerance) {
        return Err(format!("energies and outputs by {error:e}: {values:#?}"));
    }
    let [a, b] = [a, b].map(Instant::reactions);
    let both = || a.keys().filter(|name| b.contains_key(*name));
    let error = apart(both().map(|name| (&a[name], &b[name])));
    if !(error < tolerance) {
        return Err(format!("reactions by {error:e}: {a:#?} {b:#?}"));
    }
    let [a, b] = [&a, &b].map(|list| list.keys().collect::<Vec<_>>());
    match a == b {
        true => Ok(()),
        false => Err(format!("other reactions are determined: {a:?} {b:?}")),
    }
}

/// Compares the descriptions of a mechanism, each with its name.
fn compare_descriptions(make: impl Fn(&str) -> String) -> Vec<(&'static str, Verdict)> {
    let reference = analysed(&make("Reference")).expect("a description by bodies");
    let reference = Motion::new(&reference);
    let others = ["Joint", "Natural", "Auto"].map(|coordinates| {
        let verdict = match analysed(&make(coordinates)) {
            Ok(analysis) => compare(&reference, &Motion::new(&analysis)),
            // In some coordinates a contradiction is found without numbers.
            Err(_) if reference.contradicts_itself() => Verdict::Skipped("contradictory rows"),
            Err(messages) => Verdict::Different(format!("refused: {messages:?}")),
        };
        (coordinates, verdict)
    });
    others.into()
}

/// Compares so many mechanisms of a kind, and fails with the numbers of those that differ.
fn compare_all(kind: &str, make: fn(usize, &str) -> String) {
    let (mut compared, mut skipped) = (0, 0);
    let mut wrong = Vec::new();
    let (first, count) = (number("FIRST", 0), number("MECHANISMS", COUNT));
    for number in first..first + count {
        for (coordinates, verdict) in compare_descriptions(|coordinates| make(number, coordinates))
        {
            let name = format!("{kind} {number} in {coordinates}");
            match verdict {
                Verdict::Same => compared += 1,
                Verdict::Skipped(why) => {
                    println!("{name}: {why}");
                    skipped += 1;
                }
                Verdict::Different(how) => {
                    wrong.push(format!("{name}: {how}\n{}", make(number, coordinates)));
                }
            }
        }
    }
    println!("{kind}: {compared} compared, {skipped} skipped");
    let list = wrong.join("\n\n");
    assert!(wrong.is_empty(), "{} are wrong:\n{list}", wrong.len());
    // Every eighth plane mechanism has a drive or a gear that its loops do not allow.
    let few = count < 10;
    assert!(few || compared > 4 * skipped, "{skipped} were skipped");
}

/// What the comparison needs; tests of derivatives check the other quantities.
const COMPARED: [&str; 7] = ["M", "T", "A", "b", "γ", "F", "∂p/∂q"];

/// Smaller entries are round-off.
const SMALL: f64 = 1e-6;

/// For each quantity, how many flipped signs in a description by joints there are, and how many are seen.
type Counts = BTreeMap<&'static str, [usize; 2]>;

fn count_flips(make: fn(usize, &str) -> String, number: usize, counts: &mut Counts) {
    let reference = analysed(&make(number, "Reference")).expect("a description by bodies");
    let Ok(mut joints) = analysed(&make(number, "Joint")) else {
        return;
    };
    let reference = Motion::new(&reference);
    if !matches!(compare(&reference, &Motion::new(&joints)), Verdict::Same) {
        return;
    }
    flip_each(&mut joints, |flip, wrong| {
        let wrong = Motion::new(wrong);
        let value = wrong.start.value(flip.expr);
        if COMPARED.contains(&flip.quantity) && !(value.abs() < SMALL) {
            let [all, seen] = counts.entry(flip.quantity).or_default();
            let verdict = compare(&reference, &wrong);
            *all += 1;
            *seen += usize::from(matches!(verdict, Verdict::Different(_)));
        }
    });
}

/// Only entries of M and of ∂p/∂q for parts that do not move may be unseen.
#[test]
fn flipped_signs_are_differences() {
    let mut counts = Counts::new();
    for number in 0..6 {
        count_flips(planar_conditioned, number, &mut counts);
        count_flips(spatial_conditioned, number, &mut counts);
    }
    println!("{counts:?}");
    for quantity in COMPARED {
        let [all, seen] = counts[quantity];
        assert!(
            all > 0 && 10 * seen >= 9 * all,
            "{quantity}: {seen} of {all}"
        );
    }
}

#[test]
fn in_the_plane() {
    compare_all("planar", planar);
}

#[test]
fn in_the_plane_with_conditions() {
    compare_all("planar conditioned", planar_conditioned);
}

#[test]
fn in_space() {
    compare_all("spatial", spatial);
}

#[test]
fn in_space_with_conditions() {
    compare_all("spatial conditioned", spatial_conditioned);
}
