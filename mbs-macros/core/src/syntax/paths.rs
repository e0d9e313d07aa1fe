//! The paths of assemblies.

use super::entry::ASSEMBLY;
use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;

/// A path without blanks, by which an assembly is found.
pub fn path_text(path: &impl ToTokens) -> String {
    let mut text = path.to_token_stream().to_string();
    text.retain(|c| !c.is_whitespace());
    text
}

/// The paths of the assemblies that tokens name: what follows `Assembly(`.
pub fn named(tokens: &TokenStream, paths: &mut Vec<TokenStream>) {
    let mut list = tokens.clone().into_iter().peekable();
    while let Some(token) = list.next() {
        match (&token, list.peek()) {
            (TokenTree::Ident(word), Some(TokenTree::Group(arguments))) if word == ASSEMBLY => {
                let is_comma = |token: &TokenTree| matches!(token, TokenTree::Punct(comma) if comma.as_char() == ',');
                let first = arguments.stream().into_iter();
                let path: Vec<TokenTree> = first.take_while(|token| !is_comma(token)).collect();
                let is_path = path.iter().all(|token| match token {
                    TokenTree::Ident(_) => true,
                    TokenTree::Punct(colon) => colon.as_char() == ':',
                    _ => false,
                });
                if is_path && matches!(path.last(), Some(TokenTree::Ident(_))) {
                    paths.push(path.into_iter().collect());
                }
            }
            (TokenTree::Group(group), _) => named(&group.stream(), paths),
            _ => {}
        }
    }
}
