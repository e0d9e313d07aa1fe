//! The parser: entries are split at commas first, so that an error in one entry does not hide errors in others.

use super::entry::{entry, lost_parameter, place};
use super::families::is_family;
use super::members::{FamilyItem, place_family};
use super::{Declaration, Entry, MAX_DEPTH, TOO_DEEP};
use crate::diagnostics::Errors;
use crate::schema::{self, Kinds};
use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream, Parser};
use syn::{Attribute, Expr, ExprLit, Ident, Lit, Meta, Token, Visibility, braced, token};

/// Parses a declaration. What parsed is returned even if some entries did not.
pub fn parse(tokens: TokenStream, kinds: &Kinds, errors: &mut Errors) -> Option<Declaration> {
    let found = name_of(&tokens);
    let header = height(&tokens, MAX_DEPTH).and_then(|_| {
        let text = tokens.to_string();
        let header: Header = syn::parse2(tokens)?;
        Ok((header, text))
    });
    let (
        Header {
            doc,
            visibility,
            name,
            body,
        },
        text,
    ) = match header {
        Ok(header) => header,
        Err(error) => {
            errors.push(error);
            return found.map(Declaration::nameable);
        }
    };
    check_name(&name, errors);
    let mut declaration = Declaration {
        visibility,
        doc,
        text,
        ..Declaration::nameable(name)
    };
    let mut broken_world = false;
    for chunk in split_at_commas(body) {
        broken_world |= starts_with_world(&chunk);
        let read = |input: ParseStream| Item::parse(input, kinds);
        match read.parse2(chunk.clone()) {
            Ok(Item::Doc(doc)) => {
                if !declaration.doc.is_empty() {
                    declaration.doc.push('\n');
                }
                declaration.doc.push_str(&doc);
            }
            Ok(Item::Entry(entry)) => {
                if !place(entry, kinds, &mut declaration, errors) {
                    declaration.lost.extend(lost_entry(&chunk, kinds));
                }
            }
            Ok(Item::Family(family)) => place_family(&family, kinds, &mut declaration, errors),
            Err(error) => {
                errors.push(error);
                declaration.lost.extend(lost_entry(&chunk, kinds));
            }
        }
    }
    if declaration.world.is_none() && !broken_world {
        errors.at(
            declaration.name.span(),
            "this mechanism has no world; write `world: Planar(gravity = [0.0, -9.81_m_per_s2]),` as its first entry",
        );
    }
    Some(declaration)
}

/// Refuses names of mechanisms that generated code could not live with.
fn check_name(name: &Ident, errors: &mut Errors) {
    let text = name.to_string();
    if schema::PRIMITIVES.contains(&text.as_str()) {
        errors.at(
            name.span(),
            format!("`{text}` is a type of Rust; choose another name for the mechanism"),
        );
    }
    // So that no two mechanisms can have types of the same name.
    let mut stems = schema::SUFFIXES.iter();
    let stem = stems.find_map(|suffix| text.strip_suffix(suffix));
    if let Some(stem) = stem.filter(|stem| !stem.is_empty()) {
        errors.at(
            name.span(),
            format!("a mechanism `{stem}` would have a type `{text}` beside its own; choose another name for this mechanism"),
        );
    }
}

/// The name of the mechanism, also if other parts have errors.
fn name_of(tokens: &TokenStream) -> Option<Ident> {
    tokens.clone().into_iter().find_map(|token| match token {
        TokenTree::Ident(name) => syn::parse2(name.into_token_stream()).ok(),
        _ => None,
    })
}

/// The name of a wrong entry that seems to be a parameter: `name: Parm(…)` or `name: 1.0_m`.
fn lost_entry(chunk: &TokenStream, kinds: &Kinds) -> Option<Ident> {
    let mut tokens = chunk
        .clone()
        .into_iter()
        .skip_while(|token| matches!(token, TokenTree::Punct(_) | TokenTree::Group(_)));
    let Some(TokenTree::Ident(name)) = tokens.next() else {
        return None;
    };
    let name = syn::parse2(name.into_token_stream()).ok()?;
    lost_parameter(&name, tokens.collect(), kinds)
}

struct Header {
    doc: String,
    visibility: Option<Visibility>,
    name: Ident,
    body: TokenStream,
}

impl Parse for Header {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let doc = documentation(&input.call(Attribute::parse_outer)?)?;
        let visibility = match input.parse()? {
            Visibility::Inherited => None,
            written => Some(written),
        };
        let name: Ident = input.parse().map_err(|error| {
            syn::Error::new(
                error.span(),
                "expected the mechanism's name, as in `mechanism!(SliderCrank { … })`",
            )
        })?;
        if !input.peek(token::Brace) {
            return Err(syn::Error::new(
                name.span(),
                format!("expected the entries in braces: `{name} {{ … }}`"),
            ));
        }
        let body;
        braced!(body in input);
        let body = body.parse()?;
        if !input.is_empty() {
            return Err(input.error("nothing may follow the closing brace of a mechanism"));
        }
        Ok(Header {
            doc,
            visibility,
            name,
            body,
        })
    }
}

enum Item {
    Doc(String),
    Entry(Entry),
    Family(FamilyItem),
}

impl Item {
    fn parse(input: ParseStream, kinds: &Kinds) -> syn::Result<Self> {
        let doc = documentation(&input.call(Attribute::parse_outer)?)?;
        let name = entry_name(input)?;
        if !input.peek(Token![:]) {
            let message = match kinds.any(&name.to_string()) {
                Some(kind) => format!(
                    "this `{kind}` has no name; write `name: {kind}(…)`",
                    kind = kind.name
                ),
                None => format!("expected `:` after `{name}`, as in `{name}: Kind(…)`"),
            };
            return Err(syn::Error::new(name.span(), message));
        }
        input.parse::<Token![:]>()?;
        if input.is_empty() {
            return Err(syn::Error::new(
                name.span(),
                format!("expected `{name}: Kind(…)`"),
            ));
        }
        let value: Expr = input.parse()?;
        if !input.is_empty() {
            return Err(input.error("expected `,` between entries"));
        }
        if name == "doc" {
            return match value {
                Expr::Lit(ExprLit {
                    lit: Lit::Str(text),
                    ..
                }) => Ok(Item::Doc(text.value())),
                other => Err(syn::Error::new_spanned(
                    other,
                    "`doc:` takes a text in quotes",
                )),
            };
        }
        match value {
            Expr::Call(call) if is_family(&call) => {
                Ok(Item::Family(FamilyItem { name, doc, call }))
            }
            value => entry(name.into(), doc, value).map(Item::Entry),
        }
    }
}

fn starts_with_world(entry: &TokenStream) -> bool {
    let first = entry.clone().into_iter().next();
    matches!(first, Some(TokenTree::Ident(name)) if name == "world")
}

fn entry_name(input: ParseStream) -> syn::Result<Ident> {
    if !input.peek(Ident::peek_any) {
        return Err(input.error("expected an entry, as in `name: Kind(…)`"));
    }
    let name = input.call(Ident::parse_any)?;
    match syn::parse2::<Ident>(name.to_token_stream()) {
        Ok(name) if name.to_string().starts_with("r#") => Err(syn::Error::new(
            name.span(),
            "names are written without `r#`; choose another name",
        )),
        Ok(name) => Ok(name),
        Err(_) => Err(syn::Error::new(
            name.span(),
            format!("`{name}` is a word of Rust; choose another name"),
        )),
    }
}

fn documentation(attributes: &[Attribute]) -> syn::Result<String> {
    let mut lines = Vec::new();
    for attribute in attributes {
        match &attribute.meta {
            Meta::NameValue(pair) if pair.path.is_ident("doc") => {
                if let Expr::Lit(ExprLit {
                    lit: Lit::Str(line),
                    ..
                }) = &pair.value
                {
                    lines.push(line.value().trim().to_owned());
                }
            }
            other => {
                return Err(syn::Error::new_spanned(
                    other,
                    "only documentation comments (`///`) may stand here",
                ));
            }
        }
    }
    Ok(lines.join("\n"))
}

/// At least the height of the tree that these tokens will become. An error at the token where it grows beyond `limit`.
///
/// A sum of n terms is a tree of height n above its highest term; within a term every sign may be a level. A pair of
/// brackets weighs as much as the levels of grammar inside it.
fn height(tokens: &TokenStream, limit: usize) -> syn::Result<usize> {
    const BRACKETS: usize = 3;
    let (mut sums, mut term, mut inside) = (0, 0, 0);
    let (mut highest_term, mut highest) = (0, 0);
    let mut after_operand = false;
    for token in tokens.clone() {
        match &token {
            TokenTree::Punct(sign) => match sign.as_char() {
                ',' => (sums, term, inside, highest_term) = (0, 0, 0, 0),
                '+' | '-' if after_operand => {
                    sums += 1;
                    (term, inside) = (0, 0);
                }
                '+' | '-' | '*' | '/' | '.' => term += 1,
                // Attributes, such as lines of documentation, stand one after the other.
                '#' => {}
                _ => sums += 1,
            },
            TokenTree::Group(group) => {
                let within = match limit.checked_sub(sums + term + BRACKETS) {
                    Some(left) => height(&group.stream(), left)?,
                    None => 0,
                };
                inside = inside.max(within + BRACKETS);
            }
            TokenTree::Ident(_) | TokenTree::Literal(_) => {}
        }
        after_operand = !matches!(token, TokenTree::Punct(_));
        highest_term = highest_term.max(term + inside);
        highest = highest.max(sums + highest_term);
        if highest > limit {
            return Err(syn::Error::new(token.span(), TOO_DEEP));
        }
    }
    Ok(highest)
}

fn split_at_commas(body: TokenStream) -> Vec<TokenStream> {
    let mut chunks = vec![TokenStream::new()];
    for token in body {
        match &token {
            TokenTree::Punct(punct) if punct.as_char() == ',' => chunks.push(TokenStream::new()),
            _ => chunks
                .last_mut()
                .expect("starts with one chunk")
                .extend([token]),
        }
    }
    chunks.retain(|chunk| !chunk.is_empty());
    chunks
}
