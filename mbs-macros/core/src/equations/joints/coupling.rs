//! Two scalars keep a linear relation.

use super::{
    Joint, JointEquations, JointRow, Level, ReactionComponent, affine_relation,
    multiplier_dimension,
};
use crate::model::{Arguments, Dimension};
use crate::symbolic::{Expr, Graph};

#[derive(Debug)]
struct Coupling {
    first: Expr,
    second: Expr,
    ratio: Expr,
    offset: Expr,
    dimension: Option<Dimension>,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    super::holonomic::check(arguments, "first")?;
    super::holonomic::check(arguments, "second")?;
    let (first, from) = arguments.quantity("first")?;
    let (second, to) = arguments.quantity("second")?;
    for (field, expr) in [("first", first), ("second", second)] {
        if !super::holonomic::moves(arguments, expr) {
            return arguments.fail(
                field,
                "this does not depend on any position: a coupling takes two expressions that move",
            );
        }
    }
    let (ratio, offset) = (
        arguments.scalar_or("ratio", 1.0)?,
        arguments.scalar_or("offset", 0.0)?,
    );
    if let (Some(from), Some(to), false) = (from, to, arguments.has("ratio"))
        && from != to
    {
        return arguments.fail(
            "second",
            format!("this is {to}, but the first is {from}; give a `ratio =` with its unit"),
        );
    }
    if arguments.has("ratio")
        && let (Some((_, Some(unit))), Some(from), Some(to)) =
            (arguments.quantity("ratio"), from, to)
        && unit.times(from) != to
    {
        return arguments.fail(
            "ratio",
            format!("the ratio takes {from} to {to}: it is {}", to.over(from)),
        );
    }
    Some(Box::new(Coupling {
        first,
        second,
        ratio,
        offset,
        dimension: to,
    }))
}

impl Joint for Coupling {
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        let expr = affine_relation(graph, self.first, self.second, self.ratio, self.offset);
        let terms = vec![(0, graph.one())];
        let dimension = multiplier_dimension(Level::Position, self.dimension);
        JointEquations {
            rows: vec![JointRow {
                suffix: String::new(),
                level: Level::Position,
                expr,
                dimension: self.dimension,
            }],
            reactions: vec![ReactionComponent {
                name: "lambda",
                dimension,
                terms,
            }],
        }
    }
}
