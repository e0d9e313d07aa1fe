//! Which velocities follow from which rows: the order in which A v = r is solved for dependent velocities.
//!
//! A mechanism of few degrees of freedom has nearly as many rows as velocities. Rows are put in an order in which each
//! block of them has as many velocities that are not known yet, one to three: solved by Cramer's rule. What no block
//! determines is independent (coordinate partitioning: Wehage and Haug, J. Mech. Des. 104, 1982, 247–255). A row with two
//! unknown velocities has a third way: along it and at right angles to it, which no pose makes singular.

use std::collections::{BTreeMap, BTreeSet};

/// More degrees of freedom have a matrix of their own that costs more than the elimination of the rows.
const MOST_FREEDOMS: usize = 4;
/// The largest block: determinants of larger ones are sums of many products.
const LARGEST_BLOCK: usize = 3;

/// The velocities of a block in ascending order, with [`NONE`] behind them.
type Columns = [usize; LARGEST_BLOCK];
/// Where a block has fewer velocities.
const NONE: usize = usize::MAX;

/// A step of the solution.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Block {
    /// As many rows as velocities that they determine.
    Square {
        /// Rows of A.
        rows: Vec<usize>,
        /// Velocities.
        columns: Vec<usize>,
    },
    /// A row with two velocities, one independent direction of both.
    Slanted {
        /// Row of A.
        row: usize,
        /// Velocities.
        columns: [usize; 2],
    },
    /// An independent velocity.
    Free {
        /// The velocity.
        column: usize,
    },
}

/// An entry of a row of A.
#[derive(Debug, Clone, Copy)]
pub(super) struct Entry {
    /// The velocity.
    pub(super) column: usize,
    /// Whether it is a number, which no pose makes zero.
    pub(super) is_number: bool,
}

/// The blocks in the order of their solution; `None` where larger blocks or more independent velocities were needed.
///
/// `units` are those of the velocities.
pub(super) fn partition(rows: &[Vec<Entry>], units: &[&str]) -> Option<Vec<Block>> {
    let size = units.len();
    let freedoms = size.checked_sub(rows.len())?;
    if freedoms > MOST_FREEDOMS {
        return None;
    }
    let mut search = Search::new(rows, units);
    let mut independent = 0;
    while !search.left.is_empty() {
        let block = (search.square())
            .or_else(|| search.square_of_pair())
            .or_else(|| search.beginning())?;
        independent += usize::from(!matches!(block, Block::Square { .. }));
        // The count does not fall again.
        if independent > freedoms {
            return None;
        }
        search.take(block);
    }
    let free: Vec<usize> = (0..size).filter(|&j| !search.known[j]).collect();
    independent += free.len();
    for column in free {
        search.take(Block::Free { column });
    }
    (independent == freedoms).then_some(search.blocks)
}

/// A block with the velocities of two rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct PairBlock {
    /// How many rows it has: the smallest block is taken first.
    count: usize,
    /// The first row, the velocity that it shares with the other row, and that row: of equal blocks the first is taken.
    pair: [usize; 3],
    columns: Columns,
}

struct Search<'a> {
    rows: &'a [Vec<Entry>],
    units: &'a [&'a str],
    /// Rows that are in no block yet.
    left: BTreeSet<usize>,
    /// The velocities of each row that are not known yet.
    unknown: Vec<BTreeSet<usize>>,
    /// Rows to be looked at for a block, with the numbers of these velocities: those with the fewest first.
    changed: BTreeSet<(usize, usize)>,
    /// The rows of each velocity.
    holders: Vec<Vec<usize>>,
    /// The rows of `left` with at most [`LARGEST_BLOCK`] unknown velocities, by these.
    few: BTreeMap<Columns, BTreeSet<usize>>,
    /// Rows whose unknown velocities changed since blocks with the velocities of two rows were looked for.
    unpaired: BTreeSet<usize>,
    /// Blocks with the velocities of two rows, as they were found.
    pairs: BTreeSet<PairBlock>,
    blocks: Vec<Block>,
    known: Vec<bool>,
}

impl<'a> Search<'a> {
    fn new(rows: &'a [Vec<Entry>], units: &'a [&'a str]) -> Self {
        let size = units.len();
        let mut search = Search {
            rows,
            units,
            left: (0..rows.len()).collect(),
            unknown: rows
                .iter()
                .map(|row| row.iter().map(|entry| entry.column).collect())
                .collect(),
            changed: (rows.iter().enumerate())
                .map(|(r, row)| (row.len(), r))
                .collect(),
            holders: vec![Vec::new(); size],
            few: BTreeMap::new(),
            unpaired: (0..rows.len()).collect(),
            pairs: BTreeSet::new(),
            blocks: Vec::new(),
            known: vec![false; size],
        };
        for (r, row) in rows.iter().enumerate() {
            for entry in row {
                search.holders[entry.column].push(r);
            }
            search.list(r);
        }
        search
    }

    /// A block with the velocities of one row.
    fn square(&mut self) -> Option<Block> {
        while let Some((count, row)) = self.changed.pop_first() {
            if count <= LARGEST_BLOCK
                && let Some(columns) = columns_of(&self.unknown[row])
                && let Some(block) = self.block_in(&columns)
            {
                return Some(block);
            }
        }
        None
    }

    /// The smallest block with the velocities of two rows that share one.
    ///
    /// A block that was not there before has a row that changed, and is found from it. No block with the velocities of one
    /// row is left. So, if that row has a and b and the block has c too, both other rows have c and at least one of a and b.
    /// With the same one of them they would be a block of two; so a and c are in one of these rows, b and c in one of them,
    /// and it is enough to look at the rows of a or at those of b.
    fn square_of_pair(&mut self) -> Option<Block> {
        while let Some(row) = self.unpaired.pop_first() {
            for columns in self.unions(row) {
                if let Some(found) = self.pair_in(&columns) {
                    self.pairs.insert(found);
                }
            }
        }
        while let Some(found) = self.pairs.pop_first() {
            let mut columns = given(&found.columns);
            // Without one of its velocities it is no block of two rows, and as another one it is found anew.
            if columns.all(|j| !self.known[j])
                && let Some(block) = self.block_in(&found.columns)
            {
                return Some(block);
            }
        }
        None
    }

    /// The velocities of this row together with those of another one that shares its least shared velocity.
    fn unions(&self, row: usize) -> BTreeSet<Columns> {
        let unknown = &self.unknown[row];
        if !self.left.contains(&row) || unknown.len() > LARGEST_BLOCK {
            return BTreeSet::new();
        }
        if unknown.len() == LARGEST_BLOCK {
            return columns_of(unknown).into_iter().collect();
        }
        let least_shared = unknown.iter().min_by_key(|&&j| self.holders[j].len());
        let others = least_shared.into_iter().flat_map(|&j| &self.holders[j]);
        let others = others.filter(|other| self.left.contains(other));
        let few = others.filter(|&&other| self.unknown[other].len() <= LARGEST_BLOCK);
        few.filter_map(|&other| columns_of(&(unknown | &self.unknown[other])))
            .collect()
    }

    /// The block with these velocities, if there is one and two of its rows that share a velocity have all of them.
    fn pair_in(&self, columns: &Columns) -> Option<PairBlock> {
        let rows = self.rows_in(columns)?;
        let has_all = |r: usize, s: usize| {
            let mut columns = given(columns);
            columns.all(|j| self.unknown[r].contains(&j) || self.unknown[s].contains(&j))
        };
        for &r in &rows {
            for &shared in &self.unknown[r] {
                let mut others = rows.iter().copied().filter(|&s| r < s);
                let other = others.find(|&s| self.unknown[s].contains(&shared) && has_all(r, s));
                if let Some(other) = other {
                    return Some(PairBlock {
                        count: rows.len(),
                        pair: [r, shared, other],
                        columns: *columns,
                    });
                }
            }
        }
        None
    }

    /// The rows that have no other unknown velocities than these, if there are as many.
    fn block_in(&self, columns: &Columns) -> Option<Block> {
        Some(Block::Square {
            rows: self.rows_in(columns)?,
            columns: given(columns).collect(),
        })
    }

    /// The rows that have no other unknown velocities than these, if there are as many: those of each subset.
    fn rows_in(&self, columns: &Columns) -> Option<Vec<usize>> {
        let count = given(columns).count();
        let mut rows = Vec::new();
        for subset in 1..1 << count {
            let chosen = (0..count).filter(|place| subset >> place & 1 == 1);
            let Some(found) = self.few.get(&padded(chosen.map(|place| columns[place]))) else {
                continue;
            };
            if rows.len() + found.len() > count {
                return None;
            }
            rows.extend(found);
        }
        rows.sort_unstable();
        (rows.len() == count).then_some(rows)
    }

    /// Puts a row where it is found by its unknown velocities.
    fn list(&mut self, row: usize) {
        if let Some(columns) = columns_of(&self.unknown[row]) {
            self.few.entry(columns).or_default().insert(row);
        }
    }

    /// Takes a row from there.
    fn unlist(&mut self, row: usize) {
        let columns = columns_of(&self.unknown[row]);
        if let Some(list) = columns.and_then(|columns| self.few.get_mut(&columns)) {
            list.remove(&row);
        }
    }

    /// An independent velocity, from the row with the fewest unknown ones.
    fn beginning(&self) -> Option<Block> {
        let row = *self.left.iter().min_by_key(|&&r| self.unknown[r].len())?;
        let columns: Vec<usize> = self.unknown[row].iter().copied().collect();
        let is_number = |column: usize| {
            let mut entries = self.rows[row].iter();
            entries.any(|entry| entry.column == column && entry.is_number)
        };
        if let [first, second] = columns[..]
            && !is_number(first)
            && !is_number(second)
            && self.units[first] == self.units[second]
        {
            return Some(Block::Slanted {
                row,
                columns: [first, second],
            });
        }
        // The rows of the others are then solved by what is a number in them.
        let count = |&column: &usize| {
            let rows = self.holders[column].iter();
            rows.filter(|r| self.left.contains(r)).count()
        };
        let column = columns
            .into_iter()
            .rev()
            .max_by_key(|column| (!is_number(*column), count(column)))?;
        Some(Block::Free { column })
    }

    fn take(&mut self, block: Block) {
        let (rows, columns) = match &block {
            Block::Square { rows, columns } => (rows.clone(), columns.clone()),
            Block::Slanted { row, columns } => (vec![*row], columns.to_vec()),
            Block::Free { column } => (Vec::new(), vec![*column]),
        };
        for row in rows {
            self.unlist(row);
            self.left.remove(&row);
            self.changed.remove(&(self.unknown[row].len(), row));
        }
        for column in columns {
            self.known[column] = true;
            // The list is not needed any more: this velocity is known.
            for r in std::mem::take(&mut self.holders[column]) {
                if !self.left.contains(&r) {
                    continue;
                }
                self.unlist(r);
                self.changed.remove(&(self.unknown[r].len(), r));
                self.unknown[r].remove(&column);
                self.changed.insert((self.unknown[r].len(), r));
                self.unpaired.insert(r);
                self.list(r);
            }
        }
        self.blocks.push(block);
    }
}

/// Velocities of a block.
fn padded(columns: impl Iterator<Item = usize>) -> Columns {
    let mut list = [NONE; LARGEST_BLOCK];
    for (place, column) in list.iter_mut().zip(columns) {
        *place = column;
    }
    list
}

/// The same without what stands behind them.
fn given(columns: &Columns) -> impl Iterator<Item = usize> {
    columns.iter().copied().filter(|&column| column != NONE)
}

/// These velocities, unless they are too many for a block.
fn columns_of(unknown: &BTreeSet<usize>) -> Option<Columns> {
    (unknown.len() <= LARGEST_BLOCK).then(|| padded(unknown.iter().copied()))
}
