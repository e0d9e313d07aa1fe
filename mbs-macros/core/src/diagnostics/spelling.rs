//! What an unknown name may have been meant to be.

/// Kinds by the words of other programs.
const KINDS: [(&str, &str); 2] = [("Rod", "Bar"), ("Link", "Bar")];

/// Names of fewer letters are no abbreviations: too many words begin with them.
const SHORTEST_ABBREVIATION: usize = 3;

/// Names of up to so many letters may have one wrong letter, but not the first one: most words of this length differ
/// from many others by two letters.
const SHORT: usize = 4;

/// "; did you mean `x`?" for the candidate nearest to `name`, or nothing if none is near.
pub fn did_you_mean<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> String {
    nearest(name, candidates).map_or_else(String::new, asked)
}

/// The same of a kind: one that has `name` among its words comes before misspellings, as `SpringDamper` for `Spring`.
pub fn did_you_mean_kind<'a>(
    name: &str,
    kinds: impl IntoIterator<Item = &'a str, IntoIter: Clone>,
) -> String {
    let kinds = kinds.into_iter();
    let place = |kind: &str| words(kind).position(|word| word.eq_ignore_ascii_case(name));
    let with_word = kinds
        .clone()
        .filter_map(|kind| Some((place(kind)?, kind.len(), kind)));
    let kind = with_word.min().map(|(_, _, kind)| kind);
    match kind.or_else(|| meant(name, &KINDS)) {
        Some(kind) => asked(kind),
        None => did_you_mean(name, kinds),
    }
}

fn asked(candidate: &str) -> String {
    format!("; did you mean `{candidate}`?")
}

/// The words of a name in camel case.
fn words(name: &str) -> impl Iterator<Item = &str> {
    let mut rest = name;
    std::iter::from_fn(move || {
        let first = rest.chars().next()?;
        let end = rest[first.len_utf8()..].find(char::is_uppercase);
        let end = end.map_or(rest.len(), |end| end + first.len_utf8());
        let (word, after) = rest.split_at(end);
        rest = after;
        Some(word)
    })
}

/// What other programs call `name` and this language otherwise, from pairs of both.
pub fn meant<'a>(name: &str, pairs: &[(&str, &'a str)]) -> Option<&'a str> {
    let mut pairs = pairs.iter();
    let pair = pairs.find(|(other, _)| other.eq_ignore_ascii_case(name));
    pair.map(|(_, own)| *own)
}

/// The candidate that `name` may be a misspelling or an abbreviation of; underscores and capitals do not count.
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let written = letters(name);
    let count = written.len();
    let most = match count {
        0..SHORTEST_ABBREVIATION => 0,
        SHORTEST_ABBREVIATION..=SHORT => 1,
        _ => 1 + count / 3,
    };
    let rank = |candidate: &'a str| {
        let known = letters(candidate);
        let is_abbreviation = count >= SHORTEST_ABBREVIATION && is_cut_from(name, candidate);
        // The distance is no less than the difference of the lengths.
        let is_near =
            known.len().abs_diff(count) <= most && (count > SHORT || begin_alike(&written, &known));
        let distance = match is_near || is_abbreviation {
            true => distance(&written, &known),
            false => usize::MAX,
        };
        let is_same = distance == 0;
        ((is_near && distance <= most) || is_abbreviation).then_some((
            !(is_same || is_abbreviation),
            distance,
            candidate,
        ))
    };
    let nearest = candidates.into_iter().filter_map(rank).min();
    nearest.map(|(.., candidate)| candidate)
}

/// The letters that are compared.
fn letters(name: &str) -> Vec<char> {
    let letters = name.chars().filter(|&letter| letter != '_');
    letters.flat_map(char::to_lowercase).collect()
}

/// Whether a name is a candidate without the end of a word: `Out` of `Output`, and not `rod` of `rod_mass`.
fn is_cut_from(name: &str, candidate: &str) -> bool {
    let start = candidate.get(..name.len());
    start.is_some_and(|start| start.eq_ignore_ascii_case(name))
        && !candidate[name.len()..].starts_with('_')
}

/// Whether the first letters are the same, or the first two of one are swapped in the other.
fn begin_alike(a: &[char], b: &[char]) -> bool {
    let is_swapped = || a.len() > 1 && b.len() > 1 && (a[0], a[1]) == (b[1], b[0]);
    a.first() == b.first() || is_swapped()
}

/// The number of letters to insert, delete, replace or swap with the next one.
fn distance(a: &[char], b: &[char]) -> usize {
    let mut before = Vec::new();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for i in 0..a.len() {
        let mut next = vec![i + 1];
        for j in 0..b.len() {
            let replaced = row[j] + usize::from(a[i] != b[j]);
            let mut least = replaced.min(row[j + 1] + 1).min(next[j] + 1);
            if i > 0 && j > 0 && (a[i], a[i - 1]) == (b[j - 1], b[j]) {
                least = least.min(before[j - 1] + 1);
            }
            next.push(least);
        }
        before = std::mem::replace(&mut row, next);
    }
    row[b.len()]
}
