//! The size of a violation of a row, as a displacement.

#[cfg(feature = "std")]
mod large;
mod usual;

use crate::constraint_geometry::ConstraintGeometry;
#[cfg(not(feature = "std"))]
use crate::elementary::Elementary as _;
use crate::fault::Fault;
use crate::large::is_sparse;
use crate::linear::{dot, entries, larger, products, vector};
use crate::singular::{LEFT_OPEN, NOTHING, ROUND_OFF, STAGNATED};
use crate::yardstick::Yardstick;
use crate::{Settings, System};
use nalgebra::{SMatrix, SVector};

/// Converts φ to a displacement: |φ_i| ≤ tolerance · |a_i|, where |a_i| is the change of φ_i as all coordinates change
/// by the length of the mechanism or a radian, at the declared guess.
///
/// It depends on the system alone, so that a resumed run takes the same decisions.
#[derive(Clone, Copy)]
pub(crate) struct RowScale<const R: usize> {
    /// 1/(tolerance · |a_i|)².
    pub(crate) weights: SVector<f64, R>,
    /// |a_i|²: with it multipliers of rows in different units are comparable, as works.
    pub(crate) lengths_squared: SVector<f64, R>,
    /// The same of a M⁻¹aᵀ of the holonomic rows, 0 of the others: a row that has become much shorter is beside a
    /// singular pose where it vanishes. (Not computed where factors are sparse, which do not use it.)
    pub(crate) usual: SVector<f64, R>,
    /// The same for all holonomic rows, where rows vanish at the declared guess: `usual` is zero for these until the motion
    /// has left that pose. (Steps out of it from rest need the rows as they are.)
    later: Option<SVector<f64, R>>,
    /// ([`LEFT_OPEN`] / tolerance)².
    pub(crate) lost: f64,
    pub(crate) tolerance: f64,
}

impl<const R: usize> RowScale<R> {
    pub(crate) fn new<S: System<Q, N, R>, const Q: usize, const N: usize>(
        system: &S,
        yardstick: &Yardstick<Q, N>,
        settings: &Settings,
    ) -> Result<Self, Fault> {
        let tolerance = settings.constraint_tolerance;
        let yardstick = yardstick.for_tolerance(S::MODEL, S::STATES, tolerance);
        #[cfg(feature = "std")]
        if let Some([lengths_squared, usual]) = large::lengths(system, &yardstick, settings) {
            return Ok(Self::of::<S, Q, N>(
                (&lengths_squared, usual, None),
                &yardstick,
                tolerance,
            ));
        }
        let weighed = !is_sparse::<S, Q, N, R>(settings);
        let (lengths_squared, usual, later) = usual::lengths(system, &yardstick, weighed)?;
        Ok(Self::of::<S, Q, N>(
            (&lengths_squared, usual, later),
            &yardstick,
            tolerance,
        ))
    }

    /// From |a_i|², which may vanish, and a M⁻¹aᵀ.
    fn of<S: System<Q, N, R>, const Q: usize, const N: usize>(
        (found, usual, later): (&SVector<f64, R>, SVector<f64, R>, Option<SVector<f64, R>>),
        yardstick: &Yardstick<Q, N>,
        tolerance: f64,
    ) -> Self {
        let lengths_squared: SVector<f64, R> = vector(|i| {
            let length_squared = found[i];
            let expected = Self::expected::<S, Q, N>(i, yardstick.length);
            match length_squared > (NOTHING * expected).powi(2) {
                true => length_squared,
                false => expected * expected,
            }
        });
        RowScale {
            weights: vector(|i| 1.0 / (tolerance * tolerance * lengths_squared[i])),
            lengths_squared,
            usual,
            later,
            lost: (LEFT_OPEN / tolerance).powi(2).max(STAGNATED),
            tolerance,
        }
    }

    /// The expected length of a row with its unit in a mechanism of this length: length^k for a unit m^k.
    pub(crate) fn expected<S: System<Q, N, R>, const Q: usize, const N: usize>(
        row: usize,
        length: f64,
    ) -> f64 {
        let unit = S::MODEL.rows.get(row).map_or("", |row| row.unit);
        length.powi(power_of_metres(unit))
    }

    /// The lengths of all rows, whatever the declared guess.
    pub(crate) fn final_lengths(&self) -> SVector<f64, R> {
        self.later.unwrap_or(self.usual)
    }

    /// Whether rows that vanish at the declared guess have not been longer yet.
    #[inline(always)]
    pub(crate) fn is_waiting(&self) -> bool {
        self.later.is_some()
    }

    /// How short the shortest of them is here: the length relative to what it will be, 1 at most.
    #[cold]
    #[inline(never)]
    pub(crate) fn shortness(&self, delassus: &SMatrix<f64, R, R>) -> f64 {
        let Some(later) = self.later else {
            return 1.0;
        };
        let waiting = (0..R).filter(|&i| self.usual[i] != later[i]);
        let least = waiting.fold(1.0, |least: f64, i| least.min(delassus[(i, i)] / later[i]));
        least.sqrt()
    }

    /// Ends that where every one of them is longer: on its diagonal `delassus` has a M⁻¹aᵀ.
    #[cold]
    #[inline(never)]
    pub(crate) fn settle(&mut self, delassus: &SMatrix<f64, R, R>) {
        if let Some(later) = self.later
            && (0..R)
                .all(|i| self.usual[i] == later[i] || delassus[(i, i)] >= usual::SHORT * later[i])
        {
            (self.usual, self.later) = (later, None);
        }
    }

    /// a M⁻¹aᵀ of the rows of this geometry, or what is usual where that is more.
    #[inline(always)]
    pub(crate) fn lengths<S: System<Q, N, R>, const Q: usize, const N: usize>(
        &self,
        geometry: &ConstraintGeometry<S, Q, N, R>,
    ) -> SVector<f64, R> {
        let (delassus, usual) = (&geometry.delassus.data.0, entries(&self.usual));
        vector(|i| larger(delassus[i][i], usual[i]))
    }

    /// The largest |φ_i|/|a_i|, a displacement in lengths of the mechanism; NaN if any φ is.
    pub(crate) fn displacement(&self, phi: &SVector<f64, R>) -> f64 {
        let displacements = vector::<R>(|i| self.displacement_of(i, phi[i]));
        crate::linear::largest(&displacements)
    }

    /// |φ_i|/|a_i|.
    pub(crate) fn displacement_of(&self, row: usize, phi: f64) -> f64 {
        phi.abs() * self.weights[row].sqrt() * self.tolerance
    }

    /// The round-off of velocity rows, in squared tolerances per second, at this speed in lengths of the mechanism and
    /// radians per second.
    pub(crate) fn round_off(&self, speed: f64) -> f64 {
        (ROUND_OFF / self.tolerance * speed).powi(2)
    }

    /// The residual that is accepted if a new factor does not reduce it; `lost`: a row has lost its direction.
    #[inline(always)]
    pub(crate) fn round_off_of(&self, lost: bool) -> f64 {
        if lost { self.lost } else { STAGNATED }
    }

    /// The same where positions have this round-off, in lengths of the mechanism: it grows with them, as the angle of a wheel and
    /// the place of a vehicle do.
    #[cold]
    pub(crate) fn round_off_at(&self, of_positions: f64, lost: bool) -> f64 {
        self.round_off_of(lost)
            .max((of_positions / self.tolerance).powi(2))
    }

    /// Σ |a_i|² x_i² of multipliers.
    #[inline(always)]
    pub(crate) fn square(&self, x: &SVector<f64, R>) -> f64 {
        dot(&products(&self.lengths_squared, x), x)
    }
}

/// k of a unit m^k …; 0 without metres.
fn power_of_metres(unit: &str) -> i32 {
    let above = unit.split('/').next().unwrap_or("");
    above
        .split(' ')
        .find_map(|factor| match factor.strip_prefix('m')? {
            "" => Some(1),
            "²" => Some(2),
            power => power.strip_prefix('^')?.parse().ok(),
        })
        .unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::power_of_metres;

    #[test]
    fn units_tell_how_rows_grow_with_the_mechanism() {
        let units = ["m", "m^2", "m/s", "kg m²", "rad", "1/(m)", "mol", ""];
        assert_eq!(units.map(power_of_metres), [1, 2, 1, 2, 0, 0, 0, 0]);
    }
}
