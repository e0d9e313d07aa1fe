//! What stands for the parameters of a family's closure in one of its members.

use super::children::{children_mut, inner, only_expression};
use super::whole::holds;
use proc_macro2::Literal;
use syn::{Error, Expr, ExprIf, ExprLit, ExprParen, Ident, LitInt, Pat};

/// The parameters of a closure with what they stand for.
pub(super) struct Bindings<'f> {
    list: Vec<(&'f Ident, Bound<'f>)>,
}

/// What a parameter stands for.
#[derive(Clone, Copy)]
pub(super) enum Bound<'f> {
    Index(usize),
    Item(&'f Expr),
}

impl<'f> Bindings<'f> {
    /// # Errors
    /// A parameter is a pattern that does not fit.
    pub(super) fn new(
        patterns: impl IntoIterator<Item = (&'f Pat, Bound<'f>)>,
    ) -> syn::Result<Bindings<'f>> {
        let mut list = Vec::new();
        for (pattern, bound) in patterns {
            bind(pattern, bound, &mut list)?;
        }
        Ok(Bindings { list })
    }

    /// What a closure's body is in this member: one branch of every `if`. `None` where an `if` without `else` leaves
    /// the member out.
    ///
    /// # Errors
    /// The condition of an `if` is none, or a block has more than an expression.
    pub(super) fn body(&self, body: &Expr) -> syn::Result<Option<Expr>> {
        match body {
            Expr::Paren(paren) => self.body(&paren.expr),
            Expr::Block(block) => match only_expression(&block.block) {
                Some(expr) => self.body(expr),
                None => Err(no_statements(body)),
            },
            Expr::If(choice) => match self.branch(choice)? {
                Some(branch) => self.body(branch),
                None => Ok(None),
            },
            other => {
                let mut written = other.clone();
                self.write(&mut written, false)?;
                Ok(Some(written))
            }
        }
    }

    /// Puts what they stand for in the place of parameters, and branches in the place of `if`s. An operand is put in
    /// parentheses, so that an error about it is at the parameter.
    fn write(&self, expr: &mut Expr, is_operand: bool) -> syn::Result<()> {
        match expr {
            Expr::Path(path) => {
                if let Some(name) = path.path.get_ident()
                    && let Some((_, bound)) = self.list.iter().find(|(known, _)| *known == name)
                {
                    *expr = bound.at(name, is_operand);
                }
                return Ok(());
            }
            Expr::If(choice) => {
                let branch = self.branch(choice)?.cloned().ok_or_else(|| {
                    Error::new_spanned(&choice.cond, "an `if` inside an expression needs an `else`")
                })?;
                *expr = branch;
                return self.write(expr, is_operand);
            }
            Expr::Block(block) => {
                let only = only_expression(&block.block).cloned();
                *expr = only.ok_or_else(|| no_statements(block))?;
                return self.write(expr, is_operand);
            }
            // A table that the item names.
            Expr::Call(call) => {
                if let Expr::Path(path) = &*call.func
                    && let Some(name) = path.path.get_ident()
                    && let Some((_, Bound::Item(item @ (Expr::Path(_) | Expr::Index(_))))) =
                        self.list.iter().find(|(known, _)| *known == name)
                {
                    *call.func = (*item).clone();
                }
            }
            _ => {}
        }
        let are_operands = matches!(
            expr,
            Expr::Unary(_) | Expr::Binary(_) | Expr::MethodCall(_) | Expr::Field(_)
        );
        for child in children_mut(expr) {
            self.write(child, are_operands)?;
        }
        Ok(())
    }

    /// The branch of an `if` in this member; `None` if there is none.
    fn branch<'e>(&self, choice: &'e ExprIf) -> syn::Result<Option<&'e Expr>> {
        let mut condition = (*choice.cond).clone();
        self.write(&mut condition, true)?;
        if holds(&condition)? {
            let branch = only_expression(&choice.then_branch);
            return branch
                .map(Some)
                .ok_or_else(|| no_statements(&choice.then_branch));
        }
        Ok(choice.else_branch.as_ref().map(|(_, branch)| &**branch))
    }
}

impl Bound<'_> {
    /// In the place of a parameter.
    fn at(&self, parameter: &Ident, is_operand: bool) -> Expr {
        match self {
            Bound::Index(index) => {
                let mut number = Literal::usize_unsuffixed(*index);
                number.set_span(parameter.span());
                Expr::Lit(ExprLit {
                    attrs: Vec::new(),
                    lit: LitInt::from(number).into(),
                })
            }
            Bound::Item(item) if is_operand => Expr::Paren(ExprParen {
                attrs: Vec::new(),
                paren_token: syn::token::Paren(parameter.span()),
                expr: Box::new((*item).clone()),
            }),
            Bound::Item(item) => (*item).clone(),
        }
    }
}

/// The names that a closure gives to its parameters.
pub(super) fn names<'f>(pattern: &'f Pat, list: &mut Vec<&'f Ident>) {
    match pattern {
        Pat::Ident(name) => list.push(&name.ident),
        Pat::Tuple(tuple) => tuple.elems.iter().for_each(|name| names(name, list)),
        _ => {}
    }
}

fn bind<'f>(
    pattern: &'f Pat,
    bound: Bound<'f>,
    list: &mut Vec<(&'f Ident, Bound<'f>)>,
) -> syn::Result<()> {
    match (pattern, bound) {
        (Pat::Wild(_), _) => Ok(()),
        (Pat::Ident(name), bound)
            if name.by_ref.is_none() && name.mutability.is_none() && name.subpat.is_none() =>
        {
            list.push((&name.ident, bound));
            Ok(())
        }
        (Pat::Tuple(names), Bound::Item(item)) => match inner(item) {
            Expr::Tuple(items) if items.elems.len() == names.elems.len() => {
                let items = items.elems.iter().map(Bound::Item);
                let mut pairs = names.elems.iter().zip(items);
                pairs.try_for_each(|(name, item)| bind(name, item, list))
            }
            other => Err(Error::new_spanned(
                other,
                format!(
                    "expected {} values in parentheses: the closure takes this item apart",
                    names.elems.len()
                ),
            )),
        },
        (other, _) => Err(Error::new_spanned(other, "expected the name of an index")),
    }
}

fn no_statements(block: &impl quote::ToTokens) -> Error {
    Error::new_spanned(block, "expected one expression in these braces")
}
