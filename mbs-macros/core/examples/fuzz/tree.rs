//! Tokens as a tree that is easy to change.

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};
use std::fmt::Write;

/// A token, or tokens in brackets.
#[derive(Debug, Clone, PartialEq)]
pub enum Tree {
    Leaf(String),
    Group(Delimiter, Vec<Tree>),
}

/// A text as trees; `None` if it is no tokens of Rust.
pub fn parse(text: &str) -> Option<Vec<Tree>> {
    Some(trees(text.parse().ok()?))
}

fn trees(tokens: TokenStream) -> Vec<Tree> {
    let mut found = Vec::new();
    // Signs of one operator, such as `..=` and `==`, are one leaf.
    let mut goes_on = false;
    for token in tokens {
        let joined = match &token {
            TokenTree::Punct(sign) => sign.spacing() == Spacing::Joint,
            _ => false,
        };
        let tree = match token {
            TokenTree::Group(group) => Tree::Group(group.delimiter(), trees(group.stream())),
            other => Tree::Leaf(other.to_string()),
        };
        match (found.last_mut(), tree) {
            (Some(Tree::Leaf(last)), Tree::Leaf(sign)) if goes_on => last.push_str(&sign),
            (_, tree) => found.push(tree),
        }
        goes_on = joined;
    }
    found
}

pub fn text(trees: &[Tree]) -> String {
    let mut out = String::new();
    for tree in trees {
        match tree {
            Tree::Leaf(leaf) => {
                let _ = write!(out, "{leaf} ");
            }
            Tree::Group(delimiter, inside) => {
                let [open, close] = match delimiter {
                    Delimiter::Parenthesis => ["(", ")"],
                    Delimiter::Brace => ["{", "}"],
                    Delimiter::Bracket => ["[", "]"],
                    Delimiter::None => ["", ""],
                };
                let _ = write!(out, "{open}{}{close} ", text(inside));
            }
        }
    }
    out
}

/// The number of tokens, groups included.
pub fn count(trees: &[Tree]) -> usize {
    let inside = |tree: &Tree| match tree {
        Tree::Leaf(_) => 1,
        Tree::Group(_, inside) => 1 + count(inside),
    };
    trees.iter().map(inside).sum()
}

/// Calls `change` with the list that has the token of a number, and its place there.
pub fn at<T>(
    trees: &mut Vec<Tree>,
    number: &mut usize,
    change: &mut dyn FnMut(&mut Vec<Tree>, usize) -> T,
) -> Option<T> {
    for place in 0..trees.len() {
        if *number == 0 {
            return Some(change(trees, place));
        }
        *number -= 1;
        if let Tree::Group(_, inside) = &mut trees[place]
            && let Some(result) = at(inside, number, change)
        {
            return Some(result);
        }
    }
    None
}

/// The numbers of the tokens for which `is` holds.
pub fn places(trees: &[Tree], is: &dyn Fn(&Tree) -> bool) -> Vec<usize> {
    fn walk(trees: &[Tree], next: &mut usize, is: &dyn Fn(&Tree) -> bool, found: &mut Vec<usize>) {
        for tree in trees {
            if is(tree) {
                found.push(*next);
            }
            *next += 1;
            if let Tree::Group(_, inside) = tree {
                walk(inside, next, is, found);
            }
        }
    }
    let mut found = Vec::new();
    walk(trees, &mut 0, is, &mut found);
    found
}

/// Lists between commas.
pub fn split(trees: &[Tree]) -> Vec<Vec<Tree>> {
    let comma = |tree: &Tree| *tree == Tree::Leaf(",".to_owned());
    let parts = trees.split(comma).map(<[Tree]>::to_vec);
    parts.filter(|part| !part.is_empty()).collect()
}

pub fn join(parts: &[Vec<Tree>]) -> Vec<Tree> {
    let comma = Tree::Leaf(",".to_owned());
    parts
        .iter()
        .flat_map(|part| part.iter().cloned().chain([comma.clone()]))
        .collect()
}
