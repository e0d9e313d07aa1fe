//! Which joints carry the parts, and which are cut to close the loops.
//!
//! A loop of joints with f₁, f₂, … freedoms has Σ f − f_cut coordinates and leaves the rows of the joint that is cut:
//! the joint with the most freedoms is the best to cut, and of equals the one that leaves the shortest chains. The
//! search begins with the tree of the shortest chains, and exchanges joints along the loops as long as this is better.
//! Between equally good cuts the count of operations decides.

use super::elements::JointEntry;
use super::formulation::Formulation;
use super::geometry::{Owner, mergeable};
use super::mobilizer::{Freedom, Mobilizer};
use super::parts::{Part, Representation};
use super::resolver::Resolver;
use super::tree::{Tree, TreeJoint, chain};
use std::collections::{BTreeMap, BTreeSet};

/// With more loops the tree of the shortest chains is taken: each exchange would reach all parts once more, and joint
/// coordinates are not what describes so many loops best.
const MOST_LOOPS: usize = 200;
/// Other cuts that are worth a count of operations.
const ALTERNATIVES: usize = 2;

/// The tree without these joints, or the best there is.
pub(super) fn grow(resolver: &mut Resolver, joints: &[JointEntry], cut: Option<&[String]>) -> Tree {
    let spanning = Spanning::new(resolver, joints);
    let all: BTreeSet<usize> = (0..spanning.carriers.len()).collect();
    let name = |index: &usize| spanning.carriers[*index].name.clone();
    let (found, alternatives) = match cut {
        Some(cut) => {
            let kept = all.iter().filter(|index| !cut.contains(&name(index)));
            (spanning.reach(&kept.copied().collect()), Vec::new())
        }
        None => spanning.best(&all),
    };
    let beside =
        |found: &Found| -> Vec<String> { all.difference(&found.carriers).map(name).collect() };
    let mut tree = Tree {
        cut: beside(&found),
        alternatives: alternatives.iter().map(beside).collect(),
        joints: found.joints,
    };
    for joint in &mut tree.joints {
        resolver.name_coordinates(joint);
    }
    tree
}

/// A joint that can carry a part.
struct Carrier {
    name: String,
    mobilizer: Mobilizer,
    /// Rows that it would leave.
    rows: usize,
}

/// The joints that can carry a part, and the parts.
struct Spanning {
    carriers: Vec<Carrier>,
    parts: Vec<Carried>,
}

/// Properties of a part for the search.
struct Carried {
    /// Joints have merged its points, or it is a coordinate by itself.
    settled: bool,
    /// Its pose is known, so that it can carry other parts.
    has_frame: bool,
    /// A joint can carry it.
    by_any: bool,
    /// A joint that fixes its point alone can carry it.
    by_points: bool,
}

/// A tree.
struct Found {
    joints: Vec<TreeJoint>,
    /// Indices of its joints.
    carriers: BTreeSet<usize>,
    /// Its rows, which it saves, negated; then the lengths of its chains.
    weight: (isize, usize),
}

impl Spanning {
    fn new(resolver: &mut Resolver, joints: &[JointEntry]) -> Spanning {
        // Points that joints merge are reached already.
        let merged: BTreeSet<Owner> = joints
            .iter()
            .filter_map(|element| element.joint.merges.as_ref())
            .filter(|points| points.iter().all(mergeable))
            .flat_map(|[parent, child]| [parent.owner, child.owner])
            .collect();
        let parts = resolver.parts.iter().enumerate().map(|(index, part)| {
            let joint = part.formulation.unwrap_or(resolver.formulation) == Formulation::Joint;
            Carried {
                settled: merged.contains(&Owner::Part(index)) || part.representation.is_number(),
                has_frame: has_frame(part),
                by_any: joint && has_frame(part),
                by_points: joint && part.representation == Representation::FreePoint,
            }
        });
        let parts: Vec<Carried> = parts.collect();
        let mut carriers = Vec::new();
        if parts.iter().any(|part| part.by_any || part.by_points) {
            for element in joints {
                if let Some(mobilizer) = &element.joint.mobilizer {
                    carriers.push(Carrier {
                        name: element.name.clone(),
                        rows: element.joint.conditions.len(),
                        mobilizer: mobilizer.clone(),
                    });
                }
            }
        }
        Spanning { carriers, parts }
    }

    /// The tree whose cut joints leave the fewest rows, with the shortest chains; and others that are as good.
    fn best(&self, all: &BTreeSet<usize>) -> (Found, Vec<Found>) {
        let mut best = self.reach(all);
        loop {
            let others = self.exchanges(&best, all);
            // The first of the best.
            let better = others
                .iter()
                .enumerate()
                .min_by_key(|(_, other)| other.weight);
            match better {
                Some((place, other)) if other.weight < best.weight => {
                    best = { others }.swap_remove(place);
                }
                _ => {
                    let mut equal: Vec<Found> = Vec::new();
                    for other in others {
                        let known = equal.iter().any(|known| known.carriers == other.carriers);
                        if other.weight == best.weight && !known && equal.len() < ALTERNATIVES {
                            equal.push(other);
                        }
                    }
                    return (best, equal);
                }
            }
        }
    }

    /// The trees that differ by one joint: where a joint closes a loop, another of the loop can.
    fn exchanges(&self, tree: &Found, all: &BTreeSet<usize>) -> Vec<Found> {
        let mut trees = Vec::new();
        if all.len() - tree.carriers.len() > MOST_LOOPS {
            return trees;
        }
        for &closing in all.difference(&tree.carriers) {
            let mobilizer = &self.carriers[closing].mobilizer;
            let [near, far] = [&mobilizer.parent, &mobilizer.child]
                .map(|end| chain(&tree.joints, end.point.owner.part()));
            for &place in near.symmetric_difference(&far) {
                let mut carriers = tree.carriers.clone();
                carriers.remove(&self.index(&tree.joints[place].joint));
                carriers.insert(closing);
                let found = self.reach(&carriers);
                if found.joints.len() == tree.joints.len() {
                    trees.push(found);
                }
            }
        }
        trees
    }

    /// Reaches each part as early as possible by these joints; of several that reach one, the one of most rows does.
    fn reach(&self, allowed: &BTreeSet<usize>) -> Found {
        let mut found = Found {
            joints: Vec::new(),
            carriers: BTreeSet::new(),
            weight: (0, 0),
        };
        let mut reached: Vec<bool> = self.parts.iter().map(|part| part.settled).collect();
        let mut meeting: BTreeMap<Owner, Vec<(usize, bool)>> = BTreeMap::new();
        for &index in allowed {
            for forwards in [true, false] {
                let (parent, _) = ends(&self.carriers[index].mobilizer, forwards);
                meeting.entry(parent).or_default().push((index, forwards));
            }
        }
        let mut front = vec![Owner::Ground];
        let mut depth = 0;
        loop {
            depth += 1;
            let mut next: BTreeMap<usize, (usize, bool)> = BTreeMap::new();
            let mut joints: Vec<(usize, bool)> = front
                .iter()
                .filter_map(|parent| meeting.get(parent))
                .flatten()
                .copied()
                .collect();
            joints.sort_unstable_by_key(|&(index, forwards)| (index, !forwards));
            for (index, forwards) in joints {
                let Carrier {
                    mobilizer, rows, ..
                } = &self.carriers[index];
                let (parent, child) = ends(mobilizer, forwards);
                let Owner::Part(child) = child else { continue };
                let known = next.get(&child);
                if !reached[child]
                    && self.carries(parent, child, mobilizer)
                    && known.is_none_or(|&(best, _)| self.carriers[best].rows < *rows)
                {
                    next.insert(child, (index, forwards));
                }
            }
            // What follows coordinates declared by hand can carry parts, too.
            if next.is_empty() {
                let free = (0..self.parts.len())
                    .find(|&part| !reached[part] && !front.contains(&Owner::Part(part)));
                let Some(free) = free else { return found };
                // Nothing carries it: it is free, and a root of its own.
                reached[free] = true;
                front = vec![Owner::Part(free)];
                depth = 0;
                continue;
            }
            front = next.keys().map(|&child| Owner::Part(child)).collect();
            for (child, (index, forwards)) in next {
                reached[child] = true;
                found.weight.0 -= self.carriers[index].rows as isize;
                found.weight.1 += depth;
                found.carriers.insert(index);
                found
                    .joints
                    .push(self.carriers[index].joint(forwards, child));
            }
        }
    }

    /// Whether a joint can carry a part: a body that it holds, or a particle whose place is all there is to it.
    fn carries(&self, parent: Owner, child: usize, mobilizer: &Mobilizer) -> bool {
        let from = match parent {
            Owner::Ground => true,
            Owner::Part(part) => self.parts[part].has_frame,
        };
        let child = &self.parts[child];
        from && (child.by_any || (child.by_points && mobilizer.frees_rotation()))
    }

    fn index(&self, name: &str) -> usize {
        let mut carriers = self.carriers.iter();
        carriers
            .position(|carrier| carrier.name == name)
            .unwrap_or(0)
    }
}

impl Carrier {
    fn joint(&self, forwards: bool, child: usize) -> TreeJoint {
        let (parent, _) = ends(&self.mobilizer, forwards);
        TreeJoint {
            joint: self.name.clone(),
            parent: parent.part(),
            child,
            mobilizer: match forwards {
                true => self.mobilizer.clone(),
                false => self.mobilizer.reversed(),
            },
            coordinates: Vec::new(),
        }
    }
}

fn ends(mobilizer: &Mobilizer, forwards: bool) -> (Owner, Owner) {
    let (parent, child) = (mobilizer.parent.point.owner, mobilizer.child.point.owner);
    match forwards {
        true => (parent, child),
        false => (child, parent),
    }
}

fn has_frame(part: &Part) -> bool {
    matches!(
        part.representation,
        Representation::Rigid | Representation::Reference
    )
}

impl Resolver<'_> {
    /// Makes the coordinates that a joint of the tree brings: angles first.
    fn name_coordinates(&mut self, joint: &mut TreeJoint) {
        let freedoms = joint.mobilizer.freedoms.clone();
        joint.coordinates = vec![None; freedoms.len()];
        let slides = freedoms.iter().filter(|freedom| !freedom.turns()).count();
        for turns in [true, false] {
            let count = freedoms.iter().filter(|freedom| freedom.turns()).count();
            let mut angles = ["angle", "second_angle", "third_angle"][..count.min(3)].to_vec();
            if !joint.mobilizer.forwards {
                // The turns have the reverse order, too.
                angles.reverse();
            }
            let mut angles = angles.into_iter();
            for (freedom, coordinate) in freedoms.iter().zip(&mut joint.coordinates) {
                if freedom.turns() != turns {
                    continue;
                }
                let (suffix, unit) = match freedom {
                    Freedom::Rotation => continue,
                    Freedom::Turn(_) | Freedom::Helix(_) => {
                        (angles.next().unwrap_or_default(), "rad")
                    }
                    Freedom::Slide(_) if slides == 1 => ("stroke", "m"),
                    Freedom::Slide(axis) => (["stroke_x", "stroke_y", "stroke_z"][*axis], "m"),
                };
                *coordinate = Some(self.local(format!("{}.{suffix}", joint.joint), unit));
            }
        }
    }
}
