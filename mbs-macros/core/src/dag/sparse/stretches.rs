//! Columns that repeat: a chain of equal links is eliminated link by link, by the same code. Where it is eliminated from both
//! ends, a turn of the loop takes a link of each: the processor computes one while the other waits.

use super::Elimination;
use std::collections::HashMap;
use std::ops::Range;

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
    /// Whether the next stretch, which comes as often, is in the same loop.
    pub joined: bool,
}

/// Whether a column belongs to a row, and what is below its pivot, seen from the column itself.
type Outline = (bool, Vec<(usize, bool)>);

/// Splits the columns into stretches, in an order in which each column comes after those that it depends on.
pub(super) fn find(elimination: &Elimination) -> Vec<Stretch> {
    let count = elimination.columns.len();
    let shapes = shapes(elimination);
    let Some([a, b]) = halves(elimination) else {
        return of(&shapes, 0..count);
    };
    let mut all = of(&shapes, 0..a.start);
    let (first, second) = (of(&shapes, a), of(&shapes, b.clone()));
    all.extend(in_turns(elimination, first, second));
    all.extend(of(&shapes, b.end..count));
    all
}

/// The stretches of a range of columns: at each column the longest loop that begins there.
fn of(shapes: &[usize], range: Range<usize>) -> Vec<Stretch> {
    let mut stretches: Vec<Stretch> = Vec::new();
    let mut first = range.start;
    while first < range.end {
        let mut best = Stretch {
            first,
            period: 1,
            times: 1,
            joined: false,
        };
        for period in 1..=LONGEST.min(range.end - first) {
            let group = &shapes[first..first + period];
            let next = shapes[first..range.end].chunks(period);
            let times = next.take_while(|next| *next == group).count();
            if times >= FEWEST && period * times > best.period * best.times {
                best = Stretch {
                    period,
                    times,
                    ..best
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

/// The two largest branches that meet in one column, one directly after the other.
fn halves(elimination: &Elimination) -> Option<[Range<usize>; 2]> {
    let columns = &elimination.columns;
    let mut sizes = vec![1; columns.len()];
    let mut branches: Vec<Vec<usize>> = vec![Vec::new(); columns.len()];
    for (position, column) in columns.iter().enumerate() {
        if let Some(&(next, _)) = column.below.first() {
            sizes[next] += sizes[position];
            branches[next].push(position);
        }
    }
    let mut at = columns.len().checked_sub(1)?;
    loop {
        let own = &mut branches[at];
        own.sort_by_key(|&branch| std::cmp::Reverse(sizes[branch]));
        match *own.as_slice() {
            [a, b, ..] if 2 * sizes[b] > sizes[a] => {
                let range = |end: usize| end + 1 - sizes[end]..end + 1;
                let [a, b] = [range(a.min(b)), range(a.max(b))];
                return (a.end == b.start).then_some([a, b]);
            }
            [a, ..] => at = a,
            [] => return None,
        }
    }
}

/// The stretches of two branches, with the longest loops of both as one.
fn in_turns(
    elimination: &Elimination,
    mut first: Vec<Stretch>,
    mut second: Vec<Stretch>,
) -> Vec<Stretch> {
    let longest = |list: &[Stretch]| {
        let loops = (0..list.len()).filter(|&i| list[i].times > 1);
        loops.max_by_key(|&i| list[i].period * list[i].times)
    };
    let (Some(i), Some(j)) = (longest(&first), longest(&second)) else {
        first.extend(second);
        return first;
    };
    let (mut after, mut last) = (first.split_off(i + 1), second.split_off(j + 1));
    let (a, b) = (first[i], second[j]);
    let times = a.times.min(b.times);
    let end = reach(elimination, &a) + (times - 1) * a.period;
    if end >= b.first || times < FEWEST {
        first.append(&mut after);
        first.append(&mut second);
        first.append(&mut last);
        return first;
    }
    let rest = |stretch: Stretch| Stretch {
        first: stretch.first + times * stretch.period,
        times: stretch.times - times,
        ..stretch
    };
    let rests = [rest(a), rest(b)];
    let mut all: Vec<Stretch> = first.drain(..i).chain(second.drain(..j)).collect();
    all.push(Stretch {
        times,
        joined: true,
        ..a
    });
    all.push(Stretch { times, ..b });
    all.extend(rests.into_iter().filter(|rest| rest.times > 0));
    all.append(&mut after);
    all.append(&mut last);
    all
}

/// The last position that the first turn of a loop touches.
fn reach(elimination: &Elimination, stretch: &Stretch) -> usize {
    let columns = &elimination.columns[stretch.first..stretch.first + stretch.period];
    let below = columns.iter().filter_map(|column| column.below.last());
    let farthest = below.map(|&(position, _)| position).max();
    farthest
        .unwrap_or(0)
        .max(stretch.first + stretch.period - 1)
}

/// A number for each column, the same for columns with the same code.
fn shapes(elimination: &Elimination) -> Vec<usize> {
    let count = elimination.columns.len();
    let outlines: Vec<Outline> = (0..count)
        .map(|position| outline(elimination, position))
        .collect();
    let mut alike: HashMap<&Outline, Vec<usize>> = HashMap::new();
    for (position, outline) in outlines.iter().enumerate() {
        alike.entry(outline).or_default().push(position);
    }
    let mut shapes = vec![0; count];
    let mut next = 0;
    for positions in alike.into_values() {
        // The targets of a long column are many; they are not needed where no other column has its outline.
        if let [position] = positions[..] {
            shapes[position] = next;
            next += 1;
            continue;
        }
        let mut known: HashMap<Vec<usize>, usize> = HashMap::new();
        for position in positions {
            let shape = *known.entry(targets(elimination, position)).or_insert(next);
            next = next.max(shape + 1);
            shapes[position] = shape;
        }
    }
    shapes
}

fn outline(elimination: &Elimination, position: usize) -> Outline {
    let column = &elimination.columns[position];
    let below = column.below.iter();
    let below = below.map(|&(i, is_row)| (i - position, is_row));
    (column.is_row, below.collect())
}

/// Where the products of two entries of a column go, seen from its pivot.
fn targets(elimination: &Elimination, position: usize) -> Vec<usize> {
    let column = &elimination.columns[position];
    let below = &column.below;
    let pairs = below
        .iter()
        .enumerate()
        .flat_map(|(place, &(i, _))| below[..=place].iter().map(move |&(j, _)| (i, j)));
    pairs
        .map(|(i, j)| elimination.slot(i, j) - column.pivot)
        .collect()
}
