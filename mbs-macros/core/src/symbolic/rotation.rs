//! Entries of a rotation matrix from the unit quaternion that is stored.

use super::{Expr, Graph};

/// R = 1 + 2 w [r] + 2 [r]², entry by entry: the products of components (w, x, y, z) whose sum, doubled, is the entry,
/// less the identity.
const PRODUCTS: [[(usize, usize, f64); 2]; 9] = [
    [(2, 2, -1.0), (3, 3, -1.0)],
    [(1, 2, 1.0), (0, 3, -1.0)],
    [(1, 3, 1.0), (0, 2, 1.0)],
    [(1, 2, 1.0), (0, 3, 1.0)],
    [(1, 1, -1.0), (3, 3, -1.0)],
    [(2, 3, 1.0), (0, 1, -1.0)],
    [(1, 3, 1.0), (0, 2, -1.0)],
    [(2, 3, 1.0), (0, 1, 1.0)],
    [(1, 1, -1.0), (2, 2, -1.0)],
];

fn identity(entry: u8) -> f64 {
    if entry.is_multiple_of(4) { 1.0 } else { 0.0 }
}

/// Entry 3 row + column of the rotation matrix of a unit quaternion (w, x, y, z).
pub fn rotation_entry(quaternion: [f64; 4], entry: u8) -> f64 {
    let products = PRODUCTS[usize::from(entry)];
    let terms = products.map(|(i, j, sign)| sign * quaternion[i] * quaternion[j]);
    identity(entry) + 2.0 * (terms[0] + terms[1])
}

impl Graph {
    /// The same as an expression of the quaternion's components.
    pub fn rotation_entry(&mut self, quaternion: [Expr; 4], entry: u8) -> Expr {
        let terms = PRODUCTS[usize::from(entry)]
            .map(|(i, j, sign)| (self.mul(quaternion[i], quaternion[j]), 2.0 * sign));
        self.linear(identity(entry), &terms)
    }
}
