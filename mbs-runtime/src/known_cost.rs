//! An upper bound of the operations of a step with a fixed number of corrections
//! ([`Settings::fixed_iterations`](crate::Settings::fixed_iterations)).

use crate::Model;
use crate::alf3f::FIXED_REFINEMENTS;
use crate::singular::PASSES;

/// The cost of a division and of an elementary function, in additions.
const DIVISION: usize = 5;
const CALL: usize = 20;
/// A free flight of a rotation, and its tangent applied to a row.
const FLIGHT: usize = 120;
const TANGENT: usize = 60;
/// Solves on the velocity rows: the first, and refinements.
const VELOCITY_SOLVES: usize = 1 + FIXED_REFINEMENTS;

impl Model {
    /// Operations of a generated function; `None` if there is none of this name.
    pub(crate) fn cost_of(&self, name: &str) -> Option<usize> {
        let function = self.operations.iter().find(|cost| cost.function == name)?;
        Some(
            function.additions
                + function.multiplications
                + DIVISION * function.divisions
                + CALL * function.calls,
        )
    }

    /// Operations of a step of second order with this many corrections, at most; `None` where no such step exists
    /// ([`Settings::fixed_iterations`](crate::Settings::fixed_iterations)). Multiply by 7, 13 or 17 at orders 4, 6
    /// and 8. A division counts as 5 and an elementary function as 20.
    ///
    /// ```text
    /// (n + 1) (constraints + flight) + n (solve + κ₁) + metric + delassus + B + S + 3 (solve + rates + κ₂) + acceleration + books
    /// ```
    ///
    /// with the counts of [`Model::operations`]. Factorisations and solves count as proximal, which they are only
    /// beside singular poses: usual steps cost a small part of the bound. `books`: works, energies and the detection of
    /// singular poses of [`Simulation`](crate::Simulation).
    pub fn step_flops(&self, iterations: usize) -> Option<usize> {
        let structure = &self.structure;
        let (n, r) = (self.velocities.len(), self.rows.len());
        let known = structure.constant_mass
            && !structure.velocity_forces
            && structure.holonomic_rows == r
            && iterations > 0;
        if !known {
            return None;
        }
        let of = |name: &str| self.cost_of(name);
        let cost = |name: &str| of(name).unwrap_or(0);
        let delassus = cost("delassus");
        let metric = of("metric").unwrap_or(cost("solve_mass_rows") + delassus);
        let rates = of("row_rates").unwrap_or(2 * n * r) + 2 * r;
        let flight = 4 * n + FLIGHT * structure.rotations;
        let directions = TANGENT * structure.rotations * r;
        // Elimination, then BBᵀ + εI and its Cholesky factor, and the search for rows without direction.
        let factorisation = r * r * r + (3 * r * r * r + 10 * r * r) + r * r * r;
        // Bᵀ(BBᵀ + εI)⁻¹ and the residual of each pass.
        let solve = PASSES * (8 * r * r + 12 * r) + 2 * r * r;
        let multiplier = 2 * n * r + 4 * r;
        // Only counts far beyond those of settings overflow.
        let evaluation = cost("constraints") + flight + 3 * r;
        let evaluations = iterations.checked_add(1)?.checked_mul(evaluation)?;
        let corrections = iterations.checked_mul(solve + multiplier)?;
        let position = metric + delassus + directions + 2 * factorisation;
        let velocity = VELOCITY_SOLVES * (solve + rates + multiplier);
        let motion = cost("acceleration") + 2 * multiplier + 12 * n + flight + 10 * r;
        let books = cost("nonconservative_power")
            + cost("kinetic_energy")
            + cost("potential_energy")
            + rates
            + factorisation
            + 10 * r;
        let once = position + velocity + motion + books;
        evaluations.checked_add(corrections)?.checked_add(once)
    }
}
