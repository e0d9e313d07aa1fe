//! What an animation draws.

use super::elements::{ForceEntry, JointEntry};
use super::geometry::{Owner, Point, Vector};
use super::resolver::Resolver;
use crate::symbolic::{Function, Map};
use std::collections::HashMap;

/// Points and lines, and where reactions act.
#[derive(Debug, Clone, Default)]
pub struct Drawing {
    /// Points with their names.
    pub points: Vec<(String, Vector)>,
    /// Lines: part or spring, from, to.
    pub segments: Vec<(String, usize, usize)>,
    /// How many of the last points are marks: they only show how a body turns.
    pub marks: usize,
    /// Joints with the point that their reaction acts on.
    pub sites: Vec<(String, usize)>,
    /// The first point at each place.
    first_at: Map<Vector, usize>,
}

impl Drawing {
    /// The point at this place among those from `first` on; it is added if there is none.
    fn point(&mut self, first: usize, point: &Point) -> usize {
        let known = match first {
            0 => self.first_at.get(&point.position).copied(),
            _ => {
                let mut own = self.points[first..].iter().zip(first..);
                let own = own.find(|((_, position), _)| *position == point.position);
                own.map(|(_, index)| index)
            }
        };
        known.unwrap_or_else(|| {
            self.push(point.label.clone(), point.position);
            self.points.len() - 1
        })
    }

    fn push(&mut self, name: String, position: Vector) {
        self.first_at.entry(position).or_insert(self.points.len());
        self.points.push((name, position));
    }

    /// Where the reaction of each joint acts.
    pub fn sites(&self) -> HashMap<&str, usize> {
        // Of several the first counts.
        let sites = self.sites.iter().rev();
        sites.map(|(name, point)| (name.as_str(), *point)).collect()
    }
}

impl Resolver<'_> {
    /// Bars from end to end, bodies from their origin to their joints and points that have a name, springs between their points.
    pub(super) fn drawing(&mut self, joints: &[JointEntry], forces: &[ForceEntry]) -> Drawing {
        let mut drawing = Drawing::default();
        let mut attached = self.attached(joints, forces);
        // Bodies of which one point alone is drawn, with this point.
        let mut turning = Vec::new();
        for index in 0..self.parts.len() {
            let owner = Owner::Part(index);
            let part = &self.parts[index];
            let (name, kind) = (part.name.clone(), part.kind);
            if part.representation.is_number() {
                continue;
            }
            let first = drawing.points.len();
            for end in if kind == "Bar" {
                vec!["a", "b"]
            } else {
                vec!["origin"]
            } {
                if let Some(point) = self.named_point(owner, end) {
                    drawing.push(point.label, point.position);
                }
            }
            if kind == "Bar" {
                drawing.segments.push((name, first, first + 1));
                continue;
            }
            let mut attached = std::mem::take(&mut attached[index]);
            // Without any, the centre of mass at least shows how the body turns.
            if attached.is_empty() {
                attached.extend(self.named_point(owner, "center"));
            }
            let lines = drawing.segments.len();
            for point in &attached {
                let before = drawing.points.len();
                let to = drawing.point(first, point);
                if to == before {
                    drawing.segments.push((name.clone(), first, to));
                }
            }
            let part = &self.parts[index];
            let alone = drawing.segments.len() == lines && part.shape.is_none();
            if kind == "Body" && alone && !self.graph.is_zero(part.mass) {
                turning.push((index, first));
            }
        }
        for index in 0..self.parts.len() {
            self.outline(index, &mut drawing);
        }
        for element in forces {
            if let [from, to] = &element.force.points[..] {
                let ends = (drawing.point(0, from), drawing.point(0, to));
                drawing
                    .segments
                    .push((element.name.clone(), ends.0, ends.1));
            }
        }
        for element in joints {
            let points = &element.joint.points;
            let moving = points.iter().rev().find(|p| p.owner != Owner::Ground);
            if let Some(point) = moving {
                let site = drawing.point(0, point);
                drawing.sites.push((element.name.clone(), site));
            }
        }
        drawing.marks = turning.len();
        for (index, origin) in turning {
            self.mark(index, origin, &mut drawing);
        }
        drawing
    }

    /// The points of each part: of joints, of forces, and those that have a name of their own.
    fn attached(&self, joints: &[JointEntry], forces: &[ForceEntry]) -> Vec<Vec<Point>> {
        let mut attached = vec![Vec::new(); self.parts.len()];
        let of_joints = joints.iter().flat_map(|element| &element.joint.points);
        let of_forces = forces.iter().flat_map(|element| &element.force.points);
        let points = of_joints.chain(of_forces).cloned();
        for point in points.chain(self.declared_points()) {
            if let Some(part) = point.owner.part() {
                attached[part].push(point);
            }
        }
        attached
    }

    /// A line from the origin of a body: to its centre of mass or, where that is the origin, along its x axis, as long as
    /// its radius of gyration.
    fn mark(&mut self, index: usize, origin: usize, drawing: &mut Drawing) {
        let part = &self.parts[index];
        let (name, frame, mut place) = (part.name.clone(), part.frame.clone(), part.center);
        let (inertia, mass) = (part.inertia[2][2], part.mass);
        if place.iter().all(|&x| self.graph.is_zero(x)) {
            let square = self.graph.div(inertia, mass);
            place[0] = self.graph.function(Function::Sqrt, square);
        }
        let position = self.graph.place(&frame, place);
        drawing.push(format!("{name}.mark"), position);
        let mark = drawing.points.len() - 1;
        drawing.segments.push((name, origin, mark));
    }

    /// The wireframe of a part that has a shape, about its centre of mass.
    fn outline(&mut self, index: usize, drawing: &mut Drawing) {
        let part = &self.parts[index];
        let Some(shape) = part.shape else {
            return;
        };
        let (name, center, mut frame) = (part.name.clone(), part.center, part.frame.clone());
        // The sums of each corner begin with those of the origin, which are computed once.
        frame.origin = frame
            .origin
            .map(|x| self.graph.function(Function::Apart, x));
        let (corners, edges) = shape.wireframe(&mut self.graph);
        let first = drawing.points.len();
        for corner in corners {
            let local = self.graph.vector_add(center, corner);
            let position = self.graph.place(&frame, local);
            drawing.push(format!("{name}.outline"), position);
        }
        let edges = edges.into_iter();
        drawing
            .segments
            .extend(edges.map(|(from, to)| (name.clone(), first + from, first + to)));
    }
}
