//! The animation in a real browser, if one is installed.

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use mbs_runtime::output::Frame;
use mbs_runtime::output::motion::write_motion;
use mbs_runtime::{Model, World};

use super::{MODEL, frame, motion, runs};

/// Watches for errors, and reports.
const WATCH: &str = include_str!("watch.js");
/// Uses the animation as a person would.
const PROBE: &str = include_str!("probe.js");

/// A page with the size of its window.
pub struct Page {
    file: PathBuf,
    width: u32,
}

impl Page {
    /// `probe` uses the page; it is inserted before the page's first script.
    pub fn new(name: &str, text: &str, width: u32, probe: &str) -> Self {
        let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join("browser");
        fs::create_dir_all(&directory).expect("a directory");
        let file = directory.join(format!("{name}.html"));
        let watched = text.replacen(
            "<script",
            &format!("<script>{WATCH}{probe}</script><script"),
            1,
        );
        fs::write(&file, watched).expect("a page");
        Page { file, width }
    }

    /// Runs the browser on the page at `address`; `None` if there is no browser.
    fn open(&self, address: &str, how: &str) -> Option<String> {
        let profile = self.file.with_extension("profile");
        let run = |browser: &&str| {
            Command::new(browser)
                .args(["--headless", "--no-sandbox", "--disable-gpu"])
                .arg("--hide-scrollbars")
                .arg("--virtual-time-budget=20000")
                .arg(format!("--user-data-dir={}", profile.display()))
                .arg(format!("--window-size={},800", self.width))
                .arg(how)
                .arg(format!("file://{}{address}", self.file.display()))
                .stderr(Stdio::null())
                .output()
                .ok()
        };
        let output = ["chromium", "chromium-browser", "google-chrome"].iter();
        let output = output.filter_map(run).next()?;
        assert!(output.status.success(), "{}", output.status);
        Some(String::from_utf8(output.stdout).expect("UTF-8"))
    }

    /// The report of the probe.
    pub fn report(&self) -> Option<HashMap<String, String>> {
        let document = self.open("", "--dump-dom")?;
        let (_, root) = document.split_once("<html").expect("a document");
        let (root, _) = root.split_once('>').expect("a root");
        let attributes = root.split("data-").skip(1).filter_map(|attribute| {
            let (name, value) = attribute.split_once("=\"")?;
            let (value, _) = value.rsplit_once('"')?;
            Some((name.to_owned(), value.to_owned()))
        });
        let report: HashMap<_, _> = attributes.collect();
        assert_eq!(report.get("errors"), None, "{}", self.file.display());
        assert_eq!(report.get("ended").map(String::as_str), Some("true"));
        Some(report)
    }

    pub fn screenshot(&self, address: &str) -> Option<Vec<u8>> {
        let picture = self.file.with_extension("png");
        self.open(address, &format!("--screenshot={}", picture.display()))?;
        Some(fs::read(picture).expect("a screenshot"))
    }
}

pub fn skipped() {
    println!("skipped: no chromium was found");
}

/// Four seconds of a bar; in space it leaves the plane.
fn swinging(depth: f64) -> String {
    let frames: Vec<Frame> = (0..=400)
        .map(|i| {
            let time = 0.01 * f64::from(i);
            let mut frame = frame(time, time.cos(), 1.0 + time, 1e-9 * time);
            frame.points[1][2] = depth * (2.0 * time).sin();
            frame
        })
        .collect();
    let model = Model {
        world: if depth == 0.0 {
            World::Planar
        } else {
            World::Spatial
        },
        ..MODEL
    };
    let mut page = Vec::new();
    write_motion(&mut page, &model, &frames, "Swinging", None).expect("a page");
    String::from_utf8(page).expect("UTF-8")
}

fn used(name: &str, text: &str, width: u32) {
    let page = Page::new(name, text, width, PROBE);
    let Some(report) = page.report() else {
        return skipped();
    };
    let number = |name: &str| -> f64 { report[name].parse().expect(name) };
    assert!(report["clock"].starts_with("1.000 s"), "{report:?}");
    assert!(number("moved") > 200.0, "{report:?}");
    assert_eq!(number("returned"), 0.0);
    assert_eq!(number("stepped"), 1.0);
    assert_eq!(number("home"), 0.0);
    assert_eq!(report["played"], "Pause");
    assert!((number("scrubbed") - 0.72).abs() < 0.05, "{report:?}");
    assert!(number("dragged") > 200.0 && number("zoomed") > 200.0);
    assert_eq!(number("reset"), 0.0);
    assert!(number("pinched") > 200.0 && (number("zoom") - 2.0).abs() < 1e-9);
    assert_eq!(report["themed"], "true");
    assert!(number("wide") <= 0.0, "{report:?}");
    let pictures = ["#t=1", "#t=2"].map(|address| page.screenshot(address));
    assert!(pictures[0].is_some() && pictures[0] != pictures[1]);
}

#[test]
fn a_plane_motion_can_be_watched_and_used() {
    used("plane", &swinging(0.0), 1280);
}

#[test]
fn a_motion_in_space_can_be_watched_and_used() {
    used("space", &swinging(0.8), 1280);
}

#[test]
fn a_narrow_window_is_enough() {
    used("narrow", &swinging(0.0), 500);
}

#[test]
fn a_browser_survives_every_run() {
    for (index, frames) in runs().iter().enumerate() {
        let page = Page::new(&format!("run-{index}"), &motion(frames), 800, PROBE);
        if page.report().is_none() {
            return skipped();
        }
    }
}
