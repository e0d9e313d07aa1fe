//! Members of families in lists: of many that differ in their indices alone the first, and their number.

use std::collections::HashMap;

/// So many members are all listed.
const MOST: usize = 8;

/// Rows of a table, without most of those that differ in indices alone: a line says how many these are.
pub(super) fn abridged<const COLUMNS: usize>(
    rows: Vec<[String; COLUMNS]>,
) -> Vec<[String; COLUMNS]> {
    let keys: Vec<String> = rows
        .iter()
        .map(|row| without_indices(&row.join("\t")))
        .collect();
    let mut counts: HashMap<&str, usize> = HashMap::new();
    for key in &keys {
        *counts.entry(key).or_insert(0) += 1;
    }
    let mut kept = Vec::new();
    for (row, key) in rows.into_iter().zip(&keys) {
        match counts.get_mut(key.as_str()) {
            // The first of many was listed.
            Some(0) => {}
            Some(count) if *count > MOST => {
                kept.push(row);
                let mut more = [const { String::new() }; COLUMNS];
                more[0] = format!("… and {} more like this", *count - 1);
                kept.push(more);
                *count = 0;
            }
            _ => kept.push(row),
        }
    }
    kept
}

/// A text without what is in brackets: `crank[3].b` is `crank[].b`.
fn without_indices(text: &str) -> String {
    let mut inside = false;
    let outside = text.chars().filter(|&c| {
        inside = (inside || c == '[') && c != ']';
        !inside || c == '['
    });
    outside.collect()
}
