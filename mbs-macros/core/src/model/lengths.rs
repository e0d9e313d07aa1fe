//! The largest length of a mechanism: what is small against it is zero except for rounding. A micrometre is small in a machine
//! and large in a micro-mechanism.

use super::defaults::{Sampled, largest};
use super::elements::JointEntry;
use super::resolver::Resolver;
use crate::symbolic::Expr;

impl Resolver<'_> {
    /// The lengths that the parts give: their places in the home pose, their centres of mass, and the lengths of bars.
    pub(super) fn lengths_of_parts(&self) -> Vec<Expr> {
        let lengths = self.parts.iter().flat_map(|part| {
            let origin = part.home.map(|home| home.origin);
            let places = origin.into_iter().chain([part.center]).flatten();
            places.chain(part.length)
        });
        lengths.collect()
    }

    /// The largest length of the parts and of the places of joints on them.
    pub(super) fn largest_length(&self, joints: &[JointEntry]) -> Sampled {
        let mut lengths = self.lengths_of_parts();
        let points = joints.iter().flat_map(|entry| &entry.joint.points);
        lengths.extend(points.flat_map(|point| point.local));
        largest(&self.graph, &self.parameters, &lengths)
    }
}
