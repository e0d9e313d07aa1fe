//! The error of a run against its reference stays within ten times its tolerance, in sizes of the mechanism and
//! radians.

use mbs_examples::reference::ReferenceTable;
use mbs_examples::scenes::scenes;
use mbs_runtime::Settings;
use mbs_runtime::output::Frame;
use mbs_tests::with_room;

/// Runs a scene to its end at the order for each tolerance.
fn check(name: &str, columns: &[&str], size: f64, tolerances: &[f64]) {
    let scene = scenes().iter().find(|scene| scene.name == name);
    let scene = scene.expect("a scene");
    let reference = scene.reference.as_ref().expect("a reference");
    let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("reference")
        .join(reference.file);
    let table = ReferenceTable::read(file, reference, scene.model).expect("readable");
    for &tolerance in tolerances {
        let settings = Settings {
            step: scene.step,
            ..Settings::for_tolerance(tolerance)
        };
        let mut simulation = (scene.build)(&[], settings).expect(name);
        let mut frames = Vec::new();
        let interval = table.interval().expect("instants");
        for instant in 1..=(scene.duration / interval).round() as u32 {
            let time = f64::from(instant) * interval;
            simulation.run_past(time, scene.duration).expect(name);
            let seen = simulation.look_at(time, &mut |seen| frames.push(Frame::record(seen)));
            seen.expect(name);
        }
        let deviations = table.compare(&frames);
        let mut largest = 0.0_f64;
        for deviation in deviations.iter().filter(|d| columns.contains(&d.column)) {
            assert!(deviation.instants > 50, "{deviation:?}");
            assert!(deviation.largest.is_finite(), "{deviation:?}");
            largest = largest.max(deviation.largest / size);
        }
        println!(
            "{name}, {tolerance:e} at order {}: {:.2} times, {:?}",
            settings.order,
            largest / tolerance,
            simulation.report()
        );
        assert!(
            largest < 10.0 * tolerance,
            "{name}, {tolerance:e}: {largest:e}"
        );
        assert!(
            largest > 1e-3 * tolerance,
            "{name}, {tolerance:e}: {largest:e}"
        );
    }
}

#[test]
fn pendulum() {
    check("pendulum", &["x_m", "y_m"], 1.0, &[1e-3, 1e-6, 1e-9]);
}

#[test]
fn slider_crank() {
    let columns = ["p1x_m", "p1y_m", "p2x_m"];
    check("slider-crank", &columns, 2.0, &[1e-3, 1e-6, 1e-9]);
}

#[test]
fn double_four_bar() {
    check("double-four-bar", &["b0x_m", "b0y_m"], 2.0, &[1e-3, 1e-6]);
}

#[test]
fn andrews() {
    let columns = ["beta_rad", "gamma_rad", "delta_rad", "epsilon_rad"];
    check("andrews", &columns, 1.0, &[1e-3, 1e-6]);
}

#[test]
fn bricard() {
    let columns = ["p3x_m", "p3y_m", "p3z_m", "p2x_m", "p2z_m", "p5y_m"];
    check("bricard", &columns, 1.0, &[1e-6]);
}

#[test]
fn flyball_governor() {
    let columns = ["s_m", "ball1_x_m", "ball1_y_m", "ball1_z_m"];
    check("flyball-governor", &columns, 1.0, &[1e-3]);
}

/// With all rows of this scene a margin of 1e-3 is left near one pose, without a loss of rank of the mechanism. The error was
/// 2.4e-8 J when round-off of the rows was taken for that of their tolerance. By chance of the steps it differs thirtyfold between
/// accuracies that are nearly the same, so that the median counts.
#[test]
fn nearly_dependent_rows_do_not_end_the_accuracy() {
    with_room(|| {
        let mut scenes = scenes().iter();
        let scene = scenes.find(|scene| scene.name == "bricard-reference");
        let scene = scene.expect("a scene");
        let mut errors = [0.8, 0.9, 0.95, 1.0, 1.05, 1.1, 1.2].map(|part| {
            let settings = Settings {
                step: scene.step,
                ..Settings::accuracy(part * 1e-9)
            };
            let mut simulation = (scene.build)(&[], settings).expect("it assembles");
            simulation.run_until(scene.duration).expect("it runs");
            println!("{:?}", simulation.report());
            simulation.report().energy_error
        });
        errors.sort_by(f64::total_cmp);
        let error = errors[3];
        assert!(error < 5e-9, "{error:e} J");
    });
}
