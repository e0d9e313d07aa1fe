//! A flipped sign changes the snapshots: the formulas, the program and the Rust if it is in a derived expression, and
//! the numbers if it is in a compiled function.

use mbs_macros_core::{Analysis, dag, emit, model, syntax};
use mbs_tests::flips::{Flip, QUANTITIES, flip_each};
use mbs_tests::interpreted::analysis;
use mbs_tests::{small, stages, values};
use std::collections::BTreeSet;

/// The formulas of stages 3 and 4, the program of stage 5, and the Rust of stage 6.
fn texts(declaration: &str, analysis: &Analysis) -> [String; 3] {
    let derived = &analysis.derived;
    let mut errors = mbs_macros_core::diagnostics::Errors::new();
    let tree = syntax::parse(stages::tokens(declaration), model::kinds(), &mut errors)
        .expect("it compiles");
    let formulas = stages::system(&derived.system) + &stages::derived(derived);
    let program = dag::lower(derived);
    let rust = emit::mechanism(&tree, analysis, &program).to_string();
    [formulas, program.text(&derived.system.graph), rust]
}

#[test]
fn in_every_derived_quantity_of_small_declarations() {
    let mut flipped = BTreeSet::new();
    for (name, declaration) in small::ALL {
        let mut analysis = analysis(declaration);
        let right = texts(declaration, &analysis);
        flip_each(&mut analysis, |flip, analysis| {
            let Flip {
                quantity, entry, ..
            } = flip;
            flipped.insert(quantity);
            let wrong = texts(declaration, analysis);
            for (stage, (right, wrong)) in (4..).zip(right.iter().zip(&wrong)) {
                assert_ne!(
                    right, wrong,
                    "{name}: {quantity}, entry {entry}, stage {stage}"
                );
            }
        });
        assert_eq!(texts(declaration, &analysis), right);
    }
    assert_eq!(flipped, QUANTITIES.into(), "the others are zero everywhere");
}

#[test]
fn in_every_formula_of_scenes() {
    // The small declarations test these.
    let left_out = ["p", "T", "f", "F", "∂f/∂q", "∂f/∂v"];
    let mut seen = BTreeSet::from(left_out);
    for name in small::SCENES {
        let mut analysis = analysis(small::scene(name));
        let right = stages::quantities(&analysis.derived);
        flip_each(&mut analysis, |flip, analysis| {
            let Flip {
                quantity, entry, ..
            } = flip;
            if !left_out.contains(&quantity) {
                seen.insert(quantity);
                let wrong = stages::quantities(&analysis.derived);
                assert_ne!(right, wrong, "{name}: {quantity}, entry {entry}");
            }
        });
    }
    assert_eq!(seen, QUANTITIES.into(), "the others are zero everywhere");
}

#[test]
fn in_every_value_of_compiled_functions() {
    let (counts, unseen) = values::flips();
    assert!(unseen.is_empty(), "{unseen:#?}");
    for (symbol, ..) in values::QUANTITIES {
        assert!(counts.contains_key(symbol), "{symbol} is zero everywhere");
    }
}
