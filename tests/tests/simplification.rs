//! The canonical form keeps values: random expressions, built through the constructors of the graph and evaluated
//! directly, agree; so do derivatives, substitutions and programs.

use mbs_macros_core::symbolic::{Evaluator, Expr, Function, Graph, Node, Substitution, Symbol};
use proptest::prelude::*;

/// An expression that nothing has simplified.
#[derive(Debug, Clone)]
enum Tree {
    Number(i32),
    Variable(u32),
    Linear(i32, Vec<(Tree, i32)>),
    Product(Vec<(Tree, i32)>),
    Call(Function, Box<Tree>),
    Atan2(Box<Tree>, Box<Tree>),
    Power(Box<Tree>, i32),
}

const VARIABLES: u32 = 4;
/// Functions that are smooth and finite for the arguments in the trees; the others get an argument in their domain.
const FUNCTIONS: [Function; 15] = [
    Function::Sin,
    Function::Cos,
    Function::Tan,
    Function::Asin,
    Function::Acos,
    Function::Atan,
    Function::Sqrt,
    Function::Exp,
    Function::Ln,
    Function::Sinh,
    Function::Cosh,
    Function::Tanh,
    Function::Abs,
    Function::Sign,
    Function::Step,
];

/// Coefficients are eighths: exact in binary, so that sums collect without rounding.
fn eighths(n: i32) -> f64 {
    f64::from(n) / 8.0
}

/// Exponents that are no integers.
fn exponent(n: i32) -> f64 {
    f64::from(n) + 0.5
}

fn trees() -> impl Strategy<Value = Tree> {
    let leaf = prop_oneof![
        1 => (-16..=16).prop_map(Tree::Number),
        3 => (0..VARIABLES).prop_map(Tree::Variable),
    ];
    leaf.prop_recursive(5, 40, 4, |inner| {
        let boxed = inner.clone().prop_map(Box::new);
        prop_oneof![
            4 => (
                prop_oneof![Just(0), -8..=8],
                prop::collection::vec((inner.clone(), prop_oneof![Just(8), Just(-8), -12..=12]), 1..4)
            )
                .prop_map(|(constant, terms)| Tree::Linear(constant, terms)),
            4 => prop::collection::vec((inner.clone(), prop_oneof![4 => Just(1), 2 => Just(2), 1 => Just(3), 1 => Just(-1)]), 1..4)
                .prop_map(Tree::Product),
            3 => (0..FUNCTIONS.len(), boxed.clone()).prop_map(|(f, x)| Tree::Call(FUNCTIONS[f], x)),
            // Squares of sines and cosines of the same angle, so that sin² + cos² = 1 occurs.
            2 => (boxed.clone(), prop_oneof![Just(8), -8..=8], prop_oneof![Just(8), -8..=8]).prop_map(|(x, a, b)| {
                let square = |f| Tree::Product(vec![(Tree::Call(f, x.clone()), 2)]);
                Tree::Linear(0, vec![(square(Function::Sin), a), (square(Function::Cos), b)])
            }),
            1 => (boxed.clone(), boxed.clone()).prop_map(|(y, x)| Tree::Atan2(y, x)),
            1 => (boxed, -2..=2).prop_map(|(x, n)| Tree::Power(x, n)),
        ]
    })
}

/// The argument with which a function is called: inside its domain, and away from where it is not smooth.
enum Inside {
    AsItIs,
    /// 0.9 sin x
    Bounded,
    /// x² + 1
    Positive,
}

fn inside(function: Function) -> Inside {
    match function {
        Function::Asin
        | Function::Acos
        | Function::Tan
        | Function::Exp
        | Function::Sinh
        | Function::Cosh => Inside::Bounded,
        Function::Sqrt | Function::Ln | Function::Abs | Function::Sign | Function::Step => {
            Inside::Positive
        }
        _ => Inside::AsItIs,
    }
}

/// The value, and a bound of the intermediate magnitudes.
fn naive(tree: &Tree, variables: &[f64]) -> (f64, f64) {
    match tree {
        Tree::Number(n) => (eighths(*n), eighths(n.abs())),
        Tree::Variable(i) => (variables[*i as usize], variables[*i as usize].abs()),
        Tree::Linear(constant, terms) => terms.iter().fold(
            (eighths(*constant), eighths(constant.abs())),
            |(value, size), (term, c)| {
                let (x, x_size) = naive(term, variables);
                (value + eighths(*c) * x, size + eighths(c.abs()) * x_size)
            },
        ),
        Tree::Product(factors) => factors
            .iter()
            .fold((1.0, 1.0), |(value, size), (factor, p)| {
                let (x, x_size) = naive(factor, variables);
                match p {
                    // Instead of 1/x: x/(x² + 1), whose denominator is not zero.
                    -1 => (value / (x * x + 1.0), size),
                    p => (value * x.powi(*p), size * x_size.powi(*p)),
                }
            }),
        Tree::Call(function, x) => {
            let (x, size) = naive(x, variables);
            let (argument, argument_size) = match inside(*function) {
                Inside::AsItIs => (x, size),
                Inside::Bounded => (0.9 * x.sin(), size),
                Inside::Positive => (x * x + 1.0, size * size + 1.0),
            };
            let value = function.evaluate(argument);
            // The slopes of all of them are moderate where they are called.
            (value, value.abs() + 4.0 * argument_size)
        }
        Tree::Atan2(y, x) => {
            let ((y, a), (x, b)) = (naive(y, variables), naive(x, variables));
            (y.atan2(x * x + 1.0), 1.0 + a + b * b)
        }
        Tree::Power(x, n) => {
            let (x, size) = naive(x, variables);
            let value = (x * x + 1.0).powf(exponent(*n));
            (value, (size * size + 1.0).powf(exponent(*n).abs()))
        }
    }
}

fn build(graph: &mut Graph, tree: &Tree) -> Expr {
    let positive = |graph: &mut Graph, x: Expr| {
        let square = graph.square(x);
        graph.linear(1.0, &[(square, 1.0)])
    };
    match tree {
        Tree::Number(n) => graph.constant(eighths(*n)),
        Tree::Variable(i) => graph.symbol(Symbol::Coordinate(*i)),
        Tree::Linear(constant, terms) => {
            let terms: Vec<_> = terms
                .iter()
                .map(|(term, c)| (build(graph, term), eighths(*c)))
                .collect();
            graph.linear(eighths(*constant), &terms)
        }
        Tree::Product(factors) => {
            let factors: Vec<_> = factors
                .iter()
                .map(|(factor, p)| {
                    let x = build(graph, factor);
                    if *p == -1 {
                        (positive(graph, x), -1)
                    } else {
                        (x, *p)
                    }
                })
                .collect();
            graph.product(&factors)
        }
        Tree::Call(function, x) => {
            let x = build(graph, x);
            let argument = match inside(*function) {
                Inside::AsItIs => x,
                Inside::Bounded => {
                    let sin = graph.function(Function::Sin, x);
                    graph.scale(0.9, sin)
                }
                Inside::Positive => positive(graph, x),
            };
            graph.function(*function, argument)
        }
        Tree::Atan2(y, x) => {
            let (y, x) = (build(graph, y), build(graph, x));
            let x = positive(graph, x);
            graph.atan2(y, x)
        }
        Tree::Power(x, n) => {
            let x = build(graph, x);
            let base = positive(graph, x);
            graph.power(base, exponent(*n))
        }
    }
}

fn value(graph: &Graph, expr: Expr, variables: &[f64]) -> f64 {
    let symbols = |symbol| match symbol {
        Symbol::Coordinate(i) => variables[i as usize],
        other => panic!("{other:?}"),
    };
    Evaluator::new(graph, &symbols, &|_, _| unreachable!()).value(expr)
}

/// Makes the node of an expression again, from its operands.
fn rebuild(graph: &mut Graph, expr: Expr) -> Expr {
    match graph.node(expr).clone() {
        Node::Constant(number) => graph.constant(number.value()),
        Node::Symbol(symbol) => graph.symbol(symbol),
        Node::Sum { constant, terms } => {
            let terms: Vec<_> = terms
                .iter()
                .map(|&(term, coefficient)| (rebuild(graph, term), coefficient.value()))
                .collect();
            graph.linear(constant.value(), &terms)
        }
        Node::Product(factors) => {
            let factors: Vec<_> = factors
                .iter()
                .map(|&(factor, p)| (rebuild(graph, factor), p))
                .collect();
            graph.product(&factors)
        }
        Node::Function(function, x) => {
            let x = rebuild(graph, x);
            graph.function(function, x)
        }
        Node::Atan2(y, x) => {
            let (y, x) = (rebuild(graph, y), rebuild(graph, x));
            graph.atan2(y, x)
        }
        Node::Larger(a, b) => {
            let (a, b) = (rebuild(graph, a), rebuild(graph, b));
            graph.larger(a, b)
        }
        Node::Power(x, exponent) => {
            let x = rebuild(graph, x);
            graph.power(x, exponent.value())
        }
        Node::Law { .. } | Node::Table { .. } => unreachable!("the trees call no laws"),
    }
}

fn variables() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(
        (-200..=200i32).prop_map(|n| f64::from(n) / 97.0),
        VARIABLES as usize,
    )
}

/// Whether the magnitudes of a tree are so small that rounding has no effect.
fn tame(size: f64) -> bool {
    size.is_finite() && size < 1e9
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, rng_seed: proptest::test_runner::RngSeed::Fixed(20), ..ProptestConfig::default() })]

    #[test]
    fn constructors_keep_values(tree in trees(), at in variables()) {
        let (expected, size) = naive(&tree, &at);
        prop_assume!(tame(size));
        let mut graph = Graph::default();
        let expr = build(&mut graph, &tree);
        let found = value(&graph, expr, &at);
        prop_assert!((found - expected).abs() <= 1e-12 * (1.0 + size), "{found} against {expected}: {}", graph.text(expr));
    }

    #[test]
    fn the_canonical_form_is_a_fixed_point(tree in trees()) {
        let mut graph = Graph::default();
        let expr = build(&mut graph, &tree);
        let again = rebuild(&mut graph, expr);
        prop_assert_eq!(again, expr, "{} became {}", graph.text(expr), graph.text(again));
    }

    #[test]
    fn substituting_is_evaluating(tree in trees(), by in trees(), at in variables()) {
        let (inner, inner_size) = naive(&by, &at);
        let mut changed = at.clone();
        changed[1] = inner;
        let (expected, size) = naive(&tree, &changed);
        prop_assume!(tame(size) && tame(inner_size) && inner_size < 1e3);
        let mut graph = Graph::default();
        let expr = build(&mut graph, &tree);
        let mut substitution = Substitution::default();
        substitution.insert(Symbol::Coordinate(1), build(&mut graph, &by));
        let result = graph.substitute(expr, &mut substitution);
        let found = value(&graph, result, &at);
        // Values of `by` differ by rounding, which the tree amplifies.
        let amplified = 1.0 + size * (1.0 + inner_size);
        prop_assert!((found - expected).abs() <= 1e-11 * amplified, "{found} against {expected}: {}", graph.text(result));
    }

    #[test]
    fn derivatives_are_slopes(tree in trees(), at in variables(), by in 0..VARIABLES) {
        let (_, size) = naive(&tree, &at);
        prop_assume!(size < 1e4);
        let mut graph = Graph::default();
        let expr = build(&mut graph, &tree);
        let slope = graph.derivative(expr, Symbol::Coordinate(by));
        let found = value(&graph, slope, &at);
        let along = |s: f64| {
            let mut moved = at.clone();
            moved[by as usize] += s;
            naive(&tree, &moved).0
        };
        let difference = |h: f64| (along(-2.0 * h) - along(2.0 * h) + 8.0 * (along(h) - along(-h))) / (12.0 * h);
        let slopes = [1e-2, 2e-3, 4e-4, 8e-5, 1.6e-5].map(difference);
        let (best, spread) = slopes
            .windows(2)
            .map(|pair| (pair[1], (pair[1] - pair[0]).abs()))
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .expect("five steps");
        let resolution = 1e-8 * (1.0 + size + best.abs());
        // If the differences disagree among themselves, there is no test.
        prop_assume!(spread <= resolution);
        prop_assert!((found - best).abs() <= 10.0 * resolution, "{found} against {best}: {}", graph.text(slope));
    }

    #[test]
    fn programs_keep_values(trees in prop::collection::vec(trees(), 1..4), at in variables()) {
        let values: Vec<_> = trees.iter().map(|tree| naive(tree, &at)).collect();
        prop_assume!(values.iter().all(|(_, size)| tame(*size)));
        let mut graph = Graph::default();
        let exprs: Vec<_> = trees.iter().map(|tree| build(&mut graph, tree)).collect();
        // Half of the variables are parameters here, so that constants are hoisted.
        let mut substitution = Substitution::default();
        for i in 0..VARIABLES / 2 {
            let parameter = graph.symbol(Symbol::Parameter(i));
            substitution.insert(Symbol::Coordinate(i), parameter);
        }
        let exprs: Vec<_> = exprs.into_iter().map(|expr| graph.substitute(expr, &mut substitution)).collect();
        let found = program::run(graph, &exprs, &at);
        for ((found, (expected, size)), tree) in found.iter().zip(&values).zip(&trees) {
            prop_assert!((found - expected).abs() <= 1e-12 * (1.0 + size), "{found} against {expected}: {tree:?}");
        }
    }
}

/// A sum whose coefficients collect to one is flattened like any other.
#[test]
fn a_sum_that_collects_to_itself_is_flat() {
    let mut graph = Graph::default();
    let [x, y, z] = [0, 1, 2].map(|i| graph.symbol(Symbol::Coordinate(i)));
    let sum = graph.add(x, y);
    let terms = [(sum, 3.0), (z, 1.0)];
    let first = graph.linear(0.0, &terms);
    for rest in [[(sum, -2.0)], [(sum, -4.0)]] {
        let expr = graph.linear(0.0, &[(first, 1.0), rest[0]]);
        assert_eq!(rebuild(&mut graph, expr), expr, "{}", graph.text(expr));
    }
}

/// Expressions as the outputs of an otherwise empty system.
mod program {
    use super::*;
    use mbs_macros_core::dag::{self, Place, Run};
    use mbs_macros_core::{derivatives, equations::System};
    use std::collections::BTreeMap;

    pub fn run(mut graph: Graph, outputs: &[Expr], variables: &[f64]) -> Vec<f64> {
        let zero = graph.zero();
        let system = System {
            held: Vec::new(),
            requirements: Vec::new(),
            scales: Vec::new(),
            graph,
            size: 0,
            mass: BTreeMap::new(),
            potential: zero,
            forces: Vec::new(),
            force_parts: mbs_macros_core::equations::ForceParts {
                potential_slopes: Vec::new(),
                loads: Vec::new(),
            },
            power: zero,
            rows: Vec::new(),
            vacuous: Vec::new(),
            constant_mass: true,
            reduction: Substitution::default(),
            reactions: Vec::new(),
            outputs: outputs.to_vec(),
            unknown_readings: Vec::new(),
            events: Vec::new(),
            points: Vec::new(),
            kinetic: None,
            layout: Default::default(),
            unwrapped_angles: Vec::new(),
            unwrapped_rates: Vec::new(),
        };
        let derived = derivatives::derive(system, Vec::new());
        let program = dag::lower(&derived);
        let symbols = |symbol| match symbol {
            Symbol::Coordinate(i) | Symbol::Parameter(i) => variables[i as usize],
            other => panic!("{other:?}"),
        };
        let mut constants = vec![f64::NAN; program.constants.len()];
        let laws = |_: u32, _: &[f64]| unreachable!();
        let preparation = Run {
            symbols: &symbols,
            constants: &[],
            laws: &laws,
        };
        for (output, value) in preparation.function(&program.preparation[0]) {
            if let Place::Constant(slot) = output.place {
                constants[slot] = value;
            }
        }
        let run = Run {
            symbols: &symbols,
            constants: &constants,
            laws: &laws,
        };
        let function = program
            .functions
            .iter()
            .find(|function| function.name == "outputs");
        run.function(function.expect("every program has outputs"))
            .into_iter()
            .map(|(_, value)| value)
            .collect()
    }
}

/// What vanishes for one leg of a platform vanishes for the others, whose directions are other numbers.
#[test]
fn sums_that_cancel_but_for_their_round_off_are_zero() {
    assert_ne!(0.1 + 0.2 - 0.3, 0.0);
    let mut graph = Graph::default();
    let x = graph.symbol(Symbol::Coordinate(0));
    let terms = [0.1, 0.2, -0.3].map(|c| graph.linear(c, &[(x, c)]));
    let sum = graph.sum(terms);
    assert!(graph.is_zero(sum), "{}", graph.text(sum));
    let small = graph.linear(1e-20, &[(x, 1e-20)]);
    assert!(!graph.is_zero(small));
}
