//! Conditions on the positions and velocities of mechanisms of space, slender bars, a rolling disk, and forces in
//! joints.

use super::spatial::{Part, SLIDING, TURNING, vector};
use super::{motion, nonholonomic, speed};
use crate::random::Random;
use std::fmt::Write;

/// One or two conditions, at most as many as there are freedoms, perhaps with bars, a disk, and forces in joints.
pub(super) fn write(text: &mut String, parts: &[Part], freedoms: usize, random: &mut Random) {
    for i in 0..random.between(1, freedoms.min(2)) {
        condition(text, &format!("condition{i}"), parts, random);
    }
    let last = &parts[parts.len() - 1];
    match random.between(0, 5) {
        0 | 1 => bars(text, last, random),
        2 => disk(text, last, random),
        _ => {}
    }
    for i in of_kinds(parts, &TURNING) {
        if random.between(0, 2) == 0 {
            let _ = write!(
                text,
                "coil{i}: TorsionSpring(pin{i}, stiffness = 3.0, damping = 0.2, angle = 0.3), "
            );
        }
    }
    if random.between(0, 3) == 0 {
        let at = vector(random, 1.0);
        let _ = write!(
            text,
            "mount: Bushing(ground, {}, at = {at:?}, stiffness = [30.0, 20.0, 10.0], damping = 0.6, \
             torsion_stiffness = 2.0, torsion_damping = 0.1), ",
            last.name
        );
    }
}

/// The numbers of the parts whose joints are of these kinds.
fn of_kinds(parts: &[Part], kinds: &[usize]) -> Vec<usize> {
    let all = 0..parts.len();
    all.filter(|&i| kinds.contains(&parts[i].pin)).collect()
}

fn condition(text: &mut String, name: &str, parts: &[Part], random: &mut Random) {
    let part = &parts[random.between(0, parts.len() - 1)];
    let (turning, sliding) = (of_kinds(parts, &TURNING), of_kinds(parts, &SLIDING));
    let one = |list: &[usize], random: &mut Random| list[random.between(0, list.len() - 1)];
    let place = vector(random, 0.5);
    let away = vector(random, 0.5).map(|x| x + 0.4_f64.copysign(x));
    let anchor: [f64; 3] = std::array::from_fn(|k| part.at[k] + away[k]);
    let distance = away.iter().map(|x| x * x).sum::<f64>().sqrt();
    let (body, [x, y, z]) = (&part.name, place);
    let point = format!("{body}.point({x}, {y}, {z})");
    let _ = match random.between(0, 11) {
        0 if !turning.is_empty() => {
            let pin = one(&turning, random);
            write!(
                text,
                "{name}: Drive(pin{pin}.angle, value = {}), ",
                motion(random, 0.0, "rad")
            )
        }
        1 if !sliding.is_empty() => {
            // Its speed once more, as a condition on velocities.
            let (pin, rate) = (one(&sliding, random), random.within(0.5));
            write!(
                text,
                "{name}: Drive(pin{pin}.stroke, value = {rate}_m_per_s * t), \
                 {name}_again: Nonholonomic(pin{pin}.speed - {rate}_m_per_s), "
            )
        }
        2 if turning.len() > 1 => write!(
            text,
            "{name}: Gear(pin{}, pin{}, ratio = -1.3), ",
            turning[0], turning[1]
        ),
        3 if !turning.is_empty() && !sliding.is_empty() => {
            let (pinion, rack) = (one(&turning, random), one(&sliding, random));
            match pinion == rack && parts[pinion].pin == 6 {
                // A thread fixes its own ratio.
                true => Ok(()),
                false => write!(
                    text,
                    "{name}: RackPinion(pin{pinion}, pin{rack}, radius = 0.2), "
                ),
            }
        }
        4 => write!(
            text,
            "{name}: PointOnPlane({body}.origin, ground.point({}, {}, {}), normal = {away:?}), ",
            part.at[0], part.at[1], part.at[2]
        ),
        5 => write!(
            text,
            "{name}: Drive({body}.origin.z, value = {}), ",
            motion(random, part.at[2], "m")
        ),
        6 => write!(
            text,
            "{name}: Distance(ground.point({}, {}, {}), {body}.origin, length = {distance}), ",
            anchor[0], anchor[1], anchor[2]
        ),
        7 => write!(
            text,
            "{name}: Holonomic(norm({body}.origin - {anchor:?}) - ({})), ",
            motion(random, distance, "m")
        ),
        8 => {
            let condition = format!("dot({point}.velocity, {body}.y){}", speed(random));
            nonholonomic(text, name, &condition, random);
            Ok(())
        }
        9 => {
            let condition = format!("dot({point}.velocity, {away:?}){}", speed(random));
            nonholonomic(text, name, &condition, random);
            Ok(())
        }
        10 => {
            let condition = format!("dot({body}.angular_velocity, {body}.x - {place:?})");
            nonholonomic(text, name, &condition, random);
            Ok(())
        }
        _ => {
            let condition = format!(
                "{point}.velocity.x - {distance}_m * dot({body}.angular_velocity, {body}.z)"
            );
            nonholonomic(text, name, &condition, random);
            Ok(())
        }
    };
}

/// Slender bars that hang on a body, with a bob at their end.
fn bars(text: &mut String, last: &Part, random: &mut Random) {
    let mut end = last.at;
    let mut before = format!("{}.origin", last.name);
    for i in 0..random.between(1, 2) {
        let way = vector(random, 0.5);
        let to: [f64; 3] = std::array::from_fn(|k| end[k] + way[k]);
        let _ = write!(
            text,
            "bar{i}: Bar(mass = 0.4, from = {end:?}, to = {to:?}), knot{i}: Spherical({before}, bar{i}.a), \
             bar{i}_at: Output(bar{i}.b), bar{i}_speed: Output(bar{i}.center.velocity), "
        );
        (end, before) = (to, format!("bar{i}.b"));
    }
    if random.between(0, 1) == 0 {
        let _ = write!(
            text,
            "bob: Particle(mass = 0.3, at = {end:?}), eye: Spherical({before}, bob.origin), "
        );
    }
}

/// A disk that rolls on a plane, drawn by a body. The third component of its slip follows from the contact.
fn disk(text: &mut String, last: &Part, random: &mut Random) {
    let lean = random.within(0.6);
    let height = 0.3 * lean.cos();
    let [x, y, _] = vector(random, 1.0);
    let third = match random.between(0, 1) {
        0 => ", dot(slip, ground.z)",
        _ => "",
    };
    let _ = write!(
        text,
        "disk: Body(mass = 2.0, inertia = diag(0.1, 0.2, 0.12), at = [{x}, {y}, {height}], orientation = turn(X, {lean})), \
         down: Let(-unit(reject(ground.z, disk.y))), contact: Let(disk.origin + 0.3_m * down), \
         slip: Let(disk.velocity_at(contact)), touch: Holonomic(dot(contact, ground.z)), \
         no_slip: Nonholonomic([dot(slip, ground.x), dot(slip, ground.y){third}]), \
         tether: SpringDamper({}.origin, disk.point(0.1, 0.0, 0.1), stiffness = 12.0, damping = 0.4, length = 0.2), \
         disk_at: Output(disk.origin), disk_spin: Output(disk.angular_velocity), ",
        last.name
    );
}
