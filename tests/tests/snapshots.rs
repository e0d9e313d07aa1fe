//! Small declarations after every stage of the compiler, and the derived quantities of some scenes, as formulas and as
//! numbers from the generated code. `cargo insta review` shows the effect of a change on them.

use mbs_tests::interpreted::analysis;
use mbs_tests::small;
use mbs_tests::stages;
use mbs_tests::values;

/// Stage 6, formatted.
fn rust(declaration: &str) -> String {
    let file = syn::parse2(mbs_macros_core::compile(stages::tokens(declaration)));
    prettyplease::unparse(&file.expect("generated Rust parses"))
}

/// The items inside `const _: () = { … };`, but for those that only an editor sees.
fn inside(items: &[syn::Item]) -> Vec<syn::Item> {
    let hidden = |attribute: &syn::Attribute| match &attribute.meta {
        syn::Meta::List(list) => {
            list.path.is_ident("cfg") && list.tokens.to_string() == "rust_analyzer"
        }
        _ => false,
    };
    let blocks = items.iter().filter_map(|item| match item {
        syn::Item::Const(constant) if !constant.attrs.iter().any(hidden) => match &*constant.expr {
            syn::Expr::Block(block) => Some(&block.block.stmts),
            _ => None,
        },
        _ => None,
    });
    let statements = blocks.flatten().filter_map(|statement| match statement {
        syn::Stmt::Item(item) => Some(item.clone()),
        _ => None,
    });
    statements.collect()
}

/// The methods of the system with these names.
fn methods(declaration: &str, names: &[&str]) -> String {
    let mut file: syn::File =
        syn::parse2(mbs_macros_core::compile(stages::tokens(declaration))).expect("it parses");
    // The implementations are inside `const _: () = { const _: () = { … }; };`.
    file.items = inside(&inside(&file.items));
    file.items
        .retain(|item| matches!(item, syn::Item::Impl(block) if block.trait_.is_some()));
    for item in &mut file.items {
        if let syn::Item::Impl(block) = item {
            block.items.retain(|item| match item {
                syn::ImplItem::Fn(function) => names.iter().any(|name| function.sig.ident == name),
                _ => false,
            });
        }
    }
    file.items
        .retain(|item| !matches!(item, syn::Item::Impl(block) if block.items.is_empty()));
    prettyplease::unparse(&file)
}

#[test]
fn stages_1_to_5() {
    for (name, declaration) in small::ALL {
        for (stage, text) in stages::texts(declaration) {
            assert!(!text.contains('…'), "{name}-{stage}: a formula is cut");
            insta::assert_snapshot!(format!("{name}-{stage}"), text);
        }
    }
}

#[test]
fn stage_6() {
    for (name, declaration) in small::ALL {
        insta::assert_snapshot!(format!("{name}-6-rust"), rust(declaration));
    }
}

/// The method that an integrator evaluates most often.
#[test]
fn constraints() {
    for (name, declaration) in small::ALL {
        insta::assert_snapshot!(
            format!("constraints-of-{name}"),
            methods(declaration, &["constraints"])
        );
    }
}

/// M, Γ, A, b, Ȧ, γ and the tangents of the forces and of the momentum.
#[test]
fn formulas_of_scenes() {
    for name in small::SCENES {
        let analysis = analysis(small::scene(name));
        let text = stages::quantities(&analysis.derived);
        insta::assert_snapshot!(format!("formulas-of-{name}"), text);
    }
}

/// The same quantities in numbers, from the compiled functions.
#[test]
fn values() {
    for (name, text) in values::texts() {
        insta::assert_snapshot!(format!("values-of-{name}"), text);
    }
}

/// Every snapshot has a test.
#[test]
fn every_snapshot_has_its_test() {
    let directory = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/snapshots");
    let stages = [
        "1-tree",
        "2-model",
        "3-system",
        "4-derived",
        "5-program",
        "6-rust",
    ];
    let mut expected: Vec<String> = small::ALL
        .iter()
        .flat_map(|(name, _)| {
            let each = stages
                .iter()
                .map(move |stage| format!("declarations__snapshots__{name}-{stage}.snap"));
            each.chain([format!(
                "declarations__snapshots__constraints-of-{name}.snap"
            )])
        })
        .collect();
    let scenes = small::SCENES.iter();
    expected.extend(scenes.map(|name| format!("declarations__snapshots__formulas-of-{name}.snap")));
    let values = values::texts().into_iter();
    expected
        .extend(values.map(|(name, _)| format!("declarations__snapshots__values-of-{name}.snap")));
    expected.sort();
    let mut found: Vec<String> = std::fs::read_dir(directory)
        .expect("snapshots are checked in")
        .map(|entry| {
            entry
                .expect("readable")
                .file_name()
                .to_string_lossy()
                .into_owned()
        })
        .filter(|name| name.starts_with("declarations__snapshots__") && name.ends_with(".snap"))
        .collect();
    found.sort();
    assert_eq!(found, expected);
}

/// Nothing depends on the order of hash maps, or on what was compiled before.
#[test]
fn compiling_is_deterministic() {
    let scenes = mbs_examples::scenes::scenes();
    let small = scenes
        .iter()
        .filter(|scene| scene.model.coordinates.len() <= 20);
    let all: Vec<&str> = small::ALL
        .iter()
        .map(|(_, declaration)| *declaration)
        .chain(small.map(|scene| scene.model.declaration))
        .collect();
    let forwards: Vec<String> = all.iter().map(|declaration| rust(declaration)).collect();
    let mut backwards: Vec<String> = all
        .iter()
        .rev()
        .map(|declaration| rust(declaration))
        .collect();
    backwards.reverse();
    assert!(
        forwards == backwards,
        "the same declaration gave different Rust"
    );
}
