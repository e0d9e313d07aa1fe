//! The parts of a function compute what the function computes, to the last bit, whatever its length.

use mbs_examples::scenes;
use mbs_macros_core::dag::{Function, Operand, Output, Parts, Place, Run};
use mbs_macros_core::symbolic::{LawEvaluation, Symbol};
use mbs_runtime::Mechanism;
use mbs_tests::fixtures;
use mbs_tests::interpreted::analysis;
use std::collections::BTreeMap;

/// Some value of a symbol, different for different symbols.
fn value(symbol: Symbol) -> f64 {
    let text = format!("{symbol:?}");
    let mix = |hash: u32, byte: u8| hash.wrapping_mul(31).wrapping_add(u32::from(byte));
    0.5 + f64::from(text.bytes().fold(7, mix) % 1000) / 1000.0
}

fn law(index: u32, arguments: &[f64]) -> (f64, Vec<f64>) {
    let sum: f64 = arguments.iter().sum();
    (sum + f64::from(index), vec![sum; arguments.len()])
}

/// The outputs that are values, from the parts.
fn computed(parts: &Parts, constants: &[f64]) -> BTreeMap<String, u64> {
    let laws: LawEvaluation = &law;
    let mut values = vec![f64::NAN; parts.places];
    for (place, input) in parts.inputs.iter().enumerate() {
        values[place] = match *input {
            Operand::Number(number) => number.value(),
            Operand::Constant(slot) => constants[slot],
            Operand::Symbol(symbol) => value(symbol),
            Operand::Value(_) => panic!("a value is no input"),
        };
    }
    for run in &parts.runs {
        let shape = &parts.shapes[run.shape];
        for row in &shape.table[run.first..run.first + run.count] {
            let before = values.clone();
            let symbols = |symbol: Symbol| match symbol {
                Symbol::Place(k) => before[row[k as usize] as usize],
                other => panic!("{other:?} in a part"),
            };
            let run = Run {
                symbols: &symbols,
                constants: &[],
                laws,
            };
            let results = run.function(&shape.function);
            let reads = row.len() - results.len();
            for (k, (_, result)) in results.into_iter().enumerate() {
                values[row[reads + k] as usize] = result;
            }
        }
    }
    let of = |&(output, place): &(Output, usize)| (name(&output), values[place].to_bits());
    parts.outputs.iter().map(of).collect()
}

fn name(output: &Output) -> String {
    format!("{} {:?}", output.sink, output.place)
}

/// The same from the function.
fn expected(function: &Function, constants: &[f64]) -> BTreeMap<String, u64> {
    let run = Run {
        symbols: &value,
        constants,
        laws: &law,
    };
    let results = run.function(function).into_iter();
    let is_absent = |output: &Output| {
        matches!(output.place, Place::Entry(..) | Place::Tensor(..))
            && !["points", "w", "delassus"].contains(&output.sink)
            && output.value == Operand::number(0.0)
    };
    let results = results.filter(|(output, _)| !is_absent(output));
    results
        .map(|(output, value)| (name(&output), value.to_bits()))
        .collect()
}

fn check(declaration: &str) {
    let analysis = analysis(declaration);
    let program = &analysis.program;
    let constants: Vec<f64> = (0..program.constants.len())
        .map(|slot| 0.7 + 0.01 * slot as f64)
        .collect();
    for function in &program.functions {
        let parts = Parts::of(function, &program.labels);
        assert_eq!(
            computed(&parts, &constants),
            expected(function, &constants),
            "{} of {declaration}",
            function.name
        );
    }
}

#[test]
fn of_mechanisms_that_repeat() {
    check(<fixtures::Spine as Mechanism>::MODEL.declaration);
    check(<scenes::four_bar_10::FourBar10 as Mechanism>::MODEL.declaration);
    check(<scenes::bricard::BricardReference as Mechanism>::MODEL.declaration);
}

#[test]
fn of_mechanisms_with_laws_and_every_kind_of_output() {
    check(<fixtures::Workshop as Mechanism>::MODEL.declaration);
    check(<fixtures::Functions as Mechanism>::MODEL.declaration);
    check(<fixtures::Measured as Mechanism>::MODEL.declaration);
    check(<fixtures::Truss as Mechanism>::MODEL.declaration);
    check(<scenes::flyball_governor::FlyballGovernor as Mechanism>::MODEL.declaration);
}

/// A chain of bodies in space, each on a revolute joint.
fn chain(count: usize) -> String {
    let mut text = "Chain { world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),".to_owned();
    for i in 0..count {
        let (x, axis) = (0.5 * i as f64, ["Y", "Z"][i % 2]);
        let parent = match i {
            0 => "ground".to_owned(),
            _ => format!("link{}", i - 1),
        };
        text += &format!(
            "link{i}: Body(at = [{x:?}_m, 0.0, 0.0], mass = 1.0_kg, inertia = 0.02_kg_m2, center_of_mass = [0.25_m, 0.0, 0.0]),\
             joint{i}: Revolute({parent}, link{i}, at = [{x:?}_m, 0.0, 0.0], axis = {axis}),"
        );
    }
    text + "}"
}

/// The code of a chain grows less than its number of links, the operations grow with the pairs of links.
#[test]
fn repeated_bodies_are_written_once() {
    let sizes = [12, 20].map(|count| {
        let analysis = analysis(&chain(count));
        let program = &analysis.program;
        let function = program.function("balance_tangents").expect("M varies");
        let written = Parts::of(function, &program.labels).operations();
        [function.operations.len(), written]
    });
    let [[short, short_written], [long, long_written]] = sizes;
    assert!(2 * short < long, "{short} and {long} operations");
    assert!(12 * long_written < 20 * short_written, "{sizes:?}");
}
