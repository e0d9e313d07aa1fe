//! The mechanics of an instant from the derived expressions of a declaration, without compiling it: accelerations,
//! reactions, and what does not depend on the description.

mod metric;

use mbs_macros_core::Analysis;
use mbs_macros_core::derivatives::{Derived, Matrix};
use mbs_macros_core::symbolic::{Evaluator, Expr, Symbol};
use mbs_runtime::nalgebra::{DMatrix, DVector};
use metric::Metric;
use std::collections::BTreeMap;

/// The time by which points are moved to differentiate their velocities, s.
const APART: f64 = 1e-4;
/// The same for rates of coordinates: what they lose is of second order, and round-off is 1e-16 of it.
const NEAR: f64 = 1e-5;

/// Steps of the midpoint rules that are extrapolated.
const STEPS: [usize; 4] = [2, 4, 6, 8];
/// The kinetic energy that forces may give at the start, J: some metres and radians a second.
const WORK: f64 = 1.0;

/// A state of a description.
#[derive(Clone)]
pub struct Instant<'a> {
    analysis: &'a Analysis,
    time: f64,
    q: DVector<f64>,
    v: DVector<f64>,
    acceleration: DVector<f64>,
    multipliers: DVector<f64>,
    /// The rank of A.
    pub rank: usize,
    /// The smallest eigenvalue of the scaled rows that counts: near 0 beside a singular pose.
    pub margin: f64,
    /// The largest residual of the velocity rows: not 0 if no velocity satisfies them.
    pub contradiction: f64,
    /// The error that [`Instant::later`] expects of itself.
    pub doubt: f64,
}

impl<'a> Instant<'a> {
    /// At the guess, with the slowest velocity that the rows allow, and what the forces at rest give in addition in a
    /// tenth of a second or until they have done some work. (This depends on the mechanism, not on its description.)
    pub fn at_start(analysis: &'a Analysis) -> Self {
        let layout = &analysis.derived.system.layout;
        let size = analysis.derived.system.size;
        let mut instant = Instant {
            analysis,
            time: 0.0,
            q: DVector::zeros(layout.coordinates.len()),
            v: DVector::zeros(size),
            acceleration: DVector::zeros(size),
            multipliers: DVector::zeros(analysis.derived.system.rows.len()),
            rank: 0,
            margin: 1.0,
            contradiction: 0.0,
            doubt: 0.0,
        };
        let guess: Vec<Expr> = layout.coordinates.iter().map(|q| q.guess).collect();
        instant.q = instant.values(&guess).into();
        instant.start();
        instant.solve();
        instant
    }

    /// After this time: midpoint rules with more and more steps, extrapolated.
    pub fn later(&self, time: f64) -> Self {
        // What each rule gives, extrapolated with those before it by Aitken and Neville.
        let mut table: Vec<DVector<f64>> = Vec::new();
        let mut doubt = 0.0;
        for (i, &steps) in STEPS.iter().enumerate() {
            let mut latest = self.midpoints(time, steps);
            for k in (0..i).rev() {
                let ratio = (steps as f64 / STEPS[k] as f64).powi(2);
                let better = &latest + (&latest - &table[k]) / (ratio - 1.0);
                doubt = (&better - &latest).amax();
                table[k] = std::mem::replace(&mut latest, better);
            }
            table.insert(0, latest);
        }
        let mut state = self.placed(self.time + time, &table[0]);
        state.doubt = self.doubt + doubt;
        state
    }

    /// q and v after this time by the explicit midpoint rule.
    fn midpoints(&self, time: f64, steps: usize) -> DVector<f64> {
        let step = time / steps as f64;
        let start = self.state();
        let mut before = start.clone();
        let mut now = start + step * self.rates();
        for k in 1..steps {
            let rates = self.placed(self.time + k as f64 * step, &now).rates();
            (before, now) = (now, before + 2.0 * step * rates);
        }
        // Gragg's end of it is not needed: the number of steps is even.
        now
    }

    /// q and v.
    fn state(&self) -> DVector<f64> {
        let state = self.q.iter().chain(&self.v).copied();
        DVector::from_iterator(self.q.len() + self.v.len(), state)
    }

    /// The instant with other q and v.
    fn placed(&self, time: f64, state: &DVector<f64>) -> Self {
        let mut instant = self.clone();
        instant.time = time;
        instant.q = state.rows(0, self.q.len()).into();
        instant.v = state.rows(self.q.len(), self.v.len()).into();
        instant.solve();
        instant
    }

    /// q̇ and v̇.
    fn rates(&self) -> DVector<f64> {
        let moved = |s: f64| self.moved(s).q;
        let slopes = (moved(NEAR) - moved(-NEAR)) / (2.0 * NEAR);
        let rates = slopes.iter().chain(&self.acceleration).copied();
        DVector::from_iterator(self.q.len() + self.v.len(), rates)
    }

    /// The velocities of the start.
    fn start(&mut self) {
        let Equations { metric, b, .. } = self.equations();
        let Some(metric) = metric else {
            return self.v.fill(f64::NAN);
        };
        let [slowest, _] = metric.onto_rows(&self.v, &b);
        let forces = DVector::from(self.values(&self.derived().system.forces));
        let [driven, _] = metric.onto_rows(&metric.free(&forces), &(0.0 * &b));
        let energy = 0.5 * metric.square(&driven);
        self.v = slowest + (WORK / energy).sqrt().min(0.1) * driven;
        self.contradiction = metric.residual(&self.v, &b);
    }

    /// v̇ and the λ of least norm.
    fn solve(&mut self) {
        let equations = self.equations();
        let Some(metric) = &equations.metric else {
            return self.acceleration.fill(f64::NAN);
        };
        [self.acceleration, self.multipliers] =
            metric.onto_rows(&metric.free(&equations.driving), &equations.gamma);
        (self.rank, self.margin) = (metric.rank(), metric.margin());
    }

    fn equations(&self) -> Equations {
        let derived = self.derived();
        let (size, rows) = (self.v.len(), self.multipliers.len());
        self.evaluated(|evaluator| {
            let mut matrix = |entries: &Matrix, rows: usize| {
                let mut matrix = DMatrix::zeros(rows, size);
                for (&place, &entry) in entries {
                    matrix[place] = evaluator.value(entry);
                }
                matrix
            };
            let mut mass = matrix(&derived.system.mass, size);
            mass.fill_lower_triangle_with_upper_triangle();
            let jacobian = matrix(&derived.jacobian, rows);
            let momentum_rate = matrix(&derived.momentum_by_position, size) * &self.v;
            let mut vector = |list: &[Expr]| {
                DVector::from_iterator(list.len(), list.iter().map(|&x| evaluator.value(x)))
            };
            Equations {
                metric: Metric::new(mass, jacobian),
                b: vector(&derived.rheonomic),
                driving: vector(&derived.total_forces) - momentum_rate,
                gamma: vector(&derived.convective),
            }
        })
    }

    /// The largest residual of the position rows.
    pub fn open(&self) -> f64 {
        let system = &self.derived().system;
        let rows = system.rows[..system.holonomic_rows()].iter();
        let rows: Vec<Expr> = rows.map(|row| row.expr).collect();
        let values = self.values(&rows);
        values.iter().fold(0.0, |most, x| x.abs().max(most))
    }

    /// T
    pub fn kinetic(&self) -> f64 {
        self.value(self.derived().kinetic)
    }

    /// T, V, the power of the forces without potential, and the outputs with their rates.
    pub fn quantities(&self) -> Vec<f64> {
        let derived = self.derived();
        let system = &derived.system;
        let mut values = self.values(&[derived.kinetic, system.potential, system.power]);
        values.extend(self.values(&system.outputs));
        let rates = self.slope(|state| state.values(&system.outputs).into());
        values.extend(rates.iter());
        values
    }

    /// d(T + V)/dt by differences, the power of all forces, and what both are sums of.
    pub fn power(&self) -> [f64; 3] {
        let derived = self.derived();
        let system = &derived.system;
        let energies = [derived.kinetic, system.potential];
        let rates = self.slope(|state| state.values(&energies).into());
        let rheonomic = DVector::from(self.values(&derived.rheonomic));
        let driving = self.multipliers.component_mul(&rheonomic);
        let power = self.value(system.power);
        let size = rates.abs().sum() + power.abs() + driving.abs().sum();
        [rates.sum(), power - driving.sum(), size]
    }

    /// The slope along the motion at this instant.
    fn slope(&self, curve: impl Fn(&Self) -> DVector<f64>) -> DVector<f64> {
        let at = |s: f64| curve(&self.moved(s));
        let difference = |s: f64| (at(s) - at(-s)) / (2.0 * s);
        (4.0 * difference(APART) - difference(2.0 * APART)) / 3.0
    }

    /// The state after `s` seconds, up to terms of second order.
    fn moved(&self, s: f64) -> Self {
        let layout = &self.derived().system.layout;
        let moved = layout.moved(self.q.as_slice(), self.v.as_slice(), s);
        Instant {
            time: self.time + s,
            q: moved.into(),
            v: &self.v + s * &self.acceleration,
            ..self.clone()
        }
    }

    /// The reactions that are determined, by joint and component.
    pub fn reactions(&self) -> BTreeMap<String, f64> {
        let undetermined = match &self.analysis.mobility {
            Some(mobility) => &mobility.undetermined[..],
            None => &[],
        };
        let reactions = self.derived().system.reactions.iter();
        let known = reactions.filter(|reaction| !undetermined.contains(&reaction.joint));
        let named = known.map(|reaction| {
            let name = format!("{}.{}", reaction.joint, reaction.component);
            (name, self.value(reaction.expr))
        });
        named.collect()
    }

    fn derived(&self) -> &'a Derived {
        &self.analysis.derived
    }

    /// The value of an expression.
    pub fn value(&self, expr: Expr) -> f64 {
        self.values(&[expr])[0]
    }

    fn values(&self, list: &[Expr]) -> Vec<f64> {
        self.evaluated(|evaluator| list.iter().map(|&expr| evaluator.value(expr)).collect())
    }

    fn evaluated<T>(&self, read: impl FnOnce(&mut Evaluator) -> T) -> T {
        let system = &self.derived().system;
        let symbols = |symbol: Symbol| match symbol {
            Symbol::Time => self.time,
            Symbol::Parameter(i) => self.analysis.outline.parameters[i as usize].default,
            Symbol::Velocity(i) => self.v[i as usize],
            Symbol::Acceleration(i) => self.acceleration[i as usize],
            Symbol::Multiplier(i) => self.multipliers[i as usize],
            other => {
                let value = system.layout.value(other, self.q.as_slice());
                value.unwrap_or_else(|| panic!("{other:?} of a random mechanism"))
            }
        };
        let laws = |_: u32, _: &[f64]| unreachable!("random mechanisms have no laws");
        read(&mut Evaluator::new(&system.graph, &symbols, &laws))
    }
}

/// The equations of motion as numbers: M v̇ = driving + Aᵀ λ, A v + b = 0 and A v̇ + γ = 0.
struct Equations {
    /// `None` if M is not positive definite.
    metric: Option<Metric>,
    b: DVector<f64>,
    driving: DVector<f64>,
    gamma: DVector<f64>,
}
