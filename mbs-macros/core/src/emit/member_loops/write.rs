//! The loops as Rust.

use super::{Array, Loops, Repetition, Spot};
use crate::contract::{Method, Returns};
use crate::dag::{Output, Place};
use crate::emit::body::{Body, number, source};
use crate::emit::copies::copies;
use crate::emit::long_array;
use crate::emit::progressions::counted;
use std::fmt::Write;

impl Loops<'_> {
    pub(super) fn write(
        &self,
        plan: &[Repetition],
        outputs: &[(Output, usize)],
        method: &Method,
    ) -> String {
        let whole: Vec<usize> = (0..=self.parts.places).collect();
        let packed = self.packed(plan).unwrap_or(whole);
        let places = packed[self.parts.places];
        let mut out = String::new();
        if places > 0 {
            out.push_str(&long_array::declaration(places));
        }
        for (index, array) in self.arrays.iter().enumerate() {
            if let Array::Numbers(numbers) = array {
                let list = numbers.iter().map(|&bits| number(f64::from_bits(bits)));
                let list: Vec<String> = list.collect();
                let _ = writeln!(
                    out,
                    "const NUMBERS_{index}: &[f64; {}] = &[{}];",
                    list.len(),
                    list.join(", ")
                );
            }
        }
        let values = self.known.get(&Array::Values).copied();
        let kept = self.inputs.iter().zip(&self.parts.inputs).enumerate();
        let kept = kept.filter(|&(place, (spot, _))| {
            Some(spot.array) == values && packed[place] < packed[place + 1]
        });
        let mut sources = vec!["0.0".to_owned(); packed[self.inputs.len()]];
        for (place, (_, &input)) in kept {
            sources[packed[place]] = source(self.graph, input);
        }
        out.push_str(&copies("values", &sources));
        for Repetition {
            first,
            period,
            times,
        } in plan
        {
            let is_loop = *times > 1;
            if is_loop {
                let _ = writeln!(out, "for turn in 0..{times}_usize {{");
            }
            for at in *first..first + period {
                let next = if is_loop { at + period } else { at };
                self.write_member(&mut out, &packed, [at, next], is_loop && *period == 1);
            }
            if is_loop {
                out.push_str("}\n");
            }
        }
        for (_, place) in outputs
            .iter()
            .filter(|(output, _)| matches!(output.place, Place::Value))
        {
            let spot = self.inputs.get(*place).copied();
            out.push_str(&match spot {
                Some(spot) => self.text(&packed, spot, spot),
                None => format!("values[{}]", packed[*place]),
            });
        }
        if method.returns == Returns::Available {
            out.push_str("true");
        }
        out
    }

    /// The code of a member; `next` is that of the next turn. `is_alone`: nothing else is in its block.
    fn write_member(
        &self,
        out: &mut String,
        packed: &[usize],
        [at, next]: [usize; 2],
        is_alone: bool,
    ) {
        let [member, next] = [at, next].map(|at| &self.members[at]);
        let spot = |k: usize| self.text(packed, member.spots[k], next.spots[k]);
        let goes: usize = member.goes.iter().sum();
        let mut to = member.spots.len() - goes;
        let code = member.shape.map(|shape| &self.parts.shapes[shape].function);
        let body = code.map(|code| Body::of_part(self.graph, code, spot));
        let values = match &body {
            Some(body) => body.values(),
            None => vec![spot(0)],
        };
        let statements = body.as_ref().map_or_else(String::new, Body::statements);
        // Names of one member are not those of another.
        let braces = match statements.is_empty() || is_alone {
            true => ["", ""],
            false => ["{\n", "}\n"],
        };
        out.push_str(braces[0]);
        out.push_str(&statements);
        for (mut value, &goes) in values.into_iter().zip(&member.goes) {
            for k in to..to + goes {
                self.put(out, packed, [member.spots[k], next.spots[k]], &value);
                if k == to && goes > 1 {
                    value = spot(k);
                }
            }
            to += goes;
        }
        out.push_str(braces[1]);
    }

    /// The statement that writes a value.
    fn put(&self, out: &mut String, packed: &[usize], [spot, next]: [Spot; 2], value: &str) {
        let index = |k: usize| counted(spot.at[k], next.at[k]);
        let _ = match self.arrays[spot.array] {
            Array::Result(sink @ ("w" | "delassus"), 2) => {
                writeln!(out, "{sink}[{}][{}] = {value};", index(0), index(1))
            }
            Array::Result(sink, count @ 2..) => {
                let indices: Vec<String> = (0..count).map(index).collect();
                writeln!(out, "{sink}.set({}, {value});", indices.join(", "))
            }
            _ => writeln!(out, "{} = {value};", self.text(packed, spot, next)),
        };
    }

    /// A place, as text.
    fn text(&self, packed: &[usize], spot: Spot, next: Spot) -> String {
        match &self.arrays[spot.array] {
            Array::Values => {
                let index = counted(packed[spot.at[0]], packed[next.at[0]]);
                format!("values[{index}]")
            }
            Array::Argument(name) => format!("{name}[{}]", counted(spot.at[0], next.at[0])),
            Array::Common(text) => text.clone(),
            Array::Numbers(_) => {
                format!(
                    "NUMBERS_{}[{}]",
                    spot.array,
                    counted(spot.at[0], next.at[0])
                )
            }
            Array::Result(sink, _) => format!("{sink}[{}]", counted(spot.at[0], next.at[0])),
        }
    }
}
