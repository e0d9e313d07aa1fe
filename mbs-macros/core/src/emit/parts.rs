//! Long functions: one function for each shape of their parts, and for each long function a table of which parts are
//! computed with which values.
//!
//! A table is a list of words: for each run the index of its part, the length of its rows (two words, the lower first),
//! and the rows, which are [places of values](row_layout). Its words are literals. A string of bytes is shorter, but the constant
//! function that reads it made a chain of 40 joints take rustc a fifth longer. Rows that grow by even steps, as those of a grid,
//! were tried as a first row and steps: tables are shorter, and a step of 20 × 20 bodies on bushings takes 1.3 times as long.

use super::body::{Body, source};
use super::copies::copies;
use super::long_array;
use super::member_loops;
use super::row_layout::{BEYOND, RowLayout};
use super::size::Size;
use crate::contract::{Method, Origin, Returns, Shape as Argument};
use crate::dag::{ALL_TANGENTS, Function, Operation, Output, Parts, Place, Program, of_tangents};
use crate::symbolic::{Graph, Map};
use std::cell::Cell;
use std::fmt::Write;

/// The long functions of a mechanism.
pub(super) struct LongFunctions {
    functions: Vec<(&'static str, Parts)>,
    /// For each shape of each function its number.
    numbers: Vec<Vec<usize>>,
    /// The different shapes, as (function, index).
    shapes: Vec<(usize, usize)>,
    /// For each shape of each function the words of its rows.
    layouts: Vec<Vec<RowLayout>>,
    /// For each function the number of places that words can name: a power of two, so that no index needs a check.
    lengths: Vec<usize>,
    /// Whether a method computes them by tables.
    has_tables: Vec<Cell<bool>>,
}

/// The type of the words of a table: u16, or u32 where a number does not fit.
#[derive(Clone, Copy)]
struct Word(&'static str);

impl LongFunctions {
    pub(super) fn new(program: &Program) -> LongFunctions {
        let functions: Vec<(&'static str, Parts)> = program
            .functions
            .iter()
            .filter(|function| is_from_program(function))
            .chain(&program.all_tangents)
            .filter_map(|function| Some((function.name, program.parts(function)?)))
            .collect();
        let lengths: Vec<usize> = functions
            .iter()
            .map(|(_, parts)| parts.places.next_power_of_two())
            .collect();
        let layouts: Vec<Vec<RowLayout>> = functions
            .iter()
            .map(|(_, parts)| {
                let tables = parts.shapes.iter().map(|shape| &shape.table);
                tables.map(|table| RowLayout::of(table)).collect()
            })
            .collect();
        type Code<'a> = (usize, &'a [Operation], &'a [Output], &'a RowLayout);
        let mut known: Map<Code, usize> = Map::default();
        let mut shapes = Vec::new();
        let mut numbers = Vec::new();
        for (at, (_, parts)) in functions.iter().enumerate() {
            let own = parts.shapes.iter().enumerate().map(|(index, shape)| {
                let code = &shape.function;
                if shape.table.len() == 1 {
                    shapes.push((at, index));
                    return shapes.len() - 1;
                }
                *known
                    .entry((
                        lengths[at],
                        &code.operations,
                        &code.outputs,
                        &layouts[at][index],
                    ))
                    .or_insert_with(|| {
                        shapes.push((at, index));
                        shapes.len() - 1
                    })
            });
            numbers.push(own.collect());
        }
        LongFunctions {
            numbers,
            shapes,
            layouts,
            has_tables: vec![Cell::new(false); lengths.len()],
            lengths,
            functions,
        }
    }

    /// The body of a function of the contract, if it is long.
    pub(super) fn body(&self, graph: &Graph, program: &Program, method: &Method) -> Option<String> {
        let function = program.function(method.name)?;
        match program.whole_of(function) {
            Some(whole) if whole.name == ALL_TANGENTS => {
                let own = |output: &Output| of_tangents(function, output);
                self.body_with(graph, whole, method, own)
            }
            Some(_) => call_of_whole(function).map(str::to_owned),
            None => self.body_with(graph, function, method, |output| Some(*output)),
        }
    }

    /// The body of a method that computes a function and writes its outputs, or some of them, to other places.
    pub(super) fn body_with(
        &self,
        graph: &Graph,
        function: &Function,
        method: &Method,
        place: impl Fn(&Output) -> Option<Output>,
    ) -> Option<String> {
        let mut functions = self.functions.iter();
        let at = functions.position(|(name, _)| *name == function.name)?;
        let parts = &self.functions[at].1;
        let outputs = parts.outputs.iter();
        let outputs = outputs.filter_map(|(output, value)| Some((place(output)?, *value)));
        let outputs: Vec<(Output, usize)> = outputs.collect();
        if let Some(loops) = member_loops::body(graph, parts, &outputs, method) {
            return Some(loops);
        }
        self.has_tables[at].set(true);
        let mut out = long_array::declaration(self.array(at));
        let sources = parts.inputs.iter().map(|&input| source(graph, input));
        out.push_str(&copies("values", &sources.collect::<Vec<_>>()));
        let _ = writeln!(
            out,
            "::mbs_runtime::generated::compute_parts(self, &Self::{0}_PARTS, values, Self::{0}_TABLE);",
            function.name.to_uppercase()
        );
        write_outputs(&mut out, self.lengths[at], outputs, method);
        Some(out)
    }

    /// The functions that a method computes by tables.
    fn tabled(&self) -> impl Iterator<Item = (usize, &(&'static str, Parts))> {
        let functions = self.functions.iter().enumerate();
        functions.filter(|&(at, _)| self.has_tables[at].get())
    }

    /// The functions of the parts and the tables for the methods that have been written; nothing if none needs them.
    pub(super) fn items(&self, graph: &Graph, size: &mut Size) -> String {
        if self.functions.is_empty() {
            return String::new();
        }
        let mut out = String::new();
        for (at, (name, parts)) in self.tabled() {
            // Each function has its own list: a program that does not call the function does not compile its parts.
            let (list, length, word) = (self.list(at), self.array(at), self.word(at));
            let names = list.iter().map(|number| format!("Self::part_{number}"));
            let names: Vec<String> = names.collect();
            let table = self.table(at, &list);
            let _ = writeln!(
                out,
                "/// `{name}`: {0} parts, {2} of them different.\nconst {1}_PARTS: [fn(&Self, &mut [f64; {length}], &[{5}]); {2}] = [{3}];\nconst {1}_TABLE: &'static [{5}] = {4};",
                parts
                    .shapes
                    .iter()
                    .map(|shape| shape.table.len())
                    .sum::<usize>(),
                name.to_uppercase(),
                names.len(),
                names.join(", "),
                word.list(&table),
                word.0
            );
        }
        let mut needed = vec![false; self.shapes.len()];
        for (at, _) in self.tabled() {
            self.numbers[at]
                .iter()
                .for_each(|&number| needed[number] = true);
        }
        for number in (0..self.shapes.len()).filter(|&number| needed[number]) {
            let start = out.len();
            self.write_part(&mut out, graph, number);
            // What several functions share is counted for the first of them.
            let (first, _) = self.shapes[number];
            size.add(self.functions[first].0, &out[start..]);
        }
        out
    }

    /// The code of one shape: a loop over rows of places, or a block if there is one row.
    fn write_part(&self, out: &mut String, graph: &Graph, number: usize) {
        let (at, index) = self.shapes[number];
        let shape = &self.functions[at].1.shapes[index];
        let (length, word) = (self.array(at), self.word(at).0);
        let (function, layout) = (&shape.function, &self.layouts[at][index]);
        let only = match shape.table.as_slice() {
            [row] => Some(row.as_slice()),
            _ => None,
        };
        let mask = self.lengths[at] - 1;
        let place = |k: usize| match (only, layout.columns[k]) {
            (Some(row), _) => format!("values[{}]", row[k]),
            (None, (word, 0)) => format!("values[at[{word}] as usize & {mask}]"),
            (None, (word, distance)) => {
                format!("values[(at[{word}] as usize & {mask}) + {distance}]")
            }
        };
        let body = Body::of_part(graph, function, place);
        let values = body.values().into_iter().enumerate();
        let writes = values.fold(String::new(), |text, (k, value)| {
            let place = place(layout.columns.len() - function.outputs.len() + k);
            text + &format!("{place} = {value};\n")
        });
        let code = body.statements() + &writes;
        let width = layout.width();
        let code = match only {
            Some(_) => code,
            None => format!("for at in rows.as_chunks::<{width}>().0 {{ {code} }}"),
        };
        let _ = writeln!(
            out,
            "/// {}\nfn part_{number}(&self, values: &mut [f64; {length}], rows: &[{word}]) {{ {code} }}",
            function.cost(),
        );
    }

    /// The length of the array of a function.
    fn array(&self, at: usize) -> usize {
        self.lengths[at] + BEYOND
    }

    /// The words of the tables of a function.
    fn word(&self, at: usize) -> Word {
        Word::up_to(self.lengths[at] - 1)
    }

    /// The numbers of the shapes of a function, in order.
    fn list(&self, at: usize) -> Vec<usize> {
        let mut list = self.numbers[at].clone();
        list.sort_unstable();
        list.dedup();
        list
    }

    fn table(&self, at: usize, list: &[usize]) -> Vec<usize> {
        let mut table = Vec::new();
        let parts = &self.functions[at].1;
        for (shape, rows) in parts.rows() {
            let layout = &self.layouts[at][shape];
            let rows = match parts.shapes[shape].table.len() {
                // The places of the only row are written out.
                1 => &[],
                _ => rows,
            };
            let length = rows.len() * layout.width();
            let index = list.binary_search(&self.numbers[at][shape]);
            table.extend([index.unwrap_or_default(), length & 0xffff, length >> 16]);
            let places = rows.iter().flat_map(|row| layout.words(row));
            table.extend(places.map(|place| place as usize));
        }
        table
    }
}

/// Writes the outputs from their places in an array of this length.
fn write_outputs(out: &mut String, length: usize, outputs: Vec<(Output, usize)>, method: &Method) {
    let mut sinks: Vec<(&str, usize, Vec<usize>)> = Vec::new();
    for (output, place) in outputs {
        let indices: &[usize] = match output.place {
            Place::Value | Place::Constant(_) => {
                let _ = write!(out, "values[{place}]");
                continue;
            }
            Place::Element(i) => &[i],
            Place::Entry(i, j) => &[i, j],
            Place::Tensor(i, j, k) => &[i, j, k],
        };
        if sinks
            .last()
            .is_none_or(|(sink, count, _)| (*sink, *count) != (output.sink, indices.len()))
        {
            sinks.push((output.sink, indices.len(), Vec::new()));
        }
        if let Some((_, _, numbers)) = sinks.last_mut() {
            numbers.extend(indices.iter().chain([&place]));
        }
    }
    let last = method.arguments.last().map(|last| last.shape);
    for (sink, count, numbers) in sinks {
        let word = Word::up_to(numbers.iter().copied().max().unwrap_or(0));
        let value = "values[place % LENGTH]".replace("LENGTH", &length.to_string());
        let (pattern, statement) = match (count, last) {
            (1, Some(Argument::Values)) => (
                "[i, place]",
                format!(
                    "if let ::core::option::Option::Some(value) = {sink}.get_mut(i) {{ *value = {value}; }}"
                ),
            ),
            (2, Some(Argument::Points)) => (
                "[i, axis, place]",
                format!(
                    "if let ::core::option::Option::Some(point) = {sink}.get_mut(i) {{ point[axis] = {value}; }}"
                ),
            ),
            (1, _) => ("[i, place]", format!("{sink}[i] = {value};")),
            (2, _) if sink == "w" || sink == "delassus" => {
                ("[i, j, place]", format!("{sink}[i][j] = {value};"))
            }
            (2, _) => ("[i, j, place]", format!("{sink}.set(i, j, {value});")),
            _ => ("[i, j, k, place]", format!("{sink}.set(i, j, k, {value});")),
        };
        let _ = writeln!(
            out,
            "for {pattern} in ::mbs_runtime::generated::rows_of({}) {{ {statement} }}",
            word.list(&numbers)
        );
    }
    if method.returns == Returns::Available {
        out.push_str("true");
    }
}

/// Whether the body of a method is that of the function.
fn is_from_program(function: &Function) -> bool {
    Method::named(function.name).is_some_and(|method| !matches!(method.origin, Origin::Written))
}

/// The call of the function that computes the same and more.
fn call_of_whole(function: &Function) -> Option<&'static str> {
    match function.name {
        "force_tangents" => Some(
            "::mbs_runtime::Loads::balance_tangents(self, t, q, v, &mut ::mbs_runtime::generated::Discard, f_q, f_v, p_q);",
        ),
        "forces" => Some("::mbs_runtime::Loads::balance(self, t, q, v, &mut SVector::zeros(), f);"),
        _ => None,
    }
}

impl Word {
    /// For numbers up to this one.
    fn up_to(most: usize) -> Word {
        Word(if most < 1 << 16 { "u16" } else { "u32" })
    }

    /// A list of words as an expression.
    fn list(self, numbers: &[usize]) -> String {
        let mut out = String::from("&[");
        let Word(name) = self;
        for (k, number) in numbers.iter().enumerate() {
            let _ = match k {
                0 => write!(out, "{number}_{name}"),
                _ => write!(out, ", {number}"),
            };
        }
        out + "]"
    }
}
