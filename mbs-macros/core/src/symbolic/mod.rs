//! Hash-consed symbolic expressions.
//!
//! An [`Expr`] is an index into a [`Graph`]; equal expressions have equal indices, so that common subexpressions are
//! found by construction and every pass over a graph is linear in its size. Sums and products are kept in a canonical
//! form (flat, sorted by index, coefficients collected), but **never expanded**: a product of sums stays one.

mod affine;
mod along;
mod build;
mod collected;
mod derivative;
mod evaluate;
mod gradient;
mod hashing;
mod hessian;
mod index;
mod latex;
mod length;
mod map;
mod mixing;
mod number;
mod phasor;
mod print;
mod rate;
mod roots;
mod rotation;
mod smoothness;
mod substitute;
mod table;
mod turns;

pub(crate) use build::is_simple;
pub(crate) use index::Index;
pub(crate) use map::{Map, Set};
pub(crate) use mixing::{hash, mixed, mixed_text};

pub use affine::{Affine, AffineReader, Elimination, eliminate};
pub(crate) use evaluate::larger;
pub use evaluate::{Evaluator, LawEvaluation};
pub use latex::latex_identifier;
pub use length::Length;
pub use number::Number;
pub use rotation::rotation_entry;
pub use substitute::Substitution;
pub use table::{Beyond, Datum, INTEGRAL, Interpolation, Table, TableData};

use std::sync::Arc;

/// A node of a [`Graph`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Expr(pub(crate) u32);

/// What a symbol stands for.
///
/// *Local* coordinates are those of each part on its own, before joints merge points; *global* ones are the generalized
/// coordinates of the mechanism. Part-wise quantities (reactions above all) are derived in the former and substituted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Symbol {
    /// Time t.
    Time,
    /// A declared parameter.
    Parameter(u32),
    /// A declared input.
    Input(u32),
    /// Coordinate, velocity and acceleration of a part on its own.
    LocalPosition(u32),
    /// See [`Symbol::LocalPosition`].
    LocalVelocity(u32),
    /// See [`Symbol::LocalPosition`].
    LocalAcceleration(u32),
    /// Entry 3 row + column of the rotation matrix R of a body (body axes → ground axes) whose angular velocity, in body
    /// axes, are the local velocities from this index on. Its three local positions are directions only: they never
    /// occur in expressions, but derivatives are taken along them (see [`Graph::derivative`]).
    LocalRotation(u32, u8),
    /// Generalized coordinate q, by the index of its velocity.
    Coordinate(u32),
    /// The same of a generalized rotation, by the index of its first velocity.
    Rotation(u32, u8),
    /// The last value of a counted joint angle, which determines the full turns.
    UnwrappedAngle(u32),
    /// An element of q as it is stored: what the three above become in generated code.
    Stored(u32),
    /// Generalized velocity v.
    Velocity(u32),
    /// Generalized acceleration v̇.
    Acceleration(u32),
    /// Lagrange multiplier λ of a row.
    Multiplier(u32),
    /// Component of a joint's reaction that an output reads, by its index in [`Model::readings`](crate::model::Model::readings).
    Reaction(u32),
    /// Entry of the constant inverse M⁻¹: known once the parameters are.
    InverseMass(u32, u32),
    /// Entry of a matrix argument of a generated kernel (A of the rows to be weighted).
    RowEntry(u32, u32),
    /// Entry of a second matrix argument (W).
    WeightedEntry(u32, u32),
    /// Entry of a vector argument.
    VectorEntry(u32),
    /// Entry of the factor of M that a generated kernel is given.
    FactorEntry(u32),
    /// What is added to a row at acceleration level.
    Correction(u32),
    /// A value that a part of a long function reads.
    Place(u32),
}

impl Symbol {
    /// The symbols along which this one changes: itself, or the three directions of a rotation.
    pub fn directions(self) -> impl Iterator<Item = Symbol> {
        let (first, count) = match self {
            Symbol::LocalRotation(first, _) => (Symbol::LocalPosition(first), 3),
            Symbol::Rotation(first, _) => (Symbol::Coordinate(first), 3),
            other => (other, 1),
        };
        (0..count).map(move |k| match first {
            Symbol::LocalPosition(i) => Symbol::LocalPosition(i + k),
            Symbol::Coordinate(i) => Symbol::Coordinate(i + k),
            other => other,
        })
    }

    /// Whether the symbol is known as soon as the parameters are.
    pub fn is_parameter_like(self) -> bool {
        matches!(self, Symbol::Parameter(_) | Symbol::InverseMass(..))
    }

    /// Whether the symbol is a position or orientation of a part.
    pub fn is_local_position(self) -> bool {
        matches!(self, Symbol::LocalPosition(_) | Symbol::LocalRotation(..))
    }

    /// Whether the symbol is a generalized position or orientation.
    pub fn is_configuration(self) -> bool {
        matches!(self, Symbol::Coordinate(_) | Symbol::Rotation(..))
    }

    /// Whether the symbol is a velocity.
    pub fn is_velocity(self) -> bool {
        matches!(self, Symbol::LocalVelocity(_) | Symbol::Velocity(_))
    }
}

/// Elementary functions of one argument.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    /// sin
    Sin,
    /// cos
    Cos,
    /// tan
    Tan,
    /// arcsin
    Asin,
    /// arccos
    Acos,
    /// arctan
    Atan,
    /// square root
    Sqrt,
    /// exponential
    Exp,
    /// natural logarithm
    Ln,
    /// hyperbolic sine
    Sinh,
    /// hyperbolic cosine
    Cosh,
    /// hyperbolic tangent
    Tanh,
    /// absolute value
    Abs,
    /// −1, 0 or 1
    Sign,
    /// 1 where the argument is positive, else 0
    Step,
    /// The nearest integer
    Round,
    /// Its argument, a root or what a power is of, as a divisor of a slope, or a tiny number where that vanishes: the slope of |x| x is 0
    /// at x = 0, not 0/0.
    Nonzero,
    /// Its argument: marks an expression that the reduction can replace by a coordinate. Substitution removes it.
    Same,
    /// Its argument: a sum that other sums do not take in, so that each of many equal elements keeps sums of its own.
    Apart,
}

/// The operation at a node. Construct nodes through [`Graph`]'s methods only: they keep the canonical form.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Node {
    /// A number.
    Constant(Number),
    /// A symbol.
    Symbol(Symbol),
    /// constant + Σ coefficient · term.
    Sum {
        /// The constant.
        constant: Number,
        /// Terms, sorted, with their coefficients.
        terms: Box<[(Expr, Number)]>,
    },
    /// Π factor^power; numeric coefficients live in sums.
    Product(Box<[(Expr, i32)]>),
    /// An elementary function.
    Function(Function, Expr),
    /// atan2(y, x).
    Atan2(Expr, Expr),
    /// The larger of two values.
    Larger(Expr, Expr),
    /// base^exponent with a constant exponent that is not an integer.
    Power(Expr, Number),
    /// A law supplied by the user: its value (`partial: None`) or the partial by one argument.
    Law {
        /// Index of the law in its declaration.
        law: u32,
        /// Which partial, if not the value.
        partial: Option<u32>,
        /// The arguments.
        arguments: Box<[Expr]>,
    },
    /// A table's function, one of its derivatives, or its integral (order −1).
    Table {
        /// The table.
        table: Arc<Table>,
        /// Which derivative.
        order: i8,
        /// The argument.
        x: Expr,
    },
}

impl Node {
    /// The symbols of the operation itself, beside those of its operands.
    fn symbols(&self) -> impl Iterator<Item = Symbol> {
        let (own, data) = match self {
            Node::Symbol(symbol) => (Some(*symbol), None),
            Node::Table { table, .. } => (None, table.data.as_ref()),
            _ => (None, None),
        };
        own.into_iter()
            .chain(data.into_iter().flat_map(TableData::parameters))
    }
}

/// The arena of all expressions of one mechanism.
#[derive(Debug, Clone, Default)]
pub struct Graph {
    nodes: Vec<Node>,
    /// For each node, one bit for each symbol it may depend on. Symbols share bits: a bit that is not set is certain.
    reach: Vec<u128>,
    /// For each node, the number of operations from it down to its lowest symbol.
    levels: Vec<u32>,
    index: Index,
    /// Zero, once it was made: nothing is made as often.
    zero: Option<Expr>,
    derivatives: Map<(Expr, Symbol), Expr>,
    /// See [`Graph::terms_along`].
    along: Map<Expr, Arc<Map<Symbol, Vec<u32>>>>,
    names: Map<Symbol, String>,
    hints: Map<Expr, String>,
    /// See [`Graph::of_many`].
    of_many: bool,
}

impl Expr {
    pub(crate) fn index(self) -> usize {
        self.0 as usize
    }
}

impl Graph {
    /// An arena for a mechanism of many parts, which may be the same several times: there the sign of a sum depends on
    /// its simple coefficients only, and if there are none, on which sign is needed first. Other coefficients are those
    /// of a place or direction, and the expressions of two legs of a platform would differ in their signs.
    pub(crate) fn of_many() -> Graph {
        Graph {
            of_many: true,
            ..Graph::default()
        }
    }

    /// All expressions: each follows those it consists of.
    pub(crate) fn all(&self) -> impl Iterator<Item = Expr> + use<> {
        (0..self.nodes.len() as u32).map(Expr)
    }

    /// The node of an expression.
    pub fn node(&self, expr: Expr) -> &Node {
        // A slice is indexed without a call.
        &self.nodes.as_slice()[expr.0 as usize]
    }

    /// The number of operations from an expression down to its lowest symbol.
    pub fn levels(&self, expr: Expr) -> u32 {
        self.levels[expr.0 as usize]
    }

    /// The number of nodes.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether nothing was built yet.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// The display name of a symbol.
    pub fn name(&self, symbol: Symbol) -> String {
        self.names
            .get(&symbol)
            .cloned()
            .unwrap_or_else(|| match symbol {
                Symbol::Time => "t".to_owned(),
                Symbol::InverseMass(i, j) => format!("inverse_mass[{i}][{j}]"),
                Symbol::RowEntry(i, j) => format!("a[{i}][{j}]"),
                Symbol::WeightedEntry(i, j) => format!("w[{i}][{j}]"),
                Symbol::VectorEntry(i) => format!("x[{i}]"),
                Symbol::FactorEntry(i) => format!("mass[{i}]"),
                Symbol::Correction(i) => format!("correction[{i}]"),
                Symbol::Reaction(i) => format!("reaction[{i}]"),
                Symbol::Multiplier(i) => format!("lambda[{i}]"),
                other => format!("{other:?}"),
            })
    }

    /// Gives a symbol its display name.
    pub fn set_name(&mut self, symbol: Symbol, name: impl Into<String>) {
        self.names.insert(symbol, name.into());
    }

    /// Suggests a name for the temporary that will hold `expr` in generated code (the first suggestion stays).
    pub fn suggest_name(&mut self, expr: Expr, name: impl Into<String>) {
        let name = name.into();
        if let Node::Sum {
            constant: Number::ZERO,
            terms,
        } = self.node(expr)
            && let [(opposite, sign)] = **terms
            && sign.value() == -1.0
        {
            // The value that will be computed is the negative.
            self.hints
                .entry(opposite)
                .or_insert_with(|| format!("minus_{name}"));
        }
        self.hints.entry(expr).or_insert(name);
    }

    /// The suggested name of an expression.
    pub fn suggested_name(&self, expr: Expr) -> Option<&str> {
        self.hints.get(&expr).map(String::as_str)
    }

    /// The number behind an expression, if it is one.
    pub fn as_constant(&self, expr: Expr) -> Option<f64> {
        match self.node(expr) {
            Node::Constant(number) => Some(number.value()),
            _ => None,
        }
    }

    /// Whether the expression is the number zero.
    pub fn is_zero(&self, expr: Expr) -> bool {
        matches!(self.node(expr), Node::Constant(Number::ZERO))
    }

    /// Calls `visit` on each direct operand.
    pub fn for_each_operand(&self, expr: Expr, mut visit: impl FnMut(Expr)) {
        match self.node(expr) {
            Node::Constant(_) | Node::Symbol(_) => {}
            Node::Sum { terms, .. } => terms.iter().for_each(|&(term, _)| visit(term)),
            Node::Product(factors) => factors.iter().for_each(|&(factor, _)| visit(factor)),
            Node::Function(_, x) | Node::Power(x, _) | Node::Table { x, .. } => visit(*x),
            Node::Atan2(a, b) | Node::Larger(a, b) => {
                visit(*a);
                visit(*b);
            }
            Node::Law { arguments, .. } => arguments.iter().for_each(|&x| visit(x)),
        }
    }

    /// The symbols on which an expression depends, sorted.
    pub fn symbols(&self, roots: impl IntoIterator<Item = Expr>) -> Vec<Symbol> {
        let mut found = Vec::new();
        self.any_inside(roots, |node| {
            found.extend(node.symbols());
            false
        });
        found.sort_unstable();
        found.dedup();
        found
    }

    /// Whether `predicate` holds for a node of some expressions; it sees each at most once.
    fn any_inside(
        &self,
        roots: impl IntoIterator<Item = Expr>,
        mut predicate: impl FnMut(&Node) -> bool,
    ) -> bool {
        let mut seen = Seen::default();
        let mut stack: Vec<Expr> = roots.into_iter().collect();
        while let Some(expr) = stack.pop() {
            if seen.insert(expr) {
                if predicate(self.node(expr)) {
                    return true;
                }
                self.for_each_operand(expr, |operand| stack.push(operand));
            }
        }
        false
    }

    /// Whether the expression depends on a symbol for which `predicate` holds.
    pub fn depends_on(&self, expr: Expr, predicate: impl Fn(Symbol) -> bool) -> bool {
        self.any_inside([expr], |node| node.symbols().any(&predicate))
    }

    /// The same of any of some expressions; what they share is walked once.
    pub fn any_depends_on(
        &self,
        exprs: impl IntoIterator<Item = Expr>,
        predicate: impl Fn(Symbol) -> bool,
    ) -> bool {
        self.any_inside(exprs, |node| node.symbols().any(&predicate))
    }

    /// Whether the expression may depend on a symbol: `false` is certain, and known at once.
    fn may_depend_on(&self, expr: Expr, symbol: Symbol) -> bool {
        self.reach[expr.0 as usize] & reach_of(symbol) != 0
    }

    /// The symbols along which an expression changes, sorted: those inside it, with the three directions of a rotation in
    /// place of its entries.
    pub fn directions(&self, roots: impl IntoIterator<Item = Expr>) -> Vec<Symbol> {
        let mut list: Vec<Symbol> = self
            .symbols(roots)
            .into_iter()
            .flat_map(Symbol::directions)
            .collect();
        list.sort_unstable();
        list.dedup();
        list
    }

    /// Whether a user's law occurs in the expression.
    pub fn contains_law(&self, expr: Expr) -> bool {
        self.any_inside([expr], |node| matches!(node, Node::Law { .. }))
    }

    /// Whether a partial of a user's law occurs in the expression: its derivatives are not known.
    pub fn contains_partial(&self, expr: Expr) -> bool {
        let is_partial = |node: &Node| {
            matches!(
                node,
                Node::Law {
                    partial: Some(_),
                    ..
                }
            )
        };
        self.any_inside([expr], is_partial)
    }
}

/// Expressions that a walk has met. Most walks are short, and the first few are in a list.
#[derive(Default)]
struct Seen {
    few: Vec<Expr>,
    many: Set<Expr>,
}

impl Seen {
    /// Whether the expression is new.
    fn insert(&mut self, expr: Expr) -> bool {
        const FEW: usize = 16;
        let mut at = 0;
        while at < self.few.len() {
            if self.few[at].0 == expr.0 {
                return false;
            }
            at += 1;
        }
        if at < FEW {
            self.few.push(expr);
            return true;
        }
        self.many.insert(expr)
    }
}

/// The bits of a symbol and of the directions along which it changes.
fn reach_of(symbol: Symbol) -> u128 {
    let bit = |symbol: Symbol| 1 << (hash(symbol) % 128);
    symbol
        .directions()
        .fold(bit(symbol), |bits, direction| bits | bit(direction))
}
