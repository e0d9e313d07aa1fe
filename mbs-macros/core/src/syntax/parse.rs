//! The parser: entries are split at commas first, so that an error in one entry does not hide errors in others.

use super::assemblies::put_all;
use super::chunk::{split_at_commas, without_attributes};
use super::definition::{declared_twice, with_definitions};
use super::entry::{lost_parameter, place};
use super::item::{Item, WITHOUT_RAW, is_word_of_rust, read, read_header, word_of_rust};
use super::levels::is_level;
use super::members::{FamilyItem, place_family};
use super::nameless::has_world;
use super::{Declaration, Entry, nested};
use crate::diagnostics::Errors;
use crate::schema::{self, Kinds};
use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use std::collections::HashSet;
use syn::Ident;

/// Parses a declaration, alone or with the assemblies that it names (`assemblies`). What parsed is returned even if some
/// entries did not.
pub fn parse(tokens: TokenStream, kinds: &Kinds, errors: &mut Errors) -> Option<Declaration> {
    let (tokens, definitions) = with_definitions(tokens, kinds);
    let found = name_of(&tokens);
    let (header, text) = match read_header(tokens) {
        Ok(read) => read,
        Err(error) => {
            errors.push(error);
            return found.map(Declaration::nameable);
        }
    };
    check_name(&header.name, "mechanism", errors);
    let mut declaration = Declaration {
        visibility: header.visibility,
        doc: header.doc,
        text,
        definitions,
        ..Declaration::nameable(header.name)
    };
    let mut broken_world = false;
    let mut names = HashSet::new();
    for chunk in split_at_commas(header.body) {
        broken_world |= starts_with_world(&chunk);
        match read(&chunk, kinds) {
            Ok(item) if !is_first(&item, &mut names, errors) => {}
            Ok(Item::Doc(doc)) => {
                if !declaration.doc.is_empty() {
                    declaration.doc.push('\n');
                }
                declaration.doc.push_str(&doc);
            }
            Ok(Item::Entry(entry)) => {
                if !place(entry, kinds, &mut declaration, errors) {
                    declaration.lost.extend(lost_entry(&chunk, kinds));
                }
            }
            Ok(Item::Family(family)) => place_family(&family, kinds, &mut declaration, errors),
            Err(error) => {
                errors.push(error);
                broken_world |= has_world(&chunk);
                declaration.lost.extend(lost_entry(&chunk, kinds));
            }
        }
    }
    if declaration.world.is_none() && !broken_world {
        errors.at(
            declaration.name.span(),
            "this mechanism has no world; write `world: Planar(gravity = [0.0, -9.81_m_per_s2]),` as its first entry",
        );
    }
    put_all(&mut declaration, kinds, errors);
    nested::resolve(&mut declaration, errors);
    Some(declaration)
}

/// Whether no entry before has the name of this one.
fn is_first(item: &Item, names: &mut HashSet<String>, errors: &mut Errors) -> bool {
    let name = match item {
        Item::Entry(Entry { name, .. }) | Item::Family(FamilyItem { name, .. }) => name,
        Item::Doc(_) => return true,
    };
    // These have messages of their own.
    let is_setting = *name == "world" || is_level(name.as_str());
    let is_first = is_setting || names.insert(name.to_string());
    if !is_first {
        errors.at(name.span(), declared_twice(name.as_str()));
    }
    is_first
}

/// Refuses names of mechanisms and assemblies that generated code could not live with.
pub(super) fn check_name(name: &Ident, what: &str, errors: &mut Errors) {
    let text = name.to_string();
    if text.starts_with("r#") {
        errors.at(name.span(), WITHOUT_RAW);
    }
    if is_word_of_rust(name) {
        errors.at(name.span(), word_of_rust(name));
    }
    if schema::PRIMITIVES.contains(&text.as_str()) {
        errors.at(
            name.span(),
            format!("`{text}` is a type of Rust; choose another name for the {what}"),
        );
    }
    // So that no two mechanisms can have types of the same name.
    let mut stems = schema::SUFFIXES.iter();
    let stem = stems.find_map(|suffix| text.strip_suffix(suffix));
    if let Some(stem) = stem.filter(|stem| !stem.is_empty()) {
        errors.at(
            name.span(),
            format!("a mechanism `{stem}` would have a type `{text}` beside its own; choose another name for this {what}"),
        );
    }
    if let Some(stem) = text
        .strip_suffix(schema::FIXED_STEP)
        .filter(|stem| !stem.is_empty())
    {
        errors.at(
            name.span(),
            format!("a mechanism `{stem}` would have a type `{text}Simulation`, as a mechanism `{text}` has; choose another name for this {what}"),
        );
    }
}

/// The name of the mechanism, also if other parts have errors.
fn name_of(tokens: &TokenStream) -> Option<Ident> {
    tokens.clone().into_iter().find_map(|token| match token {
        TokenTree::Ident(name) => syn::parse2(name.into_token_stream()).ok(),
        _ => None,
    })
}

/// The name of a wrong entry that seems to be a parameter: `name: Parm(…)` or `name: 1.0_m`.
fn lost_entry(chunk: &TokenStream, kinds: &Kinds) -> Option<Ident> {
    let mut tokens = without_attributes(chunk).into_iter();
    let Some(TokenTree::Ident(name)) = tokens.next() else {
        return None;
    };
    let name = syn::parse2(name.into_token_stream()).ok()?;
    lost_parameter(&name, tokens.collect(), kinds)
}

fn starts_with_world(entry: &TokenStream) -> bool {
    let first = without_attributes(entry).into_iter().next();
    matches!(first, Some(TokenTree::Ident(name)) if name == "world")
}
