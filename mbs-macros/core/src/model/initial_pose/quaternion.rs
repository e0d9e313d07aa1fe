//! The unit quaternion of an orientation.

use crate::model::geometry::Axes;
use crate::model::resolver::Resolver;
use crate::symbolic::{Expr, Function, Graph};

/// The unit quaternion (w, x, y, z) of axes in parameters.
///
/// Of the four usual formulas, each of which divides by twice one component, the one is taken whose component is largest
/// with default parameters.
pub(super) fn quaternion(resolver: &mut Resolver, axes: &Axes) -> [Expr; 4] {
    // m[row][column]
    let m: [[Expr; 3]; 3] = std::array::from_fn(|row| std::array::from_fn(|k| axes[k][row]));
    let trace = |signs: [f64; 3], graph: &mut Graph| {
        let terms: Vec<_> = (0..3).map(|k| (m[k][k], signs[k])).collect();
        graph.linear(1.0, &terms)
    };
    const SIGNS: [[f64; 3]; 4] = [
        [1.0, 1.0, 1.0],
        [1.0, -1.0, -1.0],
        [-1.0, 1.0, -1.0],
        [-1.0, -1.0, 1.0],
    ];
    // 4 × the square of each component.
    let squares = SIGNS.map(|signs| trace(signs, &mut resolver.graph));
    let sizes = squares.map(|square| resolver.by_default(square));
    let largest = (0..4).fold(0, |best, k| if sizes[k] > sizes[best] { k } else { best });
    let graph = &mut resolver.graph;
    let root = graph.function(Function::Sqrt, squares[largest]);
    let half = graph.constant(0.5);
    let inverse = graph.div(half, root);
    let mut off = |a: (usize, usize), sign: f64, b: (usize, usize)| {
        let sum = graph.linear(0.0, &[(m[a.0][a.1], 1.0), (m[b.0][b.1], sign)]);
        graph.mul(sum, inverse)
    };
    // 4 w x = m21 − m12 and so on, 4 x y = m10 + m01 and so on.
    let (wx, wy, wz) = (
        off((2, 1), -1.0, (1, 2)),
        off((0, 2), -1.0, (2, 0)),
        off((1, 0), -1.0, (0, 1)),
    );
    let (xy, yz, zx) = (
        off((1, 0), 1.0, (0, 1)),
        off((2, 1), 1.0, (1, 2)),
        off((0, 2), 1.0, (2, 0)),
    );
    let own = graph.scale(0.5, root);
    match largest {
        0 => [own, wx, wy, wz],
        1 => [wx, own, xy, zx],
        2 => [wy, xy, own, yz],
        _ => [wz, zx, yz, own],
    }
}
