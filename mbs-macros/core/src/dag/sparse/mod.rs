//! Sparse elimination, for systems too large for dense arrays.
//!
//! Accelerations are a solution with K, and so are the kicks and projections of a step:
//!
//! ```text
//! K = [ M  A₀ᵀ ]    K [ v̇  ] = [ F − ṗ|_v ]    K [ δv ] = [ 0 ]
//!     [ A₁  0  ]      [ −λ ]   [ −γ       ]      [ −κ ]   [ r ]
//! ```
//!
//! which is as sparse as the mechanism, while M⁻¹, and with it A₁M⁻¹A₀ᵀ, is full for a chain. The order of elimination,
//! and so the index of every entry and of all fill, is chosen here. The generated code has no index arrays, unless it would
//! be too long: then it has tables of the pattern.

mod fill;
mod order;
mod stretches;
mod table;

use crate::derivatives::Derived;
use crate::symbolic::Expr;
use fill::{column_operations, fill};
use std::collections::BTreeSet;

pub use stretches::Stretch;
pub use table::Table;

/// With fewer rows dense arrays, held in registers and caches, are the faster.
const FEWEST_ROWS: usize = 16;
/// Code longer than this costs more to compile than it gains; the elimination is then by a table of its pattern.
const LONGEST: usize = 20_000;
/// An operation by a table takes as long as about this many of a dense matrix: it looks up where its operand is.
const BY_TABLE: usize = 3;
/// The most velocities for which a constant M⁻¹f is written out.
const LONGEST_CONSTANT: usize = 100;
/// Solutions with each factor in a step.
const SOLUTIONS: usize = 3;

/// The elimination of a sparse symmetric pattern.
#[derive(Debug, Clone)]
pub struct Elimination {
    /// The position of each unknown in the order: the velocities, then the rows.
    pub positions: Vec<usize>,
    /// The columns, in the order of elimination.
    pub columns: Vec<Column>,
    /// Length of the array of entries: of each column the pivot, then what is below it.
    pub slots: usize,
    /// The columns as loops, in the order of their elimination.
    pub stretches: Vec<Stretch>,
}

/// A column of the factor.
#[derive(Debug, Clone)]
pub struct Column {
    /// Whether it belongs to a row of A (its pivot is negative).
    pub is_row: bool,
    /// Positions of the entries below the pivot, ascending, and whether they belong to rows of A.
    pub below: Vec<(usize, bool)>,
    /// Slot of the pivot.
    pub pivot: usize,
}

/// What a large mechanism is solved with: accelerations for all, kicks for some.
#[derive(Debug, Clone)]
pub struct Sparse {
    /// K.
    pub rows: Elimination,
    /// Places of the entries of M, upper triangle.
    pub mass_entries: Vec<(usize, usize)>,
    /// The entries of A that are not zero, row by row.
    pub jacobian: Vec<(usize, usize)>,
    /// N.
    pub size: usize,
    /// R.
    pub row_count: usize,
    /// How many rows follow from others.
    pub redundant: usize,
    /// What the kicks of the two-level step need beside.
    pub kicks: Option<Kicks>,
}

/// What kicks need beside K. They exist if M is constant, forces depend on positions only, and all rows are holonomic.
#[derive(Debug, Clone)]
pub struct Kicks {
    /// M by itself.
    pub mass: Elimination,
    /// Whether M⁻¹f is computed where it is needed: forces depend on more than parameters, or there are so many that
    /// `prepare`, where each entry of M⁻¹f is a sum over f, would be long.
    pub forces_vary: bool,
    /// Operations of a step, less those of the functions it evaluates.
    pub operations: usize,
}

impl Sparse {
    /// The elimination of a mechanism, if that is cheaper than dense arrays.
    pub fn of(derived: &Derived) -> Option<Self> {
        let (system, rows) = (&derived.system, derived.system.rows.len());
        if rows < FEWEST_ROWS {
            return None;
        }
        let size = system.size;
        let mass: Vec<(usize, usize)> = system.mass.keys().copied().collect();
        let jacobian: Vec<(usize, usize)> = derived.jacobian.keys().copied().collect();
        let coupled = jacobian.iter().map(|&(row, column)| (size + row, column));
        let mut sparse = Sparse {
            rows: Elimination::new(size, rows, mass.iter().copied().chain(coupled)),
            mass_entries: mass,
            jacobian,
            size,
            row_count: rows,
            redundant: derived.redundant.len(),
            kicks: None,
        };
        sparse.kicks = Kicks::of(derived, &sparse);
        let is_used = sparse.kicks.is_some() || sparse.accelerates_faster(derived);
        is_used.then_some(sparse)
    }

    /// Whether accelerations take fewer operations than with the dense factors of M, where it varies, and of A M⁻¹Aᵀ.
    fn accelerates_faster(&self, derived: &Derived) -> bool {
        let (n, r) = (self.size, self.row_count);
        let mass = match derived.constant_mass {
            true => 0,
            false => n * n * n / 3 + 2 * n * n * r,
        };
        let dense = mass + n * r * r + r * r * r / 3;
        self.rows.operations().iter().sum::<usize>() < dense
    }
}

impl Kicks {
    /// If they exist, and are cheaper than dense arrays.
    fn of(derived: &Derived, sparse: &Sparse) -> Option<Kicks> {
        let (system, n, r) = (&derived.system, sparse.size, sparse.row_count);
        let exist = derived.constant_mass
            && !derived.velocity_forces
            && system.layout.rotations.is_empty()
            && system.holonomic_rows() == r;
        if !exist {
            return None;
        }
        let varies = |&force: &Expr| {
            system
                .graph
                .depends_on(force, |symbol| !symbol.is_parameter_like())
        };
        let mass = Elimination::new(n, 0, sparse.mass_entries.iter().copied());
        let rows = &sparse.rows;
        let operations = 3 * rows.factor_operations()
            + 2 * SOLUTIONS * rows.solve_operations()
            + mass.solve_operations()
            + 2 * SOLUTIONS * sparse.jacobian.len();
        let dense = 2 * r * r * r + 2 * n * r * r;
        (rows.weight() * operations < dense).then(|| Kicks {
            forces_vary: n > LONGEST_CONSTANT || system.forces.iter().any(varies),
            mass,
            operations,
        })
    }
}

impl Elimination {
    /// Chooses the order for `velocities` + `rows` unknowns with these couplings.
    fn new(
        velocities: usize,
        rows: usize,
        couplings: impl Iterator<Item = (usize, usize)>,
    ) -> Self {
        let mut neighbours = vec![BTreeSet::new(); velocities + rows];
        for (i, j) in couplings.filter(|(i, j)| i != j) {
            neighbours[i].insert(j);
            neighbours[j].insert(i);
        }
        let order = order::from_both_ends(&neighbours, velocities);
        let below = fill(&neighbours, &order);
        let trees = order::link_by_link(&below);
        let links = match rows {
            0 => order::in_turns(trees, &below),
            _ => trees.concat(),
        };
        let order: Vec<usize> = links.into_iter().map(|position| order[position]).collect();
        let mut positions = vec![0; order.len()];
        for (position, &unknown) in order.iter().enumerate() {
            positions[unknown] = position;
        }
        let below = fill(&neighbours, &order);
        let mut slots = 0;
        let is_row = |position: usize| order[position] >= velocities;
        let columns: Vec<Column> = below
            .into_iter()
            .enumerate()
            .map(|(position, below)| {
                let pivot = slots;
                slots += 1 + below.len();
                Column {
                    is_row: is_row(position),
                    below: below.into_iter().map(|i| (i, is_row(i))).collect(),
                    pivot,
                }
            })
            .collect();
        let mut elimination = Elimination {
            positions,
            columns,
            slots,
            stretches: Vec::new(),
        };
        elimination.stretches = stretches::find(&elimination);
        elimination
    }

    /// The slot of the entry at two positions.
    ///
    /// # Panics
    /// If the entry is zero.
    pub fn slot(&self, i: usize, j: usize) -> usize {
        let (column, row) = (&self.columns[i.min(j)], i.max(j));
        if i == j {
            return column.pivot;
        }
        let place = column.below.binary_search_by_key(&row, |&(i, _)| i);
        column.pivot + 1 + place.expect("an entry or fill")
    }

    /// The slot of the entry at two unknowns.
    pub fn slot_of(&self, i: usize, j: usize) -> usize {
        self.slot(self.positions[i], self.positions[j])
    }

    /// Its pattern as tables.
    pub fn table(&self) -> Table {
        Table::of(self)
    }

    /// Whether it is by a table.
    pub fn is_tabled(&self) -> bool {
        self.statements() >= LONGEST
    }

    /// Statements of both factorisations and their solutions, as they are written: once for each loop.
    fn statements(&self) -> usize {
        let written = self.stretches.iter().flat_map(|stretch| {
            let first = stretch.first;
            &self.columns[first..first + stretch.period]
        });
        let below = written.map(|column| column.below.len());
        below.map(|below| below * (3 * below + 9) / 2).sum()
    }

    /// What one of its operations costs, in operations with dense arrays.
    fn weight(&self) -> usize {
        if self.is_tabled() { BY_TABLE } else { 1 }
    }

    /// Multiplications and additions of a symmetric factorisation and of a solution, in those of dense arrays.
    pub fn operations(&self) -> [usize; 2] {
        [self.factor_operations(), self.solve_operations()].map(|count| self.weight() * count)
    }

    /// Multiplications and additions of a solution.
    fn solve_operations(&self) -> usize {
        4 * self.slots
    }

    /// Multiplications and additions of a symmetric factorisation.
    fn factor_operations(&self) -> usize {
        let columns = self.columns.iter().map(|column| column.below.len());
        columns.map(column_operations).sum()
    }
}
