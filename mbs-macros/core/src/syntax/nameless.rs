//! Worlds in what could not be read as an entry: they are there, and their entry is wrong.

use super::chunk::{split_at_commas, without_attributes};
use crate::schema::{self, World};
use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// The world of `Spatial(…)`, which is the value of an entry without its name. `Planar(…)` with partners is a joint.
pub(super) fn nameless_world(entry: TokenStream) -> Option<World> {
    let mut tokens = entry.into_iter();
    let Some(TokenTree::Ident(kind)) = tokens.next() else {
        return None;
    };
    let world = schema::world(&kind.to_string())?;
    let is_world = match tokens.next() {
        Some(TokenTree::Group(arguments)) if arguments.delimiter() == Delimiter::Parenthesis => {
            let arguments = split_at_commas(arguments.stream());
            arguments.into_iter().all(|argument| !is_partner(argument))
        }
        Some(TokenTree::Punct(colon)) => colon.as_char() != ':',
        _ => true,
    };
    is_world.then_some(world)
}

/// Whether an argument is a partner of a joint: it has no name, or that of a partner.
fn is_partner(argument: TokenStream) -> bool {
    let mut tokens = argument.into_iter();
    let is_named = |name: &TokenTree| {
        ["parent", "child"]
            .iter()
            .any(|partner| name.to_string() == *partner)
    };
    match (tokens.next(), tokens.next()) {
        (Some(name), Some(TokenTree::Punct(equals))) if equals.as_char() == '=' => is_named(&name),
        _ => true,
    }
}

/// Whether a world is in what could not be read: without its name, or behind an entry that no comma ends.
pub(super) fn has_world(chunk: &TokenStream) -> bool {
    let tokens: Vec<TokenTree> = without_attributes(chunk).into_iter().collect();
    let is = |token: &TokenTree, text: &str| token.to_string() == text;
    let mut pairs = tokens.windows(2);
    pairs.any(|pair| is(&pair[0], "world") && is(&pair[1], ":"))
        || nameless_world(tokens.into_iter().collect()).is_some()
}
