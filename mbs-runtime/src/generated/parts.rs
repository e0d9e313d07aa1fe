//! Long generated functions, computed part by part.

/// A part: straight-line code for each row of places, with the tables of the system.
type Part<System, const LENGTH: usize, Word> = fn(&System, &mut [f64; LENGTH], &[Word]);

/// Computes the parts that a table names: for each run the index of the part, the length of its rows (two words, the
/// lower 16 bits first), and the rows.
pub fn compute_parts<System, const LENGTH: usize, Word: Copy + Into<u32>>(
    system: &System,
    parts: &[Part<System, LENGTH, Word>],
    values: &mut [f64; LENGTH],
    mut table: &[Word],
) {
    while let Some((&[part, low, high], rest)) = table.split_first_chunk() {
        let [part, low, high] = [part, low, high].map(|word| word.into() as usize);
        let (Some((rows, rest)), Some(part)) =
            (rest.split_at_checked(low | high << 16), parts.get(part))
        else {
            return;
        };
        part(system, values, rows);
        table = rest;
    }
}

/// A value that is computed when the program is compiled.
#[doc(hidden)]
#[macro_export]
macro_rules! constant {
    ($value:expr) => {
        const { $value }
    };
}

/// The rows of a table of indices.
pub fn rows_of<const COUNT: usize, Word: Copy + Into<u32>>(
    table: &[Word],
) -> impl Iterator<Item = [usize; COUNT]> {
    let (rows, _) = table.as_chunks::<COUNT>();
    rows.iter().map(|row| row.map(|word| word.into() as usize))
}

/// The words of a table, which is written as bytes, the lowest first.
pub const fn words_of_u16<const COUNT: usize>(bytes: &[u8]) -> [u16; COUNT] {
    let mut words = [0; COUNT];
    let (mut at, (groups, _)) = (0, bytes.as_chunks());
    while at < COUNT && at < groups.len() {
        words[at] = u16::from_le_bytes(groups[at]);
        at += 1;
    }
    words
}

/// The same of longer words.
pub const fn words_of_u32<const COUNT: usize>(bytes: &[u8]) -> [u32; COUNT] {
    let mut words = [0; COUNT];
    let (mut at, (groups, _)) = (0, bytes.as_chunks());
    while at < COUNT && at < groups.len() {
        words[at] = u32::from_le_bytes(groups[at]);
        at += 1;
    }
    words
}

/// The pairs of a table of indices.
pub const fn pairs_of<const COUNT: usize>(words: &[u32]) -> [(usize, usize); COUNT] {
    let mut pairs = [(0, 0); COUNT];
    let (mut at, (groups, _)) = (0, words.as_chunks::<2>());
    while at < COUNT && at < groups.len() {
        let [a, b] = groups[at];
        pairs[at] = (a as usize, b as usize);
        at += 1;
    }
    pairs
}

/// The triples of a table of indices.
pub const fn triples_of<const COUNT: usize>(words: &[u32]) -> [(usize, usize, usize); COUNT] {
    let mut triples = [(0, 0, 0); COUNT];
    let (mut at, (groups, _)) = (0, words.as_chunks::<3>());
    while at < COUNT && at < groups.len() {
        let [a, b, c] = groups[at];
        triples[at] = (a as usize, b as usize, c as usize);
        at += 1;
    }
    triples
}
