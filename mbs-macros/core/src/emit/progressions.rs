//! Statements that differ in their numbers alone, as loops, where the numbers are arithmetic progressions.
//!
//! `p[0] = k[1] * x[0]; p[1] = k[6] * x[1]; …` is `for turn in 0..N { p[turn] = k[1 + 5 * turn] * x[turn]; }`. A loop of
//! the members of a family needs no table then, and rustc compiles its body once.

use crate::symbolic::{mixed, mixed_text};
use std::fmt::Write;
use std::ops::Range;

/// Fewer repetitions are written out.
const FEWEST: usize = 100;
/// The most statements of a turn that are looked for.
const LONGEST: usize = 16;

/// Loops take most of the statements if there is one line for this many of them.
const MOSTLY: usize = 4;

/// A statement, and the numbers in it that a loop can count.
struct Statement {
    text: String,
    /// Hash of the text between the numbers.
    form: u64,
    numbers: Vec<Number>,
}

#[derive(Clone)]
struct Number {
    range: Range<usize>,
    value: i64,
    /// Whether it is written as `2.0`.
    is_real: bool,
}

/// A group of statements that repeats.
struct Repetition {
    period: usize,
    times: usize,
}

/// The statements one after the other, with loops for what repeats.
pub(super) fn folded(mut statements: Vec<String>) -> String {
    let mut out = String::new();
    // A zero need not be written everywhere: then its statement is empty.
    statements.retain(|statement| !statement.trim().is_empty());
    if statements.len() < FEWEST {
        for statement in statements {
            out.push_str(&statement);
            out.push('\n');
        }
        return out;
    }
    let statements: Vec<Statement> = statements.into_iter().map(Statement::of).collect();
    let mut first = 0;
    while first < statements.len() {
        let rest = &statements[first..];
        let Repetition { period, times } = repetition(rest);
        if times == 1 {
            out.push_str(&rest[0].text);
            out.push('\n');
        } else {
            let _ = writeln!(out, "for turn in 0..{times}_usize {{");
            for (statement, next) in rest[..period].iter().zip(&rest[period..]) {
                statement.write(&mut out, next);
            }
            out.push_str("}\n");
        }
        first += period * times;
    }
    out
}

/// The same if loops take most of the statements.
pub(super) fn looped(statements: Vec<String>) -> Option<String> {
    let count = statements.len();
    if count < FEWEST {
        return None;
    }
    let text = folded(statements);
    (MOSTLY * text.lines().count() < count).then_some(text)
}

/// The repetition at the beginning that takes the most statements.
fn repetition(statements: &[Statement]) -> Repetition {
    let mut best = Repetition {
        period: 1,
        times: 1,
    };
    for period in 1..=LONGEST.min(statements.len() / FEWEST) {
        let times = times(statements, period);
        if times >= FEWEST && period * times > best.period * best.times {
            best = Repetition { period, times };
        }
    }
    best
}

/// How often the first statements come, with numbers that grow by the same steps.
fn times(statements: &[Statement], period: usize) -> usize {
    let continues = |at: usize| {
        let [before, now] = [&statements[at - period], &statements[at]];
        if before.form != now.form || before.numbers.len() != now.numbers.len() {
            return false;
        }
        // The first turn gives the steps.
        let [a, b] = [&statements[at % period], &statements[at % period + period]];
        let (a, b): (&[Number], &[Number]) = (&a.numbers, &b.numbers);
        let (before, now): (&[Number], &[Number]) = (&before.numbers, &now.numbers);
        let mut k = 0;
        while k < now.len() && now[k].value - before[k].value == b[k].value - a[k].value {
            k += 1;
        }
        k == now.len()
    };
    let mut at = period;
    while at < statements.len() && continues(at) {
        at += 1;
    }
    at / period
}

impl Statement {
    fn of(text: String) -> Statement {
        let numbers = numbers(&text);
        let (mut form, mut from) = (0, 0);
        for number in &numbers {
            form = mixed(
                mixed_text(form, &text[from..number.range.start]),
                u64::from(number.is_real),
            );
            from = number.range.end;
        }
        let form = mixed_text(form, &text[from..]);
        Statement {
            text,
            form,
            numbers,
        }
    }

    /// Writes the statement with its numbers as functions of the turn; `next` is the same of the next turn.
    fn write(&self, out: &mut String, next: &Statement) {
        let mut from = 0;
        for (number, next) in self.numbers.iter().zip(&next.numbers) {
            let Number { range, value, .. } = number;
            out.push_str(&self.text[from..range.start]);
            from = range.end;
            if next.value == *value {
                out.push_str(&self.text[range.clone()]);
                continue;
            }
            let sum = sum(*value, next.value - value);
            match number.is_real {
                true => {
                    let _ = write!(out, "(({sum}) as f64)");
                }
                false => out.push_str(&sum),
            }
        }
        out.push_str(&self.text[from..]);
        out.push('\n');
    }
}

/// A number that is `first` in the first turn and `second` in the next one, as a function of the turn.
pub(super) fn counted(first: usize, second: usize) -> String {
    sum(first as i64, second as i64 - first as i64)
}

/// `value + step * turn`.
fn sum(value: i64, step: i64) -> String {
    match (value, step) {
        (_, 0) => value.to_string(),
        (0, 1) => "turn".to_owned(),
        (_, 1) => format!("{value} + turn"),
        (0, _) if step > 0 => format!("{step} * turn"),
        _ if step > 0 => format!("{value} + {step} * turn"),
        _ => format!("{value} - {} * turn", -step),
    }
}

/// The integers in a text, and the reals that are integers; those in names and in other numbers are no numbers.
fn numbers(text: &str) -> Vec<Number> {
    let bytes = text.as_bytes();
    let mut found = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        if !WORD[bytes[at] as usize] {
            at += 1;
            continue;
        }
        let start = at;
        let is_number = bytes[at].is_ascii_digit();
        // `1e-5` is one word.
        while at < bytes.len()
            && (WORD[bytes[at] as usize] || is_number && continues(&bytes[start..at], bytes[at]))
        {
            at += 1;
        }
        let word = &text[start..at];
        let is_field = start > 0 && bytes[start - 1] == b'.';
        let digits = word.strip_suffix(".0");
        let is_real = digits.is_some();
        let digits = digits.unwrap_or(word);
        if let (true, false, Some(value)) = (is_number, is_field, short(digits.as_bytes())) {
            found.push(Number {
                range: start..at,
                value,
                is_real,
            });
        }
    }
    found
}

/// The number of a few digits.
fn short(digits: &[u8]) -> Option<i64> {
    if digits.len() > 9 {
        return None;
    }
    let (mut value, mut at) = (0, 0);
    while at < digits.len() {
        if !digits[at].is_ascii_digit() {
            return None;
        }
        value = 10 * value + i64::from(digits[at] - b'0');
        at += 1;
    }
    Some(value)
}

/// Whether a byte belongs to a name or number: texts of many statements are read, and a table takes no call.
const WORD: [bool; 256] = {
    let mut table = [false; 256];
    let mut byte = 0;
    while byte < 256 {
        table[byte] = (byte as u8).is_ascii_alphanumeric() || byte as u8 == b'_';
        byte += 1;
    }
    table
};

/// Whether a byte continues a number: the point of `2.5`, and the sign of `1e-5`.
fn continues(number: &[u8], byte: u8) -> bool {
    let is_exponent = number.last() == Some(&b'e');
    byte == b'.' && !number.contains(&b'.') || is_exponent && (byte == b'-' || byte == b'+')
}
