//! Arguments of a long function, copied to the array of its values.

use super::progressions::looped;
use std::fmt::Write;

/// Fewer elements that follow each other are copied one by one.
const SHORTEST: usize = 8;

/// Statements that copy sources to the first places of an array; elements that follow each other are copied at once.
pub(super) fn copies(to: &str, sources: &[String]) -> String {
    let mut out = String::new();
    let mut single: Vec<&str> = Vec::new();
    let mut first = 0;
    while first < sources.len() {
        let length = run(&sources[first..]);
        match element(&sources[first]) {
            Some((array, from)) if length >= SHORTEST => {
                one_by_one(&mut out, to, first, &mut single);
                let _ = writeln!(
                    out,
                    "{to}[{first}..{}].copy_from_slice(&{array}[{from}..{}]);",
                    first + length,
                    from + length
                );
            }
            _ => single.extend(sources[first..first + length].iter().map(String::as_str)),
        }
        first += length;
    }
    one_by_one(&mut out, to, first, &mut single);
    out
}

/// Copies the sources before a place.
fn one_by_one(out: &mut String, to: &str, end: usize, sources: &mut Vec<&str>) {
    if sources.is_empty() {
        return;
    }
    let first = end - sources.len();
    let places = sources.iter().zip(first..);
    let single = places.map(|(source, place)| format!("{to}[{place}] = {source};"));
    if let Some(loops) = looped(single.collect()) {
        out.push_str(&loops);
    } else {
        let _ = writeln!(
            out,
            "for (value, input) in {to}[{first}..{end}].iter_mut().zip([{}]) {{ *value = input; }}",
            sources.join(", ")
        );
    }
    sources.clear();
}

/// How many of the first sources follow each other in one array; at least one.
fn run(sources: &[String]) -> usize {
    let Some((array, first)) = sources.first().and_then(|source| element(source)) else {
        return 1;
    };
    let next = sources.iter().enumerate();
    next.take_while(|(i, source)| element(source) == Some((array, first + i)))
        .count()
}

/// Array and index of `array[index]`.
pub(super) fn element(source: &str) -> Option<(&str, usize)> {
    let (array, index) = source.strip_suffix(']')?.split_once('[')?;
    Some((array, index.parse().ok()?))
}
