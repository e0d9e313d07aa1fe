//! Public fields for values: one number, the components of a vector, or the array of a family.

use super::items;
use super::text::doc;
use crate::model::Quantity;
use crate::names::split;
use crate::syntax::Declaration;
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use std::collections::HashMap;

/// A field, for some of the values of a list.
pub(super) struct Field<'q> {
    pub name: Ident,
    /// The values of the list, each with the indices of its member: members in order, components in order.
    values: Vec<(Vec<usize>, usize, &'q Quantity)>,
    /// The number of members along each index; none for what is no family.
    sizes: Vec<usize>,
    is_vector: bool,
}

/// The fields of a list.
pub(super) fn fields<'q>(declaration: &Declaration, list: &'q [Quantity]) -> Vec<Field<'q>> {
    let mut fields: Vec<Field> = Vec::new();
    let mut known: HashMap<&str, usize> = HashMap::new();
    for (place, quantity) in list.iter().enumerate() {
        let (word, indices, component) = split(&quantity.name);
        let at = *known.entry(word).or_insert_with(|| {
            let family = declaration.family(word);
            fields.push(Field {
                name: items::field(declaration, word),
                values: Vec::new(),
                sizes: family.map_or_else(Vec::new, |family| family.sizes()),
                is_vector: !component.is_empty(),
            });
            fields.len() - 1
        });
        fields[at].values.push((indices, place, quantity));
    }
    for field in &mut fields {
        // Components of a member keep their order.
        field.values.sort_by(|one, other| one.0.cmp(&other.0));
    }
    fields
}

impl Field<'_> {
    /// Its type.
    pub(super) fn kind(&self) -> TokenStream {
        let width = self.width();
        let member = match self.is_vector {
            true => quote! { ::mbs_runtime::nalgebra::SVector<f64, #width> },
            false => quote! { f64 },
        };
        array_of(&self.sizes, member)
    }

    /// Its documentation, with the unit, and what else is to be said about its values.
    pub(super) fn about(&self, of_values: impl Fn(&[f64]) -> String) -> TokenStream {
        let mut quantities = self.quantities();
        let Some(first) = quantities.next() else {
            return TokenStream::new();
        };
        let same = quantities.all(|other| other.unit == first.unit);
        let about = match same {
            true => items::documented(&first.doc, &first.unit),
            false => format!("{} (in the units of its members)", first.doc),
        };
        let defaults: Vec<f64> = self.quantities().map(|value| value.default).collect();
        let about = about.strip_suffix(')').unwrap_or(&about);
        doc(&format!("{about}{})", of_values(&defaults)))
    }

    /// Its value, from those of the list.
    pub(super) fn value(&self, of: impl Fn(usize, &Quantity) -> TokenStream) -> TokenStream {
        let values = self.values.iter();
        let values: Vec<TokenStream> = values.map(|(_, at, quantity)| of(*at, quantity)).collect();
        let members = values
            .chunks(self.width())
            .map(|member| match self.is_vector {
                true => quote! { ::mbs_runtime::nalgebra::SVector::from([#(#member),*]) },
                false => quote! { #(#member)* },
            });
        nested(&self.sizes, &mut members.into_iter())
    }

    /// Where each of its values is, by its place in the list.
    pub(super) fn places(&self) -> Vec<(usize, TokenStream)> {
        let (name, width) = (&self.name, self.width());
        let places = self.values.iter().enumerate();
        let places = places.map(|(nth, (indices, at, _))| {
            let component = self.is_vector.then_some(nth % width);
            let indices = indices.iter().copied().chain(component);
            let indices = indices.map(proc_macro2::Literal::usize_unsuffixed);
            (*at, quote! { self.#name #([#indices])* })
        });
        places.collect()
    }

    fn quantities(&self) -> impl Iterator<Item = &Quantity> {
        self.values.iter().map(|(_, _, quantity)| *quantity)
    }

    /// Numbers of a member.
    fn width(&self) -> usize {
        let members: usize = self.sizes.iter().product();
        (self.values.len() / members.max(1)).max(1)
    }
}

/// Where the values of a list are, in its order.
pub(super) fn places(fields: &[Field]) -> Vec<TokenStream> {
    let mut places: Vec<(usize, TokenStream)> = fields.iter().flat_map(Field::places).collect();
    places.sort_by_key(|(at, _)| *at);
    places.into_iter().map(|(_, place)| place).collect()
}

/// The type of an array with these numbers of members.
pub(super) fn array_of(sizes: &[usize], member: TokenStream) -> TokenStream {
    let sizes = sizes.iter().rev();
    sizes.fold(member, |array, size| quote! { [#array; #size] })
}

/// An array with the same value everywhere.
pub(super) fn filled(sizes: &[usize], value: TokenStream) -> TokenStream {
    array_of(sizes, value)
}

fn nested(sizes: &[usize], members: &mut impl Iterator<Item = TokenStream>) -> TokenStream {
    match sizes {
        [] => members.next().unwrap_or_default(),
        [size, inner @ ..] => {
            let items: Vec<TokenStream> = (0..*size).map(|_| nested(inner, members)).collect();
            quote! { [#(#items),*] }
        }
    }
}
