//! Mechanisms of space.

use super::spatial_conditions;
use crate::random::Random;
use std::fmt::Write;

/// A body in its home pose.
pub(super) struct Part {
    pub name: String,
    pub at: [f64; 3],
    /// Its joint to the parts before it, by the number of its kind.
    pub pin: usize,
}

/// The kinds of joints in the plain mechanisms, and of the joints that close loops.
const KINDS: usize = 6;
const CLOSING: usize = 3;
/// Those of the mechanisms with conditions.
const ALL_KINDS: usize = 8;

/// A mechanism of this number in space; `coordinates` is the choice of the description.
pub fn spatial(number: usize, coordinates: &str) -> String {
    let random = &mut Random::of(&format!("spatial {number}"));
    let (mut text, parts) = parts(random, coordinates, KINDS);
    if random.between(0, 1) == 1 {
        close(&mut text, &parts, random);
    }
    loads(&mut text, &parts, random);
    text + "}"
}

/// The same with conditions on positions and velocities, some of which follow from others or change with time, with
/// slender bars and forces in joints.
pub fn spatial_conditioned(number: usize, coordinates: &str) -> String {
    let random = &mut Random::of(&format!("spatial conditioned {number}"));
    let (mut text, parts) = parts(random, coordinates, ALL_KINDS);
    let mut freedoms: usize = parts.iter().map(|part| FREEDOMS[part.pin]).sum();
    if freedoms > 4 && random.between(0, 2) == 0 {
        freedoms -= close(&mut text, &parts, random);
    }
    spatial_conditions::write(&mut text, &parts, freedoms, random);
    loads(&mut text, &parts, random);
    text + "}"
}

/// The declaration of the tree, and its parts.
fn parts(random: &mut Random, coordinates: &str, kinds: usize) -> (String, Vec<Part>) {
    let mut text = format!(
        "Random {{ world: Spatial(gravity = [{}, 0.0, -9.81], coordinates = {coordinates}), ",
        random.within(2.0)
    );
    let mut parts = Vec::new();
    for i in 0..random.between(1, 3) {
        let [at, axis] = [(); 2].map(|()| vector(random, 1.0));
        let ([a, b, c], off) = (
            [(); 3].map(|()| 0.3 + random.within(0.05)),
            vector(random, 0.2),
        );
        let (mass, turn) = (1.0 + random.within(0.5), random.within(2.0));
        let _ = write!(
            text,
            "part{i}: Body(mass = {mass}, inertia = diag({a}, {b}, {c}), at = {at:?}, center_of_mass = {off:?}, \
             orientation = turn({axis:?}, {turn})), "
        );
        let before = match i {
            0 => "ground".to_owned(),
            _ => format!("part{}", random.between(0, i - 1)),
        };
        let name = format!("part{i}");
        let (pin, joint) = joint(random, &before, &name, kinds);
        let _ = write!(text, "pin{i}: {joint}, ");
        parts.push(Part { name, at, pin });
    }
    (text, parts)
}

/// A joint that closes a loop; how many freedoms it takes.
fn close(text: &mut String, parts: &[Part], random: &mut Random) -> usize {
    let last = &parts[parts.len() - 1].name;
    let (kind, joint) = joint(random, "ground", last, CLOSING);
    let _ = write!(text, "close: {joint}, ");
    6 - FREEDOMS[kind]
}

/// A spring with a damper, a force and a torque; outputs of all parts.
fn loads(text: &mut String, parts: &[Part], random: &mut Random) {
    let last = &parts[parts.len() - 1].name;
    let [from, to, push] = [1.0, 0.4, 5.0].map(|size| vector(random, size));
    let [x, y, z] = vector(random, 0.5);
    let _ = write!(
        text,
        "anchor: Point({from:?}), spring: SpringDamper(anchor, {last}.origin, stiffness = 20.0, damping = 0.5, length = 0.4), \
         push: Force(part0.origin, value = {push:?}), stir: Torque({last}, value = {to:?}), "
    );
    for Part { name, .. } in parts {
        let _ = write!(
            text,
            "{name}_at: Output({name}.point({x}, {y}, {z})), {name}_speed: Output({name}.point({x}, {y}, {z}).velocity), "
        );
    }
}

pub(super) fn vector(random: &mut Random, size: f64) -> [f64; 3] {
    [(); 3].map(|()| random.within(size))
}

/// The freedoms of each kind of joint.
const FREEDOMS: [usize; ALL_KINDS] = [3, 2, 3, 1, 1, 2, 1, 2];
/// The kinds that have an angle, and those that have a stroke.
pub(super) const TURNING: [usize; 4] = [1, 2, 3, 6];
pub(super) const SLIDING: [usize; 3] = [1, 4, 6];

/// One of the first kinds of joints, at any place and with any axis.
fn joint(random: &mut Random, first: &str, second: &str, kinds: usize) -> (usize, String) {
    let (at, axis) = (vector(random, 1.0), vector(random, 1.0));
    let kind = random.between(0, kinds - 1);
    let place = format!("{first}, {second}, at = {at:?}");
    let joint = match kind {
        0 => format!("Spherical({place})"),
        1 => format!("Cylindrical({place}, axis = {axis:?})"),
        2 => format!("Planar({place}, axis = {axis:?})"),
        3 => format!("Revolute({place}, axis = {axis:?})"),
        4 => format!("Prismatic({place}, axis = {axis:?})"),
        5 => format!("Universal({place}, axis = [0.0, 1.0, 0.2], second_axis = [1.0, 0.0, 0.0])"),
        6 => format!("Screw({place}, axis = {axis:?}, pitch = 0.4)"),
        _ => format!("ConstantVelocity({place}, axis = {axis:?})"),
    };
    (kind, joint)
}
