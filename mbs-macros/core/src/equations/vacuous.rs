//! Rows that are left out, and the joints whose coordinates satisfy them.
//!
//! A force on such a row does no work in any motion of the tree. The joints that transmit it are those it follows from:
//! the ones for which the wrenches on the parts that they carry do not cancel. This is tested with numbers, because the
//! cancellation of two long expressions seldom shows.

use super::inertia::center_of;
use super::system::VacuousRow;
use crate::model::elements::joint::{Condition, Level};
use crate::model::{Model, Part, Representation, TreeJoint, scattered_motion};
use crate::symbolic::{Evaluator, Expr, Graph, Substitution, Symbol};

/// The number of poses.
const POSES: u32 = 2;
/// A wrench below this fraction of those that it is the sum of is round-off.
const ROUND_OFF: f64 = 1e-9;

/// A force and a torque, in numbers.
type Wrench = [[f64; 3]; 2];

/// The vacuous rows of all joints.
pub(super) fn rows(graph: &Graph, reduction: &Substitution, model: &Model) -> Vec<VacuousRow> {
    let mut vacuous = Vec::new();
    if model.vacuous.is_empty() {
        return vacuous;
    }
    // In a graph of their own: the equations make their expressions in their own order.
    let (graph, reduction) = (&mut graph.clone(), &mut reduction.clone());
    for (entry, joint) in &model.joints {
        for (slot, row) in joint.conditions.iter().enumerate() {
            if model.vacuous.contains(&(entry.clone(), slot)) {
                vacuous.push(VacuousRow {
                    name: row.name(entry),
                    entry: entry.clone(),
                    follows_from: loaded(graph, reduction, model, row),
                });
            }
        }
    }
    vacuous
}

/// The joints of the tree that transmit the force of a row.
fn loaded(
    graph: &mut Graph,
    reduction: &mut Substitution,
    model: &Model,
    row: &Condition,
) -> Vec<String> {
    let parts = &model.outline.parts;
    let wrenches: Vec<[[Expr; 3]; 2]> = parts
        .iter()
        .map(|part| {
            wrench(graph, model, part, row)
                .map(|vector| vector.map(|x| graph.substitute(x, reduction)))
        })
        .collect();
    let poses: Vec<Vec<Wrench>> = (0..POSES)
        .map(|pose| {
            let symbols = |symbol: Symbol| match symbol {
                Symbol::Parameter(i) => model.outline.parameters[i as usize].default,
                Symbol::Input(i) => model.outline.inputs[i as usize].default,
                other => scattered_motion(other, pose),
            };
            let laws = |_: u32, arguments: &[f64]| (f64::NAN, vec![f64::NAN; arguments.len()]);
            let mut evaluator = Evaluator::new(graph, &symbols, &laws);
            let numbers = wrenches
                .iter()
                .map(|wrench| wrench.map(|vector| vector.map(|x| evaluator.value(x))));
            numbers.collect()
        })
        .collect();
    let own = graph.symbols([row.expr]);
    let is_own = |joint: &TreeJoint| {
        let mut coordinates = joint.coordinates.iter().flatten();
        coordinates.any(|&local| {
            own.contains(&Symbol::LocalPosition(local))
                || own.contains(&Symbol::LocalVelocity(local))
        })
    };
    let tree = &model.outline.tree;
    let transmits = |joint: &TreeJoint| {
        let carried = tree.carried_by(joint.child);
        is_own(joint) || poses.iter().any(|wrenches| remains(wrenches, &carried))
    };
    let joints = tree.joints.iter().filter(|joint| transmits(joint));
    let mut names: Vec<String> = joints.map(|joint| joint.joint.clone()).collect();
    names.sort();
    names
}

/// Whether the wrenches on some parts do not cancel.
fn remains(wrenches: &[Wrench], parts: &[usize]) -> bool {
    (0..2).any(|kind| {
        let all = wrenches.iter().flat_map(|wrench| wrench[kind]);
        let most = all.fold(0.0f64, |most, x| most.max(x.abs()));
        (0..3).any(|k| {
            let sum: f64 = parts.iter().map(|&part| wrenches[part][kind][k]).sum();
            sum.abs() > ROUND_OFF * most
        })
    })
}

/// What a multiplier of 1 on a row exerts on a part: force, and torque about the origin, in local coordinates.
fn wrench(graph: &mut Graph, model: &Model, part: &Part, row: &Condition) -> [[Expr; 3]; 2] {
    let along = |graph: &mut Graph, local: u32| {
        let symbol = match row.level {
            Level::Position => Symbol::LocalPosition(local),
            Level::Velocity => Symbol::LocalVelocity(local),
        };
        graph.derivative(row.expr, symbol)
    };
    let [mut force, mut torque] = [graph.zero_vector(); 2];
    if !matches!(
        part.representation,
        Representation::Reference | Representation::Rigid
    ) {
        // The tree carries no other parts.
        return [force, torque];
    }
    let dimension = model.outline.world.dimension();
    for (force, &local) in force.iter_mut().zip(&part.locals[..dimension]) {
        *force = along(graph, local);
    }
    match part.rotation() {
        Some(first) => {
            let own = [0, 1, 2].map(|k| along(graph, first + k));
            torque = graph.turn(&part.frame.axes, own);
        }
        None => torque[2] = along(graph, part.locals[2]),
    }
    let offset = graph.turn(&part.frame.axes, part.center);
    let center = center_of(graph, part, offset);
    let lever = graph.cross(center, force);
    [force, graph.vector_add(torque, lever)]
}
