//! What a joint leaves free between its partners.

use super::geometry::{Attachment, Axes, Point};
use crate::symbolic::Expr;

/// What a joint leaves free between two frames.
#[derive(Debug, Clone)]
pub struct Mobilizer {
    /// On the parent.
    pub parent: Attachment,
    /// On the child.
    pub child: Attachment,
    /// Rotation about z.
    pub turns: bool,
    /// A second rotation after it, about the third of these axes, which are given in those that the first has turned.
    pub second: Option<Axes>,
    /// In the plane, the angle of the child against the parent, in the order of the declaration.
    pub offset: Option<Expr>,
    /// Sliding along these axes of the parent's frame.
    pub slides: Vec<usize>,
    /// The child keeps its own orientation.
    pub free_rotation: bool,
    /// Whether the partners stand in the order of the declaration.
    pub forwards: bool,
}

impl Mobilizer {
    /// Two points of the plane that coincide, while the child keeps its own angle.
    pub fn of_points(parent: &Point, child: &Point) -> Mobilizer {
        let attached = |point: &Point| Attachment {
            axes: [point.position; 3],
            local: [point.local; 3],
            point: point.clone(),
        };
        Mobilizer {
            parent: attached(parent),
            child: attached(child),
            turns: false,
            second: None,
            offset: None,
            slides: Vec::new(),
            free_rotation: true,
            forwards: true,
        }
    }

    /// The same joint with the partners exchanged: its coordinates change sign.
    pub(super) fn reversed(&self) -> Mobilizer {
        Mobilizer {
            parent: self.child.clone(),
            child: self.parent.clone(),
            forwards: !self.forwards,
            second: self
                .second
                .map(|axes| std::array::from_fn(|i| std::array::from_fn(|k| axes[k][i]))),
            ..self.clone()
        }
    }
}
