//! rustc, called by a test: with libraries that are built already, so that nothing is built again for it.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::SystemTime;
use std::{env, fs};

/// rustc with some libraries that this program was built from.
pub fn rustc(libraries: &[&str]) -> Command {
    let program = env::current_exe().expect("this program");
    let folder = program.parent().expect("its folder");
    let mut command = Command::new(env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned()));
    command.arg("--edition=2024").arg("-L");
    command.arg(format!("dependency={}", folder.display()));
    for name in libraries {
        let library = newest(folder, name);
        command.arg("--extern");
        command.arg(format!("{name}={}", library.display()));
    }
    // A thread of rustc has the stack that a user's has.
    command.env_remove("RUST_MIN_STACK");
    command
}

/// The newest library of a crate in a folder.
fn newest(folder: &Path, name: &str) -> PathBuf {
    let prefix = format!("lib{name}-");
    let files = fs::read_dir(folder).expect("the folder of this program");
    let files = files.map(|file| file.expect("an entry").path());
    let libraries = files.filter(|path| {
        let file = path.file_name().unwrap_or_default().to_string_lossy();
        file.starts_with(&prefix) && file.ends_with(".rlib")
    });
    let changed = |path: &PathBuf| -> Option<SystemTime> { path.metadata().ok()?.modified().ok() };
    libraries.max_by_key(changed).expect("it is built")
}
