//! Rank, mobility, and the names of redundant rows, computed numerically at compile time.
//!
//! Between stages 3 and 4 the constraint Jacobian A is evaluated by the interpreter at a few poses near the declared
//! guess, with default parameters. The guess is assembled, then moved at random along the free velocities, and
//! assembled again. So the poses stay on the branch of the guess, and a singular guess does not decide. Rows are
//! orthogonalised in their order: one that adds nothing to those before it is redundant, and the coefficients say on
//! which of them it depends. (A parameter that tilts an axis can change the rank; assembly at run time repeats the
//! check.) Many rows are orthogonalised only if their normal equations find one that may be dependent: see `normal`.
//!
//! A guess that cannot be assembled is examined further: see `closing`.

mod closing;
mod held;
mod inertia;
mod integrability;
mod normal;
mod numbers;
mod rows;
mod shared;
mod words;

use crate::derivatives::{self, RowDerivatives};
use crate::equations::{Row, System, VacuousRow};
use crate::model::Outline;
use numbers::Numbers;

pub use closing::Open;
pub use held::held;
pub use inertia::massless;
pub use words::{redundancies, summary};

/// The number of poses.
const POSES: u64 = 3;
/// A row depends on those before it whose coefficient exceeds this.
const INVOLVED: f64 = 1e-7;

/// Rank and free velocities.
#[derive(Debug, Clone, PartialEq)]
pub struct Mobility {
    /// Rank of A at generic poses.
    pub rank: usize,
    /// Degrees of freedom: velocities without states, less rank.
    pub mobility: usize,
    /// Rows that follow from others.
    pub redundant: Vec<Redundancy>,
    /// Those of them that are not left out.
    pub dependent: Vec<usize>,
    /// Joints whose reactions are not determined: multipliers of redundant rows, and of those that they follow from,
    /// change them without an effect on the motion.
    pub undetermined: Vec<String>,
    /// Nonholonomic rows that are conditions on positions in disguise (Frobenius): with the holonomic ones, and those
    /// before them in this list, they are the differentials of functions.
    pub integrable: Vec<usize>,
}

/// A row that follows from others.
#[derive(Debug, Clone, PartialEq)]
pub struct Redundancy {
    /// The row.
    pub row: String,
    /// The entry of the declaration it comes from.
    pub entry: String,
    /// It is left out, because joint coordinates satisfy it.
    pub vacuous: bool,
    /// Entries of the declaration whose rows it follows from.
    pub follows_from: Vec<String>,
    /// Joints on its loop that have become coordinates and left no rows.
    pub along: Vec<String>,
}

/// The mobility of a mechanism; `None` if no pose near the guess could be assembled.
///
/// # Errors
/// No pose satisfies all rows.
pub fn analyse(outline: &Outline, system: &System) -> Result<Option<Mobility>, Open> {
    let mut redundant: Vec<Redundancy> =
        system.vacuous.iter().map(Redundancy::of_vacuous).collect();
    if system.rows.is_empty() {
        return Ok(Some(Mobility {
            rank: 0,
            mobility: system.size - system.layout.states.len(),
            redundant,
            dependent: Vec::new(),
            undetermined: shared::with_rows_left_out(system),
            integrable: Vec::new(),
        }));
    }
    // In a graph of their own: stage 4 makes its expressions in its own order.
    let mut graph = system.graph.clone();
    let derived = match system.holonomic_rows() == system.rows.len() {
        // Rates are for the test whether the others are integrable.
        true => derivatives::holonomic(&mut graph, &system.rows),
        false => derivatives::rows(&mut graph, &system.rows),
    };
    let order = numbers::order(outline, system);
    let (numbers, guess) = Numbers::new(outline, system, &graph, &derived, &order);
    let home = match numbers.assemble(guess.clone()) {
        Some(home) => home,
        None => match closing::close(&numbers, guess)? {
            Some(home) => home,
            None => return Ok(None),
        },
    };
    let moved = (0..POSES).filter_map(|seed| numbers.generic_pose(&home, seed));
    let mut poses: Vec<Vec<f64>> = moved.collect();
    // On a branch the rank is lower only at single poses: the pose with the highest rank is generic. (A mechanism that
    // cannot move has no other pose than its home.)
    poses.push(home);
    let rows = poses.iter().map(|pose| (pose, numbers.dependencies(pose)));
    let Some((pose, rows)) = rows.max_by_key(|(_, rows)| rows.independent.len()) else {
        return Ok(None);
    };
    let rank = rows.independent.len();
    let mut cancelling = Vec::new();
    for (row, coefficients) in &rows.dependent {
        let involved = combined(*row, &rows.independent, coefficients);
        redundant.push(Redundancy {
            row: system.rows[*row].name.clone(),
            entry: system.rows[*row].entry.clone(),
            vacuous: false,
            follows_from: entries(&system.rows, &involved[..involved.len() - 1]),
            along: along(outline, system, &derived, &involved),
        });
        let others = rows.independent.iter().copied();
        let coefficients = coefficients.iter().map(|coefficient| -coefficient);
        let significant = others
            .zip(coefficients)
            .filter(|(other, _)| involved.contains(other));
        cancelling.push(significant.chain([(*row, 1.0)]).collect());
    }
    Ok(Some(Mobility {
        rank,
        mobility: (system.size - system.layout.states.len()).saturating_sub(rank),
        redundant,
        dependent: rows.dependent.iter().map(|(row, _)| *row).collect(),
        undetermined: shared::undetermined(&numbers, pose, &cancelling),
        integrable: integrability::integrable(&numbers, &poses),
    }))
}

/// The rows that follow from others and are not left out.
pub fn dependent(mobility: Option<&Mobility>) -> Vec<usize> {
    mobility.map_or_else(Vec::new, |found| found.dependent.clone())
}

impl Redundancy {
    fn of_vacuous(row: &VacuousRow) -> Redundancy {
        Redundancy {
            row: row.name.clone(),
            entry: row.entry.clone(),
            vacuous: true,
            follows_from: row.follows_from.clone(),
            along: Vec::new(),
        }
    }
}

/// The rows with significant coefficients in the combination that equals a dependent row, and then the row itself.
fn combined(row: usize, independent: &[usize], coefficients: &[f64]) -> Vec<usize> {
    let others = independent.iter().zip(coefficients);
    let others = others.filter(|(_, coefficient)| coefficient.abs() > INVOLVED);
    others.map(|(&other, _)| other).chain([row]).collect()
}

/// The joints on whose coordinates rows depend.
fn along(
    outline: &Outline,
    system: &System,
    derived: &RowDerivatives,
    rows: &[usize],
) -> Vec<String> {
    let mut joints: Vec<String> = Vec::new();
    let columns = derived.jacobian.keys().filter(|(i, _)| rows.contains(i));
    for &(_, column) in columns {
        let name = &system.layout.velocities[column].name;
        let owner = name.split('.').next().unwrap_or_default();
        let is_part = outline.parts.iter().any(|part| part.name == owner);
        if !is_part && !joints.iter().any(|joint| joint == owner) {
            joints.push(owner.to_owned());
        }
    }
    joints.sort();
    joints
}

/// The entries that rows come from.
fn entries(rows: &[Row], indices: &[usize]) -> Vec<String> {
    let mut entries: Vec<String> = Vec::new();
    for &row in indices {
        let entry = &rows[row].entry;
        if !entries.contains(entry) {
            entries.push(entry.clone());
        }
    }
    entries
}
