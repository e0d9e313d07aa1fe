//! Coordinates without mass.

use crate::model::parts::{Part, Representation};
use crate::model::reduction::Reduction;
use crate::model::resolver::Resolver;
use crate::model::tree::Tree;
use crate::symbolic::{Graph, Symbol};
use proc_macro2::Span;
use std::collections::BTreeSet;

/// There is at least one coordinate, and every coordinate moves a mass. (The coordinates of joints are not looked at, nor
/// those of parts that carry others by them: all parts after them move with them. A part that is carried moves with several.)
pub(in crate::model) fn massive(resolver: &mut Resolver, tree: &Tree, reduction: &Reduction) {
    if !resolver.errors.is_empty() {
        return;
    }
    let carried: BTreeSet<usize> = tree.joints.iter().map(|joint| joint.child).collect();
    let carriers: BTreeSet<usize> = tree
        .joints
        .iter()
        .filter_map(|joint| joint.parent)
        .collect();
    let graph = &resolver.graph;
    let coordinate = |local: &u32| reduction.coordinate_of(graph, *local);
    let heavy: BTreeSet<u32> = resolver
        .parts
        .iter()
        .flat_map(|part| heavy_locals(graph, part))
        .filter_map(|local| coordinate(&local))
        .collect();
    // Of the parts that share a massless coordinate the first gets the error.
    let mut known = heavy.clone();
    let mut massless: Vec<(String, Span, String)> = Vec::new();
    let mut are_bars = true;
    for (index, part) in resolver.parts.iter().enumerate() {
        let is_carried = carried.contains(&index);
        let of_points = part.representation.is_points();
        // A coordinate may move a part that carries others.
        let is_coordinate = part.representation == Representation::Coordinate;
        let of_tree = is_carried && !of_points || is_coordinate && !tree.joints.is_empty();
        if carriers.contains(&index) || of_tree {
            continue;
        }
        let light: Vec<u32> = part
            .locals
            .iter()
            .filter(|local| coordinate(local).is_some_and(|index| known.insert(index)))
            .copied()
            .collect();
        if !light.is_empty() {
            let turns_only = part.representation == Representation::Reference && light.len() == 1;
            let follower = follower(graph, &resolver.parts, &light);
            let message = match follower {
                Some(follower) => format!(
                    "only `{follower}` follows `{}`, and without mass: give `{follower}` a positive `mass =`",
                    part.name
                ),
                None => massless_message(part, turns_only),
            };
            are_bars &= part.kind == "Bar";
            massless.push((part.name.clone(), part.span, message));
        }
    }
    if known.is_empty() && tree.joints.is_empty() {
        let message = "nothing in this mechanism moves: declare a `Bar`, `Body` or `Particle` that the ground does not hold";
        resolver.fail::<()>(resolver.declaration.name.span(), message);
    }
    // A bar without mass is a link on purpose; other parts have lost theirs.
    if !massless.is_empty() && are_bars && resolver.errors.is_empty() {
        resolver.errors.are_of_mass();
    }
    for (name, span, message) in massless {
        resolver.fail_about(&name, span, message);
    }
}

/// The coordinates of a part, or those that it follows, with which it moves mass.
fn heavy_locals(graph: &Graph, part: &Part) -> Vec<u32> {
    let (mass, inertia) = (
        !graph.is_zero(part.mass),
        !graph.is_zero(part.inertia[2][2]),
    );
    match part.representation {
        Representation::Coordinate => Vec::new(),
        // The 1 on the diagonal of M.
        Representation::State => part.locals.clone(),
        Representation::Natural | Representation::FreePoint if mass => part.locals.clone(),
        Representation::Natural | Representation::FreePoint => Vec::new(),
        Representation::Reference => {
            let carried = [mass, mass, inertia];
            let locals = part.locals.iter().zip(carried);
            locals
                .filter(|(_, carried)| *carried)
                .map(|(&local, _)| local)
                .collect()
        }
        // An inertia that vanishes about an axis was refused where it was declared.
        Representation::Rigid if mass => part.locals.clone(),
        Representation::Rigid => part.locals[3..].to_vec(),
        Representation::Prescribed => {
            let turn = part.frame.angle.filter(|_| inertia);
            let place = part.frame.origin.into_iter().filter(|_| mass);
            let swing = part.frame.axes[0]
                .into_iter()
                .filter(|_| mass && part.center.iter().any(|&x| !graph.is_zero(x)));
            let symbols = graph.directions(turn.into_iter().chain(place).chain(swing));
            symbols
                .into_iter()
                .filter_map(|symbol| match symbol {
                    Symbol::LocalPosition(local) => Some(local),
                    _ => None,
                })
                .collect()
        }
    }
}

/// A part that follows one of these coordinates, but moves no mass with it.
fn follower<'a>(graph: &Graph, parts: &'a [Part], light: &[u32]) -> Option<&'a str> {
    let mut followers = parts.iter().filter(|part| {
        let place = part.frame.origin.into_iter().chain(part.frame.angle);
        let symbols = graph.directions(place);
        part.representation == Representation::Prescribed
            && symbols.iter().any(
                |symbol| matches!(symbol, Symbol::LocalPosition(local) if light.contains(local)),
            )
    });
    let first = followers.next()?;
    // Parts with mass that do not move with it have a message of their own.
    (graph.is_zero(first.mass) && followers.next().is_none()).then_some(first.name.as_str())
}

fn massless_message(part: &Part, turns_only: bool) -> String {
    let name = &part.name;
    match part.kind {
        "Coordinate" => format!(
            "nothing with mass follows `{name}`: let a part follow it by `frame =` or `position =`, or remove it"
        ),
        "Body" if turns_only => format!(
            "`{name}` turns without inertia: give it a positive `inertia =`, or use a `Particle`"
        ),
        "Bar" if part.representation == Representation::Natural => format!(
            "`{name}` moves without mass: give it `mass =`, or join its moving ends to bars and particles that have mass (a joint with a `Body` does not share the point: there a `Distance` serves)"
        ),
        "Particle" => format!(
            "`{name}` moves without mass: give it `mass =`, or join it to a part that has mass"
        ),
        _ => format!("`{name}` moves without mass: give it a positive `mass =`"),
    }
}
