//! The generalized-α method for constrained motion.
//!
//! ```text
//! M v̇₁ + Γvv = f + Aᵀλ₁,   φ(q₁) = 0   (index 3)
//! (1 − α_m) a₁ + α_m a₀ = (1 − α_f) v̇₁ + α_f v̇₀
//! v₁ = v₀ + h (1 − γ) a₀ + h γ a₁,   q₁ = q₀ ⊕ (h v₀ + h² (½ − β) a₀ + h² β a₁)
//! ```
//!
//! α_m = (2ρ − 1)/(ρ + 1), α_f = ρ/(ρ + 1), γ = ½ + α_f − α_m, β = (γ + ½)²/4, with ρ the spectral radius at infinite
//! frequency: Chung & Hulbert, J. Appl. Mech. 60, 1993; index 3: Arnold & Brüls, Multibody Syst. Dyn. 18, 2007, 185–202;
//! rotations: Brüls, Cardona, Arnold, Mech. Mach. Theory 48, 2012, 121–137. The stabilised form of index 2 (Gear, Gupta,
//! Leimkuhler, J. Comput. Appl. Math. 12, 1985; Arnold, Brüls, Cardona, Numer. Math. 129, 2015, 149–179) satisfies
//! A v₁ + b = 0 with λ and φ(q₁) = 0 with a further multiplier that moves q₁ along M⁻¹Aᵀ.

use super::bench::Bench;
use super::index1::Index1;
use super::motion::{Motion, Progress, carry, consistent, move_rows};
use super::rule::{AnyRule, Rule};
use super::saddle::Saddle;
use crate::GeneralizedAlphaSettings;
use crate::fault::Fault;
use crate::flow::pull_back;
use crate::linear::{RowMatrix, accumulate, dot, scaled, vector};
use crate::{Method, Settings, System};
use nalgebra::SVector;

/// A step may be longer than the last one by this factor, so that it goes on with its accelerations.
const LONGER: f64 = 4.0;
/// What is proportional to a power of the length of steps is taken from a step that is shorter by at most this factor than the one
/// that it was taken from before: in proportion to longer steps, the differences of shorter ones would grow without bound.
const SHORTER: f64 = 2.0;
/// A relative difference of lengths that is round-off.
const SAME: f64 = 1e-9;

#[derive(Clone)]
pub(crate) struct GeneralizedAlpha<const N: usize, const R: usize> {
    alpha_m: f64,
    alpha_f: f64,
    beta: f64,
    gamma: f64,
    stabilised: bool,
    motion: Motion<N>,
    saddle: Saddle<N, R>,
    /// The position rows of the stabilised form.
    shift: Saddle<N, R>,
    moved: RowMatrix<N, R>,
    history: Option<History<N, R>>,
    /// The length of an earlier step, and the rates A v + b of the position rows that it has left open.
    open: Option<(f64, SVector<f64, R>)>,
    /// The length of an earlier step, and a − v̇ after it.
    ahead: Option<(f64, SVector<f64, N>)>,
    /// Whether accelerations have jumped since.
    jumped: bool,
    /// The equations at acceleration level, for the first step and those after a jump.
    equations: Box<Index1<N, R>>,
}

#[derive(Clone, Copy)]
struct History<const N: usize, const R: usize> {
    /// The length of the step, s.
    length: f64,
    acceleration: SVector<f64, N>,
    /// The auxiliary acceleration a.
    algorithmic: SVector<f64, N>,
    lambda: SVector<f64, R>,
}

/// Whether a step of this length takes the place of an earlier one.
fn lasts<T>(earlier: Option<&(f64, T)>, length: f64) -> bool {
    earlier.is_none_or(|(known, _)| length.abs() * SHORTER > known.abs())
}

impl<const N: usize, const R: usize> GeneralizedAlpha<N, R> {
    /// For the method of the settings.
    pub(crate) fn rule<S: System<Q, N, R>, const Q: usize>(
        _: &Bench<S, Q, N, R>,
        settings: &Settings,
    ) -> Option<Result<AnyRule<S, Q, N, R>, Fault>> {
        let Method::GeneralizedAlpha(alpha) = &settings.method else {
            return None;
        };
        Some(Ok(Box::new(GeneralizedAlpha::new(alpha))))
    }

    fn new(settings: &GeneralizedAlphaSettings) -> Self {
        let rho = settings.spectral_radius;
        let (alpha_m, alpha_f) = ((2.0 * rho - 1.0) / (rho + 1.0), rho / (rho + 1.0));
        let gamma = 0.5 + alpha_f - alpha_m;
        GeneralizedAlpha {
            alpha_m,
            alpha_f,
            beta: 0.25 * (gamma + 0.5) * (gamma + 0.5),
            gamma,
            stabilised: settings.stabilised,
            motion: Motion::new(),
            saddle: Saddle::new(),
            shift: Saddle::new(),
            moved: RowMatrix::zeros(),
            history: None,
            open: None,
            ahead: None,
            jumped: false,
            equations: Box::new(Index1::new(0.0)),
        }
    }

    /// What a step begins with. a is an acceleration (α_m − α_f) h after the one of the state: with another length it is nearer or
    /// farther in proportion, and where v̇ jumps a jumps with it.
    ///
    /// After a much shorter step, whose accelerations have a large round-off, they are those of the equations.
    fn beginning<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        h: f64,
    ) -> Result<History<N, R>, Fault> {
        let usable = self
            .history
            .filter(|history| h.abs() < LONGER * history.length.abs());
        if let Some(history) = &self.history {
            // Steps of one length take the place of all earlier ones.
            let is_even = (h - history.length).abs() <= SAME * h.abs();
            if is_even {
                self.open = None;
            }
            if is_even || lasts(self.ahead.as_ref(), history.length) {
                let ahead = history.algorithmic - history.acceleration;
                self.ahead = Some((history.length, ahead));
            }
        }
        let mut begins = match usable {
            Some(history) if !self.jumped => history,
            _ => {
                let (acceleration, lambda) = consistent(&mut self.equations, bench)?;
                History {
                    length: h,
                    acceleration,
                    algorithmic: acceleration,
                    lambda,
                }
            }
        };
        if let Some((length, ahead)) = &self.ahead {
            begins.algorithmic = begins.acceleration + ahead * (h / length);
        }
        Ok(begins)
    }

    /// The velocities that a step begins with.
    ///
    /// In steps of equal length h the rates A v + b of the position rows are left open by a multiple of h². A step of another length s
    /// would close them with accelerations (A v + b)/(β s), which are none of the motion: these grow without bound where long and short
    /// steps alternate. So v is moved along M⁻¹Aᵀ to where the rates are those of steps of this length.
    fn opened<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        h: f64,
    ) -> Result<SVector<f64, N>, Fault> {
        let holonomic = S::STRUCTURE.holonomic_rows;
        let (t, q, mut v) = (
            bench.state.time,
            bench.state.positions,
            bench.state.velocities,
        );
        let last = self.history.as_ref().map(|history| history.length);
        let Some(last) = last.filter(|last| (h - last).abs() > SAME * last.abs()) else {
            return Ok(v);
        };
        if self.stabilised || holonomic == 0 {
            return Ok(v);
        }
        let Bench {
            system,
            geometry,
            phi,
            ..
        } = &mut *bench;
        system.constraints(t, &q, phi, geometry.a.entries_mut(), &mut geometry.b);
        let rates: SVector<f64, R> = vector(|i| {
            if i < holonomic {
                geometry.velocity_row(i, &v)
            } else {
                0.0
            }
        });
        if lasts(self.open.as_ref(), last) {
            self.open = Some((last, rates));
        }
        let (length, open) = self.open.unwrap_or((last, rates));
        self.motion.balance(system, t, &q, &v);
        *self.moved = *geometry.a;
        v += self.along_rows(&geometry.a, open * (h / length).powi(2) - rates)?;
        Ok(v)
    }

    fn step<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        h: f64,
    ) -> Result<(), Fault> {
        let holonomic = S::STRUCTURE.holonomic_rows;
        let old = self.beginning(bench, h)?;
        let (q0, v0) = (bench.state.positions, self.opened(bench, h)?);
        let t1 = bench.state.time + h;
        // Derivatives of a₁, v₁ and q₁ with respect to v̇₁.
        let share = (1.0 - self.alpha_f) / (1.0 - self.alpha_m);
        let (to_v, to_q) = (self.gamma * h * share, self.beta * h * h * share);

        let mut acceleration = old.acceleration;
        let mut lambda = old.lambda;
        let mut shift = SVector::<f64, N>::zeros();
        let mut progress = Progress::new();
        let (q, v) = loop {
            let algorithmic = self.algorithmic(&old, &acceleration);
            let v: SVector<f64, N> = vector(|i| {
                v0[i] + h * ((1.0 - self.gamma) * old.algorithmic[i] + self.gamma * algorithmic[i])
            });
            let turn: SVector<f64, N> = vector(|i| {
                let a = (0.5 - self.beta) * old.algorithmic[i] + self.beta * algorithmic[i];
                h * (v0[i] + h * a) + shift[i]
            });
            let q = bench.system.advance(&q0, &turn, 1.0);
            let Bench {
                system,
                geometry,
                phi,
                ..
            } = &mut *bench;
            system.constraints(t1, &q, phi, geometry.a.entries_mut(), &mut geometry.b);
            self.motion.balance(system, t1, &q, &v);
            self.motion.tangents(system, t1, &q, &v);
            let mut change = self.motion.defect(&v, &acceleration);
            accumulate(&mut change, &geometry.a, &lambda);
            if !S::ROTATIONS.is_empty() {
                pull_back::<S, Q, N, R>(&turn, &mut self.motion.f_q);
            }
            self.motion.combine(to_v, to_q);
            let mut rows = SVector::zeros();
            if self.stabilised {
                *self.moved = *geometry.a;
                for i in 0..R {
                    rows[i] = -(dot(&geometry.a[i], &v) + geometry.b[i]) / to_v;
                }
            } else {
                move_rows::<S, Q, N, R>(&geometry.a, &turn, &mut self.moved);
                for i in 0..R {
                    rows[i] = if i < holonomic {
                        -phi[i] / to_q
                    } else {
                        -geometry.velocity_row(i, &v) / to_v
                    };
                }
            }
            if !self
                .saddle
                .factor(&self.motion.jacobian, &geometry.a, &self.moved)
            {
                return Err(progress.lost());
            }
            bench.counters.regularised += u64::from(self.saddle.left_out() > 0);
            self.saddle.solve(&mut change, &mut rows, &self.moved);
            for i in 0..N {
                acceleration[i] += change[i];
            }
            for i in 0..R {
                lambda[i] += rows[i];
            }
            let mut step = scaled(to_v, &change);
            if self.stabilised {
                let along = scaled(to_q, &change);
                let moved = self.close(bench, &turn, &along)?;
                for i in 0..N {
                    shift[i] += moved[i];
                    step[i] += moved[i] / h;
                }
            }
            let (sizes, floor) = Progress::sizes(bench, &step, (&q, &v), h);
            if progress.settles(sizes, floor, bench.max_iterations)? {
                break (q, v);
            }
        };
        bench.counters.iterations += progress.count();
        bench.counters.stages += 1;
        let start = bench.state.time;
        bench.multipliers = Some(lambda);
        bench.trapezoid_works(start, h, (&q0, &v0), (&q, &v), [&old.lambda, &lambda]);
        bench.commit(t1, q, v, false)?;
        self.jumped = false;
        self.history = Some(History {
            length: h,
            acceleration,
            algorithmic: self.algorithmic(&old, &acceleration),
            lambda,
        });
        Ok(())
    }

    fn algorithmic(&self, old: &History<N, R>, acceleration: &SVector<f64, N>) -> SVector<f64, N> {
        vector(|i| {
            ((1.0 - self.alpha_f) * acceleration[i] + self.alpha_f * old.acceleration[i]
                - self.alpha_m * old.algorithmic[i])
                / (1.0 - self.alpha_m)
        })
    }

    /// The shift of θ along M⁻¹Aᵀ that closes the position rows after θ has changed by `along`.
    fn close<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &Bench<S, Q, N, R>,
        turn: &SVector<f64, N>,
        along: &SVector<f64, N>,
    ) -> Result<SVector<f64, N>, Fault> {
        let holonomic = S::STRUCTURE.holonomic_rows;
        let mut carried = *along;
        carry::<S, Q, N, R>(turn, &mut carried);
        let rows: SVector<f64, R> = vector(|i| {
            if i < holonomic {
                -bench.phi[i] - dot(&bench.geometry.a[i], &carried)
            } else {
                0.0
            }
        });
        move_rows::<S, Q, N, R>(&bench.geometry.a, turn, &mut self.moved);
        self.along_rows(&bench.geometry.a, rows)
    }

    /// The change along M⁻¹Aᵀ that changes what `moved` is the derivative of by these values.
    fn along_rows(
        &mut self,
        a: &RowMatrix<N, R>,
        mut rows: SVector<f64, R>,
    ) -> Result<SVector<f64, N>, Fault> {
        if !self.shift.factor(&self.motion.mass, a, &self.moved) {
            return Err(Fault::Mass);
        }
        let mut change = SVector::zeros();
        self.shift.solve(&mut change, &mut rows, &self.moved);
        Ok(change)
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Rule<S, Q, N, R>
    for GeneralizedAlpha<N, R>
{
    fn advance(&mut self, bench: &mut Bench<S, Q, N, R>, h: f64) -> Result<(), Fault> {
        GeneralizedAlpha::step(self, bench, h)
    }

    fn refresh(&mut self) {
        self.jumped = true;
        // The rates of an earlier motion are none of this one.
        self.open = None;
    }
}
