//! The reduction: points that a revolute joins become one, and points joined to the ground become constants.

use super::coordinates::Merged;
use super::elements::JointElement;
use super::geometry::{Owner, Point, Vector};
use super::parts::Representation;
use super::placement::Guesses;
use super::resolve::Resolver;
use super::solve::{self, Conditions};
use super::solved::Solved;
use super::tree::{Motion, Tree};
use crate::symbolic::{Graph, Substitution, Symbol};
use std::collections::BTreeMap;

/// A joint that left no row: its points were merged.
#[derive(Debug, Clone)]
pub struct MergedJoint {
    /// The joint's name.
    pub joint: String,
    /// The force on the child is what these points need from their surroundings: the first local coordinates of the
    /// ends of parts on the child's side. Empty where the child is the ground; then `parent` is taken with the opposite sign.
    pub child: Vec<u32>,
    /// The same for the parent's side.
    pub parent: Vec<u32>,
}

/// The outcome of the reduction.
pub(super) struct Reduction {
    pub substitution: Substitution,
    pub merged: Vec<MergedJoint>,
    pub sentences: Vec<String>,
    /// Velocities of the parts that the tree carries.
    pub motions: Vec<Motion>,
    /// Rows that were solved, and the coordinates that followed from them.
    pub solved: Solved,
    /// Counted joint angles that need a memory.
    pub unwrapped_angles: Vec<usize>,
    /// Joints of the tree: they left no rows.
    carried: Vec<String>,
    /// Local coordinates that stay, in order: (local, name).
    pub kept: Vec<(u32, String)>,
}

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
    joints: &[JointElement],
    tree: &Tree,
    keep: &[String],
    guesses: &Guesses,
) -> Option<Reduction> {
    let mut clusters = Clusters::default();
    for (index, element) in joints.iter().enumerate() {
        let Some((parent, child)) = element.joint.merges() else {
            continue;
        };
        if !mergeable(parent) || !mergeable(child) {
            continue;
        }
        if parent.owner == Owner::Ground && child.owner == Owner::Ground {
            resolver.fail::<()>(
                element.span,
                "this joint joins the ground with itself; remove it",
            );
            continue;
        }
        if let Err(message) = clusters.join(parent, child, index, joints) {
            resolver.fail::<()>(element.span, message);
        }
    }
    if !resolver.errors.is_empty() {
        return None;
    }
    let mut reduction = Reduction {
        substitution: Substitution::default(),
        merged: Vec::new(),
        sentences: Vec::new(),
        motions: Vec::new(),
        solved: Solved::default(),
        unwrapped_angles: Vec::new(),
        carried: tree
            .joints
            .iter()
            .map(|joint| joint.joint.clone())
            .collect(),
        kept: Vec::new(),
    };
    let mut leaders: BTreeMap<u32, u32> = BTreeMap::new();
    let mut fixed: BTreeMap<u32, Vector> = BTreeMap::new();
    for cluster in &clusters.list {
        // Of joined clusters one is left empty.
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
            reduction.merged.push(sides(cluster, joint, joints));
        }
    }
    let merged = Merged {
        leaders: &leaders,
        fixed: &fixed,
        tree,
    };
    let (mut by_leaders, free) = merged.by_leaders(resolver);
    resolver.name_motions(tree, &mut by_leaders);
    let mut parts = resolver.parts.iter();
    let follows = parts.any(|part| part.representation == Representation::Prescribed);
    let conditions = Conditions {
        keep,
        guesses,
        varying: !tree.joints.is_empty() || follows,
        free,
    };
    reduction.solved = solve::solve(resolver, joints, &mut reduction, by_leaders, conditions);
    merged.by_coordinates(resolver, &mut reduction);
    resolver.name_motions(tree, &mut reduction.substitution);
    Some(reduction)
}

/// A point that is a pair of coordinates, or a place of the ground.
pub(super) fn mergeable(point: &Point) -> bool {
    point.free.is_some() || point.owner == Owner::Ground
}

#[derive(Default)]
struct Clusters {
    list: Vec<Cluster>,
}

impl Clusters {
    fn find(&mut self, point: &Point) -> usize {
        let found = match point.free {
            Some(end) => self
                .list
                .iter()
                .position(|cluster| cluster.ends.contains(&end)),
            None => self
                .list
                .iter()
                .position(|cluster| cluster.ground == Some(point.position)),
        };
        found.unwrap_or_else(|| {
            let mut cluster = Cluster::default();
            match point.free {
                Some(end) => cluster.ends.push(end),
                None => cluster.ground = Some(point.position),
            }
            self.list.push(cluster);
            self.list.len() - 1
        })
    }

    fn join(
        &mut self,
        parent: &Point,
        child: &Point,
        joint: usize,
        joints: &[JointElement],
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
                "`{}` and `{}` are both held by the ground, at different places: this joint cannot close",
                parent.label, child.label
            ));
        }
        let moved = std::mem::take(&mut self.list[b]);
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
    joints: &[JointElement],
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
fn sides(cluster: &Cluster, joint: usize, joints: &[JointElement]) -> MergedJoint {
    let pair = |index: usize| {
        joints[index]
            .joint
            .merges()
            .map(|(parent, child)| (parent.free, child.free))
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

impl Reduction {
    /// Whether a joint left no row.
    pub(super) fn dissolved(&self, joint: &str) -> bool {
        self.merged.iter().any(|merged| merged.joint == joint)
            || self.carried.iter().any(|carried| carried == joint)
    }

    /// The generalized coordinate with which a local one moves; `None` if it is held, or moves with several.
    pub(super) fn coordinate_of(&self, graph: &Graph, local: u32) -> Option<u32> {
        let value = self.substitution.get(Symbol::LocalPosition(local));
        let symbols = graph.symbols(value).into_iter();
        let mut indices = symbols.filter_map(|symbol| match symbol {
            Symbol::Coordinate(index) => Some(index),
            _ => None,
        });
        indices.next().filter(|_| indices.next().is_none())
    }

    /// The local coordinates that stay, with their names.
    pub(super) fn kept(&self) -> &[(u32, String)] {
        &self.kept
    }
}
