//! The reduction: points that a revolute joins become one, and points joined to the ground become constants.

use super::coordinates::Merged;
use super::elements::JointEntry;
use super::geometry::{Owner, Point, Vector, mergeable};
use super::initial_pose::Guesses;
use super::parts::Representation;
use super::reduction::{MergedJoint, Reduction};
use super::resolver::Resolver;
use super::sizes::Sizes;
use super::solve::{self, Conditions};
use super::solved::Solved;
use super::tree::Tree;
use crate::symbolic::{Map, Substitution};
use std::collections::BTreeMap;

/// A set of joined points: ends of parts, and at most one place of the ground.
#[derive(Default)]
struct Cluster {
    ends: Vec<u32>,
    ground: Option<Vector>,
    joints: Vec<usize>,
}

/// Merges what revolutes between free points join, and solves rows but those of the joints in `keep`.
pub(super) fn reduce(
    resolver: &mut Resolver,
    joints: &[JointEntry],
    tree: &Tree,
    keep: &[String],
    (guesses, sizes): (&Guesses, &Sizes),
) -> Option<Reduction> {
    let mut clusters = Clusters::default();
    for (index, element) in joints.iter().enumerate() {
        let Some([parent, child]) = &element.joint.merges else {
            continue;
        };
        if !mergeable(parent) || !mergeable(child) {
            continue;
        }
        if parent.owner == Owner::Ground && child.owner == Owner::Ground {
            resolver.fail_about(
                &element.name,
                element.span,
                "this joint joins the ground with itself; remove it",
            );
            continue;
        }
        if let Err(message) = clusters.join(parent, child, index, joints) {
            resolver.fail_about(&element.name, element.span, message);
        }
    }
    if !resolver.errors.is_empty() {
        return None;
    }
    let mut reduction = Reduction {
        substitution: Substitution::default(),
        merged: Vec::new(),
        sentences: Vec::new(),
        twists: Vec::new(),
        solved: Solved::default(),
        unwrapped_angles: Vec::new(),
        dissolved: tree
            .joints
            .iter()
            .map(|joint| joint.joint.clone())
            .collect(),
        kept: Vec::new(),
    };
    let mut leaders: BTreeMap<u32, u32> = BTreeMap::new();
    let mut fixed: BTreeMap<u32, Vector> = BTreeMap::new();
    for cluster in &clusters.list {
        // After two clusters are joined one of them is empty.
        let Some(&leader) = cluster.ends.iter().min() else {
            continue;
        };
        for &end in &cluster.ends {
            match cluster.ground {
                Some(place) => fixed.extend([(end, place)]),
                None => leaders.extend([(end, leader)]),
            }
        }
        describe(resolver, cluster, leader, joints, &mut reduction.sentences);
        for &joint in &cluster.joints {
            reduction.dissolved.insert(joints[joint].name.clone());
            reduction.merged.push(sides(cluster, joint, joints));
        }
    }
    let merged = Merged {
        leaders: &leaders,
        fixed: &fixed,
        tree,
        joints,
    };
    let (mut by_leaders, free) = merged.by_leaders(resolver);
    resolver.name_variables(tree, &mut by_leaders);
    let mut parts = resolver.parts.iter();
    let follows = parts.any(|part| part.representation == Representation::Prescribed);
    let conditions = Conditions {
        keep,
        guesses,
        sizes,
        varying: !tree.joints.is_empty() || follows,
        free,
    };
    reduction.solved = solve::solve(resolver, joints, &mut reduction, by_leaders, conditions);
    merged.by_coordinates(resolver, &mut reduction);
    resolver.name_variables(tree, &mut reduction.substitution);
    Some(reduction)
}

#[derive(Default)]
struct Clusters {
    list: Vec<Cluster>,
    /// The cluster of each end.
    of_end: Map<u32, usize>,
    /// The cluster of each place of the ground.
    of_place: Map<Vector, usize>,
}

impl Clusters {
    fn find(&mut self, point: &Point) -> usize {
        let next = self.list.len();
        let index = match point.free {
            Some(end) => *self.of_end.entry(end).or_insert(next),
            None => *self.of_place.entry(point.position).or_insert(next),
        };
        if index == next {
            let mut cluster = Cluster::default();
            match point.free {
                Some(end) => cluster.ends.push(end),
                None => cluster.ground = Some(point.position),
            }
            self.list.push(cluster);
        }
        index
    }

    fn join(
        &mut self,
        parent: &Point,
        child: &Point,
        joint: usize,
        joints: &[JointEntry],
    ) -> Result<(), String> {
        let (a, b) = (self.find(parent), self.find(child));
        if a == b {
            let others: Vec<_> = self.list[a]
                .joints
                .iter()
                .map(|&index| format!("`{}`", joints[index].name))
                .collect();
            return Err(format!(
                "`{}` and `{}` are joined already by {}; remove this joint",
                parent.label,
                child.label,
                others.join(" and ")
            ));
        }
        if self.list[a].ground.is_some() && self.list[b].ground.is_some() {
            return Err(format!(
                "`{}` and `{}` are both held by the ground, at different places: this joint cannot close; move one of the points, or remove the joint",
                parent.label, child.label
            ));
        }
        let moved = std::mem::take(&mut self.list[b]);
        for &end in &moved.ends {
            self.of_end.insert(end, a);
        }
        if let Some(place) = moved.ground {
            self.of_place.insert(place, a);
        }
        let cluster = &mut self.list[a];
        cluster.ends.extend(moved.ends);
        cluster.joints.extend(moved.joints);
        cluster.joints.push(joint);
        cluster.ground = cluster.ground.or(moved.ground);
        Ok(())
    }
}

fn describe(
    resolver: &Resolver,
    cluster: &Cluster,
    leader: u32,
    joints: &[JointEntry],
    sentences: &mut Vec<String>,
) {
    if cluster.joints.is_empty() {
        return;
    }
    let point = |end: u32| {
        let name = &resolver.locals[end as usize].name;
        name.trim_end_matches(".x").to_owned()
    };
    let names: Vec<_> = cluster
        .joints
        .iter()
        .map(|&joint| format!("`{}`", joints[joint].name))
        .collect();
    let ends: Vec<_> = cluster.ends.iter().map(|&end| point(end)).collect();
    sentences.push(match cluster.ground {
        Some(_) => format!(
            "{}: {} held by the ground, {} coordinates and as many rows saved",
            names.join(", "),
            ends.join(", "),
            resolver.world.dimension() * ends.len()
        ),
        None => format!(
            "{}: {} are one point (`{}`), {} coordinates and as many rows saved",
            names.join(", "),
            ends.join(", "),
            point(leader),
            resolver.world.dimension() * (ends.len() - 1)
        ),
    });
}

/// Which ends are on the child's side of a joint: the joints of a cluster form a tree over its members.
fn sides(cluster: &Cluster, joint: usize, joints: &[JointEntry]) -> MergedJoint {
    let pair = |index: usize| {
        joints[index]
            .joint
            .merges
            .as_ref()
            .map(|[parent, child]| (parent.free, child.free))
    };
    let reach = |start: Option<u32>| -> Vec<u32> {
        let mut members = vec![start];
        let mut grown = true;
        while grown {
            grown = false;
            for &other in cluster.joints.iter().filter(|&&other| other != joint) {
                let Some((a, b)) = pair(other) else { continue };
                for (from, to) in [(a, b), (b, a)] {
                    if members.contains(&from) && !members.contains(&to) {
                        members.push(to);
                        grown = true;
                    }
                }
            }
        }
        if members.contains(&None) {
            Vec::new()
        } else {
            members.into_iter().flatten().collect()
        }
    };
    let (parent, child) = pair(joint).unwrap_or_default();
    MergedJoint {
        joint: joints[joint].name.clone(),
        child: reach(child),
        parent: reach(parent),
    }
}
