//! What stands between two commas of a declaration, as tokens.

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};

/// The entries, which are read one by one.
pub(super) fn split_at_commas(body: TokenStream) -> Vec<TokenStream> {
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

/// An entry without what documents it.
pub(super) fn without_attributes(chunk: &TokenStream) -> TokenStream {
    let mut tokens = chunk.clone().into_iter().peekable();
    let is = |token: &TokenTree, sign| matches!(token, TokenTree::Punct(punct) if punct.as_char() == sign);
    while tokens.next_if(|token| is(token, '#')).is_some() {
        tokens.next_if(|token| is(token, '!'));
        tokens.next_if(|token| matches!(token, TokenTree::Group(_)));
    }
    tokens.collect()
}

/// Refuses what expressions of Rust may have, but those of the language have not: attributes, which would be lost, and
/// arguments after colons.
pub(super) fn check_tokens(tokens: &TokenStream) -> syn::Result<()> {
    let mut tokens = tokens.clone().into_iter().peekable();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Punct(sign) if sign.as_char() == '#' => {
                let attribute = [TokenTree::Punct(sign)].into_iter().chain(tokens.next());
                return Err(syn::Error::new_spanned(
                    TokenStream::from_iter(attribute),
                    "no documentation and no attributes stand inside an entry; leave this out",
                ));
            }
            TokenTree::Group(group) => {
                if group.delimiter() == Delimiter::Parenthesis {
                    check_arguments(group.stream())?;
                }
                check_tokens(&group.stream())?;
            }
            _ => {}
        }
    }
    Ok(())
}

/// Refuses `name: value` among arguments.
fn check_arguments(arguments: TokenStream) -> syn::Result<()> {
    for argument in split_at_commas(arguments) {
        let mut tokens = argument.into_iter();
        if let (Some(TokenTree::Ident(name)), Some(TokenTree::Punct(colon))) =
            (tokens.next(), tokens.next())
            && colon.as_char() == ':'
            && colon.spacing() == Spacing::Alone
        {
            return Err(syn::Error::new(
                colon.span(),
                format!("arguments are given by `=`, as in `{name} = …`"),
            ));
        }
    }
    Ok(())
}
