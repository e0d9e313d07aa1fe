//! One page for any browser, without network: pictures, with one switch for the scene and one for the measure.

use std::fmt::Write as _;

use super::svg::escape;

/// A picture with its scene and measure.
pub struct Picture {
    /// Value of the first switch: a scene.
    pub scene: String,
    /// Value of the second: a measure.
    pub measure: String,
    /// The SVG.
    pub svg: String,
    /// Runs that failed, and how.
    pub remarks: Vec<String>,
}

/// The page.
pub fn page(title: &str, note: &str, pictures: &[Picture]) -> String {
    let mut html = HEAD.replace("TITLE", &escape(title));
    let _ = write!(
        html,
        "<h1>{}</h1>\n<p>{}</p>\n<p>",
        escape(title),
        escape(note)
    );
    for (id, label, values) in [
        ("scene", "Scene", distinct(pictures, |p| &p.scene)),
        ("measure", "Error of", distinct(pictures, |p| &p.measure)),
    ] {
        let _ = write!(html, "<label>{label} <select id=\"{id}\">");
        for value in values {
            let _ = write!(html, "<option>{}</option>", escape(value));
        }
        html += "</select></label>\n";
    }
    html += "</p>\n";
    for picture in pictures {
        let _ = writeln!(
            html,
            "<section data-scene=\"{}\" data-measure=\"{}\" hidden><div class=\"picture\">{}</div>",
            escape(&picture.scene),
            escape(&picture.measure),
            picture.svg
        );
        if !picture.remarks.is_empty() {
            html += "<details open><summary>Runs that failed</summary><ul>";
            for remark in &picture.remarks {
                let _ = write!(html, "<li>{}</li>", escape(remark));
            }
            html += "</ul></details>";
        }
        html += "</section>\n";
    }
    html + SCRIPT
}

fn distinct<'a>(
    pictures: &'a [Picture],
    of: impl Fn(&'a Picture) -> &'a String,
) -> Vec<&'a String> {
    let mut values: Vec<&String> = Vec::new();
    for value in pictures.iter().map(of) {
        if !values.contains(&value) {
            values.push(value);
        }
    }
    values
}

const HEAD: &str = r#"<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>TITLE</title><style>
:root { color-scheme: light dark; font: 16px/1.45 system-ui, sans-serif }
body { margin: 0 auto; max-width: 1100px; padding: 12px }
h1 { font-size: 1.3rem }
select { font: inherit; padding: 4px; margin-right: 12px }
label { display: inline-block; margin: 4px 0 }
.picture { overflow-x: auto }
.picture svg { width: 100%; height: auto; min-width: 760px }
@media (prefers-color-scheme: dark) { .picture svg { filter: invert(0.93) hue-rotate(180deg) } }
</style></head><body>
"#;

const SCRIPT: &str = r#"<script>
const switches = [...document.querySelectorAll("select")];
function show() {
  for (const section of document.querySelectorAll("section"))
    section.hidden = switches.some(s => section.dataset[s.id] !== s.value);
}
for (const s of switches) s.addEventListener("change", show);
show();
</script></body></html>
"#;
