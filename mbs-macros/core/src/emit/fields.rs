//! Public fields for values: one number, the components of a vector, the array of a family, or the values of an assembly.

use super::items;
use super::text::doc;
use crate::model::Quantity;
use crate::names::split;
use crate::syntax::{Declaration, Family, Instance, Name, path_text};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::{BTreeMap, HashMap};

/// A field, for some of the values of a list.
pub(super) struct Field<'q> {
    pub name: Ident,
    /// The number of members along each index; none for what is no family.
    sizes: Vec<usize>,
    /// In the order of their indices.
    members: BTreeMap<Vec<usize>, Content<'q>>,
}

/// What a field, or a member of its array, holds; values are given by their place in the list.
pub(super) enum Content<'q> {
    Number(usize, &'q Quantity),
    Vector(Vec<(usize, &'q Quantity)>),
    Assembly(&'q Instance, Vec<Field<'q>>),
}

/// The types of assemblies in fields.
pub(super) type TypeOf<'t> = &'t dyn Fn(&Instance, &[Field]) -> TokenStream;

/// The fields of a list.
pub(super) fn fields<'q>(declaration: &'q Declaration, list: &'q [Quantity]) -> Vec<Field<'q>> {
    let list: Vec<(usize, &Quantity)> = list.iter().enumerate().collect();
    let instances = declaration.instances.iter();
    let names = Names {
        // The last of these has the name: an assembly, what is declared alone, a family.
        declared: (declaration.instances.iter().map(|instance| &instance.name))
            .chain(declaration.entries.iter().map(|entry| &entry.name))
            .chain(declaration.families.iter().map(|family| &family.name))
            .map(|name| (name.as_str(), name))
            .collect(),
        families: (declaration.families.iter())
            .map(|family| (family.name.as_str(), family))
            .collect(),
        instances: instances
            .map(|instance| (instance.name.as_str(), instance))
            .collect(),
    };
    fields_in(&names, "", &list)
}

/// What is declared under a name.
struct Names<'q> {
    declared: HashMap<&'q str, &'q Name>,
    families: HashMap<&'q str, &'q Family>,
    instances: HashMap<&'q str, &'q Instance>,
}

impl Names<'_> {
    /// The field `word` of a value of this name, or of a family of them, with the span of its declaration.
    fn field(&self, name: &str, word: &str) -> Ident {
        let declared = self.declared.get(name);
        declared.map_or_else(|| format_ident!("{word}"), |name| name.word().clone())
    }
}

/// Of the values whose names begin with `assembly`.
fn fields_in<'q>(
    names: &Names<'q>,
    assembly: &str,
    list: &[(usize, &'q Quantity)],
) -> Vec<Field<'q>> {
    let mut fields: Vec<Field> = Vec::new();
    let mut known: HashMap<&str, usize> = HashMap::new();
    let mut inner: BTreeMap<String, Vec<(usize, &Quantity)>> = BTreeMap::new();
    for &(place, quantity) in list {
        let own = &quantity.name[assembly.len()..];
        let (word, indices, component) = split(own);
        let base = format!("{assembly}{word}");
        let at = *known.entry(word).or_insert_with(|| {
            let family = names.families.get(base.as_str());
            fields.push(Field {
                name: names.field(&base, word),
                sizes: family.map_or_else(Vec::new, |family| family.sizes()),
                members: BTreeMap::new(),
            });
            fields.len() - 1
        });
        let text = &quantity.name[..quantity.name.len() - component.len()];
        let members = &mut fields[at].members;
        if let Some(&instance) = names.instances.get(text) {
            members.insert(indices, Content::Assembly(instance, Vec::new()));
            inner
                .entry(text.to_owned())
                .or_default()
                .push((place, quantity));
        } else if component.is_empty() {
            members.insert(indices, Content::Number(place, quantity));
        } else if let Content::Vector(values) = members
            .entry(indices)
            .or_insert_with(|| Content::Vector(Vec::new()))
        {
            values.push((place, quantity));
        }
    }
    for content in fields
        .iter_mut()
        .flat_map(|field| field.members.values_mut())
    {
        if let Content::Assembly(instance, inside) = content
            && let Some(list) = inner.get(instance.name.as_str())
        {
            *inside = fields_in(names, &format!("{}.", instance.name), list);
        }
    }
    fields
}

impl<'q> Field<'q> {
    /// Its type.
    pub(super) fn kind(&self, of: TypeOf) -> TokenStream {
        let member = match self.members.values().next() {
            Some(Content::Vector(values)) => {
                let width = values.len();
                quote! { ::mbs_runtime::nalgebra::SVector<f64, #width> }
            }
            Some(Content::Assembly(instance, fields)) => of(instance, fields),
            Some(Content::Number(..)) | None => quote! { f64 },
        };
        array_of(&self.sizes, member)
    }

    /// Its documentation, with the unit, and what else is to be said about its values.
    pub(super) fn about(&self, of_values: impl Fn(&[f64]) -> String) -> TokenStream {
        if let Some(Content::Assembly(instance, _)) = self.members.values().next() {
            return doc(&format!("Of the assembly `{}`.", instance.definition.name));
        }
        let quantities: Vec<&Quantity> = self
            .members
            .values()
            .flat_map(Content::quantities)
            .collect();
        let Some(first) = quantities.first() else {
            return TokenStream::new();
        };
        let about = match quantities.iter().all(|other| other.unit == first.unit) {
            true => items::documented(&first.doc, &first.unit),
            false => format!("{} (in the units of its members)", first.doc),
        };
        if let Some(constant) = &first.constant {
            let constant = quote! { #constant }.to_string().replace(' ', "");
            return doc(&format!("{} `{constant}` by default.", first.doc));
        }
        let defaults: Vec<f64> = quantities.iter().map(|value| value.default).collect();
        let about = about.strip_suffix(')').unwrap_or(&about);
        doc(&format!("{about}{})", of_values(&defaults)))
    }

    /// Its value, from those of the list. `made` makes that of an assembly.
    pub(super) fn value(
        &self,
        of: &dyn Fn(usize, &Quantity) -> TokenStream,
        made: &dyn Fn(&Instance, &[Field]) -> TokenStream,
    ) -> TokenStream {
        let mut members = self.members.values().map(|content| match content {
            Content::Number(place, quantity) => of(*place, quantity),
            Content::Vector(values) => {
                let values = values.iter().map(|(place, quantity)| of(*place, quantity));
                quote! { ::core::convert::Into::into([#(#values),*]) }
            }
            Content::Assembly(instance, fields) => made(instance, fields),
        });
        nested(&self.sizes, &mut members)
    }

    /// Where each of its values is, by its place in the list.
    fn places(&self, base: &TokenStream, list: &mut Vec<(usize, TokenStream)>) {
        let name = &self.name;
        for (indices, content) in &self.members {
            let indices = indices.iter().copied().map(Literal::usize_unsuffixed);
            let member = quote! { #base.#name #([#indices])* };
            match content {
                Content::Number(place, _) => list.push((*place, member)),
                Content::Vector(values) => {
                    let components = values.iter().enumerate().map(|(nth, (place, _))| {
                        let nth = Literal::usize_unsuffixed(nth);
                        (*place, quote! { #member[#nth] })
                    });
                    list.extend(components);
                }
                Content::Assembly(_, fields) => {
                    fields.iter().for_each(|field| field.places(&member, list));
                }
            }
        }
    }

    /// The assemblies in it, inner ones first.
    pub(super) fn assemblies<'f>(&'f self, list: &mut Vec<(&'q Instance, &'f [Field<'q>])>) {
        for content in self.members.values() {
            if let Content::Assembly(instance, fields) = content {
                fields.iter().for_each(|field| field.assemblies(list));
                list.push((instance, fields));
            }
        }
    }

    /// Whether its members have different types.
    pub(super) fn has_other_members(&self) -> bool {
        let mut shapes = self.members.values().map(Content::shape);
        let first = shapes.next();
        let missing = self.members.len() != self.sizes.iter().product::<usize>();
        missing || shapes.any(|shape| Some(shape) != first)
    }

    /// What its members hold.
    pub(super) fn contents(&self) -> impl Iterator<Item = &Content<'q>> {
        self.members.values()
    }

    /// What its type depends on.
    fn shape(&self) -> String {
        let content = self.members.values().next().map(Content::shape);
        let content = content.unwrap_or_default();
        format!("{}{:?}{content}", self.name, self.sizes)
    }
}

impl Content<'_> {
    /// What its type depends on.
    fn shape(&self) -> String {
        match self {
            Content::Assembly(instance, fields) => shape(instance, fields),
            Content::Vector(values) => values.len().to_string(),
            Content::Number(..) => String::new(),
        }
    }

    fn quantities(&self) -> Vec<&Quantity> {
        match self {
            Content::Number(_, quantity) => vec![quantity],
            Content::Vector(values) => values.iter().map(|(_, quantity)| *quantity).collect(),
            Content::Assembly(..) => Vec::new(),
        }
    }
}

/// What the type of the values of an assembly depends on.
pub(super) fn shape(instance: &Instance, fields: &[Field]) -> String {
    let fields: String = fields.iter().map(|field| field.shape() + ";").collect();
    format!("{}{{{fields}}}", path_text(&instance.path))
}

/// Where the values of a list are, in its order, in fields of `base`.
pub(super) fn places(fields: &[Field], base: &TokenStream) -> Vec<TokenStream> {
    let mut places = Vec::new();
    fields
        .iter()
        .for_each(|field| field.places(base, &mut places));
    places.sort_by_key(|(at, _)| *at);
    places.into_iter().map(|(_, place)| place).collect()
}

/// Their values, in the order of the list.
pub(super) fn quantities<'q>(fields: &[Field<'q>]) -> Vec<&'q Quantity> {
    fn note<'q>(fields: &[Field<'q>], list: &mut Vec<(usize, &'q Quantity)>) {
        for content in fields.iter().flat_map(|field| field.members.values()) {
            match content {
                Content::Number(place, quantity) => list.push((*place, quantity)),
                Content::Vector(values) => list.extend(values.iter().copied()),
                Content::Assembly(_, fields) => note(fields, list),
            }
        }
    }
    let mut list = Vec::new();
    note(fields, &mut list);
    list.sort_by_key(|(place, _)| *place);
    list.into_iter().map(|(_, quantity)| quantity).collect()
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

fn nested(sizes: &[usize], members: &mut dyn Iterator<Item = TokenStream>) -> TokenStream {
    match sizes {
        [] => members.next().unwrap_or_default(),
        [size, inner @ ..] => {
            let items: Vec<TokenStream> = (0..*size).map(|_| nested(inner, members)).collect();
            quote! { [#(#items),*] }
        }
    }
}
