//! The live figures of the book in a real browser: they move, compare, refuse and recover.

use std::fs;
use std::path::Path;

use super::browser::{Page, skipped};

/// Uses every figure of a page.
const PROBE: &str = include_str!("live.js");

/// The part of the page of the book with the figures, without the rest of the book.
fn figures() -> String {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../book/src");
    let source = source.canonicalize().expect("the book is there");
    let page = fs::read_to_string(source.join("live.md")).expect("the page");
    let elements: Vec<&str> = page.lines().filter(|line| line.starts_with('<')).collect();
    let place = format!("=\"file://{}/live/", source.display());
    let elements = elements.join("\n").replace("=\"live/", &place);
    format!(
        "<!doctype html><html class=\"light\"><meta charset=\"utf-8\">\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\
         <body style=\"margin: 0 15px\">{elements}</body></html>"
    )
}

fn used(name: &str, width: u32) {
    let page = Page::new(name, &figures(), width, PROBE);
    let Some(report) = page.report() else {
        return skipped();
    };
    assert!(report["wide"].parse::<f64>().expect("a width") <= 0.0);
    for scene in ["pendulum", "slider-crank", "bricard"] {
        let told = |what: &str| report[&format!("{scene}-{what}")].as_str();
        let number = |what: &str| -> f64 { told(what).parse().expect(what) };
        // A second of the clock; the first frames go to the unpacking of the module.
        assert!((0.5..1.5).contains(&number("time")), "{report:?}");
        assert!(number("moved") > 200.0, "{report:?}");
        assert_eq!(number("waited"), 0.0);
        assert!(number("compared") > 200.0, "{report:?}");
        assert!(number("ours") > 0.0 && number("theirs") > 0.0, "{report:?}");
        assert_eq!(told("silent"), "true");
        assert!(told("parameter").contains("is NaN"), "{report:?}");
        assert!(
            told("step").contains("the step cannot be 7 s"),
            "{report:?}"
        );
        assert_eq!(told("recovered"), "true");
        assert!(number("again") > 0.2, "{report:?}");
        assert!(number("themed") > 200.0, "{report:?}");
    }
}

#[test]
fn live_figures_can_be_used() {
    used("live", 1280);
}

#[test]
fn live_figures_fit_a_narrow_window() {
    used("live-narrow", 500);
}
