//! Stage 3: model → system.
//!
//! AFTER THIS STAGE: M, V, applied forces, rows, reactions and outputs are expressions in the generalized coordinates q,
//! velocities v, time, parameters and inputs. There are no parts, points or tokens any more.

pub mod forces;
mod inertia;
pub mod joints;
mod reactions;
mod start;
mod vacuous;

use crate::model::{Dimension, Layout, Model, Solved, Vector};
use crate::symbolic::{Expr, Graph, Substitution, Symbol};
use forces::Load;
pub use inertia::Kinetic;
use joints::{JointEquations, Level};
use std::collections::BTreeMap;

/// The equations of a mechanism.
#[derive(Debug)]
pub struct System {
    /// All expressions.
    pub graph: Graph,
    /// Number of velocities N.
    pub size: usize,
    /// T of joint coordinates, body by body; elsewhere M says it all.
    pub kinetic: Option<Kinetic>,
    /// Upper triangle of M, structurally nonzero entries only.
    pub mass: BTreeMap<(usize, usize), Expr>,
    /// Potential energy V.
    pub potential: Expr,
    /// Applied generalized forces f.
    pub forces: Vec<Expr>,
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
    /// Event expressions.
    pub events: Vec<Expr>,
    /// Points to draw.
    pub points: Vec<Vector>,
    /// Coordinates and velocities with their guesses, rotations.
    pub layout: Layout,
    /// What pulls the guesses of positions and of velocities towards rows that were solved, where M is constant.
    pub pull: Option<[Vec<Expr>; 2]>,
    /// Counted joint angles, in the order of their memories.
    pub unwrapped_angles: Vec<Expr>,
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
    local: Expr,
}

/// A row that is left out, because joints that have become coordinates hold what it says.
#[derive(Debug, Clone)]
pub struct VacuousRow {
    /// Its name: joint and component.
    pub name: String,
    /// The entry it comes from.
    pub entry: String,
    /// The joints that hold what it says.
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
    /// The number of holonomic rows.
    pub fn holonomic_rows(&self) -> usize {
        self.rows
            .iter()
            .filter(|row| row.kind.is_holonomic())
            .count()
    }
}

/// Builds the equations. What later stages need of the model besides them stays in `model`.
pub fn derive(model: &mut Model) -> System {
    let mut graph = std::mem::take(&mut model.graph);
    let mut reduction = std::mem::take(&mut model.reduction);
    let inertia = inertia::local_mass(&mut graph, &model.parts);

    let mut potential = gravity_potential(&mut graph, model);
    let mut loads: Vec<Load> = Vec::new();
    for (_, force) in &model.forces {
        let action = force.action(&mut graph);
        potential = match action.potential {
            Some(energy) => graph.add(potential, energy),
            None => potential,
        };
        loads.extend(action.loads);
    }
    let joints: Vec<(String, JointEquations)> = model
        .joints
        .iter()
        .map(|(name, joint)| (name.clone(), joint.equations(&mut graph)))
        .collect();
    let vacuous = vacuous::rows(&graph, model, &joints);
    let rows = rows(&mut graph, &mut reduction, &joints, model);
    let solved = solved_rows(&joints, &model.solved);
    let balance = reactions::Balance {
        inertia: &inertia,
        potential,
        loads: &loads,
        rows: &rows,
        solved: &solved,
        model,
    };
    let reactions = reactions::derive(&mut graph, &mut reduction, &joints, &model.merged, &balance);

    let mut global = |graph: &mut Graph, expr: Expr| graph.substitute(expr, &mut reduction);
    let potential = global(&mut graph, potential);
    let loads: Vec<Load> = loads
        .iter()
        .map(|load| Load {
            rate: global(&mut graph, load.rate),
            force: global(&mut graph, load.force),
        })
        .collect();
    let size = model.layout.velocities.len();
    let outputs = model
        .outputs
        .iter()
        .map(|(_, expr)| global(&mut graph, *expr))
        .collect();
    let events = model
        .events
        .iter()
        .map(|(_, expr)| global(&mut graph, *expr))
        .collect();
    let points = model
        .drawing
        .points
        .iter()
        .map(|(_, position)| position.map(|x| global(&mut graph, x)))
        .collect();
    let unwrapped_angles = model
        .layout
        .unwrapped_angles
        .iter()
        .map(|(_, angle)| global(&mut graph, *angle))
        .collect();
    let pull = start::pull(&mut graph, &mut reduction, model, &inertia);
    let kinetic = inertia::kinetic(&mut graph, &mut reduction, model, &inertia)
        .map(|energy| Kinetic::new(&mut graph, size, energy));
    let mass = match &kinetic {
        Some(kinetic) => kinetic.mass(&mut graph),
        None => inertia::global_mass(&mut graph, &mut reduction, &inertia),
    };
    let forces = match kinetic {
        Some(_) => backward_forces(&mut graph, size, potential, &loads),
        None => applied_forces(&mut graph, size, potential, &loads),
    };
    let power = power(&mut graph, &loads);
    model.reduction = reduction;
    System {
        graph,
        size,
        kinetic,
        mass,
        potential,
        forces,
        power,
        rows,
        vacuous,
        reactions,
        outputs,
        events,
        points,
        layout: model.layout.clone(),
        pull,
        unwrapped_angles,
    }
}

/// V = −Σ m g · c.
fn gravity_potential(graph: &mut Graph, model: &Model) -> Expr {
    let mut terms = Vec::new();
    for part in &model.parts {
        let offset = graph.turn(&part.frame.axes, part.center);
        let center = inertia::center_of(graph, part, offset);
        let along = graph.dot(model.gravity, center);
        let energy = graph.mul(part.mass, along);
        terms.push(graph.neg(energy));
    }
    graph.sum(terms)
}

/// f_j = −∂V/∂q_j + Σ force · ∂rate/∂v_j.
fn applied_forces(graph: &mut Graph, size: usize, potential: Expr, loads: &[Load]) -> Vec<Expr> {
    (0..size as u32)
        .map(|j| {
            let slope = graph.derivative(potential, Symbol::Coordinate(j));
            let mut terms = vec![graph.neg(slope)];
            for load in loads {
                let lever = graph.derivative(load.rate, Symbol::Velocity(j));
                terms.push(graph.mul(load.force, lever));
            }
            graph.sum(terms)
        })
        .collect()
}

/// The same by gradients, whose cost does not grow with the number of coordinates.
fn backward_forces(graph: &mut Graph, size: usize, potential: Expr, loads: &[Load]) -> Vec<Expr> {
    let mut terms: Vec<Vec<Expr>> = vec![Vec::new(); size];
    for (symbol, slope) in graph.gradient(potential) {
        if let Symbol::Coordinate(j) = symbol {
            terms[j as usize].push(graph.neg(slope));
        }
    }
    for load in loads {
        for (symbol, lever) in graph.gradient(load.rate) {
            if let Symbol::Velocity(j) = symbol {
                terms[j as usize].push(graph.mul(load.force, lever));
            }
        }
    }
    terms.into_iter().map(|terms| graph.sum(terms)).collect()
}

fn power(graph: &mut Graph, loads: &[Load]) -> Expr {
    let terms: Vec<Expr> = loads
        .iter()
        .map(|load| graph.mul(load.force, load.rate))
        .collect();
    graph.sum(terms)
}

/// What becomes of a row of a joint.
enum RowStatus {
    Stays,
    /// It is zero in every pose, and left out.
    Vacuous,
    /// It was solved, as which one.
    Solved(usize),
}

fn row_status(model: &Model, entry: &str, slot: usize) -> RowStatus {
    match model.solved.position(entry, slot) {
        Some(position) => RowStatus::Solved(position),
        None if model.vacuous.contains(&(entry.to_owned(), slot)) => RowStatus::Vacuous,
        None => RowStatus::Stays,
    }
}

/// All rows that stay, holonomic ones first, each in local and in generalized coordinates.
fn rows(
    graph: &mut Graph,
    reduction: &mut Substitution,
    joints: &[(String, JointEquations)],
    model: &Model,
) -> Vec<Row> {
    let mut list = Vec::new();
    for level in [Level::Position, Level::Velocity] {
        for (entry, equations) in joints {
            for (slot, row) in equations.rows.iter().enumerate() {
                if row.level != level || !matches!(row_status(model, entry, slot), RowStatus::Stays)
                {
                    continue;
                }
                let expr = graph.substitute(row.expr, reduction);
                let kind = match level {
                    Level::Velocity => RowKind::Nonholonomic,
                    Level::Position if graph.depends_on(expr, |symbol| symbol == Symbol::Time) => {
                        RowKind::Rheonomic
                    }
                    Level::Position => RowKind::Holonomic,
                };
                let name = row.name(entry);
                let unit = unit_of(row.dimension, level);
                list.push(Row {
                    name,
                    entry: entry.clone(),
                    kind,
                    unit,
                    expr,
                    local: row.expr,
                });
            }
        }
    }
    list
}

fn unit_of(dimension: Option<Dimension>, level: Level) -> String {
    match (dimension, level) {
        (Some(Dimension::NONE), Level::Position) => "rad".to_owned(),
        (Some(dimension), _) => dimension.unit(),
        (None, _) => String::new(),
    }
}

/// The rows that were solved, in local coordinates.
fn solved_rows(joints: &[(String, JointEquations)], solved: &Solved) -> Vec<Expr> {
    let rows = solved.rows.iter().filter_map(|(joint, slot)| {
        let (_, equations) = joints.iter().find(|(name, _)| name == joint)?;
        Some(equations.rows.get(*slot)?.expr)
    });
    rows.collect()
}

/// The multiplier of each row of each joint, (joint, its row): the index among all rows, and after them among those that
/// were solved. One that is left out has none: what it could transmit is counted with the joints that are coordinates.
fn multipliers(
    joints: &[(String, JointEquations)],
    model: &Model,
    rows: usize,
) -> BTreeMap<(usize, usize), u32> {
    let mut indices = BTreeMap::new();
    let mut next = 0;
    for level in [Level::Position, Level::Velocity] {
        for (joint, (name, equations)) in joints.iter().enumerate() {
            for (slot, row) in equations.rows.iter().enumerate() {
                if row.level != level {
                    continue;
                }
                let index = match row_status(model, name, slot) {
                    RowStatus::Solved(position) => rows + position,
                    RowStatus::Vacuous => continue,
                    RowStatus::Stays => {
                        next += 1;
                        next - 1
                    }
                };
                indices.insert((joint, slot), index as u32);
            }
        }
    }
    indices
}
