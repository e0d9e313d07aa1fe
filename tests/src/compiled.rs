//! The values of the compiled functions, as a table.

use crate::random::Arguments;
use crate::table::Table;
use mbs_runtime::nalgebra::{SMatrix, SVector};
use mbs_runtime::{MatrixSink, System, TensorSink};

/// Stores the entries that are written, so that a zero that is never written is absent.
#[derive(Debug, Default)]
struct Entries(Vec<([usize; 3], f64)>);

impl MatrixSink for Entries {
    fn set(&mut self, row: usize, column: usize, value: f64) {
        self.0.push(([row, column, 0], value));
    }
}

impl TensorSink for Entries {
    fn set(&mut self, i: usize, j: usize, k: usize, value: f64) {
        self.0.push(([i, j, k], value));
    }
}

/// All functions at one instant.
pub fn table<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    at: &Arguments<Q, N, R>,
) -> Table {
    let Arguments {
        time: t,
        q,
        v,
        acceleration,
        lambda,
    } = at;
    let t = *t;
    let mut table = Table::default();
    let sparse = |table: &mut Table, function, sink, entries: Entries| {
        for (place, value) in entries.0 {
            table.insert((function, sink, place), value);
        }
    };
    let model = S::MODEL;

    let mut mass = Entries::default();
    system.mass_matrix(q, &mut mass);
    sparse(&mut table, "mass_matrix", "mass", mass);
    let mut p = SVector::<f64, N>::repeat(f64::NAN);
    system.momentum(q, v, &mut p);
    table.vector("momentum", "p", p.as_slice());
    let mut gamma = Entries::default();
    system.affinities(q, &mut gamma);
    sparse(&mut table, "affinities", "gamma", gamma);

    let holonomic = S::STRUCTURE.holonomic_rows;
    let mut phi = SVector::<f64, R>::repeat(f64::NAN);
    system.holonomic(t, q, &mut phi);
    table.vector("holonomic", "phi", &phi.as_slice()[..holonomic]);
    let (mut phi, mut a, mut b) = (
        SVector::<f64, R>::repeat(f64::NAN),
        Entries::default(),
        SVector::<f64, R>::repeat(f64::NAN),
    );
    system.constraints(t, q, &mut phi, &mut a, &mut b);
    table.vector("constraints", "phi", &phi.as_slice()[..holonomic]);
    table.vector("constraints", "b", b.as_slice());
    let mut rows = Box::new(SMatrix::<f64, N, R>::zeros());
    a.0.iter()
        .for_each(|&([i, j, _], value)| rows[(j, i)] = value);
    sparse(&mut table, "constraints", "a", a);
    let (mut rate, mut gamma) = (Entries::default(), SVector::<f64, R>::repeat(f64::NAN));
    system.constraint_rates(t, q, v, &mut rate, &mut gamma);
    sparse(&mut table, "constraint_rates", "a_rate", rate);
    table.vector("constraint_rates", "gamma", gamma.as_slice());

    let mut f = SVector::<f64, N>::repeat(f64::NAN);
    system.applied_forces(t, q, v, &mut f);
    table.vector("applied_forces", "f", f.as_slice());
    system.forces(t, q, v, &mut f);
    table.vector("forces", "f", f.as_slice());
    system.free_forces(t, q, v, &mut f);
    table.vector("free_forces", "f", f.as_slice());
    let (mut f_q, mut f_v) = (Entries::default(), Entries::default());
    system.applied_force_tangents(t, q, v, &mut f_q, &mut f_v);
    sparse(&mut table, "applied_force_tangents", "f_q", f_q);
    sparse(&mut table, "applied_force_tangents", "f_v", f_v);
    let (mut f_q, mut f_v, mut p_q) = (Entries::default(), Entries::default(), Entries::default());
    system.force_tangents(t, q, v, &mut f_q, &mut f_v, &mut p_q);
    sparse(&mut table, "force_tangents", "f_q", f_q);
    sparse(&mut table, "force_tangents", "f_v", f_v);
    sparse(&mut table, "force_tangents", "p_q", p_q);
    let (mut p, mut f) = (
        SVector::<f64, N>::repeat(f64::NAN),
        SVector::<f64, N>::repeat(f64::NAN),
    );
    system.balance(t, q, v, &mut p, &mut f);
    table.vector("balance", "p", p.as_slice());
    table.vector("balance", "f", f.as_slice());
    let [mut mass, mut f_q, mut f_v, mut p_q] = [(); 4].map(|()| Entries::default());
    system.balance_tangents(t, q, v, &mut mass, &mut f_q, &mut f_v, &mut p_q);
    for (sink, entries) in [("mass", mass), ("f_q", f_q), ("f_v", f_v), ("p_q", p_q)] {
        sparse(&mut table, "balance_tangents", sink, entries);
    }
    let mut explicit = SVector::zeros();
    system.acceleration(t, q, &mut explicit);
    table.vector("acceleration", "acceleration", explicit.as_slice());

    // Random numbers in place of the corrections.
    let (mut explicit, mut multipliers, mut inverse_pivot) =
        (SVector::zeros(), SVector::zeros(), SVector::zeros());
    let into = (&mut explicit, &mut multipliers, &mut inverse_pivot);
    if system.accelerations(t, q, v, lambda, into.0, into.1, into.2) {
        table.vector("accelerations", "inverse_pivot", inverse_pivot.as_slice());
        table.vector("accelerations", "acceleration", explicit.as_slice());
        table.vector("accelerations", "lambda", multipliers.as_slice());
    }

    let (mut explicit, mut weakness) = (SVector::zeros(), SVector::zeros());
    let into = (&mut explicit, &mut weakness);
    if system.partitioned_accelerations(t, q, v, lambda, into.0, into.1) {
        let name = "partitioned_accelerations";
        table.vector(name, "acceleration", explicit.as_slice());
        table.vector(name, "weakness", weakness.as_slice());
    }

    table.insert(("kinetic_energy", "", [0; 3]), system.kinetic_energy(q, v));
    table.insert(("potential_energy", "", [0; 3]), system.potential_energy(q));
    table.insert(
        ("nonconservative_power", "", [0; 3]),
        system.nonconservative_power(t, q, v),
    );

    let mut outputs = vec![f64::NAN; model.outputs.len()];
    system.outputs(t, q, v, &mut outputs);
    table.vector("outputs", "outputs", &outputs);
    let mut events = vec![f64::NAN; model.events.len()];
    system.events(t, q, v, &mut events);
    table.vector("events", "events", &events);
    let mut points = vec![[f64::NAN; 3]; model.points.len()];
    system.points(t, q, &mut points);
    for (i, point) in points.iter().enumerate() {
        for (axis, &x) in point.iter().enumerate() {
            table.insert(("points", "points", [i, axis, 0]), x);
        }
    }
    let mut reactions = vec![f64::NAN; model.reactions.len()];
    system.reactions(t, q, v, acceleration, lambda, &mut reactions);
    table.vector("reactions", "reactions", &reactions);

    let mut rates = SVector::<f64, R>::repeat(f64::NAN);
    system.row_rates(&rows, v, &mut rates);
    table.vector("row_rates", "rates", rates.as_slice());

    // The kernels, for x = v̇ and a = A, w = M⁻¹ A.
    if let Some(mass) = system.factor_mass(q) {
        let mut x = *acceleration;
        system.solve_mass(&mass, &mut x);
        table.vector("solve_mass", "x", x.as_slice());
        let mut w = Box::new(SMatrix::zeros());
        system.solve_mass_rows(&mass, &rows, &mut w);
        table.rows("solve_mass_rows", "w", &w);
        let mut delassus = Box::new(SMatrix::zeros());
        system.delassus(&rows, &w, &mut delassus);
        table.rows("delassus", "delassus", &delassus);
        // Either generated, or the two kernels above one after the other.
        w.fill(0.0);
        system.metric(&mass, t, q, &rows, &mut w, &mut delassus);
        table.rows("metric", "w", &w);
        table.rows("metric", "delassus", &delassus);
    }
    table
}
