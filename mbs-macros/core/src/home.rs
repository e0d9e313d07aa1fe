//! Where generated code finds `mbs-runtime`: `mechanism!(crate = path, Name { … })`.
//!
//! Generated code names it `::mbs_runtime`. A crate that has it under another name, or only through another crate, gives the
//! path, which then stands in every place of that name.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::quote;

/// The name in generated code.
const RUNTIME: &str = "mbs_runtime";

/// Words of Rust behind which a path begins anew; behind another word `::` goes on with its path.
const BEFORE_PATHS: [&str; 13] = [
    "as", "const", "dyn", "else", "for", "impl", "in", "match", "mut", "return", "static", "use",
    "where",
];

/// The path that was given, if one was.
#[derive(Debug, Default)]
pub struct Home(Option<TokenStream>);

impl Home {
    /// Reads `crate = path,` before a declaration, or before the declaration in `@ { declaration } { … }`.
    ///
    /// # Errors
    /// There is `crate`, but no path behind it.
    pub fn of(tokens: &TokenStream) -> syn::Result<Self> {
        let mut list = tokens.clone().into_iter();
        match (list.next(), list.next()) {
            (Some(TokenTree::Punct(at)), Some(TokenTree::Group(declaration)))
                if at.as_char() == '@' =>
            {
                Self::of(&declaration.stream())
            }
            (Some(TokenTree::Ident(word)), equals) if word == "crate" => {
                let is = |token: &TokenTree, sign| matches!(token, TokenTree::Punct(punct) if punct.as_char() == sign);
                let path: TokenStream = list.take_while(|token| !is(token, ',')).collect();
                if equals.is_some_and(|token| is(&token, '='))
                    && syn::parse2::<syn::Path>(path.clone()).is_ok()
                {
                    return Ok(Home(Some(path)));
                }
                let message = "expected the path of mbs-runtime in this crate, as in `crate = my_mbs, SliderCrank { … }`";
                Err(syn::Error::new(word.span(), message))
            }
            _ => Ok(Home(None)),
        }
    }

    /// The declaration alone.
    pub fn strip(&self, tokens: TokenStream) -> TokenStream {
        if self.0.is_none() {
            return tokens;
        }
        let list: Vec<TokenTree> = tokens.into_iter().collect();
        match list.as_slice() {
            [
                at @ TokenTree::Punct(_),
                TokenTree::Group(declaration),
                rest @ ..,
            ] => {
                let declaration = self.strip(declaration.stream());
                quote! { #at { #declaration } #( #rest )* }
            }
            _ => {
                let is_comma = |token: &TokenTree| matches!(token, TokenTree::Punct(comma) if comma.as_char() == ',');
                let rest = list.into_iter().skip_while(|token| !is_comma(token));
                rest.skip(1).collect()
            }
        }
    }

    /// Generated code with the path in the place of `::mbs_runtime`.
    pub fn put(&self, generated: TokenStream) -> TokenStream {
        match &self.0 {
            Some(path) => replaced(generated, path),
            None => generated,
        }
    }
}

fn replaced(tokens: TokenStream, path: &TokenStream) -> TokenStream {
    let list: Vec<TokenTree> = tokens.into_iter().collect();
    let is_colon =
        |token: &TokenTree| matches!(token, TokenTree::Punct(colon) if colon.as_char() == ':');
    let mut out: Vec<TokenTree> = Vec::with_capacity(list.len());
    for token in list {
        match token {
            TokenTree::Group(group) => {
                let delimiter: Delimiter = group.delimiter();
                let mut inner = Group::new(delimiter, replaced(group.stream(), path));
                inner.set_span(group.span());
                out.push(inner.into());
            }
            TokenTree::Ident(word) if word == RUNTIME => {
                let from_root = match out.as_slice() {
                    [.., before, first, second] if is_colon(first) && is_colon(second) => {
                        begins_a_path(before)
                    }
                    [first, second] => is_colon(first) && is_colon(second),
                    _ => false,
                };
                if from_root {
                    out.truncate(out.len() - 2);
                    out.extend(path.clone());
                } else {
                    out.push(word.into());
                }
            }
            other => out.push(other),
        }
    }
    out.into_iter().collect()
}

/// Whether `::` behind this token is that of a root.
fn begins_a_path(before: &TokenTree) -> bool {
    match before {
        TokenTree::Ident(word) => BEFORE_PATHS.contains(&word.to_string().as_str()),
        _ => true,
    }
}
