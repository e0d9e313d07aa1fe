//! The expressions inside an expression.

use syn::{Block, Expr, Stmt};

/// Without parentheses around it.
pub fn inner(mut expr: &Expr) -> &Expr {
    loop {
        expr = match expr {
            Expr::Paren(paren) => &paren.expr,
            Expr::Group(group) => &group.expr,
            other => return other,
        };
    }
}

/// The operands, arguments and items of an expression of the language; names of functions and methods are none, but for a
/// table of a family.
pub fn children(expr: &Expr) -> Vec<&Expr> {
    match expr {
        Expr::Paren(paren) => vec![&paren.expr],
        Expr::Group(group) => vec![&group.expr],
        Expr::Unary(unary) => vec![&unary.expr],
        Expr::Binary(binary) => vec![&binary.left, &binary.right],
        Expr::Array(array) => array.elems.iter().collect(),
        Expr::Tuple(tuple) => tuple.elems.iter().collect(),
        Expr::Call(call) => {
            let table = matches!(*call.func, Expr::Index(_)).then_some(&*call.func);
            table.into_iter().chain(&call.args).collect()
        }
        Expr::MethodCall(call) => std::iter::once(&*call.receiver).chain(&call.args).collect(),
        Expr::Field(field) => vec![&field.base],
        Expr::Index(index) => vec![&index.expr, &index.index],
        Expr::Assign(assign) => vec![&assign.right],
        _ => Vec::new(),
    }
}

/// The same, to be changed.
pub(super) fn children_mut(expr: &mut Expr) -> Vec<&mut Expr> {
    match expr {
        Expr::Paren(paren) => vec![&mut paren.expr],
        Expr::Group(group) => vec![&mut group.expr],
        Expr::Unary(unary) => vec![&mut unary.expr],
        Expr::Binary(binary) => vec![&mut binary.left, &mut binary.right],
        Expr::Array(array) => array.elems.iter_mut().collect(),
        Expr::Tuple(tuple) => tuple.elems.iter_mut().collect(),
        Expr::Call(call) => {
            let table = matches!(*call.func, Expr::Index(_)).then_some(&mut *call.func);
            table.into_iter().chain(&mut call.args).collect()
        }
        Expr::MethodCall(call) => std::iter::once(&mut *call.receiver)
            .chain(&mut call.args)
            .collect(),
        Expr::Field(field) => vec![&mut field.base],
        Expr::Index(index) => vec![&mut index.expr, &mut index.index],
        Expr::Assign(assign) => vec![&mut assign.right],
        _ => Vec::new(),
    }
}

/// The expression of a block that has nothing else.
pub(super) fn only_expression(block: &Block) -> Option<&Expr> {
    match block.stmts.as_slice() {
        [Stmt::Expr(expr, None)] => Some(expr),
        _ => None,
    }
}
