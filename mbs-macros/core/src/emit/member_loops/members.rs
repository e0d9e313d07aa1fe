//! Which arguments, values and results each use of a part has.

use super::{Array, FEWEST, Loops, Member, Spot};
use crate::dag::{Operand, Output, Place};
use crate::emit::body::source;
use crate::emit::copies::element;

impl<'p> Loops<'p> {
    /// Constants are fields, which a loop cannot count: they are copied to the array, and so are numbers of few members.
    /// `None` if a result is an argument, too.
    pub(super) fn find_inputs(&mut self, outputs: &[(Output, usize)]) -> Option<()> {
        let mut uses = vec![0; self.parts.places];
        let rows = self.parts.rows().flat_map(|(_, rows)| rows).flatten();
        rows.for_each(|&place| uses[place as usize] += 1);
        outputs.iter().for_each(|&(_, place)| uses[place] += 1);
        for (place, &input) in self.parts.inputs.iter().enumerate() {
            let text = source(self.graph, input);
            let spot = match (input, element(&text)) {
                (Operand::Symbol(_), Some((name, index))) => {
                    if name == "x" || outputs.iter().any(|(output, _)| output.sink == name) {
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
        let parts = self.parts;
        let split = |shape: usize, row: &'p [u32]| {
            row.split_at(row.len() - parts.shapes[shape].function.outputs.len())
        };
        // Places are used again: of each the value that it has, by the number of that value.
        let mut has = vec![usize::MAX; parts.places];
        let mut is_read = Vec::new();
        for (shape, rows) in parts.rows() {
            for row in rows {
                let (reads, leaves) = split(shape, row);
                for value in reads.iter().map(|&place| has[place as usize]) {
                    if let Some(is_read) = is_read.get_mut(value) {
                        *is_read = true;
                    }
                }
                for &place in leaves {
                    has[place as usize] = is_read.len();
                    is_read.push(false);
                }
            }
        }
        let mut results: Vec<Vec<Output>> = vec![Vec::new(); parts.places];
        let mut given = Vec::new();
        for &(output, place) in outputs {
            match output.place {
                Place::Value | Place::Constant(_) => {
                    if let Some(is_read) = is_read.get_mut(has[place]) {
                        *is_read = true;
                    }
                }
                _ if place < parts.inputs.len() => given.push((output, place)),
                _ => results[place].push(output),
            }
        }
        let (mut ends, mut value) = (Vec::new(), 0);
        for (shape, rows) in parts.rows() {
            let numbers: Vec<Option<usize>> = match rows.first() {
                Some(row) => (0..split(shape, row).0.len())
                    .map(|column| self.numbers(rows, column))
                    .collect(),
                None => Vec::new(),
            };
            for (member, row) in rows.iter().enumerate() {
                let (reads, leaves) = split(shape, row);
                let mut spots: Vec<Spot> = Vec::with_capacity(row.len());
                spots.extend(
                    reads
                        .iter()
                        .zip(&numbers)
                        .map(|(&place, numbers)| match *numbers {
                            Some(array) => Spot {
                                array,
                                at: [member, 0, 0],
                            },
                            None => self.read(place as usize),
                        }),
                );
                let mut goes = Vec::with_capacity(leaves.len());
                for place in leaves.iter().map(|&place| place as usize) {
                    let before = spots.len();
                    let results: &[Output] = match has[place] == value {
                        true => results[place].as_slice(),
                        false => &[],
                    };
                    if is_read[value] || results.len() > 1 {
                        spots.push(self.value(place));
                    }
                    spots.extend(results.iter().map(|output| self.result(output)));
                    goes.push(spots.len() - before);
                    value += 1;
                }
                self.members.push(Member {
                    shape: Some(shape),
                    spots,
                    goes,
                });
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
