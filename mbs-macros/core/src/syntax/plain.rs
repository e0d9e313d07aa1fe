//! Groups without brackets, in which `macro_rules!` puts what it was given: the grammar of the language does not know them.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

/// Tokens with parentheses around such groups, or nothing where they make no difference.
pub fn plain(tokens: TokenStream) -> TokenStream {
    if !has_bare_group(&tokens) {
        return tokens;
    }
    let list: Vec<TokenTree> = tokens.into_iter().collect();
    let ends = |neighbour: Option<&TokenTree>| match neighbour {
        Some(TokenTree::Punct(sign)) => [',', '=', ':', '|'].contains(&sign.as_char()),
        Some(_) => false,
        None => true,
    };
    let mut out = TokenStream::new();
    for (index, token) in list.iter().enumerate() {
        match token {
            TokenTree::Group(group) if group.delimiter() == Delimiter::None => {
                let inside = plain(group.stream());
                let before = index.checked_sub(1).and_then(|index| list.get(index));
                let stands_alone = ends(before) && ends(list.get(index + 1));
                match stands_alone || is_one_operand(&inside) {
                    true => out.extend(inside),
                    false => out.extend([bracketed(Delimiter::Parenthesis, inside, group)]),
                }
            }
            TokenTree::Group(group) if has_bare_group(&group.stream()) => {
                let inside = plain(group.stream());
                out.extend([bracketed(group.delimiter(), inside, group)]);
            }
            other => out.extend([other.clone()]),
        }
    }
    out
}

fn has_bare_group(tokens: &TokenStream) -> bool {
    tokens.clone().into_iter().any(|token| match token {
        TokenTree::Group(group) => {
            group.delimiter() == Delimiter::None || has_bare_group(&group.stream())
        }
        _ => false,
    })
}

/// A path, one token, or a visibility, which is no operand at all.
fn is_one_operand(tokens: &TokenStream) -> bool {
    let mut list = tokens.clone().into_iter();
    let first = list.next();
    let is_visibility = matches!(&first, Some(TokenTree::Ident(word)) if word == "pub");
    is_visibility
        || first.is_none()
        || list.next().is_none()
        || tokens.clone().into_iter().all(|token| match token {
            TokenTree::Ident(_) => true,
            TokenTree::Punct(sign) => sign.as_char() == ':',
            _ => false,
        })
}

fn bracketed(delimiter: Delimiter, inside: TokenStream, like: &Group) -> TokenTree {
    let mut group = Group::new(delimiter, inside);
    group.set_span(like.span());
    TokenTree::Group(group)
}
