//! What names mean around an assembly put in place, and inside it.

use super::assemblies::{Definition, TABLE, any_token};
use super::entry::{ASSEMBLY, place};
use super::exactly::{COORDINATE, exactly, may_be_initial};
use super::item::Item;
use super::members::{FamilyItem, place_family};
use super::name::Name;
use super::reference::{from_root, path_to};
use super::rewrite::{Role, Word, rewrite, rewrite_argument, rewrite_function, word};
use super::{Declaration, Entry, Takes};
use crate::diagnostics::{Errors, Place};
use crate::schema::{Kinds, RESERVED};
use proc_macro2::{Ident, TokenTree};
use quote::ToTokens;
use std::cell::RefCell;
use std::collections::{HashMap, HashSet};
use syn::Expr;

/// The entries around an assembly.
pub(super) struct Outside {
    tables: HashSet<String>,
}

impl Outside {
    pub(super) fn of(declaration: &Declaration) -> Outside {
        let entries = declaration.entries.iter();
        let tables = entries.filter(|entry| entry.kind == TABLE);
        Outside {
            tables: tables.map(|entry| entry.name.base().to_owned()).collect(),
        }
    }

    /// A value that means the same wherever it is put: inside the assembly, the parameter of a closure may have the name
    /// of an entry outside.
    pub(super) fn sealed(&self, value: &Expr) -> Expr {
        let mut value = value.clone();
        rewrite(&mut value, &|name, role| {
            let is_entry = match role {
                Role::Value | Role::Argument => may_be_entry(name),
                Role::Function => self.tables.contains(&name.to_string()),
            };
            is_entry.then(|| from_root(name))
        });
        value
    }
}

/// Whether an entry can have this name.
fn may_be_entry(name: &Ident) -> bool {
    !RESERVED.contains(&name.to_string().as_str())
}

/// What names mean inside an assembly put in place.
pub(super) struct Scope<'a> {
    pub(super) instance: &'a Name,
    pub(super) definition: &'a Definition,
    /// Of ports and parameters.
    pub(super) values: HashMap<String, Expr>,
    /// Ports that are given `Exactly(…)`, and are initial values.
    pub(super) held: RefCell<HashSet<String>>,
}

impl Scope<'_> {
    /// Puts an entry of the assembly into a declaration.
    pub(super) fn put(
        &self,
        item: &Item,
        kinds: &Kinds,
        declaration: &mut Declaration,
        errors: &mut Errors,
    ) {
        match item {
            Item::Doc(_) => {}
            Item::Entry(entry) => {
                place(self.entry(entry), kinds, declaration, errors);
            }
            Item::Family(family) => {
                if let Expr::Call(call) = self.written(&Expr::Call(family.call.clone())) {
                    let family = FamilyItem {
                        name: family.name.within(self.instance),
                        doc: family.doc.clone(),
                        call,
                    };
                    place_family(&family, kinds, declaration, errors);
                }
            }
        }
    }

    /// After all entries are put: what is given `Exactly(…)`, and is no initial value.
    pub(super) fn check_held(&self, errors: &mut Errors) {
        let held = self.held.borrow();
        for port in &self.definition.ports {
            let name = port.name.to_string();
            let value = self.values.get(&name).filter(|_| !held.contains(&name));
            if let Some(value) = value.filter(|value| exactly(value).is_some()) {
                let assembly = &self.definition.name;
                errors.at(
                    Place::of(value),
                    format!("no initial value of `{assembly}` is `{name}` alone, and `Exactly(…)` would hold nothing: leave it out"),
                );
            }
        }
    }

    fn entry(&self, entry: &Entry) -> Entry {
        let mut entry = entry.clone();
        let is_assembly = entry.kind == ASSEMBLY;
        // A path stays what it is.
        for argument in entry.positional.iter_mut().skip(usize::from(is_assembly)) {
            match entry.kind == COORDINATE {
                true => self.write_argument(argument),
                false => self.write(argument),
            }
        }
        for argument in &mut entry.named {
            match word(&argument.name).filter(|_| !is_assembly) {
                Some(Word::Law) => rewrite_function(&mut argument.value, &self.meaning()),
                Some(Word::OfLanguage) => {}
                None if is_assembly
                    || entry.kind == COORDINATE
                    || may_be_initial(&argument.name) =>
                {
                    self.write_argument(&mut argument.value);
                }
                None => self.write(&mut argument.value),
            }
        }
        if entry.kind == "Param"
            && let Some(given) = self.values.get(&entry.name.to_string())
        {
            let mut named = entry.named.iter_mut();
            let named = named.find(|argument| argument.name == "value");
            let value = named.map(|argument| &mut argument.value);
            if let Some(value) = value.or(entry.positional.first_mut()) {
                *value = given.clone();
            }
        }
        entry.name = entry.name.within(self.instance);
        entry
    }

    /// An expression with what they stand for in the place of names.
    pub(super) fn written(&self, expr: &Expr) -> Expr {
        let mut expr = expr.clone();
        self.write(&mut expr);
        expr
    }

    fn write(&self, expr: &mut Expr) {
        rewrite(expr, &self.meaning());
    }

    fn write_argument(&self, expr: &mut Expr) {
        rewrite_argument(expr, &self.meaning());
    }

    /// What a name stands for. Entries outside are not seen.
    fn meaning(&self) -> impl Fn(&Ident, Role) -> Option<Expr> {
        |name, role| match role {
            // As a part of an expression a value is not held.
            Role::Value => self.value(name).map(|value| match exactly(&value) {
                Some(held) => held.clone(),
                None => value,
            }),
            Role::Argument => self.value(name).inspect(|value| {
                if exactly(value).is_some() {
                    self.held.borrow_mut().insert(name.to_string());
                }
            }),
            Role::Function => self.table(name),
        }
    }

    fn value(&self, name: &Ident) -> Option<Expr> {
        let text = name.to_string();
        if self.definition.ports.iter().any(|port| port.name == text) {
            return self.values.get(&text).cloned();
        }
        may_be_entry(name).then(|| path_to(self.instance.as_str(), name))
    }

    /// A table, of the assembly or of a port; other functions have no entries.
    fn table(&self, name: &Ident) -> Option<Expr> {
        let mut ports = self.definition.ports.iter();
        if ports.any(|port| port.name == *name && port.takes == Takes::Table) {
            return self.values.get(&name.to_string()).cloned();
        }
        let is_table = match self.definition.item(name)? {
            Item::Entry(entry) => entry.kind == TABLE,
            Item::Family(family) => {
                let is_table =
                    |token: &TokenTree| matches!(token, TokenTree::Ident(kind) if *kind == TABLE);
                any_token(family.call.to_token_stream(), &is_table)
            }
            Item::Doc(_) => false,
        };
        is_table.then(|| path_to(self.instance.as_str(), name))
    }
}
