//! The names in the entries of an assembly are those of its entries and ports, and each port is named.

use super::Entry;
use super::assemblies::Definition;
use super::entry::ASSEMBLY;
use super::item::Item;
use super::rewrite::{Role, Word, rewrite, rewrite_function, word};
use crate::diagnostics::{Errors, did_you_mean};
use crate::schema::RESERVED;
use proc_macro2::Ident;
use std::cell::RefCell;
use syn::Expr;

impl Definition {
    /// Refuses names of nothing, ports that nothing names, and defaults of ports that need the value of a later one: none
    /// depends on itself.
    pub fn check_names(&self, errors: &mut Errors) {
        let ports = || self.ports.iter().map(|port| port.name.to_string());
        let items = self.items.iter().filter_map(|item| match item {
            Item::Entry(entry) => Some(entry.name.to_string()),
            Item::Family(family) => Some(family.name.to_string()),
            Item::Doc(_) => None,
        });
        let known: Vec<String> = ports().chain(items).collect();
        let names = named(self);
        for port in &self.ports {
            if names.iter().all(|(name, _)| *name != port.name) {
                errors.at(
                    port.name.span(),
                    format!(
                        "nothing in the assembly `{}` names its port `{}`, so that what it is given would be ignored; use it or remove it",
                        self.name, port.name
                    ),
                );
            }
        }
        // A function that has no name here may be one of Rust.
        let values = names.iter().filter(|(_, role)| *role != Role::Function);
        for (name, _) in values {
            let text = name.to_string();
            if !known.contains(&text) && !RESERVED.contains(&text.as_str()) {
                let hint = match self.is_default_of_own_name(name) {
                    true => format!("; {CONSTANT_IN_ASSEMBLY}"),
                    false => did_you_mean(&text, known.iter().map(String::as_str)),
                };
                errors.at(
                    name.span(),
                    format!(
                        "the assembly `{}` has no entry or port `{text}`{hint}",
                        self.name
                    ),
                );
            }
        }
        for (index, port) in self.ports.iter().enumerate() {
            let later: Vec<String> = ports().skip(index).collect();
            let names = port.default.iter().flat_map(names_in);
            let found = names
                .into_iter()
                .find(|(name, role)| *role != Role::Function && later.contains(&name.to_string()));
            if let Some((name, _)) = found {
                errors.at(
                name.span(),
                format!("the default of `{}` needs the value of `{name}`, which is not known before; name ports that are declared before it", port.name),
            );
            }
        }
    }

    /// Whether this is a constant of Rust, and the default of the parameter that would be named like it.
    fn is_default_of_own_name(&self, name: &Ident) -> bool {
        let text = name.to_string();
        let is_read = |entry: &Entry| {
            entry.kind == "Param"
                && entry.name.as_str().eq_ignore_ascii_case(&text)
                && matches!(entry.positional.first(), Some(Expr::Path(path)) if path.path.is_ident(&text))
        };
        let mut items = self.items.iter();
        is_constant(&text) && items.any(|item| matches!(item, Item::Entry(entry) if is_read(entry)))
    }
}

/// Refuses a constant of Rust in an assembly.
pub const CONSTANT_IN_ASSEMBLY: &str = "a constant of Rust is the default of a parameter of a mechanism: where an assembly is used its path would mean another one; give a number here";

/// Whether a name that no entry has is written as constants of Rust are.
pub fn is_constant(name: &str) -> bool {
    let is_upper = name.contains(char::is_uppercase) && !name.contains(char::is_lowercase);
    is_upper && !RESERVED.contains(&name)
}

/// All names that stand for values or functions.
fn named(definition: &Definition) -> Vec<(Ident, Role)> {
    let mut list = Vec::new();
    for item in &definition.items {
        match item {
            Item::Entry(entry) => {
                let is_assembly = entry.kind == ASSEMBLY;
                // The path of an assembly is none, and a constant of Rust has a message of its own.
                let has_path = is_assembly || entry.named("nominal").is_some();
                let positional = entry.positional.iter().skip(usize::from(has_path));
                list.extend(positional.flat_map(names_in));
                for argument in &entry.named {
                    match word(&argument.name).filter(|_| !is_assembly) {
                        Some(Word::Law) => list.extend(names_of_law(&argument.value)),
                        Some(Word::OfLanguage) => {}
                        None => list.extend(names_in(&argument.value)),
                    }
                }
            }
            Item::Family(family) => list.extend(names_in(&Expr::Call(family.call.clone()))),
            Item::Doc(_) => {}
        }
    }
    let defaults = definition
        .ports
        .iter()
        .filter_map(|port| port.default.as_ref());
    list.extend(defaults.flat_map(names_in));
    list
}

fn names_in(expr: &Expr) -> Vec<(Ident, Role)> {
    collected(expr, |expr, note| rewrite(expr, note))
}

fn names_of_law(expr: &Expr) -> Vec<(Ident, Role)> {
    collected(expr, |expr, note| rewrite_function(expr, note))
}

/// The names that a function which puts others in their place comes to.
fn collected(
    expr: &Expr,
    visit: impl Fn(&mut Expr, &dyn Fn(&Ident, Role) -> Option<Expr>),
) -> Vec<(Ident, Role)> {
    let names = RefCell::new(Vec::new());
    visit(&mut expr.clone(), &|name, role| {
        names.borrow_mut().push((name.clone(), role));
        None
    });
    names.into_inner()
}
