//! Several right-hand sides together. The entries of one wait for each other in a substitution; those of several fill the
//! time, and share each entry of the factor.

/// Solves with up to so many rows at once: as many as hide the latency of a sum.
const MOST: usize = 8;
/// With fewer entries a row is solved alone.
const SHORT: usize = 8;

/// The entries that rows have in one place.
pub(crate) type Lane<const WIDTH: usize> = [f64; WIDTH];

/// Substitution in a factor.
pub(crate) trait Substitution<const N: usize> {
    /// With one right-hand side.
    fn one(&self, x: &mut [f64; N]);
    /// With several.
    fn several<const WIDTH: usize>(&self, x: &mut [Lane<WIDTH>; N]);
}

/// Solves with each of the rows.
#[inline(always)]
pub(crate) fn solve_rows<const N: usize, const R: usize>(
    factor: &impl Substitution<N>,
    rows: &mut [[f64; N]; R],
) {
    if R < 2 || N <= SHORT {
        rows.iter_mut().for_each(|row| factor.one(row));
    } else if R <= MOST / 2 {
        together::<N, { MOST / 2 }>(factor, rows);
    } else {
        rows.chunks_mut(MOST)
            .for_each(|rows| together::<N, MOST>(factor, rows));
    }
}

/// Up to WIDTH rows.
fn together<const N: usize, const WIDTH: usize>(
    factor: &impl Substitution<N>,
    rows: &mut [[f64; N]],
) {
    let mut lanes = [[0.0; WIDTH]; N];
    for (k, row) in rows.iter().enumerate() {
        for (lane, &entry) in lanes.iter_mut().zip(row) {
            lane[k] = entry;
        }
    }
    factor.several(&mut lanes);
    for (k, row) in rows.iter_mut().enumerate() {
        for (entry, lane) in row.iter_mut().zip(&lanes) {
            *entry = lane[k];
        }
    }
}

/// x ← x − k y.
#[inline(always)]
pub(crate) fn subtract<const WIDTH: usize>(x: &mut Lane<WIDTH>, k: f64, y: &Lane<WIDTH>) {
    for (x, y) in x.iter_mut().zip(y) {
        *x -= k * y;
    }
}

/// x ← k x.
#[inline(always)]
pub(crate) fn scale<const WIDTH: usize>(x: &mut Lane<WIDTH>, k: f64) {
    x.iter_mut().for_each(|x| *x *= k);
}
