//! Which places of a row a table has.
//!
//! Places that have the same distance from each other in all rows, as the entries of a quaternion or the values that a part
//! leaves, need one word: the lowest of them, from which the code counts the others.

/// The places beyond the last one that the words of a table can name. Code that counts up to here from such a place stays
/// within an array that is longer by this number, so that no index needs a check.
pub(super) const BEYOND: usize = 64;

/// The columns of rows of places.
#[derive(Clone, PartialEq, Eq, Hash)]
pub(super) struct RowLayout {
    /// For each column the word that it is counted from, and its distance.
    pub(super) columns: Vec<(usize, usize)>,
    /// The columns that are words.
    bases: Vec<usize>,
}

impl RowLayout {
    pub(super) fn of(rows: &[Vec<u32>]) -> RowLayout {
        let Some(first) = rows.first() else {
            return RowLayout {
                columns: Vec::new(),
                bases: Vec::new(),
            };
        };
        let mut ascending: Vec<usize> = (0..first.len()).collect();
        ascending.sort_by_key(|&column| first[column]);
        let mut bases: Vec<usize> = Vec::new();
        let mut of = vec![0; first.len()];
        for column in ascending {
            let is_counted_from = |base: &usize| {
                let distance = first[column] - first[*base];
                let keeps = |row: &Vec<u32>| row[column].wrapping_sub(row[*base]) == distance;
                (distance as usize) < BEYOND && rows.iter().all(keeps)
            };
            of[column] = bases.iter().rposition(is_counted_from).unwrap_or_else(|| {
                bases.push(column);
                bases.len() - 1
            });
        }
        let distance = |(column, &base): (usize, &usize)| {
            let distance = first[column] - first[bases[base]];
            (base, distance as usize)
        };
        RowLayout {
            columns: of.iter().enumerate().map(distance).collect(),
            bases,
        }
    }

    /// The number of words of a row.
    pub(super) fn width(&self) -> usize {
        self.bases.len()
    }

    /// The words of a row.
    pub(super) fn words(&self, row: &[u32]) -> impl Iterator<Item = u32> {
        self.bases.iter().map(|&column| row[column])
    }
}
