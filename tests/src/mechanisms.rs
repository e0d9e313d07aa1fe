//! Random mechanisms as declarations: trees of parts in any pose, with loops that close exactly at the guess, springs,
//! and loads.

use crate::random::Random;
use std::fmt::Write;

/// A point of a part: how the declaration names it, and where it is at the guess.
type Point = (String, [f64; 2]);

/// A planar part at its guess.
struct Part {
    name: String,
    is_body: bool,
    at: [f64; 2],
    angle: f64,
    length: f64,
}

impl Part {
    /// A point of it that is not the one it hangs on.
    fn point(&self, random: &mut Random) -> Point {
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

fn ground([x, y]: [f64; 2]) -> String {
    format!("ground.point({x}, {y})")
}

/// A mechanism of this number in the plane; `coordinates` is the choice of the description.
pub fn planar(number: usize, coordinates: &str) -> String {
    let random = &mut Random::of(&format!("planar {number}"));
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
    close(&mut text, &parts, random);
    loads(&mut text, &parts, random);
    for part in &parts {
        let (point, _) = part.point(random);
        let name = &part.name;
        let _ = write!(
            text,
            "{name}_at: Output({point}), {name}_speed: Output({point}.velocity), "
        );
    }
    text + "}"
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

/// Joints that close loops, at most as many as leave a freedom.
fn close(text: &mut String, parts: &[Part], random: &mut Random) {
    let last = parts.len() - 1;
    let (point, at) = parts[last].point(random);
    match random.between(0, 3) {
        0 if last >= 2 => {
            let _ = write!(text, "close: Revolute({}, {point}), ", ground(at));
        }
        1 => {
            let _ = write!(
                text,
                "close: PointOnLine({point}, {}, axis = X), ",
                ground(at)
            );
        }
        2 if last >= 2 && parts[0].is_body => {
            let (sin, cos) = parts[0].angle.sin_cos();
            let [x, y] = [at[0] - parts[0].at[0], at[1] - parts[0].at[1]];
            let (x, y) = (cos * x + sin * y, cos * y - sin * x);
            let _ = write!(
                text,
                "close: Revolute(part0.point({x}, {y}), {point}), again: Revolute({point}, part0.point({x}, {y})), "
            );
        }
        _ => {}
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

/// A mechanism of this number in space.
pub fn spatial(number: usize, coordinates: &str) -> String {
    let random = &mut Random::of(&format!("spatial {number}"));
    let mut text = format!(
        "Random {{ world: Spatial(gravity = [{}, 0.0, -9.81], coordinates = {coordinates}), ",
        random.within(2.0)
    );
    let count = random.between(1, 3);
    for i in 0..count {
        let [at, axis] = [vector(random, 1.0), vector(random, 1.0)];
        let ([a, b, c], off) = (
            [(); 3].map(|()| 0.3 + random.within(0.05)),
            vector(random, 0.2),
        );
        let (mass, turn) = (1.0 + random.within(0.5), random.within(2.0));
        let _ = write!(
            text,
            "part{i}: Body(mass = {mass}, inertia = diag({a}, {b}, {c}), at = {at}, center_of_mass = {off}, \
             orientation = turn({axis}, {turn})), "
        );
        let before = match i {
            0 => "ground".to_owned(),
            _ => format!("part{}", random.between(0, i - 1)),
        };
        let _ = write!(
            text,
            "pin{i}: {}, ",
            joint(random, &before, &format!("part{i}"), 6)
        );
    }
    let last = format!("part{}", count - 1);
    if random.between(0, 1) == 1 {
        let _ = write!(text, "close: {}, ", joint(random, "ground", &last, 3));
    }
    let [from, to, push] = [
        vector(random, 1.0),
        vector(random, 0.4),
        vector(random, 5.0),
    ];
    let [x, y, z] = [(); 3].map(|()| random.within(0.5));
    let _ = write!(
        text,
        "anchor: Point({from}), spring: SpringDamper(anchor, {last}.origin, stiffness = 20.0, damping = 0.5, length = 0.4), \
         push: Force(part0.origin, value = {push}), stir: Torque({last}, value = {to}), "
    );
    for i in 0..count {
        let _ = write!(
            text,
            "part{i}_at: Output(part{i}.point({x}, {y}, {z})), part{i}_speed: Output(part{i}.point({x}, {y}, {z}).velocity), "
        );
    }
    text + "}"
}

fn vector(random: &mut Random, size: f64) -> String {
    let [x, y, z] = [(); 3].map(|()| random.within(size));
    format!("[{x}, {y}, {z}]")
}

/// One of the first kinds of joints, at any place and with any axis.
fn joint(random: &mut Random, first: &str, second: &str, kinds: usize) -> String {
    let (at, axis) = (vector(random, 1.0), vector(random, 1.0));
    match random.between(0, kinds - 1) {
        0 => format!("Spherical({first}, {second}, at = {at})"),
        1 => format!("Cylindrical({first}, {second}, at = {at}, axis = {axis})"),
        2 => format!("Planar({first}, {second}, at = {at}, axis = {axis})"),
        3 => format!("Revolute({first}, {second}, at = {at}, axis = {axis})"),
        4 => format!("Prismatic({first}, {second}, at = {at}, axis = {axis})"),
        _ => format!(
            "Universal({first}, {second}, at = {at}, axis = [0.0, 1.0, 0.2], second_axis = [1.0, 0.0, 0.0])"
        ),
    }
}
