//! The declared type: parameters as public fields.

use super::abridged::abridged;
use super::body::{Body, number};
use super::checks;
use super::fields::{Field, fields, places, quantities};
use super::items::{self, visibility};
use super::metadata::lines;
use super::motion;
use super::progressions::looped;
use super::size::Size;
use super::states;
use super::tables;
use super::text::{doc, tokens};
use crate::analysis::Analysis;
use crate::dag::{Operand, Program};
use crate::mobility;
use crate::model::{Outline, Quantity};
use crate::syntax::{Declaration, Instance, Port};
use proc_macro2::TokenStream;
use quote::quote;
use std::collections::BTreeMap;
use std::fmt::Write;

/// More entries of M are written in loops.
const MOST_ENTRIES: usize = 200;

/// A value in as many places of M has a loop of its own.
const OFTEN: usize = 16;

/// More defaults of a family are not listed in its documentation.
const MOST_DEFAULTS: usize = 6;

/// The struct and its default.
pub(super) fn emit(
    declaration: &Declaration,
    analysis: &Analysis,
    program: &Program,
) -> TokenStream {
    let documentation = documentation(analysis, program);
    structure(declaration, &analysis.outline.parameters, &documentation)
}

/// The same for an assembly.
pub(super) fn of_assembly(
    declaration: &Declaration,
    ports: &[Port],
    parameters: &[Quantity],
) -> TokenStream {
    let name = &declaration.name;
    let mut about = String::new();
    if !declaration.doc.is_empty() {
        let _ = writeln!(about, "{}\n", declaration.doc);
    }
    let _ = writeln!(
        about,
        "An assembly: `name: Assembly({name}, …)` puts it in place. The fields are its parameters."
    );
    if !ports.is_empty() {
        let _ = writeln!(
            about,
            "\n| port | takes | if left out | |\n|---|---|---|---|"
        );
    }
    for port in ports {
        let default = port.default.as_ref().map_or_else(
            || "required".to_owned(),
            |default| format!("`{}`", quote! { #default }),
        );
        let (name, takes, doc) = (
            &port.name,
            port.takes.describe(),
            port.doc.replace('\n', " "),
        );
        let _ = writeln!(about, "| `{name}` | {takes} | {default} | {doc} |");
    }
    let structure = structure(declaration, parameters, &about);
    quote! {
        #[allow(dead_code)]
        #structure
    }
}

fn structure(
    declaration: &Declaration,
    parameters: &[Quantity],
    documentation: &str,
) -> TokenStream {
    let name = &declaration.name;
    let visibility = visibility(declaration);
    let documentation = doc(documentation);
    let fields = fields(declaration, parameters);
    let declared = fields.iter().map(|field| {
        let (name, kind) = (&field.name, field.kind(&path_of));
        let about = field.about(|defaults| format!("; {} by default", by_default(defaults)));
        quote! { #about pub #name: #kind, }
    });
    let default = |_, parameter: &Quantity| match &parameter.constant {
        Some(constant) => quote! { #constant },
        None => tokens(&number(parameter.default)),
    };
    let defaults = fields.iter().map(|field| {
        let name = &field.name;
        let value = field.value(&default, &|instance, fields| {
            let kind = path_of(instance, fields);
            let mut places = places(fields, &quote! { member }).into_iter();
            let values = quantities(fields);
            let changes = values.iter().map(|value| {
                let (place, value) = (places.next(), default(0, value));
                quote! { #place = #value; }
            });
            quote! {{
                let mut member: #kind = ::core::default::Default::default();
                #( #changes )*
                member
            }}
        });
        quote! { #name: #value, }
    });
    quote! {
        #documentation
        #[derive(Debug, Clone, Copy, PartialEq)]
        #[allow(clippy::all, clippy::pedantic, clippy::nursery, non_snake_case)]
        #visibility struct #name {
            #( #declared )*
        }

        // A default of 45° is an approximate π/4, and meant.
        #[allow(clippy::all, clippy::pedantic, clippy::nursery)]
        impl ::core::default::Default for #name {
            fn default() -> Self {
                Self { #( #defaults )* }
            }
        }
    }
}

/// The parameters of an assembly are a struct of the assembly's own name.
fn path_of(instance: &Instance, _: &[Field]) -> TokenStream {
    let path = &instance.path;
    quote! { #path }
}

/// The defaults of a parameter, or of a family of them, in words.
fn by_default(defaults: &[f64]) -> String {
    match defaults {
        [first, others @ ..] if others.iter().all(|other| other == first) => first.to_string(),
        few if few.len() <= MOST_DEFAULTS => format!("{few:?}"),
        _ => "each its own value".to_owned(),
    }
}

fn documentation(analysis: &Analysis, program: &Program) -> String {
    let (outline, layout) = (&analysis.outline, &analysis.derived.system.layout);
    let mut out = String::new();
    if !outline.doc.is_empty() {
        let _ = writeln!(out, "{}\n", outline.doc);
    }
    let states = &layout.states;
    let is_state = |slot: usize| states.iter().any(|&state| layout.slots[state] == slot);
    let coordinates = layout.coordinates.iter().enumerate();
    let coordinates = coordinates.filter(|(slot, _)| !is_state(*slot));
    let coordinates: Vec<String> = coordinates
        .map(|(_, stored)| format!("`{}`", stored.name))
        .collect();
    let noun = match coordinates.len() {
        1 => "coordinate",
        _ => "coordinates",
    };
    let _ = writeln!(
        out,
        "A mechanism with {} generalized {noun}: {}.",
        coordinates.len(),
        abridged(coordinates).join(", ")
    );
    if let Some(mobility) = &analysis.mobility {
        let _ = writeln!(
            out,
            "\n{}.",
            mobility::summary(mobility, &program.rows, program.size - states.len())
        );
    }
    for sentence in abridged(outline.reductions.clone()) {
        let _ = writeln!(out, "* {sentence}");
    }
    out + &names(outline, &program.reactions)
}

/// Reading and setting of values by name.
fn names(outline: &Outline, reactions: &[(String, String, String)]) -> String {
    let with_unit = |name: &str, unit: &str| match unit {
        "" => format!("`{name}`"),
        _ => format!("`{name}` ({unit})"),
    };
    let quantity = |quantity: &Quantity| with_unit(&quantity.name, &quantity.unit);
    let mut joints: Vec<String> = Vec::new();
    for (joint, component, unit) in reactions {
        let component = with_unit(component, unit);
        match joints.last_mut() {
            Some(last) if last.starts_with(&format!("`{joint}`: ")) => {
                let _ = write!(last, ", {component}");
            }
            _ => joints.push(format!("`{joint}`: {component}")),
        }
    }
    let lists = [
        (
            "Inputs",
            outline.inputs.iter().map(quantity).collect(),
            ", ",
        ),
        (
            "Outputs",
            outline.outputs.iter().map(quantity).collect(),
            ", ",
        ),
        (
            "Events",
            outline
                .events
                .iter()
                .map(|name| format!("`{name}`"))
                .collect(),
            ", ",
        ),
        ("Reactions", joints, "; "),
    ];
    let mut out = String::new();
    for (title, list, separator) in lists as [(&str, Vec<String>, &str); 4] {
        if !list.is_empty() {
            let _ = writeln!(out, "\n{title}: {}.", abridged(list).join(separator));
        }
    }
    out
}

/// `impl Mechanism`.
pub(super) fn emit_mechanism(
    declaration: &Declaration,
    analysis: &Analysis,
    program: &Program,
    size: &mut Size,
) -> TokenStream {
    let (outline, name) = (&analysis.outline, &declaration.name);
    let system = items::system(declaration);
    let (coordinates, velocities, rows) = (program.coordinates, program.size, program.rows.len());
    let fields = places(&fields(declaration, &outline.parameters), &quote! { self });
    let names: Vec<&str> = outline
        .parameters
        .iter()
        .map(|parameter| parameter.name.as_str())
        .collect();
    let body = preparation(analysis, program, &system.to_string());
    size.add("prepare", &body);
    let body = tokens(&body);
    quote! {
        #[allow(clippy::all, clippy::pedantic, clippy::nursery, unused_variables, unused_mut)]
        impl ::mbs_runtime::Mechanism for #name {
            type System = #system;
            const MODEL: &'static ::mbs_runtime::Model = <#system as ::mbs_runtime::System<#coordinates, #velocities, #rows>>::MODEL;

            fn prepare(&self) -> ::core::result::Result<#system, ::mbs_runtime::ParameterError> {
                #[allow(unused_imports)]
                use ::mbs_runtime::generated::Elementary as _;
                #( ::mbs_runtime::generated::check_finite(#names, #fields)?; )*
                #body
            }

            fn parameter(&self, name: &str) -> ::core::option::Option<f64> {
                match name {
                    #( #names => ::core::option::Option::Some(#fields), )*
                    _ => ::core::option::Option::None,
                }
            }

            fn set_parameter(&mut self, name: &str, value: f64) -> ::core::result::Result<(), ::mbs_runtime::UnknownName> {
                match name {
                    #( #names => { #fields = value; ::core::result::Result::Ok(()) } )*
                    _ => ::core::result::Result::Err(::mbs_runtime::UnknownName::new("parameter", name, [#( #names ),*])),
                }
            }
        }
    }
}

/// Constants before M⁻¹, M⁻¹, constants after it, and the system that holds them.
fn preparation(analysis: &Analysis, program: &Program, system: &str) -> String {
    let (outline, equations) = (&analysis.outline, &analysis.derived.system);
    let (layout, graph) = (&equations.layout, &equations.graph);
    let [before, after] = &program.preparation;
    let mut out = String::new();
    let write = |out: &mut String, function| {
        let body = Body::of_preparation(graph, function, system);
        out.push_str(&body.statements());
        out.push_str(&body.writes());
    };
    out.push_str(&tables::preparation(graph, &outline.tables));
    write(&mut out, before);
    out.push_str(&checks::emit(equations, &program.checks, system));
    let operand = |value: Operand| match value {
        Operand::Number(value) => number(value.value()),
        Operand::Constant(slot) => format!("k{slot}"),
        Operand::Symbol(symbol) => format!("self.{}", graph.name(symbol)),
        Operand::Value(_) => unreachable!("what depends on parameters alone is a constant"),
    };
    if !program.rotations.is_empty() {
        out.push_str(&motion::spins(program, operand));
    }
    if let Some(entries) = &program.constant_mass {
        let size = program.size;
        let (clear, invert) = match items::factors_mass(program) {
            true => (format!("LongMass::<{size}>::zeros"), "factored_mass"),
            false => (format!("clear_mass::<{size}>"), "inverse_mass"),
        };
        let _ = writeln!(out, "let mut mass = ::mbs_runtime::generated::{clear}();");
        write_mass(&mut out, entries, operand);
        let coordinates = layout
            .slots
            .iter()
            .zip(&layout.velocities)
            .map(|(&slot, velocity)| {
                let coordinate = &layout.coordinates[slot].name;
                match velocity.name.strip_suffix('\'') {
                    Some(_) => coordinate.as_str(),
                    None => velocity.name.as_str(),
                }
            });
        let _ = writeln!(
            out,
            "let inverse_mass = {}::mbs_runtime::generated::{invert}(&mut mass, {})?;",
            if items::boxes_inverse(size) { "" } else { "*" },
            lines(coordinates.collect())
        );
    }
    write(&mut out, after);
    out.push_str(&states::preparation(equations, program, system));
    let inputs: Vec<String> = outline
        .inputs
        .iter()
        .map(|input| number(input.default))
        .collect();
    let inverse = if program.constant_mass.is_some() {
        "inverse_mass, "
    } else {
        ""
    };
    let spins = if program.rotations.is_empty() {
        ""
    } else {
        "spins, "
    };
    let states = match equations.scales.is_empty() {
        true => "",
        false => "states, ",
    };
    let constants = (0..program.constants.len()).map(|slot| format!("k{slot}"));
    let fields = tables::names(&outline.tables).chain(constants);
    let fields = fields.fold(String::new(), |text, field| text + &field + ", ");
    let _ = writeln!(
        out,
        "::core::result::Result::Ok({system} {{ parameters: *self, inputs: [{}], {inverse}{spins}{states}{fields} }})",
        inputs.join(", ")
    );
    out
}

/// M, entry by entry; where these are many, in a loop for each value that occurs often, and in loops over the others.
fn write_mass(
    out: &mut String,
    entries: &[(usize, usize, Operand)],
    source: impl Fn(Operand) -> String,
) {
    if entries.len() <= MOST_ENTRIES {
        for &(i, j, value) in entries {
            let value = source(value);
            let _ = writeln!(out, "mass[({i}, {j})] = {value};");
            if i != j {
                let _ = writeln!(out, "mass[({j}, {i})] = {value};");
            }
        }
        return;
    }
    let mut places: BTreeMap<String, Vec<(usize, usize)>> = BTreeMap::new();
    for &(i, j, value) in entries {
        let places = places.entry(source(value)).or_default();
        places.push((i, j));
    }
    let both = |value: &str, (i, j): &(usize, usize)| {
        format!("mass[({i}, {j})] = {value}; mass[({j}, {i})] = {value};")
    };
    let (often, seldom): (BTreeMap<_, _>, BTreeMap<_, _>) =
        (places.into_iter()).partition(|(_, places)| places.len() >= OFTEN);
    for (value, places) in often {
        let statements = places.iter().map(|place| both(&value, place));
        if let Some(loops) = looped(statements.collect()) {
            out.push_str(&loops);
            continue;
        }
        let places = places.iter().map(|(i, j)| format!("({i}, {j})"));
        let places: Vec<String> = places.collect();
        let _ = writeln!(
            out,
            "for &(i, j) in &[{}] {{ mass[(i, j)] = {value}; mass[(j, i)] = {value}; }}",
            places.join(", ")
        );
    }
    let mut seldom: Vec<((usize, usize), String)> = (seldom.into_iter())
        .flat_map(|(value, places)| places.into_iter().map(move |place| (place, value.clone())))
        .collect();
    seldom.sort_unstable();
    let statements = seldom.iter().map(|(place, value)| both(value, place));
    if let Some(loops) = looped(statements.collect()) {
        out.push_str(&loops);
        return;
    }
    for part in seldom.chunks(MOST_ENTRIES) {
        let list = part
            .iter()
            .map(|((i, j), value)| format!("({i}, {j}, {value})"));
        let list: Vec<String> = list.collect();
        let _ = writeln!(
            out,
            "for (i, j, value) in [{}] {{ mass[(i, j)] = value; mass[(j, i)] = value; }}",
            list.join(", ")
        );
    }
}
