//! Accepted declarations as a package, for the compiler of Rust.

use super::tree::{self, Tree};
use std::fmt::Write;
use std::path::Path;
use std::{fs, io};

/// Calls of functions of the user, which stand beside a declaration.
const OUTSIDE: [&str; 1] = ["law"];

/// Whether a declaration needs nothing beside it.
pub fn stands_alone(trees: &[Tree]) -> bool {
    trees.iter().all(|tree| match tree {
        Tree::Leaf(leaf) => !OUTSIDE.contains(&leaf.as_str()),
        Tree::Group(_, inside) => stands_alone(inside),
    })
}

/// Writes a library with one module for each declaration.
///
/// # Errors
/// The folder cannot be written.
pub fn write(folder: &Path, runtime: &Path, accepted: &[Vec<Tree>]) -> io::Result<()> {
    let manifest = format!(
        "[package]\nname = \"accepted\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[dependencies]\n\
         mbs-runtime = {{ path = {:?} }}\n\n[workspace]\n",
        fs::canonicalize(runtime)?
    );
    let mut library = String::from("#![allow(dead_code, unused, nonstandard_style)]\n");
    for (number, declaration) in accepted.iter().enumerate() {
        let declaration = tree::text(declaration);
        let _ = write!(
            library,
            "mod m{number} {{\n    mbs_runtime::mechanism!({declaration});\n}}\n"
        );
    }
    fs::create_dir_all(folder.join("src"))?;
    fs::write(folder.join("Cargo.toml"), manifest)?;
    fs::write(folder.join("src/lib.rs"), library)
}
