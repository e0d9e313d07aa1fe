//! Principal axes of an inertia tensor.

/// Sweeps of Jacobi's method: it converges quadratically, six reach round-off for every 3 × 3 matrix.
const SWEEPS: usize = 12;

/// Principal moments; and the principal axes as columns and as a unit quaternion (w, x, y, z), where they are not the
/// given axes. By Jacobi's method; the lower triangle is read.
pub(super) fn principal_axes(
    inertia: &[[f64; 3]; 3],
) -> ([f64; 3], Option<([[f64; 3]; 3], [f64; 4])>) {
    let mut a = *inertia;
    (a[0][1], a[0][2], a[1][2]) = (a[1][0], a[2][0], a[2][1]);
    let diagonal = [a[0][0], a[1][1], a[2][2]];
    let size = diagonal.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    let negligible = |a: &[[f64; 3]; 3], part: f64| {
        [a[1][0], a[2][0], a[2][1]]
            .iter()
            .all(|x| x.abs() <= part * size)
    };
    if negligible(&a, 0.0) {
        return (diagonal, None);
    }
    let mut axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for _ in 0..SWEEPS {
        if negligible(&a, 1e-18) {
            break;
        }
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            rotate(&mut a, &mut axes, p, q);
        }
    }
    ([a[0][0], a[1][1], a[2][2]], Some((axes, quaternion(&axes))))
}

/// One rotation in the plane of p and q, by less than 45°, that clears their product of inertia.
fn rotate(a: &mut [[f64; 3]; 3], axes: &mut [[f64; 3]; 3], p: usize, q: usize) {
    if a[p][q] == 0.0 {
        return;
    }
    let ratio = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
    let tangent = ratio.signum() / (ratio.abs() + (ratio * ratio + 1.0).sqrt());
    let cosine = 1.0 / (tangent * tangent + 1.0).sqrt();
    let sine = tangent * cosine;
    for row in [&mut *a, axes].into_iter().flatten() {
        (row[p], row[q]) = (
            cosine * row[p] - sine * row[q],
            sine * row[p] + cosine * row[q],
        );
    }
    for k in 0..3 {
        (a[p][k], a[q][k]) = (
            cosine * a[p][k] - sine * a[q][k],
            sine * a[p][k] + cosine * a[q][k],
        );
    }
}

/// The unit quaternion of a proper rotation, by its largest component.
fn quaternion(r: &[[f64; 3]; 3]) -> [f64; 4] {
    let squares = [
        1.0 + r[0][0] + r[1][1] + r[2][2],
        1.0 + r[0][0] - r[1][1] - r[2][2],
        1.0 - r[0][0] + r[1][1] - r[2][2],
        1.0 - r[0][0] - r[1][1] + r[2][2],
    ];
    let (x, y, z) = (r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]);
    let (xy, xz, yz) = (r[1][0] + r[0][1], r[0][2] + r[2][0], r[2][1] + r[1][2]);
    let rows = [
        [squares[0], x, y, z],
        [x, squares[1], xy, xz],
        [y, xy, squares[2], yz],
        [z, xz, yz, squares[3]],
    ];
    let largest = (1..4).fold(
        0,
        |best, i| if squares[i] > squares[best] { i } else { best },
    );
    super::rotation::normalised(rows[largest])
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
    fn diagonal_inertias_keep_their_axes() {
        let (moments, axes) = principal_axes(&[[3.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 2.5]]);
        assert_eq!(moments, [3.0, 1.0, 2.5]);
        assert!(axes.is_none());
    }
}
