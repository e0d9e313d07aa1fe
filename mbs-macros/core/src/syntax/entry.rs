//! One entry: read from its expression, and put into the declaration.

use super::families::EACH;
use super::levels::{self, place_level};
use super::{Declaration, Entry, Name, NamedArgument};
use crate::diagnostics::{Errors, did_you_mean, did_you_mean_kind, nearest};
use crate::schema::{self, Kinds};
use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens as _;
use syn::{Expr, ExprAssign, Ident};

/// The kind of an assembly put in place.
pub const ASSEMBLY: &str = "Assembly";
/// The kind of what the surroundings of an assembly give.
pub(super) const PORT: &str = "Port";

/// Reads `Kind(…)`.
///
/// # Errors
/// It is something else, or an argument is given twice or in the wrong place.
pub(super) fn entry(name: Name, doc: String, value: Expr) -> syn::Result<Entry> {
    let example = match name.as_str() {
        "world" => "Planar()".to_owned(),
        word => levels::example(word).unwrap_or_else(|| "Param(1.0_m)".to_owned()),
    };
    let expected = || match name.is_member() {
        true => "expected what each member is, as in `|i| Kind(…)`".to_owned(),
        false => format!("expected `{name}: Kind(…)`, for example `{name}: {example}`"),
    };
    let Expr::Call(call) = value else {
        return Err(syn::Error::new_spanned(value, expected()));
    };
    let kind = match &*call.func {
        Expr::Path(path) => path.path.get_ident().cloned(),
        _ => None,
    };
    let Some(kind) = kind else {
        return Err(syn::Error::new_spanned(call.func, expected()));
    };
    let mut entry = Entry {
        name,
        kind,
        doc,
        positional: Vec::new(),
        named: Vec::new(),
    };
    for argument in call.args {
        match argument {
            Expr::Assign(assign) => {
                let Expr::Path(path) = &*assign.left else {
                    return Err(syn::Error::new_spanned(
                        assign.left,
                        "expected `name = value`; for an equation write the difference of its sides, as in `b.b.x - 0.1_m`",
                    ));
                };
                let Some(name) = path.path.get_ident().cloned() else {
                    return Err(syn::Error::new_spanned(
                        assign.left,
                        "expected `name = value`",
                    ));
                };
                if entry.named(&name.to_string()).is_some() {
                    return Err(syn::Error::new(
                        name.span(),
                        format!("`{name}` is given twice; keep one"),
                    ));
                }
                // Of the arguments of other kinds it is known which one has no value.
                if entry.kind == ASSEMBLY
                    && let Expr::Assign(other) = &*assign.right
                {
                    let (names, value) = chain(&assign);
                    let value = value.to_token_stream();
                    let each = names.iter().map(|name| format!("{name} = {value}"));
                    let each = each.collect::<Vec<String>>().join(", ");
                    return Err(syn::Error::new_spanned(
                        other,
                        format!("each argument has a value of its own: write `{each}`"),
                    ));
                }
                entry.named.push(NamedArgument {
                    name,
                    value: *assign.right,
                });
            }
            positional if entry.named.is_empty() => entry.positional.push(positional),
            positional => {
                return Err(syn::Error::new_spanned(
                    positional,
                    "positional arguments come before named ones",
                ));
            }
        }
    }
    take_value(&mut entry);
    Ok(entry)
}

/// The names and the value of `a = b = value`.
fn chain(assign: &ExprAssign) -> (Vec<TokenStream>, &Expr) {
    let (mut names, mut assign) = (vec![assign.left.to_token_stream()], assign);
    while let Expr::Assign(next) = &*assign.right {
        names.push(next.left.to_token_stream());
        assign = next;
    }
    (names, &assign.right)
}

/// `Let(value = x)` is `Let(x)`, as `Output` and `Event` are.
fn take_value(entry: &mut Entry) {
    let kinds = ["Let", "Output", "Event"];
    if entry.positional.is_empty() && kinds.iter().any(|kind| entry.kind == kind) {
        let is_value = |argument: &NamedArgument| argument.name == "value";
        if let Some(place) = entry.named.iter().position(is_value) {
            entry.positional.push(entry.named.remove(place).value);
        }
    }
}

/// Whether the entry was stored.
pub(super) fn place(
    entry: Entry,
    kinds: &Kinds,
    declaration: &mut Declaration,
    errors: &mut Errors,
) -> bool {
    if schema::RESERVED.contains(&entry.name.to_string().as_str()) {
        errors.at(
            entry.name.span(),
            format!("`{}` is reserved; choose another name", entry.name),
        );
        return false;
    }
    if place_level(&entry, declaration, errors) {
        return true;
    }
    if entry.name == "world" {
        if declaration.world.is_some() {
            errors.at(
                entry.name.span(),
                "the world is already declared; keep one `world:` entry",
            );
        } else if schema::world(&entry.kind.to_string()).is_none() {
            let known = schema::World::ALL
                .into_iter()
                .map(|world| world.kind().name);
            let hint = did_you_mean(&entry.kind.to_string(), known.clone());
            let known: Vec<_> = known.collect();
            errors.at(
                entry.kind.span(),
                format!(
                    "there is no world `{}`{hint} (worlds: {})",
                    entry.kind,
                    known.join(", ")
                ),
            );
            declaration.world = Some(entry);
        } else {
            declaration.world = Some(entry);
        }
        return true;
    }
    // `Planar` is a joint of space, too, and then has partners.
    let has_partners = ["parent", "child"].map(|name| entry.named(name).is_some());
    let is_alone = entry.positional.is_empty() && has_partners == [false; 2];
    if schema::world(&entry.kind.to_string()).is_some() && is_alone {
        errors.at(
            entry.name.span(),
            format!(
                "a world has no name of its own; write `world: {}(…)`",
                entry.kind
            ),
        );
        declaration.world.get_or_insert(entry);
        return false;
    }
    if entry.name.is_member() && entry.kind == EACH {
        errors.at(
            entry.kind.span(),
            format!("families do not nest; give both ranges at once: `{}: {EACH}((0..3, 0..5), |i, j| Kind(…))`", entry.name.word()),
        );
        return false;
    }
    if entry.kind == ASSEMBLY {
        declaration.entries.push(entry);
        return true;
    }
    if entry.kind == PORT {
        errors.at(
            entry.kind.span(),
            match entry.name.is_member() {
                true => "a port is no member of a family; give each port of an assembly a name of its own",
                false => "a port stands in `assembly!`; a mechanism has parameters and inputs",
            },
        );
        return false;
    }
    if kinds.any(&entry.kind.to_string()).is_none() {
        let known = kinds.names();
        let hint = did_you_mean_kind(
            &entry.kind.to_string(),
            known.clone().chain([EACH, ASSEMBLY]),
        );
        let hint = if hint.is_empty() {
            format!(" (kinds: {})", known.collect::<Vec<_>>().join(", "))
        } else {
            hint
        };
        errors.at(
            entry.kind.span(),
            format!("there is no kind `{}`{hint}", entry.kind),
        );
        return false;
    }
    declaration.entries.push(entry);
    true
}

/// The name, if what follows it seems to be a parameter, or a family of them.
pub(super) fn lost_parameter(name: &Ident, after: TokenStream, kinds: &Kinds) -> Option<Ident> {
    let mut rest = after
        .into_iter()
        .skip_while(|token| matches!(token, TokenTree::Punct(_)));
    let is_parameter = match (rest.next(), rest.next()) {
        (Some(TokenTree::Ident(each)), Some(TokenTree::Group(group))) if each == EACH => {
            return lost_parameter(name, body_of(group.stream()), kinds);
        }
        (Some(TokenTree::Ident(kind)), _) => {
            nearest(&kind.to_string(), kinds.names()) == Some("Param")
        }
        (Some(TokenTree::Literal(_)), _) => true,
        _ => false,
    };
    is_parameter.then(|| name.clone())
}

/// What follows the parameters of a closure.
fn body_of(arguments: TokenStream) -> TokenStream {
    let is_bar = |token: &TokenTree| matches!(token, TokenTree::Punct(bar) if bar.as_char() == '|');
    let after = arguments.into_iter().skip_while(|token| !is_bar(token));
    after.skip(1).skip_while(|token| !is_bar(token)).collect()
}
