//! The choice of coordinates: each description that applies is derived and its step counted, and the cheapest is taken.
//!
//! `compile` runs the stages. Between them the functions of this file determine the next description, and whether the
//! present one is continued.

use crate::analysis::{Analysis, Candidate};
use crate::contract;
use crate::dag::Program;
use crate::diagnostics::{Errors, Failure};
use crate::equations::System;
use crate::mobility::{Mobility, Open};
use crate::model::{self, Description, Formulation, Model, Outline, Part, Representation, Stored};
use crate::refusals;
use crate::schema::World;
use crate::syntax::Declaration;
use std::collections::VecDeque;

/// Mechanisms with more velocities are derived with one cut only.
const MOST_FOR_OTHER_CUTS: usize = 12;

/// In mechanisms of more velocities other descriptions are not derived if they are known to cost more.
const MANY: usize = 200;
/// Kinds of entries that fix no angle.
const LEAVES_ANGLES: [&str; 11] = [
    "Bar",
    "Body",
    "Particle",
    "Revolute",
    "SpringDamper",
    "Force",
    "Torque",
    "Param",
    "Input",
    "Output",
    "Event",
];

/// A description to be tried, and why.
#[derive(Debug, Clone)]
struct Trial {
    description: Description,
    purpose: Purpose,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Purpose {
    /// It may be the cheapest.
    Candidate,
    /// The same without the elimination of rows whose reactions are not determined because of redundancy.
    RowsTakenBack,
    /// With all rows, for the message about a loop that cannot close.
    Closing,
    /// No variant of it remains to be tried.
    Settled,
}

/// The search for the cheapest description.
pub(crate) struct Search<'d> {
    declaration: &'d Declaration,
    requested: Option<Formulation>,
    waiting: VecDeque<Trial>,
    /// The present one.
    current: Option<Trial>,
    /// The errors for the user.
    errors: Errors,
    /// Errors of descriptions other than the first: these do not apply, and are skipped.
    passed_over: Errors,
    /// Errors about parts that move without mass, where other descriptions are tried in the place of the first one.
    fallback: Option<Errors>,
    best: Option<Analysis>,
    candidates: Vec<Candidate>,
    taken: usize,
}

impl<'d> Search<'d> {
    /// Begins with the declared description, or with natural coordinates.
    pub(crate) fn new(declaration: &'d Declaration) -> Self {
        let mut errors = Errors::new();
        let requested = model::requested(declaration, &mut errors);
        model::budget(declaration, &mut errors);
        let first = Description::from(requested.unwrap_or(Formulation::Natural));
        let mut search = Search {
            declaration,
            requested,
            waiting: VecDeque::new(),
            current: None,
            errors,
            passed_over: Errors::new(),
            fallback: None,
            best: None,
            candidates: Vec::new(),
            taken: 0,
        };
        search.queue(first, Purpose::Candidate);
        search
    }

    /// The next description to be derived.
    pub(crate) fn next(&mut self) -> Option<Description> {
        if !self.errors.is_empty() {
            return None;
        }
        self.passed_over = Errors::new();
        self.current = self.waiting.pop_front();
        Some(self.current.as_ref()?.description.clone())
    }

    /// The list for the errors of the current description.
    pub(crate) fn errors(&mut self) -> &mut Errors {
        let is_first = self.is_first() && self.fallback.is_none();
        match is_first && self.purpose() == Purpose::Candidate {
            true => &mut self.errors,
            false => &mut self.passed_over,
        }
    }

    /// After stage 2: returns the model if its equations are to be derived.
    pub(crate) fn admit(&mut self, model: Option<Model>) -> Option<Model> {
        let trial = self.current.clone()?;
        if model.is_none() && self.requested.is_none() && self.errors.is_of_mass() {
            // A part that moves without mass by its points may move others with its joint.
            self.fallback = Some(std::mem::take(&mut self.errors));
            self.queue_others();
        }
        let model = model?;
        match trial.purpose {
            Purpose::Candidate => {}
            Purpose::RowsTakenBack => {
                // It replaces the description with these rows eliminated, which is next in the queue.
                self.waiting.pop_front();
                return Some(model);
            }
            Purpose::Closing | Purpose::Settled => return Some(model),
        }
        let description = trial.description;
        if let Some(best) = &mut self.best {
            if same(&model.outline, &model.layout.coordinates, best) {
                // If no bar is described by its end points, natural coordinates are the same as reference coordinates.
                let natural = |part: &Part| part.representation == Representation::Natural;
                let formulation = description.formulation;
                if formulation == Formulation::Reference && !best.outline.parts.iter().any(natural)
                {
                    best.outline.formulation = formulation;
                    self.candidates[0].formulation = formulation;
                }
                return None;
            }
            let (size, rows) = (model.layout.velocities.len(), model.count_rows());
            let cheapest = cheapest(&self.candidates);
            if cheapest.is_some_and(|cheapest| least(size, rows) > cheapest) {
                self.candidates.push(Candidate {
                    formulation: description.formulation,
                    coordinates: model.layout.coordinates.len(),
                    velocities: size,
                    rows,
                    rank: None,
                    operations: None,
                    cut: model.outline.tree.cut,
                    taken: false,
                });
                return None;
            }
        }
        self.queue_other_cuts(&description, &model);
        Some(model)
    }

    /// After the analysis of mobility: returns the mobility if the description is continued.
    ///
    /// If the reaction of an eliminated row is not determined because of redundancy, the row is not eliminated: then
    /// all rows that share the load are named, and their reactions have the least norm.
    pub(crate) fn settle(
        &mut self,
        outline: &Outline,
        system: &System,
        mobility: Result<Option<Mobility>, Open>,
    ) -> Option<Option<Mobility>> {
        let Trial {
            mut description,
            purpose,
        } = self.current.clone()?;
        let mobility = match mobility {
            Ok(mobility) => mobility,
            Err(open) => {
                if purpose == Purpose::Closing {
                    self.waiting.pop_front();
                }
                if self.is_first() {
                    refusals::refuse_open(self.declaration, &open, &mut self.errors);
                }
                return None;
            }
        };
        if purpose == Purpose::Closing {
            return None;
        }
        if purpose == Purpose::Candidate && mobility.is_none() && !outline.solved.is_empty() {
            // The message about a loop that cannot close is best with all rows.
            self.try_again(description.clone(), Purpose::Settled);
            description.keep.clone_from(&outline.solved);
            self.try_again(description, Purpose::Closing);
            return None;
        }
        let open = mobility.iter().flat_map(|found| &found.undetermined);
        let shared: Vec<String> = open
            .filter(|joint| outline.solved.contains(joint))
            .cloned()
            .collect();
        if purpose != Purpose::Settled && !shared.is_empty() {
            self.try_again(description.clone(), Purpose::Settled);
            description.keep.extend(shared);
            self.try_again(description, Purpose::RowsTakenBack);
            return None;
        }
        if let (true, true, Some(mobility)) =
            (self.declaration.deny_redundant, self.is_first(), &mobility)
        {
            refusals::refuse_redundant(self.declaration, mobility, &system.rows, &mut self.errors);
        }
        Some(mobility)
    }

    /// After the derivation: whether the outputs find the reactions that they read.
    pub(crate) fn reads(&mut self, system: &System) -> bool {
        if self.is_first() {
            for unknown in &system.unknown_readings {
                refusals::refuse_reading(unknown, &mut self.errors);
            }
        }
        system.unknown_readings.is_empty()
    }

    /// Whether each coordinate moves a mass, or the name of one that does not: then the description does not apply.
    pub(crate) fn moves(&mut self, massless: Option<String>) -> bool {
        if let Some(coordinate) = &massless
            && self.is_first()
        {
            // Reported if no other description, or other cut, moves all with mass.
            if self.fallback.is_none() && self.requested.is_none() {
                self.queue_others();
            }
            let errors = self.fallback.get_or_insert_with(Errors::new);
            if errors.is_empty() {
                refusals::refuse_massless(self.declaration, coordinate, errors);
            }
        }
        massless.is_none()
    }

    /// After the check of positions that are held: whether the description is continued.
    pub(crate) fn holds(&mut self, found: Result<(), Open>) -> bool {
        match found {
            Err(open) if self.is_first() => {
                refusals::refuse_held(self.declaration, &open, &mut self.errors);
                false
            }
            _ => true,
        }
    }

    /// Counts the operations of a description, and keeps it if it is the cheapest so far.
    pub(crate) fn consider(&mut self, analysis: Analysis) {
        let own = candidate(&analysis);
        // With equal costs the first one is taken.
        if self.is_first() {
            let others = self.requested.is_none() && !self.is_far_cheaper(&analysis, &own);
            self.best = Some(analysis);
            if others && self.fallback.is_none() {
                self.queue_others();
            }
        } else if own.operations < cheapest(&self.candidates) {
            self.best = Some(analysis);
            self.taken = self.candidates.len();
        }
        self.candidates.push(own);
    }

    /// Whether others cannot be as cheap as the first, which is known without deriving them where many parts of the plane
    /// are on revolutes alone: by bodies and by joints each part has an angle, which no row of a revolute eliminates.
    fn is_far_cheaper(&self, first: &Analysis, own: &Candidate) -> bool {
        let (Some(mobility), Some(operations)) = (&first.mobility, own.operations) else {
            return false;
        };
        let mut entries = self.declaration.entries.iter();
        let outline = &first.outline;
        if own.velocities <= MANY
            || outline.world != World::Planar
            || !entries.all(|entry| LEAVES_ANGLES.contains(&entry.kind.to_string().as_str()))
        {
            return false;
        }
        let parts = outline.parts.iter();
        let turns = |part: &&Part| {
            let representation = part.representation;
            matches!(
                representation,
                Representation::Natural | Representation::Reference
            )
        };
        let angles = parts.filter(turns).count();
        least(angles, angles.saturating_sub(mobility.mobility)) > operations
    }

    /// The cheapest.
    pub(crate) fn finish(mut self) -> Result<Analysis, Failure> {
        self.errors.stop_if_any()?;
        if let (None, Some(fallback)) = (&self.best, self.fallback) {
            fallback.stop_if_any()?;
        }
        let mut best = self.best.ok_or_else(Failure::unexplained)?;
        if self.candidates.len() > 1 || self.requested.is_none() {
            self.candidates[self.taken].taken = true;
            best.candidates = self.candidates;
        }
        Ok(best)
    }

    fn is_first(&self) -> bool {
        self.best.is_none()
    }

    fn purpose(&self) -> Purpose {
        let current = self.current.as_ref();
        current.map_or(Purpose::Candidate, |trial| trial.purpose)
    }

    fn queue(&mut self, description: Description, purpose: Purpose) {
        self.waiting.push_back(Trial {
            description,
            purpose,
        });
    }

    /// The descriptions beside natural coordinates.
    fn queue_others(&mut self) {
        for formulation in [Formulation::Reference, Formulation::Joint] {
            self.queue(Description::from(formulation), Purpose::Candidate);
        }
    }

    fn try_again(&mut self, description: Description, purpose: Purpose) {
        self.waiting.push_front(Trial {
            description,
            purpose,
        });
    }

    /// The same description with its loops cut elsewhere.
    fn queue_other_cuts(&mut self, description: &Description, model: &Model) {
        if model.layout.velocities.len() > MOST_FOR_OTHER_CUTS {
            return;
        }
        for cut in &model.outline.tree.alternatives {
            let description = Description {
                cut: Some(cut.clone()),
                ..description.clone()
            };
            self.queue(description, Purpose::Candidate);
        }
    }
}

/// The fewest operations so far.
fn cheapest(candidates: &[Candidate]) -> Option<usize> {
    candidates.iter().filter_map(|other| other.operations).min()
}

/// Whether a description has the same coordinates as the best one, and the same joints with rows.
fn same(outline: &Outline, coordinates: &[Stored], best: &Analysis) -> bool {
    let names = |coordinates: &[Stored]| -> Vec<String> {
        coordinates
            .iter()
            .map(|stored| stored.name.clone())
            .collect()
    };
    let of_best = &best.derived.system.layout.coordinates;
    names(coordinates) == names(of_best) && outline.joints == best.outline.joints
}

fn candidate(analysis: &Analysis) -> Candidate {
    let (outline, program) = (&analysis.outline, &analysis.program);
    Candidate {
        formulation: outline.formulation,
        coordinates: program.coordinates,
        velocities: program.size,
        rows: program.rows.len(),
        rank: analysis.mobility.as_ref().map(|mobility| mobility.rank),
        operations: Some(step(program)),
        cut: outline.tree.cut.clone(),
        taken: false,
    }
}

/// Passes of the iteration on the multipliers in a step that begins with those of the last.
const PASSES: usize = 2;
/// Passes of Newton's method in each, if the flow is implicit.
const INNER_PASSES: usize = 2;
/// The cost of a division and of an elementary function, in additions.
const DIVISION: usize = 5;
const CALL: usize = 20;
/// A free flight of a rotation.
const FLIGHT: usize = 120;

/// Operations of a step of second order: the functions it evaluates and the linear algebra between.
fn step(program: &Program) -> usize {
    let of = |name: &str| {
        let cost = contract::cost(program, name)?;
        Some(cost.additions + cost.multiplications + DIVISION * cost.divisions + CALL * cost.calls)
    };
    let cost = |name: &str| of(name).unwrap_or(0);
    let (n, r) = (program.size, program.rows.len());
    let structure = program.structure;
    let explicit = structure.constant_mass && !structure.velocity_forces;
    let sparse = program.sparse.as_ref();
    if let Some(kicks) = sparse.and_then(|sparse| sparse.kicks.as_ref()) {
        // With sparse M, accelerations are among its solutions.
        let functions = (1 + PASSES) * cost("constraints") + cost("applied_forces");
        return functions + 2 * (1 + PASSES) * n + kicks.operations;
    }
    let delassus = cost("delassus");
    let metric = of("metric").unwrap_or_else(|| cost("solve_mass_rows") + delassus);
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

/// The least cost of a step with a varying mass matrix. (In small systems zeros reduce it further, which loops cannot
/// use.)
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
