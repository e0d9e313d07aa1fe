//! `mbs`: simulates and explains the scenes.

mod cli;

fn main() -> std::process::ExitCode {
    cli::main()
}
