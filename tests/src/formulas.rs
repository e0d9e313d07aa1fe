//! Formulas as readable text, always complete. Common parts of long formulas get names, and long lines are broken.

use mbs_macros_core::symbolic::{Expr, Graph, Node};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// Formulas longer than this are written with names for common subexpressions.
const WHOLE: usize = 240;
/// A shorter subexpression gets no name.
const SHORT: usize = 40;
/// Lines are at most about this long.
const WIDTH: usize = 110;
/// Lines are not broken inside more parentheses than this.
const DEEPEST: usize = 8;

/// Formulas that are written one after the other, with the same names for the same expressions.
pub struct Formulas<'a> {
    graph: &'a Graph,
    /// Quantity, its indices, formula.
    list: Vec<(String, String, Expr)>,
}

impl<'a> Formulas<'a> {
    /// None yet.
    pub fn new(graph: &'a Graph) -> Self {
        Formulas {
            graph,
            list: Vec::new(),
        }
    }

    /// `quantity` followed by `indices` is `expr`.
    pub fn add(&mut self, quantity: &str, indices: &str, expr: Expr) {
        self.list
            .push((quantity.to_owned(), indices.to_owned(), expr));
    }

    /// Adds the elements of a vector.
    pub fn vector(&mut self, quantity: &str, values: &[Expr]) {
        for (i, &value) in values.iter().enumerate() {
            self.add(quantity, &format!("[{i}]"), value);
        }
    }

    /// Adds the entries of a matrix that are not zero.
    pub fn matrix(&mut self, quantity: &str, entries: &BTreeMap<(usize, usize), Expr>) {
        for (&(i, j), &value) in entries {
            self.add(quantity, &format!("[{i}][{j}]"), value);
        }
    }

    /// All of them, one after the other.
    pub fn text(&self) -> String {
        let mut writer = Writer {
            graph: self.graph,
            uses: uses(self.graph, self.list.iter().map(|(_, _, expr)| *expr)),
            lengths: BTreeMap::new(),
            names: BTreeMap::new(),
            counts: BTreeMap::new(),
            out: String::new(),
        };
        for (quantity, indices, expr) in &self.list {
            if writer.length(*expr) > WHOLE {
                writer.name_what_is_shared(quantity, *expr);
            }
            writer.formula(&format!("{quantity}{indices}"), *expr);
        }
        writer.out
    }
}

/// How often each expression occurs in others, or is one of the roots.
fn uses(graph: &Graph, roots: impl IntoIterator<Item = Expr>) -> BTreeMap<Expr, usize> {
    let mut uses: BTreeMap<Expr, usize> = BTreeMap::new();
    let mut stack: Vec<Expr> = roots.into_iter().collect();
    while let Some(expr) = stack.pop() {
        let count = uses.entry(expr).or_default();
        *count += 1;
        if *count == 1 {
            graph.for_each_operand(expr, |operand| stack.push(operand));
        }
    }
    uses
}

struct Writer<'a> {
    graph: &'a Graph,
    uses: BTreeMap<Expr, usize>,
    /// Characters without any names, about.
    lengths: BTreeMap<Expr, usize>,
    names: BTreeMap<Expr, String>,
    /// How many shared expressions each quantity has named.
    counts: BTreeMap<String, usize>,
    out: String,
}

impl Writer<'_> {
    /// Characters of an expression without names, about.
    fn length(&mut self, expr: Expr) -> usize {
        if let Some(&known) = self.lengths.get(&expr) {
            return known;
        }
        let length = match self.graph.node(expr) {
            Node::Constant(_) | Node::Symbol(_) => self.graph.text(expr).chars().count(),
            _ => {
                let mut operands = Vec::new();
                self.graph
                    .for_each_operand(expr, |operand| operands.push(operand));
                operands.into_iter().fold(2, |length: usize, operand| {
                    length.saturating_add(self.length(operand).saturating_add(2))
                })
            }
        };
        self.lengths.insert(expr, length);
        length
    }

    /// Names what is inside `root` and occurs elsewhere, too, operands first.
    fn name_what_is_shared(&mut self, quantity: &str, root: Expr) {
        let mut inside = BTreeSet::new();
        let mut stack = vec![root];
        while let Some(expr) = stack.pop() {
            if !self.names.contains_key(&expr) && inside.insert(expr) {
                self.graph
                    .for_each_operand(expr, |operand| stack.push(operand));
            }
        }
        inside.remove(&root);
        // Operands have smaller indices than the expressions made from them.
        for expr in inside {
            if self.uses[&expr] > 1 && self.short(expr).is_none() {
                let count = self.counts.entry(quantity.to_owned()).or_default();
                *count += 1;
                let name = format!("{quantity}_{count}");
                self.formula(&name, expr);
            }
        }
    }

    /// The text of an expression that needs no name.
    fn short(&self, expr: Expr) -> Option<String> {
        let text = self.graph.text_naming(expr, &self.names);
        (text.chars().count() <= SHORT).then_some(text)
    }

    /// Writes a formula; later formulas use its name.
    fn formula(&mut self, name: &str, expr: Expr) {
        let text = match self.names.get(&expr) {
            Some(other) => other.clone(),
            None => self.graph.text_naming(expr, &self.names),
        };
        let _ = writeln!(self.out, "{}", broken(&format!("{name} = {text}")));
        if text.chars().count() > SHORT {
            self.names.entry(expr).or_insert_with(|| name.to_owned());
        }
    }
}

/// The text on several lines, broken before signs; before signs inside parentheses only if the text around them is too
/// long for a line.
fn broken(text: &str) -> String {
    let mut out = String::new();
    let mut line = String::new();
    for piece in pieces(text, 0) {
        let length = line.chars().count() + piece.trim_end().chars().count();
        if length > WIDTH && !line.trim().is_empty() {
            let _ = writeln!(out, "{}", line.trim_end());
            line = "    ".to_owned();
        }
        line.push_str(piece);
    }
    out + line.trim_end()
}

/// The summands inside `depth` parentheses, and their parts if they are long.
fn pieces(text: &str, depth: usize) -> Vec<&str> {
    let mut summands = Vec::new();
    let (mut start, mut inside) = (0, 0);
    for (at, character) in text.char_indices() {
        match character {
            '(' => inside += 1,
            // A piece of a longer text may close parentheses that it has not opened.
            ')' => inside -= 1,
            _ => {}
        }
        let sign = text[at..].starts_with("+ ") || text[at..].starts_with("- ");
        if sign && at > start && inside <= depth as i32 {
            summands.push(&text[start..at]);
            start = at;
        }
    }
    summands.push(&text[start..]);
    let long = |piece: &str| piece.contains('(') && piece.chars().count() + 4 > WIDTH;
    let split = |piece| match long(piece) && depth < DEEPEST {
        true => pieces(piece, depth + 1),
        false => vec![piece],
    };
    summands.into_iter().flat_map(split).collect()
}
