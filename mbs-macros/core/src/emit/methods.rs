//! The functions of the contract as Rust: one for each function of the program, and loops if that would be too long.

use super::body::Body;
use super::parts::LongFunctions;
use super::progressions::looped;
use super::size::Size;
use super::{motion, sparse};
use crate::contract::{Capability, METHODS, Method, Origin, Returns, Shape};
use crate::dag::{Function, Place, Program, TURNING};
use crate::symbolic::Graph;
use std::fmt::Write;

/// Functions of F, and the functions of f that can compute the same if M is constant.
const SAME_WHERE_MASS_IS_CONSTANT: &[(&str, &str)] = &[
    ("forces", "applied_forces"),
    ("force_tangents", "applied_force_tangents"),
];

/// The functions of one trait, as text.
pub(super) fn bodies(
    graph: &Graph,
    program: &Program,
    long: &LongFunctions,
    capability: Capability,
    size: &mut Size,
) -> String {
    let mut out = String::new();
    for method in METHODS
        .iter()
        .filter(|method| method.capability == capability)
    {
        let start = out.len();
        write_method(&mut out, graph, program, long, method);
        size.add(method.name, &out[start..]);
    }
    out
}

fn write_method(
    out: &mut String,
    graph: &Graph,
    program: &Program,
    long: &LongFunctions,
    method: &Method,
) {
    if sparse::replaces(out, graph, program, long, method) {
        return;
    }
    match (program.function(method.name), method.origin) {
        (_, Origin::Written) => {
            if let Some((cost, body)) = written(graph, program, method) {
                put(out, program, method, &cost, &body);
            }
        }
        (Some(function), _) => {
            let cost = format!("/// {}\n#[inline]\n", function.cost());
            let body = if let Some(applied) = applied(program, method, function) {
                applied.call()
            } else if let Some(turning) = program.turning_of(function) {
                let body = with_turning(graph, program, turning);
                let applied = Method::named("applied_forces").map(Method::call);
                return put_after(out, program, method, &cost, applied.as_deref(), &body);
            } else if let Some(parts) = long.body(graph, program, method) {
                parts
            } else {
                straight_line(graph, method, function)
            };
            put(out, program, method, &cost, &body);
        }
        (
            None,
            Origin::Kernel {
                constant_mass,
                written_factor,
                dense_factor,
                ..
            },
        ) => {
            let call = match (&program.constant_mass, program.factor_entries()) {
                (Some(_), _) => constant_mass,
                (None, Some(_)) => written_factor,
                (None, None) => dense_factor,
            };
            put(out, program, method, "", call);
        }
        // The trait has a default body.
        (None, Origin::Program) => {}
    }
}

fn put(out: &mut String, program: &Program, method: &Method, before: &str, body: &str) {
    put_after(out, program, method, before, None, body);
}

/// With a call before the body.
fn put_after(
    out: &mut String,
    program: &Program,
    method: &Method,
    before: &str,
    call: Option<&str>,
    body: &str,
) {
    let signature = method.signature(program);
    let call = call.map_or_else(String::new, |call| format!("{call}\n"));
    let arrays = arrays(method, body);
    let _ = writeln!(
        out,
        "{before}fn {}{signature} {{\n{call}{arrays}{body}\n}}",
        method.name
    );
}

/// The lines that make vectors and matrices arrays, for those that the body takes entry by entry.
pub(super) fn arrays(method: &Method, body: &str) -> String {
    let indexed = |name: &str| {
        let pattern = format!("{name}[");
        body.match_indices(&pattern).any(|(start, _)| {
            let before = body[..start].chars().next_back();
            !before.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == '.')
        })
    };
    let used = method
        .arguments
        .iter()
        .filter(|argument| indexed(argument.name));
    used.filter_map(|argument| argument.as_array())
        .fold(String::new(), |text, line| text + &line + "\n")
}

/// The function of f, if it computes the same: if M is constant, ∂T/∂q is zero.
fn applied(program: &Program, method: &Method, function: &Function) -> Option<&'static Method> {
    let mut pairs = SAME_WHERE_MASS_IS_CONSTANT.iter();
    let (_, applied) = pairs.find(|(total, _)| *total == method.name)?;
    let same = program.function(applied)?.computes_the_same(function);
    (program.structure.constant_mass && same).then(|| Method::named(applied))?
}

/// The terms of F that f has not, added to f.
fn with_turning(graph: &Graph, program: &Program, turning: &Function) -> String {
    let body = Body::of_method(graph, turning);
    format!(
        "let mut {TURNING} = [0.0; {}];\n{}{}for (f, {TURNING}) in f.iter_mut().zip({TURNING}) {{ *f += {TURNING}; }}",
        program.size,
        body.statements(),
        body.writes(),
    )
}

/// Temporaries, and the statements that write or return the results.
fn straight_line(graph: &Graph, method: &Method, function: &Function) -> String {
    let body = Body::of_method(graph, function);
    let statements = body.statements();
    let last = method.arguments.last();
    let values = || body.values();
    let copy = |to: &str, values: &str| {
        format!("for (place, value) in {to}.iter_mut().zip({values}) {{ *place = value; }}")
    };
    let end = match (last.map(|last| (last.name, last.shape)), method.returns) {
        (_, Returns::Available) => body.writes() + "true",
        (Some((_, Shape::Values | Shape::Points)), _) if function.outputs.is_empty() => {
            String::new()
        }
        (Some((name, Shape::Values)), _) => {
            let values = in_places(function, values());
            copy(name, &format!("[{}]", values.join(", ")))
        }
        (Some((name, Shape::Points)), _) => {
            let values = values();
            let points = values
                .chunks(3)
                .map(|point| format!("[{}]", point.join(", ")));
            let points: Vec<String> = points.collect();
            let single = points.iter().enumerate();
            let single = single.map(|(i, point)| format!("values[{i}] = {point};"));
            match looped(single.collect()) {
                Some(loops) => format!(
                    "let mut values = [[0.0; 3]; {}];\n{loops}{}",
                    points.len(),
                    copy(name, "values")
                ),
                None => copy(name, &format!("[{}]", points.join(", "))),
            }
        }
        _ => body.writes(),
    };
    statements + &end
}

/// The values in the order of their places; those that are not computed are no numbers. (Outputs that read accelerations stand among
/// the others.)
fn in_places(function: &Function, values: Vec<String>) -> Vec<String> {
    let mut placed = Vec::with_capacity(values.len());
    for (output, value) in function.outputs.iter().zip(values) {
        if let Place::Element(place) = output.place {
            let gap = place.saturating_sub(placed.len());
            placed.extend(std::iter::repeat_n("f64::NAN".to_owned(), gap));
        }
        placed.push(value);
    }
    placed
}

/// Functions that are not in the program: attributes and comments before them, and the body.
fn written(graph: &Graph, program: &Program, method: &Method) -> Option<(String, String)> {
    let body = match method.name {
        "inputs" => "&self.inputs".to_owned(),
        "inputs_mut" => "&mut self.inputs".to_owned(),
        "guess" => {
            let body = Body::of_method(graph, &program.guesses);
            format!(
                "let (mut q, mut v) = (SVector::zeros(), SVector::zeros());\n{}{{ let (q, v) = (entries_mut(&mut q), entries_mut(&mut v));\n{} }}\n(q, v)",
                body.statements(),
                body.writes()
            )
        }
        "factor_mass" => return Some(factor_mass(graph, program)),
        "sparse_constraints" | "sparse_mass" => return None,
        name => motion::body(graph, program, name),
    };
    let inline = match method.returns {
        Returns::Inputs | Returns::InputsMut | Returns::Guess => "",
        _ => "#[inline]\n",
    };
    Some((inline.to_owned(), body))
}

/// The factor of M: empty if M is constant, straight-line code if that is short, otherwise loops.
fn factor_mass(graph: &Graph, program: &Program) -> (String, String) {
    let inline = "#[inline]\n".to_owned();
    match (&program.constant_mass, program.factor_entries()) {
        (Some(_), _) => (inline, "::core::option::Option::Some(())".to_owned()),
        (None, Some((function, entries))) => {
            let body = Body::of_method(graph, function);
            let text = format!(
                "let (mut factor, mut pivot_loss) = ([0.0; {entries}], [0.0; {}]);\n{}{}::mbs_runtime::generated::positive(&factor, &pivot_loss).then_some(factor)",
                program.size,
                body.statements(),
                body.writes()
            );
            (format!("/// {}\n{inline}", function.cost()), text)
        }
        (None, None) => (
            inline,
            "let mut mass = SMatrix::zeros(); self.mass_matrix(q, &mut mass); ::mbs_runtime::generated::Cholesky::new(&mass)".to_owned(),
        ),
    }
}

/// The same signatures without bodies.
pub(super) fn stubs(program: &Program, capability: Capability) -> String {
    let methods = METHODS
        .iter()
        .filter(|method| method.capability == capability)
        .filter(|method| {
            let has_default = matches!(method.name, "held" | "outputs_at_acceleration_level");
            !has_default || program.function(method.name).is_some()
        });
    methods.fold(String::new(), |text, method| {
        text + &format!(
            "fn {}{} {{ loop {{}} }}\n",
            method.name,
            method.signature(program)
        )
    })
}
