//! The entries of a family are put into the declaration.

use super::entry::{ASSEMBLY, entry, lost_parameter, place};
use super::families::{EACH, Family, Written};
use super::levels::is_level;
use super::name::Name;
use super::paths::path_text;
use super::{Declaration, Entry};
use crate::diagnostics::{Errors, Place};
use crate::schema::{self, Kinds};
use syn::{ExprCall, Ident};

/// Kinds whose families are arrays in the user's program.
const ARRAYS: &[&str] = &["Param", "Input", "Output", "State", ASSEMBLY];

/// `name: Each(…)` as read.
#[derive(Debug, Clone)]
pub(super) struct FamilyItem {
    pub(super) name: Name,
    pub(super) doc: String,
    pub(super) call: ExprCall,
}

/// Expands a family. Of a wrong one as much is kept as the user's program may refer to.
pub(super) fn place_family(
    item: &FamilyItem,
    kinds: &Kinds,
    declaration: &mut Declaration,
    errors: &mut Errors,
) {
    let FamilyItem { name, doc, call } = item;
    let word = name.as_str();
    if word == "world" || is_level(word) {
        errors.at(
            name.span(),
            format!("`{word}:` stands once; it is no family"),
        );
        return;
    }
    if !is_free(name.word(), errors) {
        return;
    }
    let found = errors.count();
    let first = declaration.entries.len();
    match Written::read(name, call) {
        Ok(written) => {
            declaration.families.push(written.family.clone());
            expand(&written, doc, kinds, declaration, errors);
            if errors.count() == found {
                check_members(&declaration.entries[first..], &written.family, call, errors);
            }
        }
        Err(error) => {
            errors.push(error);
            // The user's program may have indices.
            declaration.families.push(Family {
                name: name.clone(),
                ranges: std::iter::once(0..0).collect(),
            });
        }
    }
    if declaration.entries.len() == first {
        declaration
            .lost
            .extend(lost_parameter(name.word(), quote::quote! { #call }, kinds));
    }
}

/// Every member becomes an entry.
fn expand(
    family: &Written,
    doc: &str,
    kinds: &Kinds,
    declaration: &mut Declaration,
    errors: &mut Errors,
) {
    let parameters = family.parameters();
    for (index, parameter) in parameters.iter().enumerate() {
        if is_free(parameter, errors) && parameters[..index].contains(parameter) {
            errors.at(
                parameter.span(),
                format!("this closure has two parameters `{parameter}`; rename one of them"),
            );
        }
    }
    for (member, value) in family.members() {
        let before = errors.enter(member.as_str());
        let entry = match value {
            Ok(Some(value)) => entry(member, doc.to_owned(), value).map(Some),
            Ok(None) => Ok(None),
            Err(error) => Err(error),
        };
        match entry {
            Ok(entry) => {
                entry.map(|entry| place(entry, kinds, declaration, errors));
            }
            Err(error) => errors.push(error),
        }
        errors.leave(before);
    }
}

/// Refuses names with a meaning of their own.
fn is_free(name: &Ident, errors: &mut Errors) -> bool {
    let is_free = !schema::RESERVED.contains(&name.to_string().as_str());
    if !is_free {
        errors.at(
            name.span(),
            format!("`{name}` is reserved; choose another name"),
        );
    }
    is_free
}

/// A family has members, and those that become an array are one: from index 0 on, without gaps, of one kind.
fn check_members(entries: &[Entry], family: &Family, call: &ExprCall, errors: &mut Errors) {
    let name = &family.name;
    if entries.is_empty() {
        return errors.at(
            name.span(),
            format!("the `if` of `{name}` leaves out all of its members"),
        );
    }
    let array = |entry: &&Entry| ARRAYS.contains(&entry.kind.to_string().as_str());
    let Some(kind) = entries.iter().find(array).map(|entry| &entry.kind) else {
        return;
    };
    if let Some(other) = entries.iter().find(|entry| entry.kind != *kind) {
        return errors.at(
            other.kind.span(),
            format!("a family of `{kind}` is an array in your program: its members are all of that kind; make `{}` of another", other.kind),
        );
    }
    let path = |entry: &Entry| entry.positional.first().map(path_text);
    if *kind == ASSEMBLY
        && let Some(first) = entries.first().map(path)
        && let Some(other) = entries.iter().find(|other| path(other) != first)
    {
        return errors.at(
            other.positional.first().map_or(other.kind.span().into(), Place::of),
            "a family of assemblies is an array in your program: its members are all of one assembly; make two families",
        );
    }
    let place = call.args.first().map_or(name.span().into(), Place::of);
    if family.ranges.iter().any(|range| range.start > 0) {
        errors.at(
            place,
            format!("a family of `{kind}` is an array in your program: its indices begin at 0; write `{EACH}(0..…, …)`"),
        );
    } else if entries.len() < family.sizes().iter().product() {
        errors.at(
            name.span(),
            format!("a family of `{kind}` is an array in your program: no member is left out; give every member a value"),
        );
    }
}
