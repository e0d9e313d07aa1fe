//! A declaration after each stage of the compiler, as stable and readable text.

use crate::formulas::Formulas;
use mbs_macros_core::derivatives::Derived;
use mbs_macros_core::diagnostics::Errors;
use mbs_macros_core::syntax::Declaration;
use mbs_macros_core::{Analysis, dag, equations::System};
use quote::ToTokens;
use std::fmt::Write;

/// The stages as text, in order: tree, model, system, derived quantities, program.
pub fn texts(declaration: &str) -> [(&'static str, String); 5] {
    let mut errors = Errors::new();
    let tree = mbs_macros_core::syntax::parse(
        tokens(declaration),
        mbs_macros_core::model::kinds(),
        &mut errors,
    );
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
    let (model, system) = (&analysis.outline, &analysis.derived.system);
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
    for name in &model.joints {
        let _ = writeln!(out, "rows from {name}");
    }
    for name in &model.forces {
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

/// Stage 3.
pub fn system(system: &System) -> String {
    let mut formulas = Formulas::new(&system.graph);
    formulas.matrix("M", &system.mass);
    formulas.add("V", "", system.potential);
    formulas.vector("f", &system.forces);
    formulas.add("power", "", system.power);
    for row in &system.rows {
        let kind = format!("{:?}", row.kind);
        formulas.add(&kind, &format!(" {} [{}]", row.name, row.unit), row.expr);
    }
    for reaction in &system.reactions {
        let which = format!(
            " {}.{} [{}]",
            reaction.joint, reaction.component, reaction.unit
        );
        formulas.add("reaction", &which, reaction.expr);
    }
    formulas.vector("output", &system.outputs);
    formulas.vector("event", &system.events);
    formulas.text()
}

/// Stage 4.
pub fn derived(derived: &Derived) -> String {
    let mut formulas = Formulas::new(&derived.system.graph);
    formulas.vector("p", &derived.momentum);
    formulas.add("T", "", derived.kinetic);
    affinities(&mut formulas, derived);
    rows(&mut formulas, derived);
    formulas.vector("F", &derived.total_forces);
    formulas.matrix("∂f/∂q", &derived.applied.by_position);
    formulas.matrix("∂f/∂v", &derived.applied.by_velocity);
    formulas.matrix("∂F/∂q", &derived.total.by_position);
    formulas.matrix("∂F/∂v", &derived.total.by_velocity);
    formulas.matrix("∂p/∂q", &derived.momentum_by_position);
    formulas.vector("M⁻¹f", derived.acceleration.as_deref().unwrap_or(&[]));
    format!(
        "constant mass: {}\n{}",
        derived.constant_mass,
        formulas.text()
    )
}

/// The quantities that the later stages derive: M, Γ, A, b, Ȧ, γ and the tangents, with all their subexpressions.
pub fn quantities(derived: &Derived) -> String {
    let mut formulas = Formulas::new(&derived.system.graph);
    formulas.matrix("M", &derived.system.mass);
    affinities(&mut formulas, derived);
    rows(&mut formulas, derived);
    formulas.matrix("∂F/∂q", &derived.total.by_position);
    formulas.matrix("∂F/∂v", &derived.total.by_velocity);
    formulas.matrix("∂p/∂q", &derived.momentum_by_position);
    formulas.text()
}

fn affinities(formulas: &mut Formulas, derived: &Derived) {
    for (&(i, j, k), &value) in derived.affinities.iter().flatten() {
        formulas.add("Γ", &format!("[{i}][{j}][{k}]"), value);
    }
}

fn rows(formulas: &mut Formulas, derived: &Derived) {
    formulas.matrix("A", &derived.jacobian);
    formulas.vector("b", &derived.rheonomic);
    formulas.matrix("Ȧ", &derived.jacobian_rate);
    formulas.vector("γ", &derived.convective);
}
