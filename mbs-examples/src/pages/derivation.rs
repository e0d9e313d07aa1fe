//! Time of the derivation.

use super::data::Data;
use super::markdown::{paragraph, significant};

const FILE: &str = "readme/derivation.csv";

/// Of the slider-crank and of Bricard's mechanism.
pub fn sentence(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let time = |scene| {
        let line = results.find(&[("scene", scene)])?;
        Ok::<_, String>(significant(line.number("total_ms")?, 2))
    };
    Ok(paragraph(&format!(
        "To derive and emit the slider-crank takes an unoptimised compiler {} ms. Bricard's mechanism in both descriptions, with its \
         loop cut in two ways, takes {} ms (`cargo run --profile unoptimised -p mbs-examples --example derivation_times`).",
        time("slider-crank")?,
        time("bricard")?,
    )))
}
