//! L U of a sparse matrix with a symmetric pattern and its pivots on the diagonal: the multifrontal method.
//!
//! ```text
//! [ F₁₁  F₁₂ ]   [ L₁₁    ] [ U₁₁  U₁₂ ]
//! [ F₂₁  F₂₂ ] = [ L₂₁  1 ] [       S  ]
//! ```
//!
//! The unknowns of a front are eliminated together; S is added to the front of its parent. Rows are not exchanged, so that
//! only what is coupled fills up: in a plane grid a fifth of what exchanges of rows have to be prepared for.

use super::Columns;
use super::fronts::{Front, Fronts};
use super::panels::{add_products, subtract_dots};
use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef, Par};
use pulp::{Arch, Simd, WithSimd};

/// A pivot below this fraction of an entry of its column is refused.
const SMALL: f64 = 1e-8;

/// The factors.
#[derive(Clone)]
pub(super) struct FrontalLu {
    fronts: Fronts,
    factors: Vec<f64>,
    /// S of the fronts whose parents have not been eliminated: those of the children of the next parent are the last ones.
    stack: Vec<f64>,
    /// The unknowns by turn.
    turned: Vec<f64>,
    /// The later unknowns of one front.
    later: Vec<f64>,
}

impl FrontalLu {
    /// For a pattern; `None` if there is no memory.
    pub(super) fn new(columns: &Columns) -> Option<FrontalLu> {
        let fronts = Fronts::new(columns)?;
        let (mut height, mut most) = (0, 0);
        for &at in &fronts.sequence {
            let front = &fronts.fronts[at];
            height += front.left();
            most = most.max(height);
            let children = front.children.iter();
            height -= children.map(|&at| fronts.fronts[at].left()).sum::<usize>();
        }
        let widest = fronts.fronts.iter().map(|front| front.later.len()).max();
        Some(FrontalLu {
            factors: vec![0.0; fronts.entries],
            stack: vec![0.0; most],
            turned: vec![0.0; fronts.order.len()],
            later: vec![0.0; widest.unwrap_or(0)],
            fronts,
        })
    }

    /// Factors the matrix of these entries, in the order of the pattern; false if a pivot is small, or not finite.
    #[must_use]
    pub(super) fn factor(&mut self, entries: &[f64]) -> bool {
        Arch::new().dispatch(Factoring(self, entries))
    }

    /// x ← K⁻¹x.
    pub(super) fn solve(&mut self, x: &mut [f64]) {
        Arch::new().dispatch(Solving(self, x));
    }
}

/// A factorisation, compiled for each width of vectors that processors have.
struct Factoring<'a>(&'a mut FrontalLu, &'a [f64]);

impl WithSimd for Factoring<'_> {
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> bool {
        let FrontalLu {
            fronts,
            factors,
            stack,
            turned,
            ..
        } = self.0;
        factors.fill(0.0);
        for (&place, &entry) in fronts.places.iter().zip(self.1) {
            factors[place] = entry;
        }
        let mut height = 0;
        for &at in &fronts.sequence {
            let front = &fronts.fronts[at];
            let panel = &mut factors[front.start..][..front.entries()];
            let (lower, upper) = panel.split_at_mut(front.count * front.height());
            let (below, left) = stack.split_at_mut(height);
            let left = &mut left[..front.left()];
            left.fill(0.0);
            let mut end = height;
            for &child in front.children.iter().rev() {
                let child = &fronts.fronts[child];
                end -= child.left();
                let of_child = &below[end..][..child.left()];
                add_child(child, of_child, front, (lower, upper, left));
            }
            if !eliminate(front, lower, upper, left, turned) {
                return false;
            }
            stack.copy_within(height..height + front.left(), end);
            height = end + front.left();
        }
        true
    }
}

/// Adds what a child has left of its later unknowns to the front of its parent.
#[inline(always)]
fn add_child(
    child: &Front,
    left: &[f64],
    parent: &Front,
    (lower, upper, into): (&mut [f64], &mut [f64], &mut [f64]),
) {
    let (k, height, m) = (parent.count, parent.height(), parent.later.len());
    let (own, rest) = child.in_parent.split_at(child.direct);
    for (column, &j) in left.chunks_exact(child.later.len()).zip(&child.in_parent) {
        if j < k {
            let target = &mut lower[j * height..][..height];
            for (&value, &i) in column.iter().zip(&child.in_parent) {
                target[i] += value;
            }
            continue;
        }
        let (above, beside) = column.split_at(child.direct);
        for (&value, &i) in above.iter().zip(own) {
            upper[j - k + m * i] += value;
        }
        let target = &mut into[(j - k) * m..][..m];
        for (&value, &i) in beside.iter().zip(rest) {
            target[i - k] += value;
        }
    }
}

/// Eliminates the unknowns of a front; false if a pivot is small. The diagonal of U₁₁ is inverted. `work` has room for k.
#[inline(always)]
fn eliminate(
    front: &Front,
    lower: &mut [f64],
    upper: &mut [f64],
    left: &mut [f64],
    work: &mut [f64],
) -> bool {
    let (k, height, m) = (front.count, front.height(), front.later.len());
    for j in 0..k {
        let (done, rest) = lower.split_at_mut(j * height);
        let (own, below) = rest[..height].split_at_mut(k);
        for (p, column) in done.chunks_exact(height).enumerate() {
            let u = own[p];
            for (x, l) in own[p + 1..].iter_mut().zip(&column[p + 1..k]) {
                *x -= l * u;
            }
            work[p] = -u;
        }
        if j > 0 {
            add_products(below, &done[k..], height, &work[..j]);
        }
        let beside = own[j + 1..].iter().chain(&*below);
        let most = beside.fold(0.0, |most: f64, x| most.max(x.abs()));
        if !(own[j].abs() > SMALL * most && own[j].is_finite()) {
            return false;
        }
        let inverse = 1.0 / own[j];
        own[j] = inverse;
        let beside = own[j + 1..].iter_mut().chain(below);
        beside.for_each(|l| *l *= inverse);
    }
    if m == 0 {
        return true;
    }
    for i in 1..k {
        let (done, rest) = upper.split_at_mut(i * m);
        for p in 0..i {
            work[p] = -lower[p * height + i];
        }
        add_products(&mut rest[..m], done, m, &work[..i]);
    }
    let below = MatRef::from_column_major_slice_with_stride(&lower[k..], m, k, height);
    let beside = MatRef::from_column_major_slice(upper, m, k).transpose();
    let left = MatMut::from_column_major_slice_mut(left, m, m);
    matmul(left, Accum::Add, below, beside, -1.0, Par::Seq);
    true
}

/// A solution, compiled for each width of vectors that processors have.
struct Solving<'a>(&'a mut FrontalLu, &'a mut [f64]);

impl WithSimd for Solving<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Solving(lu, x) = self;
        let FrontalLu {
            fronts,
            factors,
            turned,
            later,
            ..
        } = lu;
        for (turned, &unknown) in turned.iter_mut().zip(&fronts.order) {
            *turned = x[unknown];
        }
        for front in &fronts.fronts {
            let (k, height) = (front.count, front.height());
            let lower = &factors[front.start..][..k * height];
            let own = &mut turned[front.first..][..k];
            for (j, column) in lower.chunks_exact(height).enumerate() {
                let solved = own[j];
                for (x, l) in own[j + 1..].iter_mut().zip(&column[j + 1..k]) {
                    *x -= l * solved;
                }
            }
            let later = &mut later[..front.later.len()];
            later.fill(0.0);
            add_products(later, &lower[k..], height, own);
            for (&turn, change) in front.later.iter().zip(&*later) {
                turned[turn] -= change;
            }
        }
        for front in fronts.fronts.iter().rev() {
            let (k, height) = (front.count, front.height());
            let panel = &factors[front.start..][..front.entries()];
            let (lower, upper) = panel.split_at(k * height);
            let later = &mut later[..front.later.len()];
            for (x, &turn) in later.iter_mut().zip(&front.later) {
                *x = turned[turn];
            }
            let own = &mut turned[front.first..][..k];
            subtract_dots(own, upper, later);
            for j in (0..k).rev() {
                let column = &lower[j * height..][..j + 1];
                own[j] *= column[j];
                let solved = own[j];
                for (x, u) in own[..j].iter_mut().zip(column) {
                    *x -= u * solved;
                }
            }
        }
        for (turned, &unknown) in turned.iter().zip(&fronts.order) {
            x[unknown] = *turned;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Pattern;
    use super::FrontalLu;

    /// A grid of n × n nodes with three unknowns each, unsymmetric, with a dominant diagonal; its pattern has holes that
    /// its transpose fills.
    fn grid(n: usize) -> (Pattern, Vec<(usize, usize, f64)>) {
        let mut entries = Vec::new();
        let mut pattern = Pattern::new(3 * n * n);
        let nodes = (0..n * n).flat_map(|node| (0..n * n).map(move |other| (node, other)));
        for (node, other) in nodes {
            let apart = (node / n).abs_diff(other / n) + (node % n).abs_diff(other % n);
            for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
                let hole = apart == 1 && i == 2 && node > other;
                if apart < 2 && !hole {
                    let (row, column) = (3 * node + i, 3 * other + j);
                    let value = ((7 * row + 13 * column) as f64).sin();
                    let diagonal = if row == column { 9.0 } else { 0.0 };
                    pattern.insert(row, column);
                    entries.push((row, column, value + diagonal));
                }
            }
        }
        (pattern, entries)
    }

    #[test]
    fn grids_are_solved() {
        for n in [1, 2, 5, 12] {
            let (pattern, entries) = grid(n);
            let columns = pattern.finish();
            let mut values = vec![0.0; columns.rows.len()];
            (entries.iter()).for_each(|&(i, j, value)| values[columns.slot(i, j)] = value);
            let mut lu = FrontalLu::new(&columns).unwrap();
            let solution: Vec<f64> = (0..3 * n * n).map(|i| (i as f64).cos()).collect();
            // Twice: nothing is left of the first time.
            for _ in 0..2 {
                assert!(lu.factor(&values));
                let mut x = vec![0.0; solution.len()];
                (entries.iter()).for_each(|&(i, j, value)| x[i] += value * solution[j]);
                lu.solve(&mut x);
                for (x, wanted) in x.iter().zip(&solution) {
                    assert!((x - wanted).abs() < 1e-13, "{n}: {x} {wanted}");
                }
            }
        }
    }

    #[test]
    fn small_pivots_are_refused() {
        let mut pattern = Pattern::new(2);
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            pattern.insert(i, j);
        }
        let columns = pattern.finish();
        let mut lu = FrontalLu::new(&columns).unwrap();
        assert!(lu.factor(&[1e-7, 1.0, 1.0, 1e-7]));
        assert!(!lu.factor(&[1e-9, 1.0, 1.0, 1e-9]));
        assert!(!lu.factor(&[f64::NAN, 1.0, 1.0, 1.0]));
    }
}
