//! The declarations of the scenes, as tokens.

pub mod expansion;
pub mod imports;

use proc_macro2::TokenStream;
use std::path::{Path, PathBuf};

/// The files of the scenes, sorted.
pub fn scene_files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../mbs-examples/src/scenes");
    let entries = std::fs::read_dir(&folder).expect("the scenes are there");
    let mut files: Vec<PathBuf> = entries
        .map(|entry| entry.expect("readable").path())
        .collect();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "rs"));
    files.sort();
    files
}

/// Name and tokens of every `mechanism!` of the scenes.
pub fn declarations() -> Vec<(String, TokenStream)> {
    let mut found = Vec::new();
    for file in scene_files() {
        let source = std::fs::read_to_string(&file).expect("readable");
        let file = syn::parse_file(&source).expect("a scene is Rust");
        for item in file.items {
            if let syn::Item::Macro(item) = item
                && item.mac.path.is_ident("mechanism")
            {
                let name = item.mac.tokens.clone().into_iter().next();
                let name = name.map(|name| name.to_string()).unwrap_or_default();
                found.push((name, item.mac.tokens));
            }
        }
    }
    assert!(!found.is_empty(), "no declarations found");
    found
}
