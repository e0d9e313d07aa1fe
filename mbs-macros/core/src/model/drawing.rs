//! What an animation draws.

use super::elements::{ForceElement, JointElement};
use super::geometry::{Owner, Vector};
use super::parts::Representation;
use super::resolve::Resolver;

impl Resolver<'_> {
    /// Points and lines for an animation: bars from end to end, bodies from their origin to their joints.
    pub(super) fn drawing(
        &mut self,
        joints: &[JointElement],
        forces: &[ForceElement],
    ) -> (Vec<(String, Vector)>, Vec<(String, usize, usize)>) {
        let mut points: Vec<(String, Vector)> = Vec::new();
        let mut segments = Vec::new();
        for index in 0..self.parts.len() {
            let owner = Owner::Part(index);
            let part = &self.parts[index];
            let (name, kind) = (part.name.clone(), part.kind);
            if part.representation == Representation::Coordinate {
                continue;
            }
            let first = points.len();
            for end in if kind == "Bar" {
                vec!["a", "b"]
            } else {
                vec!["origin"]
            } {
                if let Some(point) = self.named_point(owner, end) {
                    points.push((point.label, point.position));
                }
            }
            if kind == "Bar" {
                segments.push((name, first, first + 1));
                continue;
            }
            let attached = joints
                .iter()
                .flat_map(|joint| joint.joint.points())
                .chain(forces.iter().flat_map(|f| f.force.points()));
            for point in attached.filter(|point| point.owner == owner) {
                if points[first..]
                    .iter()
                    .all(|(_, position)| *position != point.position)
                {
                    segments.push((name.clone(), first, points.len()));
                    points.push((point.label.clone(), point.position));
                }
            }
        }
        (points, segments)
    }
}
