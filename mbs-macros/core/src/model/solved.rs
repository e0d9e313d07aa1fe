//! Rows solved away: a holonomic row that is affine in the coordinates, with coefficients that are constant, gives one of
//! them in terms of the others. Both leave the equations, and as velocities follow by the same coefficients, a constant M
//! stays constant.
//!
//! Rows that change with time or inputs stay, and so do rows in which something is redundant or contradictory: those are
//! reported, and their reactions are those of least norm.

use super::elements::JointElement;
use super::home;
use super::reduce::Reduction;
use super::resolve::Resolver;
use crate::equations::joints::Level;
use crate::symbolic::{
    Affine, AffineReader, Elimination, Expr, Graph, Substitution, Symbol, eliminate,
};
use std::collections::BTreeSet;

/// The rows that were solved, with the coordinates that followed from them.
#[derive(Debug, Default)]
pub struct Solved {
    /// Each row: its joint, and its index among the rows of the joint.
    pub rows: Vec<(String, usize)>,
    /// As many coordinates.
    pub coordinates: Vec<SolvedCoordinate>,
    /// Local coordinates in terms of those that stand for a joined point, before rows were solved.
    pub merged: Substitution,
}

/// A coordinate that follows from others.
#[derive(Debug)]
pub struct SolvedCoordinate {
    /// The local coordinate.
    pub local: u32,
    /// Its value in terms of those that remain, and of what the solved rows are off by: [`Symbol::Multiplier`], counted
    /// in their order.
    pub value: Affine,
}

impl Solved {
    /// The index of a row among the solved ones.
    pub fn position(&self, joint: &str, slot: usize) -> Option<usize> {
        let mut rows = self.rows.iter();
        rows.position(|(name, index)| name == joint && *index == slot)
    }

    /// The value of a local coordinate that follows from others.
    pub(super) fn value(&self, local: u32) -> Option<&Affine> {
        let mut coordinates = self.coordinates.iter();
        let solved = coordinates.find(|solved| solved.local == local);
        solved.map(|solved| &solved.value)
    }
}

/// A row of a joint in terms of local coordinates that stand for all that are joined to them.
struct Row<'a> {
    joint: &'a str,
    slot: usize,
    expr: Expr,
    /// Where it may be solved.
    affine: Option<Affine>,
}

/// Finds the rows that can be solved; `free` counts the coordinates before.
pub(super) fn solve(
    resolver: &mut Resolver,
    joints: &[JointElement],
    reduction: &mut Reduction,
    mut merged: Substitution,
    free: usize,
) -> Solved {
    let rows = rows(&mut resolver.graph, joints, reduction, &mut merged);
    let mut candidates: Vec<usize> = (0..rows.len())
        .filter(|&row| rows[row].affine.is_some())
        .collect();
    let mut solved = Solved::default();
    let (elimination, taken) = loop {
        let systems: Vec<Affine> = candidates
            .iter()
            .filter_map(|&row| rows[row].affine.clone())
            .collect();
        let parameters = &resolver.parameters;
        let largest = size(&resolver.graph, parameters, &systems);
        let elimination = eliminate(&mut resolver.graph, &systems, |graph, expr| {
            home::vanishes(graph, parameters, expr, ROUNDING * largest)
        });
        let taken: BTreeSet<usize> = elimination.pivots.iter().map(|p| candidates[p.0]).collect();
        if !candidates.is_empty() && elimination.values.len() == free {
            // What cannot move at all is left to those who say so.
            candidates.clear();
            continue;
        }
        let mut stay: BTreeSet<usize> = elimination
            .dependent
            .iter()
            .flatten()
            .map(|&row| candidates[row])
            .collect();
        for (index, row) in rows.iter().enumerate() {
            if !taken.contains(&index) {
                let needed = stilled(&mut resolver.graph, row.expr, &elimination);
                stay.extend(needed.into_iter().map(|row| candidates[row]));
            }
        }
        if stay.is_empty() {
            break (elimination, candidates);
        }
        candidates.retain(|row| !stay.contains(row));
    };
    let mut order = Vec::new();
    for &(row, _) in &elimination.pivots {
        let Row { joint, slot, .. } = rows[taken[row]];
        order.push(row);
        solved.rows.push((joint.to_owned(), slot));
    }
    for &(_, unknown) in &elimination.pivots {
        let (Symbol::LocalPosition(local), Some(value)) =
            (unknown, elimination.values.get(&unknown))
        else {
            continue;
        };
        // Residuals are counted among the rows that were solved.
        let terms = value.terms.iter().map(|(&symbol, &coefficient)| {
            let counted = match symbol {
                Symbol::Multiplier(row) => {
                    let place = order.iter().position(|&other| other == row as usize);
                    Symbol::Multiplier(place.unwrap_or_default() as u32)
                }
                other => other,
            };
            (counted, coefficient)
        });
        let value = Affine {
            constant: value.constant,
            terms: terms.collect(),
        };
        solved.coordinates.push(SolvedCoordinate { local, value });
    }
    solved.merged = merged;
    describe(resolver, joints, &solved, &mut reduction.sentences);
    solved
}

/// A coefficient below this fraction of the largest is zero but for rounding.
const ROUNDING: f64 = 1e-12;

/// The largest coefficient with default parameters.
fn size(graph: &Graph, parameters: &[super::Quantity], rows: &[Affine]) -> f64 {
    let coefficients = rows.iter().flat_map(|row| row.terms.values());
    coefficients.fold(1.0, |size: f64, &coefficient| {
        size.max(home::by_default(graph, parameters, coefficient).abs())
    })
}

/// The rows of all joints that have any left.
fn rows<'a>(
    graph: &mut Graph,
    joints: &'a [JointElement],
    reduction: &Reduction,
    merged: &mut Substitution,
) -> Vec<Row<'a>> {
    let mut reader = AffineReader::default();
    let mut rows = Vec::new();
    for element in joints {
        if reduction.dissolved(&element.name) {
            continue;
        }
        for (slot, row) in element.joint.equations(graph).rows.iter().enumerate() {
            let expr = graph.substitute(row.expr, merged);
            let affine = match row.level {
                Level::Position => reader.read(graph, expr).filter(Affine::has_unknowns),
                Level::Velocity => None,
            };
            rows.push(Row {
                joint: &element.name,
                slot,
                expr,
                affine,
            });
        }
    }
    rows
}

/// The solved rows without which a row would still depend on something that moves; none, if it does so with them.
fn stilled(graph: &mut Graph, expr: Expr, elimination: &Elimination) -> Vec<usize> {
    let mut values = Substitution::default();
    let mut needed = BTreeSet::new();
    for symbol in graph.symbols([expr]) {
        let position = match symbol {
            Symbol::LocalPosition(local) | Symbol::LocalVelocity(local) => {
                Symbol::LocalPosition(local)
            }
            _ => continue,
        };
        if let Some(value) = elimination.values.get(&position) {
            let [place, speed, _] = combination(graph, value, local_symbols);
            let is_position = symbol == position;
            values.insert(symbol, if is_position { place } else { speed });
            needed.extend(value.residuals());
        }
    }
    let rest = graph.substitute(expr, &mut values);
    let moves = graph.depends_on(rest, |symbol| {
        symbol.is_local_position() || symbol.is_velocity()
    });
    match moves {
        true => Vec::new(),
        false => needed.into_iter().collect(),
    }
}

pub(super) fn local_symbols(local: u32) -> [Symbol; 3] {
    [
        Symbol::LocalPosition(local),
        Symbol::LocalVelocity(local),
        Symbol::LocalAcceleration(local),
    ]
}

/// Position, velocity and acceleration of a coordinate that follows from others, whose symbols `symbols` tells.
pub(super) fn combination(
    graph: &mut Graph,
    value: &Affine,
    symbols: impl Fn(u32) -> [Symbol; 3],
) -> [Expr; 3] {
    let zero = graph.zero();
    let mut sums = [value.constant, zero, zero];
    for (&symbol, &coefficient) in &value.terms {
        if let Symbol::LocalPosition(local) = symbol {
            for (sum, symbol) in sums.iter_mut().zip(symbols(local)) {
                let term = graph.symbol(symbol);
                let term = graph.mul(coefficient, term);
                *sum = graph.add(*sum, term);
            }
        }
    }
    sums
}

/// A sentence for each joint whose rows were solved.
fn describe(
    resolver: &mut Resolver,
    joints: &[JointElement],
    solved: &Solved,
    sentences: &mut Vec<String>,
) {
    for element in joints {
        let pairs = solved.rows.iter().zip(&solved.coordinates);
        let own = pairs.filter(|((joint, _), _)| *joint == element.name);
        let names: Vec<String> = own
            .map(|(_, coordinate)| resolver.locals[coordinate.local as usize].name.clone())
            .collect();
        let all = element.joint.equations(&mut resolver.graph).rows.len();
        let joint = &element.name;
        sentences.push(match (names.as_slice(), all) {
            ([], _) => continue,
            ([one], 1) => {
                format!("`{joint}`: {one} follows from its row, one coordinate and one row saved")
            }
            ([one], _) => format!(
                "`{joint}`: {one} follows from one of its rows, one coordinate and one row saved"
            ),
            (several, _) => format!(
                "`{joint}`: {} follow from its rows, {} coordinates and as many rows saved",
                several.join(", "),
                several.len()
            ),
        });
    }
}
