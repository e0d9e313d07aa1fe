//! Wrong programs and their messages. Each program has one mistake and one message, at the wrong tokens. The compiler
//! is a library, so that rustc does not have to run for each of them: this test writes the messages in the form of
//! rustc. `TRYBUILD=overwrite cargo test -p mbs-tests ui::` writes the `.stderr` files. A few programs of each
//! sort, in `mbs-runtime/tests/ui`, test that rustc shows messages in this form.

use crate::common::expansion::{errors, invocations};
use mbs_tests::pages::pages;
use proc_macro2::{LineColumn, TokenStream};
use std::fmt::Write;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::{env, fs};

/// The folders of the wrong programs in this package.
const OWN: &str = "tests/ui";
/// The folder of those that rustc compiles.
const OF_RUSTC: &str = "../mbs-runtime/tests/ui";

#[test]
fn wrong_programs() {
    let overwrite = env::var_os("TRYBUILD").is_some_and(|value| value == "overwrite");
    let checked = all(OWN, |program, expected| {
        let shown = shown(program)?.ok_or(
            "nothing is wrong with it, or it takes rustc to show it: then it belongs to mbs-runtime/tests/ui",
        )?;
        if overwrite {
            return fs::write(expected, shown).map_err(|error| error.to_string());
        }
        same(&shown, expected)
    });
    assert!(checked > 100, "{checked} wrong programs only");
}

/// The output of rustc equals the text that is made here, if it can be made here.
#[test]
fn form_is_that_of_rustc() {
    let mut compared = 0;
    all(OF_RUSTC, |program, expected| {
        shown(program)?.map_or(Ok(()), |shown| {
            compared += 1;
            same(&shown, expected)
        })
    });
    assert!(compared > 10, "{compared} compared only");
}

/// The message in the first chapter of the book is the real message for that mistake.
#[test]
fn a_slip_in_the_first_chapter_is_shown_as_there() {
    let pages = pages();
    let mut chapters = pages.iter();
    let chapter = chapters.find(|page| page.path.ends_with("book/src/first-mechanism.md"));
    let chapter = chapter.expect("the first chapter");
    let block = |part: &str| {
        let mut blocks = chapter.text.split("```").skip(1).step_by(2);
        let found = blocks.find(|block| block.contains(part));
        let (_, code) = found.and_then(|block| block.split_once('\n')).expect(part);
        code.to_owned()
    };
    let wrong =
        block("crank_pin: Revolute(crank.b").replace("Revolute(crank.b", "Revolute(cranck.b");
    let shown = shown_of(&wrong, "src/main.rs").expect("a program");
    let message = block("error: ");
    assert_eq!(
        shown.as_deref().map(str::trim_end),
        Some(message.trim_end())
    );
}

/// Calls `check` with each program of a folder and the file of its message; fails with a list of all errors.
fn all(folder: &str, mut check: impl FnMut(&Path, &Path) -> Result<(), String>) -> usize {
    let programs = files(folder, "rs");
    let mut failures = String::new();
    for program in &programs {
        if let Err(why) = check(program, &program.with_extension("stderr")) {
            let _ = writeln!(failures, "{}: {why}", program.display());
        }
    }
    // A message without a program is an error.
    for message in files(folder, "stderr") {
        if !message.with_extension("rs").exists() {
            let _ = writeln!(failures, "{}: its program is missing", message.display());
        }
    }
    assert!(failures.is_empty(), "\n{failures}");
    programs.len()
}

/// Compares with a file, which may be missing.
fn same(shown: &str, file: &Path) -> Result<(), String> {
    let expected = fs::read_to_string(file).unwrap_or_default();
    if shown == expected {
        Ok(())
    } else {
        Err(format!("expected:\n{expected}\nshown:\n{shown}"))
    }
}

/// The files in a folder of this package with an extension, sorted.
fn files(folder: &str, extension: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let entries = fs::read_dir(folder).expect("the folder is there");
    let mut files: Vec<PathBuf> = entries
        .map(|entry| entry.expect("readable").path())
        .filter(|file| file.extension().is_some_and(|found| found == extension))
        .collect();
    files.sort();
    files
}

/// The message for a program; `None` if there is none, or if only rustc can show it.
///
/// # Errors
/// It has no `mechanism!`, or the generated code is not Rust.
fn shown(program: &Path) -> Result<Option<String>, String> {
    let text = fs::read_to_string(program).map_err(|error| error.to_string())?;
    let name = program.file_name().unwrap_or_default().to_string_lossy();
    shown_of(&text, &format!("tests/ui/{name}"))
}

/// The same for a text, as if it were in `path`.
fn shown_of(text: &str, path: &str) -> Result<Option<String>, String> {
    let tokens: TokenStream = text.parse().map_err(|_| "these are no tokens of Rust")?;
    let declarations = invocations(tokens, "mechanism");
    if declarations.is_empty() {
        return Err("there is no `mechanism!` in it".into());
    }
    let mut reports = Vec::new();
    for declaration in declarations {
        for (message, place) in errors(mbs_macros_core::compile(declaration.tokens))? {
            reports.push(report(&message, path, text, place));
        }
    }
    let reports: Option<Vec<String>> = reports.into_iter().collect();
    Ok(reports
        .filter(|reports| !reports.is_empty())
        .map(|reports| reports.join("\n")))
}

/// An error in the form of rustc: the message, the position, the line, and carets under the wrong tokens. `None` if the
/// form is different: an error at no token or on several lines, or a message of several lines.
fn report(message: &str, path: &str, text: &str, place: Range<LineColumn>) -> Option<String> {
    let Range { start, end } = place;
    // A token has an extent; the position of the whole invocation has none outside rustc.
    if start >= end || start.line != end.line || message.contains('\n') {
        return None;
    }
    let (line, column) = (start.line, start.column);
    let source = text.lines().nth(line - 1)?;
    let margin = " ".repeat(line.to_string().len());
    let marks = " ".repeat(column) + &"^".repeat(end.column - column);
    Some(format!(
        "error: {message}\n\
         {margin}--> {path}:{line}:{}\n\
         {margin} |\n\
         {line} | {source}\n\
         {margin} | {marks}\n",
        column + 1,
    ))
}
