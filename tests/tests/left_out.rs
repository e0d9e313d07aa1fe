//! No test is left out: a library or program that is not built for tests (`test = false`) has no test in its sources, and
//! every file of tests is compiled.

use mbs_tests::pages::root;
use std::fs;
use std::path::{Path, PathBuf};

/// The packages of the workspace.
fn members() -> Vec<PathBuf> {
    let manifest = fs::read_to_string(root().join("Cargo.toml")).expect("UTF-8");
    let list = manifest.split_once("members = [").expect("members").1;
    let list = list.split_once(']').expect("their end").0;
    let names = list.split('"').skip(1).step_by(2);
    names.map(|name| root().join(name)).collect()
}

/// Whether a file below a folder has a test.
fn has_test(folder: &Path) -> bool {
    fs::read_dir(folder).expect("sources").any(|entry| {
        let path = entry.expect("readable").path();
        if path.is_dir() {
            has_test(&path)
        } else {
            fs::read_to_string(&path).is_ok_and(|text| text.contains("#[test]"))
        }
    })
}

#[test]
fn what_is_not_built_for_tests_has_none() {
    let (mut checked, mut others) = (0, 0);
    for package in members() {
        let manifest = fs::read_to_string(package.join("Cargo.toml")).expect("UTF-8");
        let inside = has_test(&package.join("src"));
        if manifest.lines().any(|line| line == "test = false") {
            checked += 1;
            assert!(
                !inside,
                "{} has a test in src that no command runs: move it to tests/, or remove `test = false`",
                package.display()
            );
        } else {
            others += usize::from(inside);
        }
    }
    // Both lists have entries, so that both were read.
    assert!(checked >= 4, "{checked} packages checked");
    assert!(others >= 2, "{others} packages with tests inside");
}

/// The tests of a package are one program: a file beside its `main.rs` that this does not name would not be compiled.
#[test]
fn every_file_of_tests_is_a_module() {
    let mut programs = 0;
    for package in members() {
        let folder = package.join("tests");
        let Ok(main) = fs::read_to_string(folder.join("main.rs")) else {
            continue;
        };
        programs += 1;
        for entry in fs::read_dir(&folder).expect("tests") {
            let path = entry.expect("readable").path();
            let name = path.file_stem().unwrap_or_default().to_string_lossy();
            let is_source = path.extension().is_some_and(|extension| extension == "rs");
            if is_source && name != "main" {
                let named = main.lines().any(|line| line == format!("mod {name};"));
                assert!(named, "{} is not named in main.rs", path.display());
            }
        }
    }
    assert_eq!(programs, 3);
}
