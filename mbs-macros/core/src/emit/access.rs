//! Typed access: the simulation of a mechanism by one name, and its inputs and outputs as fields.

use super::fields::{Field, fields, places, shape};
use super::items::{self, visibility};
use super::text::{doc, tokens};
use crate::contract::Capability;
use crate::dag::Program;
use crate::model::{Outline, Quantity};
use crate::syntax::{Declaration, Instance};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// The aliases of the simulations, and the two structs.
pub(super) fn emit(declaration: &Declaration, outline: &Outline, program: &Program) -> TokenStream {
    let (name, system) = (&declaration.name, items::system(declaration));
    let visibility = visibility(declaration);
    let alias = items::simulation(declaration);
    let fixed_steps = items::fixed_step_simulation(declaration);
    let sizes = tokens(&Capability::System.sizes(program));
    let about = doc(&format!("A simulation of [`{name}`]."));
    let about_fixed_steps = doc(&format!(
        "A simulation of [`{name}`] by steps of one length."
    ));
    let inputs = values(
        declaration,
        &items::inputs_and_outputs(declaration).0,
        &outline.inputs,
        "inputs",
    );
    let outputs = values(
        declaration,
        &items::inputs_and_outputs(declaration).1,
        &outline.outputs,
        "outputs",
    );
    quote! {
        #about
        #[allow(dead_code)]
        #visibility type #alias = ::mbs_runtime::Simulation<#system, #sizes>;

        #about_fixed_steps
        #[allow(dead_code)]
        #visibility type #fixed_steps = ::mbs_runtime::FixedStepSimulation<#system, #sizes>;

        #inputs
        #outputs
    }
}

fn values(declaration: &Declaration, name: &Ident, list: &[Quantity], what: &str) -> TokenStream {
    let mechanism = &declaration.name;
    let about = doc(&format!("The {what} of [`{mechanism}`]."));
    let fields = fields(declaration, list);
    let types = Types::new(name, &fields);
    let number = |place: usize| format_ident!("value_{place}");
    let visibility = visibility(declaration);
    let inner = types.list.iter().map(|(_, name, instance, fields)| {
        let assembly = &instance.definition.name;
        let about = doc(&format!("The {what} of `{assembly}` in [`{mechanism}`]."));
        let declared = declared(fields, &types);
        quote! {
            #about
            #[derive(Debug, Clone, Copy, PartialEq)]
            #[allow(clippy::all, clippy::pedantic, clippy::nursery, dead_code, non_snake_case)]
            #visibility struct #name { #declared }
        }
    });
    let declared = declared(&fields, &types);
    let made = types.made(&fields, &|place| {
        let number = number(place);
        quote! { #number }
    });
    let read = places(&fields, &quote! { self });
    let numbers = (0..list.len()).map(number);
    let count = list.len();
    quote! {
        #( #inner )*

        #about
        #[derive(Debug, Clone, Copy, PartialEq)]
        #[allow(clippy::all, clippy::pedantic, clippy::nursery, dead_code, non_snake_case)]
        #visibility struct #name { #declared }

        impl ::mbs_runtime::NamedValues for #name {
            fn from_values(fill: impl ::core::ops::FnOnce(&mut [f64])) -> Self {
                let mut values = [0.0; #count];
                fill(&mut values);
                let [#( #numbers ),*] = values;
                Self { #made }
            }

            fn with_values<T>(&self, read: impl ::core::ops::FnOnce(&[f64]) -> T) -> T {
                read(&[#( #read, )*])
            }
        }
    }
}

fn declared(fields: &[Field], types: &Types) -> TokenStream {
    let declared = fields.iter().map(|field| {
        let (name, kind) = (
            &field.name,
            field.kind(&|instance, fields| types.of(instance, fields)),
        );
        let about = field.about(|_| String::new());
        quote! { #about pub #name: #kind, }
    });
    quote! { #( #declared )* }
}

/// The structs of the values of assemblies: one for all assemblies with the same values.
struct Types<'f> {
    /// Each with its shape.
    list: Vec<(String, Ident, &'f Instance, &'f [Field<'f>])>,
}

impl<'f> Types<'f> {
    /// Of the struct of this name.
    fn new(name: &Ident, fields: &'f [Field<'f>]) -> Self {
        let mut found = Vec::new();
        fields.iter().for_each(|field| field.assemblies(&mut found));
        let mut list: Vec<(String, Ident, &Instance, &[Field])> = Vec::new();
        for (instance, fields) in found {
            let shape = shape(instance, fields);
            if list.iter().any(|(known, ..)| *known == shape) {
                continue;
            }
            let wanted = format!("{name}Of{}", instance.definition.name);
            let is_free = |name: &Ident| list.iter().all(|(_, known, ..)| known != name);
            let own = (1..)
                .map(|number| match number {
                    1 => format_ident!("{wanted}", span = name.span()),
                    _ => format_ident!("{wanted}{number}", span = name.span()),
                })
                .find(is_free);
            list.extend(own.map(|own| (shape, own, instance, fields)));
        }
        Types { list }
    }

    fn of(&self, instance: &Instance, fields: &[Field]) -> TokenStream {
        let shape = shape(instance, fields);
        let known = self.list.iter().find(|(known, ..)| *known == shape);
        known.map_or_else(TokenStream::new, |(_, name, ..)| quote! { #name })
    }

    /// The fields with their values.
    fn made(&self, fields: &[Field], number: &dyn Fn(usize) -> TokenStream) -> TokenStream {
        let made = fields.iter().map(|field| {
            let name = &field.name;
            let value = field.value(&|place, _| number(place), &|instance, fields| {
                let (kind, inner) = (self.of(instance, fields), self.made(fields, number));
                quote! { #kind { #inner } }
            });
            quote! { #name: #value, }
        });
        quote! { #( #made )* }
    }
}
