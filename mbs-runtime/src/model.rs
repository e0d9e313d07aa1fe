//! The summary of the model: a constant of every mechanism, for users, programs and `mbs explain`.

/// The summary of a compiled mechanism (generated as `Mechanism::MODEL`).
#[derive(Debug, Clone, Copy)]
pub struct Model {
    /// The name given to `mechanism!`.
    pub name: &'static str,
    /// The text of `doc:`.
    pub doc: &'static str,
    /// The declaration as it was written, token by token; the compiler library reads it back for `explain`.
    pub declaration: &'static str,
    /// The world it moves in.
    pub world: World,
    /// Unit vector against gravity with default parameters; without gravity y in the plane and z in space.
    pub up: [f64; 3],
    /// Generalized coordinates q, in the order of every array of length Q.
    pub coordinates: &'static [Coordinate],
    /// Generalized velocities v, in the order of every array of length N: rates of the coordinates, and for a body with
    /// a unit quaternion its angular velocity in body axes; states by their own names.
    pub velocities: &'static [Coordinate],
    /// Constraint rows, in the order of every array of length R: holonomic rows first.
    pub rows: &'static [Row],
    /// Bars, bodies and particles.
    pub parts: &'static [Part],
    /// `Param`s, in declaration order.
    pub parameters: &'static [Quantity],
    /// `Input`s, in declaration order.
    pub inputs: &'static [Quantity],
    /// `Output`s and `State`s, in declaration order; the default of a state is its initial value.
    pub outputs: &'static [Quantity],
    /// `Event`s, in declaration order.
    pub events: &'static [&'static str],
    /// Named points that an animation can draw, in the order of [`Observables::points`](crate::Observables::points).
    pub points: &'static [&'static str],
    /// How many of the last points are marks, which only show how a body turns: an animation draws them, and the size of the
    /// mechanism does not depend on them.
    pub marks: usize,
    /// Lines between points. Six or more lines of a part that touch no joint are the outline of a convex shape: they
    /// are drawn thin, and the area inside is tinted.
    pub segments: &'static [Segment],
    /// Components of the joint reactions, in the order of [`Observables::reactions`](crate::Observables::reactions).
    pub reactions: &'static [Reaction],
    /// The coordinates and rows that were eliminated, one sentence each.
    pub reductions: &'static [&'static str],
    /// Floating-point operations of each generated function.
    pub operations: &'static [FunctionCost],
    /// Properties of the equations that integrators use.
    pub structure: Structure,
    /// Rank and redundant rows at generic poses near the guess, with default parameters; `None` if no pose could be
    /// assembled there at compile time.
    pub mobility: Option<Mobility>,
    /// The coordinates in use: `Natural`, `Reference` or `Joint`.
    pub formulation: &'static str,
    /// The choices that were compared; empty if only the declared one was derived.
    pub candidates: &'static [Candidate],
}

impl Model {
    /// The number of leading rows that are holonomic.
    pub const fn holonomic_rows(&self) -> usize {
        self.structure.holonomic_rows
    }

    /// Whether rows are known to be independent at generic poses.
    pub(crate) fn has_independent_rows(&self) -> bool {
        self.mobility
            .is_some_and(|mobility| mobility.redundant.iter().all(|row| row.left_out))
    }

    /// Whether the reaction of a joint is determined at generic poses. If redundant rows contribute to it, it is the
    /// value of least norm of many; a row that is left out has no reaction. Also true for names that no joint has.
    pub fn is_determined(&self, joint: &str) -> bool {
        self.mobility
            .is_none_or(|mobility| !mobility.undetermined.contains(&joint))
    }

    /// Whether rows are left out, because joint coordinates satisfy them in every pose.
    pub(crate) fn leaves_rows_out(&self) -> bool {
        self.mobility
            .is_some_and(|mobility| mobility.redundant.iter().any(|row| row.left_out))
    }
}

/// The world a mechanism moves in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum World {
    /// x and y.
    Planar,
    /// x, y and z.
    Spatial,
}

/// A choice of coordinates that was compared with others.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Candidate {
    /// `Natural`, `Reference` or `Joint`.
    pub formulation: &'static str,
    /// Q.
    pub coordinates: usize,
    /// N.
    pub velocities: usize,
    /// R.
    pub rows: usize,
    /// Rank of the rows at generic poses near the guess.
    pub rank: Option<usize>,
    /// Operations of a step of second order, estimated: functions evaluated, factorisations and solutions. `None` where
    /// the factorisations alone exceed a whole step of another choice.
    pub operations: Option<usize>,
    /// Joints at which loops are cut: they have rows instead of coordinates.
    pub cut: &'static [&'static str],
    /// Whether it is the one in use.
    pub taken: bool,
}

/// Rank and degrees of freedom, determined at compile time. (Assembly repeats the check for the actual parameters:
/// [`AssemblyVerdict`](crate::AssemblyVerdict).)
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mobility {
    /// Rank of A.
    pub rank: usize,
    /// Velocities that are no states, less rank.
    pub degrees_of_freedom: usize,
    /// Rows that follow from others; they are harmless, but their reactions are not unique. Those that are left out come
    /// first.
    pub redundant: &'static [Redundancy],
    /// Joints whose reactions are not determined, because of redundant rows.
    pub undetermined: &'static [&'static str],
    /// Nonholonomic rows that are integrable together with the holonomic ones (Frobenius): they are equivalent to
    /// conditions on positions, whose constants the start determines.
    pub integrable: &'static [&'static str],
    /// All of this in a sentence.
    pub summary: &'static str,
}

/// A row that follows from others.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Redundancy {
    /// The row.
    pub row: &'static str,
    /// The entries of the declaration whose rows it follows from, or the joints whose coordinates satisfy it.
    pub follows_from: &'static [&'static str],
    /// Whether it is left out of [`Model::rows`]: joint coordinates satisfy it in every pose.
    pub left_out: bool,
}

/// A generalized coordinate, or a velocity.
#[derive(Debug, Clone, Copy)]
pub struct Coordinate {
    /// For example `crank.b.x`; for a velocity `crank.b.x'`.
    pub name: &'static str,
    /// SI unit, for example `m`, or `m/s` for a velocity.
    pub unit: &'static str,
}

/// An initial value that assembly holds: `Exactly(…)`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Held {
    /// For example `crank.angle` or `bob.velocity.x`.
    pub name: &'static str,
    /// SI unit.
    pub unit: &'static str,
    /// Whether it is a position or a velocity.
    pub level: Level,
}

/// Positions or velocities.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// A function of q.
    Position,
    /// A function of q and v.
    Velocity,
}

/// A constraint row.
#[derive(Debug, Clone, Copy)]
pub struct Row {
    /// For example `crank.length` or `gudgeon.x`.
    pub name: &'static str,
    /// The entry of the declaration it comes from.
    pub entry: &'static str,
    /// What kind of condition it is.
    pub kind: RowKind,
    /// SI unit of φ (holonomic) or of ψ̇ (nonholonomic).
    pub unit: &'static str,
}

/// The kinds of constraint rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum RowKind {
    /// φ(q) = 0.
    Holonomic,
    /// φ(q, t) = 0.
    Rheonomic,
    /// N(q) v + n(q, t) = 0.
    Nonholonomic,
}

/// A bar, body or particle.
#[derive(Debug, Clone, Copy)]
pub struct Part {
    /// Its name.
    pub name: &'static str,
    /// Its kind, for example `Bar`.
    pub kind: &'static str,
    /// How it was modelled, for example `natural coordinates`.
    pub modelled_as: &'static str,
}

/// A named scalar: parameter, input or output.
#[derive(Debug, Clone, Copy)]
pub struct Quantity {
    /// Its name.
    pub name: &'static str,
    /// SI unit, empty where dimensionless or not stated.
    pub unit: &'static str,
    /// Default value (zero for outputs, the initial value for states).
    pub default: f64,
    /// Its documentation comment.
    pub doc: &'static str,
}

/// A `State`: a value with a rate of its own, in [`Observables::STATES`](crate::Observables::STATES). It is an output of
/// its name, and integrated as a velocity of its name.
#[derive(Debug, Clone, Copy)]
pub struct ScalarState {
    /// Its name, its unit and its initial value, with the defaults of all parameters.
    pub quantity: Quantity,
    /// A usual size, in its unit: errors are relative to the value, or to this where it is less. Of
    /// [`Observables::STATES`](crate::Observables::STATES) it is that with the defaults of all parameters, of
    /// [`Observables::states`](crate::Observables::states) that of the system.
    pub scale: f64,
    /// Index into [`Model::coordinates`] of its integral over time, on which nothing depends.
    pub coordinate: usize,
    /// Index into [`Model::velocities`].
    pub velocity: usize,
}

/// A line to draw between two points.
#[derive(Debug, Clone, Copy)]
pub struct Segment {
    /// The part it belongs to, or the spring it stands for.
    pub part: &'static str,
    /// Index into [`Model::points`].
    pub from: usize,
    /// Index into [`Model::points`].
    pub to: usize,
}

/// A component of a joint reaction: the force or torque on the child (the second partner).
#[derive(Debug, Clone, Copy)]
pub struct Reaction {
    /// The joint.
    pub joint: &'static str,
    /// `fx`, `fy`, `torque`, …; in world axes.
    pub component: &'static str,
    /// `N` or `N m`; of a condition of one's own J over the unit of its row.
    pub unit: &'static str,
    /// Where it acts: index into [`Model::points`], if the joint holds a point of a part.
    pub at: Option<usize>,
}

/// Operations of one generated function.
#[derive(Debug, Clone, Copy)]
pub struct FunctionCost {
    /// The function.
    pub function: &'static str,
    /// Additions and subtractions.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Calls of elementary functions and external laws.
    pub calls: usize,
}

/// What the integrator may rely on, known from the symbolic expressions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Structure {
    /// M does not depend on q.
    pub constant_mass: bool,
    /// A force depends on velocities (∂f/∂v is not structurally zero).
    pub velocity_forces: bool,
    /// A force depends on positions (∂f/∂q is not structurally zero).
    pub position_forces: bool,
    /// A row or force depends on time, or a row on an input, or a velocity row is not homogeneous.
    pub time_dependent: bool,
    /// A row depends on time or on an input, or a velocity row is not homogeneous: rows do work.
    pub rheonomic: bool,
    /// M, forces and rows consist of sums, products, sines and cosines of what varies within a step. Otherwise a force may jump or
    /// bend, or come near to it, and steps with a tolerance look for it: friction, stops, tables, laws, distances, quotients,
    /// `abs`.
    pub smooth: bool,
    /// The number of leading rows that are holonomic.
    pub holonomic_rows: usize,
    /// The number of unit quaternions among the coordinates.
    pub rotations: usize,
}
