//! No import runs back up the layers: the tables of `book/src/internals/layers.md` against the sources of both crates. And what
//! both have to say twice, because they do not import each other, is the same.

use crate::common::imports;

use imports::{Imports, circles, imports};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::PathBuf;

/// Both crates, with the headings of their tables.
const CRATES: [(&str, &str); 2] = [
    ("mbs-macros/core", "The compiler"),
    ("mbs-runtime", "The runtime"),
];

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn page() -> String {
    fs::read_to_string(root().join("book/src/internals/layers.md")).expect("the page")
}

fn imports_of(crate_name: &str) -> Imports {
    imports(&root().join(crate_name).join("src"))
}

/// The rows of the table below a heading, without backticks.
fn table(page: &str, heading: &str) -> Vec<Vec<String>> {
    let section = page.split("\n## ").find(|part| part.starts_with(heading));
    let section = section.unwrap_or_else(|| panic!("the page has no `{heading}`"));
    let rows = section.lines().filter(|line| line.starts_with('|')).skip(2);
    let cells = |row: &str| -> Vec<String> {
        let cells = row.trim_matches('|').split('|');
        cells.map(|cell| cell.trim().replace('`', "")).collect()
    };
    rows.map(cells).collect()
}

/// The folder of a file, or the file itself where it is in none.
fn folder(file: &str) -> &str {
    let first = file.split('/').next().unwrap_or(file);
    first.trim_end_matches(".rs")
}

/// What each folder may import; a name that stands below it is a mistake of the table.
fn allowed(rows: &[Vec<String>]) -> BTreeMap<String, BTreeSet<String>> {
    let mut above: Vec<String> = Vec::new();
    let mut allowed = BTreeMap::new();
    for row in rows {
        let [name, may_import] = row.as_slice() else {
            panic!("a row has a folder and what it may import: {row:?}");
        };
        let listed: BTreeSet<String> = match may_import.as_str() {
            "all above" => above.iter().cloned().collect(),
            list => {
                let names = list.split(',').map(|name| name.trim().to_owned());
                names.filter(|name| !name.is_empty()).collect()
            }
        };
        for listed in &listed {
            assert!(
                above.contains(listed),
                "`{name}` imports `{listed}` below it"
            );
        }
        above.push(name.clone());
        allowed.insert(name.clone(), listed);
    }
    allowed
}

/// The imports that run back up, and the exceptions (from, to) that no import needs.
fn against(
    allowed: &BTreeMap<String, BTreeSet<String>>,
    exceptions: &BTreeSet<(String, String)>,
    imports: &Imports,
) -> Vec<String> {
    let (mut wrong, mut needed) = (Vec::new(), BTreeSet::new());
    for (file, targets) in imports {
        let from = folder(file);
        if from == "lib" {
            continue;
        }
        let Some(may_import) = allowed.get(from) else {
            wrong.push(format!("{file}: `{from}` has no row"));
            continue;
        };
        for target in targets {
            let to = folder(target);
            let exception = (from.to_owned(), target.clone());
            if to == from || may_import.contains(to) {
                continue;
            }
            match exceptions.contains(&exception) {
                true => drop(needed.insert(exception)),
                false => wrong.push(format!("{file} imports {target}")),
            }
        }
    }
    let idle = exceptions
        .difference(&needed)
        .map(|(from, to)| format!("no import needs the exception of `{from}` and `{to}` any more"));
    wrong.extend(idle);
    wrong
}

#[test]
fn imports_follow_the_tables() {
    let page = page();
    for (crate_name, heading) in CRATES {
        let exceptions = table(&page, "Exceptions");
        let own = exceptions.iter().filter(|row| row[0] == crate_name);
        let exceptions = own.map(|row| (row[1].clone(), row[2].clone())).collect();
        let allowed = allowed(&table(&page, heading));
        let wrong = against(&allowed, &exceptions, &imports_of(crate_name));
        assert!(wrong.is_empty(), "{crate_name}:\n{}", wrong.join("\n"));
    }
}

/// An arrow that runs back up is found, where the sources have one.
#[test]
fn a_wrong_import_is_found() {
    let allowed = allowed(&table(&page(), "The compiler"));
    let mut imports = imports_of("mbs-macros/core");
    let model = imports
        .get_mut("model/tree.rs")
        .expect("a file of the model");
    model.insert("equations/system.rs".to_owned());
    let wrong = against(&allowed, &BTreeSet::new(), &imports);
    assert_eq!(wrong, ["model/tree.rs imports equations/system.rs"]);
    // The exception allows it, and is not needed without it.
    let exceptions = [("model".to_owned(), "equations/system.rs".to_owned())].into();
    assert_eq!(against(&allowed, &exceptions, &imports), [""; 0]);
    let imports = imports_of("mbs-macros/core");
    let idle = "no import needs the exception of `model` and `equations/system.rs` any more";
    assert_eq!(against(&allowed, &exceptions, &imports), [idle]);
}

/// The tables of the compiler promise no arrow that is not there.
#[test]
fn listed_arrows_exist() {
    let (crate_name, heading) = CRATES[0];
    let mut found: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (file, targets) in imports_of(crate_name) {
        let targets = targets.iter().map(|target| folder(target).to_owned());
        let own = found.entry(folder(&file).to_owned()).or_default();
        own.extend(targets);
    }
    for (name, listed) in allowed(&table(&page(), heading)) {
        let real = found.get(&name).unwrap_or_else(|| panic!("no `{name}`"));
        for listed in listed {
            assert!(
                real.contains(&listed),
                "`{name}` does not import `{listed}`"
            );
        }
    }
}

#[test]
fn circles_are_small() {
    for row in table(&page(), "Circles") {
        let most: usize = row[1].parse().expect("a number of files");
        let found = circles(&imports_of(&row[0]));
        let largest = found.first().map_or(0, Vec::len);
        assert!(largest <= most, "{}: {:?}", row[0], found.first());
    }
}

/// Paths in `use` and elsewhere are found, and names that are handed on lead to their files.
#[test]
fn imports_are_found() {
    let core = imports_of("mbs-macros/core");
    let has = |file: &str, target: &str| {
        assert!(core[file].contains(target), "{file}: {:?}", core[file]);
    };
    // `use super::tree::Tree;`
    has("model/passes.rs", "model/tree.rs");
    // `use crate::model::Model;`, which `model/mod.rs` hands on.
    has("equations/derive.rs", "model/mechanism.rs");
    // `crate::dimension::unit` in an expression.
    has("model/arguments/numbers.rs", "dimension.rs");
    // `revolute::read` of a child module.
    has(
        "model/elements/joints/planar/mod.rs",
        "model/elements/joints/planar/revolute.rs",
    );
}

/// The macro weighs operations to choose coordinates, the runtime to bound a step and to compare methods.
#[test]
fn operations_weigh_the_same_in_both_crates() {
    let weights = |file: &str| {
        let text = fs::read_to_string(root().join(file)).expect(file);
        ["DIVISION", "CALL", "FLIGHT"].map(|name| {
            let start = format!("const {name}: usize = ");
            let value = text.lines().find_map(|line| line.strip_prefix(&start));
            value
                .unwrap_or_else(|| panic!("{file} has no `{name}`"))
                .to_owned()
        })
    };
    let files = [
        "mbs-macros/core/src/choose.rs",
        "mbs-runtime/src/known_cost.rs",
    ];
    let [compiler, runtime] = files.map(weights);
    assert_eq!(compiler, runtime);
}
