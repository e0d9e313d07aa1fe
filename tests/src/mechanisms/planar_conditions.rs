//! Conditions on the positions and velocities of mechanisms of the plane: drives, gears, couplings, rods, edges and
//! belts.

use super::planar::{Part, ground};
use super::{motion, nonholonomic, speed};
use crate::random::Random;
use std::fmt::Write;

/// One or two conditions, at most as many as there are freedoms, and perhaps a sled.
pub(super) fn write(text: &mut String, parts: &[Part], freedoms: usize, random: &mut Random) {
    // The point in which a loop is closed may be fixed: a condition on it would be refused.
    let movable = match freedoms + 1 < parts.len() {
        true => &parts[..parts.len() - 1],
        false => parts,
    };
    for i in 0..random.between(1, freedoms.min(2)) {
        condition(text, &format!("condition{i}"), movable, random);
    }
    if random.between(0, 3) == 0 {
        sled(text, &parts[parts.len() - 1], random);
    }
}

fn condition(text: &mut String, name: &str, parts: &[Part], random: &mut Random) {
    let [first, second] = two(parts, random);
    let (point, at) = first.point(random);
    let (part, angle) = (&first.name, first.angle);
    let anchor = [at[0] + 0.8 + random.within(0.3), at[1] + random.within(0.5)];
    let distance = (at[0] - anchor[0]).hypot(at[1] - anchor[1]);
    let ratio = 1.5 + random.within(1.0);
    let _ = match random.between(0, 9) {
        0 => write!(
            text,
            "{name}: Drive({part}.angle, value = {}), ",
            motion(random, angle, "rad")
        ),
        1 => {
            // Its rate once more, as a condition on velocities.
            let rate = random.within(0.5);
            write!(
                text,
                "{name}: Drive({part}.angle, value = {angle} + {rate}_rad_per_s * t), \
                 {name}_again: Nonholonomic({part}.rate - {rate}_rad_per_s), "
            )
        }
        2 => write!(
            text,
            "{name}: Drive({point}.x, value = {}), ",
            motion(random, at[0], "m")
        ),
        3 => write!(
            text,
            "{name}: Holonomic(norm({point} - {}) - ({})), ",
            ground(anchor),
            motion(random, distance, "m")
        ),
        4 => write!(
            text,
            "{name}: Distance({}, {point}, length = {distance}), ",
            ground(anchor)
        ),
        5 if first.name != second.name => write!(
            text,
            "{name}: Gear({part}, {}, ratio = {ratio}, offset = {}), ",
            second.name,
            second.angle - ratio * angle
        ),
        5 | 6 => {
            let (other, [_, y]) = second.point(random);
            write!(
                text,
                "{name}: Coupling({point}.x, {other}.y, ratio = {ratio}, offset = {}), ",
                y - ratio * at[0]
            )
        }
        7 => {
            let condition = format!("dot({point}.velocity, {part}.y){}", speed(random));
            nonholonomic(text, name, &condition, random);
            Ok(())
        }
        8 => {
            let condition = format!(
                "{point}.velocity.x + {ratio} * {point}.velocity.y{}",
                speed(random)
            );
            nonholonomic(text, name, &condition, random);
            Ok(())
        }
        _ => {
            let condition = format!(
                "dot({point}.velocity, {part}.x) - {distance}_m * {}.rate",
                second.name
            );
            nonholonomic(text, name, &condition, random);
            Ok(())
        }
    };
}

/// Two parts, perhaps the same.
fn two<'a>(parts: &'a [Part], random: &mut Random) -> [&'a Part; 2] {
    [(); 2].map(|()| &parts[random.between(0, parts.len() - 1)])
}

/// A free body on an edge, which the last part draws.
fn sled(text: &mut String, last: &Part, random: &mut Random) {
    let [x, y, angle, off] = [1.0, 1.0, 3.0, 0.3].map(|size| random.within(size));
    let (hook, _) = last.point(random);
    let edge = format!(
        "dot(sled.velocity_at(sled.point({off}, 0.1)), sled.y){}",
        speed(random)
    );
    let _ = write!(
        text,
        "sled: Body(mass = 1.3, inertia = 0.2, at = [{x}, {y}], angle = {angle}, center_of_mass = [0.2, {off}]), \
         rope: SpringDamper({hook}, sled.point(0.3, -0.1), stiffness = 15.0, damping = 0.7, length = 0.3), \
         sled_at: Output(sled.origin), sled_rate: Output(sled.rate), "
    );
    nonholonomic(text, "edge", &edge, random);
}
