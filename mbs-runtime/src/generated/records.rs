//! Long lists of the model, written as text: rustc reads a text as one token, and a list of a thousand parts as many
//! thousand.
//!
//! A record is a line, and its fields are separated by tabs. What is missing in a text is empty.

use crate::model::{Coordinate, Part, Reaction, Row, RowKind, Segment};

/// What is left of a text.
struct Reader {
    rest: &'static str,
}

impl Reader {
    /// The text before the next byte `end`, which is skipped.
    const fn until(&mut self, end: u8) -> &'static str {
        let bytes = self.rest.as_bytes();
        // rustc counts calls, and remarks on evaluations of many: none in the loop.
        let (mut at, length) = (0, bytes.len());
        while at < length && bytes[at] != end {
            at += 1;
        }
        let (text, rest) = self.rest.split_at(at);
        self.rest = match rest.is_empty() {
            true => rest,
            false => rest.split_at(1).1,
        };
        text
    }

    const fn field(&mut self) -> &'static str {
        self.until(b'\t')
    }

    const fn last_field(&mut self) -> &'static str {
        self.until(b'\n')
    }
}

/// A decimal number; 0 if there is none.
const fn number(text: &str) -> usize {
    let digits = text.as_bytes();
    let (mut number, mut at) = (0, 0);
    while at < digits.len() {
        number = 10 * number + (digits[at] - b'0') as usize;
        at += 1;
    }
    number
}

/// Coordinates: name, unit.
pub const fn coordinates<const COUNT: usize>(text: &'static str) -> [Coordinate; COUNT] {
    let mut list = [Coordinate { name: "", unit: "" }; COUNT];
    let (mut reader, mut at) = (Reader { rest: text }, 0);
    while at < COUNT {
        list[at].name = reader.field();
        list[at].unit = reader.last_field();
        at += 1;
    }
    list
}

/// Rows: name, entry, unit, kind.
pub const fn rows<const COUNT: usize>(text: &'static str) -> [Row; COUNT] {
    let empty = Row {
        name: "",
        entry: "",
        kind: RowKind::Holonomic,
        unit: "",
    };
    let mut list = [empty; COUNT];
    let (mut reader, mut at) = (Reader { rest: text }, 0);
    while at < COUNT {
        list[at].name = reader.field();
        list[at].entry = reader.field();
        list[at].unit = reader.field();
        list[at].kind = match reader.last_field().as_bytes() {
            b"Rheonomic" => RowKind::Rheonomic,
            b"Nonholonomic" => RowKind::Nonholonomic,
            _ => RowKind::Holonomic,
        };
        at += 1;
    }
    list
}

/// Parts: name, kind, how it was modelled.
pub const fn parts<const COUNT: usize>(text: &'static str) -> [Part; COUNT] {
    let empty = Part {
        name: "",
        kind: "",
        modelled_as: "",
    };
    let mut list = [empty; COUNT];
    let (mut reader, mut at) = (Reader { rest: text }, 0);
    while at < COUNT {
        list[at].name = reader.field();
        list[at].kind = reader.field();
        list[at].modelled_as = reader.last_field();
        at += 1;
    }
    list
}

/// Segments: part, from, to.
pub const fn segments<const COUNT: usize>(text: &'static str) -> [Segment; COUNT] {
    let empty = Segment {
        part: "",
        from: 0,
        to: 0,
    };
    let mut list = [empty; COUNT];
    let (mut reader, mut at) = (Reader { rest: text }, 0);
    while at < COUNT {
        list[at].part = reader.field();
        list[at].from = number(reader.field());
        list[at].to = number(reader.last_field());
        at += 1;
    }
    list
}

/// Reactions: joint, component, unit, and the point, which is empty where there is none.
pub const fn reactions<const COUNT: usize>(text: &'static str) -> [Reaction; COUNT] {
    let empty = Reaction {
        joint: "",
        component: "",
        unit: "",
        at: None,
    };
    let mut list = [empty; COUNT];
    let (mut reader, mut at) = (Reader { rest: text }, 0);
    while at < COUNT {
        list[at].joint = reader.field();
        list[at].component = reader.field();
        list[at].unit = reader.field();
        let point = reader.last_field();
        if !point.is_empty() {
            list[at].at = Some(number(point));
        }
        at += 1;
    }
    list
}

/// Names or sentences, one a line.
pub const fn lines<const COUNT: usize>(text: &'static str) -> [&'static str; COUNT] {
    let mut list = [""; COUNT];
    let (mut reader, mut at) = (Reader { rest: text }, 0);
    while at < COUNT {
        list[at] = reader.last_field();
        at += 1;
    }
    list
}
