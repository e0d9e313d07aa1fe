//! The entries of a generated matrix, in the order in which its function writes them.
//!
//! The function writes each structural nonzero once and always in the same order ([`MatrixSink`]): the first call tells
//! where the entries stand, each further call only their values.

use crate::MatrixSink;
use std::slice::IterMut;

/// Learns where a function writes.
#[derive(Default)]
pub(crate) struct Recorder(Vec<(usize, usize)>);

impl MatrixSink for Recorder {
    fn set(&mut self, row: usize, column: usize, _: f64) {
        self.0.push((row, column));
    }
}

/// Places and values.
#[derive(Clone)]
pub(crate) struct Entries {
    /// Row and column of each entry.
    pub(crate) places: Vec<(usize, usize)>,
    pub(crate) values: Vec<f64>,
}

impl Entries {
    /// The places that a function has written to, with values of zero.
    pub(crate) fn of(recorder: Recorder) -> Entries {
        let values = vec![0.0; recorder.0.len()];
        Entries {
            places: recorder.0,
            values,
        }
    }

    /// Takes new values from the function that was recorded.
    pub(crate) fn sink(&mut self) -> Values<'_> {
        Values(self.values.iter_mut())
    }

    /// Row, column and value of each entry.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (usize, usize, f64)> + '_ {
        let entries = self.places.iter().zip(&self.values);
        entries.map(|(&(row, column), &value)| (row, column, value))
    }
}

/// Receives the values of [`Entries`].
pub(crate) struct Values<'a>(IterMut<'a, f64>);

impl MatrixSink for Values<'_> {
    #[inline(always)]
    fn set(&mut self, _: usize, _: usize, value: f64) {
        if let Some(place) = self.0.next() {
            *place = value;
        }
    }
}
