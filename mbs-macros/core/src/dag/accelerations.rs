//! Accelerations and multipliers at an instant, in one straight-line function: what explicit integrators evaluate.
//!
//! ```text
//! M v̇ + ṗ|_v = F + Aᵀλ        ṗ|_v: rate of the momentum at constant v
//! A v̇ + γ + correction = 0
//! S λ = −γ − correction − A M⁻¹ (F − ṗ|_v),   S = A M⁻¹ Aᵀ
//! ```
//!
//! M (where it varies) and S are factored for their pattern, without exchanges. A row that follows from others gets the
//! multiplier zero; v̇ is the same as with any other division of the load. Rows that are redundant at generic poses are
//! known here. Beside a singular pose a row is left out if its pivot is below 1e-12 of its diagonal entry. (The
//! intermediate states of an explicit step violate the rows a little, so that a row that is redundant on the
//! constraints is not exactly redundant there, and its pivot alone is not a test.)

use super::elimination::{Factor, Rank, Sparse, Upper};
use super::kernels::{Rows, delassus, rows};
use super::lower::{Hoisted, Lowering};
use super::{Function, Operand, Place};
use crate::derivatives::Derived;
use crate::equations::InverseMass;
use crate::symbolic::{Expr, Graph, Symbol};

/// Code longer than this costs more to compile than it gains.
const LONGEST: usize = 4000;
/// The same before it is made: eliminations of more rows than this are not tried.
const LARGEST: usize = 16;

/// The function; `None` where it would be long.
pub(super) fn accelerations(
    graph: &mut Graph,
    hoisted: &mut Hoisted,
    derived: &Derived,
    demand: &mut Option<Demand>,
) -> Option<Function> {
    let (size, rows) = (derived.system.size, derived.system.rows.len());
    if size > LARGEST || rows > LARGEST {
        return None;
    }
    let demand = demand.get_or_insert_with(|| Demand::new(graph, derived));
    let mut code = Lowering::new(graph, hoisted);
    if derived.constant_mass {
        with_inverse(&mut code, derived, demand);
    } else {
        with_factor(&mut code, derived, demand);
    }
    let function = code.finish("accelerations");
    (function.operations.len() <= LONGEST).then_some(function)
}

/// F − ṗ|_v, and −γ − correction of each row.
pub(super) struct Demand {
    pub(super) forces: Vec<Expr>,
    pub(super) rows: Vec<Expr>,
}

impl Demand {
    pub(super) fn new(graph: &mut Graph, derived: &Derived) -> Demand {
        let rows = derived
            .convective
            .iter()
            .enumerate()
            .map(|(r, &gamma)| {
                let correction = graph.symbol(Symbol::Correction(r as u32));
                let demand = graph.add(gamma, correction);
                graph.neg(demand)
            })
            .collect();
        Demand {
            forces: derived.free_forces.clone(),
            rows,
        }
    }
}

/// M is constant: its inverse is known, and S comes straight from q.
fn with_inverse(code: &mut Lowering, derived: &Derived, demand: &Demand) {
    let inverse = InverseMass::new(derived.system.size, &derived.system.mass);
    let rows = rows_asked(derived);
    let free = inverse.apply(code.graph(), &demand.forces);
    let upper: Upper = delassus(code.graph(), &inverse, &rows)
        .into_iter()
        .map(|(place, entry)| (place, code.operand(entry)))
        .filter(|(_, entry)| *entry != Operand::number(0.0))
        .collect();
    let mut lambda = Sparse::new();
    for (r, row) in asked(derived, &rows) {
        let graph = code.graph();
        let terms: Vec<Expr> = row.iter().map(|&(j, a)| graph.mul(a, free[j])).collect();
        let met = graph.sum(terms);
        let missing = graph.sub(demand.rows[r], met);
        lambda.insert(r, code.operand(missing));
    }
    solve(code, derived, upper, &mut lambda);
    for (&r, &value) in &lambda {
        let symbol = code.graph().symbol(Symbol::Multiplier(r as u32));
        code.bind(symbol, value);
    }
    let graph = code.graph();
    let mut pushes = vec![Vec::new(); derived.system.size];
    for (r, row) in rows.iter().enumerate() {
        let lambda = graph.symbol(Symbol::Multiplier(r as u32));
        for &(j, a) in row {
            pushes[j].push(graph.mul(a, lambda));
        }
    }
    let pushes: Vec<Expr> = pushes.into_iter().map(|terms| graph.sum(terms)).collect();
    let pushed = inverse.apply(graph, &pushes);
    for (i, (&free, pushed)) in free.iter().zip(pushed).enumerate() {
        let value = code.graph().add(free, pushed);
        code.output("acceleration", Place::Element(i), value);
    }
}

/// M varies: it is factored, too. S = Σ y yᵀ/d with y = L⁻¹Aᵀ.
fn with_factor(code: &mut Lowering, derived: &Derived, demand: &Demand) {
    let (size, rows) = (derived.system.size, rows_asked(derived));
    let mass: Upper = derived
        .system
        .mass
        .iter()
        .map(|(&place, &entry)| (place, code.operand(entry)))
        .collect();
    let mass = Factor::new(code, size, mass, Rank::Full, "inertia");
    let mut free: Sparse = demand
        .forces
        .iter()
        .enumerate()
        .map(|(i, &force)| (i, code.operand(force)))
        .collect();
    mass.forward(code, &mut free);
    // y = L⁻¹ a and z = D⁻¹ y of each row.
    let halves: Vec<[Sparse; 2]> = rows
        .iter()
        .map(|row| {
            let row: Sparse = row.iter().map(|&(j, a)| (j, code.operand(a))).collect();
            mass.halves(code, row)
        })
        .collect();
    let mut upper = Upper::new();
    let mut lambda = Sparse::new();
    for (r, [_, scaled]) in asked(derived, &halves) {
        for (s, [other, _]) in halves.iter().enumerate().skip(r) {
            if let Some(entry) = code.dot(scaled, other) {
                upper.insert((r, s), entry);
            }
        }
        let missing = code.operand(demand.rows[r]);
        let met = code.dot(scaled, &free).unwrap_or(Operand::number(0.0));
        lambda.insert(r, code.less(missing, met));
    }
    solve(code, derived, upper, &mut lambda);
    mass.scale(code, &mut free);
    for (r, [_, scaled]) in halves.iter().enumerate() {
        for (&k, &z) in scaled {
            let push = code.times(z, lambda[&r]);
            let place = free.entry(k).or_insert(Operand::number(0.0));
            *place = code.plus(*place, push);
        }
    }
    mass.backward(code, &mut free);
    for (&i, &value) in &free {
        code.write("acceleration", Place::Element(i), value);
    }
}

/// The rows of A; those that follow from others are empty, so that nothing is computed for them.
fn rows_asked(derived: &Derived) -> Rows {
    let mut rows = rows(derived);
    for &row in &derived.redundant {
        rows[row].clear();
    }
    rows
}

/// What belongs to each row that does not follow from others.
fn asked<'a, T>(derived: &'a Derived, list: &'a [T]) -> impl Iterator<Item = (usize, &'a T)> {
    let rows = list.iter().enumerate();
    rows.filter(|(row, _)| !derived.redundant.contains(row))
}

/// λ ← S⁻¹ λ, and the inverse pivot of each row; −1 if it follows from others in every pose.
fn solve(code: &mut Lowering, derived: &Derived, upper: Upper, lambda: &mut Sparse) {
    let (rows, redundant) = (derived.system.rows.len(), &derived.redundant);
    let factor = Factor::new(code, rows, upper, Rank::MayBeLost, "pivot");
    factor.solve(code, lambda);
    for r in 0..rows {
        let inverse_pivot = match redundant.contains(&r) {
            true => Operand::number(-1.0),
            false => factor.inverse_pivot(r),
        };
        code.write("inverse_pivot", Place::Element(r), inverse_pivot);
    }
    for r in 0..rows {
        let value = *lambda.entry(r).or_insert(Operand::number(0.0));
        code.name(value, || format!("lambda_{r}"));
        code.write("lambda", Place::Element(r), value);
    }
}
