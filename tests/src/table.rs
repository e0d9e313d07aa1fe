//! Values of generated functions by name and place.

use mbs_macros_core::dag::Place;
use mbs_runtime::nalgebra::SMatrix;
use std::collections::{BTreeMap, BTreeSet};

/// Function, argument that receives the value, and indices in it.
pub type Key = (&'static str, &'static str, [usize; 3]);

/// Values by place. Structural zeros may be absent.
#[derive(Debug, Clone, Default)]
pub struct Table {
    values: BTreeMap<Key, f64>,
}

impl Table {
    /// Stores a value.
    pub fn insert(&mut self, key: Key, value: f64) {
        let before = self.values.insert(key, value);
        assert!(before.is_none(), "{key:?} is written twice");
    }

    /// Stores a vector.
    pub fn vector(&mut self, function: &'static str, sink: &'static str, values: &[f64]) {
        for (i, &value) in values.iter().enumerate() {
            self.insert((function, sink, [i, 0, 0]), value);
        }
    }

    /// Stores a matrix by its rows, which are the columns of `rows`.
    pub fn rows<const N: usize, const R: usize>(
        &mut self,
        function: &'static str,
        sink: &'static str,
        rows: &SMatrix<f64, N, R>,
    ) {
        for (i, row) in rows.column_iter().enumerate() {
            for (j, &value) in row.iter().enumerate() {
                self.insert((function, sink, [i, j, 0]), value);
            }
        }
    }

    /// What a function writes to one of its arguments, by place.
    pub fn of(&self, function: &str, sink: &str) -> Vec<([usize; 3], f64)> {
        let keys = self.values.iter();
        keys.filter(|(key, _)| key.0 == function && key.1 == sink)
            .map(|(key, &value)| (key.2, value))
            .collect()
    }

    /// The functions of which there are values.
    pub fn functions(&self) -> BTreeSet<&'static str> {
        self.values.keys().map(|key| key.0).collect()
    }

    /// The places at which this table differs from another by more than `relative` times the largest value of the same
    /// function and sink (with `each_by_itself`: times the value itself). A function that is in only one of the two is
    /// not compared.
    pub fn differences(&self, other: &Table, relative: f64, each_by_itself: bool) -> Vec<String> {
        let mut sizes: BTreeMap<(&str, &str), f64> = BTreeMap::new();
        for (key, value) in self.values.iter().chain(&other.values) {
            let size = sizes.entry((key.0, key.1)).or_default();
            *size = size.max(value.abs());
        }
        let mut keys: Vec<Key> = self
            .values
            .keys()
            .chain(other.values.keys())
            .copied()
            .collect();
        keys.sort_unstable();
        keys.dedup();
        let (ours, theirs) = (self.functions(), other.functions());
        keys.retain(|key| ours.contains(key.0) && theirs.contains(key.0));
        let get = |table: &Table, key: &Key| table.values.get(key).copied().unwrap_or(0.0);
        keys.iter()
            .filter_map(|key| {
                let (a, b) = (get(self, key), get(other, key));
                let size = if each_by_itself {
                    a.abs().max(b.abs())
                } else {
                    sizes[&(key.0, key.1)]
                };
                let equal = (a - b).abs() <= relative * size;
                (!equal).then(|| format!("{key:?}: {a:e} against {b:e}"))
            })
            .collect()
    }
}

/// The indices of a place in an output argument.
pub fn indices(place: Place) -> [usize; 3] {
    match place {
        Place::Value => [0; 3],
        Place::Element(i) | Place::Constant(i) => [i, 0, 0],
        Place::Entry(i, j) => [i, j, 0],
        Place::Tensor(i, j, k) => [i, j, k],
    }
}
