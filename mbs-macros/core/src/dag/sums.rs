//! Sums → operations: grouped by their constant factor, k x + k y = k (x + y), with k hoisted.

use super::likeness::Slot;
use super::lower::Lowering;
use super::{Operand, Operation};
use crate::symbolic::{Expr, Number, is_simple};

/// A value that is added, or subtracted.
type Summand = (Operand, bool);

impl Lowering<'_> {
    /// constant + Σ coefficient · term.
    pub(super) fn sum(&mut self, constant: f64, terms: &[(Expr, Number)]) -> Operand {
        let mut known: Vec<(Expr, f64)> = Vec::new();
        let mut summands: Vec<Summand> = Vec::new();
        match self.likeness {
            None => self.add_terms(terms, None, &mut known, &mut summands),
            Some(likeness) => {
                let parts = likeness.parts(terms);
                for part in &parts {
                    let mut own = Vec::new();
                    self.add_terms(part, likeness.form(part), &mut known, &mut own);
                    match own.len() {
                        2.. if parts.len() > 1 => summands.push(self.total(&own)),
                        _ => summands.extend(own),
                    }
                }
            }
        }
        if !known.is_empty() || constant != 0.0 {
            let known = self.graph.linear(constant, &known);
            let is_negative =
                |value: f64| value < 0.0 && (self.likeness.is_none() || is_simple(value));
            match self.graph.as_constant(known) {
                Some(value) if is_negative(value) => {
                    summands.push((Operand::number(-value), true));
                }
                _ => summands.push((self.operand(known), false)),
            }
        }
        self.signed_sum(&summands)
    }

    /// The summands of terms; what depends on parameters only is set aside.
    fn add_terms(
        &mut self,
        terms: &[(Expr, Number)],
        form: Option<&[Slot]>,
        known: &mut Vec<(Expr, f64)>,
        summands: &mut Vec<Summand>,
    ) {
        for Group {
            coefficient,
            factor,
            parts,
            ..
        } in self.group(terms, form, known)
        {
            if coefficient == 1.0 && factor.is_none() {
                for (varying, negative) in parts {
                    summands.push((self.operand(varying), negative));
                }
                continue;
            }
            let constant = self.graph.constant(coefficient);
            let factor = match factor {
                Some(factor) => self.graph.mul(constant, factor),
                None => constant,
            };
            let factor = self.operand(factor);
            let inner: Vec<Summand> = parts
                .iter()
                .map(|&(varying, negative)| (self.operand(varying), negative))
                .collect();
            // The sign of a single term is moved outside, so that it can become a subtraction.
            let (sum, negative) = self.total(&inner);
            summands.push((self.push(Operation::Multiply(factor, sum)), negative));
        }
    }

    /// Terms as groups. Known factors of the same varying part add up first, k x + l x = (k + l) x; then varying parts
    /// with the same factor form a group, k x + k y = k (x + y).
    fn group(
        &mut self,
        terms: &[(Expr, Number)],
        form: Option<&[Slot]>,
        known: &mut Vec<(Expr, f64)>,
    ) -> Vec<Group> {
        let mut by_varying: Vec<(Expr, Vec<(Option<Expr>, f64)>, Option<Slot>)> = Vec::new();
        for (at, &(term, coefficient)) in terms.iter().enumerate() {
            let coefficient = coefficient.value();
            if self.hoist && self.hoisted.is_known(self.graph, term) {
                known.push((term, coefficient));
                continue;
            }
            let (factor, varying) = self.split(term);
            match by_varying.iter_mut().find(|(other, ..)| *other == varying) {
                Some((_, factors, _)) => factors.push((factor, coefficient)),
                None => {
                    let slot = form.map(|form| form[at]);
                    by_varying.push((varying, vec![(factor, coefficient)], slot));
                }
            }
        }
        let mut groups: Vec<Group> = Vec::new();
        for (varying, factors, mut slot) in by_varying {
            let (factor, coefficient) = match factors.as_slice() {
                [single] => *single,
                several => {
                    let one = self.graph.one();
                    let terms: Vec<_> = several
                        .iter()
                        .map(|&(factor, c)| (factor.unwrap_or(one), c))
                        .collect();
                    slot = None;
                    (Some(self.graph.linear(0.0, &terms)), 1.0)
                }
            };
            // A sign that is not the same in all sums of a kind stays with the number.
            let negative = match slot {
                Some(slot) if !slot.has_sign => slot.opposite,
                _ => coefficient < 0.0,
            };
            let coefficient = if negative { -coefficient } else { coefficient };
            let first = slot.map(|slot| slot.first);
            let part = (varying, negative);
            let key = (coefficient, factor, first);
            match groups
                .iter_mut()
                .find(|group| (group.coefficient, group.factor, group.first) == key)
            {
                Some(group) => group.parts.push(part),
                None => groups.push(Group {
                    coefficient,
                    factor,
                    first,
                    parts: vec![part],
                }),
            }
        }
        groups
    }

    /// A sum that is subtracted if all its summands are.
    fn total(&mut self, summands: &[Summand]) -> Summand {
        let negative = summands.iter().all(|(_, negative)| *negative);
        let summands: Vec<Summand> = summands
            .iter()
            .map(|&(operand, sign)| (operand, sign != negative))
            .collect();
        (self.signed_sum(&summands), negative)
    }

    fn signed_sum(&mut self, summands: &[Summand]) -> Operand {
        let positive = summands
            .iter()
            .filter(|(_, negative)| !negative)
            .map(|(operand, _)| *operand);
        let negative = summands
            .iter()
            .filter(|(_, negative)| *negative)
            .map(|(operand, _)| *operand);
        let mut total: Option<Operand> = None;
        for operand in positive {
            total = Some(match total {
                Some(before) => self.push(Operation::Add(before, operand)),
                None => operand,
            });
        }
        for operand in negative {
            total = Some(match total {
                Some(before) => self.push(Operation::Subtract(before, operand)),
                None => self.push(Operation::Negate(operand)),
            });
        }
        total.unwrap_or(Operand::number(0.0))
    }
}

/// coefficient · factor · Σ ± part.
struct Group {
    coefficient: f64,
    factor: Option<Expr>,
    /// The first of the terms that the sums of a kind group.
    first: Option<usize>,
    /// Varying parts, and whether they count negative.
    parts: Vec<(Expr, bool)>,
}
