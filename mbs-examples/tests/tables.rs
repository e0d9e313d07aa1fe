//! Tables: reference values for runs, the columns of the command line, and those of the charts.

use mbs_examples::laboratory::outcome::Outcome;
use mbs_examples::laboratory::tables::front;
use mbs_examples::laboratory::work_precision::Point;
use mbs_examples::reference::ReferenceTable;
use mbs_examples::scene::Reference;
use mbs_examples::scenes::scenes;
use mbs_examples::table::{Align, table};
use mbs_runtime::output::Frame;
use std::path::Path;

/// The first output of a scene compared with three reference values.
fn trusted(name: &str) -> ReferenceTable {
    let scenes = scenes();
    let has_output = |model: &mbs_runtime::Model| !model.outputs.is_empty();
    let scene = scenes.iter().find(|scene| has_output(scene.model));
    let model = scene.expect("a scene with an output").model;
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("trusted-{name}.csv"));
    std::fs::write(&path, "time_s,x_m\n0.0,1.0\n0.1,2.0\n0.2,4.0\n").expect("it can be written");
    let reference = Reference {
        file: "trusted.csv",
        columns: Box::leak(Box::new([(model.outputs[0].name, "x_m")])),
    };
    ReferenceTable::read(path, &reference, model).expect("a table")
}

fn frame(time: f64, x: f64) -> Frame {
    Frame {
        time,
        outputs: vec![x],
        ..Frame::default()
    }
}

#[test]
fn only_shared_instants_are_compared() {
    let frames = [
        frame(0.0, 1.0),
        frame(0.05, 99.0),
        frame(0.1 + 1e-15, 2.5),
        frame(0.2, 4.25),
    ];
    let deviation = &trusted("shared").compare(&frames)[0];
    assert_eq!(
        (deviation.instants, deviation.largest, deviation.at_end),
        (3, 0.5, Some(0.25))
    );
}

#[test]
fn an_end_beyond_the_reference_has_no_error() {
    let deviation = &trusted("beyond").compare(&[frame(0.0, 1.0), frame(0.3, 9.0)])[0];
    assert_eq!((deviation.instants, deviation.at_end), (1, None));
}

#[test]
fn what_is_not_a_number_is_not_hidden() {
    let deviation = &trusted("nan").compare(&[frame(0.0, f64::NAN), frame(0.1, 2.0)])[0];
    assert!(deviation.largest.is_nan());
}

#[test]
fn columns_are_aligned() {
    let heading = [("name", Align::Left), ("n", Align::Right)];
    let rows = [
        ["φ".to_owned(), "12".to_owned()],
        ["longer".to_owned(), "3".to_owned()],
    ];
    let expected = "  name     n\n  φ       12\n  longer   3\n";
    assert_eq!(table(heading, &rows), expected);
}

fn point(method: &str, value: f64, cpu: f64, energy: f64) -> Point {
    Point {
        method: method.to_owned(),
        value,
        outcome: Outcome::Ok,
        cpu,
        errors: [0.0, energy, 0.0],
    }
}

#[test]
fn a_lucky_step_does_not_make_a_method_the_fastest() {
    let points = [
        point("projected 4", 0.1, 1e-5, 1e-4),
        point("projected 4", 0.05, 2e-5, 1e-2),
        point("projected 4", 0.025, 4e-5, 1e-5),
        point("projected 4", 0.0125, 8e-5, 1e-6),
        point("two-level 2", 0.1, 6.73e-5, 1e-4),
        point("two-level 2", 0.05, 0.1121, 1e-5),
    ];
    let table = front(&points, &[-3, -9]);
    let rows: Vec<&str> = table.lines().skip(2).collect();
    assert_eq!(
        rows,
        [
            "| 1e-3 | `projected 4` | 0.04 | `two-level 2` | 0.0673 | 1.68 | `projected 4` | 0.04 | 1 |",
            "| 1e-9 | – | – | – | – | – | – | – | – |",
        ]
    );
}
