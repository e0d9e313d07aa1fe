//! `deny: Redundant()` and `allow: Unused()`: what is an error, and what is not, by the choice of the declaration.

use super::{Declaration, Entry};
use crate::diagnostics::{Errors, Place};

/// An entry that makes something an error, or no error.
struct Level {
    word: &'static str,
    takes: &'static str,
    meaning: &'static str,
    set: fn(&mut Declaration),
}

const LEVELS: [Level; 2] = [
    Level {
        word: "deny",
        takes: "Redundant",
        meaning: "rows that follow from others become errors",
        set: |declaration| declaration.deny_redundant = true,
    },
    Level {
        word: "allow",
        takes: "Unused",
        meaning: "entries that nothing uses are no errors any more",
        set: |declaration| declaration.allow_unused = true,
    },
];

fn level(word: &str) -> Option<&'static Level> {
    LEVELS.iter().find(|level| level.word == word)
}

/// Whether entries of this name choose what is an error.
pub(super) fn is_level(word: &str) -> bool {
    level(word).is_some()
}

/// What such an entry takes, as an example.
pub(super) fn example(word: &str) -> Option<String> {
    level(word).map(|level| format!("{}()", level.takes))
}

/// Reads such an entry; false if it is none.
pub(super) fn place_level(
    entry: &Entry,
    declaration: &mut Declaration,
    errors: &mut Errors,
) -> bool {
    let Some(level) = level(entry.name.as_str()) else {
        return false;
    };
    let Level {
        word,
        takes,
        meaning,
        ..
    } = level;
    let given = entry.positional.iter();
    let mut given = given.chain(entry.named.iter().map(|argument| &argument.value));
    if entry.kind != takes {
        errors.at(
            entry.kind.span(),
            format!("`{word}:` takes `{takes}()`: {meaning}; an entry needs another name"),
        );
    } else if let Some(argument) = given.next() {
        errors.at(
            Place::of(argument),
            format!("`{takes}()` takes no arguments"),
        );
    }
    (level.set)(declaration);
    true
}
