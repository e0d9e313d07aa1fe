//! Conditions on arguments that follow from parameters.

use super::Arguments;
use crate::model::requirements::{Requirement, Wanted};
use crate::symbolic::{Expr, Symbol};

impl Arguments<'_, '_> {
    /// Notes a condition, unless the compiler knows the values, or they change during the motion.
    pub(in crate::model) fn require(&mut self, field: &str, values: &[Expr], wanted: Wanted) {
        let (entry, argument) = (self.entry_name(), field.to_owned());
        let resolver = self.resolver();
        let varies = |&value: &Expr| {
            let parameter = |symbol: Symbol| matches!(symbol, Symbol::Parameter(_));
            resolver.graph.depends_on(value, parameter)
        };
        let moves = |&value: &Expr| {
            let moving = |symbol: Symbol| !symbol.is_parameter_like();
            resolver.graph.depends_on(value, moving)
        };
        if values.iter().any(varies) && !values.iter().any(moves) {
            resolver.requirements.push(Requirement {
                entry,
                argument,
                values: values.to_vec(),
                wanted,
            });
        }
    }
}
