//! What is published has what a registry shows: texts of the licences, a readme, keywords and categories.

use mbs_tests::pages::root;
use std::fs;

const PUBLISHED: [&str; 4] = ["mbs-macros/core", "mbs-macros", "mbs-runtime", "mbs-parts"];

#[test]
fn packages_have_what_a_registry_shows() {
    for name in PUBLISHED {
        let folder = root().join(name);
        let manifest = fs::read_to_string(folder.join("Cargo.toml")).expect(name);
        let value = |key: &str| {
            let line = manifest.lines().find(|line| line.starts_with(key));
            let line = line.unwrap_or_else(|| panic!("{name} has no `{key}`"));
            line.split_once(" = ").expect("a value").1.to_owned()
        };
        assert!(!manifest.contains("publish = false"), "{name}");
        for key in ["description", "rust-version.workspace", "license.workspace"] {
            value(key);
        }
        let words = value("keywords").matches('"').count() / 2;
        assert!((1..=5).contains(&words), "{name}: {words} keywords");
        assert!(value("categories").contains("science::robotics"), "{name}");
        let readme = value("readme");
        assert!(folder.join(readme.trim_matches('"')).exists(), "{name}");
        for text in ["LICENSE-MIT", "LICENSE-APACHE"] {
            let read = |file| fs::read_to_string(file).expect(text);
            let (own, common) = (read(folder.join(text)), read(root().join(text)));
            assert_eq!(own, common, "{name}: {text}");
        }
    }
}

/// Everything else stays here.
#[test]
fn no_other_package_is_published() {
    let workspace = fs::read_to_string(root().join("Cargo.toml")).expect("the workspace");
    let members = workspace.lines().find(|line| line.starts_with("members"));
    let members = members.expect("members").split('"').skip(1).step_by(2);
    for member in members.filter(|member| !PUBLISHED.contains(member)) {
        let manifest = fs::read_to_string(root().join(member).join("Cargo.toml")).expect(member);
        assert!(manifest.contains("publish = false"), "{member}");
    }
}
