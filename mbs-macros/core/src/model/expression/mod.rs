//! Expressions of the declaration → symbolic values, with dimensions.

pub(in crate::model) mod functions;
mod literals;
mod members;
mod operators;

use self::operators::{POWERS, comparison};
use super::Vector;
use super::resolver::Resolver;
use super::value::Value;
use crate::diagnostics::Place;
use crate::dimension::Dimension;
use crate::schema::World;
use crate::symbolic::{Expr, Graph, Node, Symbol};
use crate::syntax::{MAX_DEPTH, MAX_LEVELS, TOO_DEEP, children, reference};
use syn::spanned::Spanned;
use syn::{Expr as Syntax, Member, UnOp};

impl Resolver<'_> {
    /// The value of an expression; `None` after recording what is wrong with it.
    pub(in crate::model) fn evaluate(&mut self, syntax: &Syntax) -> Option<Value> {
        if self.depth > MAX_DEPTH {
            return self.fail(Place::of(syntax), TOO_DEEP);
        }
        self.depth += 1;
        let value = self.evaluate_any(syntax);
        self.depth -= 1;
        let value = value?;
        let finite = |x: Expr| match *self.graph.node(x) {
            Node::Constant(number) => number.value().is_finite(),
            Node::Sum {
                constant,
                ref terms,
            } => {
                let coefficients = terms.iter().map(|&(_, coefficient)| coefficient);
                coefficients
                    .chain([constant])
                    .all(|number| number.value().is_finite())
            }
            // Where these have a value, they have become that number.
            Node::Function(_, x) | Node::Power(x, _) => self.graph.as_constant(x).is_none(),
            _ => true,
        };
        if !value.expressions().into_iter().all(finite) {
            return self.fail(
                Place::of(syntax),
                "the result of this is no finite number; check its arguments",
            );
        }
        let levels = value.expressions().into_iter();
        let levels = levels.map(|x| self.graph.levels(x)).max();
        if let Some(levels) = levels.filter(|&levels| levels > MAX_LEVELS) {
            return self.fail(
                Place::of(syntax),
                format!("this expression is {levels} operations deep, counted through the names that it uses, and {MAX_LEVELS} are the most; write part of it in closed form or as a law"),
            );
        }
        Some(value)
    }

    fn evaluate_any(&mut self, syntax: &Syntax) -> Option<Value> {
        match syntax {
            Syntax::Paren(inner) => self.evaluate(&inner.expr),
            Syntax::Group(inner) => self.evaluate(&inner.expr),
            Syntax::Lit(literal) => self.literal(&literal.lit),
            Syntax::Path(_) | Syntax::Index(_) => match (reference(syntax), syntax) {
                (Some(Ok(reference)), _) => self.lookup(&reference, Place::of(syntax)),
                (Some(Err(error)), _) => self.fail_with(error),
                (None, Syntax::Path(_)) => self.fail(
                    Place::of(syntax),
                    "only names of this mechanism can stand here; paths go into `law(path, …)`",
                ),
                (None, _) => {
                    // What it follows may have a mistake of its own, such as the index of an assembly.
                    if let Syntax::Index(index) = syntax {
                        self.evaluate(&index.expr)?;
                    }
                    self.fail(
                        Place::of(syntax),
                        "an index follows the name of a family, as in `crank[3].b`",
                    )
                }
            },
            Syntax::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => {
                let value = self.evaluate(&unary.expr)?;
                self.negate(value, Place::of(unary))
            }
            Syntax::Unary(unary) if matches!(unary.op, UnOp::Deref(_)) => {
                self.fail(Place::of(unary), POWERS)
            }
            // An argument whose value was forgotten.
            Syntax::Assign(equation) if self.errors.are_at(Place::of(&equation.left)) => None,
            Syntax::Assign(equation) => {
                self.compared("=", Place::of(&equation.eq_token))
            }
            Syntax::If(choice) => self.fail(
                Place::of(choice),
                "an `if` decides by indices alone; a value that changes with quantities is a product with step(x), or max(a, b) or min(a, b)",
            ),
            Syntax::Binary(binary) => {
                if let Some(operator) = comparison(&binary.op) {
                    return self.compared(operator, Place::of(&binary.op));
                }
                let (left, right) = (self.evaluate(&binary.left), self.evaluate(&binary.right));
                self.combine(left?, &binary.op, right?, syntax)
            }
            Syntax::Array(array) => {
                let items: Vec<_> = array.elems.iter().map(|item| self.evaluate(item)).collect();
                let items: Option<Vec<_>> = items.into_iter().collect();
                self.list(items?, Place::of(array))
            }
            Syntax::Call(call) => match &*call.func {
                Syntax::Path(path) if path.path.get_ident().is_some() => {
                    let name = path
                        .path
                        .get_ident()
                        .map(ToString::to_string)
                        .unwrap_or_default();
                    let arguments = call.args.iter().collect();
                    match reference(&call.func) {
                        Some(Ok(callee)) if self.may_be_table(&name) => {
                            self.table_call(&callee, Place::of(path), arguments)
                        }
                        _ => self.call(&name, path.span(), arguments),
                    }
                }
                other => match reference(other) {
                    Some(Ok(callee)) => {
                        let arguments = call.args.iter().collect();
                        self.table_call(&callee, Place::of(other), arguments)
                    }
                    Some(Err(error)) => self.fail_with(error),
                    None => self.fail(Place::of(other), "expected the name of a function"),
                },
            },
            Syntax::MethodCall(call) => {
                let name = call.method.to_string();
                if matches!(name.as_str(), "point" | "frame" | "velocity_at") {
                    let arguments: Vec<_> = call.args.iter().collect();
                    return self.frame_method(
                        &call.receiver,
                        &name,
                        call.method.span(),
                        &arguments,
                    );
                }
                let mut arguments = vec![&*call.receiver];
                arguments.extend(&call.args);
                self.call(&name, call.method.span(), arguments)
            }
            Syntax::Field(field) => {
                if matches!(&field.member, Member::Named(name) if name == "reaction")
                    && let Some(reaction) = self.reaction_of(&field.base, Place::of(syntax))
                {
                    return reaction;
                }
                if let Member::Named(name) = &field.member
                    && let Some(load) = self.load_of(&field.base, name)
                {
                    return load;
                }
                let value = self.evaluate(&field.base)?;
                match &field.member {
                    Member::Named(name) => self.member(&value, &name.to_string(), name.span()),
                    Member::Unnamed(index) => {
                        self.fail(index.span, "expected a name after the dot")
                    }
                }
            }
            other => self.fail(
                Place::of(other),
                "this cannot be part of an expression here",
            ),
        }
    }

    /// A scalar with its dimension.
    pub(in crate::model) fn scalar(
        &mut self,
        syntax: &Syntax,
    ) -> Option<(Expr, Option<Dimension>)> {
        match self.evaluate(syntax)? {
            Value::Scalar(expr, dimension) => Some((expr, dimension)),
            other => self.fail(
                Place::of(syntax),
                format!("expected a number, but this is {}", other.describe()),
            ),
        }
    }

    /// A vector, or a point as its position.
    pub(in crate::model) fn vector(
        &mut self,
        syntax: &Syntax,
    ) -> Option<(Vector, Option<Dimension>)> {
        match self.evaluate(syntax)? {
            Value::Vector(v, dimension) => Some((v, dimension)),
            Value::Point(point) => Some((self.position(&point), Some(Dimension::LENGTH))),
            other => self.fail(
                Place::of(syntax),
                format!(
                    "expected a vector {}, but this is {}",
                    self.vector_example(),
                    other.describe()
                ),
            ),
        }
    }

    /// Refuses an axis of zero length.
    pub(in crate::model) fn no_direction<T>(&mut self, syntax: &Syntax) -> Option<T> {
        let example = match self.world {
            World::Planar => "[1.0, 1.0]",
            World::Spatial => "[1.0, 1.0, 0.0]",
        };
        self.fail(
            Place::of(syntax),
            format!("this axis has no length; give it a direction, such as X or {example}"),
        )
    }

    /// How a vector is written.
    pub(in crate::model) fn vector_example(&self) -> &'static str {
        match self.world {
            World::Planar => "[x, y]",
            World::Spatial => "[x, y, z]",
        }
    }

    /// The smallest subexpression that depends on a symbol for which `predicate` holds.
    pub(in crate::model) fn blame(
        &mut self,
        syntax: &Syntax,
        predicate: &dyn Fn(Symbol) -> bool,
    ) -> Place {
        self.blame_value(syntax, &|value, graph| value.depends_on(graph, predicate))
    }

    /// The smallest subexpression that calls a law.
    pub(in crate::model) fn blame_law(&mut self, syntax: &Syntax) -> Place {
        self.blame_value(syntax, &|value, graph| {
            let expressions = value.expressions();
            expressions.into_iter().any(|x| graph.contains_law(x))
        })
    }

    /// The smallest subexpression with a table whose slope jumps.
    pub(in crate::model) fn blame_kink(&mut self, syntax: &Syntax, order: i8) -> Place {
        self.blame_value(syntax, &|value, graph| {
            let expressions = value.expressions();
            expressions
                .into_iter()
                .any(|x| graph.contains_kink(x, order))
        })
    }

    /// The smallest subexpression for whose value `predicate` holds.
    fn blame_value(
        &mut self,
        syntax: &Syntax,
        predicate: &dyn Fn(&Value, &Graph) -> bool,
    ) -> Place {
        let parts = match syntax {
            Syntax::Field(_) | Syntax::Index(_) => Vec::new(),
            _ => children(syntax),
        };
        for child in parts {
            let Some(value) = self.silently(|resolver| resolver.evaluate(child)) else {
                continue;
            };
            if predicate(&self.placed(value), &self.graph) {
                return self.blame_value(child, predicate);
            }
        }
        Place::of(syntax)
    }
}
