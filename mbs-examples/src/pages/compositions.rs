//! Symmetric compositions, compared by work.

use super::data::Data;
use super::markdown::table as markdown;

const FILE: &str = "readme/compositions.csv";

/// Stages a second for the finest error, a row for each set of coefficients.
pub fn table(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let (mut scenes, mut sets) = (Vec::new(), Vec::new());
    for line in results.lines() {
        let scene = line.text("scene")?;
        let set = (line.text("order")?, line.text("set")?);
        if !scenes.contains(&scene) {
            scenes.push(scene);
        }
        if !sets.contains(&set) {
            sets.push(set);
        }
    }
    let row = |(order, set): &(&str, &str)| {
        let mut row = vec![format!("{order}: {}", set.replace(';', ","))];
        for scene in &scenes {
            let line = results.find(&[("scene", scene), ("order", order), ("set", set)])?;
            row.push(line.text("rate_1e-9")?.to_owned());
        }
        Ok(row)
    };
    let rows: Result<Vec<Vec<String>>, String> = sets.iter().map(row).collect();
    Ok(markdown(
        &[&["order: set, stages"], &scenes[..]].concat(),
        &rows?,
    ))
}
