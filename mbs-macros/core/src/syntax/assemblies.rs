//! Assemblies: entries that are written once, in `assembly!`, and stand in a mechanism as often as wanted:
//! `name: Assembly(Path, port = …)`.
//!
//! Their entries become ordinary ones with names such as `front.arm`; later stages know no more of them than a list.

use super::entry::ASSEMBLY;
use super::item::Item;
use super::name::Name;
use super::paths::path_text;
use super::scope::{Outside, Scope};
use super::{Declaration, Entry};
use crate::diagnostics::{Errors, Place, did_you_mean};
use crate::schema::{Kinds, World};
use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::ToTokens;
use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;
use syn::{Expr, Visibility};

/// The kind of entries that are called like functions.
pub(super) const TABLE: &str = "Table";

/// An assembly as written in `assembly!`.
#[derive(Debug)]
pub struct Definition {
    /// Visibility written before the name.
    pub visibility: Option<Visibility>,
    /// Its name.
    pub name: Ident,
    /// Its documentation.
    pub doc: String,
    /// `world: Planar()`.
    pub world: World,
    /// What the surroundings give.
    pub ports: Vec<Port>,
    /// Everything else, as read.
    pub(super) items: Vec<Item>,
    /// The assemblies that its entries name.
    pub definitions: Definitions,
}

/// `name: Port(Point)`.
#[derive(Debug, Clone)]
pub struct Port {
    /// Its name.
    pub name: Ident,
    /// Its documentation.
    pub doc: String,
    /// What may be given.
    pub takes: Takes,
    /// What is taken where nothing is given.
    pub default: Option<Expr>,
}

/// What a port takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Takes {
    /// A point.
    Point,
    /// A part or the ground.
    Part,
    /// A frame of a part.
    Frame,
    /// A number.
    Number,
    /// A vector, or a direction.
    Vector,
    /// A table.
    Table,
}

/// Assemblies by their paths, as written.
pub type Definitions = Vec<(String, Rc<Definition>)>;

/// An assembly put in place.
#[derive(Debug, Clone)]
pub struct Instance {
    /// Its name.
    pub name: Name,
    /// The path, as written.
    pub path: Expr,
    /// What it is.
    pub definition: Rc<Definition>,
}

/// What is given to a port or a parameter, or what a port would take if nothing was.
#[derive(Debug, Clone)]
pub struct Given {
    /// The assembly put in place.
    pub instance: String,
    /// The name of the assembly.
    pub assembly: String,
    /// To what.
    pub to: Receiver,
    /// The value.
    pub value: Expr,
}

/// What of an assembly is given a value.
#[derive(Debug, Clone)]
pub enum Receiver {
    /// A port.
    Port(Port),
    /// A parameter, as declared.
    Parameter(Entry),
}

impl Takes {
    /// All of them, with the words by which they are declared.
    pub const ALL: [(&str, Takes); 6] = [
        ("Point", Takes::Point),
        ("Part", Takes::Part),
        ("Frame", Takes::Frame),
        ("Number", Takes::Number),
        ("Vector", Takes::Vector),
        (TABLE, Takes::Table),
    ];

    /// In words.
    pub fn describe(self) -> &'static str {
        match self {
            Takes::Point => "a point",
            Takes::Part => "a part or the ground",
            Takes::Frame => "a frame, as in `part.frame(…)`",
            Takes::Number => "a number",
            Takes::Vector => "a vector",
            Takes::Table => "the name of a table",
        }
    }
}

impl Definition {
    /// The entries without families, as read.
    fn entry(&self, name: &Ident) -> Option<&Entry> {
        self.items.iter().find_map(|item| match item {
            Item::Entry(entry) if entry.name == name.to_string().as_str() => Some(entry),
            _ => None,
        })
    }

    /// An entry or a family.
    pub(super) fn item(&self, name: &Ident) -> Option<&Item> {
        let text = name.to_string();
        self.items.iter().find(|item| match item {
            Item::Entry(entry) => entry.name == text.as_str(),
            Item::Family(family) => family.name == text.as_str(),
            Item::Doc(_) => false,
        })
    }

    /// Names of its parameters.
    fn parameters(&self) -> impl Iterator<Item = String> {
        self.items.iter().filter_map(|item| match item {
            Item::Entry(entry) if entry.kind == "Param" => Some(entry.name.to_string()),
            _ => None,
        })
    }
}

/// The most entries of a mechanism with all assemblies in place: with more its compilation would run out of memory.
const MOST_ENTRIES: usize = 100_000;

/// Puts assemblies in the place of entries `Assembly(…)`, and those that these name in turn; whether there were not too many.
pub(super) fn put_all(declaration: &mut Declaration, kinds: &Kinds, errors: &mut Errors) -> bool {
    if declaration
        .entries
        .iter()
        .all(|entry| entry.kind != ASSEMBLY)
    {
        return true;
    }
    let outside = Outside::of(declaration);
    for entry in std::mem::take(&mut declaration.entries) {
        if entry.kind != ASSEMBLY {
            declaration.entries.push(entry);
            continue;
        }
        if !put(&entry, &outside, kinds, declaration, errors) {
            return false;
        }
        if declaration.entries.len() + declaration.instances.len() > MOST_ENTRIES {
            errors.at(
                entry.name.span(),
                format!(
                    "with this assembly there are more than {MOST_ENTRIES} entries and assemblies; declare fewer"
                ),
            );
            return false;
        }
    }
    true
}

/// Whether there are not too many entries in it.
fn put(
    entry: &Entry,
    outside: &Outside,
    kinds: &Kinds,
    declaration: &mut Declaration,
    errors: &mut Errors,
) -> bool {
    let Some(path) = entry.positional.first() else {
        errors.at(
            entry.kind.span(),
            format!(
                "an assembly comes first: `{}: {ASSEMBLY}(Name, …)`",
                entry.name
            ),
        );
        return true;
    };
    let text = path_text(path);
    let known = declaration
        .definitions
        .iter()
        .find(|(path, _)| *path == text);
    let Some(definition) = known.map(|(_, definition)| Rc::clone(definition)) else {
        errors.at(
            Place::of(path),
            "expected the path of an assembly, as `assembly!` declares it",
        );
        return true;
    };
    let before = errors.enter(entry.name.as_str());
    let found = errors.count();
    let mut scope = Scope {
        instance: &entry.name,
        definition: &definition,
        values: HashMap::new(),
        held: RefCell::default(),
    };
    bind(entry, &mut scope, outside, declaration, errors);
    declaration.instances.push(Instance {
        name: entry.name.clone(),
        path: path.clone(),
        definition: Rc::clone(&definition),
    });
    let mut fits = true;
    if errors.count() == found {
        let mut inside = Declaration::nameable(definition.name.clone());
        inside.definitions = definition.definitions.clone();
        for item in &definition.items {
            scope.put(item, kinds, &mut inside, errors);
        }
        scope.check_held(errors);
        fits = put_all(&mut inside, kinds, errors);
        declaration.entries.append(&mut inside.entries);
        declaration.families.append(&mut inside.families);
        declaration.instances.append(&mut inside.instances);
        declaration.given.append(&mut inside.given);
    }
    errors.leave(before);
    fits
}

/// Notes the values of ports and parameters by their names.
fn bind(
    entry: &Entry,
    scope: &mut Scope,
    outside: &Outside,
    declaration: &mut Declaration,
    errors: &mut Errors,
) {
    let definition = scope.definition;
    let assembly = &definition.name;
    if let Some(more) = entry.positional.get(1) {
        errors.at(
            Place::of(more),
            format!("what `{assembly}` is given has names: write `port = …`"),
        );
    }
    for argument in &entry.named {
        let name = argument.name.to_string();
        let is_port = definition.ports.iter().any(|port| port.name == name);
        match definition.entry(&argument.name) {
            _ if is_port => {}
            Some(own) if own.kind == "Param" => declaration.given.push(Given {
                instance: entry.name.to_string(),
                assembly: assembly.to_string(),
                to: Receiver::Parameter(own.clone()),
                value: outside.sealed(&argument.value),
            }),
            _ => errors.at(argument.name.span(), not_given(definition, &argument.name)),
        }
        scope.values.insert(name, outside.sealed(&argument.value));
    }
    for port in &definition.ports {
        let name = port.name.to_string();
        let given = scope.values.get(&name).cloned();
        let default = port.default.as_ref().map(|default| scope.written(default));
        if given.is_none() && default.is_none() {
            let about = match port.doc.as_str() {
                "" => String::new(),
                doc => format!(" (“{doc}”)"),
            };
            errors.at(
                entry.kind.span(),
                format!(
                    "`{assembly}` needs `{name} = …`, {}{about}",
                    port.takes.describe()
                ),
            );
        }
        // A default that is not taken is right as well, and what it names is used.
        for value in given.iter().chain(&default) {
            declaration.given.push(Given {
                instance: entry.name.to_string(),
                assembly: assembly.to_string(),
                to: Receiver::Port(port.clone()),
                value: value.clone(),
            });
        }
        scope
            .values
            .extend(given.or(default).map(|value| (name, value)));
    }
}

fn not_given(definition: &Definition, name: &Ident) -> String {
    let assembly = &definition.name;
    if let Some(entry) = definition.entry(name) {
        return format!(
            "`{name}` is a `{}` of `{assembly}`; ports and parameters can be given",
            entry.kind
        );
    }
    let is_family = |item: &&Item| matches!(item, Item::Family(family) if family.name == name.to_string().as_str());
    if let Some(Item::Family(family)) = definition.items.iter().find(is_family) {
        let is_parameter =
            |token: &TokenTree| matches!(token, TokenTree::Ident(kind) if *kind == "Param");
        return match any_token(family.call.to_token_stream(), &is_parameter) {
            true => format!(
                "`{name}` is a family of parameters of `{assembly}`: the program sets its members"
            ),
            false => {
                format!("`{name}` is a family of `{assembly}`; ports and parameters can be given")
            }
        };
    }
    let ports: Vec<String> = definition
        .ports
        .iter()
        .map(|port| port.name.to_string())
        .collect();
    let parameters: Vec<String> = definition.parameters().collect();
    let known = ports.iter().chain(&parameters).map(String::as_str);
    let hint = did_you_mean(&name.to_string(), known);
    let list = |what: &str, names: &[String]| match names {
        [] => format!("no {what}"),
        names => format!("{what}: {}", names.join(", ")),
    };
    format!(
        "`{assembly}` has no port or parameter `{name}`{hint} ({}; {})",
        list("ports", &ports),
        list("parameters", &parameters)
    )
}

/// Whether one of some tokens is wanted.
pub(super) fn any_token(tokens: TokenStream, is_wanted: &dyn Fn(&TokenTree) -> bool) -> bool {
    tokens.into_iter().any(|token| match &token {
        TokenTree::Group(group) => any_token(group.stream(), is_wanted),
        token => is_wanted(token),
    })
}
