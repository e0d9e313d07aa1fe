//! Which rows of velocities integrate to rows of positions, found at compile time.

use crate::mobility::{SPACE, analysis};

const DISK: &str =
    "disk: Body(mass = 2.0_kg, inertia = Cylinder(0.3_m, 0.02_m, Y), at = [0.0, 0.0, 0.3]),
    down: Let(-unit(reject(ground.z, disk.y))), contact: Let(disk.origin + 0.3_m * down),
    slip: Let(disk.velocity_at(contact)), touch: Holonomic(dot(contact, ground.z)),
    no_slip: Nonholonomic([dot(slip, ground.x), dot(slip, ground.y)]),";
const SKATE: &str = "skate: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, center_of_mass = [0.1, 0.0]),
    edge: Nonholonomic(dot(skate.velocity, skate.y)),";
const TOP: &str =
    "top: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, orientation = turn([1.0, 2.0, 0.5], 0.7)),";

/// The names of the rows that are integrable.
fn integrable(world: &str, entries: &str) -> Vec<String> {
    let analysis = analysis(world, entries);
    let rows = analysis.mobility.expect("a pose is found").integrable;
    let list = &analysis.derived.system.rows;
    rows.iter().map(|&row| list[row].name.clone()).collect()
}

#[test]
fn rolling_and_skating_are_nonholonomic() {
    assert!(integrable(SPACE, DISK).is_empty());
    assert!(integrable("Planar()", SKATE).is_empty());
    for scene in mbs_examples::scenes::scenes() {
        let mobility = scene.model.mobility.expect("it assembles");
        assert!(mobility.integrable.is_empty(), "{}", scene.name);
    }
}

#[test]
fn rolling_in_a_straight_line_is_holonomic() {
    let upright = "upright: Holonomic(dot(disk.y, ground.z)),";
    let ahead = "ahead: Holonomic(dot(disk.y, ground.x)),";
    // Upright it still turns about the vertical.
    assert!(integrable(SPACE, &format!("{DISK} {upright}")).is_empty());
    let straight = format!("{DISK} {upright} {ahead}");
    assert_eq!(integrable(SPACE, &straight), ["no_slip[0]", "no_slip[1]"]);
    // The heading may also be held by a row on its rate, which is itself integrable.
    let steered = "steered: Nonholonomic(dot(disk.angular_velocity, ground.z)),";
    let rows = integrable(SPACE, &format!("{DISK} {upright} {steered}"));
    assert_eq!(rows.len(), 3);
}

#[test]
fn skates_with_a_heading_are_holonomic() {
    let held = format!("{SKATE} held: Holonomic(skate.angle - 0.3),");
    assert_eq!(integrable("Planar()", &held), ["edge"]);
    let steered = format!("{SKATE} steered: Nonholonomic(skate.rate),");
    assert_eq!(integrable("Planar()", &steered).len(), 2);
    // If the heading changes with time, the row is not integrable.
    let turning = format!("{SKATE} turning: Drive(skate.angle, value = 0.3 + 1.0_rad_per_s * t),");
    assert!(integrable("Planar()", &turning).is_empty());
}

#[test]
fn gears_of_rates_are_holonomic() {
    let wheels = "a: Body(mass = 1.0_kg, inertia = 0.1_kg_m2), b: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, at = [1.0, 0.0]),
        p: Revolute(ground.origin, a.origin), q: Revolute(ground.point(1.0, 0.0), b.origin),
        skate: Body(mass = 1.0_kg, inertia = 0.1_kg_m2), edge: Nonholonomic(dot(skate.velocity, skate.y)),
        gear: Nonholonomic(a.rate + 2.0 * b.rate),";
    let rows = integrable("Planar(coordinates = Reference)", wheels);
    assert_eq!(rows, ["gear"], "and not the edge beside it");
}

#[test]
fn quasi_velocities_have_brackets() {
    // Rates of functions of the orientation integrate to them; angular velocities about one axis do not integrate.
    for (condition, expected) in [
        ("rate(dot(top.y, ground.x))", 1),
        ("rate(dot(top.y, ground.x) * top.origin.z)", 1),
        ("dot(top.angular_velocity, top.x)", 0),
        ("dot(top.angular_velocity, ground.x)", 0),
        // All about two axes in space, or all three, leave a group to turn in.
        (
            "[dot(top.angular_velocity, ground.x), dot(top.angular_velocity, ground.y)]",
            2,
        ),
        (
            "[dot(top.angular_velocity, top.x), dot(top.angular_velocity, top.z)]",
            2,
        ),
        (
            "[dot(top.angular_velocity, top.x), dot(top.angular_velocity, ground.z)]",
            2,
        ),
        ("top.angular_velocity", 3),
        ("[dot(top.angular_velocity, top.x), top.velocity.z]", 1),
    ] {
        let rows = integrable(SPACE, &format!("{TOP} still: Nonholonomic({condition}),"));
        assert_eq!(rows.len(), expected, "{condition}: {rows:?}");
    }
}

#[test]
fn conditions_may_integrate_with_time() {
    let ball = "ball: Particle(mass = 1.0_kg, free = true),";
    for (condition, expected) in [
        ("ball.velocity.x - 2.0_m_per_s * cos(3.0_per_s * t)", 1),
        (
            "ball.velocity.x - 1.0_per_s * ball.origin.x * cos(3.0_per_s * t)",
            1,
        ),
        ("ball.velocity.x - 1.0_per_s * ball.origin.y", 0),
        ("ball.velocity.x - (2.0_per_s * t) * ball.velocity.y", 0),
    ] {
        let entries = format!("{ball} belt: Nonholonomic({condition}),");
        assert_eq!(
            integrable("Planar()", &entries).len(),
            expected,
            "{condition}"
        );
    }
}
