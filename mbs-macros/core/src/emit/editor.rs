//! The declaration once more, as Rust that only an editor reads: its tokens, with their spans, are names, structs and fields of
//! that Rust, so that the editor finds what they are.
//!
//! ```text
//! crank: Bar(mass = 0.36_kg, length = r)      static crank: members::Bar = any();
//!                                             Bar { mass: given(0.36_kg), length: given(r), ..any() };
//! ```
//!
//! It never runs, and rustc never sees it. It is made from the tokens alone: an editor asks for what can follow `crank.`
//! while the declaration is wrong.

mod entry;
mod language;

use crate::schema::{Group, Kind, Kinds, World};
use entry::{Argument, Call, Entry, entries};
use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use quote::quote;

/// Whether the macro runs for rust-analyzer, whose server of macros has its name.
pub fn is_editor() -> bool {
    let program = std::env::current_exe();
    let name = program.as_deref().ok();
    let name = name.and_then(std::path::Path::file_stem);
    name.is_some_and(|name| name.to_string_lossy().starts_with("rust-analyzer"))
}

/// The Rust of a declaration, right or wrong.
pub fn sketch(tokens: &TokenStream, kinds: &'static Kinds) -> TokenStream {
    let entries = entries(tokens);
    let world = entries.iter().find(|entry| entry.name == "world");
    let world =
        world.and_then(|entry| crate::schema::world(&entry.calls.first()?.kind.to_string()));
    let world = world.unwrap_or(World::Planar);
    let language = language::emit(world, kinds);
    let kind = |entry: &Entry, call: &Call| match entry.name == "world" {
        true => Some(world.kind()),
        false => kinds.kind(world, &call.kind.to_string()),
    };
    let own = entries.iter().filter(|entry| entry.name != "world");
    let names = own.map(|entry| {
        let first = entry.calls.first();
        named(entry, first.and_then(|call| kind(entry, call)))
    });
    let uses = entries.iter().map(|entry| {
        let calls = entry.calls.iter().map(|call| used(call, kind(entry, call)));
        match &entry.indices {
            Some(indices) => quote! { let _ = |#indices| { #( #calls )* }; },
            None => quote! { #( #calls )* },
        }
    });
    quote! {
        #[allow(warnings, non_upper_case_globals, non_snake_case, non_camel_case_types)]
        const _: () = {
            #language
            fn declaration() {
                #( #names )*
                #( #uses )*
            }
        };
    }
}

/// The item or variable of a name.
fn named(entry: &Entry, kind: Option<&Kind>) -> TokenStream {
    let (name, doc) = (&entry.name, &entry.doc);
    let group = kind.map(|kind| kind.group);
    let members = match (group, kind.map_or("", |kind| kind.name)) {
        (_, "Let") => {
            let first = entry.calls.first();
            let value = first.and_then(|call| call.arguments.first());
            let value = value.map(|argument| &argument.value);
            return quote! { let #name = #value; };
        }
        (Some(Group::Part | Group::Joint | Group::Constraint | Group::Force), kind) => {
            let kind = Ident::new(kind, Span::call_site());
            quote! { members::#kind }
        }
        (_, "Table") => quote! { fn(f64) -> f64 },
        (_, "Point") => quote! { members::Place },
        _ => quote! { f64 },
    };
    let of = (0..entry.levels).fold(members, |of, _| quote! { members::Family<#of> });
    let about = kind.map_or("", |kind| kind.doc);
    quote! {
        #doc
        #[doc = ""]
        #[doc = #about]
        static #name: #of = any();
    }
}

/// A kind with its arguments.
fn used(call: &Call, kind: Option<&Kind>) -> TokenStream {
    let fields = kind.map_or(&[][..], |kind| kind.fields);
    let mut positional = fields.iter().filter(|field| field.positional);
    let arguments = call.arguments.iter().map(|Argument { name, value }| {
        let by_place = || {
            Some(TokenTree::from(Ident::new(
                positional.next()?.name,
                Span::call_site(),
            )))
        };
        let field = name.clone().map(TokenTree::from).or_else(by_place);
        match field {
            Some(field) => quote! { #field: given(#value), },
            // The beginning of a name.
            None if value.clone().into_iter().count() == 1 => quote! { #value, },
            None => TokenStream::new(),
        }
    });
    let arguments: TokenStream = arguments.collect();
    let kind = &call.kind;
    quote! { #kind { #arguments ..any() }; }
}
