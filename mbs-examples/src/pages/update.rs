//! Compares the pages with their data: stale blocks, and new texts.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use super::block;
use super::data::Data;
use super::registry::{Entry, Place};

/// A file of the repository: its present text, and the text rendered from the data.
#[derive(Debug, Clone, PartialEq)]
pub struct Update {
    /// From the top of the repository.
    pub path: String,
    /// The present text; empty if there is no file.
    pub old: String,
    /// The text that should be there.
    pub new: String,
    /// Names of the blocks that differ; the path itself for a whole file.
    pub stale: Vec<String>,
}

/// The README, the pages of the book that have blocks, and the files that programs write as a whole.
///
/// # Errors
/// All that is wrong, a line each: files that cannot be read, data that is missing, a block without a renderer, a renderer
/// without a block.
pub fn updates(root: &Path, entries: &[Entry]) -> Result<Vec<Update>, String> {
    let data = Data::new(root);
    let (mut done, mut wrong) = (Vec::new(), Vec::new());
    let mut used = vec![false; entries.len()];
    for (path, old) in pages(root)? {
        match page(&path, &old, entries, &data, &mut used) {
            Ok(None) => {}
            Ok(Some(update)) => done.push(update),
            Err(problems) => wrong.extend(problems),
        }
    }
    for (entry, used) in entries.iter().zip(used) {
        match entry.place {
            Place::Block { page, name } if !used => wrong.push(format!(
                "{page}: no block `{name}`, for which there is a renderer"
            )),
            Place::Block { .. } => {}
            Place::File(path) => match (entry.render)(&data) {
                Ok(new) => done.push(whole(root, path, new)),
                Err(problem) => wrong.push(format!("{path}: {problem}")),
            },
        }
    }
    match wrong.is_empty() {
        true => Ok(done),
        false => Err(wrong.join("\n")),
    }
}

/// A page with its blocks rendered anew; `None` if it has none.
fn page(
    path: &str,
    old: &str,
    entries: &[Entry],
    data: &Data,
    used: &mut [bool],
) -> Result<Option<Update>, Vec<String>> {
    let blocks = block::find(old).map_err(|problem| vec![format!("{path}: {problem}")])?;
    let (mut new, mut stale, mut wrong) = (String::new(), Vec::new(), Vec::new());
    let mut at = 0;
    for found in &blocks {
        let place = Place::Block {
            page: path,
            name: found.name,
        };
        let text = match entries.iter().position(|entry| entry.place == place) {
            None => Err("has no renderer on this page".to_owned()),
            Some(index) => {
                used[index] = true;
                (entries[index].render)(data)
            }
        };
        let before = &old[found.text.clone()];
        match text {
            Err(problem) => wrong.push(format!("{path}: block `{}`: {problem}", found.name)),
            Ok(text) => {
                let text = block::framed(found, &text);
                if text != before {
                    stale.push(found.name.to_owned());
                }
                new += &old[at..found.text.start];
                new += &text;
                at = found.text.end;
            }
        }
    }
    if !wrong.is_empty() {
        return Err(wrong);
    }
    new += &old[at..];
    Ok((!blocks.is_empty()).then(|| Update {
        path: path.to_owned(),
        old: old.to_owned(),
        new,
        stale,
    }))
}

fn whole(root: &Path, path: &str, new: String) -> Update {
    let old = fs::read_to_string(root.join(path)).unwrap_or_default();
    let stale = (old != new).then(|| path.to_owned());
    Update {
        path: path.to_owned(),
        old,
        new,
        stale: stale.into_iter().collect(),
    }
}

/// The README and all pages of the book, by their paths.
fn pages(root: &Path) -> Result<BTreeMap<String, String>, String> {
    let complain = |path: &Path, error| format!("{}: {error}", root.join(path).display());
    let mut files = vec![PathBuf::from("README.md")];
    let mut folders = vec![PathBuf::from("book/src")];
    while let Some(folder) = folders.pop() {
        let entries = fs::read_dir(root.join(&folder)).map_err(|e| complain(&folder, e))?;
        for entry in entries {
            let path = folder.join(entry.map_err(|e| complain(&folder, e))?.file_name());
            if root.join(&path).is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "md") {
                files.push(path);
            }
        }
    }
    let read = |path: PathBuf| {
        let text = fs::read_to_string(root.join(&path)).map_err(|e| complain(&path, e))?;
        Ok((path.to_string_lossy().replace('\\', "/"), text))
    };
    files.into_iter().map(read).collect()
}
