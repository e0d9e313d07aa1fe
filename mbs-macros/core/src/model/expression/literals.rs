//! Numbers with their units.

use crate::diagnostics::{Place, did_you_mean};
use crate::dimension::{JOINED, UNITS, abbreviated, foreign, unit};
use crate::model::resolver::Resolver;
use crate::model::value::Value;
use syn::Lit;

impl Resolver<'_> {
    pub(super) fn literal(&mut self, literal: &Lit) -> Option<Value> {
        let (digits, suffix) = match literal {
            Lit::Float(number) => (
                number.base10_digits().to_owned(),
                number.suffix().to_owned(),
            ),
            Lit::Int(number) => (
                number.base10_digits().to_owned(),
                number.suffix().to_owned(),
            ),
            other => return self.fail(Place::of(other), "expected a number"),
        };
        let number = match digits.parse::<f64>() {
            Ok(number) if number.is_finite() => number,
            _ => {
                return self.fail(
                    Place::of(literal),
                    "this number is too large; numbers go up to 1e308",
                );
            }
        };
        if suffix.is_empty() {
            let expr = self.graph.constant(number);
            return Some(Value::Scalar(expr, None));
        }
        let Some((factor, dimension)) = unit(&suffix) else {
            let name = suffix.trim_start_matches('_');
            if let Some(advice) = foreign(name) {
                return self.fail(
                    Place::of(literal),
                    format!("there is no unit `{name}`: {advice}"),
                );
            }
            let known = UNITS.iter().map(|(name, ..)| *name);
            let hint = match abbreviated(name) {
                Some(meant) => format!("; did you mean `{meant}`?"),
                None => did_you_mean(name, known.clone().chain(JOINED)),
            };
            return self.fail(
                Place::of(literal),
                format!(
                    "there is no unit `{name}`{hint} (units: {}; joined by `_`, divided after `per`, as in `9.81_m_per_s2`)",
                    known.collect::<Vec<_>>().join(", ")
                ),
            );
        };
        let expr = self.graph.constant(number * factor);
        Some(Value::Scalar(expr, Some(dimension)))
    }
}
