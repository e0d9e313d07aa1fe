//! What a build without the feature `laboratory` does not have, and the command that has it.

/// Scenes of the feature `laboratory`.
pub const SCENES: [&str; 19] = [
    "double-pendulum",
    "driven-slider-crank",
    "four-bar-10",
    "four-bar-40",
    "andrews",
    "andrews-iftomm",
    "chaplygin-sleigh",
    "knife-edge",
    "knife-edge-moving",
    "spherical-pendulum",
    "heavy-top",
    "bricard",
    "bricard-slender",
    "bricard-reference",
    "flyball-governor",
    "cardan-shaft",
    "rolling-disk",
    "rolling-disk-tilted",
    "rattleback",
];

/// Commands of the feature `laboratory`.
pub const COMMANDS: [&str; 4] = ["explain", "chart", "paper", "pages"];

/// The command line of the build that has everything, with these arguments.
pub fn command<'a>(arguments: impl IntoIterator<Item = &'a str>) -> String {
    let mut line = "cargo run --release -p mbs-examples --features laboratory --".to_owned();
    for argument in arguments {
        line.push(' ');
        let plain = |c: char| c.is_ascii_alphanumeric() || "-_./=:,+".contains(c);
        match !argument.is_empty() && argument.chars().all(plain) {
            true => line += argument,
            false => line += &format!("'{}'", argument.replace('\'', "'\\''")),
        }
    }
    line
}

/// The message for something of the feature, asked for with these arguments.
pub fn message<'a>(what: &str, arguments: impl IntoIterator<Item = &'a str>) -> String {
    let command = command(arguments);
    format!("{what} is in builds with the feature `laboratory`; run `{command}`")
}

/// The line below the list of scenes; none in a build that has all.
pub fn more() -> Option<String> {
    let list = command(["list"]);
    let count = SCENES.len();
    (!cfg!(feature = "laboratory")).then(|| {
        format!("  {count} more scenes are in builds with the feature `laboratory`: `{list}`\n")
    })
}
