//! Instructions of a step.

use super::data::{Data, Table};
use super::markdown::{paragraph, significant, thousands};

const FILE: &str = "readme/instructions.csv";

fn count(results: &Table, name: &str, step: &str) -> Result<f64, String> {
    let line = results.find(&[("name", name), ("step_s", step)])?;
    line.number("instructions")
}

/// The generated step compared with one written by hand.
pub fn beside_hand(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let pair = |step| {
        let hand = count(&results, "hand-written", step)?;
        let generated = count(&results, "generated", step)?;
        let pair = format!("{} against {}", thousands(generated), thousands(hand));
        Ok::<_, String>((significant(generated / hand, 3), pair))
    };
    let time = |name| {
        let line = results.find(&[("name", name), ("step_s", "1e-3")])?;
        line.number("time_us")
    };
    let (short, long) = (pair("1e-3")?, pair("1e-2")?);
    let (hand, generated) = (time("hand-written")?, time("generated")?);
    let scene = |name, step| count(&results, name, step).map(thousands);
    Ok(paragraph(&format!(
        "The generated step of the double four-bar takes {} times the instructions of a step written by hand for that mechanism at \
         h = 1e-3 s and {} times at 1e-2 s ({} and {}, counted by callgrind), and {} times its time ({} against {} µs, least of \
         interleaved repeats; `cargo bench -p mbs-examples --bench step_instructions`). The step of `bricard` takes {} \
         instructions in joint coordinates and {} by bodies; that of `andrews` takes {}, and {} with equations written by hand.",
        short.0,
        long.0,
        short.1,
        long.1,
        significant(generated / hand, 2),
        significant(generated, 3),
        significant(hand, 3),
        scene("bricard", "1e-2")?,
        scene("bricard-reference", "1e-2")?,
        scene("andrews-generated", "1e-6")?,
        scene("andrews-hand", "1e-6")?,
    )))
}

/// Mechanisms with rows that are redundant in every pose.
pub fn redundant(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let scene = |name| count(&results, name, "1e-2").map(thousands);
    Ok(paragraph(&format!(
        "With this elimination a step of `bricard` (5 rows of rank 4) takes {} instructions, a step of `bricard-reference` (30 rows \
         of rank 29) {}.",
        scene("bricard")?,
        scene("bricard-reference")?,
    )))
}
