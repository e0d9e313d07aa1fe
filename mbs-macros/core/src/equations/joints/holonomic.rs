//! φ(q, t) = 0, written as an expression.

use super::{Joint, JointEquations, JointRow, Level, ReactionComponent, multiplier_dimension};
use crate::model::{Arguments, Dimension};
use crate::symbolic::{Expr, Graph, Symbol};

/// Conditions written as expressions, at one level.
#[derive(Debug)]
pub(super) struct Conditions {
    pub level: Level,
    pub list: Vec<(Expr, Option<Dimension>)>,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    check(arguments, "value")?;
    let conditions = arguments.conditions("value")?;
    for &(span, expr, _) in &conditions {
        if !moves(arguments, expr) {
            return arguments.fail_at(
                span,
                "this condition does not depend on any position: nothing could fulfil it",
            );
        }
    }
    let list = conditions
        .into_iter()
        .map(|(_, expr, dimension)| (expr, dimension))
        .collect();
    Some(Box::new(Conditions {
        level: Level::Position,
        list,
    }))
}

/// Whether an expression depends on positions.
pub(super) fn moves(arguments: &mut Arguments, expr: Expr) -> bool {
    arguments
        .graph()
        .depends_on(expr, Symbol::is_local_position)
}

/// A condition on positions may not have velocities, inputs, or laws (whose second derivatives nobody supplies).
pub(super) fn check(arguments: &mut Arguments, field: &str) -> Option<()> {
    arguments.refuse(
        field,
        &Symbol::is_velocity,
        "a holonomic condition has no velocities; declare it as `Nonholonomic`, or write the position it integrates to",
    )?;
    arguments.refuse(
        field,
        &|symbol| matches!(symbol, Symbol::Input(_)),
        "a condition on positions cannot follow an input, whose rate is unknown; write it as a function of `t`, or let a force follow the input",
    )?;
    arguments.refuse_laws(field)
}

impl Joint for Conditions {
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        let one = graph.one();
        let several = self.list.len() > 1;
        let mut equations = JointEquations::default();
        for (slot, &(expr, dimension)) in self.list.iter().enumerate() {
            let suffix = if several {
                format!("[{slot}]")
            } else {
                String::new()
            };
            equations.rows.push(JointRow {
                suffix,
                level: self.level,
                expr,
                dimension,
            });
            equations.reactions.push(ReactionComponent {
                name: "lambda",
                dimension: multiplier_dimension(self.level, dimension),
                terms: vec![(slot, one)],
            });
        }
        equations
    }
}
