//! Mobility in words.

use super::{Mobility, Redundancy};
use crate::equations::Row;

/// For example "30 rows, rank 29: one row of `j6` (rotation about x) follows from j1…j5; mobility 1; Grübler counts 0".
pub fn summary(mobility: &Mobility, rows: &[Row], velocities: usize) -> String {
    let count = rows.len();
    let mut text = match count {
        0 => "no rows".to_owned(),
        1 => format!("1 row, rank {}", mobility.rank),
        _ => format!("{count} rows, rank {}", mobility.rank),
    };
    for (mark, vacuous) in [(": ", false), ("; left out: ", true)] {
        let sentences: Vec<String> = sentences(mobility, rows, vacuous)
            .into_iter()
            .map(|(_, text)| text)
            .collect();
        if !sentences.is_empty() {
            text += &format!("{mark}{}", sentences.join("; "));
        }
    }
    text += &format!("; mobility {}", mobility.mobility);
    // Grübler's count takes every row for independent.
    let left_out = mobility.redundant.iter().filter(|row| row.vacuous).count();
    let counted = velocities as i64 - (count + left_out) as i64;
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
    let left_out = sentences(mobility, rows, true);
    left_out
        .into_iter()
        .chain(sentences(mobility, rows, false))
        .collect()
}

/// The sentences about rows that are left out, or about the others.
fn sentences(mobility: &Mobility, rows: &[Row], vacuous: bool) -> Vec<(String, String)> {
    let mut entries: Vec<&String> = Vec::new();
    let listed = || {
        mobility
            .redundant
            .iter()
            .filter(|row| row.vacuous == vacuous)
    };
    for redundancy in listed() {
        if !entries.contains(&&redundancy.entry) {
            entries.push(&redundancy.entry);
        }
    }
    let sentences = entries.into_iter().map(|entry| {
        let own: Vec<&Redundancy> = listed().filter(|row| row.entry == *entry).collect();
        let (mut what, mut from): (Vec<String>, Vec<&str>) = (Vec::new(), Vec::new());
        for redundancy in &own {
            what.push(direction(redundancy));
            for other in &redundancy.follows_from {
                if !from.contains(&other.as_str()) {
                    from.push(other);
                }
            }
        }
        let left_out = mobility.redundant.iter();
        let left_out = left_out.filter(|row| row.vacuous && row.entry == *entry);
        let all = rows.iter().filter(|row| row.entry == *entry).count() + left_out.count();
        let subject = match (what.len(), all) {
            (1, 1) => format!("the row of `{entry}`"),
            (count, _) => format!("{} of `{entry}`", counted(count)),
        };
        let what: Vec<String> = what.into_iter().filter(|what| !what.is_empty()).collect();
        let what = match what.as_slice() {
            [] => String::new(),
            what => format!(" ({})", what.join(", ")),
        };
        let follows = if own.len() == 1 { "follows" } else { "follow" };
        let along = own.iter().flat_map(|row| &row.along).map(String::as_str);
        let mut along: Vec<&str> = along.filter(|joint| *joint != entry.as_str()).collect();
        along.sort_unstable();
        along.dedup();
        // Its other rows may well take part; that goes without saying.
        let own = from.len();
        from.retain(|other| other != entry);
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

/// What a row holds, from its name.
fn direction(row: &Redundancy) -> String {
    let suffix = row.row.strip_prefix(&row.entry).unwrap_or_default();
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

/// "a, b, c", where names are numbered in order "j1…j5", `j[1]…j[5]`, or `leg[1].hip…leg[5].hip`.
fn list(names: &[&str]) -> String {
    let mut groups: Vec<(Option<(&str, &str)>, Vec<(u64, &str)>)> = Vec::new();
    for &name in names {
        let (pattern, number) = match numbered(name) {
            Some((pattern, number)) => (Some(pattern), number),
            None => (None, 0),
        };
        let same = groups
            .iter_mut()
            .find(|(known, _)| known.is_some() && *known == pattern);
        match same {
            Some((_, members)) => members.push((number, name)),
            None => groups.push((pattern, vec![(number, name)])),
        }
    }
    let mut text: Vec<String> = Vec::new();
    for (_, members) in groups {
        let follows = |a: &(u64, &str), b: &(u64, &str)| b.0 == a.0 + 1;
        for run in members.chunk_by(follows) {
            match run {
                [(_, first), _, .., (_, last)] => text.push(format!("{first}…{last}")),
                few => text.extend(few.iter().map(|(_, name)| (*name).to_owned())),
            }
        }
    }
    text.join(", ")
}

/// What a name has around its number, its first index or else its last digits, and the number.
fn numbered(name: &str) -> Option<((&str, &str), u64)> {
    let (start, end) = match name.find('[') {
        Some(bracket) => (bracket + 1, bracket + name[bracket..].find(']')?),
        None => (
            name.trim_end_matches(|c: char| c.is_ascii_digit()).len(),
            name.len(),
        ),
    };
    let number = name[start..end].parse().ok()?;
    Some(((&name[..start], &name[end..]), number))
}
