//! Tables: constants of the system, or fields of it where some of their points are parameters.

use super::body::{number, symbol_text};
use super::names::table_field;
use super::text::doc;
use crate::symbolic::{Beyond, Datum, Graph, Interpolation, Table, TableData};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use std::fmt::Write;
use std::sync::Arc;

/// The associated constants of tables of numbers.
pub(super) fn constants(tables: &[Arc<Table>]) -> impl Iterator<Item = TokenStream> {
    let tables = tables.iter().filter(|table| table.data.is_none());
    tables.map(|table| {
        let name = format_ident!("TABLE_{}", table.index);
        let about = doc(&table.name);
        let (knots, pieces) = (table.knots(), table.pieces());
        let pieces = pieces.map(|piece| quote! { [#( #piece ),*] });
        quote! {
            #about
            const #name: ::mbs_runtime::generated::Table<'static> = ::mbs_runtime::generated::Table {
                knots: &[#( #knots ),*],
                pieces: &[#( #pieces ),*],
            };
        }
    })
}

/// The fields of tables with parameters.
pub(super) fn fields(tables: &[Arc<Table>]) -> impl Iterator<Item = TokenStream> {
    with_parameters(tables).map(|(table, _)| {
        let name = format_ident!("{}", table_field(table));
        let about = doc(&table.name);
        let knots = table.knots().count();
        let pieces = knots + 1;
        quote! {
            #about
            #name: ::mbs_runtime::generated::MeasuredTable<#knots, #pieces>,
        }
    })
}

/// Statements of `prepare` that compute these fields.
pub(super) fn preparation(graph: &Graph, tables: &[Arc<Table>]) -> String {
    let mut out = String::new();
    for (table, data) in with_parameters(tables) {
        let [x, y] = data.points.each_ref().map(|points| {
            let points = points.iter().map(|datum| match *datum {
                Datum::Number(value) => number(value.value()),
                Datum::Parameter(symbol) => symbol_text(graph, symbol, ["", "self."]),
            });
            points.collect::<Vec<_>>().join(", ")
        });
        let interpolation = match data.interpolation {
            Interpolation::Cubic => "Cubic",
            Interpolation::Linear => "Linear",
        };
        let beyond = match data.beyond {
            Beyond::Linear => "Linear",
            Beyond::Constant => "Constant",
            Beyond::Periodic => "Periodic",
        };
        let _ = writeln!(
            out,
            "let {} = ::mbs_runtime::generated::MeasuredTable::through({:?}, [{x}], [{y}], ::mbs_runtime::generated::Interpolation::{interpolation}, ::mbs_runtime::generated::Beyond::{beyond})?;",
            table_field(table),
            table.name
        );
    }
    out
}

/// The names of these fields.
pub(super) fn names(tables: &[Arc<Table>]) -> impl Iterator<Item = String> {
    with_parameters(tables).map(|(table, _)| table_field(table))
}

fn with_parameters(tables: &[Arc<Table>]) -> impl Iterator<Item = (&Table, &TableData)> {
    tables
        .iter()
        .filter_map(|table| Some((&**table, table.data.as_ref()?)))
}
