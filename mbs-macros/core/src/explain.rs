//! The equations of a mechanism as LaTeX, from its declaration.

use crate::analysis::Analysis;
use crate::compile::analyse;
use crate::equations::RowKind;
use std::fmt::Write;

/// A LaTeX fragment (amsmath) with q, M, V, f, the rows, A and the equations of motion.
///
/// # Errors
/// The messages of a declaration that does not compile.
pub fn latex(declaration: &str) -> Result<String, String> {
    let tokens = declaration
        .parse()
        .map_err(|error| format!("the declaration cannot be read: {error}"))?;
    let (_, analysis) = analyse(tokens);
    let analysis = analysis.map_err(|failure| {
        let messages: Vec<String> = failure
            .messages()
            .into_iter()
            .map(|(message, _)| message)
            .collect();
        messages.join("\n")
    })?;
    Ok(write(&analysis))
}

fn write(analysis: &Analysis) -> String {
    let derived = &analysis.derived;
    let system = &derived.system;
    let graph = &system.graph;
    let mut out = String::new();
    let mut line = |text: String| {
        let _ = writeln!(out, "{text}");
    };
    let states = &system.layout.states;
    let moves = |i: usize| !states.contains(&i);
    let coordinates: Vec<String> = (0..system.size as u32)
        .filter(|&i| moves(i as usize))
        .map(|i| symbol(graph, crate::symbolic::Symbol::Coordinate(i)))
        .collect();
    line(format!("% {}", analysis.outline.name));
    line("\\begin{align*}".to_owned());
    line(format!(
        "q &= \\left({}\\right)^T, \\qquad \\dot q = v \\\\",
        coordinates.join(",\\; ")
    ));
    let mass = system.mass.iter();
    for (&(i, j), &entry) in mass.filter(|((i, _), _)| moves(*i)) {
        let mirror = if i == j {
            String::new()
        } else {
            format!(" = M_{{{},{}}}", j + 1, i + 1)
        };
        line(format!(
            "M_{{{},{}}}{mirror} &= {} \\\\",
            i + 1,
            j + 1,
            graph.latex(entry)
        ));
    }
    line(format!("V &= {} \\\\", graph.latex(system.potential)));
    for (i, &force) in system
        .forces
        .iter()
        .enumerate()
        .filter(|(i, force)| moves(*i) && !graph.is_zero(**force))
    {
        line(format!("f_{{{}}} &= {} \\\\", i + 1, graph.latex(force)));
    }
    for &state in states {
        let name = symbol(graph, crate::symbolic::Symbol::Velocity(state as u32));
        let rate = graph.latex(system.forces[state]);
        line(format!("\\dot{{{name}}} &= {rate} \\\\"));
    }
    for (i, row) in system.rows.iter().enumerate() {
        let name = row.name.replace('_', "\\_");
        let left = if row.kind == RowKind::Nonholonomic {
            "\\dot\\psi"
        } else {
            "\\varphi"
        };
        line(format!(
            "{left}_{{{}}} &= {} = 0 && \\text{{{name}}} \\\\",
            i + 1,
            graph.latex(row.expr)
        ));
    }
    for (&(i, j), &entry) in &derived.jacobian {
        line(format!(
            "A_{{{},{}}} &= {} \\\\",
            i + 1,
            j + 1,
            graph.latex(entry)
        ));
    }
    let quadratic = if derived.constant_mass {
        ""
    } else {
        " + \\Gamma(v, v)"
    };
    let reactions = if system.rows.is_empty() {
        ""
    } else {
        " + A^T \\lambda"
    };
    line(format!("M \\dot v{quadratic} &= f{reactions}"));
    line("\\end{align*}".to_owned());
    out
}

fn symbol(graph: &crate::symbolic::Graph, symbol: crate::symbolic::Symbol) -> String {
    crate::symbolic::latex_identifier(&graph.name(symbol))
}
