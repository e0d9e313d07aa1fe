//! Names of entries as text: a word, for a member of a family with its indices, and in an assembly after the name of
//! this assembly: `crank`, `crank[3]`, `rod[3][4]`, `front.arm`, `leg[2].rod[1]`.

/// Whether a name has indices.
pub fn is_member(name: &str) -> bool {
    name.ends_with(']')
}

/// Whether several entries may stand at the same place of a declaration: members of families, entries of assemblies.
pub fn is_one_of_many(name: &str) -> bool {
    is_member(name) || name.contains('.')
}

/// Without the last indices.
pub fn base(name: &str) -> &str {
    let start = name.rfind('.').map_or(0, |dot| dot + 1);
    let end = name[start..]
        .find('[')
        .map_or(name.len(), |end| start + end);
    &name[..end]
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
