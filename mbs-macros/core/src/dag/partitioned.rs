//! Accelerations of mechanisms with few degrees of freedom, by independent velocities.
//!
//! ```text
//! v̇ = N s − u        A u = γ + correction,   A N = 0
//! Nᵀ M N s = Nᵀ (F − ṗ|_v) + (M N)ᵀ u
//! ```
//!
//! Each block of rows (`partition.rs`) gives some entries of u and of the columns of N. There are no multipliers, and no
//! zeros; M need not be factored. Where a block is singular though the rows are independent (a dead point) another method
//! has to be used: `weakness` of a block is about the reciprocal of the square of its determinant, where that of the declared
//! guess is usual.

use super::accelerations::Demand;
use super::elimination::{Factor, Rank, Sparse, Upper};
use super::kernels::{Rows, rows};
use super::lower::{Hoisted, Lowering};
use super::partition::{Block, Entry, partition};
use super::{Function, Operand, Operation, Place};
use crate::derivatives::Derived;
use crate::symbolic::{Expr, Graph, Substitution, Symbol};
use std::collections::BTreeMap;

/// More rows make a function that is too long to be written as it is.
const MOST_ROWS: usize = 4000;
/// Squared lengths below this fraction of the largest one are round-off.
const VANISHES: f64 = 1e-24;

/// The function; `None` where blocks are large, degrees of freedom many, or the code would be long.
pub(super) fn partitioned_accelerations(
    graph: &mut Graph,
    hoisted: &mut Hoisted,
    derived: &Derived,
    demand: &mut Option<Demand>,
) -> Option<Function> {
    let system = &derived.system;
    let is_usable = derived.redundant.is_empty()
        && (1..=MOST_ROWS).contains(&system.rows.len())
        && system.layout.rotations.is_empty();
    if !is_usable {
        return None;
    }
    let rows = rows(derived);
    let entry = |&(column, value): &(usize, Expr)| Entry {
        column,
        is_number: graph.as_constant(value).is_some(),
    };
    let pattern: Vec<Vec<Entry>> = (rows.iter())
        .map(|row| row.iter().map(entry).collect())
        .collect();
    let velocities = system.layout.velocities.iter();
    let units: Vec<&str> = velocities.map(|velocity| velocity.unit.as_str()).collect();
    let blocks = partition(&pattern, &units)?;
    let scales = Scales::new(graph, derived, &rows)?;
    let demand: &Demand = demand.get_or_insert_with(|| Demand::new(graph, derived));
    let mut solution = Solution {
        code: Lowering::new(graph, hoisted),
        rows: &rows,
        particular: Sparse::new(),
        directions: Vec::new(),
    };
    for block in &blocks {
        solution.solve(block, demand, &scales);
    }
    let Solution {
        mut code,
        particular,
        directions,
        ..
    } = solution;
    let accelerations = combine(&mut code, derived, demand, particular, &directions);
    for (&i, &value) in &accelerations {
        code.write("acceleration", Place::Element(i), value);
    }
    Some(code.finish("partitioned_accelerations"))
}

/// Squared lengths of the rows and entries of M at the declared guess.
struct Scales {
    lengths: Vec<Expr>,
    mass: Vec<Expr>,
}

impl Scales {
    /// `None` where M has no diagonal entry, and where a row vanishes at the guess, which is then no usual pose.
    fn new(graph: &mut Graph, derived: &Derived, rows: &Rows) -> Option<Scales> {
        let system = &derived.system;
        let mut at_guess = Substitution::nameless();
        for (i, &slot) in system.layout.slots.iter().enumerate() {
            let guess = system.layout.coordinates[slot].guess;
            at_guess.insert(Symbol::Coordinate(i as u32), guess);
        }
        let mut mass = Vec::new();
        for j in 0..system.size {
            let entry = *system.mass.get(&(j, j))?;
            mass.push(graph.substitute(entry, &mut at_guess));
        }
        let mut lengths = Vec::new();
        for row in rows {
            let mut terms = Vec::new();
            for &(j, entry) in row {
                let entry = graph.substitute(entry, &mut at_guess);
                let square = graph.square(entry);
                terms.push(graph.div(square, mass[j]));
            }
            lengths.push(graph.sum(terms));
        }
        let numbers = lengths.iter().filter_map(|&x| graph.as_constant(x));
        let longest = numbers.clone().fold(0.0, f64::max);
        if numbers.into_iter().any(|x| x <= VANISHES * longest) {
            return None;
        }
        Some(Scales { lengths, mass })
    }

    /// The determinant of a block of this usual size, squared.
    fn of(&self, graph: &mut Graph, rows: &[usize], columns: &[usize]) -> Expr {
        let rows = rows.iter().map(|&r| (self.lengths[r], 1));
        let columns = columns.iter().map(|&j| (self.mass[j], 1));
        let factors: Vec<(Expr, i32)> = rows.chain(columns).collect();
        graph.product(&factors)
    }
}

struct Solution<'a> {
    code: Lowering<'a>,
    rows: &'a Rows,
    /// u.
    particular: Sparse,
    /// The columns of N.
    directions: Vec<Sparse>,
}

impl Solution<'_> {
    fn solve(&mut self, block: &Block, demand: &Demand, scales: &Scales) {
        match block {
            Block::Free { column } => {
                self.directions
                    .push([(*column, Operand::number(1.0))].into());
            }
            Block::Slanted { row, columns } => {
                let missing = self.missing(&[*row], demand);
                let [a, b] = columns.map(|j| self.entry(*row, j));
                let [square_a, square_b] = [a, b].map(|x| self.code.times(x, x));
                let length = self.code.plus(square_a, square_b);
                let inverse = self.inverse(length);
                self.weigh(inverse, &[*row], &columns[..1], scales);
                for (part, [missing]) in missing.into_iter().enumerate() {
                    let Some(missing) = missing else { continue };
                    let scaled = self.code.times(inverse, missing);
                    let values = [a, b].map(|x| self.code.times(x, scaled));
                    self.keep(part, columns, &values);
                }
                let minus_b = self.code.negative(b);
                self.directions
                    .push([(columns[0], minus_b), (columns[1], a)].into());
            }
            Block::Square { rows, columns } => {
                let determinant = Matrix {
                    entries: rows
                        .iter()
                        .map(|&r| columns.iter().map(|&j| self.entry(r, j)).collect())
                        .collect(),
                };
                match rows.len() {
                    1 => self.by_cramer::<1>(rows, columns, &determinant, demand, scales),
                    2 => self.by_cramer::<2>(rows, columns, &determinant, demand, scales),
                    _ => self.by_cramer::<3>(rows, columns, &determinant, demand, scales),
                }
            }
        }
    }

    fn by_cramer<const K: usize>(
        &mut self,
        rows: &[usize],
        columns: &[usize],
        matrix: &Matrix,
        demand: &Demand,
        scales: &Scales,
    ) {
        let zero = Operand::number(0.0);
        let rows_of: [usize; K] = std::array::from_fn(|i| rows[i]);
        let missing = self.missing(&rows_of, demand);
        // The adjugate, its columns by rows.
        let adjugate: [[Operand; K]; K] =
            std::array::from_fn(|i| std::array::from_fn(|j| matrix.cofactor(&mut self.code, j, i)));
        let mut determinant = zero;
        for (entry, cofactors) in matrix.entries[0].iter().zip(&adjugate) {
            let product = self.code.times(*entry, cofactors[0]);
            determinant = self.code.plus(determinant, product);
        }
        let name = rows[0];
        self.code
            .name(determinant, || format!("determinant_{name}"));
        let inverse = self.inverse(determinant);
        let square = self.code.times(inverse, inverse);
        self.weigh(square, rows, columns, scales);
        for (part, missing) in missing.into_iter().enumerate() {
            if missing.iter().all(Option::is_none) {
                continue;
            }
            let scaled = missing.map(|x| x.map(|x| self.code.times(inverse, x)));
            let mut values = [zero; K];
            for (value, cofactors) in values.iter_mut().zip(&adjugate) {
                for (&cofactor, scaled) in cofactors.iter().zip(&scaled) {
                    if let &Some(scaled) = scaled {
                        let product = self.code.times(cofactor, scaled);
                        *value = self.code.plus(*value, product);
                    }
                }
            }
            self.keep(part, columns, &values);
        }
    }

    /// What known velocities leave of the rows: for u, then for each direction; `None` where it is zero.
    fn missing<const K: usize>(
        &mut self,
        rows: &[usize; K],
        demand: &Demand,
    ) -> Vec<[Option<Operand>; K]> {
        let mut entries = Vec::new();
        let whole = rows.map(|r| {
            let row = self.row(r);
            let wanted = self.code.operand(demand.rows[r]);
            let wanted = self.code.negative(wanted);
            let met = self.code.dot(&row, &self.particular);
            entries.push(row);
            Some(self.code.less(wanted, met.unwrap_or(Operand::number(0.0))))
        });
        let mut list = vec![whole];
        for k in 0..self.directions.len() {
            list.push(std::array::from_fn(|i| {
                let met = self.code.dot(&entries[i], &self.directions[k])?;
                Some(self.code.negative(met))
            }));
        }
        list
    }

    /// Entries of u (part 0) or of a direction.
    fn keep(&mut self, part: usize, columns: &[usize], values: &[Operand]) {
        let vector = match part {
            0 => &mut self.particular,
            _ => &mut self.directions[part - 1],
        };
        for (&j, &value) in columns.iter().zip(values) {
            if value != Operand::number(0.0) {
                vector.insert(j, value);
            }
        }
    }

    /// Writes the reciprocal of a squared determinant relative to its usual size.
    fn weigh(&mut self, square: Operand, rows: &[usize], columns: &[usize], scales: &Scales) {
        // A number is the same in every pose.
        if matches!(square, Operand::Number(_)) {
            return;
        }
        let scale = scales.of(self.code.graph(), rows, columns);
        let scale = self.code.operand(scale);
        let weakness = self.code.times(scale, square);
        (self.code).write("weakness", Place::Element(rows[0]), weakness);
    }

    fn row(&mut self, r: usize) -> Sparse {
        let entries = self.rows[r].iter();
        let entries: Vec<(usize, Operand)> = entries
            .map(|&(j, entry)| (j, self.code.operand(entry)))
            .collect();
        entries.into_iter().collect()
    }

    fn entry(&mut self, r: usize, j: usize) -> Operand {
        let found = self.rows[r].iter().find(|&&(column, _)| column == j);
        match found {
            Some(&(_, entry)) => self.code.operand(entry),
            None => Operand::number(0.0),
        }
    }

    fn inverse(&mut self, x: Operand) -> Operand {
        match x {
            Operand::Number(number) => Operand::number(1.0 / number.value()),
            _ => self.code.push(Operation::Divide(Operand::number(1.0), x)),
        }
    }
}

/// A block of A.
struct Matrix {
    entries: Vec<Vec<Operand>>,
}

impl Matrix {
    /// The determinant without this row and column, with its sign.
    fn cofactor(&self, code: &mut Lowering, row: usize, column: usize) -> Operand {
        let others = |k: usize| (0..self.entries.len()).filter(move |&i| i != k);
        let (rows, columns): (Vec<usize>, Vec<usize>) =
            (others(row).collect(), others(column).collect());
        let at = |i: usize, j: usize| self.entries[rows[i]][columns[j]];
        let (even, odd) = match rows.len() {
            0 => (Operand::number(1.0), Operand::number(0.0)),
            1 => (at(0, 0), Operand::number(0.0)),
            _ => (
                code.times(at(0, 0), at(1, 1)),
                code.times(at(0, 1), at(1, 0)),
            ),
        };
        match (row + column) % 2 {
            0 => code.less(even, odd),
            _ if even == Operand::number(0.0) => odd,
            _ if odd == Operand::number(0.0) => code.negative(even),
            _ => code.less(odd, even),
        }
    }
}

/// v̇ from u and N.
fn combine(
    code: &mut Lowering,
    derived: &Derived,
    demand: &Demand,
    particular: Sparse,
    directions: &[Sparse],
) -> Sparse {
    let mass: BTreeMap<(usize, usize), Operand> = (derived.system.mass.iter())
        .map(|(&place, &entry)| (place, code.operand(entry)))
        .collect();
    let forces: Sparse = (demand.forces.iter().enumerate())
        .map(|(i, &force)| (i, code.operand(force)))
        .collect();
    let mut inertia = Upper::new();
    let mut wanted = Sparse::new();
    for (k, direction) in directions.iter().enumerate() {
        let moved = times_mass(code, &mass, direction);
        for (l, other) in directions.iter().enumerate().take(k + 1) {
            if let Some(entry) = code.dot(&moved, other) {
                inertia.insert((l, k), entry);
            }
        }
        // M is symmetric.
        let applied = code.dot(direction, &forces);
        let inertial = code.dot(&moved, &particular);
        let [applied, inertial] = [applied, inertial].map(|x| x.unwrap_or(Operand::number(0.0)));
        wanted.insert(k, code.plus(applied, inertial));
    }
    let factor = Factor::new(code, directions.len(), inertia, Rank::Full, "inertia");
    factor.solve(code, &mut wanted);
    let mut total = Sparse::new();
    for (k, direction) in directions.iter().enumerate() {
        let Some(&s) = wanted.get(&k) else { continue };
        for (&j, &entry) in direction {
            let change = code.times(entry, s);
            let place = total.entry(j).or_insert(Operand::number(0.0));
            *place = code.plus(*place, change);
        }
    }
    for (&j, &entry) in &particular {
        let place = total.entry(j).or_insert(Operand::number(0.0));
        *place = code.less(*place, entry);
    }
    total
}

/// M x.
fn times_mass(code: &mut Lowering, mass: &BTreeMap<(usize, usize), Operand>, x: &Sparse) -> Sparse {
    let mut product = Sparse::new();
    for (&(i, j), &entry) in mass {
        let mut add = |row: usize, column: usize| {
            let Some(&value) = x.get(&column) else { return };
            let term = code.times(entry, value);
            let place = product.entry(row).or_insert(Operand::number(0.0));
            *place = code.plus(*place, term);
        };
        add(i, j);
        if i != j {
            add(j, i);
        }
    }
    product
}
