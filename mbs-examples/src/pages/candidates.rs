//! The coordinate descriptions that the compiler compared.

use super::data::Data;
use super::scene_runs::scene;

/// The tables of two scenes, as `mbs explain` prints them.
pub fn text(_: &Data) -> Result<String, String> {
    let parts =
        ["slider-crank", "bricard"].map(|name| scene(name).map(|scene| scene.model.considered()));
    let parts: Vec<String> = parts.into_iter().collect::<Result<_, _>>()?;
    Ok(format!("```text\n{}```", parts.join("\n")))
}
