//! The bindings and temporaries of a body, in blocks where they are many.
//!
//! Each `let` opens a scope inside the last. With some thousand of them rustc overflows its stack, and with debug
//! information LLVM needs time that grows with the square of their number. So many temporaries are divided into blocks,
//! one `let` each: a block hands on what is used after it.

use super::body::Body;
use crate::dag::Operand;
use std::fmt::Write;

/// Up to so many `let`s are written one after the other.
const MOST: usize = 300;
/// Temporaries of a block.
const BLOCK: usize = 100;

impl Body<'_> {
    /// Bindings and temporaries.
    pub(super) fn statements(&self) -> String {
        let mut out = String::new();
        let_all(&mut out, &self.bindings());
        let temporaries: Vec<(usize, &str, String)> = self.temporaries().collect();
        if temporaries.len() <= MOST {
            write_temporaries(&mut out, &temporaries);
            return out;
        }
        let last = self.last_uses(&temporaries);
        for (index, block) in temporaries.chunks(BLOCK).enumerate() {
            let end = (index + 1) * BLOCK;
            let handed_on = block.iter().filter(|(slot, _, _)| last[*slot] >= end);
            let handed_on = handed_on.fold(String::new(), |text, (_, name, _)| text + name + ", ");
            let _ = writeln!(out, "let ({handed_on}) = {{");
            write_temporaries(&mut out, block);
            let _ = writeln!(out, "({handed_on}) }};");
        }
        out
    }

    /// For each operation the index of the last temporary whose text has its value; at least the number of temporaries
    /// for what is used after all of them.
    fn last_uses(&self, temporaries: &[(usize, &str, String)]) -> Vec<usize> {
        let operations = &self.function.operations;
        let mut own = vec![None; operations.len()];
        for (index, (slot, _, _)) in temporaries.iter().enumerate() {
            own[*slot] = Some(index);
        }
        let mut last = vec![0; operations.len()];
        for output in &self.function.outputs {
            if let Operand::Value(slot) = output.value {
                last[slot] = usize::MAX;
            }
        }
        for slot in (0..operations.len()).rev() {
            // What has no temporary is written where it is used.
            let place = own[slot].unwrap_or(last[slot]);
            operations[slot].for_each_operand(|operand| {
                if let Operand::Value(inner) = operand {
                    last[inner] = last[inner].max(place);
                }
            });
        }
        last
    }
}

fn write_temporaries(out: &mut String, temporaries: &[(usize, &str, String)]) {
    for (_, name, value) in temporaries {
        let _ = writeln!(out, "let {name} = {value};");
    }
}

/// Names for numbers that do not depend on each other: a `let` for each, or for many at a time.
pub(super) fn let_all<N: AsRef<str>, V: AsRef<str>>(out: &mut String, list: &[(N, V)]) {
    if list.len() <= BLOCK {
        for (name, value) in list {
            let _ = writeln!(out, "let {} = {};", name.as_ref(), value.as_ref());
        }
        return;
    }
    for block in list.chunks(BLOCK) {
        let join = |text: String, part: &str| text + part + ", ";
        let names = block.iter().map(|(name, _)| name.as_ref());
        let values = block.iter().map(|(_, value)| value.as_ref());
        let _ = writeln!(
            out,
            "let [{}] = [{}];",
            names.fold(String::new(), join),
            values.fold(String::new(), join)
        );
    }
}
