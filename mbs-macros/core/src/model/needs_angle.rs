//! Which bars need an angle.

use crate::schema::{Expects, Kinds};
use crate::syntax::{Declaration, Entry, children, reference};
use std::collections::{HashMap, HashSet};
use syn::{Expr as Syntax, Member};

/// The names whose angle a joint, force or condition uses, and the partners of joints among them. Natural coordinates
/// have no angle, so that such a bar takes reference coordinates. (Drives of bars need only the direction; outputs and
/// events have an angle that is counted beside the coordinates.)
pub(super) fn needs_angle(declaration: &Declaration, kinds: &Kinds) -> HashSet<String> {
    let mut names = HashSet::new();
    for entry in &declaration.entries {
        note_entry(entry, declaration, kinds, &mut names);
    }
    let others = other_names(declaration);
    follow(&others, &mut names);
    let mut joints = declaration.entries.iter();
    let joints = joints
        .by_ref()
        .filter(|entry| turns(entry, declaration, kinds) && names.contains(entry.name.as_str()));
    let partners: Vec<String> = joints.flat_map(partners).collect();
    names.extend(partners);
    follow(&others, &mut names);
    names
}

/// `Let`s that are no more than another name of a part, or of such a name in turn.
fn other_names(declaration: &Declaration) -> HashMap<&str, String> {
    let lets = declaration
        .entries
        .iter()
        .filter(|entry| entry.kind == "Let");
    lets.filter_map(|entry| {
        let named = entry.named("value").map(|argument| &argument.value);
        let part = reference(entry.positional.first().or(named)?)?.ok()?;
        Some((entry.name.as_str(), part.text()))
    })
    .collect()
}

/// Adds what these names stand for.
fn follow(others: &HashMap<&str, String>, names: &mut HashSet<String>) {
    let mut front: Vec<String> = names.iter().cloned().collect();
    while let Some(name) = front.pop() {
        if let Some(part) = others.get(name.as_str())
            && names.insert(part.clone())
        {
            front.push(part.clone());
        }
    }
}

/// Whether the entry is a joint that has an angle.
fn turns(entry: &Entry, declaration: &Declaration, kinds: &Kinds) -> bool {
    let kind = kinds.kind(declaration.world_kind(), &entry.kind.to_string());
    kind.is_some_and(|kind| kind.traits().turns)
}

/// The parts whose points a joint names.
fn partners(joint: &Entry) -> Vec<String> {
    let named = ["parent", "child"].map(|field| joint.named(field));
    let named = named.into_iter().flatten().map(|argument| &argument.value);
    let points = joint.positional.iter().chain(named);
    let owner = |point: &Syntax| {
        let part = match point {
            Syntax::Field(field) => &field.base,
            Syntax::MethodCall(call) => &call.receiver,
            _ => return None,
        };
        Some(reference(part)?.ok()?.text())
    };
    points.filter_map(owner).collect()
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
            Some(Expects::Driven) if drives_bar(argument, declaration, kinds) => continue,
            Some(Expects::PartAngle) => {
                note(argument, names);
            }
            _ => {}
        }
        note_angles(argument, names);
    }
}

/// Whether this is `bar.angle`, and not the angle of a joint.
fn drives_bar(target: &Syntax, declaration: &Declaration, kinds: &Kinds) -> bool {
    let Syntax::Field(field) = target else {
        return true;
    };
    let Some(Ok(name)) = reference(&field.base) else {
        return true;
    };
    let name = name.text();
    let mut entries = declaration.entries.iter();
    entries.all(|entry| entry.name != name.as_str() || !turns(entry, declaration, kinds))
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
