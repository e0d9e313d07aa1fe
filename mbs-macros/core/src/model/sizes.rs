//! The usual sizes of coordinates and of their rates, by units: a difference that is small against them is round-off.

use super::defaults::{OF_ANGLES, Sampled, largest};
use super::elements::JointEntry;
use super::initial_pose::Guesses;
use super::resolver::Resolver;
use crate::symbolic::Expr;
use std::collections::BTreeMap;

/// The largest coordinates and rates at the start.
#[derive(Debug, Default)]
pub struct Sizes {
    /// By the unit of the coordinate.
    of: BTreeMap<String, Size>,
}

/// Of the coordinates of one unit.
#[derive(Debug, Default, Clone, Copy)]
pub(crate) struct Size {
    /// Of the coordinates themselves.
    pub(crate) positions: Sampled,
    /// Of their rates.
    pub(crate) rates: Sampled,
}

impl Sizes {
    pub(super) fn new(resolver: &mut Resolver, joints: &[JointEntry], guesses: &Guesses) -> Sizes {
        let mut starts: BTreeMap<String, [Vec<Expr>; 2]> = BTreeMap::new();
        for (local, quantity) in (0..).zip(&resolver.locals) {
            let [positions, rates] = starts.entry(quantity.unit.clone()).or_default();
            positions.push(guesses.position(local, &mut resolver.graph));
            rates.push(guesses.velocity(local, &mut resolver.graph));
        }
        for part in &resolver.parts {
            let guess = &part.guess;
            let declared = [("m", guess.velocity), ("rad", guess.spin)];
            for (unit, vector) in declared {
                let [_, rates] = starts.entry(unit.to_owned()).or_default();
                rates.extend(vector.iter().flatten());
            }
        }
        let (graph, parameters) = (&resolver.graph, &resolver.parameters);
        let of = starts.into_iter().map(|(unit, [positions, rates])| {
            let [positions, rates] =
                [positions, rates].map(|list| largest(graph, parameters, &list));
            (unit, Size { positions, rates })
        });
        let mut sizes = Sizes { of: of.collect() };
        sizes.include_arms(resolver.largest_length(joints));
        sizes
    }

    /// Places and velocities carry the rounding of arms and of turning, and angles that of 1.
    fn include_arms(&mut self, lengths: Sampled) {
        let [mut along, mut turning] = ["m", "rad"].map(|unit| self.of(unit));
        for sample in 0..lengths.len() {
            let length = along.positions[sample].max(lengths[sample]);
            let (speed, rate) = (along.rates[sample], turning.rates[sample]);
            along.positions[sample] = length;
            along.rates[sample] = speed.max(length * rate);
            turning.positions[sample] = turning.positions[sample].max(OF_ANGLES[sample]);
            if length > 0.0 {
                turning.rates[sample] = rate.max(speed / length);
            }
        }
        let sizes = [("m", along), ("rad", turning)];
        let sizes = sizes.map(|(unit, size)| (unit.to_owned(), size));
        self.of.extend(sizes);
    }

    /// That of the coordinates of a unit.
    pub(crate) fn of(&self, unit: &str) -> Size {
        self.of.get(unit).copied().unwrap_or_default()
    }
}
