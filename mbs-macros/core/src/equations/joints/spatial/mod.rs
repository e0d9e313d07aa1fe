//! Joints of space.
//!
//! Each is a selection of the same few conditions between two frames that coincide in the home pose: see [`Builder`].

mod constant_velocity;
mod cylindrical;
mod fixed;
mod gear;
mod planar;
mod point_on_line;
mod point_on_plane;
mod prismatic;
mod rack_pinion;
mod revolute;
mod screw;
mod spherical;
mod universal;

use super::{Joint, JointEquations, ReactionComponent, affine_relation, row};
use crate::model::{Arguments, Dimension, JointFrames, Owner, Point, Vector};
use crate::symbolic::{Expr, Graph};
use std::fmt::Debug;

/// Reads a joint of space.
pub(super) fn read(kind: &str, arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    match kind {
        "Revolute" => revolute::read(arguments),
        "Prismatic" => prismatic::read(arguments),
        "Cylindrical" => cylindrical::read(arguments),
        "Spherical" => spherical::read(arguments),
        "Universal" => universal::read(arguments),
        "ConstantVelocity" => constant_velocity::read(arguments),
        "Planar" => planar::read(arguments),
        "Fixed" => fixed::read(arguments),
        "Screw" => screw::read(arguments),
        "Gear" => gear::read(arguments),
        "RackPinion" => rack_pinion::read(arguments),
        "PointOnLine" => point_on_line::read(arguments),
        "PointOnPlane" => point_on_plane::read(arguments),
        _ => None,
    }
}

/// Collects rows between two frames p (parent) and c (child), with what their multipliers λ do to the child.
///
/// | condition | row | force on the child | torque on the child |
/// |---|---|---|---|
/// | [`coincide`](Builder::coincide) | the gap d = r_c − r_p, along X, Y, Z | λ along X, Y, Z | |
/// | [`on_plane`](Builder::on_plane) | p_k · d | λ p_k | |
/// | [`square`](Builder::square) | p_i · c_j | | λ c_j × p_i |
///
/// Rows are named by the direction that they hold: `x` or `rotation_x` where that is X in the home pose, `u`, `v`, `w` for
/// the joint's own axes where those are none of the ground's.
struct Builder<'g> {
    graph: &'g mut Graph,
    frames: &'g JointFrames,
    equations: JointEquations,
    force: [Vec<(usize, Expr)>; 3],
    torque: [Vec<(usize, Expr)>; 3],
}

impl<'g> Builder<'g> {
    fn new(graph: &'g mut Graph, frames: &'g JointFrames) -> Self {
        Builder {
            graph,
            frames,
            equations: JointEquations::default(),
            force: Default::default(),
            torque: Default::default(),
        }
    }

    fn gap(&mut self) -> Vector {
        let (parent, child) = (&self.frames.parent.point, &self.frames.child.point);
        self.graph.vector_sub(child.position, parent.position)
    }

    fn push(&mut self, suffix: &str, expr: Expr, dimension: Dimension) -> usize {
        self.equations.rows.push(row(suffix, expr, dimension));
        self.equations.rows.len() - 1
    }

    /// What λ of a row does to the child.
    fn acts(&mut self, row: usize, force: Option<Vector>, torque: Option<Vector>) {
        for (components, vector) in [(&mut self.force, force), (&mut self.torque, torque)] {
            for (component, x) in components.iter_mut().zip(vector.into_iter().flatten()) {
                if !self.graph.is_zero(x) {
                    component.push((row, x));
                }
            }
        }
    }

    /// The origins coincide.
    fn coincide(mut self) -> Self {
        let gap = self.gap();
        let axes = self.graph.ground_axes();
        for ((suffix, gap), axis) in ["x", "y", "z"].into_iter().zip(gap).zip(axes) {
            let row = self.push(suffix, gap, Dimension::LENGTH);
            self.acts(row, Some(axis), None);
        }
        self
    }

    /// The child's origin stays in the plane across axis k of the parent.
    fn on_plane(mut self, k: usize) -> Self {
        let normal = self.frames.parent.axes[k];
        let gap = self.gap();
        let distance = self.graph.dot(normal, gap);
        let row = self.push(self.frames.letters[k], distance, Dimension::LENGTH);
        self.acts(row, Some(normal), None);
        self
    }

    /// Axis i of the parent stays square to axis j of the child: no rotation about the third.
    fn square(mut self, i: usize, j: usize) -> Self {
        let (fixed, turned) = (self.frames.parent.axes[i], self.frames.child.axes[j]);
        let cosine = self.graph.dot(fixed, turned);
        let suffix = format!("rotation_{}", self.frames.letters[3 - i - j]);
        let row = self.push(&suffix, cosine, Dimension::NONE);
        let torque = self.graph.cross(turned, fixed);
        self.acts(row, None, Some(torque));
        self
    }

    /// The z axes stay parallel.
    fn parallel(self) -> Self {
        self.square(2, 1).square(2, 0)
    }

    fn finish(mut self) -> JointEquations {
        let names = [["fx", "fy", "fz"], ["tx", "ty", "tz"]];
        let dimensions = [Dimension::FORCE, Dimension::TORQUE];
        for ((components, names), dimension) in [self.force, self.torque]
            .into_iter()
            .zip(names)
            .zip(dimensions)
        {
            if components.iter().all(Vec::is_empty) {
                continue;
            }
            for (terms, name) in components.into_iter().zip(names) {
                self.equations.reactions.push(ReactionComponent {
                    name,
                    dimension,
                    terms,
                });
            }
        }
        self.equations
    }
}

/// λ · axes: the force on the first of two points, one row for each axis, which is fixed in the part of the other.
fn held_across(
    graph: &mut Graph,
    point: &Point,
    other: &Point,
    axes: &[(&str, Vector)],
) -> JointEquations {
    let gap = graph.vector_sub(point.position, other.position);
    let rows = axes
        .iter()
        .map(|(suffix, axis)| row(suffix, graph.dot(*axis, gap), Dimension::LENGTH))
        .collect();
    let reactions = ["fx", "fy", "fz"]
        .into_iter()
        .enumerate()
        .map(|(k, name)| ReactionComponent {
            name,
            dimension: Dimension::FORCE,
            terms: axes
                .iter()
                .enumerate()
                .map(|(row, (_, axis))| (row, axis[k]))
                .filter(|&(_, x)| !graph.is_zero(x))
                .collect(),
        })
        .collect();
    JointEquations { rows, reactions }
}

/// Two different parts, the second of which has axes.
fn sliding_points(arguments: &mut Arguments, surface: &str) -> Option<(Point, Point)> {
    let (point, other) = (arguments.point("point"), arguments.point(surface));
    let (point, other) = (point?, other?);
    let owner = arguments.owner_name(other.owner);
    if point.owner == other.owner {
        return arguments.fail(
            surface,
            format!("the point and the {surface} both belong to `{owner}`"),
        );
    }
    if arguments.is_particle(other.owner) || arguments.is_slender(other.owner) {
        return arguments.fail(
            surface,
            format!("`{owner}` has no orientation that could hold a {surface}; use a `Body`, or a `Bar` with `radius =`"),
        );
    }
    Some((point, other))
}

/// The two partners of a joint.
fn partners(frames: &JointFrames) -> Vec<&Point> {
    vec![&frames.parent.point, &frames.child.point]
}

/// Two joints whose coordinates a third relates.
#[derive(Debug)]
struct Relation {
    first: Expr,
    second: Expr,
    ratio: Expr,
    offset: Expr,
    unit: Dimension,
    reaction: (&'static str, Dimension),
    owners: Vec<Owner>,
}

impl Relation {
    fn owners(joints: [&JointFrames; 2]) -> Vec<Owner> {
        joints
            .iter()
            .flat_map(|joint| [joint.parent.point.owner, joint.child.point.owner])
            .collect()
    }
}

impl Joint for Relation {
    /// second − ratio · first − offset
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        let expr = affine_relation(graph, self.first, self.second, self.ratio, self.offset);
        let (name, dimension) = self.reaction;
        JointEquations {
            rows: vec![row("", expr, self.unit)],
            reactions: vec![ReactionComponent {
                name,
                dimension,
                terms: vec![(0, graph.one())],
            }],
        }
    }

    fn owners(&self) -> Vec<Owner> {
        self.owners.clone()
    }
}
