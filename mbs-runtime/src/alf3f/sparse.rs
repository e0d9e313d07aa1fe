//! K of a large mechanism at one instant, and its factor.

use crate::System;
use crate::generated::{Elimination, Kicks};
use crate::linear::sparse::SparseRows;
use crate::singular::{RankMargin, Thresholds, WEAK_PIVOT};
use nalgebra::SVector;

/// An array whose length is a constant of the generated code.
pub(crate) type Slots = Box<[f64]>;

/// K where A₀ is A₁.
#[derive(Clone)]
pub(crate) struct Bordered {
    /// M and A.
    pub(crate) entries: Slots,
    factor: Slots,
    /// a M⁻¹aᵀ of each row, by its position in the elimination.
    lengths: Slots,
    /// The largest ratio of these to the pivots.
    most: f64,
    pub(crate) thresholds: Thresholds,
}

/// K where A₀ and A₁ belong to different instants.
#[derive(Clone)]
pub(crate) struct Pair<const N: usize, const R: usize> {
    functions: &'static Kicks<N, R>,
    lower: Slots,
    upper: Slots,
}

/// M by itself.
#[derive(Clone)]
pub(crate) struct SparseMass<const N: usize, const R: usize> {
    functions: &'static Kicks<N, R>,
    factor: Slots,
}

/// The verdict on rows from their pivots.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Rows {
    Independent,
    /// Solutions lose digits that an iteration on the residual restores.
    Weak,
    /// The same, beside a singular pose.
    Beside,
    /// Rows are nearly dependent.
    Lost,
}

/// The diagonal entry of a row that gets no multiplier, with the sign of its pivot: nothing is taken from other rows.
const FREE: f64 = -1e100;

fn zeros(length: usize) -> Slots {
    vec![0.0; length].into_boxed_slice()
}

/// The verdict on pivots whose sizes relative to the lengths of their rows are given; zero for those left out, of which
/// there may be `redundant`.
fn judge(
    thresholds: Thresholds,
    most: f64,
    relative: impl Iterator<Item = f64>,
    redundant: Option<usize>,
) -> Rows {
    if most < 1.0 / WEAK_PIVOT {
        return Rows::Independent;
    }
    let (mut least, mut left_out) = (f64::INFINITY, 0);
    for pivot in relative {
        if pivot == 0.0 {
            left_out += 1;
        } else {
            least = least.min(pivot);
        }
    }
    if least <= thresholds.lost || redundant.is_some_and(|redundant| redundant != left_out) {
        Rows::Lost
    } else if least < WEAK_PIVOT {
        match least < thresholds.beside {
            true => Rows::Beside,
            false => Rows::Weak,
        }
    } else {
        Rows::Independent
    }
}

impl Bordered {
    /// K with M and no rows, not factored.
    pub(crate) fn new<const N: usize, const R: usize>(
        plan: &Elimination<N, R>,
        mass: &SparseRows,
        thresholds: Thresholds,
    ) -> Self {
        let entries = plan.matrix(mass);
        Bordered {
            factor: entries.clone(),
            entries,
            lengths: zeros(plan.unknowns),
            most: f64::INFINITY,
            thresholds,
        }
    }

    pub(crate) fn factor<const N: usize, const R: usize>(&mut self, plan: &Elimination<N, R>) {
        self.factor.copy_from_slice(&self.entries);
        self.most = (plan.factor)(&mut self.factor, &mut self.lengths);
    }

    /// a M⁻¹aᵀ of the row at this position of the elimination, where it was factored.
    pub(crate) fn length(&self, position: usize) -> f64 {
        self.lengths[position]
    }

    /// Pivots of the rows, relative to their lengths.
    fn relative<'a, const N: usize, const R: usize>(
        &'a self,
        plan: &'a Elimination<N, R>,
    ) -> impl Iterator<Item = f64> + 'a {
        relative(plan, &self.factor, &self.lengths)
    }

    /// The smallest relative pivot of the rows that are not left out, 1 at most.
    pub(crate) fn least_pivot<const N: usize, const R: usize>(
        &self,
        plan: &Elimination<N, R>,
    ) -> f64 {
        let pivots = self.relative(plan).filter(|&pivot| pivot > 0.0);
        pivots.fold(1.0, f64::min)
    }

    /// The number of rows that depend on others here.
    pub(crate) fn left_out<const N: usize, const R: usize>(
        &self,
        plan: &Elimination<N, R>,
    ) -> usize {
        self.relative(plan).filter(|&pivot| pivot == 0.0).count()
    }

    /// Frees the rows that depend on others here: from now on they get no multiplier, and do not count.
    pub(crate) fn free_dependent<const N: usize, const R: usize>(
        &mut self,
        plan: &Elimination<N, R>,
    ) {
        for &(_, slot) in plan.pivots {
            if self.factor[slot] == 0.0 {
                self.entries[slot] = FREE;
            }
        }
        self.factor(plan);
    }

    #[inline]
    pub(crate) fn rows<const N: usize, const R: usize>(&self, plan: &Elimination<N, R>) -> Rows {
        judge(self.thresholds, self.most, self.relative(plan), None)
    }

    /// The same where no row may be left out, but those that were freed.
    #[inline]
    pub(crate) fn all_rows<const N: usize, const R: usize>(
        &self,
        plan: &Elimination<N, R>,
    ) -> Rows {
        judge(self.thresholds, self.most, self.relative(plan), Some(0))
    }

    /// How independent the first `rows` rows are.
    #[inline]
    pub(crate) fn rank_margin<const N: usize, const R: usize>(
        &self,
        plan: &Elimination<N, R>,
        rows: usize,
    ) -> RankMargin {
        let mut rank_margin = RankMargin::of(1.0 / self.most.sqrt());
        if rows == R && self.most < 1.0 / self.thresholds.lost {
            return rank_margin;
        }
        let (mut small, mut least) = (f64::INFINITY, f64::INFINITY);
        for pivot in self.relative(plan).take(rows) {
            if pivot > 0.0 {
                least = least.min(pivot);
            } else {
                rank_margin.dependent += 1;
            }
            if pivot > self.thresholds.lost {
                small = small.min(pivot);
            } else {
                rank_margin.lost += 1;
            }
        }
        (rank_margin.sigma, rank_margin.least) = (small.sqrt(), least.sqrt());
        rank_margin.bound = self.thresholds.lost.sqrt();
        rank_margin
    }

    /// The combination of the rows, each of unit length, that is nearest to zero, by a step of inverse iteration from
    /// the row with the smallest pivot.
    pub(crate) fn combination<const N: usize, const R: usize>(
        &self,
        plan: &Elimination<N, R>,
        x: &mut [f64],
    ) -> SVector<f64, R> {
        let pivots = self.relative(plan).enumerate();
        let independent = pivots.filter(|&(_, pivot)| pivot > 0.0);
        let weakest = independent.min_by(|a, b| a.1.total_cmp(&b.1));
        let mut combination = SVector::zeros();
        if let Some((weakest, _)) = weakest {
            let mut rates = SVector::zeros();
            rates[weakest] = 1.0;
            self.solve(plan, &rates, x, (&mut SVector::zeros(), &mut combination));
        }
        let lengths = plan
            .pivots
            .iter()
            .map(|&(position, _)| self.lengths[position].sqrt());
        combination
            .iter_mut()
            .zip(lengths)
            .for_each(|(part, length)| *part *= length);
        combination
    }

    /// v and κ change so that A v changes by `rates`.
    #[inline]
    pub(crate) fn solve<const N: usize, const R: usize>(
        &self,
        plan: &Elimination<N, R>,
        rates: &SVector<f64, R>,
        x: &mut [f64],
        (v, kappa): (&mut SVector<f64, N>, &mut SVector<f64, R>),
    ) {
        (plan.solve)(&self.factor, rates, x, v, kappa);
    }

    /// F − ṗ|_v becomes v̇, and −γ becomes λ.
    pub(crate) fn accelerate<const N: usize, const R: usize>(
        &self,
        plan: &Elimination<N, R>,
        x: &mut [f64],
        (v, lambda): (&mut SVector<f64, N>, &mut SVector<f64, R>),
    ) {
        (plan.accelerate)(&self.factor, x, v, lambda);
    }
}

fn relative<'a, const N: usize, const R: usize>(
    plan: &'a Elimination<N, R>,
    factor: &'a [f64],
    lengths: &'a [f64],
) -> impl Iterator<Item = f64> + 'a {
    plan.pivots.iter().map(move |&(position, slot)| {
        let inverse = factor[slot].abs();
        if inverse == 0.0 {
            0.0
        } else {
            1.0 / (inverse * lengths[position])
        }
    })
}

impl<const N: usize, const R: usize> Pair<N, R> {
    pub(crate) fn new(plan: &Elimination<N, R>, functions: &'static Kicks<N, R>) -> Self {
        Pair {
            functions,
            lower: zeros(plan.slots),
            upper: zeros(plan.slots),
        }
    }

    /// Factors K with A₁ of `end` and A₀ of `start`, which is factored itself.
    pub(crate) fn factor(
        &mut self,
        plan: &Elimination<N, R>,
        start: &Bordered,
        end: &Bordered,
    ) -> Rows {
        self.lower.copy_from_slice(&end.entries);
        self.upper.copy_from_slice(&start.entries);
        let factor = self.functions.factor_pair;
        let most = factor(&mut self.lower, &mut self.upper, &start.lengths);
        let relative = relative(plan, &self.lower, &start.lengths);
        judge(start.thresholds, most, relative, Some(start.left_out(plan)))
    }

    #[inline]
    pub(crate) fn solve(
        &self,
        rates: &SVector<f64, R>,
        x: &mut [f64],
        (v, kappa): (&mut SVector<f64, N>, &mut SVector<f64, R>),
    ) {
        (self.functions.solve_pair)(&self.lower, &self.upper, rates, x, v, kappa);
    }
}

impl<const N: usize, const R: usize> SparseMass<N, R> {
    /// M factored.
    pub(crate) fn new(functions: &'static Kicks<N, R>, mass: &SparseRows) -> Self {
        let mut factor = zeros(functions.mass_slots);
        for &(i, j, slot) in functions.mass {
            factor[slot] = mass.get(i, j);
        }
        (functions.factor_mass)(&mut factor, &mut zeros(N));
        SparseMass { functions, factor }
    }

    /// x ← M⁻¹x.
    #[inline]
    pub(crate) fn solve(&self, work: &mut [f64], x: &mut SVector<f64, N>) {
        (self.functions.solve_mass)(&self.factor, work, x);
    }

    /// M⁻¹f of the forces at (t, q), which do not depend on velocities.
    #[inline]
    pub(crate) fn weigh_forces<S, const Q: usize>(
        &self,
        system: &S,
        (t, q): (f64, &SVector<f64, Q>),
        work: &mut [f64],
        acceleration: &mut SVector<f64, N>,
    ) where
        S: System<Q, N, R>,
    {
        if self.functions.forces_vary {
            system.applied_forces(t, q, &SVector::zeros(), acceleration);
            self.solve(work, acceleration);
        } else {
            system.acceleration(t, q, acceleration);
        }
    }
}
