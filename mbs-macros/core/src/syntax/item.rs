//! A declaration is read: its header, and what stands between two commas.

use super::chunk::{check_tokens, without_attributes};
use super::entry::entry;
use super::families::{is_family, of_list};
use super::height::height;
use super::members::FamilyItem;
use super::nameless::nameless_world;
use super::{Entry, MAX_DEPTH};
use crate::schema::Kinds;
use proc_macro2::{Delimiter, Group, Span, TokenStream, TokenTree};
use quote::ToTokens;
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream, Parser};
use syn::{
    Attribute, Expr, ExprLit, Ident, Lit, Meta, Token, Visibility, braced, parenthesized, token,
};

/// The header, and the tokens as text.
pub(super) fn read_header(tokens: TokenStream) -> syn::Result<(Header, String)> {
    height(&tokens, MAX_DEPTH)?;
    let text = tokens.to_string();
    Ok((syn::parse2(tokens)?, text))
}

pub(super) struct Header {
    pub(super) doc: String,
    pub(super) visibility: Option<Visibility>,
    pub(super) name: Ident,
    pub(super) body: TokenStream,
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
                "expected a name, as in `mechanism!(SliderCrank { … })`",
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
            return Err(input.error("nothing may follow the closing brace"));
        }
        Ok(Header {
            doc,
            visibility,
            name,
            body,
        })
    }
}

/// What stands between two commas.
#[derive(Debug, Clone)]
pub(super) enum Item {
    Doc(String),
    Entry(Entry),
    Family(FamilyItem),
}

impl Item {
    pub(super) fn parse(input: ParseStream, kinds: &Kinds) -> syn::Result<Self> {
        let attributes = input.call(Attribute::parse_outer)?;
        let doc = documentation(&attributes)?;
        if let Some(last) = attributes.last().filter(|_| input.is_empty()) {
            return Err(syn::Error::new_spanned(
                last,
                "documentation stands before its entry, and nothing follows here",
            ));
        }
        // The tokens of an entry are copied only where its name is missing.
        let has_name = input.peek2(Token![:]);
        let tokens = (!has_name).then(|| input.cursor().token_stream());
        let world = tokens.and_then(nameless_world);
        let name = entry_name(input)?;
        if let Some(world) = world {
            let world = world.kind().name;
            return Err(syn::Error::new(
                name.span(),
                format!("the name of a world is `world`; write `world: {world}(…)`"),
            ));
        }
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
        if let Some(last) = attributes.last()
            && ["world", "deny", "allow", "doc"]
                .iter()
                .any(|setting| name == setting)
        {
            return Err(syn::Error::new_spanned(
                last,
                format!(
                    "`{name}:` has no documentation of its own; that of the whole stands before its name, or in `doc:`"
                ),
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
        let family = match &value {
            Expr::Call(call) if is_family(call) => Some(call.clone()),
            Expr::Call(call) => of_list(call),
            _ => None,
        };
        match family {
            Some(call) => Ok(Item::Family(FamilyItem {
                name: name.into(),
                doc,
                call,
            })),
            None => entry(name.into(), doc, value).map(Item::Entry),
        }
    }
}

fn entry_name(input: ParseStream) -> syn::Result<Ident> {
    if !input.peek(Ident::peek_any) {
        return Err(input.error("expected an entry, as in `name: Kind(…)`"));
    }
    let name = input.call(Ident::parse_any)?;
    if name == "pub" {
        return Err(syn::Error::new(
            name.span(),
            "what an entry gives is public anyway; leave `pub` out",
        ));
    }
    if is_word_of_rust(&name) {
        return Err(syn::Error::new(name.span(), word_of_rust(&name)));
    }
    match name.to_string().starts_with("r#") {
        true => Err(syn::Error::new(name.span(), WITHOUT_RAW)),
        false => Ok(name),
    }
}

/// The message for names such as `r#fn`.
pub(super) const WITHOUT_RAW: &str = "names are written without `r#`; choose another name";

/// Whether the generated code cannot have this name; `gen` is such a word from edition 2024 on.
pub(super) fn is_word_of_rust(name: &Ident) -> bool {
    name == "gen" || syn::parse2::<Ident>(name.to_token_stream()).is_err()
}

/// The message for such a name.
pub(super) fn word_of_rust(name: &Ident) -> String {
    format!("`{name}` is a word of Rust; choose another name")
}

fn documentation(attributes: &[Attribute]) -> syn::Result<String> {
    let mut lines = Vec::new();
    for attribute in attributes {
        match &attribute.meta {
            Meta::NameValue(pair) if pair.path.is_ident("doc") => {
                let Expr::Lit(ExprLit {
                    lit: Lit::Str(line),
                    ..
                }) = &pair.value
                else {
                    return Err(syn::Error::new_spanned(
                        &pair.value,
                        "expected a text in quotes: documentation is read where the declaration is",
                    ));
                };
                let line = line.value();
                let line = line.strip_prefix(' ').unwrap_or(&line);
                lines.push(line.trim_end().to_owned());
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

/// Reads an entry.
///
/// # Errors
/// It is none. What is missing at its end is said at its last token.
pub(super) fn read(chunk: &TokenStream, kinds: &Kinds) -> syn::Result<Item> {
    check_tokens(&without_attributes(chunk))?;
    let end = chunk.clone().into_iter().last();
    let end = end.map_or_else(Span::call_site, |last| match last {
        TokenTree::Group(group) => group.span_close(),
        other => other.span(),
    });
    // The parser says at the end of brackets what is missing in them.
    let mut brackets = Group::new(Delimiter::Parenthesis, chunk.clone());
    brackets.set_span(end);
    let read = |input: ParseStream| {
        let inside;
        parenthesized!(inside in input);
        Item::parse(&inside, kinds)
    };
    read.parse2(TokenTree::Group(brackets).into())
}
