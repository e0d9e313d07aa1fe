//! The joints whose reactions are not determined: redundant rows can carry forces that cancel each other.

use super::INVOLVED;
use super::numbers::Numbers;
use super::rows::norm;
use crate::equations::{System, VacuousRow};

/// Changes below this fraction of what they are added to are round-off.
const ROUND_OFF: f64 = 1e-13;

/// Multipliers that cancel each other: rows, each with its coefficient relative to its length.
pub(super) type Cancelling = Vec<(usize, f64)>;

/// Joints that share with rows left out.
pub(super) fn with_rows_left_out(system: &System) -> Vec<String> {
    let shares = |joint: &String| {
        let with = |row: &VacuousRow| row.entry == *joint || row.follows_from.contains(joint);
        system.vacuous.iter().any(with)
    };
    if system.vacuous.is_empty() {
        return Vec::new();
    }
    let joints = system.reactions.iter().map(|reaction| &reaction.joint);
    let shared: Vec<String> = joints.filter(|&joint| shares(joint)).cloned().collect();
    in_order(system, &shared)
}

/// The same, and the joints whose reactions such multipliers change at this pose. (In joint coordinates a reaction is
/// what moves all that follows in the tree, where forces between its parts cancel. Therefore numbers decide.)
pub(super) fn undetermined(
    numbers: &Numbers,
    pose: &[f64],
    cancelling: &[Cancelling],
) -> Vec<String> {
    let system = numbers.system;
    let mut joints = with_rows_left_out(system);
    if cancelling.is_empty() {
        return joints;
    }
    let reactions = || system.reactions.iter().map(|reaction| reaction.expr);
    let lengths: Vec<f64> = numbers
        .matrix(&numbers.rows.jacobian, pose, &[])
        .iter()
        .map(|row| norm(row))
        .collect();
    let unloaded = numbers.values_loaded(pose, None, reactions());
    for multipliers in cancelling {
        let (mut sums, mut sizes) = (vec![0.0; unloaded.len()], vec![0.0; unloaded.len()]);
        for &(row, coefficient) in multipliers {
            let load = Some((row, coefficient / lengths[row]));
            let loaded = numbers.values_loaded(pose, load, reactions());
            for (i, (with, without)) in loaded.iter().zip(&unloaded).enumerate() {
                sums[i] += with - without;
                sizes[i] += (with - without).abs();
            }
        }
        // Forces that cancel inside of a sum leave their round-off: torques are compared with forces at the lever of the
        // mechanism.
        let lever = |i: usize| match system.reactions[i].unit.as_str() {
            "N m" => numbers.length,
            _ => 1.0,
        };
        let sizes = sizes.iter().enumerate();
        let most = sizes.map(|(i, size)| size / lever(i)).fold(0.0, f64::max);
        for (i, reaction) in system.reactions.iter().enumerate() {
            let noise = (INVOLVED * most * lever(i)).max(ROUND_OFF * unloaded[i].abs());
            if sums[i].abs() > noise {
                joints.push(reaction.joint.clone());
            }
        }
    }
    in_order(system, &joints)
}

/// Each of these joints once, in the order of the declaration.
fn in_order(system: &System, joints: &[String]) -> Vec<String> {
    let mut order: Vec<String> = Vec::new();
    for reaction in &system.reactions {
        if joints.contains(&reaction.joint) && !order.contains(&reaction.joint) {
            order.push(reaction.joint.clone());
        }
    }
    order
}
