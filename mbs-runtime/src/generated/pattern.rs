//! Elimination by a table of its pattern: for large mechanisms whose columns repeat so little that code for each of them
//! would be too long.
//!
//! Column by column, from the left: a column is spread out, what the columns before it take from it is subtracted, and
//! it is collected. The arrays are those of [`Elimination`](crate::generated::Elimination), with room for one spread
//! column behind.

use super::DEPENDENT;

/// The pattern of a factor.
#[derive(Debug)]
pub struct Pattern {
    /// Where each column begins, with its pivot, and where the last one ends.
    pub starts: &'static [u32],
    /// The position of each slot; of a pivot, that of its column.
    pub positions: &'static [u32],
    /// Where the list of each position begins in `crossings`, and where the last one ends.
    pub lists: &'static [u32],
    /// Columns, and slots in them, that stand below a pivot at a position.
    pub crossings: &'static [[u32; 2]],
    /// 1 for the positions of rows of A.
    pub is_row: &'static [u8],
}

/// A column, from its pivot on, and the entry with which it crosses another one.
struct Crossing {
    slot: usize,
    pivot: usize,
    end: usize,
    is_row: bool,
}

impl Pattern {
    /// The number of positions.
    fn count(&self) -> usize {
        self.is_row.len()
    }

    fn is_row(&self, position: usize) -> bool {
        self.is_row[position] != 0
    }

    /// The slots of a column.
    fn column(&self, position: usize) -> core::ops::Range<usize> {
        self.starts[position] as usize..self.starts[position + 1] as usize
    }

    /// The columns that take something from this one.
    fn crossings(&self, position: usize) -> impl Iterator<Item = Crossing> + '_ {
        let list = self.lists[position] as usize..self.lists[position + 1] as usize;
        self.crossings[list].iter().map(|&[column, slot]| {
            let slots = self.column(column as usize);
            Crossing {
                slot: slot as usize,
                pivot: slots.start,
                end: slots.end,
                is_row: self.is_row(column as usize),
            }
        })
    }

    fn spread(&self, slots: core::ops::Range<usize>, from: &[f64], wide: &mut [f64]) {
        for (value, &position) in from[slots.clone()].iter().zip(&self.positions[slots]) {
            wide[position as usize] = *value;
        }
    }

    fn collect(&self, slots: core::ops::Range<usize>, wide: &[f64], into: &mut [f64]) {
        for (value, &position) in into[slots.clone()].iter_mut().zip(&self.positions[slots]) {
            *value = wide[position as usize];
        }
    }

    /// What the unknowns behind one take from it. The next one is the last to be known.
    fn behind(&self, position: usize, from: &[f64], x: &[f64]) -> f64 {
        let column = self.column(position);
        let below = column.start + 1..column.end;
        let terms = from[below.clone()].iter().zip(&self.positions[below]);
        let products = terms.rev().map(|(value, &at)| value * x[at as usize]);
        products.sum()
    }

    /// wide ← wide − factor · slots.
    fn subtract(
        &self,
        slots: core::ops::Range<usize>,
        from: &[f64],
        factor: f64,
        wide: &mut [f64],
    ) {
        for (value, &position) in from[slots.clone()].iter().zip(&self.positions[slots]) {
            wide[position as usize] -= factor * value;
        }
    }
}

/// [`Elimination::factor`](crate::generated::Elimination::factor), and `factor_mass`.
pub fn factor(pattern: &Pattern, f: &mut [f64], c: &mut [f64]) -> f64 {
    let Some((f, wide)) = f.split_at_mut_checked(pattern.positions.len()) else {
        return f64::INFINITY;
    };
    if wide.len() < pattern.count() || c.len() < pattern.count() {
        return f64::INFINITY;
    }
    c.fill(0.0);
    let mut most = 0.0;
    for at in 0..pattern.count() {
        let column = pattern.column(at);
        pattern.spread(column.clone(), f, wide);
        for crossing in pattern.crossings(at) {
            let entry = f[crossing.slot];
            let l = entry * f[crossing.pivot];
            if pattern.is_row(at) && !crossing.is_row {
                c[at] += l * entry;
            }
            pattern.subtract(crossing.slot..crossing.end, f, l, wide);
            // No later column needs the entry as it was.
            f[crossing.slot] = l;
        }
        pattern.collect(column.clone(), wide, f);
        let pivot = f[column.start];
        let inverse = match pattern.is_row(at) {
            true if -pivot > DEPENDENT * c[at] => 1.0 / pivot,
            true => {
                most = f64::INFINITY;
                0.0
            }
            false => 1.0 / pivot,
        };
        if pattern.is_row(at) && -c[at] * inverse > most {
            most = -c[at] * inverse;
        }
        f[column.start] = inverse;
    }
    most
}

/// [`Kicks::factor_pair`](crate::generated::Kicks::factor_pair).
pub fn factor_pair(pattern: &Pattern, f: &mut [f64], g: &mut [f64], c: &[f64]) -> f64 {
    let slots = pattern.positions.len();
    let (Some((f, low)), Some((g, high))) =
        (f.split_at_mut_checked(slots), g.split_at_mut_checked(slots))
    else {
        return f64::INFINITY;
    };
    if low.len().min(high.len()).min(c.len()) < pattern.count() {
        return f64::INFINITY;
    }
    let mut most = 0.0;
    for at in 0..pattern.count() {
        let column = pattern.column(at);
        pattern.spread(column.clone(), f, low);
        pattern.spread(column.clone(), g, high);
        for crossing in pattern.crossings(at) {
            let (l, u) = (f[crossing.slot], g[crossing.slot]);
            pattern.subtract(crossing.slot..crossing.end, f, u, low);
            pattern.subtract(crossing.slot..crossing.end, g, l, high);
        }
        pattern.collect(column.clone(), low, f);
        pattern.collect(column.clone(), high, g);
        let pivot = f[column.start];
        let inverse = match pattern.is_row(at) {
            true if pivot.abs() > DEPENDENT * c[at] => 1.0 / pivot,
            true => {
                most = f64::INFINITY;
                0.0
            }
            false => 1.0 / pivot,
        };
        if pattern.is_row(at) && c[at] * inverse.abs() > most {
            most = c[at] * inverse.abs();
        }
        f[column.start] = inverse;
        for entry in &mut f[column.start + 1..column.end] {
            *entry *= inverse;
        }
    }
    most
}

/// x ← K⁻¹x with the factor of [`factor`].
pub fn solve(pattern: &Pattern, f: &[f64], x: &mut [f64]) {
    if f.len() < pattern.positions.len() || x.len() < pattern.count() {
        return;
    }
    for at in 0..pattern.count() {
        let column = pattern.column(at);
        pattern.subtract(column.start + 1..column.end, f, x[at], x);
    }
    for at in (0..pattern.count()).rev() {
        x[at] = x[at] * f[pattern.column(at).start] - pattern.behind(at, f, x);
    }
}

/// The same with the factors of [`factor_pair`].
pub fn solve_pair(pattern: &Pattern, f: &[f64], g: &[f64], x: &mut [f64]) {
    let slots = pattern.positions.len();
    if f.len() < slots || g.len() < slots || x.len() < pattern.count() {
        return;
    }
    for at in 0..pattern.count() {
        let column = pattern.column(at);
        pattern.subtract(column.start + 1..column.end, f, x[at], x);
    }
    for at in (0..pattern.count()).rev() {
        x[at] = (x[at] - pattern.behind(at, g, x)) * f[pattern.column(at).start];
    }
}
