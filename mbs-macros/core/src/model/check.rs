//! Checks of whole entries and of the whole model: known arguments, connected parts, used names, coordinates with mass.

use super::Dimension;
use super::Formulation;
use super::Representation;
use super::advice;
use super::elements::{ForceElement, JointElement};
use super::geometry::{Owner, Point};
use super::parts::Part;
use super::placement::Guesses;
use super::reduce::Reduction;
use super::resolve::{Resolver, has_frames};
use super::tree::Tree;
use crate::diagnostics::{Place, did_you_mean};
use crate::schema::{self, Absent, Kind, World};
use crate::symbolic::{Graph, Symbol};
use crate::syntax::Entry;
use proc_macro2::Span;
use std::collections::BTreeSet;

/// How far apart points may be in the home pose, relative to the size of the mechanism: assembly closes such gaps.
pub(super) const NEARLY_TOGETHER: f64 = 1e-2;

/// Every argument is one that its kind has, and no required one is missing.
pub(super) fn arguments(resolver: &mut Resolver) {
    let declaration = resolver.declaration;
    for entry in declaration.world.iter().chain(&declaration.entries) {
        let name = entry.kind.to_string();
        let kind = if entry.name == "world" {
            schema::world(&name).map(World::kind)
        } else {
            schema::kind(resolver.world, &name)
        };
        if let Some(kind) = kind {
            entry_arguments(resolver, entry, kind);
        } else if let Some(kind) = schema::any_kind(&name) {
            let (world, kind) = (resolver.world.describe(), kind.name);
            let advice = advice::kind(resolver.world, kind);
            resolver.fail::<()>(
                entry.kind.span(),
                format!("there is no `{kind}` in {world}; {advice}"),
            );
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
    let mut misplaced = false;
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
            Place::of(surplus),
            format!("`{}` takes {takes}; name the others", kind.name),
        );
        misplaced = true;
    }
    for argument in &entry.named {
        let name = argument.name.to_string();
        if !kind.fields.iter().any(|field| field.name == name) {
            let known = kind.fields.iter().map(|field| field.name);
            let hint = match advice::argument(resolver.world, kind.name, &name) {
                Some(advice) => format!("; {advice}"),
                None => did_you_mean(&name, known.clone()),
            };
            let known: Vec<_> = known.collect();
            resolver.fail::<()>(
                argument.name.span(),
                format!(
                    "`{}` has no argument `{name}`{hint} (arguments: {})",
                    kind.name,
                    known.join(", ")
                ),
            );
            misplaced = true;
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
    if misplaced {
        // What seems to be missing may be what stands in the wrong place, and what is wrong besides may follow from it.
        resolver.misplaced.insert(entry.name.to_string());
        return;
    }
    for (slot, field) in kind
        .fields
        .iter()
        .enumerate()
        .filter(|(_, field)| field.default == Absent::Required)
    {
        let by_position = field.positional && slot < entry.positional.len();
        if !by_position && entry.named(field.name).is_none() {
            resolver.misplaced.insert(entry.name.to_string());
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

/// In space, the frames that a joint holds together are together in the home pose, with the defaults of all parameters.
/// (Differences within the rounding of a written number are left to assembly.)
pub(super) fn home_poses(resolver: &mut Resolver, joints: &[JointElement], guesses: &Guesses) {
    let mut found: Vec<Disagreement> = Vec::new();
    let mut size = 0.0f64;
    for element in joints {
        let entry = resolver.declaration.entries.iter();
        let mut entry = entry.filter(|entry| entry.name == element.name);
        let Some(kind) = entry.next().map(|entry| entry.kind.to_string()) else {
            continue;
        };
        let points = element.joint.points();
        if let (true, [parent, child]) = (has_frames(resolver.world, &kind), points.as_slice()) {
            let disagreement = Disagreement::new(resolver, element, kind, [parent, child], guesses);
            let homes = disagreement.homes.as_flattened().iter();
            size = homes.fold(size, |size, x| size.max(x.abs()));
            found.push(disagreement);
        }
    }
    for disagreement in found {
        if let Some(message) = disagreement.message(size) {
            resolver.fail::<()>(disagreement.span, message);
        }
    }
}

/// How far the partners of a joint are from where it holds them.
struct Disagreement {
    span: Span,
    kind: String,
    labels: [String; 2],
    homes: [[f64; 3]; 2],
    /// In the directions that the joint holds.
    gap: f64,
    /// Radians; about the directions that the joint holds.
    angle: f64,
    /// Whether it holds all directions.
    coincident: bool,
}

impl Disagreement {
    fn new(
        resolver: &mut Resolver,
        element: &JointElement,
        kind: String,
        points: [&Point; 2],
        guesses: &Guesses,
    ) -> Self {
        let homes = points.map(|point| {
            let home = resolver.home_of(point);
            home.map(|x| resolver.by_default(x))
        });
        let rows = element.joint.equations(&mut resolver.graph).rows;
        let size_of = |resolver: &mut Resolver, dimension: Dimension| {
            let rows = rows.iter().filter(|row| row.dimension == Some(dimension));
            let squares = rows.map(|row| resolver.at_home(row.expr, guesses).powi(2));
            squares.sum::<f64>().sqrt()
        };
        Disagreement {
            span: element.span,
            kind,
            labels: points.map(|point| point.label.clone()),
            homes,
            gap: size_of(resolver, Dimension::LENGTH),
            angle: size_of(resolver, Dimension::NONE).min(1.0).asin(),
            coincident: element.joint.coincident().is_some(),
        }
    }

    fn message(&self, size: f64) -> Option<String> {
        let ([first, second], [parent, child]) = (&self.labels, &self.homes);
        let (kind, gap, angle) = (&self.kind, self.gap, self.angle.to_degrees());
        let held = match self.coincident {
            true => format!("{gap:.3} m apart, but this joint holds them together"),
            false => format!("{gap:.3} m apart in directions that this `{kind}` holds"),
        };
        if gap > NEARLY_TOGETHER * size {
            return Some(format!(
                "in the home pose `{first}` is at {parent:?} m and `{second}` at {child:?} m, {held}; move one of the parts by its `at`, `from` or `orientation`"
            ));
        }
        (self.angle > NEARLY_TOGETHER).then(|| format!("in the home pose the axes at `{first}` and at `{second}` are {angle:.1}° off those that this `{kind}` holds together; turn one of the frames or parts, or give the axis once by `axis =`"))
    }
}

/// Parts that ask for joint coordinates are carried by a joint.
pub(super) fn carried(resolver: &mut Resolver, tree: &Tree) {
    for index in 0..resolver.parts.len() {
        let part = &resolver.parts[index];
        if part.formulation != Some(Formulation::Joint) || tree.carrier(index).is_some() {
            continue;
        }
        let (span, name) = (part.span, part.name.clone());
        resolver.fail::<()>(
            span,
            format!("`{name}` asks for joint coordinates, but no joint carries it: that takes a `Revolute`, `Prismatic` or `Fixed`, in space also a `Cylindrical`, `Spherical`, `Universal` or `Planar`, to the ground or to a part with axes; ask for `Reference`, or leave `coordinates =` out"),
        );
    }
}

/// Something moves, and with every coordinate moves some mass.
pub(super) fn massive(resolver: &mut Resolver, reduction: &Reduction) {
    if !resolver.errors.is_empty() {
        return;
    }
    let graph = &resolver.graph;
    let coordinate = |local: &u32| reduction.coordinate_of(graph, *local);
    let heavy: BTreeSet<u32> = resolver
        .parts
        .iter()
        .flat_map(|part| heavy_locals(graph, part))
        .filter_map(|local| coordinate(&local))
        .collect();
    // Of the parts that share a massless coordinate the first answers for it.
    let mut known = heavy.clone();
    let mut massless: Vec<(Span, String)> = Vec::new();
    for part in &resolver.parts {
        let light: Vec<u32> = part
            .locals
            .iter()
            .filter(|local| coordinate(local).is_some_and(|index| known.insert(index)))
            .copied()
            .collect();
        if !light.is_empty() {
            let turns_only = part.representation == Representation::Reference && light.len() == 1;
            massless.push((part.span, massless_message(part, turns_only)));
        }
    }
    if known.is_empty() {
        let message = "nothing in this mechanism moves: declare a `Bar`, `Body` or `Particle` that the ground does not hold";
        resolver.fail::<()>(resolver.declaration.name.span(), message);
    }
    for (span, message) in massless {
        resolver.fail::<()>(span, message);
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
            "`{name}` moves without mass: give it `mass =`, or join its moving ends to parts that have mass"
        ),
        "Particle" => format!(
            "`{name}` moves without mass: give it `mass =`, or join it to a part that has mass"
        ),
        _ => format!("`{name}` moves without mass: give it a positive `mass =`"),
    }
}
