//! Names of entries of assemblies: `front.arm.a` is the point `a` of the entry `front.arm`.

use super::Declaration;
use super::children::children_mut;
use super::reference::{member_of, reference};
use crate::diagnostics::{Errors, Place};
use std::collections::HashSet;
use syn::{Expr, ExprCall, Member};

/// Finds these names in all expressions, and checks that assemblies are of the world of their mechanism.
pub(super) fn resolve(declaration: &mut Declaration, errors: &mut Errors) {
    if declaration.instances.is_empty() {
        return;
    }
    let names: HashSet<String> = declaration
        .instances
        .iter()
        .map(|instance| instance.name.to_string())
        .collect();
    for entry in &mut declaration.entries {
        let named = entry.named.iter_mut().map(|argument| &mut argument.value);
        entry
            .positional
            .iter_mut()
            .chain(named)
            .for_each(|expr| nest(expr, &names));
    }
    for given in &mut declaration.given {
        nest(&mut given.value, &names);
    }
    if declaration.world.is_none() {
        return;
    }
    let world = declaration.world_kind();
    for instance in &declaration.instances {
        let of = &instance.definition;
        if of.world == world {
            continue;
        }
        // The one outside is wrong already.
        let outer = declaration.instance(instance.name.assembly());
        if outer.is_none_or(|outer| outer.definition.world == world) {
            let before = errors.enter(instance.name.as_str());
            errors.at(
                Place::of(&instance.path),
                format!(
                    "`{}` is an assembly of {}, and this mechanism is one of {}",
                    of.name,
                    of.world.describe(),
                    world.describe()
                ),
            );
            errors.leave(before);
        }
    }
}

fn nest(expr: &mut Expr, assemblies: &HashSet<String>) {
    for child in children_mut(expr) {
        nest(child, assemblies);
    }
    // A table of an assembly looks like a method.
    if let Expr::MethodCall(call) = expr
        && let Some(Ok(base)) = reference(&call.receiver)
        && assemblies.contains(&base.text())
        && let Some(table) = member_of(&call.receiver, &call.method)
    {
        *expr = Expr::Call(ExprCall {
            attrs: Vec::new(),
            func: Box::new(table),
            paren_token: call.paren_token,
            args: call.args.clone(),
        });
        return;
    }
    let Expr::Field(field) = expr else {
        return;
    };
    if let (Some(Ok(base)), Member::Named(member)) = (reference(&field.base), &field.member)
        && assemblies.contains(&base.text())
        && let Some(name) = member_of(&field.base, member)
    {
        *expr = name;
    }
}
