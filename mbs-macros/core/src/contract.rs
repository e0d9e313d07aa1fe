//! The contract between generated code and the runtime as a table: each function with its arguments, their shapes, and
//! the source of its body. Signatures, stubs, reserved names and operation counts follow from this table; the traits of
//! the runtime, in its `contract/`, declare the same functions with their meaning; rustc compares the two.

use crate::dag::{Cost, Program};

/// The subject of a function: one trait of the runtime each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Capability {
    /// q, v and the motion along velocities.
    Configuration,
    /// M and its factor.
    Inertia,
    /// φ, A, b and the solutions with them.
    Constraints,
    /// f, F and their tangents.
    Loads,
    /// Outputs, events, points, reactions.
    Observables,
    /// All of the others together.
    System,
}

impl Capability {
    /// In the order in which they are emitted.
    pub const ALL: [Self; 6] = [
        Capability::Configuration,
        Capability::Inertia,
        Capability::Constraints,
        Capability::Loads,
        Capability::Observables,
        Capability::System,
    ];

    /// The trait, with the sizes it depends on.
    pub fn name(self, program: &Program) -> String {
        format!("{self:?}<{}>", self.sizes(program))
    }

    /// Q, N, and R if the trait depends on it.
    pub fn sizes(self, program: &Program) -> String {
        let (q, n, r) = (program.coordinates, program.size, program.rows.len());
        match self {
            Capability::Configuration | Capability::Inertia | Capability::Loads => {
                format!("{q}, {n}")
            }
            _ => format!("{q}, {n}, {r}"),
        }
    }
}

/// The shape of an argument.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// A number.
    Number,
    /// Q entries.
    Coordinates,
    /// N entries.
    Velocities,
    /// R entries.
    Rows,
    /// R rows of N entries, as the columns of an N × R matrix.
    RowsByVelocities,
    /// R rows of R entries, as the columns of a matrix.
    RowsByRows,
    /// The factor of M.
    Factor,
    /// Entries that are written to a sink for matrices.
    Matrix,
    /// Entries that are written to a sink for tensors.
    Tensor,
    /// As many numbers as the caller has room for.
    Values,
    /// As many points as the caller has room for.
    Points,
    /// The array of K of the sparse elimination.
    Slots,
}

/// An argument of a function.
#[derive(Debug, Clone, Copy)]
pub struct Argument {
    /// Its name in signatures and bodies.
    pub name: &'static str,
    /// Its shape.
    pub shape: Shape,
    /// Whether the function writes it.
    pub written: bool,
}

/// What a function returns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Returns {
    /// Nothing: it writes into its arguments.
    Nothing,
    /// A number.
    Number,
    /// Whether the function has written its results.
    Available,
    /// q.
    Coordinates,
    /// v.
    Velocities,
    /// q and v.
    Guess,
    /// A factor of M, or `None`.
    Factor,
    /// The inputs.
    Inputs,
    /// The inputs, to be set.
    InputsMut,
}

/// The source of the body of a function.
#[derive(Clone, Copy)]
pub enum Origin {
    /// The function of this name in the program. If the program has none, the trait has a default body.
    Program,
    /// The same, but with calls of loops if the program has none. The last field gives their operations from N and R.
    Kernel {
        /// The call if M is constant.
        constant_mass: &'static str,
        /// The call if M varies, and its factor is written out.
        written_factor: &'static str,
        /// The call if M varies, and its factor has all entries.
        dense_factor: &'static str,
        /// Operations of the loops; 0 for functions that no step calls.
        operations: fn(usize, usize) -> usize,
    },
    /// Stage 6 writes it without the program.
    Written,
}

/// A function of the contract.
pub struct Method {
    /// The trait it belongs to.
    pub capability: Capability,
    /// Its name, in the program and in the trait.
    pub name: &'static str,
    /// After the receiver.
    pub arguments: &'static [Argument],
    /// What it returns.
    pub returns: Returns,
    /// The source of its body.
    pub origin: Origin,
}

const fn read(name: &'static str, shape: Shape) -> Argument {
    Argument {
        name,
        shape,
        written: false,
    }
}

const fn write(name: &'static str, shape: Shape) -> Argument {
    Argument {
        name,
        shape,
        written: true,
    }
}

const fn method(
    capability: Capability,
    name: &'static str,
    arguments: &'static [Argument],
    returns: Returns,
    origin: Origin,
) -> Method {
    Method {
        capability,
        name,
        arguments,
        returns,
        origin,
    }
}

const T: Argument = read("t", Shape::Number);
const H: Argument = read("h", Shape::Number);
const Q: Argument = read("q", Shape::Coordinates);
const V: Argument = read("v", Shape::Velocities);
const MASS: Argument = read("mass", Shape::Factor);
const A: Argument = read("a", Shape::RowsByVelocities);
const W: Argument = read("w", Shape::RowsByVelocities);

use Capability::{Configuration, Constraints, Inertia, Loads, Observables, System};
use Origin::{Kernel, Program as Generated, Written};
use Returns::Nothing;
use Shape::{Coordinates, Matrix, Rows, RowsByRows, RowsByVelocities, Velocities};

/// All functions, in the order in which they are emitted.
#[rustfmt::skip]
pub const METHODS: &[Method] = &[
    method(Configuration, "guess", &[], Returns::Guess, Written),
    method(Configuration, "advance", &[Q, V, H], Returns::Coordinates, Written),
    method(Configuration, "difference", &[read("from", Coordinates), read("to", Coordinates)], Returns::Velocities, Written),
    method(Configuration, "free_flight", &[write("q", Coordinates), write("v", Velocities), H], Nothing, Written),

    method(Inertia, "mass_matrix", &[Q, write("mass", Matrix)], Nothing, Generated),
    method(Inertia, "momentum", &[Q, V, write("p", Velocities)], Nothing, Generated),
    method(Inertia, "affinities", &[Q, write("gamma", Shape::Tensor)], Nothing, Kernel {
        constant_mass: "::mbs_runtime::generated::affinities(self, q, gamma);",
        written_factor: "::mbs_runtime::generated::affinities(self, q, gamma);",
        dense_factor: "::mbs_runtime::generated::affinities(self, q, gamma);",
        operations: |_, _| 0,
    }),
    method(Inertia, "kinetic_energy", &[Q, V], Returns::Number, Generated),
    method(Inertia, "solve_mass", &[MASS, write("x", Velocities)], Nothing, Kernel {
        constant_mass: "::mbs_runtime::generated::multiply(&self.inverse_mass, x);",
        written_factor: "mass.solve(x);",
        dense_factor: "mass.solve(x);",
        operations: |n, _| 2 * n * n,
    }),
    method(Inertia, "factor_mass", &[Q], Returns::Factor, Written),

    method(Constraints, "holonomic", &[T, Q, write("phi", Rows)], Nothing, Generated),
    method(Constraints, "constraints", &[T, Q, write("phi", Rows), write("a", Matrix), write("b", Rows)], Nothing, Generated),
    method(Constraints, "constraint_rates", &[T, Q, V, write("a_rate", Matrix), write("gamma", Rows)], Nothing, Generated),
    method(Constraints, "metric", &[MASS, T, Q, A, write("w", RowsByVelocities), write("delassus", RowsByRows)], Nothing, Generated),
    method(Constraints, "row_rates", &[A, V, write("rates", Rows)], Nothing, Generated),
    method(Constraints, "sparse_constraints", &[T, Q, write("phi", Rows), write("k", Shape::Slots), write("b", Rows)], Nothing, Written),
    method(Constraints, "sparse_mass", &[Q, write("k", Shape::Slots)], Nothing, Written),
    method(Constraints, "solve_mass_rows", &[MASS, A, write("w", RowsByVelocities)], Nothing, Kernel {
        constant_mass: "::mbs_runtime::generated::multiply_rows(&self.inverse_mass, a, w);",
        written_factor: "::mbs_runtime::generated::solve_rows(a, w, |x| ::mbs_runtime::Inertia::solve_mass(self, mass, x));",
        dense_factor: "mass.solve_rows(a, w);",
        operations: |n, r| 2 * n * n * r,
    }),
    method(Constraints, "delassus", &[A, W, write("delassus", RowsByRows)], Nothing, Kernel {
        constant_mass: "::mbs_runtime::generated::delassus(a, w, delassus);",
        written_factor: "::mbs_runtime::generated::delassus(a, w, delassus);",
        dense_factor: "::mbs_runtime::generated::delassus(a, w, delassus);",
        operations: |n, r| 2 * n * r * r,
    }),

    method(Loads, "inputs", &[], Returns::Inputs, Written),
    method(Loads, "inputs_mut", &[], Returns::InputsMut, Written),
    method(Loads, "applied_forces", &[T, Q, V, write("f", Velocities)], Nothing, Generated),
    method(Loads, "forces", &[T, Q, V, write("f", Velocities)], Nothing, Generated),
    method(Loads, "applied_force_tangents", &[T, Q, V, write("f_q", Matrix), write("f_v", Matrix)], Nothing, Generated),
    method(Loads, "force_tangents", &[T, Q, V, write("f_q", Matrix), write("f_v", Matrix), write("p_q", Matrix)], Nothing, Generated),
    method(Loads, "free_forces", &[T, Q, V, write("f", Velocities)], Nothing, Generated),
    method(Loads, "balance", &[T, Q, V, write("p", Velocities), write("f", Velocities)], Nothing, Generated),
    method(Loads, "balance_tangents", &[T, Q, V, write("mass", Matrix), write("f_q", Matrix), write("f_v", Matrix), write("p_q", Matrix)], Nothing, Generated),
    method(Loads, "acceleration", &[T, Q, write("acceleration", Velocities)], Nothing, Generated),
    method(Loads, "potential_energy", &[Q], Returns::Number, Generated),
    method(Loads, "nonconservative_power", &[T, Q, V], Returns::Number, Generated),

    method(Observables, "outputs", &[T, Q, V, write("outputs", Shape::Values)], Nothing, Generated),
    method(Observables, "outputs_at_acceleration_level", &[T, Q, V, read("acceleration", Velocities), read("lambda", Rows), write("outputs", Shape::Values)], Nothing, Generated),
    method(Observables, "events", &[T, Q, V, write("events", Shape::Values)], Nothing, Generated),
    method(Observables, "held", &[Q, V, write("held", Shape::Values)], Nothing, Generated),
    method(Observables, "points", &[T, Q, write("points", Shape::Points)], Nothing, Generated),
    method(Observables, "reactions", &[T, Q, V, read("acceleration", Velocities), read("lambda", Rows), write("reactions", Shape::Values)], Nothing, Generated),

    method(System, "accelerations", &[T, Q, V, read("correction", Rows), write("acceleration", Velocities), write("lambda", Rows), write("inverse_pivot", Rows)], Returns::Available, Generated),
    method(System, "partitioned_accelerations", &[T, Q, V, read("correction", Rows), write("acceleration", Velocities), write("weakness", Rows)], Returns::Available, Generated),
];

impl Method {
    /// The function of this name.
    pub fn named(name: &str) -> Option<&'static Method> {
        METHODS.iter().find(|method| method.name == name)
    }

    /// Arguments and result as Rust, with the sizes of the program.
    pub fn signature(&self, program: &Program) -> String {
        let receiver = match self.returns {
            Returns::InputsMut => "&mut self",
            _ => "&self",
        };
        let arguments = self
            .arguments
            .iter()
            .map(|argument| argument.declared(program));
        let list: Vec<String> = std::iter::once(receiver.to_owned())
            .chain(arguments)
            .collect();
        format!("({}){}", list.join(", "), self.returns.declared(program))
    }

    /// A call with arguments of the same names.
    pub fn call(&self) -> String {
        let names: Vec<&str> = self
            .arguments
            .iter()
            .map(|argument| argument.name)
            .collect();
        format!("self.{}({});", self.name, names.join(", "))
    }
}

impl Argument {
    fn declared(&self, program: &Program) -> String {
        let kind = match self.shape {
            Shape::Number => return format!("{}: f64", self.name),
            Shape::Coordinates => vector(program.coordinates),
            Shape::Velocities => vector(program.size),
            Shape::Rows => vector(program.rows.len()),
            Shape::RowsByVelocities => matrix(program.size, program.rows.len()),
            Shape::RowsByRows => matrix(program.rows.len(), program.rows.len()),
            Shape::Factor => "Self::Mass".to_owned(),
            Shape::Matrix => "impl ::mbs_runtime::MatrixSink".to_owned(),
            Shape::Tensor => "impl ::mbs_runtime::TensorSink".to_owned(),
            Shape::Values | Shape::Slots => "[f64]".to_owned(),
            Shape::Points => "[[f64; 3]]".to_owned(),
        };
        let reference = if self.written { "&mut " } else { "&" };
        format!("{}: {reference}{kind}", self.name)
    }

    /// The line that makes its entries an array, for a body that reads or writes them one by one.
    pub fn as_array(&self) -> Option<String> {
        let view = match (self.shape, self.written) {
            (Shape::Coordinates | Shape::Velocities | Shape::Rows, false) => "entries",
            (Shape::Coordinates | Shape::Velocities | Shape::Rows, true) => "entries_mut",
            (Shape::RowsByVelocities | Shape::RowsByRows, false) => "rows",
            (Shape::RowsByVelocities | Shape::RowsByRows, true) => "rows_mut",
            _ => return None,
        };
        Some(format!("let {0} = {view}({0});", self.name))
    }
}

impl Returns {
    fn declared(self, program: &Program) -> String {
        let (q, v) = (vector(program.coordinates), vector(program.size));
        let kind = match self {
            Returns::Nothing => return String::new(),
            Returns::Number => "f64".to_owned(),
            Returns::Available => "bool".to_owned(),
            Returns::Coordinates => q,
            Returns::Velocities => v,
            Returns::Guess => format!("({q}, {v})"),
            Returns::Factor => "::core::option::Option<Self::Mass>".to_owned(),
            Returns::Inputs => "&[f64]".to_owned(),
            Returns::InputsMut => "&mut [f64]".to_owned(),
        };
        format!(" -> {kind}")
    }
}

/// A vector of this length.
pub fn vector(length: usize) -> String {
    format!("SVector<f64, {length}>")
}

/// A matrix of this size.
pub fn matrix(rows: usize, columns: usize) -> String {
    format!("SMatrix<f64, {rows}, {columns}>")
}

/// Names of arguments: no value of a generated body has one of them.
pub fn reserved_names() -> impl Iterator<Item = &'static str> {
    METHODS
        .iter()
        .flat_map(|method| method.arguments)
        .map(|argument| argument.name)
}

/// What a function costs: its straight-line code, or the loops in its place; `None` where the trait has it.
pub fn cost(program: &Program, name: &str) -> Option<Cost> {
    let straight = program.function(name).map(|function| function.cost());
    straight.or_else(|| loops(program).find_map(|(own, cost)| (own == name).then_some(cost)))
}

/// What the functions cost that are loops, because their straight-line code would be too long.
pub fn loops(program: &Program) -> impl Iterator<Item = (&'static str, Cost)> {
    let (n, r) = (program.size, program.rows.len());
    METHODS
        .iter()
        .filter_map(move |method| match method.origin {
            Kernel { operations, .. } if program.function(method.name).is_none() => {
                Some((method.name, Cost::of_loops(operations(n, r))))
            }
            _ => None,
        })
}
