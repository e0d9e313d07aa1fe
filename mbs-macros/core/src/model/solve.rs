//! Finds the rows that can be solved for a coordinate.
//!
//! Rows are solved in rounds: once an angle is held, a row with its sine may have become affine, too. Rows that change with
//! time or inputs stay, and so do rows in which something is redundant or contradictory: those are reported, and share
//! their load by least norm.

use super::defaults::{self, ROUNDING, Sampled};
use super::elements::JointEntry;
use super::elements::joint::Level;
use super::initial_pose::Guesses;
use super::quantities::Quantity;
use super::reduction::Reduction;
use super::resolver::Resolver;
use super::sizes::Sizes;
use super::solved::{Solved, SolvedCoordinate, combination, describe, local_symbols};
use crate::symbolic::{
    Affine, AffineReader, Elimination, Expr, Graph, Substitution, Symbol, eliminate,
};
use std::collections::BTreeSet;

/// Conditions for the elimination.
pub(super) struct Conditions<'a> {
    /// Joints whose rows stay.
    pub keep: &'a [String],
    /// Where the motion would start without solved rows.
    pub guesses: &'a Guesses,
    /// How large the coordinates are there.
    pub sizes: &'a Sizes,
    /// Whether M may vary: then a guess that contradicts a row is left to assembly, and the row stays.
    pub varying: bool,
    /// The number of coordinates.
    pub free: usize,
}

/// A row of a joint in terms of local coordinates that stand for all that are joined to them.
struct Row<'a> {
    joint: &'a str,
    slot: usize,
    expr: Expr,
    level: Level,
}

/// Rows that are affine, with their indices.
type Rows = Vec<(usize, Affine)>;

/// Solves the rows of `joints`; `merged`: the local coordinates that stand for others.
pub(super) fn solve(
    resolver: &mut Resolver,
    joints: &[JointEntry],
    reduction: &mut Reduction,
    mut merged: Substitution,
    conditions: Conditions,
) -> Solved {
    let rows = rows(&mut resolver.graph, joints, reduction, &mut merged);
    let keeps = |row: &Row| conditions.keep.iter().any(|joint| joint == row.joint);
    let mut stay: BTreeSet<usize> = (0..rows.len()).filter(|&row| keeps(&rows[row])).collect();
    let elimination = loop {
        match eliminated(resolver, &rows, &stay, &conditions) {
            Ok(elimination) => break elimination,
            Err(more) => stay.extend(more),
        }
    };
    let mut solved = Solved {
        merged,
        ..Solved::default()
    };
    for &(row, unknown) in &elimination.pivots {
        let Row { joint, slot, .. } = rows[row];
        solved.rows.push((joint.to_owned(), slot));
        if let (Symbol::LocalPosition(local), Some(value)) =
            (unknown, elimination.values.get(&unknown))
        {
            let gap = gap(resolver, &conditions, &elimination, unknown);
            let zero = resolver.graph.zero();
            let pivots = elimination.pivots.iter();
            let answers = pivots.map(|&(row, _)| {
                let residual = Symbol::Multiplier(row as u32);
                value.terms.get(&residual).copied().unwrap_or(zero)
            });
            let answers = answers.collect();
            let mut value = value.clone();
            value.terms.retain(|symbol, _| symbol.is_local_position());
            solved.coordinates.push(SolvedCoordinate {
                local,
                value,
                answers,
                gap,
            });
        }
    }
    describe(resolver, joints, &solved, &mut reduction.sentences);
    solved
}

/// The rows of all joints that have any left.
fn rows<'a>(
    graph: &mut Graph,
    joints: &'a [JointEntry],
    reduction: &Reduction,
    merged: &mut Substitution,
) -> Vec<Row<'a>> {
    let mut rows = Vec::new();
    for element in joints {
        if reduction.dissolved(&element.name) {
            continue;
        }
        for (slot, row) in element.joint.conditions.iter().enumerate() {
            rows.push(Row {
                joint: &element.name,
                slot,
                expr: graph.substitute(row.expr, merged),
                level: row.level,
            });
        }
    }
    rows
}

/// All rows but those that `stay`, solved as far as they go; or further rows that must not be eliminated.
fn eliminated(
    resolver: &mut Resolver,
    rows: &[Row],
    stay: &BTreeSet<usize>,
    conditions: &Conditions,
) -> Result<Elimination, BTreeSet<usize>> {
    let mut reader = AffineReader::default();
    let mut systems = Rows::new();
    let mut elimination = Elimination::default();
    loop {
        let mut more = Rows::new();
        for (index, row) in rows.iter().enumerate() {
            let known = systems.iter().any(|(known, _)| *known == index);
            if !known && !stay.contains(&index) && row.level == Level::Position {
                let affine = affine(&mut resolver.graph, &mut reader, row.expr, &elimination);
                more.extend(affine.map(|affine| (index, affine)));
            }
        }
        if more.is_empty() {
            return Ok(elimination);
        }
        systems.extend(more);
        let parameters = &resolver.parameters;
        let size = size(&resolver.graph, parameters, &systems);
        let rounding = size.map(|size| ROUNDING * size);
        elimination = eliminate(&mut resolver.graph, &systems, |graph, expr| {
            defaults::vanishes(graph, parameters, expr, rounding)
        });
        let stay = refused(resolver, rows, &elimination, conditions);
        if !stay.is_empty() {
            return Err(stay);
        }
    }
}

/// A row as an affine one, where it is such with the values of unknowns in their places: with its residual if those
/// values have residuals.
fn affine(
    graph: &mut Graph,
    reader: &mut AffineReader,
    expr: Expr,
    elimination: &Elimination,
) -> Option<Affine> {
    let (mut values, touched) = values(graph, expr, elimination);
    let rest = graph.substitute(expr, &mut values);
    let mut affine = reader.read(graph, rest).filter(Affine::has_unknowns)?;
    for unknown in touched {
        let slope = graph.derivative(expr, unknown);
        let slope = graph.substitute(slope, &mut values);
        if let Some(value) = elimination.values.get(&unknown) {
            let mut residuals = value.clone();
            residuals.constant = graph.zero();
            residuals
                .terms
                .retain(|symbol, _| !symbol.is_local_position());
            affine.add(graph, slope, &residuals);
        }
    }
    Some(affine)
}

/// The values of the unknowns, and of their rates, in an expression; and these unknowns.
fn values(
    graph: &mut Graph,
    expr: Expr,
    elimination: &Elimination,
) -> (Substitution, BTreeSet<Symbol>) {
    let mut values = Substitution::default();
    let mut touched = BTreeSet::new();
    for symbol in graph.symbols([expr]) {
        let (Symbol::LocalPosition(local) | Symbol::LocalVelocity(local)) = symbol else {
            continue;
        };
        let unknown = Symbol::LocalPosition(local);
        if let Some(value) = elimination.values.get(&unknown) {
            let [place, speed, _] = combination(graph, value, local_symbols);
            let value = if symbol == unknown { place } else { speed };
            values.insert(symbol, value);
            touched.insert(unknown);
        }
    }
    (values, touched)
}

/// The largest coefficient.
fn size(graph: &Graph, parameters: &[Quantity], rows: &[(usize, Affine)]) -> Sampled {
    let terms = rows.iter().flat_map(|(_, row)| &row.terms);
    let unknowns = terms.filter(|(symbol, _)| symbol.is_local_position());
    let coefficients: Vec<Expr> = unknowns.map(|(_, &coefficient)| coefficient).collect();
    defaults::largest(graph, parameters, &coefficients)
}

/// The rows that must not be eliminated: rows that depend on each other; rows whose elimination would leave another row
/// without coordinates; and all rows, if nothing could move.
fn refused(
    resolver: &mut Resolver,
    rows: &[Row],
    elimination: &Elimination,
    conditions: &Conditions,
) -> BTreeSet<usize> {
    let taken: BTreeSet<usize> = elimination.pivots.iter().map(|&(row, _)| row).collect();
    if taken.len() == conditions.free {
        return taken;
    }
    let mut refused: BTreeSet<usize> = elimination.dependent.iter().flatten().copied().collect();
    for (index, row) in rows.iter().enumerate() {
        if taken.contains(&index) {
            continue;
        }
        let graph = &mut resolver.graph;
        let (mut values, touched) = values(graph, row.expr, elimination);
        let rest = graph.substitute(row.expr, &mut values);
        let moves = graph.depends_on(rest, |symbol| {
            symbol.is_local_position() || symbol.is_velocity()
        });
        if !moves {
            let values = touched.iter().filter_map(|s| elimination.values.get(s));
            refused.extend(values.flat_map(Affine::residuals));
        }
    }
    if conditions.varying {
        for &(row, unknown) in &elimination.pivots {
            let gap = gap(resolver, conditions, elimination, unknown);
            if gap.iter().any(|&gap| !resolver.graph.is_zero(gap)) {
                refused.insert(row);
            }
        }
    }
    refused
}

/// By how much the guesses of position and velocity of an unknown exceed those that follow; zero except for rounding is
/// zero.
fn gap(
    resolver: &mut Resolver,
    conditions: &Conditions,
    elimination: &Elimination,
    unknown: Symbol,
) -> [Expr; 2] {
    let graph = &mut resolver.graph;
    let zero = graph.zero();
    let (Symbol::LocalPosition(local), Some(value)) = (unknown, elimination.values.get(&unknown))
    else {
        return [zero; 2];
    };
    let [position, velocity, _] = combination(graph, value, local_symbols);
    let mut guesses = Substitution::default();
    for other in value.terms.keys() {
        if let Symbol::LocalPosition(other) = *other {
            let position = conditions.guesses.position(other, graph);
            let velocity = conditions.guesses.velocity(other, graph);
            guesses.insert(Symbol::LocalPosition(other), position);
            guesses.insert(Symbol::LocalVelocity(other), velocity);
        }
    }
    let own = [
        conditions.guesses.position(local, graph),
        conditions.guesses.velocity(local, graph),
    ];
    let follows = [position, velocity].map(|expr| graph.substitute(expr, &mut guesses));
    let gaps = [0, 1].map(|k| graph.sub(own[k], follows[k]));
    let size = conditions.sizes.of(&resolver.locals[local as usize].unit);
    let [place, speed] = gaps;
    [
        resolver.settled(place, size.positions),
        resolver.settled(speed, size.rates),
    ]
}
