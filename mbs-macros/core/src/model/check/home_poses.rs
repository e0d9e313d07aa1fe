//! Home poses that joints contradict.

use crate::dimension::Dimension;
use crate::model::defaults::largest;
use crate::model::elements::JointEntry;
use crate::model::geometry::Point;
use crate::model::home::NEARLY_TOGETHER;
use crate::model::initial_pose::Guesses;
use crate::model::mobilizer::Freedom;
use crate::model::resolver::Resolver;
use proc_macro2::Span;
use std::f64::consts::PI;

/// In space, the frames that a joint holds together are together in the home pose, with the defaults of all parameters.
/// (Differences within the rounding of a written number are left to assembly.)
pub(in crate::model) fn home_poses(
    resolver: &mut Resolver,
    joints: &[JointEntry],
    guesses: &Guesses,
) {
    let mut found: Vec<Disagreement> = Vec::new();
    // A joint in the origin has no coordinate, yet its rows carry the rounding of the places of the parts.
    let lengths = resolver.lengths_of_parts();
    let [mut size, ..] = largest(&resolver.graph, &resolver.parameters, &lengths);
    for element in joints {
        let Some(&index) = resolver.names.get(&element.name) else {
            continue;
        };
        let entry = resolver.entry(index);
        let points = &element.joint.points;
        if let (true, [parent, child]) = (resolver.has_frames(entry), points.as_slice()) {
            let kind = entry.kind.to_string();
            let mut disagreement =
                Disagreement::new(resolver, element, kind, [parent, child], guesses);
            if points_back(resolver, element, guesses) {
                disagreement.angle = PI - disagreement.angle;
            }
            let homes = disagreement.homes.as_flattened().iter();
            size = homes.fold(size, |size, x| size.max(x.abs()));
            found.push(disagreement);
        }
    }
    for disagreement in found {
        if let Some(message) = disagreement.message(size) {
            resolver.fail_about(&disagreement.name, disagreement.span, message);
        }
    }
}

/// Whether axes that the joint holds parallel are opposite: its rows, which are products of axes, vanish there too.
fn points_back(resolver: &mut Resolver, element: &JointEntry, guesses: &Guesses) -> bool {
    let Some(mobilizer) = &element.joint.mobilizer else {
        return false;
    };
    let mut turns = mobilizer.freedoms.iter().filter(|freedom| freedom.turns());
    let held: &[usize] = match (turns.next(), turns.next()) {
        (None, _) => &[2, 0],
        (Some(Freedom::Turn(_) | Freedom::Helix(_)), None) => &[2],
        _ => &[],
    };
    held.iter().any(|&k| {
        let axes = [&mobilizer.parent, &mobilizer.child].map(|side| side.axes[k]);
        let cosine = resolver.graph.dot(axes[0], axes[1]);
        resolver.at_home(cosine, guesses) < 0.0
    })
}

/// How far the partners of a joint are from where it holds them.
struct Disagreement {
    name: String,
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
        element: &JointEntry,
        kind: String,
        points: [&Point; 2],
        guesses: &Guesses,
    ) -> Self {
        let homes = points.map(|point| {
            let home = resolver.home_of(point);
            home.map(|x| resolver.by_default(x))
        });
        let rows = &element.joint.conditions;
        let size_of = |resolver: &mut Resolver, dimension: Dimension| {
            let rows = rows.iter().filter(|row| row.dimension == Some(dimension));
            let squares = rows.map(|row| resolver.at_home(row.expr, guesses).powi(2));
            squares.sum::<f64>().sqrt()
        };
        Disagreement {
            name: element.name.clone(),
            span: element.span,
            kind,
            labels: points.map(|point| point.label.clone()),
            homes,
            gap: size_of(resolver, Dimension::LENGTH),
            angle: size_of(resolver, Dimension::NONE).min(1.0).asin(),
            coincident: element.joint.coincident.is_some(),
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
