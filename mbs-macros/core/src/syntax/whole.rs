//! Whole numbers: ranges, indices, and conditions on indices.

use super::children::inner;
use syn::{BinOp, Error, Expr, ExprBinary, Lit, UnOp};

/// The whole number that an expression of literals is.
///
/// # Errors
/// It is none, or too large.
pub(super) fn whole(expr: &Expr) -> syn::Result<i64> {
    let wrong = || {
        Error::new_spanned(
            expr,
            "expected a whole number: indices and numbers such as `i - 1`, joined by + - * / %",
        )
    };
    let too_large = || Error::new_spanned(expr, "this is no whole number, or it is too large");
    match inner(expr) {
        Expr::Lit(literal) => match &literal.lit {
            Lit::Int(number) if number.suffix().is_empty() => {
                number.base10_parse().map_err(|_| too_large())
            }
            _ => Err(wrong()),
        },
        Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => {
            let number = whole(&unary.expr)?;
            number.checked_neg().ok_or_else(too_large)
        }
        Expr::Binary(binary) => {
            let (left, right) = (whole(&binary.left)?, whole(&binary.right)?);
            if right == 0 && matches!(binary.op, BinOp::Div(_) | BinOp::Rem(_)) {
                return Err(Error::new_spanned(expr, "this divides by zero"));
            }
            let result = match binary.op {
                BinOp::Add(_) => left.checked_add(right),
                BinOp::Sub(_) => left.checked_sub(right),
                BinOp::Mul(_) => left.checked_mul(right),
                BinOp::Div(_) => left.checked_div(right),
                BinOp::Rem(_) => left.checked_rem(right),
                _ => return Err(wrong()),
            };
            result.ok_or_else(too_large)
        }
        _ => Err(wrong()),
    }
}

/// Whether a condition on whole numbers holds.
///
/// # Errors
/// It is no such condition.
pub(super) fn holds(condition: &Expr) -> syn::Result<bool> {
    match inner(condition) {
        Expr::Binary(binary) => compare(condition, binary),
        Expr::Unary(unary) if matches!(unary.op, UnOp::Not(_)) => Ok(!holds(&unary.expr)?),
        _ => Err(no_condition(condition)),
    }
}

fn compare(condition: &Expr, binary: &ExprBinary) -> syn::Result<bool> {
    let numbers = || Ok::<_, Error>((whole(&binary.left)?, whole(&binary.right)?));
    Ok(match binary.op {
        BinOp::And(_) => holds(&binary.left)? && holds(&binary.right)?,
        BinOp::Or(_) => holds(&binary.left)? || holds(&binary.right)?,
        BinOp::Eq(_) => numbers().map(|(left, right)| left == right)?,
        BinOp::Ne(_) => numbers().map(|(left, right)| left != right)?,
        BinOp::Lt(_) => numbers().map(|(left, right)| left < right)?,
        BinOp::Le(_) => numbers().map(|(left, right)| left <= right)?,
        BinOp::Gt(_) => numbers().map(|(left, right)| left > right)?,
        BinOp::Ge(_) => numbers().map(|(left, right)| left >= right)?,
        _ => return Err(no_condition(condition)),
    })
}

fn no_condition(condition: &Expr) -> Error {
    Error::new_spanned(
        condition,
        "expected a condition on the index, such as `i == 0` or `i % 2 == 1 && i < 40`",
    )
}
