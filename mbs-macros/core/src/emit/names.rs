//! Identifiers for generated code.

use crate::contract::reserved_names;
use crate::dag::{Function, Operand, Operation};
use crate::symbolic::{Graph, Symbol, Table};
use std::collections::{BTreeMap, HashSet};

/// Names that generated bodies use for themselves beside those of their arguments, and keywords that a coordinate might
/// collide with.
const TAKEN: &[&str] = &[
    "factor",
    "pivot_loss",
    "turn",
    "at",
    "entries",
    "entries_mut",
    "rows",
    "rows_mut",
    "values",
    "as",
    "async",
    "await",
    "break",
    "const",
    "continue",
    "crate",
    "dyn",
    "else",
    "enum",
    "extern",
    "false",
    "fn",
    "for",
    "gen",
    "if",
    "impl",
    "in",
    "let",
    "loop",
    "match",
    "mod",
    "move",
    "mut",
    "pub",
    "ref",
    "return",
    "self",
    "static",
    "struct",
    "super",
    "trait",
    "true",
    "type",
    "unsafe",
    "use",
    "where",
    "while",
];

/// The identifiers of one function: bound symbols and named temporaries.
pub(super) struct Names {
    /// Symbols that the body binds at its start: symbol → (identifier, where it comes from).
    pub bound: BTreeMap<Symbol, (String, String)>,
    /// The temporary of each operation.
    pub temporaries: Vec<String>,
}

impl Names {
    pub(super) fn new(graph: &Graph, function: &Function) -> Names {
        let taken = TAKEN.iter().copied().chain(reserved_names());
        let mut taken: HashSet<String> = taken.map(str::to_owned).collect();
        let mut bound = BTreeMap::new();
        for symbol in symbols(function) {
            let Some(source) = source(symbol) else {
                continue;
            };
            let name = match symbol {
                Symbol::VectorEntry(i) => format!("x{i}"),
                Symbol::Place(i) => format!("a{i}"),
                _ => binding(symbol, &graph.name(symbol)),
            };
            let name = claim(&name, &mut taken);
            bound.insert(symbol, (name, source));
        }
        let mut names = Names {
            bound,
            temporaries: Vec::new(),
        };
        for (slot, operation) in function.operations.iter().enumerate() {
            let wanted = match (&function.names[slot], operation) {
                (Some(hint), _) => identifier(hint),
                (None, Operation::Call(function, operand)) => match names.simple(operand) {
                    Some(operand) => format!("{}_{operand}", function.name()),
                    None => format!("t{slot}"),
                },
                (None, Operation::Multiply(x, y)) if x == y => match names.simple(x) {
                    Some(operand) => format!("{operand}_squared"),
                    None => format!("t{slot}"),
                },
                (None, Operation::Law(law, _)) => format!("law_{law}"),
                _ => format!("t{slot}"),
            };
            let name = claim(&wanted, &mut taken);
            names.temporaries.push(name);
        }
        names
    }

    /// The name of an operand, if it is a short word of its own.
    fn simple(&self, operand: &Operand) -> Option<String> {
        match operand {
            Operand::Symbol(symbol) => self.bound.get(symbol).map(|(name, _)| name.clone()),
            Operand::Value(slot) => self
                .temporaries
                .get(*slot)
                .filter(|name| !is_numbered(name))
                .cloned(),
            _ => None,
        }
        .filter(|name| name.len() <= 24)
    }
}

/// The field, and in `prepare` the variable, of a table some of whose points are parameters.
pub(super) fn table_field(table: &Table) -> String {
    format!("table_{}", table.index)
}

/// Whether a variable of this name may hide that of a table.
fn is_table_field(name: &str) -> bool {
    let number = name.strip_prefix("table_");
    number.is_some_and(|number| number.bytes().all(|byte| byte.is_ascii_digit()))
}

fn is_numbered(name: &str) -> bool {
    name.strip_prefix('t')
        .is_some_and(|rest| rest.chars().all(|c| c.is_ascii_digit()))
}

/// The variable of a symbol. A name of one word is the user's own word: a constant or a unit struct of that name in the
/// user's module would make the binding a pattern, and hygiene does not help, as constants are items.
fn binding(symbol: Symbol, name: &str) -> String {
    let own = !name.contains(['.', '\'']);
    match symbol {
        Symbol::Input(_) => format!("input_{}", identifier(name)),
        _ if own => format!("q_{}", identifier(name)),
        _ => identifier(name),
    }
}

/// `crank.b.x'` → `crank_b_x_dot`, `crank[3].b.x` → `crank_3_b_x`. Different names may become the same word: whoever
/// declares it claims it.
fn identifier(name: &str) -> String {
    let dotted = name.replace("''", "_ddot").replace('\'', "_dot");
    let dotted = dotted.replace(']', "");
    dotted
        .chars()
        .map(|c| if c.is_alphanumeric() { c } else { '_' })
        .collect()
}

/// Where a body finds what a symbol stands for; `None` for what is not among its arguments.
pub(super) fn source(symbol: Symbol) -> Option<String> {
    Some(match symbol {
        Symbol::Stored(i) => format!("q[{i}]"),
        Symbol::Velocity(i) => format!("v[{i}]"),
        Symbol::Acceleration(i) => format!("acceleration[{i}]"),
        Symbol::Input(i) => format!("self.inputs[{i}]"),
        // The kernel overwrites its argument: read all of it first.
        Symbol::VectorEntry(i) => format!("x[{i}]"),
        Symbol::Place(i) => format!("place {i}"),
        _ => return None,
    })
}

fn claim(wanted: &str, taken: &mut HashSet<String>) -> String {
    let mut name = wanted.to_owned();
    let mut suffix = 2;
    while is_table_field(&name) || !taken.insert(name.clone()) {
        name = format!("{wanted}_{suffix}");
        suffix += 1;
    }
    name
}

fn symbols(function: &Function) -> Vec<Symbol> {
    let mut found = Vec::new();
    let mut note = |operand: Operand| {
        if let Operand::Symbol(symbol) = operand {
            found.push(symbol);
        }
    };
    function
        .operations
        .iter()
        .for_each(|operation| operation.for_each_operand(&mut note));
    function
        .outputs
        .iter()
        .for_each(|output| note(output.value));
    found.sort_unstable();
    found.dedup();
    found
}
