//! The method laboratory: stored results, interrupted measurements, and pictures of runs that failed.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use mbs_examples::laboratory::diagram::{MEASURES, draw};
use mbs_examples::laboratory::methods::{Control, entries};
use mbs_examples::laboratory::outcome::Outcome;
use mbs_examples::laboratory::paper::{
    self, Extent, RUN_COLUMNS, RUN_KEYS, SAMPLE_KEYS, Stores, figures, measure,
};
use mbs_examples::laboratory::stability::{Cell, Map};
use mbs_examples::laboratory::store::{Row, Store};
use mbs_examples::laboratory::tables::failed_cells;
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
    // Interrupted in the middle of the next row.
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

/// Every method of the runtime has to be in the charts.
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
    for entry in entries() {
        let fine = entry.settings(10.0, 1e-5);
        let coarse = entry.settings(10.0, 1e-3);
        assert_ne!(fine, coarse, "{}", entry.label);
        if entry.control == Control::Step {
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
    // The error of a failed run does not change the axis.
    let paths = |svg: &str| svg.matches("<path").count();
    assert_eq!(
        paths(&with),
        paths(&without) + 1,
        "one more marker, no more"
    );
    assert_eq!(Point::read(&row(&["s", "bdf"])), None);
}

/// A run that ended with an error of its own is no wrong motion that nobody noticed.
#[test]
fn cells_that_stopped_differ_from_those_that_went_on() {
    let map = Map {
        name: "m",
        title: "t",
        axis: "s",
        rows: vec!["bdf".to_owned()],
        columns: vec![0.01],
        trials: Box::new(|_, _| Vec::new()),
    };
    let cell = |stopped| {
        let cells = [
            "m", "bdf", "1e-2", "drift", "8", "3", stopped, "1e-3", "lost",
        ];
        Cell::read(&row(&cells)).expect("a cell")
    };
    let [all, some] = ["3", "2"].map(cell);
    assert!(all.is_stopped() && !some.is_stopped());
    assert!(failed_cells(&map, &[all]).contains("| bdf | drift | yes | 0.01 (3/8) |"));
    assert!(failed_cells(&map, &[some]).contains("| bdf | drift | no | 0.01 (3/8) |"));
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
        "work-precision",
        "pendulum",
        "--quick",
        "--out",
        out.to_str().expect("UTF-8"),
    ];
    let output = mbs(&arguments);
    assert!(output.status.success(), "{output:?}");
    let csv = out.join("work-precision.csv");
    let complete = fs::read_to_string(&csv).expect("a CSV");
    let methods = labels(&complete);
    assert!(methods.len() >= 3, "{complete}");
    for name in ["work-precision-pendulum-energy.svg", "work-precision.html"] {
        assert!(out.join(name).is_file(), "{name}");
    }
    // Interrupted after the first point, which is recognised by its time.
    let kept: Vec<&str> = complete.lines().take(3).collect();
    fs::write(&csv, kept.join("\n") + "\n").expect("a CSV");
    assert!(mbs(&arguments).status.success());
    let resumed = fs::read_to_string(&csv).expect("a CSV");
    assert_eq!(resumed.lines().nth(2), Some(kept[2]));
    // Whether a method has finer steps, too, depends on the times that were measured.
    assert_eq!(labels(&resumed), methods);
    // No point is measured twice.
    assert!(mbs(&arguments).status.success());
    let again = fs::read_to_string(&csv).expect("a CSV");
    for line in resumed.lines() {
        assert!(again.lines().any(|other| other == line), "{line}");
    }
}

/// The methods of the points of a chart.
fn labels(csv: &str) -> BTreeSet<&str> {
    let points = csv.lines().skip(2);
    points.filter_map(|line| line.split(',').nth(1)).collect()
}

/// Makes some runs of a figure of the paper.
fn take(name: &str, number: u8, part: f64, wanted: &[&str]) -> Stores {
    take_some(name, number, part, 1, wanted)
}

/// The same with one of so many instants only: a step ends at each of them.
fn take_some(name: &str, number: u8, part: f64, every: usize, wanted: &[&str]) -> Stores {
    let out = directory(name);
    let extent = Extent {
        part,
        patience: 60.0,
        members: 2,
    };
    let mut all = figures(extent);
    let mut figure = all.remove(usize::from(number) - 1);
    assert_eq!(figure.number, number);
    figure.runs.retain(|run| wanted.contains(&run.label));
    assert_eq!(figure.runs.len(), wanted.len(), "all of {wanted:?}");
    for run in &mut figure.runs {
        let kept = run.instants.iter().skip(every - 1).step_by(every);
        run.instants = kept.copied().collect();
    }
    let columns = figure.sample_columns();
    let columns: Vec<&str> = columns.iter().map(String::as_str).collect();
    let open = |name: &str, columns: &[&str], keys| {
        Store::open(&out.join(name), "a", columns, keys).expect("a store")
    };
    let mut stores = Stores {
        samples: open("samples.csv", &columns, SAMPLE_KEYS),
        runs: open("runs.csv", &RUN_COLUMNS, RUN_KEYS),
    };
    measure(&figure, extent, &mut stores, &mut |_| ()).expect("files");
    let svg = paper::draw(&figure, &stores);
    assert!(svg.contains(wanted[0]) && !svg.contains("NaN"), "{svg}");
    stores
}

fn samples<'a>(stores: &'a Stores, run: &str) -> Vec<&'a [String]> {
    let rows = stores.samples.rows().iter().filter(|row| row[0] == run);
    rows.map(|row| &row[1..]).collect()
}

/// The counts of section 7, and of rows that follow from others.
#[test]
fn the_papers_mechanisms_have_the_papers_counts() {
    let expected = [
        (1, 12, 11, 11),
        (3, 24, 26, 23),
        (6, 36, 36, 35),
        (7, 36, 36, 35),
    ];
    let all = figures(Extent::QUICK);
    for (number, velocities, rows, rank) in expected {
        let model = all[number - 1].subject.model;
        assert_eq!(model.velocities.len(), velocities, "figure {number}");
        assert_eq!(model.rows.len(), rows, "figure {number}");
        let found = model.mobility.map(|mobility| mobility.rank);
        assert_eq!(found, Some(rank), "figure {number}");
    }
}

/// The closed form of the pendulum compared with a simulation: heights and reactions.
#[test]
fn the_exact_pendulum_is_that_of_the_scene() {
    let stores = take("paper-1", 1, 0.003, &["exact", "two-level"]);
    let (exact, found) = (samples(&stores, "exact"), samples(&stores, "two-level"));
    assert!(exact.len() > 300);
    // The simulation has its start too. Columns: time, energy error, y, fx, fy.
    for (exact, found) in exact.iter().zip(&found[1..]) {
        assert_eq!(exact[0], found[0]);
        for (i, tolerance) in [(2, 1e-4), (3, 3e-3), (4, 3e-3)] {
            let [a, b]: [f64; 2] = [exact, found].map(|row| row[i].parse().expect("a number"));
            assert!((a - b).abs() < tolerance, "{exact:?} {found:?}");
        }
    }
}

/// If multipliers start from zero in each step, only the product of m̄ and ξ matters.
#[test]
fn a_tenth_of_the_masses_is_a_tenth_of_the_penalties() {
    let runs = ["two-level", "m̄; ξ = 10", "m̄/10; ξ = 100", "m̄ = 0; ξ = 100"];
    let stores = take("paper-2", 2, 0.01, &runs);
    // The penalties differ, as they should: time, energy error, step.
    let shown = |run| -> Vec<Vec<f64>> {
        let number = |cell: &String| cell.parse().unwrap_or(0.0);
        let rows = samples(&stores, run);
        rows.iter()
            .map(|row| row[..3].iter().map(number).collect())
            .collect()
    };
    let (scaled, tenth) = (shown(runs[1]), shown(runs[2]));
    assert_eq!(scaled.len(), 201);
    for (a, b) in scaled.iter().flatten().zip(tenth.iter().flatten()) {
        assert!((a - b).abs() <= 1e-3 * a.abs() + 1e-12, "{a} and {b}");
    }
    let outcome = |run: &str| stores.runs.find(&[run]).map(|row| row[2].clone());
    assert_eq!(outcome(runs[0]).as_deref(), Some("ok"));
    assert_eq!(outcome(runs[2]).as_deref(), Some("ok"));
    assert_eq!(outcome(runs[3]).as_deref(), Some("step underflow"));
}

/// Algorithm 1 with its default start passes two singular poses; with too small penalties it does not.
#[test]
fn figure_4_tells_who_passes_the_singular_pose() {
    let runs = ["two-level", "m-alf", "ξ = 1e4", "ξ = 1"];
    let stores = take_some("paper-4", 4, 0.03, 10, &runs);
    let run = |label: &str| stores.runs.find(&[label]).cloned().expect("it was run");
    let number = |cell: &String| cell.parse::<f64>().expect("a number");
    for (label, most) in [("two-level", 1e-3), ("m-alf", 1e-3), ("ξ = 1e4", 1e-2)] {
        let passed = run(label);
        assert_eq!(passed[2..4], ["ok", "1.35"], "{passed:?}");
        // The other branch is a metre away.
        let [energy, branch] = [8, 11].map(|i| number(&passed[i]));
        assert!(energy < most && branch < 1e-3, "{passed:?}");
        assert_eq!(passed[6], "0", "no step is rejected: {passed:?}");
    }
    let failed = run("ξ = 1");
    assert_eq!(failed[2], "step underflow");
    assert!(number(&failed[3]) < 0.5, "{failed:?}");
}

/// A run can be repeated from the settings in its row.
#[test]
fn runs_tell_their_settings() {
    // Settings are known before the first step.
    let stores = take_some(
        "paper-settings",
        4,
        0.001,
        100,
        &["ξ = 1e5", "alf3f-paper c_R = a"],
    );
    let settings = |label: &str| stores.runs.find(&[label]).expect("it was run")[1].clone();
    assert_eq!(settings("ξ = 1e5"), "ψ̇ 1e-2; ℜ 1e-2; ξ 1e5; h 1e-3 s");
    assert_eq!(
        settings("alf3f-paper c_R = a"),
        "ψ̇ 1e-2; ℜ 1e-2; ξ 1e3 to 1e5; c_R Euclidean; h 1e-3 s"
    );
}

#[test]
fn a_figure_resumes_from_its_runs() {
    let out = directory("paper-2-resumes");
    let out = out.to_str().expect("UTF-8");
    let arguments = ["paper", "--figure", "2", "--quick", "--out", out];
    let output = mbs(&arguments);
    assert!(output.status.success(), "{output:?}");
    let path = |name: &str| Path::new(out).join(name);
    let file = |name: &str| fs::read_to_string(path(name)).expect("a file");
    assert!(file("figure-2.svg").contains("effective masses"));
    let [samples, runs] = ["figure-2.csv", "figure-2-runs.csv"].map(file);
    assert!(samples.starts_with("# commit "), "{samples}");
    assert_eq!(runs.lines().count(), 2 + 19, "{runs}");
    // Interrupted in the last run: the others are recognised by their processor times.
    let kept: Vec<&str> = runs.lines().take(2 + 18).collect();
    fs::write(path("figure-2-runs.csv"), kept.join("\n") + "\n").expect("a CSV");
    assert!(mbs(&arguments).status.success());
    let resumed = file("figure-2-runs.csv");
    assert_eq!(resumed.lines().take(2 + 18).collect::<Vec<_>>(), kept);
    assert_eq!(resumed.lines().count(), 2 + 19, "{resumed}");
    // The run that is repeated may stop at another time.
    let again = file("figure-2.csv");
    let known = |text: &str| {
        let lines = text.lines().filter(|line| !line.starts_with("point mass"));
        lines.map(str::to_owned).collect::<Vec<_>>()
    };
    assert!(known(&samples) == known(&again), "samples of other runs");
    // No run is made twice.
    assert!(mbs(&arguments).status.success());
    let last = file("figure-2-runs.csv");
    assert!(last == resumed, "{last}\n{resumed}");
    let refused = mbs(&["paper", "--figure", "8", "--out", out]);
    assert_eq!(refused.status.code(), Some(1));
    let stderr = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(stderr.contains("--figure 1 to --figure 7"), "{stderr}");
}
