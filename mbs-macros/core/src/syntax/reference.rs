//! What an expression names: the one place that reads a name out of an expression.
//!
//! The name of an entry of an assembly is a path from the root, with indices as arguments: `::front::arm` and
//! `::leg::<2>::rod` are written for `front.arm` and `leg[2].rod` when the assembly is put in place.

use super::children::inner;
use super::whole::whole;
use crate::names;
use proc_macro2::{Ident, Literal, Span};
use syn::punctuated::Punctuated;
use syn::{
    AngleBracketedGenericArguments, Expr, ExprLit, ExprPath, GenericArgument, LitInt, Path,
    PathArguments, PathSegment, Token,
};

/// The name of an entry, or of a member of a family: `crank`, `crank[3]`, `rod[3][4]`, `front.arm`, `leg[2].rod[1]`.
#[derive(Debug)]
pub struct Reference<'e> {
    /// The last word.
    pub word: &'e Ident,
    /// All of it but the last indices.
    pub base: String,
    /// The last indices, in order. They need not be those of a member.
    pub indices: Vec<i64>,
}

impl Reference<'_> {
    /// As `Name` writes it.
    pub fn text(&self) -> String {
        with_indices(self.base.clone(), &self.indices)
    }
}

/// The name that an expression is; `None` if it is none.
///
/// # Errors
/// An index is no whole number.
pub fn reference(expr: &Expr) -> Option<syn::Result<Reference<'_>>> {
    match inner(expr) {
        Expr::Path(path) if path.path.get_ident().is_some() || is_marked(path) => {
            of_path(&path.path).map(Ok)
        }
        Expr::Index(index) => {
            let of = reference(&index.expr)?;
            Some(of.and_then(|mut of| {
                of.indices.push(whole(&index.index)?);
                Ok(of)
            }))
        }
        _ => None,
    }
}

/// The path that stands for `member` inside the assembly that `base` names.
pub(super) fn member_of(base: &Expr, member: &Ident) -> Option<Expr> {
    let mut path = match inner(base) {
        Expr::Path(path) if path.path.get_ident().is_some() || is_marked(path) => path.path.clone(),
        Expr::Index(index) => indexed(&index.expr, &index.index)?,
        _ => return None,
    };
    path.segments.push(PathSegment::from(member.clone()));
    Some(as_expression(path))
}

/// The path from the root that stands for an entry in no assembly.
pub(super) fn from_root(name: &Ident) -> Expr {
    as_expression(Path::from(name.clone()))
}

/// The path that stands for `member` inside the assembly of this name, all at the place of the member.
pub(super) fn path_to(assembly: &str, member: &Ident) -> Expr {
    let mut segments = Punctuated::new();
    for part in assembly.split('.') {
        let (word, indices, _) = names::split(part);
        let arguments = indices.into_iter().map(literal);
        let word = Ident::new(word, member.span());
        segments.push(segment(&word, arguments.collect()));
    }
    segments.push(PathSegment::from(member.clone()));
    as_expression(Path {
        leading_colon: None,
        segments,
    })
}

/// A name with one more index on its last segment.
fn indexed(base: &Expr, index: &Expr) -> Option<Path> {
    let mut path = match inner(base) {
        Expr::Path(path) => path.path.clone(),
        Expr::Index(index) => indexed(&index.expr, &index.index)?,
        _ => return None,
    };
    let index = usize::try_from(whole(index).ok()?).ok()?;
    let last = path.segments.last_mut()?;
    let mut indices = indices_of(last);
    indices.push(i64::try_from(index).ok()?);
    let arguments = indices
        .iter()
        .filter_map(|&index| usize::try_from(index).ok());
    *last = segment(&last.ident, arguments.map(literal).collect());
    Some(path)
}

fn of_path(path: &Path) -> Option<Reference<'_>> {
    let word = &path.segments.last()?.ident;
    let mut segments = path.segments.iter();
    let first = segments.next()?;
    let mut base = first.ident.to_string();
    let mut indices = indices_of(first);
    for next in segments {
        base = with_indices(base, &indices) + "." + &next.ident.to_string();
        indices = indices_of(next);
    }
    Some(Reference {
        word,
        base,
        indices,
    })
}

fn with_indices(base: String, indices: &[i64]) -> String {
    let indices = indices.iter();
    indices.fold(base, |text, index| text + &format!("[{index}]"))
}

fn segment(word: &Ident, arguments: Punctuated<GenericArgument, Token![,]>) -> PathSegment {
    let arguments = match arguments.is_empty() {
        true => PathArguments::None,
        false => PathArguments::AngleBracketed(AngleBracketedGenericArguments {
            colon2_token: Some(Token![::](word.span())),
            lt_token: Token![<](word.span()),
            args: arguments,
            gt_token: Token![>](word.span()),
        }),
    };
    PathSegment {
        ident: word.clone(),
        arguments,
    }
}

fn literal(index: usize) -> GenericArgument {
    GenericArgument::Const(Expr::Lit(ExprLit {
        attrs: Vec::new(),
        lit: LitInt::from(Literal::usize_unsuffixed(index)).into(),
    }))
}

fn indices_of(segment: &PathSegment) -> Vec<i64> {
    let PathArguments::AngleBracketed(arguments) = &segment.arguments else {
        return Vec::new();
    };
    let arguments = arguments.args.iter();
    let indices = arguments.filter_map(|argument| match argument {
        GenericArgument::Const(index) => whole(index).ok(),
        _ => None,
    });
    indices.collect()
}

/// With the mark.
fn as_expression(mut path: Path) -> Expr {
    let first = path.segments.first();
    let span = first.map_or_else(Span::call_site, |first| first.ident.span());
    path.leading_colon = Some(Token![::](span));
    Expr::Path(ExprPath {
        attrs: Vec::new(),
        qself: None,
        path,
    })
}

fn is_marked(path: &ExprPath) -> bool {
    path.path.leading_colon.is_some()
}
