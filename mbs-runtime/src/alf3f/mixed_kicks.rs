//! Kick, flow, kick with nonholonomic rows, alone or beside holonomic ones.
//!
//! Nonholonomic rows have ONE multiplier κₙ, acting in both kicks: N₁ v₁ + n₁ = 0 determines it, and energy is kept as
//! it is by the holonomic rows. Newton works on (κ₁, κₙ) together; with P the velocity projection of the holonomic rows
//! its matrix is
//!
//! ```text
//! holonomic row i:     A₁ᵢ · (∂q₁/∂v_a / h) W₀ⱼ
//! nonholonomic row i:  N₁ᵢ · P ((∂v_b/∂v_a) W₀ⱼ + [j nonholonomic] W₁ⱼ)
//! ```

use super::kicks::{EXACT, SLOW, STAGNATED, not_converged, residual_of};
use super::step_context::{StepContext, Workspace};
use super::{ConstraintGeometry, Fault};
use crate::System;
use crate::flow::KickFlow;
use crate::linear::{accumulate, dot};

/// Slower than any motion: 0/0 does not arise where nothing moves.
const AT_REST: f64 = 1e-100;

pub(crate) fn step<S, F, const Q: usize, const N: usize, const R: usize>(
    context: &mut StepContext<S, Q, N, R>,
    flow: &mut F,
    h: f64,
) -> Result<(), Fault>
where
    S: System<Q, N, R>,
    F: KickFlow<S, Q, N, R>,
{
    let holonomic = S::STRUCTURE.holonomic_rows;
    let StepContext {
        system,
        state,
        max_iterations,
        start,
        end,
        work,
        scale,
        yardstick,
        counters,
        ..
    } = context;
    let (t0, t1) = (state.time, state.time + h);
    let lengths = start.lengths_squared();
    let mut weights = scale.weights;

    let beside = holonomic > 0 && work.delassus.beside;
    let mut kappa = state.expected_impulse(h);
    let mut va = state.velocities;
    accumulate(&mut va, &start.w, &kappa);
    flow.begin(system, t0, &state.positions, &va, start, h);

    let mut q = state.positions;
    // NaN is below nothing: the first correction always begins with a factorisation.
    let mut last = f64::NAN;
    let mut fresh = false;
    work.projection.regularised = false;
    let mut iterations = 0;
    let v = loop {
        flow.positions(system, &va, &mut q)?;
        system.constraints(t1, &q, &mut work.phi, &mut *end.a, &mut end.b);
        end.metric(system, t1, &q)?;
        let mut v = flow.velocities(system, &va, &q, end);
        factor_holonomic(end, work);
        for i in holonomic..R {
            for j in 0..N {
                v[j] += end.w[i][j] * kappa[i];
            }
        }
        work.impulse[1] = kappa;
        project(end, work, &mut v);

        let mut defect = work.phi;
        for i in holonomic..R {
            defect[i] = dot(&end.a[i], &v) + end.b[i];
        }
        if iterations == 0 {
            // Kicks that cancel leave their round-off.
            let speeds = std::array::from_fn(|i| va[i].abs().max(v[i].abs()));
            let speed = yardstick.measure(&speeds).max(AT_REST);
            for i in holonomic..R {
                weights[i] /= speed * speed;
            }
        }
        let residual = residual_of(&defect, &weights);
        // Beside a singular pose down to round-off.
        let beside = beside || (holonomic > 0 && work.delassus.beside);
        let stuck = residual >= 0.25 * last || iterations >= *max_iterations;
        if residual <= 1.0 && (!beside || residual <= EXACT || stuck) {
            break v;
        }
        if !(residual < SLOW * last) {
            let taken = if work.projection.regularised {
                scale.lost
            } else {
                STAGNATED
            };
            if fresh && residual > 0.5 * last && residual < taken {
                break v;
            }
            if iterations >= *max_iterations || !residual.is_finite() {
                return Err(not_converged(&defect, &weights, iterations));
            }
            let directions = flow.position_sensitivity(system, &va, start)?;
            system.delassus(&end.a, directions, &mut work.matrix);
            let far = flow.velocity_sensitivity(&start.w);
            for j in 0..R {
                let mut column = far[j];
                if j >= holonomic {
                    for k in 0..N {
                        column[k] += end.w[j][k];
                    }
                }
                remove_holonomic(end, work, &mut column);
                for i in holonomic..R {
                    work.matrix[i][j] = dot(&end.a[i], &column);
                }
            }
            // The kick of a nonholonomic row counts twice.
            let mut lengths = lengths;
            for length in &mut lengths[holonomic..] {
                *length *= 2.0;
            }
            work.projection
                .factor(&work.matrix, &lengths, work.delassus.skipped());
            counters.regularised += u64::from(work.projection.regularised);
            fresh = true;
        } else {
            fresh = false;
        }
        let mut change = defect;
        for value in &mut change[..holonomic] {
            *value /= h;
        }
        work.projection.solve(&mut change);
        for i in 0..R {
            change[i] = -change[i];
            kappa[i] += change[i];
        }
        accumulate(&mut va, &start.w, &change);
        flow.predict(&change);
        last = residual;
        iterations += 1;
    };
    counters.iterations += iterations as u64;
    work.impulse[0] = kappa;
    let weak = context.work.projection.regularised
        || (S::STRUCTURE.holonomic_rows > 0 && context.work.delassus.weak);
    context.commit(t1, h, q, v, weak)
}

/// Factors S of the holonomic rows, with unit rows in place of the others.
pub(super) fn factor_holonomic<
    S: System<Q, N, R>,
    const Q: usize,
    const N: usize,
    const R: usize,
>(
    end: &ConstraintGeometry<S, Q, N, R>,
    work: &mut Workspace<R>,
) {
    let holonomic = S::STRUCTURE.holonomic_rows;
    if holonomic > 0 {
        // On the stack: a step allocates nothing.
        let mut delassus = *end.delassus;
        for i in holonomic..R {
            delassus[i] = [0.0; R];
            for row in &mut delassus {
                row[i] = 0.0;
            }
            delassus[i][i] = 1.0;
        }
        work.delassus.factor(&delassus);
    }
}

/// Projects v onto the holonomic velocity rows and adds the multipliers to the second impulse.
fn project<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    end: &ConstraintGeometry<S, Q, N, R>,
    work: &mut Workspace<R>,
    v: &mut [f64; N],
) {
    let holonomic = S::STRUCTURE.holonomic_rows;
    if holonomic == 0 {
        return;
    }
    work.impulse[1][..holonomic].fill(0.0);
    let passes = if work.delassus.weak { 4 } else { 1 };
    for _ in 0..passes {
        let mut multiplier = [0.0; R];
        for i in 0..holonomic {
            multiplier[i] = -dot(&end.a[i], v) - end.b[i];
        }
        work.delassus.solve(&mut multiplier);
        accumulate(v, &end.w, &multiplier);
        for i in 0..holonomic {
            work.impulse[1][i] += multiplier[i];
        }
    }
}

/// x ← P x.
fn remove_holonomic<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    end: &ConstraintGeometry<S, Q, N, R>,
    work: &Workspace<R>,
    x: &mut [f64; N],
) {
    let holonomic = S::STRUCTURE.holonomic_rows;
    if holonomic == 0 {
        return;
    }
    let mut multiplier = [0.0; R];
    for i in 0..holonomic {
        multiplier[i] = -dot(&end.a[i], x);
    }
    work.delassus.solve(&mut multiplier);
    accumulate(x, &end.w, &multiplier);
}
