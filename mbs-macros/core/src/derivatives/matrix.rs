//! Sparse matrices of expressions.

use crate::symbolic::Expr;
use std::collections::BTreeMap;

/// A sparse matrix of expressions, in row order.
pub type Matrix = BTreeMap<(usize, usize), Expr>;
