//! The pages of the book and the README as text, for tests that read them.

use std::fs;
use std::path::{Path, PathBuf};

/// The top of the repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// A page of Markdown.
#[derive(Debug)]
pub struct Page {
    /// Relative to the top of the repository.
    pub path: PathBuf,
    /// With what it includes.
    pub text: String,
}

/// The README and all pages of the book.
pub fn pages() -> Vec<Page> {
    let mut files = vec![PathBuf::from("README.md")];
    let mut folders = vec![PathBuf::from("book/src")];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(root().join(&folder)).expect("the book is there") {
            let path = folder.join(entry.expect("readable").file_name());
            if root().join(&path).is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "md") {
                files.push(path);
            }
        }
    }
    files.sort();
    let page = |path: PathBuf| Page {
        text: expanded(&path),
        path,
    };
    files.into_iter().map(page).collect()
}

/// The text of a file with `{{#include file}}` replaced; a range of lines counts as the whole file.
fn expanded(path: &Path) -> String {
    const MARK: &str = "{{#include ";
    let text = fs::read_to_string(root().join(path))
        .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut parts = text.split(MARK);
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (target, rest) = part.split_once("}}").expect("an include ends");
        let file = target.split(':').next().unwrap_or(target);
        let folder = path.parent().unwrap_or(Path::new(""));
        let included = root().join(folder).join(file);
        let text = fs::read_to_string(&included)
            .unwrap_or_else(|error| panic!("{} includes {file}: {error}", path.display()));
        out.push_str(&text);
        out.push_str(rest);
    }
    out
}

impl Page {
    /// The lines that are not in blocks of code.
    pub fn prose(&self) -> impl Iterator<Item = &str> {
        let mut code = false;
        self.text.lines().filter(move |line| {
            let fence = line.trim_start().starts_with("```");
            code ^= fence;
            !code && !fence
        })
    }

    /// The lines of blocks of code in this language.
    pub fn code(&self, language: &str) -> Vec<&str> {
        let (mut inside, mut wanted) = (false, false);
        let mut lines = Vec::new();
        for line in self.text.lines() {
            if let Some(info) = line.trim_start().strip_prefix("```") {
                inside = !inside;
                wanted = inside && info.trim() == language;
            } else if wanted {
                lines.push(line);
            }
        }
        lines
    }

    /// The texts between single backticks.
    pub fn spans(&self) -> Vec<&str> {
        // A span may continue on the next line: only whole paragraphs have an even number of backticks.
        self.prose()
            .flat_map(|line| line.split('`').skip(1).step_by(2))
            .collect()
    }

    /// Targets of `[text](target)`.
    pub fn links(&self) -> Vec<&str> {
        self.prose()
            .flat_map(|line| line.split("](").skip(1))
            .filter_map(|rest| rest.split(')').next())
            .collect()
    }

    /// The anchors that mdBook gives to the headings.
    pub fn anchors(&self) -> Vec<String> {
        self.prose()
            .filter(|line| line.starts_with('#'))
            .map(|line| anchor(line.trim_start_matches('#').trim()))
            .collect()
    }
}

fn anchor(heading: &str) -> String {
    heading
        .to_lowercase()
        .chars()
        .filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'))
        .map(|c| if c == ' ' { '-' } else { c })
        .collect()
}
