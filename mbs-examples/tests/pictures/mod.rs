//! Diagrams and the animation of unusual runs: empty, without motion, with values that are not finite. And the live
//! figures of the book.

mod browser;
mod live;

use mbs_examples::plot;
use mbs_runtime::output::Frame;
use mbs_runtime::output::csv::CsvWriter;
use mbs_runtime::output::motion::write_motion;
use mbs_runtime::{Coordinate, Energy, Model, Quantity, Reaction, Segment, Structure, World};
use serde_json::Value;

const MODEL: Model = Model {
    name: "Hostile",
    doc: "A text with </script>, \"quotes\" and a \\ in it.",
    declaration: "",
    world: World::Planar,
    up: [0.0, 1.0, 0.0],
    coordinates: &[Coordinate {
        name: "bar.b.x",
        unit: "m",
    }],
    velocities: &[Coordinate {
        name: "bar.b.x'",
        unit: "m/s",
    }],
    rows: &[],
    parts: &[],
    parameters: &[],
    inputs: &[],
    outputs: &[Quantity {
        name: "omega",
        unit: "rad/s",
        default: 0.0,
        doc: "",
    }],
    events: &[],
    points: &["bar.a", "bar.b"],
    marks: 0,
    segments: &[Segment {
        part: "bar",
        from: 0,
        to: 1,
    }],
    reactions: &[
        Reaction {
            joint: "pivot",
            component: "fx",
            unit: "N",
            at: Some(0),
        },
        Reaction {
            joint: "pivot",
            component: "fy",
            unit: "N",
            at: Some(0),
        },
    ],
    reductions: &[],
    operations: &[],
    structure: Structure {
        constant_mass: true,
        velocity_forces: false,
        position_forces: false,
        time_dependent: false,
        rheonomic: false,
        smooth: false,
        holonomic_rows: 0,
        rotations: 0,
    },
    mobility: None,
    formulation: "Natural",
    candidates: &[],
};

fn frame(time: f64, x: f64, kinetic: f64, error: f64) -> Frame {
    let mut energy = Energy::default();
    (energy.kinetic, energy.error) = (kinetic, error);
    Frame {
        time,
        coordinates: vec![x],
        velocities: vec![-x],
        outputs: vec![0.1 * x],
        points: vec![[0.0; 3], [x, 0.5, 0.0]],
        reactions: vec![10.0, x],
        energy,
        holonomic_error: error,
        velocity_error: 0.0,
    }
}

/// Unusual runs; drawing them must not fail.
fn runs() -> Vec<Vec<Frame>> {
    vec![
        vec![],
        vec![frame(0.0, 1.0, 2.0, 0.0)],
        vec![frame(0.0, 1.0, 0.0, 0.0), frame(1.0, 1.0, 0.0, 0.0)],
        vec![
            frame(0.0, 1.0, 2.0, 1e-16),
            frame(0.1, f64::NAN, f64::INFINITY, f64::NAN),
        ],
        vec![
            frame(0.0, 1e-12, 1e-20, 1e-300),
            frame(1e6, 1e12, 1e30, 1e25),
        ],
        (0..5000)
            .map(|i| frame(1e-3 * f64::from(i), f64::from(i).sin(), 1.0, 1e-9))
            .collect(),
    ]
}

fn motion(frames: &[Frame]) -> String {
    let mut page = Vec::new();
    write_motion(&mut page, &MODEL, frames, "A <title>", Some("no reason")).expect("a page");
    String::from_utf8(page).expect("UTF-8")
}

fn data(page: &str) -> Value {
    let (_, rest) = page.split_once("const data = ").expect("the data begin");
    let (data, _) = rest.split_once("};\n").expect("the data end");
    serde_json::from_str(&format!("{data}}}")).expect("JSON")
}

#[test]
fn diagrams_survive_every_run() {
    for frames in runs() {
        for picture in [
            plot::energy("A & <b>", &frames),
            plot::constraints("", &frames),
        ] {
            let picture = picture.expect("a picture");
            assert!(picture.starts_with("<svg") && picture.trim_end().ends_with("</svg>"));
            assert!(
                !picture.contains("<b>") && !picture.contains("NaN"),
                "{picture}"
            );
        }
    }
}

#[test]
fn animations_hold_all_frames_or_a_selection_with_both_ends() {
    for frames in runs() {
        let data = data(&motion(&frames));
        let time = data["time"].as_array().expect("an array");
        // A constant series is one number.
        let columns = [&data["tracks"][1][0], &data["outputs"][0][2]];
        for column in columns.into_iter().filter_map(Value::as_array) {
            assert_eq!(column.len(), time.len());
        }
        assert!(time.len() <= 2001 && time.len() >= frames.len().min(1000));
        if let (Some(first), Some(last)) = (frames.first(), frames.last()) {
            let near = |value: &Value, wanted: f64| {
                (value.as_f64().expect("a number") - wanted).abs() <= 1e-5 * last.time
            };
            assert!(near(&time[0], first.time) && near(&time[time.len() - 1], last.time));
        }
    }
}

#[test]
fn text_stays_text_in_the_animation() {
    let page = motion(&runs()[1]);
    assert_eq!(page.matches("</script>").count(), 1);
    let data = data(&page);
    assert_eq!(data["doc"], MODEL.doc);
    assert_eq!(data["title"], "A <title>");
    assert_eq!(data["spatial"], false);
}

#[test]
fn tables_read_back_to_the_same_bits_and_show_where_a_run_stopped() {
    let frames = [
        frame(0.0, 1.0 / 3.0, 2.0, -0.0),
        frame(0.1, 1e-300, 2.0, 5e-324),
    ];
    let mut table = CsvWriter::new(Vec::new(), &MODEL).expect("a table");
    for frame in &frames {
        table.write(frame).expect("a row");
    }
    table.stopped(0.1, "two\nlines").expect("a mark");
    let text = String::from_utf8(table.finish().expect("the table")).expect("UTF-8");
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(
        lines[0],
        "time_s,omega_rad_per_s,bar.b.x_m,bar.b.x_dot_m_per_s,kinetic_J,potential_J,energy_error_J,\
         holonomic_error,velocity_error"
    );
    for (line, frame) in lines[1..3].iter().zip(&frames) {
        let cells: Vec<f64> = line
            .split(',')
            .map(|c| c.parse().expect("a number"))
            .collect();
        assert_eq!(cells.len(), lines[0].split(',').count());
        assert_eq!(cells[2].to_bits(), frame.coordinates[0].to_bits());
        assert_eq!(cells[6].to_bits(), frame.energy.error.to_bits());
    }
    assert_eq!(lines[3], "# stopped at t = 0.1 s: two lines");
}

#[test]
fn points_that_go_the_same_way_are_written_once() {
    const TWO: Model = Model {
        points: &["bar.a", "bar.b", "rod.a"],
        ..MODEL
    };
    let frames: Vec<Frame> = (0..10)
        .map(|i| {
            let mut frame = frame(0.1 * f64::from(i), f64::from(i), 1.0, 0.0);
            frame.points.push(frame.points[1]);
            frame.points[2][0] += 1e-9;
            frame
        })
        .collect();
    let mut page = Vec::new();
    write_motion(&mut page, &TWO, &frames, "", None).expect("a page");
    let data = data(&String::from_utf8(page).expect("UTF-8"));
    assert_eq!(data["track"], serde_json::json!([0, 1, 1]));
    assert_eq!(data["tracks"][0], serde_json::json!([0, 0]));
    assert_eq!(data["tracks"][1][1], 0.5);
    assert_eq!(data["tracks"][1][0][9], 9);
}
