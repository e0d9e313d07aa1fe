//! Names of entries as text: a word, and for a member of a family its indices, as in `crank[3]` and `rod[3][4]`.

/// Whether a name has indices.
pub fn is_member(name: &str) -> bool {
    name.ends_with(']')
}

/// Word, indices and what follows them: `tip[3].x` is `tip`, 3 and `.x`.
pub fn split(name: &str) -> (&str, Vec<usize>, &str) {
    let end = name.find(['[', '.']).unwrap_or(name.len());
    let (word, mut rest) = name.split_at(end);
    let mut indices = Vec::new();
    while let Some((index, after)) = next_index(rest) {
        indices.push(index);
        rest = after;
    }
    (word, indices, rest)
}

fn next_index(text: &str) -> Option<(usize, &str)> {
    let (index, rest) = text.strip_prefix('[')?.split_once(']')?;
    Some((index.parse().ok()?, rest))
}
