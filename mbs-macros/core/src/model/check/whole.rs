//! Connected parts, used names, carried parts.

use crate::model::elements::{ForceEntry, JointEntry};
use crate::model::formulation::Formulation;
use crate::model::geometry::Owner;
use crate::model::parts::Representation;
use crate::model::resolver::Resolver;
use crate::model::tree::Tree;
use crate::names::base;
use crate::schema::World;
use proc_macro2::Span;
use std::collections::{BTreeSet, HashSet};

/// Every part is connected to something.
pub(in crate::model) fn connected(
    resolver: &mut Resolver,
    joints: &[JointEntry],
    forces: &[ForceEntry],
) {
    let mut connected: BTreeSet<Owner> = BTreeSet::new();
    for joint in joints {
        connected.extend(joint.joint.points.iter().map(|point| point.owner));
        connected.extend(&joint.joint.owners);
    }
    for force in forces {
        connected.extend(force.force.points.iter().map(|point| point.owner));
        connected.extend(&force.force.owners);
    }
    let lonely: Vec<(String, Span)> = resolver
        .parts
        .iter()
        .enumerate()
        .filter(|(index, part)| {
            let follows = part.representation == Representation::Prescribed
                || part.representation.is_number();
            let named = resolver.used.contains(&part.name);
            !follows && !part.free && !named && !connected.contains(&Owner::Part(*index))
        })
        .map(|(_, part)| (part.name.clone(), part.span))
        .collect();
    for (name, span) in lonely {
        resolver.fail_about(
            &name,
            span,
            format!("`{name}` is connected to nothing: join it, or write `free = true` if it is meant to move freely"),
        );
    }
}

/// Every parameter, input, point and named expression is used: nothing is silently ignored, unless `allow: Unused()` says
/// so. A family is used if one of its members is.
pub(in crate::model) fn used(resolver: &mut Resolver) {
    let declaration = resolver.declaration;
    let used = resolver.used.iter().map(|name| base(name).to_owned());
    let mut used: HashSet<String> = used.collect();
    for entry in &declaration.entries {
        let name = entry.name.base().to_owned();
        let kind = entry.kind.to_string();
        // What an assembly offers need not be taken.
        if entry.name.is_nested() && kind != "Param" && kind != "Input" {
            continue;
        }
        if matches!(
            kind.as_str(),
            "Param" | "Input" | "Let" | "Table" | "Point" | "Coordinate"
        ) && used.insert(name.clone())
        {
            // A coordinate that moves nothing has no mass, which no declaration may allow.
            let is_lint = kind != "Coordinate";
            if is_lint && declaration.allow_unused {
                continue;
            }
            let otherwise = match is_lint {
                true => ", or write `allow: Unused()`",
                false => "",
            };
            let before = resolver.errors.enter(entry.name.assembly());
            resolver.fail::<()>(
                entry.span(),
                format!("`{name}` is declared but never used; use it or remove it{otherwise}"),
            );
            resolver.errors.leave(before);
        }
    }
}

/// Parts that ask for joint coordinates are carried by a joint.
pub(in crate::model) fn carried(resolver: &mut Resolver, tree: &Tree) {
    for index in 0..resolver.parts.len() {
        let part = &resolver.parts[index];
        if part.formulation != Some(Formulation::Joint) || tree.carrier(index).is_some() {
            continue;
        }
        let (span, name) = (part.span, part.name.clone());
        let takes = carriers(resolver);
        resolver.fail_about(
            &name,
            span,
            format!("`{name}` asks for joint coordinates, but no joint carries it: that takes a {takes}, to the ground or to a part with axes; ask for `Reference`, or leave `coordinates =` out"),
        );
    }
}

/// The kinds of joints that can carry a part: those of the plane, and what space has besides.
fn carriers(resolver: &Resolver) -> String {
    let carrying = |world: World| -> Vec<&str> {
        let kinds = resolver.kinds.of(world);
        let carrying = kinds.filter(|kind| kind.traits().carries);
        carrying.map(|kind| kind.name).collect()
    };
    let planar = carrying(World::Planar);
    let mut spatial = carrying(World::Spatial);
    spatial.retain(|name| !planar.contains(name));
    format!("{}, in space also a {}", one_of(&planar), one_of(&spatial))
}

/// `a`, `b` or `c`.
fn one_of(names: &[&str]) -> String {
    let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    match names.split_last() {
        Some((last, [])) => last.clone(),
        Some((last, others)) => format!("{} or {last}", others.join(", ")),
        None => String::new(),
    }
}
