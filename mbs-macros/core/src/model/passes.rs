//! The passes of stage 2, in order, with the conditions that hold after each.

use super::elements::JointEntry;
use super::elements::kinds::kinds;
use super::formulation::{Description, Formulation};
use super::initial_pose::Guesses;
use super::mechanism::Model;
use super::outline::Outline;
use super::quantities::Quantity;
use super::resolver::Resolver;
use super::sizes::Sizes;
use super::tree::Tree;
use super::{check, initial_pose, layout, reduce, spanning, vacuous};
use crate::diagnostics::Errors;
use crate::schema::World;
use crate::syntax::{CONSTANT_IN_ASSEMBLY, Declaration};

/// Resolves a declaration in one of its descriptions.
///
/// # Errors
/// All of its errors are recorded in `errors`, and there is no model.
pub fn resolve(
    declaration: &Declaration,
    description: &Description,
    errors: &mut Errors,
) -> Option<Model> {
    let mut state = Resolver::new(declaration, kinds(), description.formulation, errors);
    let resolver = &mut state;

    // Names. AFTER THIS POINT: every name is that of one entry, and entries have the arguments of their kinds.
    resolver.declare();
    check::arguments(resolver);

    // Values. AFTER THIS POINT: every entry that has a value has been evaluated; there are no unknown names.
    if !resolver.given_parameters() {
        return None;
    }
    resolver.quantities();
    if !resolver.given_ports() {
        return None;
    }
    let gravity = resolver.gravity();
    for (index, entry) in declaration.entries.iter().enumerate() {
        if !resolver.is_planar_joint(entry) {
            resolver.force(index);
        }
    }
    debug_assert!(resolver.is_evaluated());

    // Elements. AFTER THIS POINT: joints, forces, outputs, events and held values are expressions in local coordinates, and no tokens
    // are read any more.
    let (outputs, events) = resolver.outputs();
    let held = resolver.held();
    let (joints, forces) = resolver.elements();
    resolver.state_rates();
    if !resolver.errors.is_empty() {
        return None;
    }

    // Checks of the whole. AFTER THIS POINT: every part is held by something, every name is used, and in space the frames
    // that joints hold together are together in the home pose (or an error is recorded).
    check::connected(resolver, &joints, &forces);
    check::used(resolver);
    if resolver.world == World::Spatial {
        let home = initial_pose::guesses(resolver, &joints, &Tree::default());
        check::home_poses(resolver, &joints, &home);
    }

    // The tree. AFTER THIS POINT: the joints that are coordinates are known, parents before children.
    let tree = spanning::grow(resolver, &joints, description.cut.as_deref());
    debug_assert!(tree.parents_come_first());
    check::carried(resolver, &tree);

    // Initial poses. AFTER THIS POINT: every local coordinate has a guess that depends on parameters alone.
    let guesses: Guesses = initial_pose::guesses(resolver, &joints, &tree);
    debug_assert!(guesses.are_known(&resolver.graph));
    let sizes = Sizes::new(resolver, &joints, &guesses);

    // The reduction. AFTER THIS POINT: every local coordinate is an expression of generalized ones.
    let mut reduction = reduce::reduce(
        resolver,
        &joints,
        &tree,
        &description.keep,
        (&guesses, &sizes),
    )?;
    debug_assert!(reduction.is_complete(&resolver.graph, &resolver.parts));

    // Vacuous rows. AFTER THIS POINT: every row that is neither solved nor vacuous depends on the motion (or an error is
    // recorded).
    let vacuous = vacuous::rows(resolver, &joints, &tree, &mut reduction);
    check::massive(resolver, &tree, &reduction);

    // The layout. AFTER THIS POINT: every generalized coordinate has its position in q, and every velocity its
    // coordinate.
    let layout = layout::layout(resolver, &reduction, &guesses);
    debug_assert_eq!(layout.slots.len(), layout.velocities.len());
    let carried_velocities = initial_pose::carried_velocities(resolver, &tree, &guesses);

    // AFTER THIS POINT: all errors of the declaration have been found.
    let drawing = resolver.drawing(&joints, &forces);
    let up = resolver.up(gravity);
    if !resolver.errors.is_empty() {
        return None;
    }
    let (outputs, output_exprs) = outputs.into_iter().unzip();
    let (events, event_exprs) = events.into_iter().unzip();
    let joints = joints.into_iter();
    let joints = joints.filter(|entry| !reduction.dissolved(&entry.name));
    let joints: Vec<JointEntry> = joints.collect();
    let outline = Outline {
        name: declaration.name.to_string(),
        doc: declaration.doc.clone(),
        world: state.world,
        text: declaration.text.clone(),
        parameters: state.parameters,
        inputs: state.inputs,
        outputs,
        events,
        up,
        locals: state.locals,
        parts: state.parts,
        states: state.scalar_states,
        joints: joints.iter().map(|entry| entry.name.clone()).collect(),
        solved: reduction.solved.joints(),
        forces: forces.iter().map(|entry| entry.name.clone()).collect(),
        tree,
        formulation: description.formulation,
        reductions: reduction.sentences,
        drawing,
        laws: state.laws,
        tables: state.tables,
    };
    Some(Model {
        graph: state.graph,
        outline,
        outputs: output_exprs,
        readings: state.readings,
        events: event_exprs,
        held,
        requirements: state.requirements,
        gravity,
        joints: joints
            .into_iter()
            .map(|entry| (entry.name, entry.joint))
            .collect(),
        vacuous,
        forces: forces.into_iter().map(|entry| entry.force).collect(),
        layout,
        reduction: reduction.substitution,
        merged: reduction.merged,
        solved: reduction.solved,
        twists: reduction.twists,
        carried_velocities,
        sizes,
    })
}

/// The parameters of the entries of an assembly alone, of this world.
pub fn parameters(declaration: &Declaration, world: World, errors: &mut Errors) -> Vec<Quantity> {
    let formulation = Formulation::Natural;
    let mut resolver = Resolver::new(declaration, kinds(), formulation, errors);
    resolver.world = world;
    resolver.declare();
    check::arguments(&mut resolver);
    if resolver.given_parameters() {
        resolver.quantities();
    }
    for entry in &declaration.entries {
        if entry.named("nominal").is_some() && entry.kind == "Param" {
            resolver.fail::<()>(entry.span(), CONSTANT_IN_ASSEMBLY);
        }
    }
    resolver.parameters
}
