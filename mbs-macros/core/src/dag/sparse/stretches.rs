//! Columns that repeat: a chain of equal links is eliminated link by link, by the same code.

use super::Elimination;

/// Longest group of columns that is looked for.
const LONGEST: usize = 32;
/// With fewer repetitions a loop has no advantage.
const FEWEST: usize = 3;

/// Columns that follow each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Stretch {
    /// The first column.
    pub first: usize,
    /// Columns of a group.
    pub period: usize,
    /// How often the group comes, each time at the same distances in all arrays.
    pub times: usize,
}

/// What the code of a column depends on, seen from the column itself.
#[derive(PartialEq)]
struct Shape {
    is_row: bool,
    below: Vec<(usize, bool)>,
    targets: Vec<usize>,
}

/// Splits the columns into stretches: at each column the longest loop that begins there.
pub(super) fn find(elimination: &Elimination) -> Vec<Stretch> {
    let shapes: Vec<Shape> = (0..elimination.columns.len())
        .map(|position| shape(elimination, position))
        .collect();
    let mut stretches: Vec<Stretch> = Vec::new();
    let mut first = 0;
    while first < shapes.len() {
        let mut best = Stretch {
            first,
            period: 1,
            times: 1,
        };
        for period in 1..=LONGEST.min(shapes.len() - first) {
            let group = &shapes[first..first + period];
            let next = shapes[first..].chunks(period);
            let times = next.take_while(|next| *next == group).count();
            if times >= FEWEST && period * times > best.period * best.times {
                best = Stretch {
                    first,
                    period,
                    times,
                };
            }
        }
        first += best.period * best.times;
        match stretches.last_mut() {
            Some(last) if last.times == 1 && best.times == 1 => last.period += 1,
            _ => stretches.push(best),
        }
    }
    stretches
}

fn shape(elimination: &Elimination, position: usize) -> Shape {
    let column = &elimination.columns[position];
    let below = &column.below;
    let pairs = below
        .iter()
        .enumerate()
        .flat_map(|(place, &(i, _))| below[..=place].iter().map(move |&(j, _)| (i, j)));
    Shape {
        is_row: column.is_row,
        below: below
            .iter()
            .map(|&(i, is_row)| (i - position, is_row))
            .collect(),
        targets: pairs
            .map(|(i, j)| elimination.slot(i, j) - column.pivot)
            .collect(),
    }
}
