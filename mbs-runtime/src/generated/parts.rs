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

/// The rows of a table of indices.
pub fn rows_of<const COUNT: usize, Word: Copy + Into<u32>>(
    table: &[Word],
) -> impl Iterator<Item = [usize; COUNT]> {
    let (rows, _) = table.as_chunks::<COUNT>();
    rows.iter().map(|row| row.map(|word| word.into() as usize))
}
