//! Mechanisms of the plane.

use super::planar_conditions;
use crate::random::Random;
use std::fmt::Write;

/// A point of a part: how the declaration names it, and where it is at the guess.
pub(super) type Point = (String, [f64; 2]);

/// A planar part at its guess.
pub(super) struct Part {
    pub name: String,
    is_body: bool,
    at: [f64; 2],
    pub angle: f64,
    length: f64,
}

impl Part {
    /// A point of it that is not the one it hangs on.
    pub fn point(&self, random: &mut Random) -> Point {
        let (sin, cos) = self.angle.sin_cos();
        let [x, y] = match self.is_body {
            true => [random.within(0.6), random.within(0.6)],
            false => [self.length, 0.0],
        };
        let at = [
            self.at[0] + cos * x - sin * y,
            self.at[1] + sin * x + cos * y,
        ];
        let name = &self.name;
        let name = match self.is_body {
            true => format!("{name}.point({x}, {y})"),
            false => format!("{name}.b"),
        };
        (name, at)
    }
}

pub(super) fn ground([x, y]: [f64; 2]) -> String {
    format!("ground.point({x}, {y})")
}

/// A mechanism of this number in the plane; `coordinates` is the choice of the description.
pub fn planar(number: usize, coordinates: &str) -> String {
    let random = &mut Random::of(&format!("planar {number}"));
    let (mut text, parts, _) = parts(random, coordinates);
    loads(&mut text, &parts, random);
    outputs(&mut text, &parts, random);
    text + "}"
}

/// The same with conditions on positions and velocities, some of which follow from others or change with time.
pub fn planar_conditioned(number: usize, coordinates: &str) -> String {
    let random = &mut Random::of(&format!("planar conditioned {number}"));
    let (mut text, parts, freedoms) = parts(random, coordinates);
    planar_conditions::write(&mut text, &parts, freedoms, random);
    loads(&mut text, &parts, random);
    outputs(&mut text, &parts, random);
    text + "}"
}

/// The declaration up to the joints that close loops, its parts, and the freedoms that are left.
fn parts(random: &mut Random, coordinates: &str) -> (String, Vec<Part>, usize) {
    let mut text = format!(
        "Random {{ world: Planar(gravity = [{}, -9.81], coordinates = {coordinates}), ",
        random.within(2.0)
    );
    let mut parts: Vec<Part> = Vec::new();
    for i in 0..random.between(2, 5) {
        let name = format!("part{i}");
        let parent = (i > 0).then(|| random.between(0, i - 1));
        let (from, pin) = match parent {
            Some(parent) => parts[parent].point(random),
            None => ("ground.origin".to_owned(), [0.0; 2]),
        };
        let angle = random.within(3.0);
        let mass = 1.0 + random.within(0.8);
        let hangs_on_body = parent.is_none_or(|parent| parts[parent].is_body);
        let part = match random.between(0, 3) {
            0 if hangs_on_body => slide(&mut text, name, random, (&from, pin), {
                parent.map_or(0.0, |parent| parts[parent].angle)
            }),
            0 | 1 => {
                let part = Part {
                    name,
                    is_body: true,
                    at: pin,
                    angle,
                    length: 0.0,
                };
                declare(&mut text, &part, mass, random);
                let _ = write!(text, "pin{i}: Revolute({from}, {}.origin), ", part.name);
                part
            }
            _ => {
                let length = 0.7 + random.within(0.4);
                let _ = write!(
                    text,
                    "{name}: Bar(mass = {mass}, length = {length}, angle = {angle}), \
                     pin{i}: Revolute({from}, {name}.a), "
                );
                Part {
                    name,
                    is_body: false,
                    at: pin,
                    angle,
                    length,
                }
            }
        };
        parts.push(part);
    }
    let closed = close(&mut text, &parts, random);
    let freedoms = parts.len() - closed;
    (text, parts, freedoms)
}

/// Where a point of each part is, and its velocity.
fn outputs(text: &mut String, parts: &[Part], random: &mut Random) {
    for part in parts {
        let (point, _) = part.point(random);
        let name = &part.name;
        let _ = write!(
            text,
            "{name}_at: Output({point}), {name}_speed: Output({point}.velocity), "
        );
    }
}

/// Declares a body with its centre of mass off its origin.
fn declare(text: &mut String, part: &Part, mass: f64, random: &mut Random) {
    let Part {
        name,
        at: [x, y],
        angle,
        ..
    } = part;
    let (inertia, off) = (0.3 + random.within(0.2), random.within(0.3));
    let _ = write!(
        text,
        "{name}: Body(mass = {mass}, inertia = {inertia}, at = [{x}, {y}], angle = {angle}, \
         center_of_mass = [{off}, 0.1]), "
    );
}

/// A body that slides along an axis fixed to the one before it.
fn slide(
    text: &mut String,
    name: String,
    random: &mut Random,
    (from, pin): (&str, [f64; 2]),
    before: f64,
) -> Part {
    let (direction, turned, way) = (random.within(3.0), random.within(1.0), random.within(0.5));
    let (sin, cos) = (before + direction).sin_cos();
    let part = Part {
        is_body: true,
        at: [pin[0] + way * cos, pin[1] + way * sin],
        angle: before + turned,
        length: 0.0,
        name,
    };
    declare(text, &part, 1.0 + random.within(0.5), random);
    let name = &part.name;
    let (sin, cos) = direction.sin_cos();
    let _ = write!(
        text,
        "slide_{name}: Prismatic({from}, {name}.origin, axis = [{cos}, {sin}], angle = {turned}), "
    );
    part
}

/// Joints that close loops, at most as many as leave a freedom; how many freedoms they take.
fn close(text: &mut String, parts: &[Part], random: &mut Random) -> usize {
    let last = parts.len() - 1;
    let (point, at) = parts[last].point(random);
    match random.between(0, 3) {
        0 if last >= 2 => {
            let _ = write!(text, "close: Revolute({}, {point}), ", ground(at));
            2
        }
        1 => {
            let _ = write!(
                text,
                "close: PointOnLine({point}, {}, axis = X), ",
                ground(at)
            );
            1
        }
        2 if last >= 2 && parts[0].is_body => {
            let (sin, cos) = parts[0].angle.sin_cos();
            let [x, y] = [at[0] - parts[0].at[0], at[1] - parts[0].at[1]];
            let (x, y) = (cos * x + sin * y, cos * y - sin * x);
            let _ = write!(
                text,
                "close: Revolute(part0.point({x}, {y}), {point}), again: Revolute({point}, part0.point({x}, {y})), "
            );
            2
        }
        _ => 0,
    }
}

/// A spring with a damper, a force and a torque.
fn loads(text: &mut String, parts: &[Part], random: &mut Random) {
    let first = parts[0].point(random).0;
    let last = parts[parts.len() - 1].point(random).0;
    let [stiffness, damping] = [20.0 + random.within(10.0), 1.0 + random.within(1.0)];
    let [x, y, turn] = [(); 3].map(|()| random.within(5.0));
    let _ = write!(
        text,
        "spring: SpringDamper({}, {last}, stiffness = {stiffness}, damping = {damping}, length = 0.4), \
         push: Force({first}, value = [{x}, {y}]), motor: Torque(part0, value = {turn}), ",
        ground([1.3, -0.7])
    );
}
