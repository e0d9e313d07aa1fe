//! The freedoms of a joint between its partners.

use super::geometry::{Attachment, Axes, Point};
use crate::symbolic::Expr;

/// The motions that a joint allows, in order, from the frame on the parent to that on the child. Kinematics, home pose
/// and spanning tree use this list; a joint with such a list can become coordinates.
///
/// Slides come before turns: a slide along the axis of a turn may be written on either side of it.
#[derive(Debug, Clone)]
pub struct Mobilizer {
    /// The frame on the parent.
    pub parent: Attachment,
    /// The frame on the child.
    pub child: Attachment,
    /// The motions, in order; none for a joint that allows no motion.
    pub freedoms: Vec<Freedom>,
    /// In the plane, the angle of the child relative to the parent if it is held, in the order of the declaration.
    pub offset: Option<Expr>,
    /// Whether the partners have the order of the declaration.
    pub forwards: bool,
}

/// A motion that a joint allows, in the axes that result from the motions before it.
#[derive(Debug, Clone)]
pub enum Freedom {
    /// A turn about z. With axes, the frame is first turned to these axes, and the turn is about the third of them.
    Turn(Option<Axes>),
    /// A slide along x, y or z.
    Slide(usize),
    /// A turn about z with a slide along z of this length per radian.
    Helix(Expr),
    /// Any rotation: the child keeps its own orientation. It comes last.
    Rotation,
}

impl Mobilizer {
    /// Between two frames.
    pub fn new(
        parent: &Attachment,
        child: &Attachment,
        freedoms: impl Into<Vec<Freedom>>,
    ) -> Mobilizer {
        let mobilizer = Mobilizer {
            parent: parent.clone(),
            child: child.clone(),
            freedoms: freedoms.into(),
            offset: None,
            forwards: true,
        };
        debug_assert!(mobilizer.freedoms.is_sorted_by_key(Freedom::turns));
        mobilizer
    }

    /// Two points of the plane that coincide, while the child keeps its own angle.
    pub fn of_points(parent: &Point, child: &Point) -> Mobilizer {
        let attached = |point: &Point| Attachment {
            axes: [point.position; 3],
            local: [point.local; 3],
            point: point.clone(),
        };
        Mobilizer::new(&attached(parent), &attached(child), [Freedom::Rotation])
    }

    /// Whether the child keeps its own orientation.
    pub fn frees_rotation(&self) -> bool {
        let last = self.freedoms.last();
        matches!(last, Some(Freedom::Rotation))
    }

    /// 1, or −1 in a joint that the tree takes backwards: the motion of the child against the parent is this times the coordinate,
    /// which has the sign of the declaration.
    pub fn sign(&self) -> f64 {
        if self.forwards { 1.0 } else { -1.0 }
    }

    /// The same joint with the partners exchanged: its motions change sign, its coordinates do not ([`Self::sign`]). The order of the
    /// turns is reversed; slides stay before them, along the axes of the other partner: the strokes of a `Planar` joint are along those
    /// of the partner that was declared second.
    pub(super) fn reversed(&self) -> Mobilizer {
        let mut freedoms = self.freedoms.clone();
        let first = freedoms.partition_point(|freedom| !freedom.turns());
        let turns = &mut freedoms[first..];
        // Axes belong between two turns: those of the later turn are transposed and become those of the earlier one.
        let between = turns.iter().skip(1).map(|turn| match turn {
            Freedom::Turn(Some(axes)) => Some(transposed(axes)),
            _ => None,
        });
        let between: Vec<Option<Axes>> = between.rev().collect();
        turns.reverse();
        for (turn, axes) in turns.iter_mut().zip([None].into_iter().chain(between)) {
            if let Freedom::Turn(before) = turn {
                *before = axes;
            }
        }
        Mobilizer {
            parent: self.child.clone(),
            child: self.parent.clone(),
            freedoms,
            forwards: !self.forwards,
            ..self.clone()
        }
    }
}

impl Freedom {
    /// Whether it has an angle, or is a rotation.
    pub fn turns(&self) -> bool {
        !matches!(self, Freedom::Slide(_))
    }
}

/// The axes of one frame in components of another, from those of the other in components of the one.
pub(super) fn transposed(axes: &Axes) -> Axes {
    std::array::from_fn(|i| std::array::from_fn(|k| axes[k][i]))
}
