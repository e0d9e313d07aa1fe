//! Line 3 of Algorithm 1: the start values of a step, and its first estimates.

use super::rows::{Instant, RowMotion, Unknowns};
use crate::dynamics::Dynamics;
use crate::fault::Fault;
use crate::{MultiplierStart, PaperSettings};
use crate::{State, System};
use nalgebra::SVector;

/// The fields at the beginning of a step.
pub(super) struct Origin<const N: usize, const R: usize> {
    pub(super) mu: SVector<f64, R>,
    pub(super) lambda: SVector<f64, R>,
    pub(super) momentum: SVector<f64, N>,
}

impl<const N: usize, const R: usize> Origin<N, R> {
    /// Those of the last step, or μ = 0, λ = 0 and π = M v.
    pub(super) fn new<S: System<Q, N, R>, const Q: usize>(
        system: &S,
        state: &State<Q, N, R>,
        carried: bool,
    ) -> Self {
        let State {
            positions,
            velocities,
            fields,
            ..
        } = state;
        if carried && fields.started {
            return Origin {
                mu: fields.mu,
                lambda: fields.lambda,
                momentum: fields.momentum,
            };
        }
        let mut momentum = SVector::zeros();
        system.momentum(positions, velocities, &mut momentum);
        Origin {
            mu: SVector::zeros(),
            lambda: SVector::zeros(),
            momentum,
        }
    }
}

/// v⁰, μ⁰, q⁰, λ⁰ and ξ⁰ of a step of h.
///
/// The change of μ over a step is the impulse of its row, so that it scales with h. M-ALF, in which the force of the
/// rows depends on λ alone, starts at λ₀, that is with μ = −μ₀: λ₁ = λ₀ + h/2 (μ₀ + μ₁). With λ₀ + h μ₀ an error of μ
/// would change its sign in each step and not decay.
pub(super) fn estimate<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    settings: &PaperSettings,
    motion: RowMotion,
    state: &State<Q, N, R>,
    origin: &Origin<N, R>,
    h: f64,
) -> Unknowns<Q, N, R> {
    let fields = &state.fields;
    let (mut mu, mut lambda) = (origin.mu, origin.lambda);
    match (motion, settings.start) {
        (RowMotion::Own, MultiplierStart::Warm) if fields.length > 0.0 => {
            for i in 0..R {
                mu[i] += h / fields.length * fields.change[i];
            }
        }
        (RowMotion::Own, _) => {}
        (RowMotion::Static, MultiplierStart::Warm) => mu = mu.map(|mu| -mu),
        (RowMotion::Static, MultiplierStart::Cold) => {
            for i in 0..R {
                lambda[i] += h * mu[i];
            }
        }
    }
    Unknowns {
        v: state.velocities,
        q: system.advance(&state.positions, &state.velocities, h),
        mu,
        lambda,
        penalty: SVector::repeat(settings.penalty),
    }
}

/// Multipliers of a start without history: the change of μ that the reactions at acceleration level make in a second,
/// (M̄μ)˙ − f̄ = λ; those reactions themselves for M-ALF.
pub(super) fn begin<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    start: &mut Instant<S, Q, N, R>,
    motion: RowMotion,
    state: &mut State<Q, N, R>,
) -> Result<(), Fault> {
    let (t, q, v) = (state.time, &state.positions, &state.velocities);
    let dynamics = Dynamics::of(system.clone(), t, q, v)?;
    let reactions = dynamics.multipliers();
    let State {
        time,
        positions,
        velocities,
        fields,
        ..
    } = state;
    match motion {
        RowMotion::Own => {
            start.total_force(
                system,
                *time,
                positions,
                velocities,
                &SVector::zeros(),
                &SVector::zeros(),
            );
            for i in 0..R {
                let own = start.row_force(i, &SVector::zeros(), &SVector::zeros());
                fields.change[i] = (reactions[i] - own) / start.constraint_mass[i];
            }
            fields.length = 1.0;
        }
        RowMotion::Static => {
            fields.lambda = *reactions;
            fields.mu = SVector::zeros();
            system.momentum(positions, velocities, &mut fields.momentum);
            fields.started = true;
        }
    }
    Ok(())
}
