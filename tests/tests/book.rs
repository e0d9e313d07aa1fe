//! Links, files and names in the book and the README exist.

use mbs_tests::pages::{Page, pages, root};
use std::fs;
use std::path::{Component, Path, PathBuf};

/// Without `..` and `.`.
fn tidy(path: &Path) -> PathBuf {
    let mut out = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => assert!(out.pop(), "{} leaves the repository", path.display()),
            Component::CurDir => {}
            other => out.push(other),
        }
    }
    out
}

#[test]
fn links_lead_somewhere() {
    let pages = pages();
    let (mut checked, mut wrong) = (0, Vec::new());
    for page in &pages {
        for link in page.links() {
            if link.starts_with("https://") || link.starts_with("mailto:") {
                continue;
            }
            checked += 1;
            let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
            let folder = page.path.parent().unwrap_or(Path::new(""));
            let target = match file {
                "" => page.path.clone(),
                file => tidy(&folder.join(file)),
            };
            let complain = |what: &str| format!("{}: `{link}` {what}", page.path.display());
            let in_book = |path: &Path| path.starts_with("book/src");
            if !root().join(&target).exists() {
                wrong.push(complain("leads nowhere"));
            } else if in_book(&page.path) && !in_book(&target) {
                wrong.push(complain("leaves the book, whose pages stand alone"));
            } else if !anchor.is_empty() {
                let known = pages.iter().find(|other| other.path == target);
                if !known.is_some_and(|other| other.anchors().iter().any(|name| name == anchor)) {
                    wrong.push(complain("has no such heading"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(checked > 30, "{checked} links found");
}

#[test]
fn every_page_is_in_the_summary() {
    let pages = pages();
    let summary = Path::new("book/src/SUMMARY.md");
    let listed = pages.iter().find(|page| page.path == summary);
    let listed: Vec<PathBuf> = listed
        .expect("a summary")
        .links()
        .iter()
        .map(|link| tidy(&Path::new("book/src").join(link)))
        .collect();
    for page in pages
        .iter()
        .filter(|page| page.path.starts_with("book/src"))
    {
        let known = page.path == summary || listed.contains(&page.path);
        assert!(known, "{} is not in the summary", page.path.display());
    }
}

#[test]
fn files_that_are_named_exist() {
    const FOLDERS: [&str; 4] = [
        "",
        "mbs-runtime/src",
        "mbs-macros/core/src",
        "mbs-macros/core/src/equations",
    ];
    let (mut checked, mut wrong) = (0, Vec::new());
    for page in pages() {
        for span in page.spans() {
            let top = ["mbs-", "tests/", "book/", ".ci/"];
            let path = span.contains('/') && !span.contains([' ', '*', '(']);
            if !path || !(span.ends_with(".rs") || top.iter().any(|top| span.starts_with(top))) {
                continue;
            }
            checked += 1;
            if !FOLDERS
                .iter()
                .any(|folder| root().join(folder).join(span).exists())
            {
                wrong.push(format!("{}: `{span}`", page.path.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(checked > 30, "{checked} names found");
}

/// The table of symbols names types and their members; so do the other pages of the theory.
#[test]
fn names_of_the_theory_are_in_the_code() {
    let sources = sources(&root().join("mbs-runtime/src"));
    let (mut checked, mut wrong) = (0, Vec::new());
    let theory = |page: &Page| page.path.starts_with("book/src/theory");
    for page in pages().into_iter().filter(theory) {
        for span in page.spans() {
            let Some((owner, member)) = span.split_once("::") else {
                continue;
            };
            checked += 1;
            let defines = |source: &&String| {
                ["struct", "trait", "enum"].iter().any(|kind| {
                    let name = format!("{kind} {owner}");
                    source.match_indices(&name).any(|(at, _)| {
                        !source[at + name.len()..]
                            .starts_with(|c: char| c.is_alphanumeric() || c == '_')
                    })
                })
            };
            if !sources
                .iter()
                .filter(defines)
                .any(|source| has_word(source, member))
            {
                wrong.push(format!("{}: `{span}`", page.path.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(checked > 30, "{checked} names found");
}

fn sources(folder: &Path) -> Vec<String> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("sources") {
        let path = entry.expect("readable").path();
        if path.is_dir() {
            found.extend(sources(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(fs::read_to_string(path).expect("UTF-8"));
        }
    }
    found
}

fn has_word(text: &str, word: &str) -> bool {
    text.split(|c: char| !(c.is_alphanumeric() || c == '_'))
        .any(|other| other == word)
}

/// A page whose blocks another test compiles: `tests/tests/new_joint.rs`.
const FOLLOWED: &str = "book/src/contributing/joint.md";

/// Pages with Rust are documentation tests; other code on pages is included from files that are compiled.
#[test]
fn every_page_with_code_is_compiled() {
    let library = fs::read_to_string(root().join("tests/src/lib.rs")).expect("UTF-8");
    for page in pages() {
        let path = page.path.display().to_string();
        let compiled = library.contains(&format!("include_str!(\"../../{path}\")"));
        assert!(
            compiled || page.code("rust").is_empty(),
            "{path} has code that nothing compiles; name it in tests/src/lib.rs"
        );
        let written = fs::read_to_string(root().join(&page.path)).expect("UTF-8");
        let mut lines = written.lines();
        while let Some(line) = lines.next() {
            if line.starts_with("```rust,") && path != FOLLOWED {
                let next = lines.next().unwrap_or_default();
                assert!(
                    next.starts_with("{{#include "),
                    "{path}: `{next}` is not compiled; include it, or drop `{line}`"
                );
            }
        }
    }
}
