//! Which arguments, values and results each use of a part has.

use super::{Array, FEWEST, Loops, Member, Spot};
use crate::dag::{Operand, Output, Place};
use crate::emit::body::source;
use crate::emit::copies::element;

/// The values that are left, by number in the order in which they are left.
struct Values {
    /// The last one of each place.
    last: Vec<usize>,
    is_read: Vec<bool>,
}

impl Values {
    fn read(&mut self, place: usize) {
        if let Some(is_read) = self.is_read.get_mut(self.last[place]) {
            *is_read = true;
        }
    }
}

impl<'p> Loops<'p> {
    /// Constants are fields, which a loop cannot count: they are copied to the array, and so are numbers of few members.
    /// `None` if a result is an argument, too.
    pub(super) fn find_inputs(&mut self, outputs: &[(Output, usize)]) -> Option<()> {
        let mut uses = vec![0; self.parts.places];
        let rows = self.parts.rows().flat_map(|(_, rows)| rows).flatten();
        rows.for_each(|&place| uses[place as usize] += 1);
        outputs.iter().for_each(|&(_, place)| uses[place] += 1);
        let mut sinks: Vec<&str> = outputs.iter().map(|(output, _)| output.sink).collect();
        sinks.dedup();
        for (place, &input) in self.parts.inputs.iter().enumerate() {
            let text = source(self.graph, input);
            let spot = match (input, element(&text)) {
                (Operand::Symbol(_), Some((name, index))) => {
                    // A kernel overwrites x.
                    if name == "x" || sinks.contains(&name) {
                        return None;
                    }
                    let array = self.array(Array::Argument(name.to_owned()));
                    Spot {
                        array,
                        at: [index, 0, 0],
                    }
                }
                (Operand::Symbol(_), None) => Spot {
                    array: self.array(Array::Common(text)),
                    at: [0; 3],
                },
                (Operand::Number(_), _) if uses[place] >= FEWEST => Spot {
                    array: self.array(Array::Common(text)),
                    at: [0; 3],
                },
                _ => self.value(place),
            };
            self.inputs.push(spot);
        }
        Some(())
    }

    fn read(&mut self, place: usize) -> Spot {
        match self.inputs.get(place) {
            Some(&spot) => spot,
            None => self.value(place),
        }
    }

    /// The members in the order in which they are computed, and where each run of them ends.
    pub(super) fn find_members(&mut self, outputs: &[(Output, usize)]) -> Vec<usize> {
        let values = self.values(outputs);
        let mut results: Vec<Vec<Output>> = vec![Vec::new(); self.parts.places];
        let mut given = Vec::new();
        for &(output, place) in outputs {
            match output.place {
                Place::Value | Place::Constant(_) => {}
                _ if place < self.parts.inputs.len() => given.push((output, place)),
                _ => results[place].push(output),
            }
        }
        let (mut ends, mut value) = (Vec::new(), 0);
        for (shape, rows) in self.parts.rows() {
            let columns = rows.first().map_or(0, |row| self.split(shape, row).0.len());
            let numbers = (0..columns).map(|column| self.numbers(rows, column));
            let numbers: Vec<Option<usize>> = numbers.collect();
            for (index, row) in rows.iter().enumerate() {
                let (reads, leaves) = self.split(shape, row);
                let mut member = Member {
                    shape: Some(shape),
                    spots: Vec::with_capacity(row.len()),
                    goes: Vec::with_capacity(leaves.len()),
                };
                for (&place, numbers) in reads.iter().zip(&numbers) {
                    member.spots.push(match *numbers {
                        Some(array) => Spot {
                            array,
                            at: [index, 0, 0],
                        },
                        None => self.read(place as usize),
                    });
                }
                for place in leaves.iter().map(|&place| place as usize) {
                    let before = member.spots.len();
                    let results: &[Output] = match values.last[place] == value {
                        true => results[place].as_slice(),
                        false => &[],
                    };
                    if values.is_read[value] || results.len() > 1 {
                        member.spots.push(self.value(place));
                    }
                    let results = results.iter().map(|output| self.result(output));
                    member.spots.extend(results);
                    member.goes.push(member.spots.len() - before);
                    value += 1;
                }
                self.members.push(member);
            }
            ends.push(self.members.len());
        }
        for (output, place) in given {
            let spots = vec![self.read(place), self.result(&output)];
            self.members.push(Member {
                shape: None,
                spots,
                goes: vec![1],
            });
        }
        ends.push(self.members.len());
        ends
    }

    /// What a row of a shape reads, and what it leaves.
    fn split(&self, shape: usize, row: &'p [u32]) -> (&'p [u32], &'p [u32]) {
        row.split_at(row.len() - self.parts.shapes[shape].function.outputs.len())
    }

    /// Which of the values that are left in places something reads: places are used again.
    fn values(&self, outputs: &[(Output, usize)]) -> Values {
        let mut values = Values {
            last: vec![usize::MAX; self.parts.places],
            is_read: Vec::new(),
        };
        for (shape, rows) in self.parts.rows() {
            for row in rows {
                let (reads, leaves) = self.split(shape, row);
                reads.iter().for_each(|&place| values.read(place as usize));
                for &place in leaves {
                    values.last[place as usize] = values.is_read.len();
                    values.is_read.push(false);
                }
            }
        }
        let returned = outputs.iter();
        let returned = returned.filter(|(output, _)| matches!(output.place, Place::Value));
        returned.for_each(|&(_, place)| values.read(place));
        values
    }

    /// What the rows read in a column, if these are numbers that are not all the same.
    fn numbers(&mut self, rows: &[Vec<u32>], column: usize) -> Option<usize> {
        let inputs = &self.parts.inputs;
        let numbers = rows
            .iter()
            .map(|row| match inputs.get(row[column] as usize) {
                Some(Operand::Number(number)) => Some(number.value().to_bits()),
                _ => None,
            });
        let numbers: Vec<u64> = numbers.collect::<Option<_>>()?;
        let differ = numbers.iter().any(|number| *number != numbers[0]);
        (differ && numbers.len() >= FEWEST).then(|| self.array(Array::Numbers(numbers)))
    }

    fn result(&mut self, output: &Output) -> Spot {
        let (count, at) = match output.place {
            Place::Value | Place::Constant(_) => (0, [0; 3]),
            Place::Element(i) => (1, [i, 0, 0]),
            Place::Entry(i, j) => (2, [i, j, 0]),
            Place::Tensor(i, j, k) => (3, [i, j, k]),
        };
        let array = self.array(Array::Result(output.sink, count));
        Spot { array, at }
    }
}
