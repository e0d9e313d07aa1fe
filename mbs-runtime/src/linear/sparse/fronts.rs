//! The order in which the unknowns of a symmetric pattern are eliminated, in groups, and where the entries of the factors
//! stand.

use super::Columns;
use faer::Side;
use faer::sparse::SymbolicSparseColMat;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholeskyRaw, SymmetricOrdering, factorize_symbolic_cholesky,
};

/// Unknowns that are eliminated together, because their columns have nearly the same entries.
#[derive(Debug, Clone)]
pub(super) struct Front {
    /// The first of them, by turn, and their number k.
    pub(super) first: usize,
    pub(super) count: usize,
    /// The m later unknowns that they are coupled with, in order.
    pub(super) later: Vec<usize>,
    /// Where \[L₁₁\U₁₁; L₂₁\] begins among the factors, k + m by k; behind it U₁₂ᵀ, m by k; both column by column.
    pub(super) start: usize,
    /// How many of `later` the parent eliminates: the front of the first of them.
    pub(super) direct: usize,
    /// The places of `later` in the front of the parent: those of its own unknowns, then those of its `later`.
    pub(super) in_parent: Vec<usize>,
    pub(super) children: Vec<usize>,
}

impl Front {
    /// k + m.
    pub(super) fn height(&self) -> usize {
        self.count + self.later.len()
    }

    /// The number of entries among the factors.
    pub(super) fn entries(&self) -> usize {
        self.count * (self.height() + self.later.len())
    }

    /// m²: what is left for the parent.
    pub(super) fn left(&self) -> usize {
        self.later.len().pow(2)
    }

    /// The place of an unknown, by turn.
    fn place(&self, turn: usize) -> usize {
        if turn < self.first + self.count {
            return turn - self.first;
        }
        let later = self.later.binary_search(&turn);
        self.count + later.expect("an unknown of the front")
    }
}

/// All fronts of a pattern.
#[derive(Debug, Clone)]
pub(super) struct Fronts {
    /// Which unknown is eliminated at each turn.
    pub(super) order: Vec<usize>,
    /// By their first unknowns: each before its parent.
    pub(super) fronts: Vec<Front>,
    /// The same fronts, each right behind its last child and what precedes that.
    pub(super) sequence: Vec<usize>,
    /// For each entry of the pattern its place among the factors.
    pub(super) places: Vec<usize>,
    /// The number of entries of the factors.
    pub(super) entries: usize,
}

impl Fronts {
    /// Analyses a pattern with its transpose, in an order of nearly least degree. `None` if there is no memory.
    pub(super) fn new(columns: &Columns) -> Option<Fronts> {
        let size = columns.starts.len() - 1;
        let (order, mut fronts) = groups(&columns.with_transpose(), size)?;
        let mut turns = vec![0; size];
        (order.iter().enumerate()).for_each(|(turn, &unknown)| turns[unknown] = turn);
        let mut owners = vec![0; size];
        let mut entries = 0;
        for (at, front) in fronts.iter_mut().enumerate() {
            owners[front.first..front.first + front.count].fill(at);
            front.start = entries;
            entries += front.entries();
        }
        let mut roots = Vec::new();
        for child in 0..fronts.len() {
            let Some(&next) = fronts[child].later.first() else {
                roots.push(child);
                continue;
            };
            let parent = &fronts[owners[next]];
            let later = fronts[child].later.iter();
            let in_parent: Vec<usize> = later.map(|&turn| parent.place(turn)).collect();
            let direct = in_parent.partition_point(|&place| place < parent.count);
            (fronts[child].direct, fronts[child].in_parent) = (direct, in_parent);
            fronts[owners[next]].children.push(child);
        }
        let place = |(row, column): (usize, usize)| {
            let (i, j) = (turns[row], turns[column]);
            let front = &fronts[owners[i.min(j)]];
            let (lower, m) = (front.count * front.height(), front.later.len());
            front.start
                + match j < front.first + front.count {
                    true => front.place(i) + front.height() * (j - front.first),
                    false => lower + front.place(j) - front.count + m * (i - front.first),
                }
        };
        Some(Fronts {
            places: columns.places().map(place).collect(),
            sequence: sequence(&fronts, roots),
            order,
            fronts,
            entries,
        })
    }
}

/// The fronts below these roots, children before their parents.
fn sequence(fronts: &[Front], mut waiting: Vec<usize>) -> Vec<usize> {
    let mut sequence = Vec::with_capacity(fronts.len());
    while let Some(next) = waiting.pop() {
        sequence.push(next);
        waiting.extend(&fronts[next].children);
    }
    sequence.reverse();
    sequence
}

/// The order, and the groups in it, of a symmetric pattern.
fn groups(columns: &Columns, size: usize) -> Option<(Vec<usize>, Vec<Front>)> {
    let (starts, rows) = (columns.starts.clone(), columns.rows.clone());
    let pattern = SymbolicSparseColMat::new_checked(size, size, starts, None, rows);
    let parameters = CholeskySymbolicParams {
        supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
        ..CholeskySymbolicParams::default()
    };
    let order = SymmetricOrdering::Amd;
    let symbolic = factorize_symbolic_cholesky(pattern.as_ref(), Side::Lower, order, parameters);
    let symbolic = symbolic.ok()?;
    let SymbolicCholeskyRaw::Supernodal(groups) = symbolic.raw() else {
        return None;
    };
    let order = symbolic.perm()?.arrays().0.to_vec();
    let fronts = (0..groups.n_supernodes()).map(|at| {
        let first = groups.supernode_begin()[at];
        let mut later = groups.supernode(at).pattern().to_vec();
        later.sort_unstable();
        Front {
            first,
            count: groups.supernode_end()[at] - first,
            later,
            start: 0,
            direct: 0,
            in_parent: Vec::new(),
            children: Vec::new(),
        }
    });
    Some((order, fronts.collect()))
}
