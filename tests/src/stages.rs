//! A declaration after each stage of the compiler, as text that is stable and made for people.

use mbs_macros_core::derivatives::{Derived, Matrix};
use mbs_macros_core::diagnostics::Errors;
use mbs_macros_core::symbolic::{Expr, Graph};
use mbs_macros_core::syntax::Declaration;
use mbs_macros_core::{Analysis, dag, equations::System};
use quote::ToTokens;
use std::fmt::Write;

/// The stages as text, in order: tree, model, system, derived quantities, program.
pub fn texts(declaration: &str) -> [(&'static str, String); 5] {
    let mut errors = Errors::new();
    let tree = mbs_macros_core::syntax::parse(tokens(declaration), &mut errors);
    errors.stop_if_any().expect("the fixture is right");
    let tree = tree.expect("the fixture is right");
    let analysis = crate::interpreted::analysis(declaration);
    let derived = &analysis.derived;
    let graph = derived.system.graph.clone();
    let stages = [
        ("1-tree", syntax(&tree)),
        ("2-model", self::model(&analysis)),
        ("3-system", system(&derived.system)),
        ("4-derived", self::derived(derived)),
    ];
    let program = dag::lower(&analysis.derived);
    let [a, b, c, d] = stages;
    [a, b, c, d, ("5-program", program.text(&graph))]
}

/// A declaration as tokens.
pub fn tokens(declaration: &str) -> proc_macro2::TokenStream {
    declaration
        .parse()
        .expect("a declaration is made of tokens")
}

fn syntax(tree: &Declaration) -> String {
    let mut out = format!("{}: {}\n", tree.name, tree.doc);
    for entry in tree.world.iter().chain(&tree.entries) {
        let _ = write!(out, "{}: {}", entry.name, entry.kind);
        for argument in &entry.positional {
            let _ = write!(out, "\n    {}", argument.to_token_stream());
        }
        for argument in &entry.named {
            let _ = write!(
                out,
                "\n    {} = {}",
                argument.name,
                argument.value.to_token_stream()
            );
        }
        let _ = writeln!(out);
    }
    out
}

fn model(analysis: &Analysis) -> String {
    let (model, system) = (&analysis.model, &analysis.derived.system);
    let (graph, candidates) = (&system.graph, &analysis.candidates);
    let mut out = String::new();
    for parameter in &model.parameters {
        let _ = writeln!(
            out,
            "parameter {} = {} {}",
            parameter.name, parameter.default, parameter.unit
        );
    }
    for input in &model.inputs {
        let _ = writeln!(
            out,
            "input {} = {} {}",
            input.name, input.default, input.unit
        );
    }
    for part in &model.parts {
        let _ = writeln!(
            out,
            "{} {}: {}",
            part.kind,
            part.name,
            part.representation.describe()
        );
    }
    let layout = &system.layout;
    for (kind, list) in [
        ("coordinate", &layout.coordinates),
        ("velocity", &layout.velocities),
    ] {
        for stored in list {
            let (name, unit, guess) = (&stored.name, &stored.unit, graph.text(stored.guess));
            let _ = writeln!(out, "{kind} {name} [{unit}] from {guess}");
        }
    }
    for candidate in candidates {
        let cut = match candidate.cut.is_empty() {
            true => String::new(),
            false => format!(" cut at {}", candidate.cut.join(", ")),
        };
        let _ = writeln!(
            out,
            "choice {}{cut}: {} velocities, {} rows, {:?} operations{}",
            candidate.formulation.name(),
            candidate.velocities,
            candidate.rows,
            candidate.operations,
            if candidate.taken { ", taken" } else { "" }
        );
    }
    for sentence in &model.reductions {
        let _ = writeln!(out, "reduction: {sentence}");
    }
    for (name, _) in &model.joints {
        let _ = writeln!(out, "rows from {name}");
    }
    for (name, _) in &model.forces {
        let _ = writeln!(out, "force from {name}");
    }
    for (name, _) in &model.drawing.points {
        let _ = writeln!(out, "point {name}");
    }
    for (part, from, to) in &model.drawing.segments {
        let _ = writeln!(out, "line of {part}: point {from} to point {to}");
    }
    out
}

struct Text<'a> {
    graph: &'a Graph,
    out: String,
}

impl Text<'_> {
    fn scalar(&mut self, name: &str, expr: Expr) {
        // Shared subexpressions are written out each time: cut what grows beyond reading.
        let _ = writeln!(self.out, "{name} = {}", self.graph.short_text(expr, 600));
    }
    fn vector(&mut self, name: &str, values: &[Expr]) {
        for (i, &value) in values.iter().enumerate() {
            self.scalar(&format!("{name}[{i}]"), value);
        }
    }
    fn matrix(&mut self, name: &str, entries: &Matrix) {
        for (&(i, j), &value) in entries {
            self.scalar(&format!("{name}[{i}][{j}]"), value);
        }
    }
}

fn system(system: &System) -> String {
    let mut text = Text {
        graph: &system.graph,
        out: String::new(),
    };
    text.matrix("M", &system.mass);
    text.scalar("V", system.potential);
    text.vector("f", &system.forces);
    text.scalar("power", system.power);
    for row in &system.rows {
        text.scalar(
            &format!("{:?} {} [{}]", row.kind, row.name, row.unit),
            row.expr,
        );
    }
    for reaction in &system.reactions {
        let name = format!(
            "reaction {}.{} [{}]",
            reaction.joint, reaction.component, reaction.unit
        );
        text.scalar(&name, reaction.expr);
    }
    text.vector("output", &system.outputs);
    text.vector("event", &system.events);
    text.out
}

fn derived(derived: &Derived) -> String {
    let mut text = Text {
        graph: &derived.system.graph,
        out: String::new(),
    };
    let _ = writeln!(text.out, "constant mass: {}", derived.constant_mass);
    text.vector("p", &derived.momentum);
    text.scalar("T", derived.kinetic);
    for (&(i, j, k), &value) in derived.affinities.iter().flatten() {
        text.scalar(&format!("Γ[{i}][{j}][{k}]"), value);
    }
    text.matrix("A", &derived.jacobian);
    text.vector("b", &derived.rheonomic);
    text.matrix("Ȧ", &derived.jacobian_rate);
    text.vector("γ", &derived.convective);
    text.vector("F", &derived.total_forces);
    text.matrix("∂f/∂q", &derived.applied_by_position);
    text.matrix("∂f/∂v", &derived.applied_by_velocity);
    text.matrix("∂F/∂q", &derived.total_by_position);
    text.matrix("∂F/∂v", &derived.total_by_velocity);
    text.matrix("∂p/∂q", &derived.momentum_by_position);
    text.vector("M⁻¹f", derived.acceleration.as_deref().unwrap_or(&[]));
    text.out
}
