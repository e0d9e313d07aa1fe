//! What rustc compiles for a mechanism.

use super::data::{Data, Line};
use super::markdown::{paragraph, significant, table as markdown_table, thousands};

const FILE: &str = "readme/compile.csv";
const ORIGINS: &str = "readme/compile_origins.csv";
const METHODS: &str = "readme/compile_methods.csv";
/// What every crate takes is a small part of the time from so many statements on.
const LARGE: f64 = 5000.0;

/// Sizes and times as mechanisms grow.
pub fn table(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let heading = [
        "mechanism",
        "size",
        "velocities",
        "rows",
        "operations",
        "written out",
        "statements",
        "release, s",
        "dev, s",
        "all methods, s",
    ];
    let counts = ["velocities", "rows", "operations", "written", "statements"];
    let rows: Result<Vec<Vec<String>>, String> = results
        .lines()
        .map(|line| {
            let mut row = vec![
                line.text("mechanism")?.to_owned(),
                line.text("size")?.to_owned(),
            ];
            for column in counts {
                row.push(thousands(line.number(column)?));
            }
            for column in ["release_s", "dev_s", "any_s"] {
                row.push(line.text(column)?.to_owned());
            }
            Ok(row)
        })
        .collect();
    Ok(format!(
        "{}\n\nFrom {}.",
        markdown_table(&heading, &rows?),
        results.source()
    ))
}

/// Processor time of a statement in release, of the mechanisms that are large.
pub fn of_statement(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for line in results.lines() {
        let statements = line.number("statements")?;
        if statements > LARGE {
            let time = 1e3 * line.number("release_s")? / statements;
            (least, most) = (least.min(time), most.max(time));
        }
    }
    Ok(paragraph(&format!(
        "In the table above ({}) the mechanisms of more than {} statements took {} to {} ms of processor time a statement in release.",
        results.source(),
        thousands(LARGE),
        significant(least, 2),
        significant(most, 2),
    )))
}

/// Lines of LLVM IR by origin.
pub fn origins(data: &Data) -> Result<String, String> {
    by_mechanism(data, ORIGINS, "origin", |line| {
        Ok(thousands(line.number("lines")?))
    })
}

/// Seconds of a program with each method.
pub fn methods(data: &Data) -> Result<String, String> {
    by_mechanism(data, METHODS, "methods", |line| {
        Ok(line.text("release_s")?.to_owned())
    })
}

/// A row for each value of `key`, with a column for each mechanism.
fn by_mechanism(
    data: &Data,
    file: &str,
    key: &str,
    entry: impl Fn(Line) -> Result<String, String>,
) -> Result<String, String> {
    let results = data.table(file)?;
    let mut heading = vec![key.to_owned()];
    let mut rows: Vec<Vec<String>> = Vec::new();
    for line in results.lines() {
        let mechanism = format!("{} {}", line.text("mechanism")?, line.text("size")?);
        if !heading.contains(&mechanism) {
            heading.push(mechanism);
        }
        let (name, entry) = (line.text(key)?.to_owned(), entry(line)?);
        match rows.iter_mut().find(|row| row[0] == name) {
            Some(row) => row.push(entry),
            None => rows.push(vec![name, entry]),
        }
    }
    let heading: Vec<&str> = heading.iter().map(String::as_str).collect();
    Ok(format!(
        "{}\n\nFrom {}.",
        markdown_table(&heading, &rows),
        results.source()
    ))
}
