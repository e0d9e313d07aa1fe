//! Principal axes of an inertia tensor.

use nalgebra::{Matrix3, Rotation3, SymmetricEigen, UnitQuaternion};

/// Most iterations for the axes; some ten are usual.
const ITERATIONS: usize = 1000;

/// Principal moments; and the principal axes as columns and as a unit quaternion (w, x, y, z), if they are not the given
/// axes. The lower triangle is read.
pub(super) fn principal_axes(
    inertia: &[[f64; 3]; 3],
) -> ([f64; 3], Option<([[f64; 3]; 3], [f64; 4])>) {
    let [[xx, ..], [xy, yy, _], [xz, yz, zz]] = *inertia;
    if xy == 0.0 && xz == 0.0 && yz == 0.0 {
        return ([xx, yy, zz], None);
    }
    let inertia = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    // An inertia that is not finite has no axes, and its moments are refused; the library does not test it.
    let finite = inertia.iter().all(|entry| entry.is_finite());
    let eigen = finite.then(|| SymmetricEigen::try_new(inertia, f64::EPSILON, ITERATIONS));
    let Some(eigen) = eigen.flatten() else {
        return ([f64::NAN; 3], None);
    };
    let mut axes = eigen.eigenvectors;
    // A proper rotation: the sign of an axis is free.
    let third = axes.column(0).cross(&axes.column(1));
    axes.set_column(2, &third);
    let rotation = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes));
    let columns = axes.transpose().data.0;
    let quaternion = [rotation.w, rotation.i, rotation.j, rotation.k];
    let quaternion = super::rotation::normalised(quaternion);
    (eigen.eigenvalues.into(), Some((columns, quaternion)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_diagonalise() {
        let inertia = [[2.0, -0.3, 0.1], [-0.3, 3.0, 0.25], [0.1, 0.25, 2.5]];
        let (moments, axes) = principal_axes(&inertia);
        let (axes, _) = axes.unwrap();
        for k in 0..3 {
            for i in 0..3 {
                let product: f64 = (0..3).map(|j| inertia[i][j] * axes[j][k]).sum();
                assert!((product - moments[k] * axes[i][k]).abs() < 4e-15);
            }
        }
    }

    #[test]
    fn the_quaternion_is_that_of_the_axes() {
        let inertia = [[2.0, 0.9, -0.6], [0.9, 3.0, 0.5], [-0.6, 0.5, 2.5]];
        let (axes, [w, x, y, z]) = principal_axes(&inertia).1.unwrap();
        let first = [
            w * w + x * x - y * y - z * z,
            2.0 * (x * y + w * z),
            2.0 * (x * z - w * y),
        ];
        for i in 0..3 {
            assert!((axes[i][0] - first[i]).abs() < 1e-15);
        }
    }

    #[test]
    fn equal_moments_stay_equal() {
        let axis = [0.7_f64, 0.6, 0.2];
        let size = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
        let n = axis.map(|x| x / size);
        let inertia: [[f64; 3]; 3] = core::array::from_fn(|i| {
            core::array::from_fn(|j| 3.0 * n[i] * n[j] + if i == j { 2.0 } else { 0.0 })
        });
        let (mut moments, _) = principal_axes(&inertia);
        moments.sort_by(f64::total_cmp);
        assert!((moments[0] - 2.0).abs() < 4e-15 && (moments[1] - moments[0]).abs() < 8e-15);
        assert!((moments[2] - 5.0).abs() < 4e-15);
    }

    #[test]
    fn an_inertia_that_is_not_finite_has_no_moments() {
        let (moments, _) =
            principal_axes(&[[1.0, 0.0, 0.0], [f64::NAN, 1.0, 0.0], [0.0, 0.0, 1.0]]);
        assert!(moments.iter().all(|moment| moment.is_nan()));
    }

    #[test]
    fn diagonal_inertias_keep_their_axes() {
        let (moments, axes) = principal_axes(&[[3.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 2.5]]);
        assert_eq!(moments, [3.0, 1.0, 2.5]);
        assert!(axes.is_none());
    }
}
