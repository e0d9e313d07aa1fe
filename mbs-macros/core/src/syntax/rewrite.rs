//! Other expressions in the place of names.

use super::entry::ASSEMBLY;
use syn::{Expr, Ident, Pat, Stmt};

/// Puts what `of` returns in the place of each name; names of functions, methods and members are none, and neither are
/// the parameters of closures.
pub(super) fn rewrite(expr: &mut Expr, of: &dyn Fn(&Ident) -> Option<Expr>) {
    match expr {
        Expr::Path(path) => {
            if let Some(other) = path.path.get_ident().and_then(of) {
                *expr = other;
            }
        }
        Expr::Paren(paren) => rewrite(&mut paren.expr, of),
        Expr::Group(group) => rewrite(&mut group.expr, of),
        Expr::Unary(unary) => rewrite(&mut unary.expr, of),
        Expr::Binary(binary) => {
            rewrite(&mut binary.left, of);
            rewrite(&mut binary.right, of);
        }
        Expr::Array(array) => array.elems.iter_mut().for_each(|item| rewrite(item, of)),
        Expr::Tuple(tuple) => tuple.elems.iter_mut().for_each(|item| rewrite(item, of)),
        Expr::Call(call) => {
            // The path of a law is that of a function, and the first argument of an assembly is its own.
            let is_path =
                |name: &str| matches!(&*call.func, Expr::Path(path) if path.path.is_ident(name));
            let skipped = usize::from(is_path("law") || is_path(ASSEMBLY));
            let arguments = call.args.iter_mut().skip(skipped);
            arguments.for_each(|argument| rewrite(argument, of));
        }
        Expr::MethodCall(call) => {
            rewrite(&mut call.receiver, of);
            call.args
                .iter_mut()
                .for_each(|argument| rewrite(argument, of));
        }
        Expr::Field(field) => rewrite(&mut field.base, of),
        Expr::Index(index) => {
            rewrite(&mut index.expr, of);
            rewrite(&mut index.index, of);
        }
        Expr::Assign(assign) if !names_no_entry(&assign.left) => rewrite(&mut assign.right, of),
        Expr::Range(range) => {
            let ends = [&mut range.start, &mut range.end];
            ends.into_iter().flatten().for_each(|end| rewrite(end, of));
        }
        Expr::If(choice) => {
            rewrite(&mut choice.cond, of);
            rewrite_block(&mut choice.then_branch.stmts, of);
            if let Some((_, branch)) = &mut choice.else_branch {
                rewrite(branch, of);
            }
        }
        Expr::Block(block) => rewrite_block(&mut block.block.stmts, of),
        Expr::Closure(closure) => {
            let mut own = Vec::new();
            closure
                .inputs
                .iter()
                .for_each(|pattern| names(pattern, &mut own));
            let outer = |name: &Ident| match own.contains(name) {
                true => None,
                false => of(name),
            };
            rewrite(&mut closure.body, &outer);
        }
        _ => {}
    }
}

/// Whether the value of an argument of this name is a path or a unit.
fn names_no_entry(argument: &Expr) -> bool {
    matches!(argument, Expr::Path(path) if path.path.get_ident().is_some_and(is_word))
}

/// The same.
pub(super) fn is_word(argument: &Ident) -> bool {
    argument == "law" || argument == "unit"
}

fn rewrite_block(statements: &mut [Stmt], of: &dyn Fn(&Ident) -> Option<Expr>) {
    for statement in statements {
        if let Stmt::Expr(expr, _) = statement {
            rewrite(expr, of);
        }
    }
}

fn names(pattern: &Pat, list: &mut Vec<Ident>) {
    match pattern {
        Pat::Ident(name) => list.push(name.ident.clone()),
        Pat::Tuple(tuple) => tuple.elems.iter().for_each(|name| names(name, list)),
        _ => {}
    }
}
