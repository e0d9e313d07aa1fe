//! Affinities of mechanisms for which they are not generated.

use crate::linear::{RowMatrix, vector};
use crate::sink::Discard;
use crate::{System, TensorSink};
use nalgebra::SVector;

/// Γ_ijk = ½ (∂M_ij/∂q_k + ∂M_ik/∂q_j − ∂M_jk/∂q_i) from the slopes of the momentum M e_j of unit velocities, and the
/// structure constants of the rotations, symmetric in j and k: Γ_ijk v_j v_k has ω × p in their rows.
pub fn by_tangents<S, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    q: &SVector<f64, Q>,
    gamma: &mut impl TensorSink,
) where
    S: System<Q, N, R>,
{
    let mut mass = RowMatrix::<N, N>::zeros();
    system.mass_matrix(q, &mut mass);
    // slopes[j][i][k] = ∂M_ij/∂q_k
    let slopes: [_; N] = core::array::from_fn(|j| {
        let unit: SVector<f64, N> = vector(|i| if i == j { 1.0 } else { 0.0 });
        let mut slope = RowMatrix::<N, N>::zeros();
        system.force_tangents(0.0, q, &unit, &mut Discard, &mut Discard, &mut slope);
        slope
    });
    for i in 0..N {
        // ω × p of the rotation that i belongs to: rows a, b, c in cyclic order.
        let mut rotations = S::ROTATIONS.iter();
        let turn = rotations.find(|&&first| (first..first + 3).contains(&i));
        for j in 0..N {
            for k in 0..N {
                let mut value = 0.5 * (slopes[j][i][k] + slopes[k][i][j] - slopes[k][j][i]);
                if let Some(&first) = turn {
                    let (b, c) = (first + (i - first + 1) % 3, first + (i - first + 2) % 3);
                    // (ω × p)_a = ω_b p_c − ω_c p_b
                    for (omega, other) in [(j, k), (k, j)] {
                        if omega == b {
                            value += 0.5 * mass[c][other];
                        }
                        if omega == c {
                            value -= 0.5 * mass[b][other];
                        }
                    }
                }
                if value != 0.0 {
                    gamma.set(i, j, k, value);
                }
            }
        }
    }
}
