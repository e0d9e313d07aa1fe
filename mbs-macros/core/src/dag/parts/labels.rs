//! Which part or joint coordinates, velocities and rows belong to.

use crate::dag::{Output, Place};
use crate::equations::System;
use crate::symbolic::{Map, Symbol};

/// Labels by index.
#[derive(Debug, Default, Clone)]
pub struct Labels {
    coordinates: Vec<u32>,
    velocities: Vec<u32>,
    rows: Vec<u32>,
    reactions: Vec<u32>,
    points: u32,
    /// The parts and joints, from label 1 on.
    names: Vec<String>,
}

/// The label of what belongs to no part.
pub(super) const NONE: u32 = 0;

impl Labels {
    pub(crate) fn new(system: &System) -> Labels {
        let mut known: Map<String, u32> = Map::default();
        let mut label = |name: &str| {
            let owner = name.split('.').next().unwrap_or(name);
            let next = known.len() as u32 + 1;
            *known.entry(owner.to_owned()).or_insert(next)
        };
        let layout = &system.layout;
        let coordinates = layout.coordinates.iter().map(|q| label(&q.name)).collect();
        let velocities = layout.velocities.iter().map(|v| label(&v.name)).collect();
        let rows = system.rows.iter().map(|row| label(&row.entry)).collect();
        let reactions = system.reactions.iter().map(|r| label(&r.joint)).collect();
        let points = known.len() as u32 + 1;
        let mut names: Vec<(u32, String)> =
            known.into_iter().map(|(name, at)| (at, name)).collect();
        names.sort_unstable();
        Labels {
            coordinates,
            velocities,
            rows,
            reactions,
            points,
            names: names.into_iter().map(|(_, name)| name).collect(),
        }
    }

    /// The part or joint of a label.
    pub(super) fn name(&self, label: u32) -> Option<&str> {
        let index = (label as usize).checked_sub(1)?;
        self.names.get(index).map(String::as_str)
    }

    /// Of an argument.
    pub(in crate::dag) fn of_symbol(&self, symbol: Symbol) -> u32 {
        let (list, index) = match symbol {
            Symbol::Stored(i) => (&self.coordinates, i),
            Symbol::Coordinate(i)
            | Symbol::Rotation(i, _)
            | Symbol::Velocity(i)
            | Symbol::Acceleration(i)
            | Symbol::VectorEntry(i) => (&self.velocities, i),
            Symbol::RowEntry(r, _)
            | Symbol::WeightedEntry(r, _)
            | Symbol::Multiplier(r)
            | Symbol::Correction(r) => (&self.rows, r),
            _ => return NONE,
        };
        list.get(index as usize).copied().unwrap_or(NONE)
    }

    /// Of a result, by row and column.
    pub(super) fn of_output(&self, output: &Output) -> [u32; 2] {
        let at = |list: &[u32], i: usize| list.get(i).copied().unwrap_or(NONE);
        let (of_rows, of_columns): (&[u32], &[u32]) = match output.sink {
            "phi" | "b" | "gamma" | "lambda" | "rates" | "pivot_loss" | "inverse_pivot"
            | "weakness" => (&self.rows, &[]),
            "a" | "a_rate" | "w" => (&self.rows, &self.velocities),
            "delassus" => (&self.rows, &self.rows),
            "reactions" => (&self.reactions, &[]),
            "points" | "outputs" | "events" => {
                return match output.place {
                    Place::Entry(i, _) | Place::Element(i) => [self.points + i as u32, NONE],
                    _ => [NONE; 2],
                };
            }
            _ => (&self.velocities, &self.velocities),
        };
        match output.place {
            Place::Element(i) => [at(of_rows, i), NONE],
            Place::Entry(i, j) | Place::Tensor(i, j, _) => [at(of_rows, i), at(of_columns, j)],
            Place::Value | Place::Constant(_) => [NONE; 2],
        }
    }
}
