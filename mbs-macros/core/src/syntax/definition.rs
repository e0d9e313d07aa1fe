//! What `assembly!` declares, as read: ports, entries, and the assemblies that these name.
//!
//! An assembly reaches a mechanism as tokens (`crate::assemblies`):
//!
//! ```text
//! @ { declaration } { {path} {assembly} {path} {assembly} … }      assembly: { declaration } { {path} {assembly} … }
//! ```
//!
//! A word behind the two parts of an assembly says that it has errors of its own.

use super::Entry;
use super::assemblies::{Definition, Definitions, Port, Takes};
use super::chunk::split_at_commas;
use super::entry::{ASSEMBLY, PORT};
use super::item::{Item, read, read_header};
use super::levels::is_level;
use super::parse::check_name;
use super::paths::path_text;
use crate::diagnostics::{Errors, Place, did_you_mean_kind};
use crate::schema::{self, Kinds, World};
use proc_macro2::{TokenStream, TokenTree};
use std::rc::Rc;
use syn::Expr;

/// A declaration without the assemblies that came with it.
pub(super) fn with_definitions(tokens: TokenStream, kinds: &Kinds) -> (TokenStream, Definitions) {
    match parts(tokens) {
        Ok((declaration, definitions)) => (declaration, definitions_of(definitions, kinds)),
        Err(tokens) => (tokens, Vec::new()),
    }
}

/// Whether one of the assemblies has errors, which are shown where it is declared.
pub fn is_broken(tokens: &TokenStream) -> bool {
    let Ok((_, definitions)) = parts(tokens.clone()) else {
        return false;
    };
    let mut assemblies = definitions.into_iter().skip(1).step_by(2);
    assemblies.any(|assembly| match assembly {
        TokenTree::Group(assembly) => assembly.stream().into_iter().count() > 2,
        _ => false,
    })
}

/// `@ { declaration } { definitions }`, or the tokens as they are.
fn parts(tokens: TokenStream) -> Result<(TokenStream, TokenStream), TokenStream> {
    let list: Vec<TokenTree> = tokens.clone().into_iter().collect();
    match list.as_slice() {
        [
            TokenTree::Punct(at),
            TokenTree::Group(declaration),
            TokenTree::Group(definitions),
        ] if at.as_char() == '@' => Ok((declaration.stream(), definitions.stream())),
        _ => Err(tokens),
    }
}

fn definitions_of(tokens: TokenStream, kinds: &Kinds) -> Definitions {
    let list: Vec<TokenTree> = tokens.into_iter().collect();
    let pairs = list.chunks(2).filter_map(|pair| match pair {
        [TokenTree::Group(path), TokenTree::Group(assembly)] => {
            let mut inner = assembly.stream().into_iter();
            let (Some(TokenTree::Group(declaration)), Some(TokenTree::Group(inside))) =
                (inner.next(), inner.next())
            else {
                return None;
            };
            // Its errors are shown where it is declared.
            let mut errors = Errors::new();
            let definition = define(declaration.stream(), inside.stream(), kinds, &mut errors)?;
            Some((path_text(&path.stream()), Rc::new(definition)))
        }
        _ => None,
    });
    pairs.collect()
}

/// Reads an assembly.
pub fn define(
    declaration: TokenStream,
    inside: TokenStream,
    kinds: &Kinds,
    errors: &mut Errors,
) -> Option<Definition> {
    let header = match read_header(declaration) {
        Ok((header, _)) => header,
        Err(error) => {
            errors.push(error);
            return None;
        }
    };
    check_name(&header.name, "assembly", errors);
    if header.name.to_string().starts_with("r#") {
        return None;
    }
    let mut definition = Definition {
        visibility: header.visibility,
        name: header.name,
        doc: header.doc,
        world: World::Planar,
        ports: Vec::new(),
        items: Vec::new(),
        definitions: definitions_of(inside, kinds),
    };
    let mut world = None;
    for chunk in split_at_commas(header.body) {
        match read(&chunk, kinds) {
            Ok(item) => note(item, &mut definition, &mut world, kinds, errors),
            Err(error) => errors.push(error),
        }
    }
    if world.is_none() && errors.is_empty() {
        errors.at(
            definition.name.span(),
            "this assembly has no world; write `world: Planar(),` or `world: Spatial(),` as its first entry",
        );
    }
    Some(definition)
}

fn note(
    item: Item,
    definition: &mut Definition,
    world: &mut Option<World>,
    kinds: &Kinds,
    errors: &mut Errors,
) {
    let entry = match item {
        Item::Doc(doc) => {
            if !definition.doc.is_empty() {
                definition.doc.push('\n');
            }
            return definition.doc.push_str(&doc);
        }
        Item::Family(family) => {
            if is_free(family.name.word(), definition, errors) {
                definition.items.push(Item::Family(family));
            }
            return;
        }
        Item::Entry(entry) => entry,
    };
    if entry.name == "world" {
        match schema::world(&entry.kind.to_string()) {
            Some(found) if world.is_none() => (*world, definition.world) = (Some(found), found),
            Some(_) => errors.at(
                entry.name.span(),
                "the world is already declared; keep one `world:` entry",
            ),
            None => errors.at(
                entry.kind.span(),
                format!(
                    "there is no world `{}` (worlds: Planar, Spatial)",
                    entry.kind
                ),
            ),
        }
        let given = entry.positional.iter();
        let given = given.chain(entry.named.iter().map(|argument| &argument.value));
        if let Some(argument) = given.into_iter().next() {
            errors.at(
                Place::of(argument),
                "the world of an assembly has no arguments: gravity and coordinates are those of the mechanism",
            );
        }
        return;
    }
    if is_level(entry.name.as_str()) {
        let word = &entry.name;
        return errors.at(
            entry.name.span(),
            format!("`{word}:` stands in the mechanism, for all of it"),
        );
    }
    if !is_free(entry.name.word(), definition, errors) {
        return;
    }
    if entry.kind == PORT {
        match port(&entry) {
            Ok(port) => definition.ports.push(port),
            Err(error) => errors.push(error),
        }
        return;
    }
    let known = kinds.names().chain([super::families::EACH, ASSEMBLY, PORT]);
    if known.clone().all(|name| entry.kind != name) {
        let hint = did_you_mean_kind(&entry.kind.to_string(), known);
        return errors.at(
            entry.kind.span(),
            format!("there is no kind `{}`{hint}", entry.kind),
        );
    }
    definition.items.push(Item::Entry(entry));
}

/// Refuses names that have a meaning of their own, or are there already.
fn is_free(name: &proc_macro2::Ident, definition: &Definition, errors: &mut Errors) -> bool {
    let text = name.to_string();
    if schema::RESERVED.contains(&text.as_str()) {
        errors.at(
            name.span(),
            format!("`{text}` is reserved; choose another name"),
        );
        return false;
    }
    let is_same = |item: &Item| match item {
        Item::Entry(entry) => entry.name == text.as_str(),
        Item::Family(family) => family.name == text.as_str(),
        Item::Doc(_) => false,
    };
    let taken = definition.items.iter().any(is_same)
        || definition.ports.iter().any(|port| port.name == text);
    if taken {
        errors.at(name.span(), declared_twice(&text));
    }
    !taken
}

/// The message at the second of two entries of one name.
pub(super) fn declared_twice(name: &str) -> String {
    format!("`{name}` is declared twice; rename one of them")
}

/// Reads `Port(Point)` or `Port(Number, default = 1.0)`.
fn port(entry: &Entry) -> syn::Result<Port> {
    let expected = || {
        let words: Vec<&str> = Takes::ALL.iter().map(|(word, _)| *word).collect();
        format!(
            "a port says what it takes: `{}: Port(Point)` ({})",
            entry.name,
            words.join(", ")
        )
    };
    let word = match entry.positional.as_slice() {
        [Expr::Path(path)] => path.path.get_ident(),
        [] => return Err(syn::Error::new(entry.kind.span(), expected())),
        [other] => return Err(syn::Error::new_spanned(other, expected())),
        [_, more, ..] => return Err(syn::Error::new_spanned(more, expected())),
    };
    let takes = word.and_then(|word| Takes::ALL.iter().find(|(known, _)| word == known));
    let Some(&(_, takes)) = takes else {
        return Err(syn::Error::new_spanned(&entry.positional[0], expected()));
    };
    if let Some(other) = entry
        .named
        .iter()
        .find(|argument| argument.name != "default")
    {
        return Err(syn::Error::new(
            other.name.span(),
            format!("a port has no argument `{}` (it has: default)", other.name),
        ));
    }
    Ok(Port {
        name: entry.name.word().clone(),
        doc: entry.doc.clone(),
        takes,
        default: entry
            .named("default")
            .map(|argument| argument.value.clone()),
    })
}
