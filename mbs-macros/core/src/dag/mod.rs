//! Stage 5: derived quantities → straight-line programs.
//!
//! What depends on parameters alone is hoisted into constants, computed once per parameter set; what remains becomes
//! binary operations, shared across all outputs of a function. AFTER THIS STAGE: every operation of the generated code
//! is an [`Operation`], and is counted.

mod accelerations;
mod cost;
mod elimination;
mod factor;
mod functions;
mod kernels;
mod likeness;
mod lower;
mod partition;
mod partitioned;
mod parts;
mod reciprocals;
mod run;
mod sparse;
mod sums;
mod tangents;
mod text;

use crate::symbolic::{Function as Elementary, Number, Symbol, Table as Curve};
use std::sync::Arc;

pub use cost::Cost;
pub use functions::lower;
pub use parts::{Labels, Parts, Run as PartRun, Shape};
pub use run::Run;
pub use sparse::{Elimination, Kicks, Sparse, Stretch, Table};
pub use tangents::{ALL_TANGENTS, TURNING, of_tangents};

/// All generated functions of a mechanism.
#[derive(Debug)]
pub struct Program {
    /// Constants of the first kind: they depend on parameters.
    pub constants: Vec<Constant>,
    /// M (upper triangle) in constants, where it is constant: its inverse is computed from these.
    pub constant_mass: Option<Vec<(usize, usize, Operand)>>,
    /// The functions that compute the constants: those before M⁻¹, and those that use it.
    pub preparation: [Function; 2],
    /// The values of [`System::requirements`](crate::equations::System::requirements), one after the other.
    pub checks: Function,
    /// The values of [`System::scales`](crate::equations::System::scales).
    pub scales: Function,
    /// The functions of the system.
    pub functions: Vec<Function>,
    /// Guesses of q and v.
    pub guesses: Function,
    /// Rotations, for their free flight.
    pub rotations: Vec<RotationBlock>,
    /// Where the counted joint angles are stored, in the order of the function `unwrapped_angles`.
    pub unwrapped_angles: Vec<usize>,
    /// Q.
    pub coordinates: usize,
    /// For each velocity where its coordinate is stored.
    pub slots: Vec<usize>,
    /// N.
    pub size: usize,
    /// R.
    pub rows: Vec<crate::equations::Row>,
    /// Reactions: joint, component, unit.
    pub reactions: Vec<(String, String, String)>,
    /// What the integrator may rely on.
    pub structure: Structure,
    /// Elimination without zeros, where that is the cheaper.
    pub sparse: Option<Sparse>,
    /// The tangents of F and f as one function, where both are long: they differ by gyroscopic terms.
    pub all_tangents: Option<Function>,
    /// p × ω, where M is constant and f is long: F is f and these terms.
    pub turning: Option<Function>,
    /// The parts and joints that coordinates, velocities and rows belong to.
    pub labels: Labels,
}

impl Program {
    /// A function by its name.
    pub fn function(&self, name: &str) -> Option<&Function> {
        let mut functions = self.functions.iter();
        functions.find(|function| function.name == name)
    }

    /// Whether a function reads entries of a constant M⁻¹.
    pub fn reads_inverse_mass(&self) -> bool {
        let own = self.functions.iter().chain(&self.preparation);
        let mut all = own.chain(&self.all_tangents).chain(&self.turning);
        let of_inverse = |operand| matches!(operand, Operand::Symbol(Symbol::InverseMass(..)));
        all.any(|function| {
            let mut reads = function
                .outputs
                .iter()
                .any(|output| of_inverse(output.value));
            for operation in &function.operations {
                operation.for_each_operand(|operand| reads |= of_inverse(operand));
            }
            reads
        })
    }

    /// The function that factors M, and the length of its factor, where M varies and that is straight-line code.
    pub fn factor_entries(&self) -> Option<(&Function, usize)> {
        let function = self.function("factor_mass")?;
        let of_factor = |output: &&Output| output.sink == "factor";
        Some((function, function.outputs.iter().filter(of_factor).count()))
    }
}

/// A rotation: a unit quaternion and three angular velocities in body axes.
#[derive(Debug, Clone)]
pub struct RotationBlock {
    /// The part.
    pub part: String,
    /// Index of its first velocity.
    pub velocity: usize,
    /// Index of the first component of its quaternion.
    pub coordinate: usize,
    /// Its inertia about the centre of mass, in constants.
    pub inertia: [[Operand; 3]; 3],
}

/// What the integrator may rely on, from the symbolic zeros.
#[derive(Debug, Clone, Copy)]
pub struct Structure {
    /// M does not depend on q.
    pub constant_mass: bool,
    /// ∂f/∂v is not zero.
    pub velocity_forces: bool,
    /// ∂f/∂q is not zero.
    pub position_forces: bool,
    /// A row or force depends on time.
    pub time_dependent: bool,
    /// A row depends on time or on an input, or a velocity row is not homogeneous.
    pub rheonomic: bool,
    /// M, forces and rows are [smooth](crate::symbolic::Graph::is_smooth).
    pub smooth: bool,
    /// The number of unit quaternions.
    pub rotations: usize,
    /// The number of leading holonomic rows.
    pub holonomic_rows: usize,
}

/// A constant of the mechanism, computed from parameters.
#[derive(Debug, Clone)]
pub struct Constant {
    /// Its expression, for comments.
    pub text: String,
    /// Whether it needs M⁻¹.
    pub after_inverse: bool,
}

/// A straight-line function.
#[derive(Debug, Clone)]
pub struct Function {
    /// Its name.
    pub name: &'static str,
    /// The operations, in order; an operand refers to earlier ones only.
    pub operations: Vec<Operation>,
    /// A suggested name for each operation's value.
    pub names: Vec<Option<String>>,
    /// What it writes.
    pub outputs: Vec<Output>,
}

impl Function {
    /// Whether both write the same values to the same places.
    pub fn computes_the_same(&self, other: &Function) -> bool {
        self.operations == other.operations && self.outputs == other.outputs
    }
}

/// A value that a function writes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Output {
    /// Which argument receives it.
    pub sink: &'static str,
    /// Where in it.
    pub place: Place,
    /// The value.
    pub value: Operand,
}

/// A place in an output argument.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Place {
    /// The function's return value.
    Value,
    /// An element of a vector.
    Element(usize),
    /// An entry of a matrix.
    Entry(usize, usize),
    /// An entry of a tensor.
    Tensor(usize, usize, usize),
    /// A field of the constants.
    Constant(usize),
}

/// An operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Operand {
    /// A number.
    Number(Number),
    /// An argument, parameter or input.
    Symbol(Symbol),
    /// A constant.
    Constant(usize),
    /// The value of an earlier operation.
    Value(usize),
}

impl Operand {
    /// A number.
    pub fn number(value: f64) -> Operand {
        Operand::Number(Number::new(value))
    }
}

/// A floating-point operation.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Operation {
    /// a + b
    Add(Operand, Operand),
    /// a − b
    Subtract(Operand, Operand),
    /// a · b
    Multiply(Operand, Operand),
    /// a / b
    Divide(Operand, Operand),
    /// −a
    Negate(Operand),
    /// 1/d of a pivot d whose diagonal entry was the second operand (positive); 0 if d is round-off relative to it.
    PivotInverse(Operand, Operand),
    /// An elementary function.
    Call(Elementary, Operand),
    /// atan2(y, x)
    Atan2(Operand, Operand),
    /// The larger of two values.
    Larger(Operand, Operand),
    /// a^exponent
    Power(Operand, Number),
    /// A user's law: value and partials together; `Part` selects one of them.
    Law(u32, Vec<Operand>),
    /// The value (`None`) or a partial of a law's result.
    Part(usize, Option<u32>),
    /// A table's function, one of its derivatives, or its integral (order −1).
    Table(Arc<Curve>, i8, Operand),
}

impl Operation {
    /// The same operation on other operands.
    pub(crate) fn map_operands(&self, map: impl Fn(Operand) -> Operand) -> Operation {
        match self {
            Operation::Add(a, b) => Operation::Add(map(*a), map(*b)),
            Operation::Subtract(a, b) => Operation::Subtract(map(*a), map(*b)),
            Operation::Multiply(a, b) => Operation::Multiply(map(*a), map(*b)),
            Operation::Divide(a, b) => Operation::Divide(map(*a), map(*b)),
            Operation::Negate(a) => Operation::Negate(map(*a)),
            Operation::PivotInverse(pivot, whole) => {
                Operation::PivotInverse(map(*pivot), map(*whole))
            }
            Operation::Call(function, a) => Operation::Call(*function, map(*a)),
            Operation::Atan2(y, x) => Operation::Atan2(map(*y), map(*x)),
            Operation::Larger(a, b) => Operation::Larger(map(*a), map(*b)),
            Operation::Power(a, exponent) => Operation::Power(map(*a), *exponent),
            Operation::Law(law, arguments) => {
                Operation::Law(*law, arguments.iter().map(|x| map(*x)).collect())
            }
            Operation::Part(law, partial) => match map(Operand::Value(*law)) {
                Operand::Value(law) => Operation::Part(law, *partial),
                _ => unreachable!("a law's result is a value"),
            },
            Operation::Table(table, order, a) => Operation::Table(table.clone(), *order, map(*a)),
        }
    }

    /// Calls `visit` on each operand.
    pub fn for_each_operand(&self, mut visit: impl FnMut(Operand)) {
        match self {
            Operation::Add(a, b)
            | Operation::Subtract(a, b)
            | Operation::Multiply(a, b)
            | Operation::Divide(a, b)
            | Operation::PivotInverse(a, b)
            | Operation::Atan2(a, b)
            | Operation::Larger(a, b) => {
                visit(*a);
                visit(*b);
            }
            Operation::Negate(a)
            | Operation::Call(_, a)
            | Operation::Power(a, _)
            | Operation::Table(_, _, a) => visit(*a),
            Operation::Law(_, arguments) => arguments.iter().copied().for_each(visit),
            Operation::Part(law, _) => visit(Operand::Value(*law)),
        }
    }
}
