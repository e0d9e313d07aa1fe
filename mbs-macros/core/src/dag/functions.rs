//! Which functions a mechanism gets, and what each computes.

use super::accelerations::accelerations;
use super::kernels::{LONGEST, kernels};
use super::likeness::Likeness;
use super::lower::{Hoisted, Lowering};
use super::partitioned::partitioned_accelerations;
use super::tangents::{all_tangents, turning};
use super::{
    Constant, Function, Labels, Operand, Place, Program, RotationBlock, Sparse, Structure,
};
use crate::derivatives::{Derived, Matrix};
use crate::equations::InverseMass;
use crate::model::Rotation;
use crate::symbolic::{Expr, Graph, Symbol};

/// Bytes of the formula of a constant that are kept, for its documentation.
const WRITTEN: usize = 400;

/// The guesses of more coordinates are computed when they are asked for.
const MOST_KEPT_GUESSES: usize = 200;

/// Lowers everything that a mechanism computes. In large mechanisms what is alike gets the same operations.
pub fn lower(derived: &Derived) -> Program {
    let system = &derived.system;
    // Where it is known beforehand that a function is long, the mechanism is lowered once.
    if !Function::is_long_by(system.reactions.len().max(3 * system.points.len())) {
        let program = lower_with(derived, None);
        if !program.functions.iter().any(Function::is_long) {
            return program;
        }
    }
    let likeness = Likeness::of(&system.graph, &Labels::new(system));
    lower_with(derived, Some(&likeness))
}

fn lower_with(derived: &Derived, likeness: Option<&Likeness>) -> Program {
    let Derived { system, .. } = derived;
    let mut graph = system.graph.clone();
    let mut hoisted = Hoisted::new(system.layout.clone());
    let structure = structure(derived);
    let sparse = Sparse::of(derived);
    let kicks = sparse.as_ref().and_then(|sparse| sparse.kicks.as_ref());
    let forces_vary = kicks.is_some_and(|kicks| kicks.forces_vary);
    let acceleration = (!forces_vary).then(|| acceleration(&mut graph, derived));
    let mut functions = Vec::new();
    {
        let mut make = |name: &'static str, outputs: &mut dyn FnMut(&mut Lowering)| {
            let mut lowering = Lowering::new(&mut graph, &mut hoisted).with_likeness(likeness);
            outputs(&mut lowering);
            functions.push(lowering.finish(name));
        };
        let holonomic = structure.holonomic_rows;
        make("mass_matrix", &mut |f| mass(f, &system.mass));
        make("momentum", &mut |f| vector(f, "p", &derived.momentum));
        if let Some(affinities) = &derived.affinities {
            make("affinities", &mut |f| {
                for (&(i, j, k), &value) in affinities {
                    f.output("gamma", Place::Tensor(i, j, k), value);
                }
            });
        }
        make("holonomic", &mut |f| {
            for (i, row) in system.rows[..holonomic].iter().enumerate() {
                f.output("phi", Place::Element(i), row.expr);
            }
        });
        make("constraints", &mut |f| {
            for (i, row) in system.rows[..holonomic].iter().enumerate() {
                f.output("phi", Place::Element(i), row.expr);
            }
            matrix(f, "a", &derived.jacobian);
            vector(f, "b", &derived.rheonomic);
        });
        make("constraint_rates", &mut |f| {
            matrix(f, "a_rate", &derived.jacobian_rate);
            vector(f, "gamma", &derived.convective);
        });
        make("applied_forces", &mut |f| vector(f, "f", &system.forces));
        make("forces", &mut |f| vector(f, "f", &derived.total_forces));
        make("applied_force_tangents", &mut |f| {
            matrix(f, "f_q", &derived.applied.by_position);
            matrix(f, "f_v", &derived.applied.by_velocity);
        });
        make("force_tangents", &mut |f| {
            matrix(f, "f_q", &derived.total.by_position);
            matrix(f, "f_v", &derived.total.by_velocity);
            matrix(f, "p_q", &derived.momentum_by_position);
        });
        if !structure.constant_mass {
            make("free_forces", &mut |f| vector(f, "f", &derived.free_forces));
            make("balance", &mut |f| {
                vector(f, "p", &derived.momentum);
                vector(f, "f", &derived.total_forces);
            });
            make("balance_tangents", &mut |f| {
                mass(f, &system.mass);
                matrix(f, "f_q", &derived.total.by_position);
                matrix(f, "f_v", &derived.total.by_velocity);
                matrix(f, "p_q", &derived.momentum_by_position);
            });
        }
        if let Some(acceleration) = &acceleration {
            make("acceleration", &mut |f| {
                vector(f, "acceleration", acceleration)
            });
        }
        if !system.unwrapped_angles.is_empty() {
            make("unwrapped_angles", &mut |f| {
                vector(f, "angles", &system.unwrapped_angles)
            });
            let rates = &system.unwrapped_rates;
            if rates.iter().any(|&rate| !system.graph.is_zero(rate)) {
                make("unwrapped_rates", &mut |f| vector(f, "rates", rates));
            }
        }
        make("kinetic_energy", &mut |f| {
            f.output("", Place::Value, derived.kinetic)
        });
        make("potential_energy", &mut |f| {
            f.output("", Place::Value, system.potential)
        });
        make("nonconservative_power", &mut |f| {
            f.output("", Place::Value, system.power)
        });
        make("outputs", &mut |f| {
            for (i, &output) in system.outputs.iter().enumerate() {
                if !system.is_at_acceleration_level(output) {
                    f.output("outputs", Place::Element(i), output);
                }
            }
        });
        let mut outputs = system.outputs.iter();
        if outputs.any(|&output| system.is_at_acceleration_level(output)) {
            make("outputs_at_acceleration_level", &mut |f| {
                vector(f, "outputs", &system.outputs)
            });
        }
        make("events", &mut |f| vector(f, "events", &system.events));
        if !system.held.is_empty() {
            let held = system.held.iter().flat_map(|held| [held.gap, held.rate]);
            let held: Vec<Expr> = held.collect();
            make("held", &mut |f| vector(f, "held", &held));
        }
        make("points", &mut |f| {
            for (i, point) in system.points.iter().enumerate() {
                for (axis, &x) in point.iter().enumerate() {
                    f.output("points", Place::Entry(i, axis), x);
                }
            }
        });
        let reactions: Vec<Expr> = system
            .reactions
            .iter()
            .map(|reaction| reaction.expr)
            .collect();
        make("reactions", &mut |f| vector(f, "reactions", &reactions));
    }
    // No integrator needs affinities: they are generated only where they are short.
    functions
        .retain(|function| function.name != "affinities" || function.operations.len() <= LONGEST);
    functions.extend(kernels(&mut graph, &mut hoisted, derived));
    // Derived for the first of them that needs it.
    let mut demand = None;
    let with_multipliers = accelerations(&mut graph, &mut hoisted, derived, &mut demand);
    if !structure.rheonomic {
        let known = hoisted.count();
        let longest = with_multipliers.as_ref().map(|code| code.cost().total());
        match partitioned_accelerations(&mut graph, &mut hoisted, derived, &mut demand) {
            Some(code) if longest.is_none_or(|most| code.cost().total() < most) => {
                functions.push(code);
            }
            _ => hoisted.keep(known),
        }
    }
    functions.extend(with_multipliers);
    // Long functions are lowered with a likeness.
    let all_tangents = likeness
        .and_then(|likeness| all_tangents(&mut graph, &mut hoisted, likeness, derived, &functions));
    let turning = turning(&mut graph, &mut hoisted, derived, &functions);
    let layout = &system.layout;
    // The guess is asked for once: many values of it are no constants.
    let mut guesses = match layout.coordinates.len() > MOST_KEPT_GUESSES {
        true => Lowering::of_constants(&mut graph, &mut hoisted, &[]),
        false => Lowering::new(&mut graph, &mut hoisted),
    };
    for (sink, list) in [("q", &layout.coordinates), ("v", &layout.velocities)] {
        for (i, stored) in list.iter().enumerate() {
            guesses.output(sink, Place::Element(i), stored.guess);
        }
    }
    let guesses = guesses.finish("guess");
    let constant_mass = derived
        .constant_mass
        .then(|| constant_mass(&mut graph, &mut hoisted, &system.mass));
    let rotations = layout
        .rotations
        .iter()
        .map(|rotation| rotation_block(&mut graph, &mut hoisted, derived, rotation))
        .collect();
    let (constants, preparation) = constants(&mut graph, &mut hoisted);
    let known = known_before_inverse(&graph, &hoisted);
    let requirements = system.requirements.iter();
    let checked = requirements.flat_map(|requirement| requirement.values.iter().copied());
    let checks = of_preparation(&mut graph, &mut hoisted, ("checks", checked), &known);
    let scales = system.scales.iter().copied();
    let scales = of_preparation(&mut graph, &mut hoisted, ("scales", scales), &known);
    Program {
        constants,
        checks,
        scales,
        constant_mass,
        all_tangents,
        turning,
        preparation,
        functions,
        guesses,
        rotations,
        unwrapped_angles: layout
            .unwrapped_angles
            .iter()
            .map(|(slot, _)| *slot)
            .collect(),
        coordinates: layout.coordinates.len(),
        slots: layout.slots.clone(),
        size: system.size,
        rows: system.rows.clone(),
        reactions: system
            .reactions
            .iter()
            .map(|r| (r.joint.clone(), r.component.clone(), r.unit.clone()))
            .collect(),
        structure,
        sparse,
        labels: Labels::new(system),
    }
}

/// M⁻¹ f; nothing where an explicit step does not exist.
fn acceleration(graph: &mut Graph, derived: &Derived) -> Vec<Expr> {
    let system = &derived.system;
    match &derived.acceleration {
        Some(known) => known.clone(),
        None if derived.is_explicit() => {
            InverseMass::new(system.size, &system.mass).apply(graph, &system.forces)
        }
        None => Vec::new(),
    }
}

fn structure(derived: &Derived) -> Structure {
    let system = &derived.system;
    let graph = &system.graph;
    let on_time = |expr: &Expr| graph.depends_on(*expr, |symbol| symbol == Symbol::Time);
    let is_position = |symbol| {
        matches!(
            symbol,
            Symbol::Coordinate(_) | Symbol::Rotation(..) | Symbol::UnwrappedAngle(_)
        )
    };
    let forces = || system.forces.iter().copied();
    let on_inputs =
        |expr: &Expr| graph.depends_on(*expr, |symbol| matches!(symbol, Symbol::Input(_)));
    let rheonomic = system
        .rows
        .iter()
        .any(|row| on_time(&row.expr) || on_inputs(&row.expr))
        || derived.rheonomic.iter().any(|&b| !graph.is_zero(b));
    Structure {
        constant_mass: derived.constant_mass,
        velocity_forces: derived.velocity_forces,
        position_forces: graph.any_depends_on(forces(), is_position),
        time_dependent: rheonomic
            || graph.any_depends_on(forces(), |symbol| symbol == Symbol::Time),
        rheonomic,
        smooth: graph.is_smooth(
            system
                .rows
                .iter()
                .flat_map(|row| graph.inside_row(row.expr))
                .chain(system.forces.iter().copied())
                .chain(system.mass.values().copied()),
        ),
        rotations: system.layout.rotations.len(),
        holonomic_rows: system.holonomic_rows(),
    }
}

fn vector(lowering: &mut Lowering, sink: &'static str, values: &[Expr]) {
    for (i, &value) in values.iter().enumerate() {
        lowering.output(sink, Place::Element(i), value);
    }
}

pub(super) fn matrix(lowering: &mut Lowering, sink: &'static str, entries: &Matrix) {
    for (&(i, j), &value) in entries {
        lowering.output(sink, Place::Entry(i, j), value);
    }
}

/// Both triangles.
fn mass(lowering: &mut Lowering, upper: &Matrix) {
    let mut entries = upper.clone();
    entries.extend(upper.iter().map(|(&(i, j), &value)| ((j, i), value)));
    matrix(lowering, "mass", &entries);
}

fn constant_mass(
    graph: &mut Graph,
    hoisted: &mut Hoisted,
    upper: &Matrix,
) -> Vec<(usize, usize, Operand)> {
    let mut lowering = Lowering::new(graph, hoisted);
    for (&(i, j), &value) in upper {
        lowering.output("mass", Place::Entry(i, j), value);
    }
    let entries = lowering.finish("mass").outputs;
    entries
        .into_iter()
        .map(|output| match output.place {
            Place::Entry(i, j) => (i, j, output.value),
            _ => (0, 0, output.value),
        })
        .collect()
}

/// A rotation, with the inertia of its free flight in constants: the block of M, where M is constant. (A body on a ball
/// joint turns about the joint; if M varies, there is no free flight, and the inertia of the part is used instead.)
fn rotation_block(
    graph: &mut Graph,
    hoisted: &mut Hoisted,
    derived: &Derived,
    rotation: &Rotation,
) -> RotationBlock {
    let zero = graph.zero();
    let entry = |i: usize, j: usize| {
        let (row, column) = (rotation.velocity + i.min(j), rotation.velocity + i.max(j));
        match derived.constant_mass {
            true => derived.system.mass.get(&(row, column)).copied(),
            false => Some(rotation.inertia[i][j]),
        }
    };
    let mut lowering = Lowering::new(graph, hoisted);
    for i in 0..9 {
        let value = entry(i / 3, i % 3).unwrap_or(zero);
        lowering.output("inertia", Place::Element(i), value);
    }
    let values = lowering.finish("inertia").outputs;
    RotationBlock {
        part: rotation.part.clone(),
        velocity: rotation.velocity,
        coordinate: rotation.coordinate,
        inertia: std::array::from_fn(|i| std::array::from_fn(|j| values[3 * i + j].value)),
    }
}

/// The constants that are known before M⁻¹, and their slots.
fn known_before_inverse(graph: &Graph, hoisted: &Hoisted) -> Vec<(Expr, usize)> {
    let constants = hoisted.list.iter().copied().zip(0..);
    let known = constants.filter(|&(expr, _)| !uses_inverse(graph, expr));
    known.collect()
}

/// Values that `prepare` reads, in constants that are known then.
fn of_preparation(
    graph: &mut Graph,
    hoisted: &mut Hoisted,
    (name, values): (&'static str, impl Iterator<Item = Expr>),
    known: &[(Expr, usize)],
) -> Function {
    let mut lowering = Lowering::of_constants(graph, hoisted, known);
    for (i, value) in values.enumerate() {
        lowering.output(name, Place::Element(i), value);
    }
    lowering.finish(name)
}

fn uses_inverse(graph: &Graph, expr: Expr) -> bool {
    graph.depends_on(expr, |symbol| matches!(symbol, Symbol::InverseMass(..)))
}

/// The constants, and the two functions that compute them: before M⁻¹ is known, and after.
fn constants(graph: &mut Graph, hoisted: &mut Hoisted) -> (Vec<Constant>, [Function; 2]) {
    let list: Vec<(Expr, usize)> = hoisted
        .list
        .iter()
        .copied()
        .enumerate()
        .map(|(slot, expr)| (expr, slot))
        .collect();
    let (after, before): (Vec<_>, Vec<_>) = list
        .iter()
        .copied()
        .partition(|&(expr, _)| uses_inverse(graph, expr));
    let mut compute = |name, these: &[(Expr, usize)], known: &[(Expr, usize)]| {
        let mut lowering = Lowering::of_constants(graph, hoisted, known);
        for &(expr, slot) in these {
            lowering.output("", Place::Constant(slot), expr);
        }
        lowering.finish(name)
    };
    let preparation = [
        compute("constants", &before, &[]),
        compute("constants_after_inverse", &after, &before),
    ];
    let constants = list
        .iter()
        .map(|&(expr, _)| Constant {
            text: graph.start_of_text(expr, WRITTEN),
            after_inverse: uses_inverse(graph, expr),
        })
        .collect();
    (constants, preparation)
}
