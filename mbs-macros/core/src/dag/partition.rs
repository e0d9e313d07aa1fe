//! Which velocities follow from which rows: the order in which A v = r is solved for dependent velocities.
//!
//! A mechanism of few degrees of freedom has nearly as many rows as velocities. Rows are put in an order in which each
//! block of them has as many velocities that are not known yet, one to three: solved by Cramer's rule. What no block
//! determines is independent (coordinate partitioning: Wehage and Haug, J. Mech. Des. 104, 1982, 247–255). A row with two
//! unknown velocities has a third way: along it and at right angles to it, which no pose makes singular.

use std::collections::BTreeSet;

/// More degrees of freedom have a matrix of their own that costs more than the elimination of the rows.
const MOST_FREEDOMS: usize = 4;
/// The largest block: determinants of larger ones are sums of many products.
const LARGEST_BLOCK: usize = 3;

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
        blocks: Vec::new(),
        known: vec![false; size],
    };
    for (r, row) in rows.iter().enumerate() {
        for entry in row {
            search.holders[entry.column].push(r);
        }
    }
    while !search.left.is_empty() {
        let block = (search.square())
            .or_else(|| search.square_of_pair())
            .or_else(|| search.beginning())?;
        search.take(block);
    }
    let free: Vec<usize> = (0..size).filter(|&j| !search.known[j]).collect();
    for column in free {
        search.take(Block::Free { column });
    }
    let independent = |block: &&Block| !matches!(block, Block::Square { .. });
    (search.blocks.iter().filter(independent).count() == freedoms).then_some(search.blocks)
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
    blocks: Vec<Block>,
    known: Vec<bool>,
}

impl Search<'_> {
    /// A block with the velocities of one row.
    fn square(&mut self) -> Option<Block> {
        while let Some((count, row)) = self.changed.pop_first() {
            if count <= LARGEST_BLOCK
                && let Some(block) = self.block_in(&self.unknown[row])
            {
                return Some(block);
            }
        }
        None
    }

    /// The smallest block with the velocities of two rows.
    fn square_of_pair(&self) -> Option<Block> {
        let few = self.left.iter().copied();
        let few = few.filter(|&r| self.unknown[r].len() <= LARGEST_BLOCK);
        let pairs = few.flat_map(|r| {
            let others = self.unknown[r].iter().flat_map(|&j| &self.holders[j]);
            others.map(move |&s| (r, s))
        });
        let unions = pairs.filter(|&(r, s)| r < s && self.left.contains(&s));
        let blocks = unions.filter_map(|(r, s)| {
            let both: BTreeSet<usize> = self.unknown[r].union(&self.unknown[s]).copied().collect();
            (both.len() <= LARGEST_BLOCK).then(|| self.block_in(&both))?
        });
        blocks.min_by_key(|block| match block {
            Block::Square { rows, .. } => rows.len(),
            Block::Slanted { .. } | Block::Free { .. } => 1,
        })
    }

    /// The rows that have no other unknown velocities than these, if there are as many.
    fn block_in(&self, columns: &BTreeSet<usize>) -> Option<Block> {
        let candidates: BTreeSet<usize> = columns
            .iter()
            .flat_map(|&j| &self.holders[j])
            .copied()
            .collect();
        let inside = |r: &usize| self.left.contains(r) && self.unknown[*r].is_subset(columns);
        let rows: Vec<usize> = candidates.into_iter().filter(inside).collect();
        (rows.len() == columns.len()).then(|| Block::Square {
            rows,
            columns: columns.iter().copied().collect(),
        })
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
            self.left.remove(&row);
            self.changed.remove(&(self.unknown[row].len(), row));
        }
        for column in columns {
            self.known[column] = true;
            for &r in &self.holders[column] {
                self.changed.remove(&(self.unknown[r].len(), r));
                self.unknown[r].remove(&column);
                if self.left.contains(&r) {
                    self.changed.insert((self.unknown[r].len(), r));
                }
            }
        }
        self.blocks.push(block);
    }
}
