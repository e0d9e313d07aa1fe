//! The picture of the README: two mechanisms at regular instants, with the paths of points. It is written by this test
//! (`UPDATE_PICTURE=1`) and compared with what is checked in.

use mbs_examples::scenes::scenes;
use mbs_runtime::{AnySimulation, Settings, World};
use std::fmt::Write;
use std::fs;
use std::path::Path;

const WIDTH: f64 = 860.0;
const HEIGHT: f64 = 330.0;
/// Instants between two poses, for the paths.
const BETWEEN: usize = 12;

/// One half of the picture.
struct Panel {
    scene: &'static str,
    caption: &'static str,
    /// The point whose path is drawn.
    path: &'static str,
    poses: usize,
    /// Time between poses, s.
    interval: f64,
    /// Left, top, width and height of its frame.
    frame: [f64; 4],
}

const PANELS: [Panel; 2] = [
    Panel {
        scene: "slider-crank",
        caption: "slider-crank with equal rods, through its singular pose",
        path: "rod.center",
        poses: 12,
        interval: 0.07,
        frame: [20.0, 20.0, 480.0, 265.0],
    },
    Panel {
        scene: "bricard",
        caption: "Bricard’s mechanism, one row redundant",
        path: "rod3.a",
        poses: 9,
        interval: 0.16,
        frame: [540.0, 20.0, 300.0, 265.0],
    },
];

/// The projection: the plane without change, space seen from the front, a little from the side and from above.
fn seen([x, y, z]: [f64; 3], world: World) -> [f64; 2] {
    match world {
        World::Planar => [x, y],
        World::Spatial => {
            let (side, above) = (0.55_f64, 0.35_f64);
            let (across, away) = (
                x * side.cos() + z * side.sin(),
                z * side.cos() - x * side.sin(),
            );
            [across, y * above.cos() - away * above.sin()]
        }
    }
}

/// Lines of the bars, pose by pose, and the path.
fn motion(panel: &Panel) -> (Vec<Vec<[[f64; 2]; 2]>>, Vec<[f64; 2]>) {
    let scene = scenes().iter().find(|scene| scene.name == panel.scene);
    let scene = scene.expect("the scene is there");
    let mut simulation = (scene.build)(&[], Settings::default()).expect("it assembles");
    let model = simulation.model();
    let end = |point: usize| {
        let name = model.points[point];
        name.ends_with(".a") || name.ends_with(".b")
    };
    let bars: Vec<(usize, usize)> = model
        .segments
        .iter()
        .map(|segment| (segment.from, segment.to))
        .filter(|&(from, to)| end(from) && end(to))
        .collect();
    let followed = |simulation: &dyn AnySimulation| {
        let points = simulation.points();
        let at = |name: &str| points[model.points.iter().position(|known| *known == name)?].into();
        let middle = |part: &str| -> Option<[f64; 3]> {
            let (a, b): ([f64; 3], [f64; 3]) =
                (at(&format!("{part}.a"))?, at(&format!("{part}.b"))?);
            Some(std::array::from_fn(|i| 0.5 * (a[i] + b[i])))
        };
        let point = match panel.path.strip_suffix(".center") {
            Some(part) => middle(part),
            None => at(panel.path),
        };
        seen(point.expect("the point is there"), model.world)
    };
    let (mut poses, mut path) = (Vec::new(), Vec::new());
    for pose in 0..panel.poses {
        for part in 0..BETWEEN {
            let instant = (pose as f64 + part as f64 / BETWEEN as f64) * panel.interval;
            simulation.run_until(instant).expect("it moves");
            path.push(followed(simulation.as_ref()));
            if part == 0 {
                let points = simulation.points();
                let line = |&(from, to): &(usize, usize)| [points[from], points[to]];
                poses.push(
                    bars.iter()
                        .map(|bar| line(bar).map(|point| seen(point, model.world)))
                        .collect(),
                );
            }
            if pose + 1 == panel.poses {
                break;
            }
        }
    }
    (poses, path)
}

fn draw(out: &mut String, panel: &Panel) {
    let (poses, path) = motion(panel);
    let all: Vec<[f64; 2]> = poses
        .iter()
        .flatten()
        .flatten()
        .chain(&path)
        .copied()
        .collect();
    let range = |axis: usize| {
        let values = all.iter().map(|point| point[axis]);
        let low = values.clone().fold(f64::INFINITY, f64::min);
        (low, values.fold(f64::NEG_INFINITY, f64::max))
    };
    let ((left, right), (low, high)) = (range(0), range(1));
    let [x, y, width, height] = panel.frame;
    let scale = (width / (right - left)).min(height / (high - low));
    let place = |[px, py]: [f64; 2]| {
        let px = x + 0.5 * width + scale * (px - 0.5 * (left + right));
        let py = y + 0.5 * height - scale * (py - 0.5 * (low + high));
        format!("{px:.1} {py:.1}")
    };
    let line = |points: &[[f64; 2]]| -> String {
        let points: Vec<String> = points.iter().map(|&point| place(point)).collect();
        format!("M{}", points.join("L"))
    };
    let _ = writeln!(out, "<path class=\"path\" d=\"{}\"/>", line(&path));
    let last = poses.len() - 1;
    for (index, pose) in poses.iter().enumerate() {
        let opacity = if index == last {
            1.0
        } else {
            0.12 + 0.4 * index as f64 / last as f64
        };
        let bars: String = pose.iter().map(|bar| line(bar)).collect();
        let _ = writeln!(
            out,
            "<path class=\"bar\" opacity=\"{opacity:.2}\" d=\"{bars}\"/>"
        );
    }
    let pins: String = poses[last]
        .iter()
        .flatten()
        .map(|&point| format!("M{}h0", place(point)))
        .collect();
    let _ = writeln!(out, "<path class=\"pin\" d=\"{pins}\"/>");
    let (middle, below) = (x + 0.5 * width, y + height + 32.0);
    let caption = panel.caption;
    let _ = writeln!(out, "<text x=\"{middle}\" y=\"{below}\">{caption}</text>");
}

fn picture() -> String {
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" width=\"{WIDTH}\" height=\"{HEIGHT}\">\n\
         <style>\n\
         path {{ fill: none; stroke-linecap: round; stroke-linejoin: round }}\n\
         .bar {{ stroke: #24527a; stroke-width: 4 }} .path {{ stroke: #c8642b; stroke-width: 1.6 }}\n\
         .pin {{ stroke: #12293d; stroke-width: 8 }} text {{ fill: #444; font: 15px sans-serif; text-anchor: middle }}\n\
         @media (prefers-color-scheme: dark) {{\n\
         .bar {{ stroke: #7db6e8 }} .path {{ stroke: #f0a070 }} .pin {{ stroke: #d8ecff }} text {{ fill: #bbb }}\n\
         }}\n\
         </style>\n"
    );
    for panel in &PANELS {
        draw(&mut out, panel);
    }
    out.push_str("</svg>\n");
    out
}

/// The numbers of a text, and the text between them.
fn parts(text: &str) -> (Vec<f64>, Vec<&str>) {
    let digit = |c: char| c.is_ascii_digit() || matches!(c, '.' | '-');
    let numbers = text
        .split(|c| !digit(c))
        .filter_map(|word| word.parse().ok());
    let words = text.split(digit).filter(|word| !word.is_empty());
    (numbers.collect(), words.collect())
}

#[test]
fn the_picture_is_up_to_date() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../book/src/mechanisms.svg");
    let now = picture();
    assert!(now.len() < 100_000, "{} bytes", now.len());
    if std::env::var_os("UPDATE_PICTURE").is_some() {
        fs::write(&file, &now).expect("the book can be written");
    }
    let before = fs::read_to_string(&file).expect("UPDATE_PICTURE=1 writes it");
    let ((new, text), (old, same)) = (parts(&now), parts(&before));
    assert_eq!(text, same, "UPDATE_PICTURE=1 writes it again");
    // Half a pixel, for changes of the method that are not visible.
    let differs = new
        .iter()
        .zip(&old)
        .find(|(new, old)| (*new - *old).abs() > 0.5);
    assert_eq!(differs, None, "UPDATE_PICTURE=1 writes it again");
}
