//! Finds items by name; for an unknown name the message suggests a similar one.

use mbs_examples::absent;
use mbs_examples::scene::Scene;
use mbs_examples::scenes::scenes;

use super::failure::Failure;

/// The scene of this name.
pub fn scene(name: &str) -> Result<&'static Scene, Failure> {
    // A name of either sort may be what was meant.
    let names = || {
        let built = scenes().iter().map(|scene| scene.name);
        let absent = absent::SCENES.iter().copied();
        built.chain(absent.filter(|_| !cfg!(feature = "laboratory")))
    };
    let found = scenes().iter().find(|scene| scene.name == name);
    found.ok_or_else(|| {
        // A build with all scenes has found those.
        Failure(match absent::SCENES.contains(&name) {
            true => absent(&format!("the scene `{name}`")),
            false => unknown("scene", name, names()),
        })
    })
}

/// The message for something that this build does not have, with the command line that has it.
pub fn absent(what: &str) -> String {
    // A path need not be text.
    let arguments = std::env::args_os().skip(1);
    let arguments: Vec<String> = arguments
        .map(|argument| argument.to_string_lossy().into_owned())
        .collect();
    absent::message(what, arguments.iter().map(String::as_str))
}

/// Below the help: the commands that this build does not have.
#[cfg(not(feature = "laboratory"))]
pub fn in_laboratory() -> String {
    let commands = absent::COMMANDS.join(", ");
    absent::message(&format!("Each of {commands}"), ["COMMAND"])
}

/// `no scene is named …; did you mean …? There are: …`
pub fn unknown<'a>(what: &str, name: &str, known: impl Iterator<Item = &'a str> + Clone) -> String {
    let mut message = format!("no {what} is named `{name}`");
    if let Some(near) = nearest(name, known.clone()) {
        message += &format!("; did you mean `{near}`?");
    } else {
        message += ".";
    }
    let known: Vec<&str> = known.collect();
    match known.as_slice() {
        [] => message += " There are none.",
        known => message += &format!(" There are: {}", known.join(", ")),
    }
    message
}

/// The most similar name, if it is similar at all.
fn nearest<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let scored = known.map(|known| (strsim::jaro_winkler(name, known), known));
    let near = scored.filter(|(likeness, _)| *likeness > 0.75);
    near.max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, known)| known)
}
