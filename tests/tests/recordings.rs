//! Recorded runs of a mechanism that is no scene: instants, files, and the model in words.

use crate::data::Pendulum;
use mbs_runtime::{Mechanism, Settings, Simulation};
use std::path::Path;
use std::{env, fs};

#[test]
fn instants_are_multiples_of_the_interval() {
    let mut simulation = Simulation::new(Pendulum {}).unwrap();
    let mut seen = Vec::new();
    let run = simulation.record(0.25).every(0.1);
    let run = run.progress(|progress| seen.push(progress.fraction()));
    let recording = run.run().unwrap();
    let times: Vec<f64> = recording.frames.iter().map(|frame| frame.time).collect();
    assert_eq!(times, [0.0, 0.1, 0.2, 0.25]);
    assert_eq!(seen, [0.4, 0.8, 1.0]);
    let last = &recording.frames[3];
    assert_eq!(last.outputs, simulation.output_values());
    assert!(last.reactions.iter().all(|value| value.is_finite()));
    // The next part begins where this one has ended.
    let next = simulation.record(0.3).run().unwrap();
    assert_eq!(next.frames[0].time, 0.25);
}

/// Without an interval; with a tolerance a step goes beyond an instant, and the run is the same as without instants.
#[test]
fn instants_of_a_tolerance_shorten_no_step() {
    let settings = Settings::for_tolerance(1e-4);
    let new = || Simulation::with_settings(Pendulum {}, settings).unwrap();
    let (mut recorded, mut plain) = (new(), new());
    let recording = recorded.record(2.0).run().unwrap();
    plain.run_until(2.0).unwrap();
    assert_eq!(recording.frames.len(), 501);
    assert_eq!(recorded.state(), plain.state());
}

#[test]
fn what_cannot_be_recorded_is_an_error() {
    let mut simulation = Simulation::new(Pendulum {}).unwrap();
    let wrong = simulation.record(1.0).every(0.0).run().unwrap_err();
    assert!(wrong.to_string().contains("recording interval"), "{wrong}");
    simulation.run_until(0.5).unwrap();
    let late = simulation.record(0.1).run().unwrap_err();
    assert_eq!(late.recording.stopped, Some(late.error.clone()));
    assert_eq!(late.recording.frames.len(), 1);
}

#[test]
fn files_of_a_run() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("recording");
    let _ = fs::remove_dir_all(&folder);
    let mut simulation = Simulation::new(Pendulum {}).unwrap();
    let mut recording = simulation.record(0.5).every(0.1).run().unwrap();
    recording.title = "Swing".to_owned();
    recording.save(&folder).unwrap();
    let read = |name: &str| fs::read_to_string(folder.join(name)).expect(name);
    let table = read("trajectory.csv");
    assert_eq!(table.lines().count(), 7);
    assert!(table.starts_with("time_s,height_m,tip.x_m,tip.y_m,rate_rad_per_s,"));
    assert!(read("motion.html").contains("\"title\":\"Swing\""));
    // Metres and radians per second are in different diagrams.
    let outputs = read("outputs.svg");
    for text in ["height", "tip.x", "rate", "rad/s", ">m<"] {
        let text = text.trim_matches(['>', '<']);
        assert!(outputs.contains(text), "no {text}");
    }
    assert_eq!(outputs.matches("time, s").count(), 2);
    for name in ["energy.svg", "constraints.svg"] {
        assert!(read(name).ends_with("</svg>\n"), "{name}");
    }
    // A folder that is a file is named in the error.
    let error = recording.save(folder.join("outputs.svg")).unwrap_err();
    assert!(error.to_string().contains("outputs.svg"), "{error}");
}

#[test]
fn an_own_mechanism_explains_itself() {
    let text = Pendulum::MODEL.explain().to_string();
    for line in [
        "Coordinates considered, with the estimated operations of a step",
        "rod",
        "mass matrix  constant",
        "Reactions on the second partner",
    ] {
        assert!(text.contains(line), "no {line} in\n{text}");
    }
    let equations = Pendulum::MODEL.latex().unwrap();
    assert!(equations.contains("M_{1,1} &= "), "{equations}");
    // The text of a declaration has no assemblies.
    let refused = crate::home::Pendulum::MODEL.latex().unwrap_err();
    assert!(refused.contains("has no assemblies"), "{refused}");
}
