//! The energy balance, the first diagnostic of every run.

use crate::{Energy, State, System};

/// T + V.
#[cfg(feature = "std")]
pub(crate) fn total<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    state: &State<Q, N, R>,
) -> f64 {
    let (q, v) = (&state.positions, &state.velocities);
    system.kinetic_energy(q, v) + system.potential_energy(q)
}

/// T, V and works; their balance is zero for the exact motion.
pub(crate) fn balance<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    state: &State<Q, N, R>,
) -> Energy {
    let kinetic = system.kinetic_energy(&state.positions, &state.velocities);
    let potential = system.potential_energy(&state.positions);
    let ledger = &state.ledger;
    let total = kinetic + potential;
    Energy {
        kinetic,
        potential,
        nonconservative_work: ledger.nonconservative_work,
        drive_work: ledger.drive_work,
        error: total
            - ledger.initial.unwrap_or(total)
            - ledger.nonconservative_work
            - ledger.drive_work,
    }
}
