//! The README and the book have the measured numbers, and the programs still measure the same numbers.

use mbs_examples::pages::block::find;
use mbs_examples::pages::data::Data;
use mbs_examples::pages::orders;
use mbs_examples::pages::registry::{ENTRIES, Entry, Place, block, file};
use mbs_examples::pages::scene_runs::{self, COLUMNS, REPEATABLE, reference, run, scene};
use mbs_examples::pages::update::updates;
use mbs_runtime::Settings;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

#[test]
fn pages_are_what_their_data_render_to() {
    const COMMAND: &str = "cargo mbs pages";
    let updates = updates(&root(), ENTRIES).unwrap_or_else(|problems| panic!("{problems}"));
    let stale: Vec<String> = updates
        .iter()
        .filter(|update| !update.stale.is_empty())
        .map(|update| format!("{}: {}", update.path, update.stale.join(", ")))
        .collect();
    let stale = stale.join("\n");
    assert!(
        stale.is_empty(),
        "stale; `{COMMAND}` at the top of the repository writes\n{stale}"
    );
}

/// A repository of its own with one page and one file of results.
fn repository(name: &str, page: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let results = root.join("book/src/results");
    fs::create_dir_all(&results).expect("a folder");
    fs::write(root.join("README.md"), page).expect("a page");
    fs::write(
        results.join("answer.csv"),
        "# commit a; machine b; c\nname,value\nanswer,42\n",
    )
    .expect("results");
    root
}

fn answer(data: &Data) -> Result<String, String> {
    let table = data.table("answer.csv")?;
    let value = table.find(&[("name", "answer")])?.number("value")?;
    Ok(format!("It is {value} ({}).", table.source()))
}

const ANSWER: &[Entry] = &[block("README.md", "answer", answer)];

#[test]
fn a_stale_block_is_named_and_written() {
    let page = "a\n\n<!-- written by `mbs pages`: answer -->\nold\n<!-- end of answer -->\nb\n";
    let root = repository("pages-stale", page);
    let found = updates(&root, ANSWER).expect("it renders");
    assert_eq!(found[0].path, "README.md");
    assert_eq!(found[0].stale, ["answer"]);
    assert_eq!(
        found[0].new,
        "a\n\n<!-- written by `mbs pages`: answer -->\n\nIt is 42 (commit a, machine b).\n\n<!-- end of answer -->\nb\n"
    );
    fs::write(root.join("README.md"), &found[0].new).expect("a page");
    let again = updates(&root, ANSWER).expect("it renders");
    assert!(again[0].stale.is_empty());
}

#[test]
fn a_block_may_be_a_part_of_a_line() {
    let page = "So: <!-- written by `mbs pages`: answer -->?<!-- end of answer --> It is known.\n";
    let found = updates(&repository("pages-line", page), ANSWER).expect("it renders");
    assert!(
        found[0]
            .new
            .contains("answer -->It is 42 (commit a, machine b).<!--")
    );
}

#[test]
fn blocks_and_renderers_belong_together() {
    let complaint = |name: &str, page: &str, entries: &[Entry]| {
        updates(&repository(name, page), entries).expect_err("it is wrong")
    };
    assert_eq!(
        complaint("pages-no-block", "nothing\n", ANSWER),
        "README.md: no block `answer`, for which there is a renderer"
    );
    let page = "<!-- written by `mbs pages`: question --><!-- end of question -->";
    assert_eq!(
        complaint("pages-no-renderer", page, &[]),
        "README.md: block `question`: has no renderer on this page"
    );
    let page = "<!-- written by `mbs pages`: answer --> and so on";
    let wrong = complaint("pages-no-end", page, ANSWER);
    assert!(
        wrong.contains("block `answer` has no `<!-- end of answer -->`"),
        "{wrong}"
    );
    let missing = &[file("book/src/results/x.txt", |data| {
        data.table("no.csv").map(|t| t.note)
    })];
    let wrong = complaint("pages-no-data", "nothing\n", missing);
    assert!(
        wrong.starts_with("book/src/results/x.txt: book/src/results/no.csv: "),
        "{wrong}"
    );
    let nowhere = root().join("no such folder");
    let wrong = updates(&nowhere, ANSWER).expect_err("it is wrong");
    let folder = nowhere.join("book/src");
    assert!(
        wrong.starts_with(&format!("{}: ", folder.display())),
        "{wrong}"
    );
}

#[test]
fn blocks_do_not_nest() {
    let one = "<!-- written by `mbs pages`: a -->x<!-- end of a -->";
    assert_eq!(find(&format!("{one} and {one}")).expect("two").len(), 2);
    let inside = format!("<!-- written by `mbs pages`: b -->{one}<!-- end of b -->");
    assert!(find(&inside).is_err());
}

#[test]
fn no_text_is_written_twice() {
    for (i, entry) in ENTRIES.iter().enumerate() {
        let same = |other: &Entry| other.place == entry.place;
        assert!(!ENTRIES[..i].iter().any(same), "{:?}", entry.place);
        let (Place::Block { page: path, .. } | Place::File(path)) = entry.place;
        assert!(root().join(path).exists(), "{path}");
    }
}

#[test]
fn the_command_says_what_is_stale() {
    let mbs = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_mbs"));
        command.args(arguments).output().expect("mbs starts")
    };
    let output = mbs(&["pages", "--check", "--root", &root().to_string_lossy()]);
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{complaint}");
    let empty = repository("pages-empty", "nothing\n");
    let output = mbs(&["pages", "--check", "--root", &empty.to_string_lossy()]);
    assert!(!output.status.success());
    assert!(String::from_utf8_lossy(&output.stderr).contains("no block `scenes`"));
}

/// Two results of a run, before and now. Round-off may differ on another machine.
fn agree(before: f64, now: f64, round_off: f64) -> bool {
    (before - now).abs() <= 0.05 * before.abs().max(now.abs()) + round_off
}

/// Scenes with few rows and at most ten thousand steps. The others of the table (the chains of four-bars, `bricard-reference`
/// with 30 rows, `andrews` with fifty thousand steps) take longer, or are of the same kind as one of these.
#[test]
fn quick_scenes_run_as_the_table_says() {
    const QUICK: [&str; 8] = [
        "pendulum",
        "slider-crank",
        "double-four-bar",
        "chaplygin-sleigh",
        "driven-slider-crank",
        "heavy-top",
        "bricard",
        "cardan-shaft",
    ];
    let table = Data::new(&root()).table(scene_runs::FILE).expect("results");
    for name in QUICK {
        let line = table.find(&[("scene", name)]).expect("a row");
        let row = run(scene(name).expect("a scene")).expect("it runs");
        for (column, now) in COLUMNS.iter().zip(&row) {
            let before = line.text(column).expect("a column");
            if REPEATABLE.contains(column) && !now.is_empty() {
                let [before, now] = [before, now].map(|text| text.parse().expect("a number"));
                assert!(
                    agree(before, now, 1e-12),
                    "{name}, {column}: {before:e}, now {now:e}"
                );
            } else if ["steps", "stages", "iterations"].contains(column) {
                let [before, now] = [before, now].map(|text| text.parse().expect("a count"));
                assert!(
                    agree(before, now, 0.0),
                    "{name}, {column}: {before}, now {now}"
                );
            } else if *column != "time_us" {
                assert_eq!(before, now, "{name}, {column}");
            }
        }
    }
}

/// Steps of 0.025 s at orders 4 to 8; energy errors near round-off vary with it.
#[test]
fn orders_are_as_the_table_says() {
    let table = Data::new(&root()).table(orders::FILE).expect("results");
    for case in orders::SCENES {
        let reference = reference(case.0).expect("readable").expect("a reference");
        for order in [4, 6, 8] {
            let settings = Settings {
                order,
                step: 0.025,
                ..Settings::default()
            };
            for interval in orders::INTERVALS {
                let outcome = orders::run(case, &reference, settings, interval);
                let row = orders::row(case.0, &settings, interval, &outcome);
                let key: Vec<(&str, &str)> = (orders::COLUMNS.iter().zip(&row))
                    .take(orders::KEYS)
                    .map(|(column, cell)| (*column, cell.as_str()))
                    .collect();
                let line = table.find(&key).expect("a row");
                let before = ["energy_error_J", "position_error_m"]
                    .map(|column| line.number(column).expect("a number"));
                let position = outcome.position.expect("it runs");
                let now = [outcome.report.energy_error, position];
                for (before, now) in before.into_iter().zip(now) {
                    assert!(
                        agree(before, now, 1e-10),
                        "{key:?}: {before:e}, now {now:e}"
                    );
                }
            }
        }
    }
}
