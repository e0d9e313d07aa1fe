//! The equations at acceleration level (index 1): M v̇ + Γvv = f + Aᵀλ, A v̇ + γ = 0.

use super::bench::Bench;
use super::planned::Planned;
use crate::System;
use crate::constraint_geometry::ConstraintGeometry;
use crate::fault::Fault;
use crate::free::free;
use crate::linear::{DelassusFactor, accumulate, largest, vector};
use crate::singular::{REDUNDANT_OFF_ROWS, RankMargin, Thresholds};
use crate::sink::Discard;
use nalgebra::SVector;

/// The largest weakness of a block with which accelerations are solved for independent velocities.
const WEAKEST: f64 = 1e4;

/// Accelerations and multipliers, with the stabilising terms of Baumgarte if the settings have them:
///
/// ```text
/// A v̇ + γ + 2α (A v + b) + β² φ = 0
/// ```
#[derive(Clone)]
pub(crate) struct Index1<const N: usize, const R: usize> {
    pub(crate) delassus: Box<DelassusFactor<R>>,
    /// Instead of it where rows are many.
    pub(crate) planned: Option<Box<Planned<N, R>>>,
    /// 2α, 1/s.
    damping: f64,
    /// β², 1/s².
    stiffness: f64,
    gamma: SVector<f64, R>,
    /// λ of the last acceleration.
    pub(crate) lambda: SVector<f64, R>,
    inverse_pivot: SVector<f64, R>,
    weakness: SVector<f64, R>,
    /// The least and the largest 1/σ² of the evaluations since [`Self::begin`], with the smallest singular value σ of the
    /// rows.
    range: [f64; 2],
    /// 1/σ² of the last of them.
    pub(crate) last: f64,
}

impl<const N: usize, const R: usize> Index1<N, R> {
    /// With α = β = `gain`, 1/s.
    pub(crate) fn new(gain: f64) -> Self {
        Index1 {
            delassus: Box::new(DelassusFactor::new()),
            planned: None,
            damping: 2.0 * gain,
            stiffness: gain * gain,
            gamma: SVector::zeros(),
            lambda: SVector::zeros(),
            inverse_pivot: SVector::zeros(),
            weakness: SVector::zeros(),
            range: [f64::INFINITY, 0.0],
            last: f64::NAN,
        }
    }

    /// The same, by planned elimination where there is one.
    pub(crate) fn planned<S: System<Q, N, R>, const Q: usize>(
        bench: &Bench<S, Q, N, R>,
        gain: f64,
    ) -> Self {
        let mut equations = Index1::new(gain);
        equations.planned = Planned::new(bench, equations.delassus.thresholds);
        equations
    }

    /// The same without stabilising terms, for steps that detect singular poses and redundant rows from those at the
    /// state of the bench.
    pub(crate) fn detecting<S: System<Q, N, R>, const Q: usize>(
        bench: &Bench<S, Q, N, R>,
        usual: SVector<f64, R>,
    ) -> Result<Self, Fault> {
        Index1::planned(bench, 0.0).expecting(bench, usual)
    }

    /// The same without planned elimination, for methods that need A in any case.
    pub(crate) fn detecting_densely<S: System<Q, N, R>, const Q: usize>(
        bench: &Bench<S, Q, N, R>,
        usual: SVector<f64, R>,
    ) -> Result<Self, Fault> {
        Index1::new(0.0).expecting(bench, usual)
    }

    fn expecting<S: System<Q, N, R>, const Q: usize>(
        mut self,
        bench: &Bench<S, Q, N, R>,
        usual: SVector<f64, R>,
    ) -> Result<Self, Fault> {
        let (system, state) = (&bench.system, &bench.state);
        let delassus = &mut self.delassus;
        // Projections leave rows open that count as lost: by 1e-9 in poses of a spherical linkage with σ² < 1e-6.
        delassus.thresholds = Thresholds::SECOND_ORDER_PLACED;
        delassus.usual = usual;
        // Without redundant rows there is nothing to expect.
        let planned = self.planned.as_ref();
        if planned.is_none_or(|planned| planned.leaves_rows_out()) {
            let mut geometry = ConstraintGeometry::new(system, &state.positions)?;
            let mut phi = SVector::zeros();
            geometry.evaluate(system, state.time, &state.positions, &mut phi)?;
            delassus.expect_redundancy(&geometry.delassus);
            delassus.expect_pivots(&ConstraintGeometry::at_guess(system)?.delassus);
        }
        delassus.follows = REDUNDANT_OFF_ROWS;
        Ok(self)
    }

    /// A step begins.
    pub(crate) fn begin(&mut self) {
        (self.range, self.last) = ([f64::INFINITY, 0.0], f64::NAN);
        if let Some(planned) = &mut self.planned {
            planned.begin();
        }
    }

    /// The smallest σ of the evaluations since [`Self::begin`] as a fraction of the largest: near 0 if one of them was
    /// beside a singular pose. The effect of a violation of A v = 0 in the stages is proportional to 1/σ² there.
    pub(crate) fn clearance(&self) -> f64 {
        let [least, most] = self.range;
        if most > 0.0 {
            (least / most).sqrt()
        } else {
            f64::INFINITY
        }
    }

    #[inline(always)]
    fn note(&mut self, inverse_square: f64) {
        // Comparisons, not `f64::min`: one instruction each.
        self.last = inverse_square;
        let [least, most] = &mut self.range;
        if inverse_square < *least {
            *least = inverse_square;
        }
        if inverse_square > *most {
            *most = inverse_square;
        }
    }

    /// v̇ at (t, q, v): by the planned elimination, or by the generated function, where there is one.
    #[inline(always)]
    pub(crate) fn evaluate<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
    ) -> Result<SVector<f64, N>, Fault> {
        if let Some(acceleration) = self.by_partition(bench, t, q, v) {
            return Ok(acceleration);
        }
        if let Some(acceleration) = self.by_plan(bench, t, q, v) {
            return Ok(acceleration);
        }
        let mut acceleration = SVector::zeros();
        // b is needed for the works of drives.
        let is_planned = const { S::ELIMINATION.is_some() } && self.planned.is_some();
        if !S::STRUCTURE.rheonomic && !is_planned {
            let correction = self.stabilisation(bench, t, q, v);
            let (system, inverse_pivot) = (&bench.system, &mut self.inverse_pivot);
            let (into, lambda) = (&mut acceleration, &mut self.lambda);
            if system.accelerations(t, q, v, &correction, into, lambda, inverse_pivot) {
                let mut most: f64 = 0.0;
                for (&inverse, &usual) in inverse_pivot.iter().zip(&self.delassus.usual) {
                    // The reciprocal is 0 of a row that is lost, −1 of one that follows from others in every pose.
                    let lost = inverse == 0.0;
                    let ratio = if lost { f64::INFINITY } else { inverse * usual };
                    if ratio > most {
                        most = ratio;
                    }
                }
                if R == 0 {
                    return Ok(acceleration);
                }
                if !self.delassus.needs_other_rows(most) {
                    self.note(most);
                    return Ok(acceleration);
                }
            }
        }
        self.place(bench, t, q)?;
        if let Some(now) = self.rank_margin(bench) {
            self.note(1.0 / (now.least * now.least));
        }
        Ok(self.acceleration(bench, t, q, v))
    }

    /// v̇ by independent velocities; `None` where there is no such function, and where a block of it is weak.
    #[inline(always)]
    fn by_partition<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
    ) -> Option<SVector<f64, N>> {
        if const { !S::PARTITIONED } {
            return None;
        }
        let correction = self.stabilisation(bench, t, q, v);
        let (system, weakness) = (&bench.system, &mut self.weakness);
        let mut acceleration = SVector::zeros();
        system.partitioned_accelerations(t, q, v, &correction, &mut acceleration, weakness);
        let most = largest(weakness);
        if most <= WEAKEST {
            self.note(most);
            return Some(acceleration);
        }
        None
    }

    /// v̇ by the planned elimination; `None` where there is none, and where dense equations are needed.
    #[inline(always)]
    fn by_plan<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
    ) -> Option<SVector<f64, N>> {
        if const { S::ELIMINATION.is_none() } {
            return None;
        }
        let planned = self.planned.as_mut()?;
        if !planned.place(bench, t, q) {
            return None;
        }
        let system = &bench.system;
        system.constraint_rates(t, q, v, &mut Discard, &mut self.gamma);
        let mut demand = self.gamma;
        if self.damping != 0.0 || self.stiffness != 0.0 {
            let rates = planned.rates(v);
            for i in 0..R {
                demand[i] +=
                    self.damping * (rates[i] + bench.geometry.b[i]) + self.stiffness * bench.phi[i];
            }
        }
        let acceleration = planned.acceleration(system, (t, q, v), &demand, &mut self.lambda);
        if let Some(now) = self.rank_margin(bench) {
            self.note(1.0 / (now.least * now.least));
        }
        Some(acceleration)
    }

    /// How independent the holonomic rows are where the bench was placed; `None` without such rows.
    pub(crate) fn rank_margin<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &Bench<S, Q, N, R>,
    ) -> Option<RankMargin> {
        let rows = S::STRUCTURE.holonomic_rows;
        if let Some(planned) = &self.planned
            && planned.is_sound()
        {
            return (rows > 0).then(|| planned.rank_margin(rows));
        }
        (rows > 0).then(|| self.delassus.rank_margin(&bench.geometry.delassus, rows))
    }

    /// The same at the state of the bench, where the rows are factored unless they are; `placed`: whether they are.
    pub(crate) fn margin_here<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        placed: &mut bool,
    ) -> Option<RankMargin> {
        if !*placed {
            let (t, q) = (bench.state.time, bench.state.positions);
            self.settle(bench, t, &q).ok()?;
            *placed = true;
        }
        self.rank_margin(bench)
    }

    /// How much each row takes part in what is nearest to a loss of independence; after [`Self::rank_margin`].
    pub(crate) fn weakest_rows<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &Bench<S, Q, N, R>,
    ) -> SVector<f64, R> {
        let rows = S::STRUCTURE.holonomic_rows;
        if let Some(planned) = &mut self.planned
            && planned.is_sound()
        {
            return planned.weakest_rows();
        }
        self.delassus.combination(&bench.geometry.delassus, rows)
    }

    /// 2α (A v + b) + β² φ.
    #[inline(always)]
    fn stabilisation<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
    ) -> SVector<f64, R> {
        if self.damping == 0.0 && self.stiffness == 0.0 {
            return SVector::zeros();
        }
        let Bench {
            system,
            geometry,
            phi,
            ..
        } = bench;
        system.constraints(t, q, phi, geometry.a.entries_mut(), &mut geometry.b);
        let rates = geometry.velocity_rows(system, v);
        vector(|i| self.damping * rates[i] + self.stiffness * phi[i])
    }

    /// The rows at (t, q), factored in whichever way.
    pub(crate) fn settle<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        t: f64,
        q: &SVector<f64, Q>,
    ) -> Result<(), Fault> {
        let planned = self.planned.as_mut();
        if planned.is_some_and(|planned| planned.place(bench, t, q)) {
            return Ok(());
        }
        self.place(bench, t, q)
    }

    /// Constraints and metric at (t, q), with S factored.
    #[inline(always)]
    pub(crate) fn place<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        t: f64,
        q: &SVector<f64, Q>,
    ) -> Result<(), Fault> {
        let Bench {
            system,
            geometry,
            phi,
            ..
        } = bench;
        system.constraints(t, q, phi, geometry.a.entries_mut(), &mut geometry.b);
        geometry.metric(system, t, q)?;
        self.delassus.factor(&geometry.delassus);
        bench.counters.regularised += u64::from(self.delassus.regularised);
        Ok(())
    }

    /// v̇ where the bench was placed.
    #[inline(always)]
    pub(crate) fn acceleration<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &Bench<S, Q, N, R>,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
    ) -> SVector<f64, N> {
        let (system, geometry) = (&bench.system, &bench.geometry);
        let mut acceleration = free(system, &geometry.mass, t, q, v);
        if R == 0 {
            return acceleration;
        }
        system.constraint_rates(t, q, v, &mut Discard, &mut self.gamma);
        // A v̇ + 2α A v in one product.
        let along = vector(|i| acceleration[i] + self.damping * v[i]);
        let mut rates = SVector::zeros();
        system.row_rates(&geometry.a, &along, &mut rates);
        for i in 0..R {
            self.lambda[i] = -(rates[i]
                + self.gamma[i]
                + self.damping * geometry.b[i]
                + self.stiffness * bench.phi[i]);
        }
        self.delassus.solve(&mut self.lambda);
        accumulate(&mut acceleration, &geometry.w, &self.lambda);
        acceleration
    }
}
