//! Initial poses in the plane: what was declared, carried along the joints from the ground outwards.
//!
//! The pose of a part is known if its angle and one of its points are known, or two of its points; then all its points
//! are known, and its neighbours follow; so does what is declared to start at one of its points. An angle that remains
//! unknown starts at 0 at a known point, and a part that no known point reaches also at the place 0; assembly corrects all
//! of them.

use super::guesses::Guesses;
use super::held_angles::{Angle, HeldAngles};
use crate::model::elements::JointEntry;
use crate::model::geometry::{Axes, Owner, Point, Vector};
use crate::model::mobilizer::Freedom;
use crate::model::parts::{Part, Representation, StartPlace};
use crate::model::resolver::Resolver;
use crate::model::tree::Tree;
use crate::symbolic::{Expr, Graph, Substitution, Symbol};

/// A placed frame: origin, axis, and their rates.
#[derive(Clone, Copy)]
struct Pose {
    origin: Vector,
    velocity: Vector,
    angle: Expr,
    axes: Axes,
    rate: Expr,
}

/// Where a point is and how fast it moves.
#[derive(Clone, Copy)]
struct Known {
    position: Vector,
    velocity: Vector,
}

/// Which poses are taken where no better one is left.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Trust {
    /// Those that follow from what is declared.
    Known,
    /// Those whose angle a joint carries from another part.
    Carried,
    /// Those with angle zero at a known point.
    AtPoint,
    /// Those with angle and place zero.
    Zero,
}

/// The places of points, as far as they are known.
struct Places<'a> {
    parts: &'a [Part],
    /// The values of declared coordinates and inputs, and t = 0.
    values: Substitution,
    poses: Vec<Option<Pose>>,
}

impl Places<'_> {
    fn of(&mut self, graph: &mut Graph, point: &Point) -> Option<Known> {
        let part = match point.owner {
            Owner::Ground => {
                return Some(Known {
                    position: point.position,
                    velocity: graph.zero_vector(),
                });
            }
            Owner::Part(part) => part,
        };
        if self.parts[part].representation != Representation::Prescribed {
            let pose = self.poses[part]?;
            return Some(point_of(graph, &pose, point.local));
        }
        let rates = point.position.map(|x| graph.rate(x));
        let [position, velocity] = [point.position, rates]
            .map(|vector| vector.map(|x| graph.substitute(x, &mut self.values)));
        // Those of a part that follows another one are not known.
        let moves = graph.any_depends_on(position.into_iter().chain(velocity), |symbol| {
            !symbol.is_parameter_like()
        });
        (!moves).then_some(Known { position, velocity })
    }
}

/// The guesses of all parts' coordinates.
pub(super) fn guesses(resolver: &mut Resolver, joints: &[JointEntry]) -> Guesses {
    let parts = resolver.parts.clone();
    let pairs: Vec<&[Point; 2]> = joints
        .iter()
        .filter_map(|element| element.joint.coincident.as_ref())
        .collect();
    let mut pairs_of: Vec<Vec<&[Point; 2]>> = vec![Vec::new(); parts.len()];
    for pair in pairs {
        let mut owners = pair.each_ref().map(|point| point.owner).to_vec();
        owners.dedup();
        for owner in owners {
            if let Owner::Part(part) = owner {
                pairs_of[part].push(pair);
            }
        }
    }
    let mut values = known_at_start(resolver, &parts);
    let mut angles = HeldAngles::new(&mut resolver.graph, &parts, joints, &mut values);
    let mut places = Places {
        parts: &parts,
        values,
        poses: vec![None; parts.len()],
    };
    let mut trust = Trust::Known;
    loop {
        let mut progress = false;
        for (index, part) in parts.iter().enumerate() {
            if places.poses[index].is_some()
                || part.representation == Representation::Prescribed
                || part.representation.is_number()
            {
                continue;
            }
            let graph = &mut resolver.graph;
            let mut known = joined_points(graph, index, &pairs_of[index], &mut places);
            known.extend(declared_points(graph, part, &mut places));
            if let Some(pose) = pose(graph, part, angles.of(index), &known, trust) {
                angles.found(graph, index, pose.angle, pose.rate);
                places.poses[index] = Some(pose);
                progress = true;
                if trust > Trust::Known {
                    break;
                }
            }
        }
        trust = match (progress, trust) {
            (true, _) => Trust::Known,
            (false, Trust::Known) => Trust::Carried,
            (false, Trust::Carried) => Trust::AtPoint,
            (false, Trust::AtPoint) => Trust::Zero,
            (false, Trust::Zero) => break,
        };
    }
    let mut guesses = Guesses::default();
    for (index, (part, pose)) in parts.iter().zip(places.poses).enumerate() {
        if part.representation.is_number() {
            let zero = resolver.graph.zero();
            let value = (
                part.guess.angle.unwrap_or(zero),
                part.guess.rate.unwrap_or(zero),
            );
            guesses.set(part.locals[0], value.0, value.1);
        } else if let Some(pose) = pose {
            store(&mut resolver.graph, part, &pose, &mut guesses);
            if part.representation == Representation::Natural {
                guesses.set_angle(index, pose.angle);
            }
        }
    }
    guesses
}

/// The strokes of the tree's joints in the plane, from the places of their partners.
pub(super) fn strokes(resolver: &mut Resolver, tree: &Tree, guesses: &mut Guesses) {
    for joint in &tree.joints {
        for (freedom, local) in joint.freedoms() {
            let Freedom::Slide(axis) = *freedom else {
                continue;
            };
            let graph = &mut resolver.graph;
            let (parent, child) = (&joint.mobilizer.parent, &joint.mobilizer.child);
            let gap = graph.vector_sub(child.point.position, parent.point.position);
            let stroke = graph.dot(parent.axes[axis], gap);
            let speed = graph.rate(stroke);
            let mut known = Substitution::default();
            for symbol in graph.symbols([stroke, speed]) {
                let value = match symbol {
                    Symbol::LocalPosition(local) => guesses.position(local, graph),
                    Symbol::LocalVelocity(local) => guesses.velocity(local, graph),
                    _ => continue,
                };
                known.insert(symbol, value);
            }
            let sign = joint.mobilizer.sign();
            let [stroke, speed] = [stroke, speed].map(|x| {
                let motion = graph.substitute(x, &mut known);
                graph.scale(sign, motion)
            });
            guesses.set(local, stroke, speed);
        }
    }
}

/// The points of a part that its joints place: (local coordinates in the part, position and velocity).
fn joined_points(
    graph: &mut Graph,
    part: usize,
    pairs: &[&[Point; 2]],
    places: &mut Places,
) -> Vec<(Vector, Known)> {
    let mut known = Vec::new();
    for [a, b] in pairs {
        for (own, other) in [(a, b), (b, a)] {
            if own.owner == Owner::Part(part) {
                known.extend(places.of(graph, other).map(|place| (own.local, place)));
            }
        }
    }
    known
}

/// The declared coordinates and their rates with their guesses, the inputs with their defaults, and t = 0.
fn known_at_start(resolver: &mut Resolver, parts: &[Part]) -> Substitution {
    let graph = &mut resolver.graph;
    let mut values = Substitution::default();
    values.insert(Symbol::Time, graph.zero());
    for (input, quantity) in (0..).zip(&resolver.inputs) {
        values.insert(Symbol::Input(input), graph.constant(quantity.default));
    }
    for part in parts.iter().filter(|part| part.representation.is_number()) {
        let (local, zero) = (part.locals[0], graph.zero());
        let (value, rate) = (part.guess.angle, part.guess.rate);
        values.insert(Symbol::LocalPosition(local), value.unwrap_or(zero));
        values.insert(Symbol::LocalVelocity(local), rate.unwrap_or(zero));
    }
    values
}

/// The points of a part whose places are declared, as far as these are known.
fn declared_points(graph: &mut Graph, part: &Part, places: &mut Places) -> Vec<(Vector, Known)> {
    let (guess, zero) = (&part.guess, graph.zero());
    let velocity = guess.velocity.unwrap_or([zero; 3]);
    let origin = guess.origin.as_ref();
    let origin = origin.map(|place| ([zero; 3], place, velocity));
    let end = guess.end.as_ref().zip(part.length);
    let end = end.map(|(place, length)| ([length, zero, zero], place, [zero; 3]));
    let declared = origin.into_iter().chain(end);
    let known = declared.filter_map(|(local, place, velocity)| {
        let position = match place {
            StartPlace::Known(position) => *position,
            StartPlace::Of(point) => places.of(graph, point)?.position,
        };
        Some((local, Known { position, velocity }))
    });
    known.collect()
}

fn point_of(graph: &mut Graph, pose: &Pose, local: Vector) -> Known {
    let arm = graph.turn(&pose.axes, local);
    let turned = graph.perpendicular(arm);
    let swing = graph.vector_scale(pose.rate, turned);
    Known {
        position: graph.vector_add(pose.origin, arm),
        velocity: graph.vector_add(pose.velocity, swing),
    }
}

fn pose(
    graph: &mut Graph,
    part: &Part,
    angle: Option<Angle>,
    known: &[(Vector, Known)],
    trust: Trust,
) -> Option<Pose> {
    let zero = graph.zero();
    let guess = &part.guess;
    let is_point = part.kind == "Particle";
    let by_points = two_points(graph, known);
    // A part that starts at its declared angle, without a rate, starts without turning.
    let of_points = by_points.filter(|_| guess.angle.is_none());
    let rate = angle.and_then(|angle| angle.rate);
    let rate = guess.rate.or(rate).or(of_points.map(|(_, rate)| rate));
    let rate = rate.unwrap_or(zero);
    let (angle, rate) = match (angle, by_points) {
        (Some(own), _) if own.is_firm => (own.angle, rate),
        _ if is_point => (zero, zero),
        (_, Some((angle, of_points))) => (angle, guess.rate.unwrap_or(of_points)),
        (Some(carried), None) if trust >= Trust::Carried => (carried.angle, rate),
        (None, None) if trust >= Trust::AtPoint => (zero, rate),
        _ => return None,
    };
    let x = graph.direction(angle);
    let axes = graph.planar_axes(x);
    let (local, place) = match known.first() {
        Some(known) => *known,
        None if trust == Trust::Zero => (
            [zero; 3],
            Known {
                position: [zero; 3],
                velocity: guess.velocity.unwrap_or([zero; 3]),
            },
        ),
        None => return None,
    };
    // origin = known point − its arm, and the same for velocities
    let mut pose = Pose {
        origin: [zero; 3],
        velocity: [zero; 3],
        angle,
        axes,
        rate,
    };
    let arm = point_of(graph, &pose, local);
    pose.origin = graph.vector_sub(place.position, arm.position);
    pose.velocity = graph.vector_sub(place.velocity, arm.velocity);
    Some(pose)
}

/// Angle and rate from two known points at different places of the part.
fn two_points(graph: &mut Graph, known: &[(Vector, Known)]) -> Option<(Expr, Expr)> {
    let (first, second) = known
        .iter()
        .enumerate()
        .find_map(|(i, a)| known[i + 1..].iter().find(|b| b.0 != a.0).map(|b| (a, b)))?;
    let inside = graph.vector_sub(second.0, first.0);
    let outside = graph.vector_sub(second.1.position, first.1.position);
    let spread = graph.vector_sub(second.1.velocity, first.1.velocity);
    // One arctangent, in (−π, π]: the difference of two can be a turn off.
    let sine = graph.planar_cross(inside, outside);
    let cosine = graph.dot(inside, outside);
    let angle = graph.atan2(sine, cosine);
    let cross = graph.planar_cross(outside, spread);
    let (square, usual) = (graph.dot(outside, outside), graph.dot(inside, inside));
    // Guesses may put both points at one place. Any angle and rate do there: assembly changes them.
    let least = graph.scale(1e-20, usual);
    let square = graph.larger(square, least);
    let rate = graph.div(cross, square);
    Some((angle, rate))
}

fn store(graph: &mut Graph, part: &Part, pose: &Pose, guesses: &mut Guesses) {
    let zero = graph.zero();
    let points: Vec<Vector> = match part.representation {
        Representation::Natural => vec![[zero; 3], [part.length.unwrap_or(zero), zero, zero]],
        Representation::FreePoint => vec![[zero; 3]],
        Representation::Reference => vec![part.center],
        Representation::Prescribed
        | Representation::Coordinate
        | Representation::State
        | Representation::Rigid => Vec::new(),
    };
    for (slot, local) in points.into_iter().enumerate() {
        let place = point_of(graph, pose, local);
        for axis in 0..2 {
            guesses.set(
                part.locals[2 * slot + axis],
                place.position[axis],
                place.velocity[axis],
            );
        }
    }
    if part.representation == Representation::Reference {
        guesses.set(part.locals[2], pose.angle, pose.rate);
    }
}
