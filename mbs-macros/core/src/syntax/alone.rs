//! An assembly by itself: its entries as a declaration, which lists its parameters and finds what is wrong with them
//! wherever it is used.

use super::assemblies::{Definition, Definitions, any_token, put_all};
use super::bindings::names;
use super::children::{children, inner};
use super::entry::{ASSEMBLY, place};
use super::item::Item;
use super::members::{FamilyItem, place_family};
use super::paths::{named, path_text};
use super::reference::reference;
use super::{Declaration, Entry};
use crate::diagnostics::Errors;
use crate::schema::Kinds;
use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use quote::ToTokens;
use syn::Expr;

impl Definition {
    /// Its entries in a declaration of their own. Families whose members depend on a port are left out.
    pub fn alone(&self, kinds: &Kinds, errors: &mut Errors) -> Declaration {
        let mut declaration = Declaration {
            visibility: self.visibility.clone(),
            doc: self.doc.clone(),
            definitions: self.definitions.clone(),
            ..Declaration::nameable(self.name.clone())
        };
        for item in &self.items {
            match item {
                Item::Entry(entry) => {
                    place(entry.clone(), kinds, &mut declaration, errors);
                }
                Item::Family(family) => match self.port_of_members(family) {
                    Some(port) => self.check_varying(family, &port, errors),
                    None => place_family(family, kinds, &mut declaration, errors),
                },
                Item::Doc(_) => {}
            }
        }
        put_all(&mut declaration, kinds, errors);
        for entry in &declaration.entries {
            self.check_default(entry, errors);
        }
        declaration
    }

    /// The port that tells which members a family has: one in a range, or in a condition of its closure. What a list
    /// gives may stand in a condition, too.
    fn port_of_members(&self, family: &FamilyItem) -> Option<String> {
        let mut arguments = family.call.args.iter();
        let (over, closure) = (arguments.next()?, arguments.next());
        let (mut own, mut conditions) = (Vec::new(), TokenStream::new());
        if let Some(Expr::Closure(closure)) = closure {
            closure
                .inputs
                .iter()
                .for_each(|input| names(input, &mut own));
            note_conditions(closure.body.to_token_stream(), &mut conditions);
        }
        let is_fixed = |over: &Expr| matches!(inner(over), Expr::Array(_)) && conditions.is_empty();
        let ranges: TokenStream = match inner(over) {
            Expr::Tuple(several) => {
                let several = several.elems.iter().filter(|over| !is_fixed(over));
                several.map(ToTokens::to_token_stream).collect()
            }
            one if is_fixed(one) => TokenStream::new(),
            one => one.to_token_stream(),
        };
        let names_it = |tokens: &TokenStream, port: &Ident| {
            let is_port =
                |token: &TokenTree| matches!(token, TokenTree::Ident(name) if name == port);
            any_token(tokens.clone(), &is_port)
        };
        let mut ports = self.ports.iter().map(|port| &port.name);
        let found = ports.find(|port| {
            let in_conditions = !own.contains(port) && names_it(&conditions, port);
            in_conditions || names_it(&ranges, port)
        });
        found.map(Ident::to_string)
    }

    /// The fields of the struct of an assembly are the same in all of its uses.
    fn check_varying(&self, family: &FamilyItem, port: &str, errors: &mut Errors) {
        if has_parameters(&family.call.to_token_stream(), &self.definitions) {
            errors.at(
                family.name.span(),
                format!(
                    "the members of `{}` have parameters, which are fields of `{}` and the same wherever it is used: they cannot depend on the port `{port}`; write numbers in its place",
                    family.name, self.name
                ),
            );
        }
    }

    /// The defaults of parameters and inputs are numbers.
    fn check_default(&self, entry: &Entry, errors: &mut Errors) {
        let what = match entry.kind.to_string().as_str() {
            "Param" => "a parameter",
            "Input" => "an input",
            _ => return,
        };
        let named = entry.named.iter().map(|argument| &argument.value);
        let mut values = entry.positional.iter().chain(named);
        if let Some(port) = values.find_map(|value| self.port_in(value)) {
            errors.about(
                entry.name.as_str(),
                port.span(),
                format!("`{port}` is a port, whose value each use gives: the default of {what} is a number; write one, or declare a port instead of {what}"),
            );
        }
    }

    /// The first port that an expression names.
    fn port_in(&self, expr: &Expr) -> Option<Ident> {
        match reference(expr) {
            Some(Ok(found)) => {
                let mut ports = self.ports.iter();
                let is_port = ports.any(|port| port.name == found.base);
                is_port.then(|| found.word.clone())
            }
            _ => children(expr)
                .into_iter()
                .find_map(|child| self.port_in(child)),
        }
    }

    fn has_parameters(&self) -> bool {
        self.items.iter().any(|item| match item {
            Item::Entry(entry) if entry.kind == ASSEMBLY => {
                let path = entry.positional.first().map(path_text);
                path.is_some_and(|path| is_of_parameters(&path, &self.definitions))
            }
            Item::Entry(entry) => entry.kind == "Param",
            Item::Family(family) => {
                has_parameters(&family.call.to_token_stream(), &self.definitions)
            }
            Item::Doc(_) => false,
        })
    }
}

/// Whether the call of a family makes parameters, or assemblies that have some.
fn has_parameters(call: &TokenStream, definitions: &Definitions) -> bool {
    let is_parameter =
        |token: &TokenTree| matches!(token, TokenTree::Ident(kind) if kind == "Param");
    let mut paths = Vec::new();
    named(call, &mut paths);
    any_token(call.clone(), &is_parameter)
        || paths
            .iter()
            .any(|path| is_of_parameters(&path_text(path), definitions))
}

fn is_of_parameters(path: &str, definitions: &Definitions) -> bool {
    let mut definitions = definitions.iter();
    definitions.any(|(known, definition)| known == path && definition.has_parameters())
}

/// What stands between `if` and its braces.
fn note_conditions(tokens: TokenStream, list: &mut TokenStream) {
    let mut tokens = tokens.into_iter();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Ident(word) if word == "if" => {
                for token in tokens.by_ref() {
                    match token {
                        TokenTree::Group(braces) if braces.delimiter() == Delimiter::Brace => {
                            note_conditions(braces.stream(), list);
                            break;
                        }
                        condition => list.extend([condition]),
                    }
                }
            }
            TokenTree::Group(group) => note_conditions(group.stream(), list),
            _ => {}
        }
    }
}
