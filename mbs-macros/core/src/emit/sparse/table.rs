//! The pattern of an elimination in tables.

use crate::dag::Elimination;
use std::fmt::{Display, Write};

/// A function that returns the pattern.
pub(super) fn emit(out: &mut String, name: &str, elimination: &Elimination) {
    let table = elimination.table();
    let crossings = table.crossings.iter();
    let crossings: Vec<String> = crossings.map(|pair| format!("{pair:?}")).collect();
    let _ = writeln!(
        out,
        "fn {name}() -> &'static ::mbs_runtime::generated::pattern::Pattern {{
            static STARTS: [u32; {}] = [{}];
            static POSITIONS: [u32; {}] = [{}];
            static LISTS: [u32; {}] = [{}];
            static CROSSINGS: [[u32; 2]; {}] = [{}];
            static IS_ROW: [u8; {}] = [{}];
            static PATTERN: ::mbs_runtime::generated::pattern::Pattern = ::mbs_runtime::generated::pattern::Pattern {{
                starts: &STARTS, positions: &POSITIONS, lists: &LISTS, crossings: &CROSSINGS, is_row: &IS_ROW }};
            &PATTERN }}",
        table.starts.len(),
        list(&table.starts),
        table.positions.len(),
        list(&table.positions),
        table.lists.len(),
        list(&table.lists),
        crossings.len(),
        list(&crossings),
        table.is_row.len(),
        list(&table.is_row),
    );
}

fn list(items: &[impl Display]) -> String {
    items.iter().fold(String::new(), |mut text, item| {
        let _ = write!(text, "{item}, ");
        text
    })
}
