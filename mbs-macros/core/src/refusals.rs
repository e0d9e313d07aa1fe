//! Errors that are found numerically: loops that cannot close, redundant rows with
//! `deny: Redundant()`.

use crate::diagnostics::Errors;
use crate::equations::{Row, UnknownReading};
use crate::mobility::{self, Mobility, Open};
use crate::syntax::{Declaration, Entry};
use proc_macro2::Span;

/// Where the entry of this name is; its part or the mechanism, if it has none.
fn place_of(declaration: &Declaration, name: &str) -> Span {
    let entry = declaration.entries.iter().find(|entry| entry.name == name);
    entry.map_or_else(|| declaration.name.span(), Entry::span)
}

/// The rows contradict each other.
pub(crate) fn refuse_open(declaration: &Declaration, open: &Open, errors: &mut Errors) {
    let gaps = open.gaps.join(", ");
    errors.about(
        &open.entry,
        place_of(declaration, &open.entry),
        format!("this loop cannot close: with the defaults of all parameters, where everything comes closest to fitting, these are still off: {gaps}; check lengths, places and axes"),
    );
}

/// The positions that are held contradict the rows, or each other.
pub(crate) fn refuse_held(declaration: &Declaration, open: &Open, errors: &mut Errors) {
    let gaps = open.gaps.join(", ");
    errors.about(
        &open.entry,
        place_of(declaration, &open.entry),
        format!("the initial values in `Exactly(…)` do not fit the joints, or each other: with the defaults of all parameters, where everything comes closest to fitting, these are still off: {gaps}; hold as many as there are degrees of freedom, and leave the others as guesses"),
    );
}

/// A coordinate of this name moves no mass.
pub(crate) fn refuse_massless(declaration: &Declaration, coordinate: &str, errors: &mut Errors) {
    let entry = coordinate
        .rsplit_once('.')
        .map_or(coordinate, |(entry, _)| entry);
    errors.about(
        entry,
        place_of(declaration, entry),
        format!("in joint coordinates nothing with mass follows `{coordinate}`: give the part `mass =`, or take other coordinates for it by `coordinates = Natural`"),
    );
}

/// An output reads a component of a reaction that its joint does not have.
pub(crate) fn refuse_reading(unknown: &UnknownReading, errors: &mut Errors) {
    let (reading, known) = (&unknown.reading, &unknown.known);
    let (joint, component) = (&reading.joint, &reading.component);
    let message = match known.as_slice() {
        [] => format!("`{joint}` has no reaction: other joints of the same parts hold all of it"),
        known => format!(
            "the reaction of `{joint}` has no `{component}` (it has: {})",
            known.join(", ")
        ),
    };
    errors.about(joint, reading.place, message);
}

/// `deny: Redundant()`.
pub(crate) fn refuse_redundant(
    declaration: &Declaration,
    mobility: &Mobility,
    rows: &[Row],
    errors: &mut Errors,
) {
    let redundancies = mobility::redundancies(mobility, rows);
    for (entry, sentence) in &redundancies {
        errors.about(
            entry,
            place_of(declaration, entry),
            format!("{sentence}, which `deny: Redundant()` refuses; let this joint hold less"),
        );
    }
}
