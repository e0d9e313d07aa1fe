//! Members of families in documentation: of many that differ in their indices alone the first, and their number.

use std::collections::HashMap;

/// So many members are all listed.
const MOST: usize = 100;

/// Names or sentences, without most of those that differ in indices alone: the first of these says how many more there are.
pub(super) fn abridged(list: Vec<String>) -> Vec<String> {
    if list.len() <= MOST {
        return list;
    }
    let keys: Vec<String> = list.iter().map(|text| without_indices(text)).collect();
    let mut counts: HashMap<&str, usize> = HashMap::new();
    for key in &keys {
        *counts.entry(key).or_insert(0) += 1;
    }
    let mut kept = Vec::new();
    for (text, key) in list.into_iter().zip(&keys) {
        match counts.get_mut(key.as_str()) {
            // The first of many was listed.
            Some(0) => {}
            Some(count) if *count > MOST => {
                kept.push(format!("{text} (and {} more like it)", *count - 1));
                *count = 0;
            }
            _ => kept.push(text),
        }
    }
    kept
}

/// A text without what is in brackets: `crank[3].b` is `crank[].b`.
fn without_indices(text: &str) -> String {
    let mut parts = text.split('[');
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |text, part| {
        text + part.split_once(']').map_or(part, |(_, rest)| rest)
    })
}
