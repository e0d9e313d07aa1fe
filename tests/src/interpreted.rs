//! The values of the two interpreters for the same declaration, as tables.

use crate::laws;
use crate::random::Arguments;
use crate::table::{Key, Table, indices};
use mbs_macros_core::dag::{self, Operand, Place, Program, Run};
use mbs_macros_core::derivatives::Derived;
use mbs_macros_core::model::{Law, Layout};
use mbs_macros_core::symbolic::{Evaluator, Expr, Graph, LawEvaluation, Symbol};
use mbs_macros_core::{Analysis, analyse};
use mbs_runtime::nalgebra::{DMatrix, SMatrix, SVector};
use mbs_runtime::{Mechanism, System};

/// A declaration that is compiled again inside the test.
pub struct Interpreted {
    laws: Vec<Law>,
    layout: Layout,
    graph: Graph,
    expressions: Vec<(Key, Expr)>,
    program: Program,
    parameters: Vec<f64>,
    inverse: DMatrix<f64>,
    constants: Vec<f64>,
}

/// Stages 1 to 4 of a declaration that is known to be right.
pub fn analysis(declaration: &str) -> Analysis {
    let tokens = declaration
        .parse()
        .expect("a declaration is made of tokens");
    match analyse(tokens).1 {
        Ok(analysis) => analysis,
        Err(failure) => panic!("{}", failure.to_compile_errors()),
    }
}

impl Interpreted {
    /// The declaration of a mechanism, with the mechanism's parameters.
    pub fn new<M, S, const Q: usize, const N: usize, const R: usize>(mechanism: &M) -> Self
    where
        M: Mechanism<System = S>,
        S: System<Q, N, R>,
    {
        let analysis = analysis(<M as Mechanism>::MODEL.declaration);
        let graph = analysis.derived.system.graph.clone();
        let layout = analysis.derived.system.layout.clone();
        let expressions = expressions(&analysis.derived);
        let program = dag::lower(&analysis.derived);
        let parameters: Vec<f64> = <M as Mechanism>::MODEL
            .parameters
            .iter()
            .map(|parameter| {
                mechanism
                    .parameter(parameter.name)
                    .expect("named by the model")
            })
            .collect();
        let mut interpreted = Interpreted {
            laws: analysis.outline.laws,
            layout,
            graph,
            expressions,
            program,
            parameters,
            inverse: DMatrix::zeros(0, 0),
            constants: Vec::new(),
        };
        interpreted.prepare::<N>();
        interpreted
    }

    /// The constants, in the order in which generated code computes them.
    fn prepare<const N: usize>(&mut self) {
        let mut constants = vec![f64::NAN; self.program.constants.len()];
        self.run_preparation(0, &mut constants);
        if let Some(entries) = &self.program.constant_mass {
            let mut mass = Box::new(SMatrix::zeros());
            for &(i, j, value) in entries {
                let value = match value {
                    Operand::Number(number) => number.value(),
                    Operand::Constant(slot) => constants[slot],
                    Operand::Symbol(Symbol::Parameter(i)) => self.parameters[i as usize],
                    other => panic!("{other:?} in a constant mass matrix"),
                };
                mass[(i, j)] = value;
                mass[(j, i)] = value;
            }
            let inverse = mbs_runtime::generated::inverse_mass(&mut mass, &[""; N])
                .expect("the mechanism was prepared");
            self.inverse = DMatrix::from_column_slice(N, N, inverse.as_slice());
        }
        self.run_preparation(1, &mut constants);
        self.constants = constants;
    }

    fn run_preparation(&self, stage: usize, constants: &mut [f64]) {
        let known = constants.to_vec();
        let symbols = |symbol: Symbol| self.parameter(symbol);
        let results = Run {
            symbols: &symbols,
            constants: &known,
            laws: &|_, _| unreachable!(),
        }
        .function(&self.program.preparation[stage]);
        for (output, value) in results {
            match output.place {
                Place::Constant(slot) => constants[slot] = value,
                other => panic!("{other:?} in the preparation"),
            }
        }
    }

    fn parameter(&self, symbol: Symbol) -> f64 {
        match symbol {
            Symbol::Parameter(i) => self.parameters[i as usize],
            Symbol::InverseMass(i, j) => self.inverse[(i as usize, j as usize)],
            other => panic!("{other:?} is not known from parameters"),
        }
    }

    /// Both tables at an instant: of the symbolic interpreter, and of the interpreter of programs.
    pub fn tables<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
        &self,
        system: &S,
        at: &Arguments<Q, N, R>,
    ) -> (Table, Table) {
        let inputs = system.inputs();
        let mut a = Box::new(SMatrix::<f64, R, N>::zeros());
        let mut w = Box::new(SMatrix::zeros());
        let (mut phi, mut b) = (SVector::zeros(), SVector::zeros());
        system.constraints(at.time, &at.q, &mut phi, &mut a, &mut b);
        let a = Box::new(a.transpose());
        if let Some(mass) = system.factor_mass(&at.q) {
            system.solve_mass_rows(&mass, &a, &mut w);
        }
        let laws = |law: u32, arguments: &[f64]| laws::call(&self.laws[law as usize], arguments);
        let factor = self.factor(at.q.as_slice(), &laws);
        let symbols = |symbol: Symbol| match symbol {
            Symbol::FactorEntry(i) => factor[i as usize],
            Symbol::Time => at.time,
            Symbol::Input(i) => inputs[i as usize],
            Symbol::Stored(i) => at.q[i as usize],
            Symbol::Velocity(i) => at.v[i as usize],
            Symbol::Acceleration(i) | Symbol::VectorEntry(i) => at.acceleration[i as usize],
            Symbol::Multiplier(i) | Symbol::Correction(i) => at.lambda[i as usize],
            Symbol::RowEntry(i, j) => a[(j as usize, i as usize)],
            Symbol::WeightedEntry(i, j) => w[(j as usize, i as usize)],
            other => match self.layout.value(other, at.q.as_slice()) {
                Some(value) => value,
                None => self.parameter(other),
            },
        };
        let mut symbolic = Table::default();
        let mut evaluator = Evaluator::new(&self.graph, &symbols, &laws);
        for &(key, expr) in &self.expressions {
            symbolic.insert(key, evaluator.value(expr));
        }

        let mut program = Table::default();
        let run = Run {
            symbols: &symbols,
            constants: &self.constants,
            laws: &laws,
        };
        // Counted angles are no method of their own: `advance` writes them, and outputs show them. The factor of M shows
        // in what is solved with it.
        let inner = ["unwrapped_angles", "unwrapped_rates", "factor_mass"];
        let methods = self.program.functions.iter();
        for function in methods.filter(|function| !inner.contains(&function.name)) {
            for (output, value) in run.function(function) {
                program.insert((function.name, output.sink, indices(output.place)), value);
            }
        }
        (symbolic, program)
    }

    /// The factor of M at q, if straight-line code computes it.
    fn factor(&self, q: &[f64], laws: LawEvaluation) -> Vec<f64> {
        let Some((function, entries)) = self.program.factor_entries() else {
            return Vec::new();
        };
        let symbols = |symbol: Symbol| match symbol {
            Symbol::Stored(i) => q[i as usize],
            other => match self.layout.value(other, q) {
                Some(value) => value,
                None => self.parameter(other),
            },
        };
        let run = Run {
            symbols: &symbols,
            constants: &self.constants,
            laws,
        };
        let values = run.function(function).into_iter().map(|(_, value)| value);
        values.take(entries).collect()
    }
}

/// Every derived expression, and the place to which the generated code writes it.
fn expressions(derived: &Derived) -> Vec<(Key, Expr)> {
    let system = &derived.system;
    let mut list = Vec::new();
    let mut vector = |function, sink, values: &[Expr]| {
        for (i, &value) in values.iter().enumerate() {
            list.push(((function, sink, [i, 0, 0]), value));
        }
    };
    let holonomic: Vec<Expr> = system
        .rows
        .iter()
        .filter(|row| row.kind.is_holonomic())
        .map(|row| row.expr)
        .collect();
    vector("momentum", "p", &derived.momentum);
    vector("holonomic", "phi", &holonomic);
    vector("constraints", "phi", &holonomic);
    vector("constraints", "b", &derived.rheonomic);
    vector("constraint_rates", "gamma", &derived.convective);
    vector("applied_forces", "f", &system.forces);
    vector("forces", "f", &derived.total_forces);
    vector("free_forces", "f", &derived.free_forces);
    vector("balance", "p", &derived.momentum);
    vector("balance", "f", &derived.total_forces);
    vector("outputs", "outputs", &system.outputs);
    vector("events", "events", &system.events);
    vector("kinetic_energy", "", &[derived.kinetic]);
    vector("potential_energy", "", &[system.potential]);
    vector("nonconservative_power", "", &[system.power]);
    let reactions: Vec<Expr> = system
        .reactions
        .iter()
        .map(|reaction| reaction.expr)
        .collect();
    vector("reactions", "reactions", &reactions);
    if let Some(acceleration) = &derived.acceleration {
        vector("acceleration", "acceleration", acceleration);
    }
    for (function, sink, matrix) in [
        ("mass_matrix", "mass", &system.mass),
        ("constraints", "a", &derived.jacobian),
        ("constraint_rates", "a_rate", &derived.jacobian_rate),
        (
            "applied_force_tangents",
            "f_q",
            &derived.applied.by_position,
        ),
        (
            "applied_force_tangents",
            "f_v",
            &derived.applied.by_velocity,
        ),
        ("force_tangents", "f_q", &derived.total.by_position),
        ("force_tangents", "f_v", &derived.total.by_velocity),
        ("force_tangents", "p_q", &derived.momentum_by_position),
    ] {
        for (&(i, j), &value) in matrix {
            list.push(((function, sink, [i, j, 0]), value));
            if function == "mass_matrix" && i != j {
                list.push(((function, sink, [j, i, 0]), value));
            }
        }
    }
    for (&(i, j, k), &value) in derived.affinities.iter().flatten() {
        list.push((("affinities", "gamma", [i, j, k]), value));
    }
    for (i, point) in system.points.iter().enumerate() {
        let components = point.iter().enumerate();
        list.extend(components.map(|(axis, &x)| (("points", "points", [i, axis, 0]), x)));
    }
    list
}
