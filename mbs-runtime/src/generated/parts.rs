//! Long generated functions, computed part by part.

/// A part: straight-line code for each row of places.
type Part<const LENGTH: usize> = fn(&mut [f64; LENGTH], &[u16]);

/// Computes the parts that a table names: for each run the index of the part, the length of its rows (two words, the
/// lower first), and the rows.
pub fn compute_parts<const LENGTH: usize>(
    parts: &[Part<LENGTH>],
    values: &mut [f64; LENGTH],
    mut table: &[u16],
) {
    while let Some((&[part, low, high], rest)) = table.split_first_chunk() {
        let length = usize::from(low) | usize::from(high) << 16;
        let (Some((rows, rest)), Some(part)) =
            (rest.split_at_checked(length), parts.get(usize::from(part)))
        else {
            return;
        };
        part(values, rows);
        table = rest;
    }
}

/// The rows of a table of indices.
pub fn rows_of<const COUNT: usize>(table: &[u16]) -> impl Iterator<Item = [usize; COUNT]> {
    let (rows, _) = table.as_chunks::<COUNT>();
    rows.iter().map(|row| row.map(usize::from))
}

/// The words of a table, which is written as bytes, the lower first.
pub const fn words<const COUNT: usize>(bytes: &[u8]) -> [u16; COUNT] {
    let mut words = [0; COUNT];
    let (mut at, (pairs, _)) = (0, bytes.as_chunks::<2>());
    while at < COUNT && at < pairs.len() {
        words[at] = u16::from_le_bytes(pairs[at]);
        at += 1;
    }
    words
}
