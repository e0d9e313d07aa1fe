//! The method laboratory: what it keeps, what it resumes, and what it draws of runs that failed.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use mbs_examples::laboratory::diagram::{MEASURES, draw};
use mbs_examples::laboratory::methods::{Control, entries};
use mbs_examples::laboratory::outcome::Outcome;
use mbs_examples::laboratory::store::{Row, Store};
use mbs_examples::laboratory::work_precision::Point;
use mbs_runtime::Method;

/// An empty directory of its own.
fn directory(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).expect("a directory");
    path
}

fn row(cells: &[&str]) -> Row {
    cells.iter().map(|cell| (*cell).to_owned()).collect()
}

fn mbs(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_mbs"));
    command.args(arguments).output().expect("mbs starts")
}

#[test]
fn a_store_goes_on_where_it_was_interrupted() {
    let path = directory("store-resumes").join("points.csv");
    let columns = ["scene", "step", "error"];
    let mut store = Store::open(&path, "commit a; full", &columns, 2).expect("a store");
    store.put(row(&["pendulum", "1e-2", "0.5"])).expect("a row");
    store
        .put(row(&["pendulum", "1e-3", "0.25"]))
        .expect("a row");
    store
        .put(row(&["pendulum", "1e-2", "0.125"]))
        .expect("a row");
    drop(store);
    // Killed while it wrote the next row.
    let text = fs::read_to_string(&path).expect("a file");
    fs::write(&path, text + "bricard,1e-2,0.0").expect("a file");

    let store = Store::open(&path, "commit a; full", &columns, 2).expect("a store");
    assert_eq!(
        store.rows(),
        [
            row(&["pendulum", "1e-2", "0.125"]),
            row(&["pendulum", "1e-3", "0.25"])
        ]
    );
    assert_eq!(store.find(&["pendulum", "1e-3"]), Some(&store.rows()[1]));
    assert_eq!(store.find(&["bricard", "1e-2"]), None);
    assert_eq!(
        fs::read_to_string(&path).expect("a file"),
        "# commit a; full\nscene,step,error\npendulum,1e-2,0.125\npendulum,1e-3,0.25\n"
    );
}

#[test]
fn points_of_another_commit_are_not_kept() {
    let path = directory("store-restarts").join("points.csv");
    let columns = ["scene", "error"];
    let mut store = Store::open(&path, "commit a", &columns, 1).expect("a store");
    store.put(row(&["pendulum", "0.5"])).expect("a row");
    drop(store);
    let store = Store::open(&path, "commit b", &columns, 1).expect("a store");
    assert!(store.rows().is_empty());
}

#[test]
fn messages_do_not_break_rows() {
    let path = directory("store-messages").join("points.csv");
    let mut store = Store::open(&path, "a", &["scene", "detail"], 1).expect("a store");
    store
        .put(row(&["pendulum", "row `a`, at\nt = 1 s"]))
        .expect("a row");
    drop(store);
    let store = Store::open(&path, "a", &["scene", "detail"], 1).expect("a store");
    assert_eq!(store.rows(), [row(&["pendulum", "row `a`; at t = 1 s"])]);
}

#[test]
fn outcomes_have_names() {
    for outcome in Outcome::ALL {
        assert_eq!(Outcome::by_name(outcome.name()), Some(outcome));
    }
    assert_eq!(Outcome::by_name("fine"), None);
}

/// A method that is added to the runtime has to come into the charts.
#[test]
fn every_method_is_compared() {
    let entries = entries();
    for &name in Method::NAMES {
        assert!(
            entries.iter().any(|entry| entry.method.name() == name),
            "{name} is in no chart"
        );
    }
    for (i, entry) in entries.iter().enumerate() {
        let same = entries.iter().position(|e| e.label == entry.label);
        assert_eq!(same, Some(i), "two methods are called {}", entry.label);
    }
}

#[test]
fn controls_reach_the_settings() {
    let model = mbs_examples::scenes::scenes()[0].model;
    for entry in entries() {
        let fine = entry.settings(model, 10.0, 1e-5);
        let coarse = entry.settings(model, 10.0, 1e-3);
        assert_ne!(fine, coarse, "{}", entry.label);
        if entry.control() == Control::Step {
            assert_eq!(fine.step, 1e-5, "{}", entry.label);
        }
    }
}

#[test]
fn failed_runs_are_drawn_as_failed() {
    let ok = row(&[
        "s",
        "bdf",
        "tolerance",
        "1e-2",
        "1",
        "ok",
        "1e-3",
        "5",
        "1e-2",
        "1e-3",
        "1e-4",
        "",
    ]);
    let failed = row(&[
        "s",
        "bdf",
        "tolerance",
        "1e-1",
        "1",
        "wrong branch",
        "1e-4",
        "5",
        "1.5",
        "3.0",
        "2.0",
        "1.5e0 from the reference",
    ]);
    let points: Vec<Point> = [&ok, &failed].into_iter().filter_map(Point::read).collect();
    assert_eq!(points[1].outcome, Outcome::WrongBranch);
    assert_eq!(points[0].errors, [1e-2, 1e-3, 1e-4]);
    let with = draw("t", "n", &["bdf"], &points, MEASURES[0]);
    let without = draw("t", "n", &["bdf"], &points[..1], MEASURES[0]);
    assert!(with.contains("bdf (1 ✗)") && !without.contains('✗'));
    // The error of a failed run does not stretch the axis.
    let paths = |svg: &str| svg.matches("<path").count();
    assert_eq!(
        paths(&with),
        paths(&without) + 1,
        "one more marker, no more"
    );
    assert_eq!(Point::read(&row(&["s", "bdf"])), None);
}

#[test]
fn unknown_charts_scenes_and_maps_are_refused() {
    for (arguments, word) in [
        (&["chart", "speed"][..], "work-precision"),
        (
            &["chart", "work-precision", "pendulm"],
            "did you mean `pendulum`?",
        ),
        (
            &["chart", "stability", "penalti"],
            "did you mean `penalty`?",
        ),
    ] {
        let out = directory("refused");
        let out = out.to_str().expect("UTF-8");
        let output = mbs(&[arguments, &["--out", out]].concat());
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert!(stderr.contains(word), "{arguments:?}: {stderr}");
    }
}

#[test]
fn a_chart_resumes_from_its_points() {
    let out = directory("chart-resumes");
    let arguments = [
        "chart",
        "stability",
        "mass-scale",
        "--quick",
        "--out",
        out.to_str().expect("UTF-8"),
    ];
    let output = mbs(&arguments);
    assert!(output.status.success(), "{output:?}");
    let csv = out.join("stability.csv");
    let complete = fs::read_to_string(&csv).expect("a CSV");
    let cells = complete.lines().count() - 2;
    assert!(cells >= 3, "{complete}");
    for name in ["stability-mass-scale.svg", "stability.html"] {
        assert!(out.join(name).is_file(), "{name}");
    }
    // Interrupted after the first point, which is told by its time.
    let kept: Vec<&str> = complete.lines().take(3).collect();
    fs::write(&csv, kept.join("\n") + "\n").expect("a CSV");
    assert!(mbs(&arguments).status.success());
    let resumed = fs::read_to_string(&csv).expect("a CSV");
    assert_eq!(resumed.lines().nth(2), Some(kept[2]));
    assert_eq!(resumed.lines().count() - 2, cells);
    // And nothing is measured twice.
    assert!(mbs(&arguments).status.success());
    assert_eq!(fs::read_to_string(&csv).expect("a CSV"), resumed);
}
