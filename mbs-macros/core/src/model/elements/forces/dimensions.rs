//! Dimensions that follow from that of what a force acts on.

use crate::diagnostics::Place;
use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::symbolic::Expr;

impl Arguments<'_, '_> {
    /// A scalar of this dimension, where that is known.
    pub(super) fn of_dimension(&mut self, field: &str, wanted: Option<Dimension>) -> Option<Expr> {
        let (value, found) = self.quantity(field)?;
        if let (Some(wanted), Some(syntax)) = (wanted, self.syntax(field)) {
            self.check_dimension(field, found, wanted, Place::of(syntax))?;
        }
        Some(value)
    }

    /// The same, 0 if it was not given, and not negative.
    pub(super) fn not_negative(&mut self, field: &str, wanted: Option<Dimension>) -> Option<Expr> {
        if !self.has(field) {
            return Some(self.graph().zero());
        }
        let value = self.of_dimension(field, wanted)?;
        self.refuse_negative(field, value)?;
        Some(value)
    }
}
