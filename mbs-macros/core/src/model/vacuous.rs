//! Rows that do not depend on the motion.
//!
//! In joint coordinates a row of a cut joint may be satisfied by the tree in every pose: the second hinge of a door,
//! the rows across the plane of a loop that is planar. Such a row is zero in every pose, whatever the parameters, and
//! is left out. This is tested numerically, because rounding in the axes can give 1e-17 instead of an exact zero. A row
//! that no motion changes and that is not zero, or only for some values of the parameters, is an error.

use super::defaults::Near;
use super::elements::JointEntry;
use super::reduction::Reduction;
use super::resolver::Resolver;
use super::tree::Tree;
use crate::dimension::Dimension;
use crate::symbolic::{Evaluator, Expr, Symbol, rotation_entry};
use std::collections::BTreeSet;

/// Poses at which a row has to vanish, with the default parameters and then with others.
const POSES: u32 = 3;
/// A row below this fraction of its scale vanishes.
const VANISHES: f64 = 1e-12;

/// A row that is left out: its entry, and its place among the rows of the entry.
pub type VacuousPlace = (String, usize);

/// A row in generalized coordinates.
struct Candidate {
    element: usize,
    slot: usize,
    expr: Expr,
    dimension: Option<Dimension>,
}

/// The rows to leave out; another row that does not depend on the motion is an error.
pub(super) fn rows(
    resolver: &mut Resolver,
    joints: &[JointEntry],
    tree: &Tree,
    reduction: &mut Reduction,
) -> BTreeSet<VacuousPlace> {
    let mut candidates = Vec::new();
    for (element, joint) in joints.iter().enumerate() {
        if reduction.dissolved(&joint.name) {
            continue;
        }
        for (slot, row) in joint.joint.conditions.iter().enumerate() {
            if reduction.solved.position(&joint.name, slot).is_some() {
                continue;
            }
            let expr = resolver
                .graph
                .substitute(row.expr, &mut reduction.substitution);
            candidates.push(Candidate {
                element,
                slot,
                expr,
                dimension: row.dimension,
            });
        }
    }
    let [by_default, otherwise] = match tree.joints.is_empty() {
        true => [vec![false; candidates.len()], vec![false; candidates.len()]],
        false => {
            [false, true].map(|varied| vanishing(resolver, joints, reduction, &candidates, varied))
        }
    };
    let mut vacuous = BTreeSet::new();
    let mut stuck = BTreeSet::new();
    for (candidate, (by_default, otherwise)) in
        candidates.iter().zip(by_default.into_iter().zip(otherwise))
    {
        let moves = resolver.graph.depends_on(candidate.expr, |symbol| {
            symbol.is_configuration() || matches!(symbol, Symbol::Velocity(_))
        });
        if by_default && otherwise {
            vacuous.insert((joints[candidate.element].name.clone(), candidate.slot));
        } else if by_default || !moves {
            stuck.insert(candidate.element);
        }
    }
    for element in stuck {
        let JointEntry { name, span, .. } = &joints[element];
        let message = stuck_message(resolver, name, tree);
        resolver.fail_about(name, *span, message);
    }
    vacuous
}

/// Which rows vanish in a few poses that have nothing to do with each other, with default or varied parameters.
fn vanishing(
    resolver: &mut Resolver,
    joints: &[JointEntry],
    reduction: &mut Reduction,
    candidates: &[Candidate],
    varied: bool,
) -> Vec<bool> {
    // The positions of a joint give the scale of its rows.
    let mut places = vec![Vec::new(); joints.len()];
    for candidate in candidates {
        let points = &joints[candidate.element].joint.points;
        let positions = points.iter().flat_map(|point| point.position);
        places[candidate.element] = positions
            .map(|x| resolver.graph.substitute(x, &mut reduction.substitution))
            .collect();
    }
    // Conditions on positions have no points.
    let [length, ..] = resolver.largest_length(joints);
    let length = if length > 0.0 { length } else { 1.0 };
    let near = [&resolver.parameters, &resolver.inputs].map(|quantities| Near::new(quantities));
    let mut vanishing = vec![true; candidates.len()];
    for pose in 0..POSES {
        let symbols = |symbol| sample(symbol, &near, pose, varied);
        let laws = |_, arguments: &[f64]| (f64::NAN, vec![f64::NAN; arguments.len()]);
        let mut evaluator = Evaluator::new(&resolver.graph, &symbols, &laws);
        for (candidate, vanishes) in candidates.iter().zip(&mut vanishing) {
            let value = evaluator.value(candidate.expr);
            let places = places[candidate.element].iter();
            let reach = places.fold(0.0f64, |reach, &x| reach.max(evaluator.value(x).abs()));
            let reach = if reach > 0.0 { reach } else { length };
            let scale = match candidate.dimension {
                Some(Dimension::LENGTH) => reach,
                Some(area) if area == Dimension::LENGTH.power(2) => reach * reach,
                _ => 1.0,
            };
            // Written so that NaN does not vanish.
            *vanishes &= value.abs() <= VANISHES * scale;
        }
    }
    vanishing
}

/// A value for each symbol of a pose; parameters and inputs are near their defaults at most.
fn sample(symbol: Symbol, [parameters, inputs]: &[Near; 2], pose: u32, varied: bool) -> f64 {
    let sample = if varied { pose as usize + 1 } else { 0 };
    match symbol {
        Symbol::Parameter(i) => parameters.value(i as usize, sample),
        Symbol::Input(i) => inputs.value(i as usize, sample),
        other => scattered_motion(other, pose),
    }
}

/// A number in (−1, 1).
fn scattered(pose: u32, index: u32, salt: f64) -> f64 {
    let x = f64::from(index + 1) * 0.754_877_666_246_693 + f64::from(pose) * 0.569_840_290_998;
    2.0 * (x + salt).fract() - 1.0
}

/// A value for time and each symbol of the motion, in a pose of this number.
pub(crate) fn scattered_motion(symbol: Symbol, pose: u32) -> f64 {
    match symbol {
        Symbol::Time => 0.17 * f64::from(pose + 1),
        Symbol::Coordinate(i) | Symbol::UnwrappedAngle(i) => scattered(pose, i, 0.0),
        Symbol::Velocity(i) => scattered(pose, i, 0.5),
        Symbol::Rotation(first, entry) => {
            let quaternion = [0.1, 0.4, 0.6, 0.8].map(|salt| scattered(pose, first, salt));
            let length = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
            rotation_entry(quaternion.map(|x| x / length), entry)
        }
        _ => f64::NAN,
    }
}

fn stuck_message(resolver: &Resolver, name: &str, tree: &Tree) -> String {
    if resolver.parts.iter().any(|part| part.name == *name) {
        format!(
            "both ends of `{name}` are held by the ground, so that it cannot move: release one end, or remove the bar"
        )
    } else if tree.joints.is_empty() {
        format!(
            "other joints already fix all that `{name}` holds: no motion could fulfil or break it; remove it"
        )
    } else {
        format!(
            "the joints that are coordinates leave no motion that could fulfil or break what `{name}` holds, and with other parameters or as time passes it would break; describe the mechanism by `coordinates = Reference`, where such a joint is redundant and harmless while it fits, or remove it"
        )
    }
}
