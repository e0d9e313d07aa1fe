//! `mbs pages`: writes measured numbers into the README and the book.

use std::fs;
use std::path::PathBuf;

use clap::Args;
use mbs_examples::pages::registry::ENTRIES;
use mbs_examples::pages::update::updates;

use super::failure::Failure;
use super::print::print;

/// Arguments of `mbs pages`.
#[derive(Args)]
pub struct Pages {
    /// Say which blocks are stale and write nothing.
    #[arg(long)]
    check: bool,
    /// The top of the repository [default: the working directory].
    #[arg(long, value_name = "DIR")]
    root: Option<PathBuf>,
}

impl Pages {
    /// Writes the stale pages, or names them.
    pub fn run(&self) -> Result<(), Failure> {
        let root = self.root.clone().unwrap_or_else(|| ".".into());
        let updates = updates(&root, ENTRIES)?;
        let stale = updates.iter().filter(|update| !update.stale.is_empty());
        let mut list = String::new();
        for update in stale {
            list += &format!("{}: {}\n", update.path, update.stale.join(", "));
            if !self.check {
                let path = root.join(&update.path);
                fs::write(&path, &update.new).map_err(|error| {
                    Failure(format!("cannot write {}: {error}", path.display()))
                })?;
            }
        }
        match (list.is_empty(), self.check) {
            (true, _) => print("every page is up to date\n"),
            (false, true) => Err(Failure(format!("stale; `mbs pages` writes them:\n{list}"))),
            (false, false) => print(&format!("written:\n{list}")),
        }
    }
}
