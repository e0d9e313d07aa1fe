//! Affine expressions are recognised, and unknowns eliminated from them exactly.

use mbs_macros_core::symbolic::{
    Affine, AffineReader, Evaluator, Expr, Function, Graph, Symbol, eliminate,
};
use mbs_tests::random::Random;
use std::collections::BTreeMap;

fn unknown(graph: &mut Graph, index: u32) -> Expr {
    graph.symbol(Symbol::LocalPosition(index))
}

fn read(graph: &mut Graph, expr: Expr) -> Option<Affine> {
    AffineReader::default().read(graph, expr)
}

/// The value of an affine expression, with parameters 2, 3, 4, ….
fn value(graph: &Graph, affine: &Affine, at: &dyn Fn(Symbol) -> f64) -> f64 {
    let symbols = |symbol| match symbol {
        Symbol::Parameter(index) => f64::from(index + 2),
        other => at(other),
    };
    let laws = |_: u32, _: &[f64]| unreachable!("there is no law");
    let mut evaluator = Evaluator::new(graph, &symbols, &laws);
    let terms = affine.terms.iter();
    let sum: f64 = terms.map(|(&s, &c)| evaluator.value(c) * at(s)).sum();
    evaluator.value(affine.constant) + sum
}

fn nothing_vanishes(graph: &Graph, expr: Expr) -> bool {
    graph.as_constant(expr).is_some_and(|c| c.abs() < 1e-12)
}

#[test]
fn what_is_affine() {
    let graph = &mut Graph::default();
    let (x, y) = (unknown(graph, 0), unknown(graph, 1));
    let (a, b) = (
        graph.symbol(Symbol::Parameter(0)),
        graph.symbol(Symbol::Parameter(1)),
    );
    // a (x − 2 y + b) + sin b
    let inside = graph.linear(0.0, &[(x, 1.0), (y, -2.0), (b, 1.0)]);
    let scaled = graph.mul(a, inside);
    let sine = graph.function(Function::Sin, b);
    let sum = graph.add(scaled, sine);
    let affine = read(graph, sum).expect("it is affine");
    let at = |symbol| {
        if symbol == Symbol::LocalPosition(0) {
            5.0
        } else {
            7.0
        }
    };
    let expected = 2.0 * (5.0 - 14.0 + 3.0) + 3f64.sin();
    assert!((value(graph, &affine, &at) - expected).abs() < 1e-14);

    let time = graph.symbol(Symbol::Time);
    let input = graph.symbol(Symbol::Input(0));
    let speed = graph.symbol(Symbol::LocalVelocity(0));
    let turn = graph.symbol(Symbol::LocalRotation(3, 1));
    for others in [time, input, speed, turn] {
        let sum = graph.add(x, others);
        assert_eq!(read(graph, sum), None);
        let product = graph.mul(x, others);
        assert_eq!(read(graph, product), None);
    }
    let (square, product, quotient) = (graph.square(x), graph.mul(x, y), graph.div(a, x));
    // Derivatives vanish here, and yet they are not constant.
    let (sign, step) = (
        graph.function(Function::Sign, x),
        graph.function(Function::Step, y),
    );
    for bent in [square, product, quotient, sign, step] {
        assert_eq!(read(graph, bent), None, "{}", graph.text(bent));
    }
}

/// Random systems of integers: the solution satisfies the rows for any values of the remaining unknowns, and has the
/// right derivatives with respect to residuals.
#[test]
fn solutions_fulfil_the_rows() {
    let mut random = Random::of("solutions fulfil the rows");
    for _ in 0..200 {
        let graph = &mut Graph::default();
        let (unknowns, rows) = (6, 4);
        let systems: Vec<(usize, Affine)> = (0..rows)
            .map(|name| {
                let mut affine = Affine {
                    constant: graph.constant((9.0 * random.within(1.0)).round()),
                    terms: BTreeMap::new(),
                };
                for index in 0..unknowns {
                    let whole = (3.0 * random.within(1.0)).round();
                    // Some coefficients are parameters, by which nothing may be divided.
                    let parameter = graph.symbol(Symbol::Parameter(index));
                    let coefficient = match index < 2 {
                        true => graph.scale(whole, parameter),
                        false => graph.constant(whole),
                    };
                    if !graph.is_zero(coefficient) {
                        let symbol = Symbol::LocalPosition(index);
                        affine.terms.insert(symbol, coefficient);
                    }
                }
                (name, affine)
            })
            .collect();
        let solution = eliminate(graph, &systems, nothing_vanishes);
        let free: Vec<f64> = (0..unknowns).map(|_| random.within(1.0)).collect();
        let residuals: Vec<f64> = (0..rows).map(|_| random.within(1.0)).collect();
        let given = |symbol| match symbol {
            Symbol::LocalPosition(index) => free[index as usize],
            Symbol::Multiplier(row) => residuals[row as usize],
            other => panic!("{other:?}"),
        };
        let solved = |symbol| match solution.values.get(&symbol) {
            Some(affine) => value(graph, affine, &given),
            None => given(symbol),
        };
        for &(row, pivot) in &solution.pivots {
            let Symbol::LocalPosition(index) = pivot else {
                panic!("{pivot:?}")
            };
            assert!(index >= 2, "a division by a parameter");
            let left = value(graph, &systems[row].1, &solved);
            assert!((left - residuals[row]).abs() < 1e-9, "{left}");
        }
        for affine in solution.values.values() {
            assert!(
                affine
                    .terms
                    .keys()
                    .all(|s| !solution.values.contains_key(s))
            );
        }
    }
}

#[test]
fn pivots_and_dependent_rows() {
    let graph = &mut Graph::default();
    let [x, y, z] = [0, 1, 2].map(|index| unknown(graph, index));
    let p = graph.symbol(Symbol::Parameter(0));
    let row = |graph: &mut Graph, constant: f64, terms: &[(Expr, f64)]| {
        let sum = graph.linear(constant, terms);
        read(graph, sum).expect("it is affine")
    };
    // 5 x − y: the coefficient of size 1; x + z and y − z: the last of several; twice the first follows from the first.
    let rows = [
        row(graph, 1.0, &[(x, 5.0), (y, -1.0)]),
        row(graph, 0.0, &[(x, 1.0), (z, 1.0)]),
        row(graph, 2.0, &[(x, 10.0), (y, -2.0)]),
        row(graph, 7.0, &[(x, 10.0), (y, -2.0)]),
    ];
    let named: Vec<(usize, Affine)> = rows.into_iter().enumerate().collect();
    let solution = eliminate(graph, &named, nothing_vanishes);
    let pivots = [(0, Symbol::LocalPosition(1)), (1, Symbol::LocalPosition(2))];
    assert_eq!(solution.pivots, pivots);
    assert_eq!(solution.dependent, [vec![0, 2], vec![0, 3]]);
    // p x + p y = 0 is a condition, but division by p is not allowed.
    let sum = graph.add(x, y);
    let scaled = graph.mul(p, sum);
    let stays = [(0, read(graph, scaled).expect("it is affine"))];
    let solution = eliminate(graph, &stays, nothing_vanishes);
    assert!(solution.pivots.is_empty() && solution.dependent.is_empty());
}
