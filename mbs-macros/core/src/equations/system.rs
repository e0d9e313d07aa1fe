//! The equations of a mechanism, as data.

use super::generalized_forces::ForceParts;
use super::kinetic::Kinetic;
use super::readings::UnknownReading;
use crate::model::{Held, Layout, Requirement, Vector};
use crate::symbolic::{Expr, Graph, Substitution, Symbol};
use std::collections::BTreeMap;

/// The equations of a mechanism.
#[derive(Debug)]
pub struct System {
    /// All expressions.
    pub graph: Graph,
    /// Number of velocities N.
    pub size: usize,
    /// T of joint coordinates, body by body; for other coordinates M determines T.
    pub kinetic: Option<Kinetic>,
    /// Upper triangle of M, structurally nonzero entries only.
    pub mass: BTreeMap<(usize, usize), Expr>,
    /// Potential energy V.
    pub potential: Expr,
    /// Applied generalized forces f.
    pub forces: Vec<Expr>,
    /// What f consists of.
    pub force_parts: ForceParts,
    /// Power of the forces without potential.
    pub power: Expr,
    /// Rows, holonomic ones first.
    pub rows: Vec<Row>,
    /// Rows that are zero in every pose, and are left out.
    pub vacuous: Vec<VacuousRow>,
    /// Reactions in terms of v̇ and λ.
    pub reactions: Vec<Reaction>,
    /// Output expressions.
    pub outputs: Vec<Expr>,
    /// Components of reactions that outputs read and that no joint has.
    pub unknown_readings: Vec<UnknownReading>,
    /// Event expressions.
    pub events: Vec<Expr>,
    /// Initial values that assembly holds.
    pub held: Vec<Held>,
    /// What arguments that follow from parameters have to be.
    pub requirements: Vec<Requirement>,
    /// The values whose sizes are the scales of the states; none where no scale follows from parameters.
    pub scales: Vec<Expr>,
    /// Points to draw.
    pub points: Vec<Vector>,
    /// Coordinates and velocities with their guesses, rotations.
    pub layout: Layout,
    /// Whether M does not depend on q.
    pub constant_mass: bool,
    /// Local coordinates of the parts in terms of the generalized ones.
    pub reduction: Substitution,
    /// Counted joint angles, in the order of their memories.
    pub unwrapped_angles: Vec<Expr>,
    /// Their rates by rotations of bodies and by coordinates that are angles.
    pub unwrapped_rates: Vec<Expr>,
}

/// A constraint row.
#[derive(Debug, Clone)]
pub struct Row {
    /// Its name: joint and component.
    pub name: String,
    /// The entry it comes from.
    pub entry: String,
    /// Its kind.
    pub kind: RowKind,
    /// SI unit of the expression.
    pub unit: String,
    /// φ or ψ̇.
    pub expr: Expr,
    /// The same in local coordinates, for reactions.
    pub(super) local: Expr,
}

impl Row {
    /// A position that is held, as a row.
    pub(crate) fn of_held(held: &Held) -> Row {
        Row {
            name: held.name.clone(),
            entry: held.entry.clone(),
            kind: RowKind::Holonomic,
            unit: held.unit.clone(),
            expr: held.gap,
            local: held.gap,
        }
    }
}

/// A row that is left out, because joint coordinates satisfy it in every pose.
#[derive(Debug, Clone)]
pub struct VacuousRow {
    /// Its name: joint and component.
    pub name: String,
    /// The entry it comes from.
    pub entry: String,
    /// The joints whose coordinates satisfy it.
    pub follows_from: Vec<String>,
}

/// The kinds of rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RowKind {
    /// φ(q) = 0
    Holonomic,
    /// φ(q, t) = 0
    Rheonomic,
    /// N(q) v + n(q, t) = 0
    Nonholonomic,
}

impl RowKind {
    /// Whether the row is a condition on positions.
    pub fn is_holonomic(self) -> bool {
        self != RowKind::Nonholonomic
    }
}

/// A component of a joint reaction.
#[derive(Debug, Clone)]
pub struct Reaction {
    /// The joint.
    pub joint: String,
    /// `fx`, `fy`, `torque`, `lambda[1]`, ….
    pub component: String,
    /// SI unit.
    pub unit: String,
    /// In terms of q, v, v̇ and λ.
    pub expr: Expr,
}

impl System {
    /// Whether an expression has accelerations or multipliers.
    pub fn is_at_acceleration_level(&self, expr: Expr) -> bool {
        self.graph.depends_on(expr, |symbol| {
            matches!(symbol, Symbol::Acceleration(_) | Symbol::Multiplier(_))
        })
    }

    /// The number of holonomic rows.
    pub fn holonomic_rows(&self) -> usize {
        self.rows
            .iter()
            .filter(|row| row.kind.is_holonomic())
            .count()
    }
}
