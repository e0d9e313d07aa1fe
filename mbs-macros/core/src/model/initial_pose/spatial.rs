//! Initial poses in space.

use super::guesses::Guesses;
use super::joint::joint_guess;
use super::quaternion::quaternion;
use crate::model::elements::JointEntry;
use crate::model::geometry::{Owner, Point, Vector};
use crate::model::parts::{Part, Representation};
use crate::model::resolver::Resolver;
use crate::model::tree::Tree;

/// The home pose as initial guess. Velocities that were not declared are computed along the joints from the ground
/// outwards. Unknown ones start at zero, and assembly corrects all of them.
pub(super) fn guesses(resolver: &mut Resolver, joints: &[JointEntry], tree: &Tree) -> Guesses {
    let mut guesses = Guesses::default();
    let parts = resolver.parts.clone();
    let speeds = origin_velocities(resolver, &parts, joints);
    let zero = resolver.graph.zero();
    let length = resolver.largest_length(joints);
    for joint in &tree.joints {
        joint_guess(resolver, &parts, &speeds, joint, length, &mut guesses);
    }
    for (index, (part, &speed)) in parts.iter().zip(&speeds).enumerate() {
        let Some(home) = part.home else {
            let (value, rate) = (
                part.guess.angle.unwrap_or(zero),
                part.guess.rate.unwrap_or(zero),
            );
            if part.representation.is_number() {
                guesses.set(part.locals[0], value, rate);
            }
            continue;
        };
        let spin = part.guess.spin.unwrap_or([zero; 3]);
        let points: Vec<Vector> = match part.representation {
            Representation::Natural => {
                vec![[zero; 3], [part.length.unwrap_or(zero), zero, zero]]
            }
            Representation::FreePoint => vec![[zero; 3]],
            Representation::Rigid => vec![part.center],
            _ => Vec::new(),
        };
        for (slot, local) in points.into_iter().enumerate() {
            let graph = &mut resolver.graph;
            let arm = graph.turn(&home.axes, local);
            let position = graph.vector_add(home.origin, arm);
            let swing = graph.cross(spin, arm);
            let mut velocity = graph.vector_add(speed, swing);
            if part.representation == Representation::Natural {
                let point = (Owner::Part(index), local);
                velocity = joined_velocity(resolver, point, &speeds, joints).unwrap_or(velocity);
            }
            for axis in 0..3 {
                guesses.set(part.locals[3 * slot + axis], position[axis], velocity[axis]);
            }
        }
        if let Some(first) = part.rotation() {
            let quaternion = quaternion(resolver, &home.axes);
            guesses.set_quaternion(first, quaternion);
            let omega = resolver.graph.components(&home.axes, spin);
            for (turn, rate) in (first..).zip(omega) {
                guesses.set(turn, zero, rate);
            }
        }
    }
    guesses
}

/// The velocity of an end of a slender bar, which has no declared one: that of a part joined there, straight or by way of
/// others, that has.
fn joined_velocity(
    resolver: &mut Resolver,
    end: (Owner, Vector),
    speeds: &[Vector],
    joints: &[JointEntry],
) -> Option<Vector> {
    let pairs: Vec<&[Point; 2]> = joints
        .iter()
        .filter_map(|element| element.joint.coincident.as_ref())
        .collect();
    let mut points = vec![end];
    let mut next = 0;
    while let Some(&(owner, local)) = points.get(next) {
        next += 1;
        if let Owner::Part(part) = owner {
            let guess = &resolver.parts[part].guess;
            if guess.velocity.is_some() || guess.spin.is_some() {
                let spin = guess.spin.unwrap_or(resolver.graph.zero_vector());
                let home = resolver.home(owner);
                let arm = resolver.graph.turn(&home.axes, local);
                let swing = resolver.graph.cross(spin, arm);
                return Some(resolver.graph.vector_add(speeds[part], swing));
            }
        }
        for [a, b] in &pairs {
            for (own, other) in [(a, b), (b, a)] {
                let joined = (other.owner, other.local);
                if (own.owner, own.local) == (owner, local) && !points.contains(&joined) {
                    points.push(joined);
                }
            }
        }
    }
    None
}

/// The velocity of the origin of each part.
fn origin_velocities(
    resolver: &mut Resolver,
    parts: &[Part],
    joints: &[JointEntry],
) -> Vec<Vector> {
    let zero = resolver.graph.zero_vector();
    let mut speeds: Vec<Option<Vector>> = parts.iter().map(|part| part.guess.velocity).collect();
    let spin = |owner: Owner| match owner {
        Owner::Ground => zero,
        Owner::Part(part) => parts[part].guess.spin.unwrap_or(zero),
    };
    let pairs: Vec<&[Point; 2]> = joints
        .iter()
        .filter_map(|element| element.joint.coincident.as_ref())
        .collect();
    let mut progress = true;
    while progress {
        progress = false;
        for [a, b] in &pairs {
            for (known, unknown) in [(a, b), (b, a)] {
                let speed = match known.owner {
                    Owner::Ground => Some(zero),
                    Owner::Part(part) => speeds[part],
                };
                let (Some(speed), Owner::Part(part)) = (speed, unknown.owner) else {
                    continue;
                };
                if speeds[part].is_some() {
                    continue;
                }
                // v + ω × arm of the known part, less the same of the unknown one.
                let mut velocity = speed;
                for (point, sign) in [(known, 1.0), (unknown, -1.0)] {
                    let home = resolver.home(point.owner);
                    let arm = resolver.graph.turn(&home.axes, point.local);
                    let swing = resolver.graph.cross(spin(point.owner), arm);
                    let swing = swing.map(|x| resolver.graph.scale(sign, x));
                    velocity = resolver.graph.vector_add(velocity, swing);
                }
                speeds[part] = Some(velocity);
                progress = true;
            }
        }
    }
    speeds
        .into_iter()
        .map(|speed| speed.unwrap_or(zero))
        .collect()
}
