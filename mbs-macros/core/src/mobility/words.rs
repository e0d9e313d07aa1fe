//! Mobility in words.

use super::Mobility;
use crate::equations::Row;

/// For example "30 rows, rank 29: one row of `j6` (rotation about x) follows from j1…j5; mobility 1; Grübler counts 0".
pub fn summary(mobility: &Mobility, rows: &[Row], velocities: usize) -> String {
    let count = rows.len();
    let mut text = match count {
        0 => "no rows".to_owned(),
        1 => format!("1 row, rank {}", mobility.rank),
        _ => format!("{count} rows, rank {}", mobility.rank),
    };
    let redundancies = redundancies(mobility, rows);
    if !redundancies.is_empty() {
        let sentences: Vec<String> = redundancies.into_iter().map(|(_, text)| text).collect();
        text += &format!(": {}", sentences.join("; "));
    }
    text += &format!("; mobility {}", mobility.mobility);
    // Grübler's count takes every row for independent.
    let counted = velocities as i64 - count as i64;
    if counted != mobility.mobility as i64 {
        text += &format!("; Grübler counts {counted}");
    }
    if !mobility.integrable.is_empty() {
        let names: Vec<String> = mobility
            .integrable
            .iter()
            .map(|&row| format!("`{}`", rows[row].name))
            .collect();
        let (is, conditions) = match names.len() {
            1 => ("is", "a condition on positions"),
            _ => ("are", "conditions on positions"),
        };
        text += &format!(
            "; {} {is} integrable: {conditions} (`Holonomic`) in terms of velocities",
            names.join(", ")
        );
    }
    text
}

/// For each entry with redundant rows a sentence: "one row of `j6` (rotation about x) follows from j1…j5".
pub fn redundancies(mobility: &Mobility, rows: &[Row]) -> Vec<(String, String)> {
    let mut entries: Vec<&String> = Vec::new();
    for redundancy in &mobility.redundant {
        let entry = &rows[redundancy.row].entry;
        if !entries.contains(&entry) {
            entries.push(entry);
        }
    }
    let sentences = entries.into_iter().map(|entry| {
        let own = mobility
            .redundant
            .iter()
            .filter(|redundancy| rows[redundancy.row].entry == *entry);
        let (mut what, mut from): (Vec<String>, Vec<&str>) = (Vec::new(), Vec::new());
        for redundancy in own {
            what.push(direction(&rows[redundancy.row]));
            for other in &redundancy.follows_from {
                if !from.contains(&other.as_str()) {
                    from.push(other);
                }
            }
        }
        let all = rows.iter().filter(|row| row.entry == *entry).count();
        let subject = match (what.len(), all) {
            (1, 1) => format!("the row of `{entry}`"),
            (count, _) => format!("{} of `{entry}`", counted(count)),
        };
        let what: Vec<String> = what.into_iter().filter(|what| !what.is_empty()).collect();
        let what = match what.as_slice() {
            [] => String::new(),
            what => format!(" ({})", what.join(", ")),
        };
        let follows = if own_count(mobility, rows, entry) == 1 {
            "follows"
        } else {
            "follow"
        };
        // Its other rows may well take part; that goes without saying.
        let own = from.len();
        from.retain(|other| other != entry);
        let mut along: Vec<&str> = Vec::new();
        for redundancy in mobility.redundant.iter() {
            if rows[redundancy.row].entry == *entry {
                let new = redundancy.along.iter().map(String::as_str);
                along.extend(new.filter(|joint| *joint != entry.as_str()));
            }
        }
        along.sort_unstable();
        along.dedup();
        let from = match from.as_slice() {
            [] if own > 0 && !along.is_empty() => {
                format!(
                    "its other rows and the joints that are coordinates, {}",
                    list(&along)
                )
            }
            [] if own > 0 => "its other rows".to_owned(),
            [] => "nothing, as it holds by itself".to_owned(),
            from => list(from),
        };
        (
            entry.clone(),
            format!("{subject}{what} {follows} from {from}"),
        )
    });
    sentences.collect()
}

fn own_count(mobility: &Mobility, rows: &[Row], entry: &str) -> usize {
    let own = mobility
        .redundant
        .iter()
        .filter(|redundancy| rows[redundancy.row].entry == entry);
    own.count()
}

/// What a row holds, from its name.
fn direction(row: &Row) -> String {
    let suffix = row.name.strip_prefix(&row.entry).unwrap_or_default();
    let suffix = suffix.trim_start_matches('.');
    match suffix.strip_prefix("rotation_") {
        Some(axis @ ("x" | "y" | "z")) => format!("rotation about {}", axis.to_uppercase()),
        Some(axis) => format!("rotation about its axis {axis}"),
        None => match suffix {
            "x" | "y" | "z" => format!("position along {}", suffix.to_uppercase()),
            "u" | "v" | "w" => format!("position along its axis {suffix}"),
            other => other.to_owned(),
        },
    }
}

fn counted(count: usize) -> String {
    match count {
        1 => "one row".to_owned(),
        2 => "two rows".to_owned(),
        3 => "three rows".to_owned(),
        count => format!("{count} rows"),
    }
}

/// "a, b, c", where names are numbered in order "j1…j5".
fn list(names: &[&str]) -> String {
    let numbered = |name: &str| {
        let digits = name.trim_end_matches(|c: char| c.is_ascii_digit()).len();
        let number: u64 = name[digits..].parse().ok()?;
        Some((name[..digits].to_owned(), number))
    };
    let mut text: Vec<String> = Vec::new();
    let mut rest = names;
    while let Some(first) = rest.first() {
        let start = numbered(first);
        let run = rest.iter().enumerate().take_while(|(k, name)| {
            let expected = start
                .as_ref()
                .map(|(stem, n)| (stem.clone(), n + *k as u64));
            *k == 0 || (expected.is_some() && numbered(name) == expected)
        });
        let length = run.count();
        match length {
            0..=2 => {
                text.push((*first).to_owned());
                rest = &rest[1..];
            }
            _ => {
                text.push(format!("{first}…{}", rest[length - 1]));
                rest = &rest[length..];
            }
        }
    }
    text.join(", ")
}
