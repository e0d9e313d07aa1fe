//! The choice of coordinates: each description that applies is derived and its step counted, and the cheapest is taken.

use crate::compile::Analysis;
use crate::dag::{self, Program};
use crate::derivatives;
use crate::diagnostics::Errors;
use crate::equations;
use crate::mobility::{self, Open};
use crate::model::{self, Description, Formulation, Model, Part, Representation};
use crate::refusals;
use crate::syntax::Declaration;
use std::collections::VecDeque;

/// A description that was considered.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// Which.
    pub formulation: Formulation,
    /// Q.
    pub coordinates: usize,
    /// N.
    pub velocities: usize,
    /// R.
    pub rows: usize,
    /// Rank of the rows near the guess, where a pose could be assembled there.
    pub rank: Option<usize>,
    /// Operations of a step; `None` where the linear algebra alone costs more than a whole step of another.
    pub operations: Option<usize>,
    /// Joints that could carry a part, and close a loop instead.
    pub cut: Vec<String>,
    /// Whether it is the one in use.
    pub taken: bool,
}

/// Mechanisms with more velocities are derived with one cut only.
const MOST_FOR_OTHER_CUTS: usize = 12;

/// Derives what is asked for, or the cheapest.
pub(crate) fn choose(
    declaration: &Declaration,
    requested: Option<Formulation>,
    errors: &mut Errors,
) -> Option<Analysis> {
    let first = Description::from(requested.unwrap_or(Formulation::Natural));
    let model = model::resolve(declaration, &first, errors);
    if !errors.is_empty() {
        return None;
    }
    let mut waiting = other_cuts(&first, model.as_ref()?);
    let mut best = match derive(declaration, &first, model?) {
        Ok(best) => best,
        Err(open) => {
            refusals::refuse_open(declaration, &open, errors);
            return None;
        }
    };
    if let (true, Some(mobility)) = (declaration.deny_redundant, &best.mobility) {
        refusals::refuse_redundant(declaration, mobility, &best.derived, errors);
    }
    if requested.is_none() {
        waiting.extend([Formulation::Reference, Formulation::Joint].map(Description::from));
    } else if waiting.is_empty() {
        return Some(best);
    }
    let mut candidates = vec![candidate(&mut best)];
    let mut taken = 0;
    while let Some(description) = waiting.pop_front() {
        let formulation = description.formulation;
        // What is wrong with a declaration was found already; a description that does not apply is passed over.
        let mut passed_over = Errors::new();
        let model = model::resolve(declaration, &description, &mut passed_over);
        let (Some(mut model), true) = (model, passed_over.is_empty()) else {
            continue;
        };
        if same(&model, &best.model) {
            // Where no bar is its end points, natural coordinates are reference coordinates.
            let parts = &best.model.parts;
            let natural = |part: &Part| part.representation == Representation::Natural;
            if formulation == Formulation::Reference && !parts.iter().any(natural) {
                best.model.formulation = formulation;
                candidates[0].formulation = formulation;
            }
            continue;
        }
        let cheapest = candidates.iter().filter_map(|other| other.operations).min();
        let size = model.layout.velocities.len();
        let rows = count_rows(&mut model);
        if cheapest.is_some_and(|cheapest| least(size, rows) > cheapest) {
            candidates.push(Candidate {
                formulation,
                coordinates: model.layout.coordinates.len(),
                velocities: size,
                rows,
                rank: None,
                operations: None,
                cut: model.tree.cut,
                taken: false,
            });
            continue;
        }
        waiting.extend(other_cuts(&description, &model));
        let Ok(mut other) = derive(declaration, &description, model) else {
            continue;
        };
        let own = candidate(&mut other);
        // Of two that cost the same the one tried first stays.
        if own.operations < cheapest {
            best = other;
            taken = candidates.len();
        }
        candidates.push(own);
    }
    if candidates.len() > 1 || requested.is_none() {
        candidates[taken].taken = true;
        best.candidates = candidates;
    }
    Some(best)
}

/// The same description with its loops cut elsewhere.
fn other_cuts(description: &Description, model: &Model) -> VecDeque<Description> {
    if model.layout.velocities.len() > MOST_FOR_OTHER_CUTS {
        return VecDeque::new();
    }
    let alternatives = model.tree.alternatives.iter();
    alternatives
        .map(|cut| Description {
            cut: Some(cut.clone()),
            ..description.clone()
        })
        .collect()
}

/// A description with its equations. Where redundancy leaves the reaction of a solved row open, the row is taken back: so
/// those who share a load are named, and share it by least norm.
fn derive(
    declaration: &Declaration,
    description: &Description,
    model: Model,
) -> Result<Analysis, Open> {
    let mut description = description.clone();
    let mut analysis = derived(model)?;
    let rows = analysis.model.solved.rows.iter();
    let joints: Vec<String> = rows.map(|(joint, _)| joint.clone()).collect();
    if analysis.mobility.is_none() && !joints.is_empty() {
        // What cannot be closed is told best with all rows at hand.
        let mut none = Errors::new();
        let all_rows = Description {
            keep: joints,
            ..description.clone()
        };
        let model = model::resolve(declaration, &all_rows, &mut none);
        if let (Some(model), true) = (model, none.is_empty()) {
            derived(model)?;
        }
    }
    loop {
        let open = analysis.mobility.iter().flat_map(|m| &m.undetermined);
        let solved = &analysis.model.solved;
        let shared: Vec<String> = open
            .filter(|joint| solved.touches(joint))
            .cloned()
            .collect();
        if shared.is_empty() {
            return Ok(analysis);
        }
        description.keep.extend(shared);
        let mut none = Errors::new();
        match model::resolve(declaration, &description, &mut none) {
            Some(model) if none.is_empty() => analysis = derived(model)?,
            _ => return Ok(analysis),
        }
    }
}

fn derived(mut model: Model) -> Result<Analysis, Open> {
    let system = equations::derive(&mut model);
    let mut derived = derivatives::derive(system);
    let mobility = mobility::analyse(&model, &derived)?;
    if let Some(mobility) = &mobility {
        derived.redundant = mobility.dependent.clone();
    }
    Ok(Analysis {
        model,
        derived,
        mobility,
        candidates: Vec::new(),
        program: None,
    })
}

/// Whether two descriptions have the same coordinates and the same joints left as rows.
fn same(a: &Model, b: &Model) -> bool {
    let names = |model: &Model| -> Vec<String> {
        let coordinates = model.layout.coordinates.iter();
        let joints = model.joints.iter().map(|(name, _)| name.clone());
        coordinates
            .map(|stored| stored.name.clone())
            .chain(joints)
            .collect()
    };
    names(a) == names(b)
}

fn count_rows(model: &mut Model) -> usize {
    let graph = &mut model.graph;
    let joints = model.joints.iter();
    let rows: usize = joints
        .map(|(_, joint)| joint.equations(graph).rows.len())
        .sum();
    rows - model.vacuous.len() - model.solved.rows.len()
}

fn candidate(analysis: &mut Analysis) -> Candidate {
    let program = dag::lower(&analysis.derived);
    let candidate = Candidate {
        formulation: analysis.model.formulation,
        coordinates: program.coordinates,
        velocities: program.size,
        rows: program.rows.len(),
        rank: analysis.mobility.as_ref().map(|mobility| mobility.rank),
        operations: Some(step(&program)),
        cut: analysis.model.tree.cut.clone(),
        taken: false,
    };
    analysis.program = Some(program);
    candidate
}

/// Passes of the iteration on the multipliers in a step that begins with those of the last.
const PASSES: usize = 2;
/// Passes of Newton's method in each, where the flow is implicit.
const INNER_PASSES: usize = 2;
/// What a division and an elementary function cost, in additions.
const DIVISION: usize = 5;
const CALL: usize = 20;
/// A free flight of a rotation.
const FLIGHT: usize = 120;

/// Operations of a step of second order: the functions it evaluates and the linear algebra between.
fn step(program: &Program) -> usize {
    let of = |name: &str| {
        program.function(name).map(|function| {
            let cost = function.cost();
            cost.additions + cost.multiplications + DIVISION * cost.divisions + CALL * cost.calls
        })
    };
    let cost = |name: &str| of(name).unwrap_or(0);
    let (n, r) = (program.size, program.rows.len());
    let structure = program.structure;
    let explicit = structure.constant_mass && !structure.velocity_forces;
    if let Some(sparse) = &program.sparse {
        // With sparse M, accelerations are among its solutions.
        let functions = (1 + PASSES) * cost("constraints") + cost("applied_forces");
        return functions + 2 * (1 + PASSES) * n + sparse.operations();
    }
    let delassus = of("delassus").unwrap_or(2 * n * r * r);
    let metric = of("metric").unwrap_or_else(|| {
        let rows = of("solve_mass_rows").unwrap_or(2 * n * n * r);
        rows + delassus
    });
    let rows = cost("constraints")
        + metric
        + delassus
        + PASSES * (cost("holonomic") + 2 * n * r)
        + cost("row_rates");
    let motion = if explicit {
        cost("acceleration") + PASSES * (2 * n + FLIGHT * program.rotations.len())
    } else {
        let balance = of("balance").unwrap_or_else(|| cost("momentum") + cost("forces"));
        let tangents =
            of("balance_tangents").unwrap_or_else(|| cost("mass_matrix") + cost("force_tangents"));
        let factor = of("factor_mass").unwrap_or_else(|| cost("mass_matrix") + n * n * n / 3);
        PASSES * INNER_PASSES * balance + tangents + factor
    };
    rows + motion + linear_algebra(n, r, explicit)
}

/// What a step with a mass matrix that varies costs at least. (Small systems have zeros that loops cannot know.)
fn least(n: usize, r: usize) -> usize {
    let weighted = if n > 20 { 2 * n * r * r } else { 0 };
    linear_algebra(n, r, false) + weighted
}

/// Factorisations and their solutions: S and B of the rows, and J of an implicit flow with the directions of the rows.
fn linear_algebra(n: usize, r: usize, explicit: bool) -> usize {
    let rows = r * r * r + (2 + 2 * PASSES) * r * r;
    let flow = match explicit {
        true => 0,
        false => 2 * n * n * n / 3 + PASSES * INNER_PASSES * 2 * n * n + 2 * n * n * r,
    };
    rows + flow
}
