//! How deep an expression is nested, told from its tokens: the parser and all that comes after it go down on the stack.

use super::TOO_DEEP;
use proc_macro2::{Ident, Spacing, TokenStream, TokenTree};

/// Words of Rust with an expression or a type below them.
const ABOVE: [&str; 23] = [
    "as", "async", "await", "become", "box", "break", "const", "do", "dyn", "for", "if", "impl",
    "in", "let", "loop", "match", "move", "mut", "return", "static", "unsafe", "while", "yield",
];

fn is_above(word: &Ident) -> bool {
    ABOVE.iter().any(|known| word == known)
}

/// At least the height of the tree that these tokens will become. An error at the token where it grows beyond `limit`.
///
/// A sum of n terms is a tree of height n above its highest term; within a term every sign may be a level, and so may
/// brackets behind brackets, as in `f[0][0]`. What follows a word such as `return` or `if` is below it. A pair of brackets
/// weighs as much as the levels of grammar inside it.
pub(super) fn height(tokens: &TokenStream, limit: usize) -> syn::Result<usize> {
    const BRACKETS: usize = 3;
    let (mut sums, mut term, mut inside) = (0, 0, 0);
    let (mut highest_term, mut highest) = (0, 0);
    let (mut after_operand, mut after_brackets, mut in_operator) = (false, false, false);
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
                // Of an operator such as `==`.
                '=' if in_operator => {}
                _ => sums += 1,
            },
            TokenTree::Group(group) => {
                term += usize::from(after_brackets);
                let within = match limit.checked_sub(sums + term + BRACKETS) {
                    Some(left) => height(&group.stream(), left)?,
                    None => 0,
                };
                inside = inside.max(within + BRACKETS);
            }
            TokenTree::Ident(word) if is_above(word) => sums += 1,
            TokenTree::Ident(_) | TokenTree::Literal(_) => {}
        }
        after_operand = !matches!(token, TokenTree::Punct(_));
        after_brackets = matches!(token, TokenTree::Group(_));
        in_operator = matches!(&token, TokenTree::Punct(sign) if sign.spacing() == Spacing::Joint);
        highest_term = highest_term.max(term + inside);
        highest = highest.max(sums + highest_term);
        if highest > limit {
            return Err(syn::Error::new(token.span(), TOO_DEEP));
        }
    }
    Ok(highest)
}
