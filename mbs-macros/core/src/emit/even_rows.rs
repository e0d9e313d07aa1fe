//! Rows of a table that grow by even steps, as a number of rows, the first one, and the steps.
//!
//! In a grid the joints along a line are such rows. Tables with a row for each joint are longer than the second-level cache
//! of a processor where there are some hundred joints.

/// Rows that follow each other by the same steps.
struct EvenRows<'a> {
    count: usize,
    first: &'a [u32],
    /// What is added to each place, modulo 2³².
    steps: Vec<u32>,
}

/// The most rows: their number is one word.
const MOST: usize = u16::MAX as usize;

/// The rows in groups, each as long as possible.
fn grouped(rows: &[Vec<u32>]) -> Vec<EvenRows<'_>> {
    let mut groups = Vec::new();
    let mut from = 0;
    while let Some(first) = rows.get(from) {
        let steps = match rows.get(from + 1) {
            Some(second) => steps(first, second),
            None => vec![0; first.len()],
        };
        let pairs = rows[from..].windows(2).take(MOST - 1);
        let count = 1 + pairs
            .take_while(|pair| is_followed(&pair[0], &pair[1], &steps))
            .count();
        groups.push(EvenRows {
            count,
            first,
            steps,
        });
        from += count;
    }
    groups
}

fn steps(row: &[u32], next: &[u32]) -> Vec<u32> {
    let pairs = row.iter().zip(next);
    pairs.map(|(now, next)| next.wrapping_sub(*now)).collect()
}

fn is_followed(row: &[u32], next: &[u32], steps: &[u32]) -> bool {
    let mut sums = row.iter().zip(steps).zip(next);
    sums.all(|((now, step), next)| now.wrapping_add(*step) == *next)
}

/// Whether tables of such groups are at most half as long as those of the rows.
pub(super) fn pays<'a>(runs: impl Iterator<Item = &'a [Vec<u32>]>) -> bool {
    let (mut whole, mut even) = (0, 0);
    for rows in runs.filter(|rows| rows.len() > 1) {
        let width = rows[0].len();
        whole += rows.len() * width;
        even += grouped(rows).len() * (1 + 2 * width);
    }
    2 * even < whole
}

/// The words of such groups, one after the other.
pub(super) fn words(rows: &[Vec<u32>]) -> Vec<u32> {
    let mut words = Vec::new();
    for group in grouped(rows) {
        words.push(group.count as u32);
        words.extend(group.first);
        words.extend(group.steps);
    }
    words
}
