//! Whether M is constant.

use crate::model::Layout;
use crate::symbolic::{Expr, Graph, Symbol};
use std::collections::BTreeMap;

/// Whether M does not depend on q. A rotation whose momentum depends on other velocities, too, has no free flight of its
/// own: for the integrator its M is like one that varies.
pub(super) fn constant_mass(
    graph: &Graph,
    layout: &Layout,
    mass: &BTreeMap<(usize, usize), Expr>,
) -> bool {
    let turns = |i: usize| {
        let rotations = layout.rotations.iter();
        let mut firsts = rotations.map(|rotation| rotation.velocity);
        firsts.find(|&first| (first..first + 3).contains(&i))
    };
    let coupled = mass.keys().any(|&(i, j)| turns(i) != turns(j));
    let varies = |&entry: &Expr| graph.depends_on(entry, Symbol::is_configuration);
    !coupled && !mass.values().any(varies)
}
