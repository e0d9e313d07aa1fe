//! The command line from outside: exit codes, messages, JSON and files. The tests take the scenes from the list, so
//! that every new scene is tested, too.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use serde_json::Value;

/// The keys that programs rely on.
const KEYS: &[&str] = &[
    "scene",
    "method",
    "order",
    "coordinates",
    "velocities",
    "rows",
    "rank",
    "steps",
    "stages",
    "cpu_s",
    "final_time_s",
    "energy_error_J",
    "holonomic_error",
    "velocity_error",
    "rejected_steps",
    "placed_steps",
    "events",
    "status",
    "final",
    "flow",
];

fn mbs(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_mbs"));
    command.args(arguments).output().expect("mbs starts")
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("UTF-8")
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).expect("UTF-8")
}

fn scenes() -> Vec<Value> {
    let output = mbs(&["list", "--json"]);
    assert!(output.status.success(), "{}", stderr(&output));
    let list: Value = serde_json::from_str(&stdout(&output)).expect("JSON");
    list.as_array().expect("an array").clone()
}

fn names() -> Vec<String> {
    let name = |scene: &Value| scene["scene"].as_str().expect("a name").to_owned();
    scenes().iter().map(name).collect()
}

/// Exit code 1, nothing on stdout, no panic, and all of `words` on stderr.
#[track_caller]
fn refused(arguments: &[&str], words: &[&str]) {
    let output = mbs(arguments);
    let message = stderr(&output);
    assert_eq!(output.status.code(), Some(1), "{arguments:?}: {message}");
    assert!(
        output.stdout.is_empty(),
        "{arguments:?}: {}",
        stdout(&output)
    );
    assert!(!message.contains("panicked"), "{arguments:?}: {message}");
    for word in words {
        assert!(
            message.contains(word),
            "{arguments:?}: no `{word}` in: {message}"
        );
    }
}

/// An empty directory of its own for each test.
fn directory(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).expect("a directory");
    path
}

fn text(path: &Path) -> &str {
    path.to_str().expect("UTF-8")
}

/// A time of a few steps, for every scene.
fn short(scene: &Value) -> String {
    (20.0 * scene["step_s"].as_f64().expect("a step")).to_string()
}

#[test]
fn list_names_every_scene() {
    let output = mbs(&["list"]);
    assert!(output.status.success());
    let table = stdout(&output);
    for name in names() {
        assert!(table.contains(&name), "no {name} in:\n{table}");
    }
}

#[test]
fn simulate_prints_one_object_with_all_keys() {
    for scene in scenes() {
        let name = scene["scene"].as_str().expect("a name");
        let time = short(&scene);
        let output = mbs(&["simulate", name, "--time", &time, "--order", "2", "--json"]);
        assert!(output.status.success(), "{name}: {}", stderr(&output));
        let run: Value = serde_json::from_str(&stdout(&output)).expect("JSON");
        for key in KEYS {
            assert!(
                run.get(key).is_some_and(|v| !v.is_null()),
                "{name}: no {key} in {run:#}"
            );
        }
        assert_eq!(run["scene"], *name);
        assert_eq!(run["status"], "ok");
        assert_eq!(run["final_time_s"], time.parse::<f64>().expect("a number"));
        for key in ["coordinates", "rows", "rank"] {
            assert_eq!(run[key], scene[key], "{name}: {key}");
        }
        for output in scene["outputs"].as_array().expect("an array") {
            let output = output.as_str().expect("a name");
            // `p1.x` and `p1.y` are the components of `p1: [x, y]`.
            let value = match output.split_once('.') {
                None => &run["final"][output],
                Some((vector, "x")) => &run["final"][vector][0],
                Some((vector, _)) => &run["final"][vector][1],
            };
            assert!(value.is_f64(), "{name}: no {output} in {run:#}");
        }
    }
}

/// Without options a run has an accuracy; a step, a method or an order is taken as it is.
#[test]
fn a_run_has_an_accuracy_unless_told_otherwise() {
    let run = |more: &[&str]| -> Value {
        let output = mbs(&[&["simulate", "slider-crank", "--time", "1", "--json"], more].concat());
        assert!(output.status.success(), "{}", stderr(&output));
        serde_json::from_str(&stdout(&output)).expect("JSON")
    };
    let chosen = run(&[]);
    assert_eq!(chosen["accuracy"], 1e-6);
    assert_eq!(chosen["method"], "projected");
    assert_eq!(chosen["method_changes"], Value::Array(Vec::new()));
    assert!(chosen["energy_error_J"].as_f64().expect("a number") < 1e-5);
    assert_eq!(chosen["final"], run(&["--accuracy", "1e-6"])["final"]);
    for (more, step, order) in [
        (["--step", "0.002"], 0.002, 2),
        (["--order", "4"], 0.001, 4),
        (["--method", "two-level"], 0.001, 2),
    ] {
        let run = run(&more);
        assert!(run["accuracy"].is_null() && run["tolerance"].is_null());
        assert_eq!(run["method"], "two-level");
        assert_eq!(
            (&run["step_s"], &run["order"]),
            (&step.into(), &order.into())
        );
    }
    let text = stdout(&mbs(&["simulate", "slider-crank", "--time", "1"]));
    assert!(text.contains("chosen for an accuracy of 1e-6"), "{text}");
    assert!(text.contains("for samples between them"), "{text}");
}

#[test]
fn simulate_reports_singular_poses() {
    let output = mbs(&["simulate", "slider-crank", "--time", "3.5", "--json"]);
    let run: Value = serde_json::from_str(&stdout(&output)).expect("JSON");
    let events = run["events"].as_array().expect("an array");
    assert_eq!(events.len(), 4);
    let first = events[0]["time"].as_f64().expect("a time");
    assert!((first - 0.3917).abs() < 1e-3, "{run:#}");
    assert!(events[0]["sigma_min"].as_f64().expect("a number") < 0.02);
    let joints = events[0]["joints"].as_array().expect("an array");
    assert!(joints.contains(&"crank".into()) && joints.contains(&"rod".into()));
    let text = stdout(&mbs(&["simulate", "slider-crank", "--time", "3.5"]));
    // With as many decimals as a hundredth of a step has.
    assert!(text.contains("singular     t = 0.392 s") && text.contains("and 1 more"));
    assert!(!stdout(&mbs(&["simulate", "pendulum"])).contains("singular"));
}

#[test]
fn simulate_writes_its_files_and_says_where() {
    for scene in scenes() {
        let name = scene["scene"].as_str().expect("a name");
        let out = directory(&format!("files-{name}"));
        let output = mbs(&[
            "simulate",
            name,
            "--time",
            &short(&scene),
            "--order",
            "2",
            "--out",
            text(&out),
        ]);
        assert!(output.status.success(), "{name}: {}", stderr(&output));
        assert!(stdout(&output).contains(text(&out)));

        let table = std::fs::read_to_string(out.join("trajectory.csv")).expect("a table");
        let mut lines = table.lines();
        let header = lines.next().expect("a header");
        assert!(header.starts_with("time_s,"), "{name}: {header}");
        let columns = header.split(',').count();
        let rows: Vec<&str> = lines.collect();
        assert_eq!(rows.len(), 21, "{name}");
        for row in rows {
            let cells: Vec<f64> = row
                .split(',')
                .map(|c| c.parse().expect("a number"))
                .collect();
            assert_eq!(cells.len(), columns, "{name}: {row}");
        }
        for picture in ["energy.svg", "constraints.svg"] {
            let picture = std::fs::read_to_string(out.join(picture)).expect("a picture");
            assert!(picture.starts_with("<svg") && picture.trim_end().ends_with("</svg>"));
        }
        let motion = std::fs::read_to_string(out.join("motion.html")).expect("an animation");
        assert!(motion.trim_end().ends_with("</html>"), "{name}");
        assert!(
            !motion.contains("http"),
            "{name}: the animation needs no network"
        );
    }
}

/// A killed run leaves whole rows, and no picture that looks complete.
#[test]
fn a_killed_run_leaves_whole_rows() {
    let out = directory("killed");
    let mut child = Command::new(env!("CARGO_BIN_EXE_mbs"))
        .args(["simulate", "pendulum", "--time", "10000", "--step", "1e-5"])
        .args(["--out", text(&out)])
        .stderr(std::process::Stdio::null())
        .spawn()
        .expect("mbs starts");
    std::thread::sleep(std::time::Duration::from_millis(700));
    child.kill().expect("it runs");
    child.wait().expect("it ends");
    let table = std::fs::read_to_string(out.join("trajectory.csv")).expect("a table");
    assert!(table.ends_with('\n'));
    let columns = |row: &str| row.split(',').count();
    let wide = table.lines().next().map(columns);
    for row in table.lines().filter(|row| !row.starts_with('#')) {
        assert_eq!(Some(columns(row)), wide, "{row}");
    }
    assert!(!out.join("motion.html").exists());
}

/// Two runs into one directory: the table is that of one run, and the other one says that its own is lost.
#[test]
fn two_runs_into_one_directory_do_not_mix() {
    let out = directory("twice");
    let run = |time: &str| {
        Command::new(env!("CARGO_BIN_EXE_mbs"))
            .args(["simulate", "pendulum", "--step", "1e-5", "--time", time])
            .args(["--out", text(&out)])
            .stdout(std::process::Stdio::null())
            .stderr(std::process::Stdio::piped())
            .spawn()
            .expect("mbs starts")
    };
    let first = run("20");
    std::thread::sleep(std::time::Duration::from_millis(200));
    let second = run("0.1");
    let [first, second] = [first, second].map(|run| run.wait_with_output().expect("it ends"));
    assert!(second.status.success(), "{}", stderr(&second));
    assert!(stderr(&first).contains("--out"), "{}", stderr(&first));
    let table = std::fs::read_to_string(out.join("trajectory.csv")).expect("a table");
    let times: Vec<f64> = table
        .lines()
        .skip(1)
        .map(|row| {
            row.split(',')
                .next()
                .expect("a cell")
                .parse()
                .expect("a time")
        })
        .collect();
    assert!(times.windows(2).all(|pair| pair[0] < pair[1]));
    assert_eq!(times.last(), Some(&0.1));
}

#[test]
fn json_leaves_no_files() {
    for name in names() {
        let here = directory(&format!("json-{name}"));
        let mut command = Command::new(env!("CARGO_BIN_EXE_mbs"));
        let command = command.args(["simulate", &name, "--time", "0.001", "--json"]);
        let output = command.current_dir(&here).output().expect("mbs starts");
        assert!(output.status.success(), "{name}: {}", stderr(&output));
        assert_eq!(
            std::fs::read_dir(&here).expect("a directory").count(),
            0,
            "{name}"
        );
    }
}

#[test]
fn every_parameter_can_be_set() {
    for scene in scenes() {
        let name = scene["scene"].as_str().expect("a name");
        let time = short(&scene);
        let mut arguments = vec!["simulate", name, "--time", &time, "--json"];
        let settings: Vec<String> = ["parameters", "inputs"]
            .iter()
            .flat_map(|kind| scene[kind].as_array().expect("an array"))
            .map(|q| {
                format!(
                    "--set={}={}",
                    q["name"].as_str().expect("a name"),
                    q["default"]
                )
            })
            .collect();
        arguments.extend(settings.iter().map(String::as_str));
        let output = mbs(&arguments);
        assert!(output.status.success(), "{name}: {}", stderr(&output));
    }
}

#[test]
fn parameters_that_are_not_finite_are_refused() {
    for scene in scenes() {
        let name = scene["scene"].as_str().expect("a name");
        for parameter in scene["parameters"].as_array().expect("an array") {
            let set = format!("{}=nan", parameter["name"].as_str().expect("a name"));
            refused(
                &["simulate", name, "--set", &set, "--json"],
                &["nan", "finite"],
            );
        }
    }
}

#[test]
fn explain_shows_coordinates_and_rows() {
    for name in names() {
        let output = mbs(&["explain", &name]);
        assert!(output.status.success(), "{name}: {}", stderr(&output));
        let text = stdout(&output);
        for section in ["Coordinates", "Structure", "flow"] {
            assert!(text.contains(section), "{name}: no {section} in:\n{text}");
        }
    }
}

#[test]
fn wrong_scenes_are_refused_with_the_right_ones() {
    refused(
        &["simulate", "no-such-scene"],
        &["no scene", "no-such-scene"],
    );
    refused(&["explain", "no-such-scene"], &["no scene"]);
    for name in names() {
        let misspelt = format!("{name}x");
        refused(
            &["simulate", &misspelt],
            &["did you mean", &format!("`{name}`")],
        );
    }
}

#[test]
fn wrong_numbers_are_refused() {
    for name in names() {
        for option in ["--time", "--step"] {
            for value in ["0", "-1", "nan", "inf", "abc", ""] {
                refused(&["simulate", &name, option, value, "--json"], &[option]);
            }
        }
        refused(
            &["simulate", &name, "--time", "1", "--step", "1e-50"],
            &["--step", "longer"],
        );
        // None of them would end.
        for (value, told) in [
            ("1e-322", "1e-100 to 1e100"),
            ("1e300", "1e-100 to 1e100"),
            ("1e20", "--time 1e20 is too long"),
        ] {
            refused(&["simulate", &name, "--time", value], &["--time", told]);
        }
    }
}

#[test]
fn what_is_not_built_is_refused_with_what_is() {
    for name in names() {
        refused(
            &["simulate", &name, "--order", "3"],
            &["order 3", "--order 2, 4, 6 and 8"],
        );
        refused(
            &["simulate", &name, "--order", "-2"],
            &["order -2", "--order 2, 4, 6 and 8"],
        );
        for tolerance in ["0", "-1", "nan", "1", "1e-20", "abc", ""] {
            refused(
                &["simulate", &name, "--tolerance", tolerance],
                &["--tolerance"],
            );
        }
        refused(
            &[
                "simulate",
                &name,
                "--tolerance",
                "1e-6",
                "--method",
                "alf3f-paper",
            ],
            &["two-level"],
        );
        refused(
            &["simulate", &name, "--method", "euler"],
            &["euler", "two-level", "generalized-alpha"],
        );
        refused(
            &["simulate", &name, "--method", "two-levels"],
            &["did you mean `two-level`"],
        );
    }
}

#[test]
fn wrong_settings_are_refused() {
    for name in names() {
        refused(&["simulate", &name, "--set", "length"], &["name=value"]);
        refused(
            &["simulate", &name, "--set", "no_such=1"],
            &["no parameter", "no_such"],
        );
    }
}

#[test]
fn directories_that_cannot_be_made_are_refused() {
    let file = directory("occupied").join("file");
    std::fs::write(&file, "").expect("a file");
    let below = file.join("below");
    for name in names() {
        let arguments = ["simulate", &name, "--time", "0.001", "--out", text(&below)];
        refused(&arguments, &["cannot write", "--out"]);
    }
}

#[test]
fn wrong_usage_exits_with_one() {
    refused(&[], &["Usage"]);
    refused(&["no-such-command"], &["no-such-command"]);
    refused(&["simulate"], &["<SCENE>"]);
    refused(&["list", "--no-such-option"], &["--no-such-option"]);
}

#[test]
fn help_is_no_failure() {
    for arguments in [&["--help"][..], &["simulate", "--help"], &["--version"]] {
        let output = mbs(arguments);
        assert_eq!(output.status.code(), Some(0), "{arguments:?}");
        assert!(
            output.stderr.is_empty() && !output.stdout.is_empty(),
            "{arguments:?}"
        );
    }
}

#[test]
fn a_closed_pipe_is_no_panic() {
    let mut commands = vec![vec!["list".to_owned(), "--json".to_owned()]];
    commands.extend(
        names()
            .into_iter()
            .map(|name| vec!["explain".to_owned(), name]),
    );
    for arguments in commands {
        let mut command = Command::new(env!("CARGO_BIN_EXE_mbs"));
        let command = command
            .args(&arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        let mut child = command.spawn().expect("mbs starts");
        drop(child.stdout.take());
        let output = child.wait_with_output().expect("mbs ends");
        assert!(
            !stderr(&output).contains("panicked"),
            "{arguments:?}: {}",
            stderr(&output)
        );
        assert!(output.status.success(), "{arguments:?}");
    }
}
