//! Entries as an editor has them: read from tokens that may be wrong.

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};

/// `name: Kind(…)`.
pub(super) struct Entry {
    pub(super) name: Ident,
    /// Its documentation comment, as attributes.
    pub(super) doc: TokenStream,
    /// Of a family: what stands between the bars of `|i|`.
    pub(super) indices: Option<TokenStream>,
    /// How many indices follow its name.
    pub(super) levels: usize,
    /// What it is: one kind, or those of the branches of a family.
    pub(super) calls: Vec<Call>,
}

/// `Kind(…)`.
pub(super) struct Call {
    pub(super) kind: Ident,
    pub(super) arguments: Vec<Argument>,
}

/// `value` or `name = value`.
pub(super) struct Argument {
    pub(super) name: Option<Ident>,
    pub(super) value: TokenStream,
}

/// The entries of `Name { … }`.
pub(super) fn entries(tokens: &TokenStream) -> Vec<Entry> {
    let groups = tokens.clone().into_iter().filter_map(|token| match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => Some(group.stream()),
        _ => None,
    });
    let Some(body) = groups.last() else {
        return Vec::new();
    };
    split(body).into_iter().filter_map(entry).collect()
}

fn entry(tokens: Vec<TokenTree>) -> Option<Entry> {
    // Attributes: `#` and a group.
    let is_attribute =
        |k: usize| matches!(&tokens[k], TokenTree::Punct(punct) if punct.as_char() == '#');
    let attributes = (0..tokens.len()).step_by(2).find(|&k| !is_attribute(k))?;
    let (doc, rest) = tokens.split_at(attributes);
    let [TokenTree::Ident(name), TokenTree::Punct(colon), value @ ..] = rest else {
        return None;
    };
    if colon.as_char() != ':' {
        return None;
    }
    let entry = |(levels, indices), calls| Entry {
        name: name.clone(),
        levels,
        doc: doc.iter().cloned().collect(),
        indices,
        calls,
    };
    match value {
        [TokenTree::Ident(each), TokenTree::Group(group), ..] if each == "Each" => {
            let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
            let mut halves = tokens.splitn(2, is_comma);
            let levels = halves.next().map_or(1, ranges);
            let member = halves.next().unwrap_or_default();
            let is_bar = |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == '|');
            let mut parts = member.splitn(3, is_bar).skip(1);
            let indices = parts.next()?.iter().cloned().collect();
            Some(entry((levels, Some(indices)), calls(parts.next()?)))
        }
        [TokenTree::Ident(kind), TokenTree::Group(group), ..] if kind == "Param" => {
            // Of a list of values it is a family.
            let levels = usize::from(matches!(
                group.stream().into_iter().next(),
                Some(TokenTree::Group(list)) if list.delimiter() == Delimiter::Bracket
            ));
            Some(entry((levels, None), calls(value)))
        }
        value => Some(entry((0, None), calls(value))),
    }
}

/// The number of indices of a family over `0..3`, a list, or `(0..3, 0..2)`.
fn ranges(over: &[TokenTree]) -> usize {
    match over {
        [TokenTree::Group(group)] if group.delimiter() == Delimiter::Parenthesis => {
            split(group.stream()).len()
        }
        _ => 1,
    }
}

/// The kinds of an expression: `Kind(…)`, or those inside `if … { } else { }`.
fn calls(tokens: &[TokenTree]) -> Vec<Call> {
    let mut found = Vec::new();
    match tokens {
        [TokenTree::Ident(branch), ..] if branch == "if" => {
            for token in tokens {
                if let TokenTree::Group(group) = token
                    && group.delimiter() == Delimiter::Brace
                {
                    found.extend(calls(&group.stream().into_iter().collect::<Vec<_>>()));
                }
            }
        }
        [TokenTree::Ident(kind), TokenTree::Group(group), ..] => found.push(Call {
            kind: kind.clone(),
            arguments: split(group.stream()).into_iter().map(argument).collect(),
        }),
        [TokenTree::Ident(kind), ..] => found.push(Call {
            kind: kind.clone(),
            arguments: Vec::new(),
        }),
        _ => {}
    }
    found
}

fn argument(tokens: Vec<TokenTree>) -> Argument {
    match tokens.as_slice() {
        [TokenTree::Ident(name), TokenTree::Punct(equal), value @ ..] if equal.as_char() == '=' => {
            Argument {
                name: Some(name.clone()),
                value: value.iter().cloned().collect(),
            }
        }
        value => Argument {
            name: None,
            value: value.iter().cloned().collect(),
        },
    }
}

/// The tokens between commas.
fn split(tokens: TokenStream) -> Vec<Vec<TokenTree>> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let parts = tokens.split(is_comma).map(<[TokenTree]>::to_vec);
    parts.filter(|part| !part.is_empty()).collect()
}

fn is_comma(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == ',')
}
