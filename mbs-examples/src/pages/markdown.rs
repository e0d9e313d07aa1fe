//! Tables, paragraphs and numbers of Markdown.

use std::fmt::Write as _;

/// Longest line of a paragraph.
const WIDTH: usize = 120;

/// A table.
pub fn table<Cell: AsRef<str>>(heading: &[&str], rows: &[Vec<Cell>]) -> String {
    let mut out = format!(
        "| {} |\n|{}",
        heading.join(" | "),
        "---|".repeat(heading.len())
    );
    for row in rows {
        let cells: Vec<&str> = row.iter().map(AsRef::as_ref).collect();
        let _ = write!(out, "\n| {} |", cells.join(" | "));
    }
    out
}

/// Words in lines.
pub fn paragraph(text: &str) -> String {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let line = lines.len() - 1;
        let length = lines[line].chars().count() + 1 + word.chars().count();
        if lines[line].is_empty() {
            lines[line].push_str(word);
        } else if length > WIDTH {
            lines.push(word.to_owned());
        } else {
            lines[line] = format!("{} {word}", lines[line]);
        }
    }
    lines.join("\n")
}

/// An error: two digits and a power of ten.
pub fn error(x: f64) -> String {
    match x {
        0.0 => "0".to_owned(),
        x if x.is_finite() => format!("{x:.1e}"),
        _ => "–".to_owned(),
    }
}

/// An error: one digit.
pub fn about(x: f64) -> String {
    match x {
        0.0 => "0".to_owned(),
        x => format!("{x:.0e}"),
    }
}

/// A number of so many significant digits, without a power of ten.
pub fn significant(x: f64, digits: i32) -> String {
    if x == 0.0 || !x.is_finite() {
        return x.to_string();
    }
    let after = digits - 1 - x.abs().log10().floor() as i32;
    let unit = 10_f64.powi(after);
    format!("{:.*}", after.max(0) as usize, (x * unit).round() / unit)
}

/// `12,594`.
pub fn thousands(x: f64) -> String {
    let digits = format!("{x:.0}");
    let mut out = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) && digits.len() > 4 {
            out.push(',');
        }
        out.push(digit);
    }
    out
}
