//! Joints whose reactions are not determined: the same with rows that joint coordinates leave out and with rows that
//! stay.

use mbs_macros_core::analyse;

/// The joints of undetermined reactions, and how many rows are left out.
fn undetermined(coordinates: &str, entries: &str) -> (Vec<String>, usize) {
    let text = format!(
        "Tried {{ world: Planar(gravity = [0.0, -9.81], coordinates = {coordinates}), {entries} }}"
    );
    let (_, outcome) = analyse(text.parse().expect("these are tokens"));
    let analysis = outcome.unwrap_or_else(|failure| panic!("{:?}", failure.messages()));
    let mut joints = analysis.mobility.expect("it assembles").undetermined;
    joints.sort();
    (joints, analysis.derived.system.vacuous.len())
}

/// A carriage and a slider on it, which keep their angles.
const SLIDES: &str = "carriage: Body(mass = 1.0, inertia = 0.3, angle = 0.4),
    slider: Body(mass = 0.7, inertia = 0.2, at = [0.3, 0.2], angle = 1.1),
    track: Prismatic(ground.origin, carriage.origin, axis = [0.8, 0.6], angle = 0.4),
    guide: Prismatic(carriage.point(0.3, 0.1), slider.origin, axis = [0.6, -0.8], angle = 0.7),";

fn compare(row: &str, expected: &[&str]) {
    let entries = format!("{SLIDES} {row},");
    let (by_bodies, stay) = undetermined("Reference", &entries);
    let (by_joints, left_out) = undetermined("Joint", &entries);
    assert_eq!((stay, left_out), (0, 1), "{row}");
    assert_eq!(by_bodies, expected, "{row}");
    assert_eq!(by_joints, expected, "{row}");
}

/// A gear between angles against the ground loads what carries both parts, a torsion between the parts does not.
#[test]
fn rows_left_out_load_all_joints_that_carry_them() {
    compare(
        "mesh: Gear(carriage, slider, ratio = 0.7, offset = 1.1 - 0.7 * 0.4)",
        &["guide", "mesh", "track"],
    );
    compare(
        "mesh: Gear(carriage, slider, ratio = 1.0, offset = 0.7)",
        &["guide", "mesh"],
    );
    compare(
        "level: Holonomic(dot(slider.x, ground.y) - sin(1.1))",
        &["guide", "level", "track"],
    );
    compare(
        "square: Holonomic(dot(slider.x, carriage.y) - sin(0.7))",
        &["guide", "square"],
    );
}
