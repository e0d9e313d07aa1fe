//! No test is left out: a library or program that is not built for tests (`test = false`) has no test in its sources, one
//! without documentation tests (`doctest = false`) no code in its documentation, and every file of tests is compiled.

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

/// Whether a file below a folder has a line of some sort.
fn has(folder: &Path, sort: fn(&str) -> bool) -> bool {
    fs::read_dir(folder).expect("sources").any(|entry| {
        let path = entry.expect("readable").path();
        if path.is_dir() {
            has(&path, sort)
        } else {
            fs::read_to_string(&path).is_ok_and(|text| text.lines().any(sort))
        }
    })
}

fn begins_test(line: &str) -> bool {
    line.contains("#[test]")
}

/// Code in documentation, or a page that may have some.
fn begins_documentation_test(line: &str) -> bool {
    let line = line.trim_start();
    line.starts_with("//") && line.contains("```") || line.contains("doc = include_str!")
}

#[test]
fn what_is_not_built_for_tests_has_none() {
    let (mut checked, mut others, mut undocumented) = (0, 0, 0);
    for package in members() {
        let manifest = fs::read_to_string(package.join("Cargo.toml")).expect("UTF-8");
        let source = package.join("src");
        let inside = has(&source, begins_test);
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
        if manifest.lines().any(|line| line == "doctest = false") {
            undocumented += 1;
            assert!(
                !has(&source, begins_documentation_test),
                "{} has a documentation test that no command runs: remove `doctest = false`",
                package.display()
            );
        }
    }
    // The lists have entries, so that they were read.
    assert!(checked >= 4, "{checked} packages checked");
    assert!(others >= 2, "{others} packages with tests inside");
    assert!(
        undocumented >= 1,
        "{undocumented} without documentation tests"
    );
    assert!(has(&root().join("tests/src"), begins_documentation_test));
}

/// The tests of a package are the programs that its manifest names: a file beside their sources that none of these names would
/// not be compiled.
#[test]
fn every_file_of_tests_is_a_module() {
    let mut programs = 0;
    for package in members() {
        let folder = package.join("tests");
        if !folder.join("main.rs").is_file() {
            continue;
        }
        let manifest = fs::read_to_string(package.join("Cargo.toml")).expect("a manifest");
        let roots = manifest
            .lines()
            .filter_map(|line| line.strip_prefix("path = \"tests/")?.strip_suffix(".rs\""));
        let roots: Vec<&str> = roots.collect();
        programs += roots.len();
        let read = |root: &&str| fs::read_to_string(folder.join(format!("{root}.rs")));
        let sources = roots.iter().map(read).collect::<Result<Vec<_>, _>>();
        let sources = sources.expect("the manifest names files that exist");
        for entry in fs::read_dir(&folder).expect("tests") {
            let path = entry.expect("readable").path();
            let name = path.file_stem().unwrap_or_default().to_string_lossy();
            let is_source = path.extension().is_some_and(|extension| extension == "rs");
            if is_source && !roots.contains(&&*name) {
                let module = format!("mod {name};");
                let named = sources.iter().flat_map(|source| source.lines());
                let count = named.filter(|line| *line == module).count();
                assert!(count > 0, "{} is not named in {roots:?}", path.display());
            }
        }
    }
    assert_eq!(programs, 6);
}
