//! `assembly!`, and how assemblies reach the mechanisms that name them.
//!
//! An assembly becomes a macro of its own name, which hands its tokens to whoever calls it. A mechanism that names an
//! assembly first becomes a call of this macro, which calls `mechanism!` again, now with these tokens:
//!
//! ```text
//! mechanism!(Car { front: Assembly(Corner, …) })
//!   → Corner! { { ::mbs_runtime::mechanism } @ { Car { … } } { } { Corner } }
//!   → ::mbs_runtime::mechanism! { @ { Car { … } } { } { Corner } { { Corner { … } } { } } }
//! ```
//!
//! Tokens keep their places, so that an error in an assembly is shown in its own file.

use crate::diagnostics::{Errors, Failure};
use crate::home::Home;
use crate::syntax::{self, named, path_text};
use crate::{emit, model};
use proc_macro2::{Delimiter, Group, Ident, Punct, Spacing, Span, TokenStream, TokenTree};
use quote::{format_ident, quote};
use std::hash::{DefaultHasher, Hash, Hasher};
use syn::Visibility;

/// Macros that are no assemblies.
const OWN_MACROS: [&str; 2] = ["mechanism", "assembly"];

/// Tokens with all assemblies that they name, or what asks for the next one.
pub enum Gathered {
    /// `@ { declaration } { definitions }`, or a declaration that names none.
    All(TokenStream),
    /// A call of the macro of an assembly, which calls back.
    Asked(TokenStream),
}

/// Collects the assemblies that a declaration names, for a macro of mbs-runtime.
pub fn gather(tokens: TokenStream, callback: &str) -> Gathered {
    let list: Vec<TokenTree> = tokens.clone().into_iter().collect();
    let (declaration, known) = match list.as_slice() {
        [
            TokenTree::Punct(at),
            TokenTree::Group(declaration),
            rest @ ..,
        ] if at.as_char() == '@' => (declaration.stream(), known(rest)),
        _ => (tokens.clone(), TokenStream::new()),
    };
    let pairs: Vec<TokenTree> = known.clone().into_iter().collect();
    let is_known = |path: &TokenStream| {
        pairs.iter().step_by(2).any(|known| match known {
            TokenTree::Group(known) => path_text(&known.stream()) == path_text(path),
            _ => false,
        })
    };
    let mut wanted = Vec::new();
    named(&declaration, &mut wanted);
    // These would ask again without an end.
    let is_own = |path: &TokenStream| {
        let last = path.clone().into_iter().last().map(|word| word.to_string());
        last.is_some_and(|word| OWN_MACROS.contains(&word.as_str()))
    };
    let mut wanted = wanted.into_iter();
    match wanted.find(|path| !is_known(path) && !is_own(path)) {
        None if pairs.is_empty() => Gathered::All(declaration),
        None => Gathered::All(quote! { @ { #declaration } { #known } }),
        Some(path) => {
            let callback = format_ident!("{callback}");
            Gathered::Asked(quote! {
                #path! { { ::mbs_runtime::#callback } @ { #declaration } { #known } { #path } }
            })
        }
    }
}

/// The assemblies so far, and the one that has just come.
fn known(rest: &[TokenTree]) -> TokenStream {
    match rest {
        [TokenTree::Group(known), new @ ..] => {
            let new = new.iter().cloned();
            known.stream().into_iter().chain(new).collect()
        }
        _ => TokenStream::new(),
    }
}

/// Compiles `assembly!`: the struct of its parameters, and the macro that hands out its tokens.
pub fn compile(tokens: TokenStream, home: &Home) -> TokenStream {
    if let Some(itself) = contains_itself(&tokens) {
        return itself;
    }
    let tokens = match gather(tokens, "assembly") {
        Gathered::Asked(tokens) => return tokens,
        Gathered::All(tokens) => home.strip(tokens),
    };
    let (declaration, inside) = apart(tokens.clone());
    let mut errors = Errors::new();
    let is_broken = syntax::is_broken(&tokens);
    let kinds = model::kinds();
    let definition = syntax::define(declaration.clone(), inside.clone(), kinds, &mut errors);
    let Some(definition) = definition else {
        return errors
            .stop_if_any()
            .err()
            .map_or_else(TokenStream::new, |failure| failure.to_compile_errors());
    };
    let alone = match is_broken {
        true => None,
        false => Some(definition.alone(kinds, &mut errors)),
    };
    let (struct_of_parameters, is_wrong) = match alone {
        Some(alone) if errors.is_empty() => {
            definition.check_names(&mut errors);
            let parameters = model::parameters(&alone, definition.world, &mut errors);
            (
                emit::assembly(&alone, &definition.ports, &parameters),
                !errors.is_empty(),
            )
        }
        _ => (TokenStream::new(), true),
    };
    let shown = errors
        .stop_if_any()
        .err()
        .as_ref()
        .map(Failure::to_compile_errors);
    let bundle = bundle(&declaration, &inside, is_wrong);
    let name = &definition.name;
    let hidden = format_ident!(
        "__mbs_assembly_{name}_{:x}",
        hash(&declaration, name.span()),
        span = Span::call_site()
    );
    // Public where nothing else is said, as a mechanism is.
    let (visibility, export) = match &definition.visibility {
        None | Some(Visibility::Public(_)) => (quote! { pub }, Some(quote! { #[macro_export] })),
        Some(narrower) => (quote! { #narrower }, None),
    };
    quote! {
        #shown
        #struct_of_parameters

        #[doc(hidden)]
        #export
        #[allow(clippy::crate_in_macro_def, non_local_definitions)]
        macro_rules! #hidden {
            ({ $($callback:tt)* } $($rest:tt)*) => { $($callback)*! { $($rest)* #bundle } };
        }
        #[doc(hidden)]
        #[allow(unused_imports)]
        #visibility use #hidden as #name;
    }
}

/// The error of an assembly that names itself.
fn contains_itself(tokens: &TokenStream) -> Option<TokenStream> {
    let list: Vec<TokenTree> = tokens.clone().into_iter().collect();
    let is_body = |token: &TokenTree| matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
    let body = list.iter().position(is_body)?;
    let name = list.get(body.checked_sub(1)?)?.to_string();
    let mut inside = Vec::new();
    named(tokens, &mut inside);
    let itself = inside.into_iter().find(|path| path_text(path) == name)?;
    let message = format!("the assembly `{name}` contains itself, and would have no end");
    Some(syn::Error::new_spanned(itself, message).to_compile_error())
}

/// `{ { declaration } { inside } }`, with a word behind if something is wrong with it.
fn bundle(declaration: &TokenStream, inside: &TokenStream, is_wrong: bool) -> TokenStream {
    // What stands before the braces says who may use the assembly, seen from where it is declared.
    let of_body = |token: TokenTree| match &token {
        TokenTree::Group(body) if body.delimiter() == Delimiter::Brace => {
            for_everywhere(token.into())
        }
        _ => token.into(),
    };
    let declaration: TokenStream = declaration.clone().into_iter().flat_map(of_body).collect();
    // Paths as the declaration names them now; the assemblies of these paths are of their own crates.
    let inside = inside.clone().into_iter().enumerate();
    let inside = inside.flat_map(|(index, token)| match index % 2 {
        0 => for_everywhere(token.into()),
        _ => token.into(),
    });
    let inside: TokenStream = inside.collect();
    let wrong = is_wrong.then(|| quote! { broken });
    quote! { { { #declaration } { #inside } #wrong } }
}

/// The declaration and the assemblies in it.
fn apart(tokens: TokenStream) -> (TokenStream, TokenStream) {
    let list: Vec<TokenTree> = tokens.clone().into_iter().collect();
    match list.as_slice() {
        [
            TokenTree::Punct(_),
            TokenTree::Group(declaration),
            TokenTree::Group(inside),
        ] => (declaration.stream(), inside.stream()),
        _ => (tokens, TokenStream::new()),
    }
}

/// With `$crate` in the place of `crate`: a path of an assembly is that of its own crate, wherever it is used.
fn for_everywhere(tokens: TokenStream) -> TokenStream {
    let mut out = TokenStream::new();
    for token in tokens {
        match token {
            TokenTree::Ident(word) if word == "crate" => {
                let mut dollar = Punct::new('$', Spacing::Alone);
                dollar.set_span(word.span());
                out.extend([
                    TokenTree::Punct(dollar),
                    TokenTree::Ident(Ident::new("crate", word.span())),
                ]);
            }
            TokenTree::Group(group) => {
                let delimiter: Delimiter = group.delimiter();
                let mut inner = Group::new(delimiter, for_everywhere(group.stream()));
                inner.set_span(group.span());
                out.extend([TokenTree::Group(inner)]);
            }
            other => out.extend([other]),
        }
    }
    out
}

/// So that two assemblies of one name in different modules of a crate have different macros, also if one is a copy of
/// the other.
fn hash(tokens: &TokenStream, place: Span) -> u64 {
    let mut hasher = DefaultHasher::new();
    tokens.to_string().hash(&mut hasher);
    let start = place.start();
    (place.file(), start.line, start.column).hash(&mut hasher);
    // Inside `macro_rules!` the place is that of the definition; the text of the span differs for each use.
    format!("{:?}", Span::call_site()).hash(&mut hasher);
    hasher.finish()
}
