//! Lines of LLVM IR of a user's crate before any optimisation, by the origin of each function.

use std::collections::BTreeMap;

/// Lines by origin.
pub type Lines = BTreeMap<&'static str, usize>;

/// What belongs to no method in particular.
const SHARED: [(&str, &[&str]); 3] = [
    ("generated equations", &["user::"]),
    (
        "linear algebra",
        &[
            "mbs_runtime::linear",
            "mbs_runtime::generated",
            "nalgebra::",
            "bytemuck::",
        ],
    ),
    ("core and alloc", &["core::", "alloc::", "std::"]),
];

/// The methods that only `with_any_method` compiles, with their modules.
const METHODS: [(&str, &[&str]); 10] = [
    ("Algorithm 1, M-ALF", &["mbs_runtime::alf3f::paper"]),
    ("RATTLE", &["mbs_runtime::baselines::rattle"]),
    (
        "Runge–Kutta",
        &[
            "mbs_runtime::baselines::runge_kutta",
            "mbs_runtime::baselines::tableau",
            "mbs_runtime::baselines::adaptive",
        ],
    ),
    ("Baumgarte", &["mbs_runtime::baselines::baumgarte"]),
    ("backward differentiation", &["mbs_runtime::baselines::bdf"]),
    (
        "Radau IIA",
        &[
            "mbs_runtime::baselines::radau",
            "mbs_runtime::baselines::complex_saddle",
        ],
    ),
    (
        "generalized α",
        &["mbs_runtime::baselines::generalized_alpha"],
    ),
    (
        "index-3 projections",
        &["mbs_runtime::baselines::index3_projections"],
    ),
    ("penalties", &["mbs_runtime::baselines::penalty"]),
    ("shared by these", &["mbs_runtime::baselines"]),
];
/// All else of the runtime.
const TWO_LEVEL: &str = "two-level method, simulation";

/// The rows of the table, with the lines of the usual program and of one with all methods.
pub fn rows(usual: &str, any: &str) -> Vec<(String, usize)> {
    let (usual, any) = (count(usual), count(any));
    let of = |lines: &Lines, origin: &str| lines.get(origin).copied().unwrap_or(0);
    let mut rows = Vec::new();
    let shared = SHARED.iter().map(|(origin, _)| *origin);
    let shared: Vec<&str> = shared.chain([TWO_LEVEL]).collect();
    for origin in &shared {
        rows.push(((*origin).to_owned(), of(&usual, origin)));
    }
    for (method, _) in METHODS {
        rows.push((method.to_owned(), of(&any, method)));
    }
    let more = shared
        .iter()
        .map(|origin| of(&any, origin).saturating_sub(of(&usual, origin)));
    rows.push(("more of the first four with these".to_owned(), more.sum()));
    rows
}

/// Lines of each function, by its path: the comment before its definition.
fn count(text: &str) -> Lines {
    let mut lines = Lines::new();
    let (mut path, mut length) = ("", None);
    for line in text.lines() {
        match line.strip_prefix("; ") {
            Some(comment) if length.is_none() && !comment.starts_with("Function Attrs") => {
                path = comment;
            }
            _ => {}
        }
        if line.starts_with("define ") {
            length = Some(0);
        }
        length = length.map(|length| length + 1);
        if line == "}"
            && let Some(length) = length.take()
        {
            *lines.entry(origin(path)).or_default() += length;
        }
    }
    lines
}

/// The origin whose module is named first in a path.
fn origin(path: &str) -> &'static str {
    let all = SHARED.iter().chain(&METHODS).enumerate();
    let found = all.filter_map(|(order, (origin, modules))| {
        let places = modules.iter().filter_map(|module| path.find(module));
        // `baselines` is found where a method of them is, too: the first of the list is meant.
        Some((places.min()?, order, *origin))
    });
    let runtime = path.find("mbs_runtime::");
    match found.min() {
        Some((place, _, origin)) if runtime.is_none_or(|runtime| place <= runtime) => origin,
        _ if runtime.is_some() => TWO_LEVEL,
        _ => "core and alloc",
    }
}
