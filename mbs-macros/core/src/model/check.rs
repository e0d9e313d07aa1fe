//! Checks of whole entries: known arguments, connected parts, used names.

use super::Representation;
use super::geometry::Owner;
use super::resolve::{ForceElement, JointElement, Resolver};
use crate::diagnostics::did_you_mean;
use crate::schema::{self, Absent, Kind};
use crate::syntax::Entry;
use proc_macro2::Span;
use std::collections::BTreeSet;
use syn::spanned::Spanned;

/// Every argument is one that its kind has, and no required one is missing.
pub(super) fn arguments(resolver: &mut Resolver) {
    let declaration = resolver.declaration;
    for entry in declaration.world.iter().chain(&declaration.entries) {
        let name = entry.kind.to_string();
        let kind = if entry.name == "world" {
            schema::world(&name)
        } else {
            schema::kind(&name)
        };
        if let Some(kind) = kind {
            entry_arguments(resolver, entry, kind);
        }
    }
}

fn entry_arguments(resolver: &mut Resolver, entry: &Entry, kind: &Kind) {
    let positional: Vec<&str> = kind
        .fields
        .iter()
        .filter(|field| field.positional)
        .map(|field| field.name)
        .collect();
    if let Some(surplus) = entry.positional.get(positional.len()) {
        let takes = match positional.as_slice() {
            [] => "no positional arguments".to_owned(),
            [one] => format!("one positional argument (`{one}`)"),
            many => format!(
                "{} positional arguments (`{}`)",
                many.len(),
                many.join("`, `")
            ),
        };
        resolver.fail::<()>(
            surplus.span(),
            format!("`{}` takes {takes}; name the others", kind.name),
        );
    }
    for argument in &entry.named {
        let name = argument.name.to_string();
        if !kind.fields.iter().any(|field| field.name == name) {
            let known = kind.fields.iter().map(|field| field.name);
            let hint = did_you_mean(&name, known.clone());
            let known: Vec<_> = known.collect();
            resolver.fail::<()>(
                argument.name.span(),
                format!(
                    "`{}` has no argument `{name}`{hint} (arguments: {})",
                    kind.name,
                    known.join(", ")
                ),
            );
        } else if positional
            .iter()
            .position(|known| *known == name)
            .is_some_and(|slot| slot < entry.positional.len())
        {
            resolver.fail::<()>(
                argument.name.span(),
                format!("`{name}` is given by position already"),
            );
        }
    }
    for (slot, field) in kind
        .fields
        .iter()
        .enumerate()
        .filter(|(_, field)| field.default == Absent::Required)
    {
        let by_position = field.positional && slot < entry.positional.len();
        if !by_position && entry.named(field.name).is_none() {
            resolver.fail::<()>(
                entry.kind.span(),
                format!("`{}` needs `{}`: {}", kind.name, field.name, field.doc),
            );
        }
    }
}

/// Every part is connected to something.
pub(super) fn connected(resolver: &mut Resolver, joints: &[JointElement], forces: &[ForceElement]) {
    let mut connected: BTreeSet<Owner> = BTreeSet::new();
    for joint in joints {
        connected.extend(joint.joint.points().iter().map(|point| point.owner));
        connected.extend(joint.joint.owners());
    }
    for force in forces {
        connected.extend(force.force.points().iter().map(|point| point.owner));
        connected.extend(force.force.owners());
    }
    let lonely: Vec<(String, Span)> = resolver
        .parts
        .iter()
        .enumerate()
        .filter(|(index, part)| {
            let follows = matches!(
                part.representation,
                Representation::Prescribed | Representation::Coordinate
            );
            let named = resolver.used.contains(&part.name);
            !follows && !part.free && !named && !connected.contains(&Owner::Part(*index))
        })
        .map(|(_, part)| (part.name.clone(), part.span))
        .collect();
    for (name, span) in lonely {
        resolver.fail::<()>(
            span,
            format!("`{name}` is connected to nothing: join it, or write `free = true` if it is meant to move freely"),
        );
    }
}

/// Every parameter, input, point and named expression is used: nothing is silently ignored.
pub(super) fn used(resolver: &mut Resolver) {
    let declaration = resolver.declaration;
    for entry in &declaration.entries {
        let name = entry.name.to_string();
        let kind = entry.kind.to_string();
        if matches!(
            kind.as_str(),
            "Param" | "Input" | "Let" | "Point" | "Coordinate"
        ) && !resolver.used.contains(&name)
        {
            resolver.fail::<()>(
                entry.span(),
                format!("`{name}` is declared but never used; use it or remove it"),
            );
        }
    }
}
