//! Entries in other units, while they are written.

use mbs_runtime::{MatrixSink, TensorSink};

/// Multiplies each entry by what its place asks for.
pub(super) struct Sink<'a, T, F> {
    pub sink: &'a mut T,
    pub factor: F,
}

impl<T: MatrixSink, F: Fn(usize, usize) -> f64> MatrixSink for Sink<'_, T, F> {
    fn set(&mut self, row: usize, column: usize, value: f64) {
        let factor = (self.factor)(row, column);
        self.sink.set(row, column, factor * value);
    }
}

impl<T: TensorSink, F: Fn(usize, usize, usize) -> f64> TensorSink for Sink<'_, T, F> {
    fn set(&mut self, i: usize, j: usize, k: usize, value: f64) {
        let factor = (self.factor)(i, j, k);
        self.sink.set(i, j, k, factor * value);
    }
}
