//! Stage 1: tokens → tree.
//!
//! One production, `name: Kind(positional, named = value)`, and families of it. The tree keeps its tokens, so that every
//! later error can point at the offending one. AFTER THIS STAGE: entries are well formed and their kinds exist, families
//! and assemblies are entries with indices and dots in their names; nothing is resolved.

mod alone;
mod assemblies;
mod bindings;
mod children;
mod chunk;
mod definition;
mod entry;
mod exactly;
mod families;
mod height;
mod item;
mod levels;
mod members;
mod name;
mod nameless;
mod nested;
mod own_names;
mod parse;
mod paths;
mod plain;
mod ranges;
mod reference;
mod rewrite;
mod scope;
mod whole;

use crate::schema::World;
use proc_macro2::Span;
use syn::{Expr, Ident, Visibility};

pub use assemblies::{Definition, Definitions, Given, Instance, Port, Receiver, Takes};
pub use children::{children, inner};
pub use definition::{define, is_broken};
pub use entry::ASSEMBLY;
pub use exactly::exactly;
pub use families::{Family, MOST_MEMBERS};
pub use name::Name;
pub use own_names::{CONSTANT_IN_ASSEMBLY, is_constant};
pub use parse::parse;
pub use paths::{named, path_text};
pub use plain::plain;
pub use reference::{Reference, reference};

/// How deep expressions may be nested: deeper ones would exhaust the stack of the compiler.
pub const MAX_DEPTH: usize = 400;

/// How deep an expression may be, counted through the names that it uses: later stages follow it to its end, for its
/// value and its derivatives.
pub const MAX_LEVELS: u32 = 1200;

/// The message for expressions nested deeper than `MAX_DEPTH`.
pub const TOO_DEEP: &str =
    "this is nested too deeply; name parts of it by `Let`, and declare names before their use";

/// A declaration as written.
#[derive(Debug)]
pub struct Declaration {
    /// Visibility written before the name; public if none was.
    pub visibility: Option<Visibility>,
    /// The mechanism's name.
    pub name: Ident,
    /// The text of `doc:` and of documentation comments before the name.
    pub doc: String,
    /// `world: Planar(…)`.
    pub world: Option<Entry>,
    /// `deny: Redundant()`: rows that follow from others are errors.
    pub deny_redundant: bool,
    /// `allow: Unused()`: entries that nothing uses are no errors.
    pub allow_unused: bool,
    /// All other entries, in order.
    pub entries: Vec<Entry>,
    /// The families, whose members are among the entries.
    pub families: Vec<Family>,
    /// The assemblies that entries name, by their paths.
    pub definitions: Definitions,
    /// The assemblies put in place, whose entries are among the entries; outer ones first.
    pub instances: Vec<Instance>,
    /// What their ports are given.
    pub given: Vec<Given>,
    /// Names of entries that could not be read but seem to be parameters: the user's program uses their fields.
    pub lost: Vec<Ident>,
    /// The tokens, as text.
    pub text: String,
}

/// `name: Kind(positional, named = value)`.
#[derive(Debug, Clone)]
pub struct Entry {
    /// Its name.
    pub name: Name,
    /// Its kind.
    pub kind: Ident,
    /// Its documentation comment.
    pub doc: String,
    /// Positional arguments.
    pub positional: Vec<Expr>,
    /// Named arguments.
    pub named: Vec<NamedArgument>,
}

impl Declaration {
    /// The world; the plane where it is missing or unknown (which is an error already).
    pub fn world_kind(&self) -> World {
        let world = self.world.as_ref();
        world
            .and_then(|entry| crate::schema::world(&entry.kind.to_string()))
            .unwrap_or(World::Planar)
    }

    /// The family of this name.
    pub fn family(&self, name: &str) -> Option<&Family> {
        self.families.iter().find(|family| family.name == name)
    }

    /// The assembly put in place under this name.
    pub fn instance(&self, name: &str) -> Option<&Instance> {
        self.instances.iter().find(|instance| instance.name == name)
    }

    /// No more than a name.
    fn nameable(name: Ident) -> Self {
        Declaration {
            visibility: None,
            name,
            doc: String::new(),
            world: None,
            deny_redundant: false,
            allow_unused: false,
            entries: Vec::new(),
            families: Vec::new(),
            definitions: Vec::new(),
            instances: Vec::new(),
            given: Vec::new(),
            lost: Vec::new(),
            text: String::new(),
        }
    }
}

impl Entry {
    /// The named argument, if given.
    pub fn named(&self, name: &str) -> Option<&NamedArgument> {
        self.named.iter().find(|argument| argument.name == name)
    }

    /// Where the entry is.
    pub fn span(&self) -> Span {
        self.name.span()
    }
}

/// `name = value`.
#[derive(Debug, Clone)]
pub struct NamedArgument {
    /// The argument's name.
    pub name: Ident,
    /// Its value.
    pub value: Expr,
}
