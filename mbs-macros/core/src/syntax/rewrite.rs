//! Other expressions in the place of names.

use super::bindings::names;
use super::children::children_mut;
use super::entry::ASSEMBLY;
use super::exactly::{COORDINATE, may_be_initial};
use syn::{Expr, Ident, Stmt};

/// Where a name stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    /// For a value, in an expression.
    Value,
    /// For an initial value as a whole, or what an assembly is given.
    Argument,
    /// For a function, which may be a table.
    Function,
}

/// Puts what `of` returns in the place of each name; names of methods and members are none, and neither are the
/// parameters of closures.
pub(super) fn rewrite(expr: &mut Expr, of: &dyn Fn(&Ident, Role) -> Option<Expr>) {
    match expr {
        Expr::Path(_) => replace(expr, Role::Value, of),
        Expr::Call(call) => {
            // The path of a law is that of a function, and the first argument of an assembly is its own.
            let is_path =
                |name: &str| matches!(&*call.func, Expr::Path(path) if path.path.is_ident(name));
            let is_assembly = is_path(ASSEMBLY);
            let is_coordinate = is_path(COORDINATE);
            let skipped = usize::from(is_path("law") || is_assembly);
            for argument in call.args.iter_mut().skip(skipped) {
                match argument {
                    // Its ports may have any names.
                    Expr::Assign(assign) if is_assembly => rewrite_argument(&mut assign.right, of),
                    other if is_coordinate => rewrite_argument(other, of),
                    other => rewrite(other, of),
                }
            }
            if skipped == 0 {
                rewrite_function(&mut call.func, of);
            }
        }
        Expr::Assign(assign) => match argument(&assign.left) {
            Some(Word::Law) => rewrite_function(&mut assign.right, of),
            Some(Word::OfLanguage) => {}
            None if is_initial(&assign.left) => rewrite_argument(&mut assign.right, of),
            None => rewrite(&mut assign.right, of),
        },
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
            let inputs = closure.inputs.iter();
            inputs.for_each(|pattern| names(pattern, &mut own));
            let outer = |name: &Ident, role: Role| match own.contains(&name) {
                true => None,
                false => of(name, role),
            };
            rewrite(&mut closure.body, &outer);
        }
        other => children_mut(other)
            .into_iter()
            .for_each(|child| rewrite(child, of)),
    }
}

/// The same of an initial value, or of what an assembly is given.
pub(super) fn rewrite_argument(expr: &mut Expr, of: &dyn Fn(&Ident, Role) -> Option<Expr>) {
    match expr {
        Expr::Path(_) => replace(expr, Role::Argument, of),
        Expr::Group(group) => rewrite_argument(&mut group.expr, of),
        other => rewrite(other, of),
    }
}

/// The same where a function stands: a table, a member of a family of them, or a law with arguments.
pub(super) fn rewrite_function(expr: &mut Expr, of: &dyn Fn(&Ident, Role) -> Option<Expr>) {
    match expr {
        Expr::Index(index) => {
            rewrite_function(&mut index.expr, of);
            rewrite(&mut index.index, of);
        }
        Expr::Call(call) => {
            rewrite_function(&mut call.func, of);
            call.args
                .iter_mut()
                .for_each(|argument| rewrite(argument, of));
        }
        _ => replace(expr, Role::Function, of),
    }
}

fn replace(expr: &mut Expr, role: Role, of: &dyn Fn(&Ident, Role) -> Option<Expr>) {
    if let Expr::Path(path) = expr
        && let Some(name) = path.path.get_ident()
        && let Some(other) = of(name, role)
    {
        *expr = other;
    }
}

/// Arguments whose values are no expressions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Word {
    /// The path of a law, or a table.
    Law,
    /// A unit, or a word such as `Auto`.
    OfLanguage,
}

/// The argument of this name.
pub(super) fn word(argument: &Ident) -> Option<Word> {
    match argument.to_string().as_str() {
        "law" => Some(Word::Law),
        "unit" | "coordinates" | "interpolation" | "beyond" => Some(Word::OfLanguage),
        _ => None,
    }
}

fn is_initial(left: &Expr) -> bool {
    match left {
        Expr::Path(path) => path.path.get_ident().is_some_and(may_be_initial),
        _ => false,
    }
}

fn argument(left: &Expr) -> Option<Word> {
    match left {
        Expr::Path(path) => path.path.get_ident().and_then(word),
        _ => None,
    }
}

fn rewrite_block(statements: &mut [Stmt], of: &dyn Fn(&Ident, Role) -> Option<Expr>) {
    for statement in statements {
        if let Stmt::Expr(expr, _) = statement {
            rewrite(expr, of);
        }
    }
}
