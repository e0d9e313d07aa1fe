//! The toolkit against equations written for one mechanism, and an accuracy against Baumgarte's terms.

use super::data::{Data, Line, Table};
use super::markdown::{significant, table as markdown, thousands};

/// Below `book/src/results`.
pub const FILE: &str = "readme/symbolic.csv";
/// The same for the comparison with Baumgarte's terms.
pub const STABILISED_FILE: &str = "readme/stabilised.csv";
/// Columns of both files; the first four identify a row. The other cells are empty if no run stays within the bound.
pub const COLUMNS: [&str; 11] = [
    "scene",
    "bound_J",
    "rule",
    "family",
    "setting",
    "value",
    "tried",
    "steps",
    "calls",
    "instructions",
    "time_ms",
];
/// How many of them identify a row.
pub const KEYS: usize = 4;
/// Who is compared with equations in bar angles.
pub const FAMILIES: [&str; 4] = ["accuracy", "ours", "symbolic 8", "symbolic 4"];
/// Who is compared with Baumgarte's terms.
pub const STABILISED: [&str; 3] = ["accuracy", "Baumgarte 4", "Baumgarte 8"];

/// Scenes and bounds of a file, in its order.
fn cases(results: &Table) -> Result<Vec<[String; 2]>, String> {
    let mut cases: Vec<[String; 2]> = Vec::new();
    for line in results.lines() {
        let case = [line.text("scene")?, line.text("bound_J")?].map(str::to_owned);
        if !cases.contains(&case) {
            cases.push(case);
        }
    }
    Ok(cases)
}

fn line<'t>(
    results: &'t Table,
    [scene, bound]: &[String; 2],
    rule: &str,
    family: &str,
) -> Result<Option<Line<'t>>, String> {
    let line = results.find(&[
        ("scene", scene),
        ("bound_J", bound),
        ("rule", rule),
        ("family", family),
    ])?;
    Ok((!line.text("time_ms")?.is_empty()).then_some(line))
}

/// A time, ms; infinite if no run stays within the bound.
fn time(results: &Table, case: &[String; 2], rule: &str, family: &str) -> Result<f64, String> {
    line(results, case, rule, family)?.map_or(Ok(f64::INFINITY), |line| line.number("time_ms"))
}

fn cell(number: f64, digits: i32) -> String {
    match number.is_finite() {
        true => significant(number, digits),
        false => "–".to_owned(),
    }
}

/// Times of all families, with the faster of those after the first `of_ours` as a multiple of each of these.
fn times(
    results: &Table,
    rule: &str,
    families: &[&str],
    of_ours: usize,
    heading: &[&str],
) -> Result<String, String> {
    let mut rows = Vec::new();
    for case in cases(results)? {
        let mut times = Vec::new();
        for family in families {
            times.push(time(results, &case, rule, family)?);
        }
        let rivals = times[of_ours..].iter().copied();
        let rival = rivals.fold(f64::INFINITY, f64::min);
        let mut row = vec![format!("`{}`", case[0]), case[1].clone()];
        row.extend(times.iter().map(|time| cell(*time, 3)));
        row.extend(times[..of_ours].iter().map(|time| cell(rival / time, 2)));
        rows.push(row);
    }
    let source = results.source();
    Ok(format!(
        "{}\n\nMeasured at {source}.",
        markdown(heading, &rows)
    ))
}

fn symbolic(data: &Data, rule: &str) -> Result<String, String> {
    const HEADING: [&str; 8] = [
        "scene",
        "energy error, J",
        "`accuracy`, ms",
        "best of our methods, ms",
        "bar angles, order 8, ms",
        "bar angles, order 4, ms",
        "rival / `accuracy`",
        "rival / best of ours",
    ];
    times(&data.table(FILE)?, rule, &FAMILIES, 2, &HEADING)
}

fn against_baumgarte(data: &Data, rule: &str) -> Result<String, String> {
    const HEADING: [&str; 6] = [
        "scene",
        "energy error, J",
        "`accuracy`, ms",
        "Baumgarte, order 4, ms",
        "Baumgarte, order 8, ms",
        "rival / `accuracy`",
    ];
    times(
        &data.table(STABILISED_FILE)?,
        rule,
        &STABILISED,
        1,
        &HEADING,
    )
}

/// Times against equations in bar angles, where a single run may be lucky.
///
/// # Errors
/// Results that are missing.
pub fn any(data: &Data) -> Result<String, String> {
    symbolic(data, "any")
}

/// The same where the finer settings stay within the bound, too.
///
/// # Errors
/// Results that are missing.
pub fn steady(data: &Data) -> Result<String, String> {
    symbolic(data, "steady")
}

/// Times against Baumgarte's terms, where a single run may be lucky.
///
/// # Errors
/// Results that are missing.
pub fn stabilised_any(data: &Data) -> Result<String, String> {
    against_baumgarte(data, "any")
}

/// The same where the finer settings stay within the bound, too.
///
/// # Errors
/// Results that are missing.
pub fn stabilised_steady(data: &Data) -> Result<String, String> {
    against_baumgarte(data, "steady")
}

/// The settings behind the steady times against equations in bar angles, and the instructions of their runs.
///
/// # Errors
/// Results that are missing.
pub fn settings(data: &Data) -> Result<String, String> {
    settings_of(data, FILE, &FAMILIES)
}

/// The same against Baumgarte's terms.
///
/// # Errors
/// Results that are missing.
pub fn stabilised_settings(data: &Data) -> Result<String, String> {
    settings_of(data, STABILISED_FILE, &STABILISED)
}

/// A family as the tables of times head its column.
fn named(family: &str) -> &str {
    match family {
        "ours" => "best of our methods",
        "symbolic 8" => "bar angles, order 8",
        "symbolic 4" => "bar angles, order 4",
        other => other,
    }
}

fn settings_of(data: &Data, file: &str, families: &[&str]) -> Result<String, String> {
    const HEADING: [&str; 7] = [
        "scene",
        "energy error, J",
        "who",
        "setting",
        "steps",
        "calls",
        "thousands of instructions",
    ];
    let results = data.table(file)?;
    let mut rows = Vec::new();
    for case in cases(&results)? {
        for family in families {
            let Some(line) = line(&results, &case, "steady", family)? else {
                continue;
            };
            let instructions = match line.text("instructions")? {
                "" => String::new(),
                _ => thousands(line.number("instructions")? / 1e3),
            };
            rows.push(vec![
                format!("`{}`", case[0]),
                case[1].clone(),
                named(family).to_owned(),
                format!("{}; {}", line.text("setting")?, line.text("value")?),
                line.text("steps")?.to_owned(),
                line.text("calls")?.to_owned(),
                instructions,
            ]);
        }
    }
    Ok(markdown(&HEADING, &rows))
}
