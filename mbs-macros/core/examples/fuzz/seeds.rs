//! The declarations of the repository.

use super::tree::{self, Tree};
use std::path::Path;

/// Those with more tokens take long to derive, and find no more than small ones.
const LARGEST: usize = 700;

/// What stands in `mechanism!(…)` in sources and pages.
pub fn declarations(root: &Path) -> Vec<Vec<Tree>> {
    let mut found = Vec::new();
    read(root, &mut found);
    found.retain(|trees| tree::count(trees) <= LARGEST);
    found
}

fn read(folder: &Path, found: &mut Vec<Vec<Tree>>) {
    let Ok(entries) = std::fs::read_dir(folder) else {
        return;
    };
    let mut paths: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
    paths.sort();
    for path in paths {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name.starts_with('.') || name == "target" {
            continue;
        }
        if path.is_dir() {
            read(&path, found);
        } else if name.ends_with(".rs") || name.ends_with(".md") {
            let text = std::fs::read_to_string(&path).unwrap_or_default();
            let starts = text.match_indices("mechanism!(");
            let inside = starts.filter_map(|(start, mark)| inside(&text[start + mark.len()..]));
            found.extend(
                inside
                    .filter_map(tree::parse)
                    .filter(|trees| trees.len() > 1),
            );
        }
    }
}

/// The text up to the bracket that closes one opened before it.
fn inside(text: &str) -> Option<&str> {
    let mut open = 1;
    for (end, character) in text.char_indices() {
        match character {
            '(' => open += 1,
            ')' => open -= 1,
            _ => {}
        }
        if open == 0 {
            return Some(&text[..end]);
        }
    }
    None
}
