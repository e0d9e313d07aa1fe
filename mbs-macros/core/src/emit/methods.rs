//! The methods of `System`: one for each function of the program.

use super::body::Body;
use super::{motion, sparse};
use crate::dag::{Function, Program};
use crate::symbolic::Graph;
use std::fmt::Write;

/// Methods: name, signature after the name, and how the body ends. Those that the program lacks keep the default of the
/// trait.
const METHODS: &[(&str, &str, Ending)] = &[
    (
        "mass_matrix",
        "(&self, q: &[f64; Q], mass: &mut impl ::mbs_runtime::MatrixSink)",
        Ending::Writes,
    ),
    (
        "momentum",
        "(&self, q: &[f64; Q], v: &[f64; N], p: &mut [f64; N])",
        Ending::Writes,
    ),
    (
        "affinities",
        "(&self, q: &[f64; Q], gamma: &mut impl ::mbs_runtime::TensorSink)",
        Ending::Writes,
    ),
    (
        "holonomic",
        "(&self, t: f64, q: &[f64; Q], phi: &mut [f64; R])",
        Ending::Writes,
    ),
    (
        "constraints",
        "(&self, t: f64, q: &[f64; Q], phi: &mut [f64; R], a: &mut impl ::mbs_runtime::MatrixSink, b: &mut [f64; R])",
        Ending::Writes,
    ),
    (
        "constraint_rates",
        "(&self, t: f64, q: &[f64; Q], v: &[f64; N], a_rate: &mut impl ::mbs_runtime::MatrixSink, gamma: &mut [f64; R])",
        Ending::Writes,
    ),
    (
        "applied_forces",
        "(&self, t: f64, q: &[f64; Q], v: &[f64; N], f: &mut [f64; N])",
        Ending::Writes,
    ),
    (
        "forces",
        "(&self, t: f64, q: &[f64; Q], v: &[f64; N], f: &mut [f64; N])",
        Ending::Writes,
    ),
    (
        "applied_force_tangents",
        "(&self, t: f64, q: &[f64; Q], v: &[f64; N], f_q: &mut impl ::mbs_runtime::MatrixSink, f_v: &mut impl ::mbs_runtime::MatrixSink)",
        Ending::Writes,
    ),
    (
        "force_tangents",
        "(&self, t: f64, q: &[f64; Q], v: &[f64; N], f_q: &mut impl ::mbs_runtime::MatrixSink, f_v: &mut impl ::mbs_runtime::MatrixSink, p_q: &mut impl ::mbs_runtime::MatrixSink)",
        Ending::Writes,
    ),
    (
        "balance",
        "(&self, t: f64, q: &[f64; Q], v: &[f64; N], p: &mut [f64; N], f: &mut [f64; N])",
        Ending::Writes,
    ),
    (
        "balance_tangents",
        "(&self, t: f64, q: &[f64; Q], v: &[f64; N], mass: &mut impl ::mbs_runtime::MatrixSink, f_q: &mut impl ::mbs_runtime::MatrixSink, f_v: &mut impl ::mbs_runtime::MatrixSink, p_q: &mut impl ::mbs_runtime::MatrixSink)",
        Ending::Writes,
    ),
    (
        "acceleration",
        "(&self, t: f64, q: &[f64; Q], acceleration: &mut [f64; N])",
        Ending::Writes,
    ),
    (
        "kinetic_energy",
        "(&self, q: &[f64; Q], v: &[f64; N]) -> f64",
        Ending::Writes,
    ),
    (
        "potential_energy",
        "(&self, q: &[f64; Q]) -> f64",
        Ending::Writes,
    ),
    (
        "nonconservative_power",
        "(&self, t: f64, q: &[f64; Q], v: &[f64; N]) -> f64",
        Ending::Writes,
    ),
    (
        "outputs",
        "(&self, t: f64, q: &[f64; Q], v: &[f64; N], outputs: &mut [f64])",
        Ending::Slice("outputs"),
    ),
    (
        "events",
        "(&self, t: f64, q: &[f64; Q], v: &[f64; N], events: &mut [f64])",
        Ending::Slice("events"),
    ),
    (
        "points",
        "(&self, t: f64, q: &[f64; Q], points: &mut [[f64; 3]])",
        Ending::Points,
    ),
    (
        "reactions",
        "(&self, t: f64, q: &[f64; Q], v: &[f64; N], acceleration: &[f64; N], lambda: &[f64; R], reactions: &mut [f64])",
        Ending::Slice("reactions"),
    ),
    (
        "accelerations",
        "(&self, t: f64, q: &[f64; Q], v: &[f64; N], correction: &[f64; R], acceleration: &mut [f64; N], lambda: &mut [f64; R], pivot_loss: &mut [f64; R]) -> bool",
        Ending::Available,
    ),
    (
        "metric",
        "(&self, mass: &Self::Mass, t: f64, q: &[f64; Q], a: &[[f64; N]; R], w: &mut [[f64; N]; R], delassus: &mut [[f64; R]; R])",
        Ending::Writes,
    ),
    (
        "row_rates",
        "(&self, a: &[[f64; N]; R], v: &[f64; N], rates: &mut [f64; R])",
        Ending::Writes,
    ),
];

/// A method that has to exist even where its straight-line code would be too long, and what it calls then.
struct Kernel {
    name: &'static str,
    signature: &'static str,
    /// Where M⁻¹ is a field.
    constant_mass: &'static str,
    /// Where M was factored.
    varying_mass: &'static str,
}

const KERNELS: &[Kernel] = &[
    Kernel {
        name: "solve_mass",
        signature: "(&self, mass: &Self::Mass, x: &mut [f64; N])",
        constant_mass: "::mbs_runtime::generated::multiply(&self.inverse_mass, x);",
        varying_mass: "mass.solve(x);",
    },
    Kernel {
        name: "solve_mass_rows",
        signature: "(&self, mass: &Self::Mass, a: &[[f64; N]; R], w: &mut [[f64; N]; R])",
        constant_mass: "::mbs_runtime::generated::multiply_rows(&self.inverse_mass, a, w);",
        varying_mass: "for (w, a) in w.iter_mut().zip(a) { *w = *a; self.solve_mass(mass, w); }",
    },
    Kernel {
        name: "delassus",
        signature: "(&self, a: &[[f64; N]; R], w: &[[f64; N]; R], delassus: &mut [[f64; R]; R])",
        constant_mass: "::mbs_runtime::generated::delassus(a, w, delassus);",
        varying_mass: "::mbs_runtime::generated::delassus(a, w, delassus);",
    },
];

/// Methods of F, the methods of f that compute the same where M is constant, and the call of the latter.
const SAME_WHERE_MASS_IS_CONSTANT: &[(&str, &str, &str)] = &[
    (
        "forces",
        "applied_forces",
        "self.applied_forces(t, q, v, f);",
    ),
    (
        "force_tangents",
        "applied_force_tangents",
        "self.applied_force_tangents(t, q, v, f_q, f_v);",
    ),
];

/// How the body of a method ends.
#[derive(Clone, Copy)]
enum Ending {
    /// Writes into arrays of known size and into sinks, or a return value.
    Writes,
    /// A slice of the caller's length receives as many values as fit.
    Slice(&'static str),
    /// The same for points.
    Points,
    /// Writes, and tells that there was something to write.
    Available,
}

/// A signature with the sizes of the program.
fn sized(signature: &str, program: &Program) -> String {
    signature
        .replace("; Q]", &format!("; {}]", program.coordinates))
        .replace("; N]", &format!("; {}]", program.size))
        .replace("; R]", &format!("; {}]", program.rows.len()))
}

/// All methods, as text.
pub(super) fn bodies(graph: &Graph, program: &Program) -> String {
    let mut out = String::new();
    out.push_str("fn inputs(&self) -> &[f64] { &self.inputs }\nfn inputs_mut(&mut self) -> &mut [f64] { &mut self.inputs }\n");
    let body = Body::of_method(graph, &program.guesses);
    let _ = writeln!(
        out,
        "fn guess(&self) -> ([f64; {0}], [f64; {1}]) {{ let (mut q, mut v) = ([0.0; {0}], [0.0; {1}]); {2} {3} (q, v) }}",
        program.coordinates,
        program.size,
        body.statements(),
        body.writes()
    );
    let find = |name: &str| program.function(name);
    for ((name, signature), body) in motion::SIGNATURES
        .into_iter()
        .zip(motion::bodies(graph, program))
    {
        let _ = writeln!(
            out,
            "#[inline]\nfn {name}{} {{ {body} }}",
            sized(signature, program)
        );
    }
    for (name, signature, ending) in METHODS {
        if let Some(function) = find(name) {
            // Where M is constant ∂T/∂q is zero, and F is f.
            let same = SAME_WHERE_MASS_IS_CONSTANT
                .iter()
                .find(|(total, ..)| total == name && program.structure.constant_mass);
            if let Some((_, applied, call)) = same
                && find(applied).is_some_and(|applied| applied.computes_the_same(function))
            {
                let signature = sized(signature, program);
                let cost = function.cost();
                let _ = writeln!(
                    out,
                    "/// {cost}\n#[inline]\nfn {name}{signature} {{ {call} }}"
                );
                continue;
            }
            method(
                &mut out,
                graph,
                function,
                &sized(signature, program),
                *ending,
            );
        }
    }
    sparse::methods(&mut out, graph, program);
    for kernel in KERNELS {
        let (name, signature) = (kernel.name, sized(kernel.signature, program));
        if let Some(function) = find(name) {
            method(&mut out, graph, function, &signature, Ending::Writes);
            continue;
        }
        let call = match program.constant_mass {
            Some(_) => kernel.constant_mass,
            None => kernel.varying_mass,
        };
        let _ = writeln!(out, "fn {name}{signature} {{ {call} }}");
    }
    factor_mass(&mut out, graph, program);
    out
}

/// The factor of M: nothing where M is constant, straight-line code where that is short, else by loops.
fn factor_mass(out: &mut String, graph: &Graph, program: &Program) {
    let size = program.size;
    let (cost, body) = match (&program.constant_mass, program.factor_entries()) {
        (Some(_), _) => (String::new(), "::core::option::Option::Some(())".to_owned()),
        (None, Some((function, entries))) => {
            let body = Body::of_method(graph, function);
            let text = format!(
                "let (mut factor, mut pivot_loss) = ([0.0; {entries}], [0.0; {size}]);\n{}{}::mbs_runtime::generated::positive(&factor, &pivot_loss).then_some(factor)",
                body.statements(),
                body.writes()
            );
            (format!("/// {}\n", function.cost()), text)
        }
        (None, None) => (
            String::new(),
            format!(
                "let mut mass = [[0.0; {size}]; {size}]; self.mass_matrix(q, &mut mass); ::mbs_runtime::generated::Cholesky::new(&mass)"
            ),
        ),
    };
    let _ = writeln!(
        out,
        "{cost}#[inline]\nfn factor_mass(&self, q: &[f64; {}]) -> ::core::option::Option<Self::Mass> {{ {body} }}",
        program.coordinates
    );
}

/// One method, with its cost as documentation.
fn method(out: &mut String, graph: &Graph, function: &Function, signature: &str, ending: Ending) {
    let body = Body::of_method(graph, function);
    let statements = body.statements();
    let copy = |slice: &str, values: String| {
        format!(
            "for (place, value) in {slice}.iter_mut().zip([{values}] as [_; {}]) {{ *place = value; }}",
            function.outputs.len()
        )
    };
    let end = match ending {
        Ending::Writes => body.writes(),
        Ending::Available => body.writes() + "true",
        Ending::Slice(_) | Ending::Points if function.outputs.is_empty() => String::new(),
        Ending::Slice(slice) => copy(slice, body.values().join(", ")),
        Ending::Points => {
            let points: Vec<String> = body
                .values()
                .chunks(3)
                .map(|point| format!("[{}]", point.join(", ")))
                .collect();
            format!(
                "for (place, value) in points.iter_mut().zip([{}]) {{ *place = value; }}",
                points.join(", ")
            )
        }
    };
    let _ = writeln!(
        out,
        "/// {}\n#[inline]\nfn {}{signature} {{\n{statements}{end}\n}}",
        function.cost(),
        function.name
    );
}

/// The same signatures without bodies.
pub(super) fn stubs(program: &Program) -> String {
    let mut out = String::new();
    let mut stub = |name: &str, signature: &str| {
        let _ = writeln!(
            out,
            "fn {name}{} {{ loop {{}} }}",
            sized(signature, program)
        );
    };
    stub("inputs", "(&self) -> &[f64]");
    stub("inputs_mut", "(&mut self) -> &mut [f64]");
    stub("guess", "(&self) -> ([f64; Q], [f64; N])");
    for (name, signature) in motion::SIGNATURES {
        stub(name, signature);
    }
    stub(
        "factor_mass",
        "(&self, q: &[f64; Q]) -> ::core::option::Option<Self::Mass>",
    );
    for (name, signature, _) in METHODS {
        stub(name, signature);
    }
    for kernel in KERNELS {
        stub(kernel.name, kernel.signature);
    }
    out
}
