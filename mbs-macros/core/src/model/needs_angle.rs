//! Which bars need an angle.

use crate::schema::{Expects, Kinds};
use crate::syntax::{Declaration, Entry, children, reference};
use std::collections::HashSet;
use syn::{Expr as Syntax, Member};

/// The names whose angle a joint, force or condition uses. Natural coordinates have no angle that counts full turns, so
/// that such a bar takes reference coordinates. (Outputs, events and drives need only the direction.)
pub(super) fn needs_angle(declaration: &Declaration, kinds: &Kinds) -> HashSet<String> {
    let mut names = HashSet::new();
    for entry in &declaration.entries {
        note_entry(entry, declaration, kinds, &mut names);
    }
    names
}

fn note_entry(
    entry: &Entry,
    declaration: &Declaration,
    kinds: &Kinds,
    names: &mut HashSet<String>,
) {
    let kind = entry.kind.to_string();
    if kind == "Output" || kind == "Event" {
        return;
    }
    let fields = kinds.kind(declaration.world_kind(), &kind);
    let fields = fields.map_or(&[][..], |kind| kind.fields);
    let by_place = fields.iter().filter(|field| field.positional);
    let by_place = entry
        .positional
        .iter()
        .zip(by_place.map(Some).chain([None].into_iter().cycle()));
    let by_name = entry.named.iter().map(|argument| {
        let mut fields = fields.iter();
        let field = fields.find(|field| argument.name == field.name);
        (&argument.value, field)
    });
    for (argument, field) in by_place.chain(by_name) {
        match field.map(|field| field.expects) {
            Some(Expects::Driven) => continue,
            Some(Expects::PartAngle) => {
                note(argument, names);
            }
            _ => {}
        }
        note_angles(argument, names);
    }
}

/// Notes `name` of each `name.angle`.
fn note_angles(syntax: &Syntax, names: &mut HashSet<String>) {
    if let Syntax::Field(field) = syntax
        && matches!(&field.member, Member::Named(member) if member == "angle")
    {
        note(&field.base, names);
    }
    for child in children(syntax) {
        note_angles(child, names);
    }
}

fn note(syntax: &Syntax, names: &mut HashSet<String>) {
    if let Some(Ok(name)) = reference(syntax) {
        names.insert(name.text());
    }
}
