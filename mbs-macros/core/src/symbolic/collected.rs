//! Equal factors and terms, put together. Loops over arrays, because compilers run unoptimised.

use super::Expr;

/// Larger powers of one factor are not put together.
const LARGEST: i32 = 1 << 24;

/// Whether the powers of factors times another power are not too large.
pub(super) fn are_multiplied(factors: &[(Expr, i32)], power: i32) -> bool {
    let is_small = |power: i32| (-LARGEST..=LARGEST).contains(&power);
    power == 1
        || factors
            .iter()
            .all(|(_, own)| own.checked_mul(power).is_some_and(is_small))
}

/// Puts a factor into a sorted list.
pub(super) fn put_factor(flat: &mut Vec<(Expr, i32)>, factor: Expr, power: i32) {
    let mut at = flat.len();
    while at > 0 && flat[at - 1].0.0 > factor.0 {
        at -= 1;
    }
    if at > 0
        && flat[at - 1].0.0 == factor.0
        && let sum = flat[at - 1].1.saturating_add(power)
        && (-LARGEST..=LARGEST).contains(&sum)
    {
        flat[at - 1].1 = sum;
        if sum == 0 {
            flat.remove(at - 1);
        }
        return;
    }
    flat.insert(at, (factor, power));
}

/// Sorts by term and adds up coefficients.
pub(super) fn collect(terms: &mut Vec<(Expr, f64)>) {
    sort(terms);
    let mut kept = 0;
    let mut at = 0;
    while at < terms.len() {
        let (term, mut coefficient) = terms[at];
        at += 1;
        let mut total = Total::of(coefficient);
        while at < terms.len() && terms[at].0.0 == term.0 {
            total.add(terms[at].1);
            coefficient = total.value();
            at += 1;
        }
        if coefficient != 0.0 {
            terms[kept] = (term, coefficient);
            kept += 1;
        }
    }
    terms.truncate(kept);
}

/// Sorts terms, of which there are few in most sums.
fn sort(terms: &mut [(Expr, f64)]) {
    const FEW: usize = 16;
    if terms.len() > FEW {
        terms.sort_by_key(|&(term, _)| term);
        return;
    }
    let mut next = 1;
    while next < terms.len() {
        let mut at = next;
        while at > 0 && terms[at - 1].0.0 > terms[at].0.0 {
            terms.swap(at - 1, at);
            at -= 1;
        }
        next += 1;
    }
}

/// A sum of numbers that cancel exactly, if they cancel but for their round-off: what vanishes for one leg of a
/// platform vanishes for the others, whose directions are other numbers.
pub(super) struct Total {
    sum: f64,
    /// Σ |number|.
    size: f64,
}

impl Total {
    pub(super) fn of(number: f64) -> Total {
        Total {
            sum: number,
            size: number.abs(),
        }
    }

    pub(super) fn add(&mut self, number: f64) {
        self.sum += number;
        self.size += number.abs();
    }

    pub(super) fn value(&self) -> f64 {
        // A sum that is not finite is found where values are checked.
        if self.sum.is_finite() && self.sum.abs() <= 4.0 * f64::EPSILON * self.size {
            0.0
        } else {
            self.sum
        }
    }
}
