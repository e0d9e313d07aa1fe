//! Arguments that a kind does not have, and those that it needs.

use crate::diagnostics::{Place, did_you_mean};
use crate::model::advice;
use crate::model::resolver::Resolver;
use crate::schema::{self, Absent, Kind, World};
use crate::syntax::{Entry, NamedArgument};
use syn::Expr;

/// Every argument is one that its kind has, and no required one is missing.
pub(in crate::model) fn arguments(resolver: &mut Resolver) {
    let declaration = resolver.declaration;
    for entry in declaration.world.iter().chain(&declaration.entries) {
        let name = entry.kind.to_string();
        let kind = if entry.name == "world" {
            schema::world(&name).map(World::kind)
        } else {
            resolver.kinds.kind(resolver.world, &name)
        };
        let before = resolver.errors.enter(entry.name.as_str());
        if let Some(kind) = kind {
            entry_arguments(resolver, entry, kind);
        } else if let Some(kind) = resolver.kinds.any(&name) {
            let advice = advice::kind(resolver.world, kind);
            let (world, kind) = (resolver.world.describe(), kind.name);
            resolver.fail::<()>(
                entry.kind.span(),
                format!("there is no `{kind}` in {world}; {advice}"),
            );
        }
        resolver.errors.leave(before);
    }
}

fn entry_arguments(resolver: &mut Resolver, entry: &Entry, kind: &Kind) {
    let positional: Vec<&str> = kind
        .fields
        .iter()
        .filter(|field| field.positional)
        .map(|field| field.name)
        .collect();
    let mut misplaced = false;
    if let Some(surplus) = entry.positional.get(positional.len()) {
        let takes = match positional.as_slice() {
            [] => "no positional arguments".to_owned(),
            [one] => format!("one positional argument (`{one}`)"),
            many => format!(
                "{} positional arguments (`{}`)",
                many.len(),
                many.join("`, `")
            ),
        };
        resolver.fail::<()>(
            Place::of(surplus),
            format!("`{}` takes {takes}; name the others", kind.name),
        );
        misplaced = true;
    }
    for argument in &entry.named {
        let name = argument.name.to_string();
        if !kind.fields.iter().any(|field| field.name == name) {
            let known = kind.fields.iter().map(|field| field.name);
            let hint = match advice::argument(resolver.world, kind, &name) {
                Some(advice) => format!("; {advice}"),
                None => did_you_mean(&name, known.clone()),
            };
            let known: Vec<_> = known.collect();
            resolver.fail::<()>(
                argument.name.span(),
                format!(
                    "`{}` has no argument `{name}`{hint} (arguments: {})",
                    kind.name,
                    known.join(", ")
                ),
            );
            misplaced = true;
        } else if positional
            .iter()
            .position(|known| *known == name)
            .is_some_and(|slot| slot < entry.positional.len())
        {
            resolver.fail::<()>(
                argument.name.span(),
                format!("`{name}` is given by position already; keep one of them"),
            );
        }
        misplaced |= forgotten(resolver, argument, kind).is_some();
    }
    if misplaced {
        // A missing argument may be one in the wrong position, which may also cause the other errors.
        resolver.misplaced.insert(entry.name.to_string());
        return;
    }
    for (slot, field) in kind
        .fields
        .iter()
        .enumerate()
        .filter(|(_, field)| field.default == Absent::Required)
    {
        let by_position = field.positional && slot < entry.positional.len();
        if !by_position && entry.named(field.name).is_none() {
            resolver.misplaced.insert(entry.name.to_string());
            resolver.fail::<()>(
                entry.kind.span(),
                format!("`{}` needs `{}`: {}", kind.name, field.name, field.doc),
            );
        }
    }
}

/// Refuses `mass = length = 0.1_m`, which is the beginning of two arguments.
fn forgotten(resolver: &mut Resolver, argument: &NamedArgument, kind: &Kind) -> Option<()> {
    let Expr::Assign(following) = &argument.value else {
        return None;
    };
    let Expr::Path(path) = &*following.left else {
        return None;
    };
    let (name, next) = (&argument.name, path.path.get_ident()?);
    if kind.fields.iter().all(|field| next != field.name) {
        return None;
    }
    resolver.fail::<()>(
        Place::of(&following.left),
        format!("the value of `{name}` is missing: write `{name} = …, {next} = …`"),
    );
    Some(())
}
