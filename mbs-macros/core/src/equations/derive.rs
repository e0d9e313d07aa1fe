//! The passes of stage 3.

use super::balance::{self, Balance};
use super::carried_start;
use super::constant_mass::constant_mass;
use super::forces::{Action, Potential};
use super::generalized_forces::{Elements, ForceParts};
use super::kinetic::{self, Kinetic};
use super::states::{self, States};
use super::system::System;
use super::{forces, generalized_forces, inertia, reactions, readings, rows, start, vacuous};
use crate::model::elements::force::Load;
use crate::model::{Held, Layout, Model, Outline};
use crate::symbolic::{Expr, Graph, Symbol};

/// Builds the equations; beside them stays what later stages need to name things.
pub fn derive(mut model: Model) -> (Outline, System) {
    let mut graph = std::mem::take(&mut model.graph);
    let mut reduction = std::mem::take(&mut model.reduction);
    let inertia = inertia::local_mass(&mut graph, &model.outline.parts);

    let gravity = generalized_forces::gravity_potential(&mut graph, &model);
    let actions = model.forces.iter();
    let actions: Vec<Action> = actions
        .map(|force| forces::action(&mut graph, &model, &force.element))
        .collect();
    let potentials = actions.iter().filter_map(|action| action.potential);
    let generators = potentials.map(|potential| potential.generator);
    let potential = graph.sum([gravity].into_iter().chain(generators));
    let vacuous = vacuous::rows(&graph, &reduction, &model);
    let rows = rows::rows(&mut graph, &mut reduction, &model);
    let solved = rows::solved_rows(&model.joints, &model.solved);
    let balance = Balance {
        inertia: &inertia,
        varying: balance::varying(&graph, &inertia),
        potential,
        actions: &actions,
        rows: &rows,
        rows_along: balance::rows_along(&graph, &rows),
        solved: &solved,
        model: &model,
    };
    let reactions = reactions::derive(&mut graph, &mut reduction, &balance);
    readings::give_units(&graph, &mut model, &reactions);
    let unknown_readings = readings::resolve(&model.readings, &reactions, &mut reduction);

    let mut global = |graph: &mut Graph, expr: Expr| graph.substitute(expr, &mut reduction);
    let elements = Elements {
        potentials: actions
            .iter()
            .filter_map(|action| {
                let Potential { energy, generator } = action.potential?;
                Some(Potential {
                    energy: global(&mut graph, energy),
                    generator: global(&mut graph, generator),
                })
            })
            .collect(),
        loads: actions
            .iter()
            .map(|action| {
                let loads = action.loads.iter().map(|load| Load {
                    rate: global(&mut graph, load.rate),
                    force: global(&mut graph, load.force),
                });
                loads.collect()
            })
            .collect(),
    };
    let gravity = global(&mut graph, gravity);
    let potential = elements.potential(&mut graph, gravity, |potential| potential.energy);
    let generator = elements.potential(&mut graph, gravity, |potential| potential.generator);
    let size = model.layout.velocities.len();
    let outputs = model.outputs.iter();
    let outputs = outputs.map(|&expr| global(&mut graph, expr)).collect();
    let events = model
        .events
        .iter()
        .map(|&expr| global(&mut graph, expr))
        .collect();
    let held = model
        .held
        .iter()
        .map(|held| Held {
            gap: global(&mut graph, held.gap),
            rate: global(&mut graph, held.rate),
            ..held.clone()
        })
        .collect();
    let points = model
        .outline
        .drawing
        .points
        .iter()
        .map(|(_, position)| position.map(|x| global(&mut graph, x)))
        .collect();
    let unwrapped_angles: Vec<Expr> = model
        .layout
        .unwrapped_angles
        .iter()
        .map(|(_, angle)| global(&mut graph, *angle))
        .collect();
    let unwrapped_rates = turning_rates(&mut graph, &model.layout, &unwrapped_angles);
    let pull = start::pull(&mut graph, &mut reduction, &model, &inertia);
    let mut kinetic = kinetic::energy(&mut graph, &mut reduction, &model)
        .map(|energy| Kinetic::new(&mut graph, size, energy));
    let mut mass = match &kinetic {
        Some(kinetic) => kinetic.mass(&mut graph),
        None => inertia::global_mass(&mut graph, &mut reduction, &inertia),
    };
    let mut force_parts = match &kinetic {
        Some(_) => ForceParts::by_gradients(&mut graph, size, generator, &elements),
        None => ForceParts::new(&mut graph, size, generator, &elements),
    };
    let states = States::new(&mut graph, &mut reduction, &model);
    states.join(&mut graph, &mut force_parts, &mut mass, kinetic.as_mut());
    let forces = force_parts.total(&mut graph);
    let power = generalized_forces::power(&mut graph, &elements);
    let constant_mass = constant_mass(&graph, &model.layout, &mass);
    let mut layout = model.layout.clone();
    if let (true, Some(pull)) = (constant_mass, pull) {
        start::move_guesses(&mut graph, &mass, &mut layout, pull);
    }
    let masses = (&model, &inertia, &mass);
    carried_start::move_guesses(&mut graph, &mut reduction, masses, &mut layout);
    let scales = states::scales(&graph, &model.outline.states);
    let system = System {
        graph,
        size,
        kinetic,
        mass,
        potential,
        forces,
        force_parts,
        power,
        rows,
        vacuous,
        reactions,
        outputs,
        unknown_readings,
        events,
        held,
        requirements: model.requirements,
        scales,
        points,
        layout,
        constant_mass,
        reduction,
        unwrapped_angles,
        unwrapped_rates,
    };
    (model.outline, system)
}

/// The part of the rate of each counted angle by rotations of bodies and by coordinates that are angles: these may turn by more
/// than half a turn at once. (Other coordinates move on a line, along which no angle changes by more than half a turn.)
fn turning_rates(graph: &mut Graph, layout: &Layout, angles: &[Expr]) -> Vec<Expr> {
    let slots = layout.slots.iter();
    let mut turns: Vec<bool> = slots
        .map(|&slot| layout.coordinates[slot].unit == "rad")
        .collect();
    for rotation in &layout.rotations {
        turns[rotation.velocity..rotation.velocity + 3].fill(true);
    }
    let rate = |angle: &Expr| {
        let mut terms = Vec::new();
        for symbol in graph.directions([*angle]) {
            if let Symbol::Coordinate(i) = symbol
                && turns[i as usize]
            {
                let slope = graph.derivative(*angle, symbol);
                let speed = graph.symbol(Symbol::Velocity(i));
                terms.push(graph.mul(slope, speed));
            }
        }
        graph.sum(terms)
    };
    angles.iter().map(rate).collect()
}
