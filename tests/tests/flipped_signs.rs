//! A flipped sign changes the snapshots: the formulas, the program and the Rust if it is in a derived expression, and
//! the numbers if it is in a compiled function.

use mbs_macros_core::derivatives::Derived;
use mbs_macros_core::symbolic::Expr;
use mbs_macros_core::{Analysis, dag, emit, model, syntax};
use mbs_tests::interpreted::analysis;
use mbs_tests::{small, stages, values};
use std::collections::BTreeSet;

/// The derived quantities, by their symbols.
const QUANTITIES: [&str; 15] = [
    "M",
    "p",
    "T",
    "Γ",
    "A",
    "b",
    "Ȧ",
    "γ",
    "f",
    "F",
    "∂f/∂q",
    "∂f/∂v",
    "∂F/∂q",
    "∂F/∂v",
    "∂p/∂q",
];

/// The expressions of a quantity.
fn expressions<'a>(derived: &'a mut Derived, quantity: &str) -> Vec<&'a mut Expr> {
    let matrix = match quantity {
        "M" => &mut derived.system.mass,
        "A" => &mut derived.jacobian,
        "Ȧ" => &mut derived.jacobian_rate,
        "∂f/∂q" => &mut derived.applied.by_position,
        "∂f/∂v" => &mut derived.applied.by_velocity,
        "∂F/∂q" => &mut derived.total.by_position,
        "∂F/∂v" => &mut derived.total.by_velocity,
        "∂p/∂q" => &mut derived.momentum_by_position,
        "Γ" => {
            let affinities = derived.affinities.iter_mut();
            return affinities.flat_map(|list| list.values_mut()).collect();
        }
        "T" => return vec![&mut derived.kinetic],
        "p" => return derived.momentum.iter_mut().collect(),
        "b" => return derived.rheonomic.iter_mut().collect(),
        "γ" => return derived.convective.iter_mut().collect(),
        "f" => return derived.system.forces.iter_mut().collect(),
        "F" => return derived.total_forces.iter_mut().collect(),
        other => panic!("`{other}` is not a quantity"),
    };
    matrix.values_mut().collect()
}

/// Calls `examine` with every entry of every quantity that is not zero, its sign flipped.
fn flip_each(analysis: &mut Analysis, mut examine: impl FnMut(&'static str, usize, &Analysis)) {
    for quantity in QUANTITIES {
        let count = expressions(&mut analysis.derived, quantity).len();
        for entry in 0..count {
            let expr = *expressions(&mut analysis.derived, quantity)[entry];
            let graph = &mut analysis.derived.system.graph;
            if graph.is_zero(expr) {
                continue;
            }
            let flipped = graph.neg(expr);
            *expressions(&mut analysis.derived, quantity)[entry] = flipped;
            examine(quantity, entry, analysis);
            *expressions(&mut analysis.derived, quantity)[entry] = expr;
        }
    }
}

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
        flip_each(&mut analysis, |quantity, entry, analysis| {
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
        flip_each(&mut analysis, |quantity, entry, analysis| {
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
