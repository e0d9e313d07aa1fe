//! The header of a mechanism, from its model.

use super::Status;
use crate::{Model, Quantity};
use std::fmt::Write;

/// Words that are no names in C or in C++, beside those that Rust refuses as well.
const RESERVED: [&str; 77] = [
    "alignas",
    "alignof",
    "and",
    "and_eq",
    "asm",
    "auto",
    "bitand",
    "bitor",
    "bool",
    "case",
    "catch",
    "char",
    "char16_t",
    "char32_t",
    "char8_t",
    "class",
    "co_await",
    "co_return",
    "co_yield",
    "compl",
    "concept",
    "const_cast",
    "consteval",
    "constexpr",
    "constinit",
    "decltype",
    "default",
    "delete",
    "double",
    "dynamic_cast",
    "explicit",
    "export",
    "float",
    "friend",
    "goto",
    "inline",
    "int",
    "linux",
    "long",
    "mutable",
    "namespace",
    "new",
    "noexcept",
    "not",
    "not_eq",
    "nullptr",
    "operator",
    "or",
    "or_eq",
    "private",
    "protected",
    "public",
    "register",
    "reinterpret_cast",
    "requires",
    "restrict",
    "short",
    "signed",
    "sizeof",
    "static_assert",
    "static_cast",
    "switch",
    "template",
    "this",
    "thread_local",
    "throw",
    "typedef",
    "typeid",
    "typename",
    "union",
    "unix",
    "unsigned",
    "void",
    "volatile",
    "wchar_t",
    "xor",
    "xor_eq",
];

/// The header of [`c_library!`](crate::c_library) with this name: C99, and C++.
pub fn header(name: &str, model: &Model) -> String {
    let mut out = String::new();
    // A text takes all that is written.
    let _ = write(&mut out, name, model);
    out
}

fn write(out: &mut String, name: &str, model: &Model) -> std::fmt::Result {
    let guard = name.to_uppercase();
    writeln!(
        out,
        "/* {}: written by mbs_runtime::c_interface::header. */",
        comment(model.name)
    )?;
    writeln!(out, "#ifndef {guard}_H\n#define {guard}_H\n")?;
    writeln!(
        out,
        "#include <stddef.h>\n\n#ifdef __cplusplus\nextern \"C\" {{\n#endif\n"
    )?;
    common(out)?;
    writeln!(
        out,
        "/* {} */\ntypedef struct {name} {name};\n",
        comment(match model.doc {
            "" => "A simulation.",
            doc => doc,
        })
    )?;
    for (what, quantities) in [
        ("parameters", model.parameters),
        ("inputs", model.inputs),
        ("outputs", model.outputs),
    ] {
        structure(out, &format!("{name}_{what}"), what, quantities)?;
    }
    let (q, v) = (model.coordinates.len(), model.velocities.len());
    writeln!(
        out,
        "/* Numbers of coordinates and of velocities. */\nenum {{ {guard}_COORDINATES = {q}, {guard}_VELOCITIES = {v} }};\n"
    )?;
    functions(out, name)?;
    writeln!(out, "#ifdef __cplusplus\n}}\n#endif\n\n#endif")
}

/// What the headers of several mechanisms have in common.
fn common(out: &mut String) -> std::fmt::Result {
    writeln!(
        out,
        "#ifndef MBS_STATUS\n#define MBS_STATUS\n/* What calls return; NAME_message has the text. */\nenum {{"
    )?;
    for (status, name) in Status::NAMES {
        let about = match status {
            Status::Ok => "all is well",
            Status::Null => "a pointer is null or not aligned",
            Status::Size => "a size is not that of the struct or array",
            Status::Value => "a value that a parameter, setting or input cannot have",
            Status::Assembly => "the mechanism cannot be assembled",
            Status::Step => "a step failed, and the state is that before it",
            Status::Internal => "an error in the library: free the simulation",
        };
        writeln!(out, "    {name} = {}, /* {about} */", status as i32)?;
    }
    writeln!(
        out,
        "}};\n\n/* In J; works since the start. */\ntypedef struct {{\n    double kinetic;\n    double potential;\n    double nonconservative_work;\n    double drive_work;\n    double error; /* of the balance */\n}} mbs_energy;\n#endif\n"
    )
}

fn structure(
    out: &mut String,
    name: &str,
    what: &str,
    quantities: &[Quantity],
) -> std::fmt::Result {
    writeln!(out, "typedef struct {{")?;
    if quantities.is_empty() {
        writeln!(out, "    double none; /* there are no {what} */")?;
    }
    for (quantity, field) in quantities.iter().zip(fields(quantities)) {
        let mut about = match quantity.unit {
            "" => "dimensionless".to_owned(),
            unit => format!("in {unit}"),
        };
        if what != "outputs" {
            write!(about, "; {} by default", quantity.default)?;
        }
        if !quantity.doc.is_empty() {
            about = format!("{} ({about})", quantity.doc);
        }
        writeln!(out, "    double {field}; /* {} */", comment(&about))?;
    }
    writeln!(out, "}} {name};\n")
}

/// The names as names of C, each once.
fn fields(quantities: &[Quantity]) -> Vec<String> {
    let mut fields: Vec<String> = Vec::new();
    for quantity in quantities {
        let plain = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
        let mut field: String = quantity.name.chars().map(plain).collect();
        // Of a name without letters of C one character stays.
        while field.len() > 1 && field.ends_with('_') && field != quantity.name {
            field.pop();
        }
        if RESERVED.contains(&field.as_str()) {
            field.push('_');
        }
        while fields.contains(&field) {
            field.push('_');
        }
        fields.push(field);
    }
    fields
}

/// A text that does not end the comment that it is in.
fn comment(text: &str) -> String {
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    lines.join(" ").replace("*/", "* /").replace("/*", "/ *")
}

fn functions(out: &mut String, name: &str) -> std::fmt::Result {
    let declared = [
        (
            "Writes the default parameters. `size` is sizeof *parameters; so in all calls.",
            "int NAME_default_parameters(NAME_parameters *parameters, size_t size);",
        ),
        (
            "Makes a simulation with steps of `step` seconds, and stores it at `simulation`: NULL where it cannot be made. One thread at a time may use it.",
            "int NAME_new(const NAME_parameters *parameters, size_t size, double step, NAME **simulation);",
        ),
        (
            "Frees it; nothing for NULL.",
            "void NAME_free(NAME *simulation);",
        ),
        ("One step.", "int NAME_step(NAME *simulation);"),
        (
            "Runs to a time in s, with a shorter step at the end.",
            "int NAME_run_until(NAME *simulation, double time);",
        ),
        (
            "The time in s.",
            "int NAME_time(const NAME *simulation, double *time);",
        ),
        (
            "Sets the inputs from now on: all, or none.",
            "int NAME_set_inputs(NAME *simulation, const NAME_inputs *inputs, size_t size);",
        ),
        (
            "The outputs now.",
            "int NAME_output(const NAME *simulation, NAME_outputs *outputs, size_t size);",
        ),
        (
            "Coordinates and velocities; sizes in bytes.",
            "int NAME_state(const NAME *simulation, double *positions, size_t positions_size, double *velocities, size_t velocities_size);",
        ),
        (
            "The energy balance.",
            "int NAME_energy(const NAME *simulation, mbs_energy *energy, size_t size);",
        ),
        (
            "The text of the last failure of this thread, cut where it does not fit; returns its length.",
            "size_t NAME_message(char *text, size_t size);",
        ),
    ];
    for (about, function) in declared {
        writeln!(out, "/* {about} */\n{}\n", function.replace("NAME", name))?;
    }
    Ok(())
}
