//! Other units of length, mass and time.

mod factors;
mod scaled;
mod sinks;

pub use scaled::{InUnits, Scaled};

/// New units, as multiples of the old ones: a length of 1 m is written as `length`.
#[derive(Debug, Clone, Copy)]
pub struct Units {
    /// m
    pub length: f64,
    /// kg
    pub mass: f64,
    /// s
    pub time: f64,
}

impl Units {
    /// Powers of four: square roots of such numbers are powers of two, and nothing is rounded.
    pub fn powers_of_four(length: i32, mass: i32, time: i32) -> Self {
        let power = |exponent: i32| 4f64.powi(exponent);
        Units {
            length: power(length),
            mass: power(mass),
            time: power(time),
        }
    }

    /// What an energy of 1 J is written as.
    pub fn energy(&self) -> f64 {
        self.mass * (self.length / self.time).powi(2)
    }

    /// What a quantity of 1 in this SI unit is written as.
    pub fn factor(&self, unit: &str) -> f64 {
        let (above, below) = match unit.rsplit_once('/') {
            Some((above, below)) => (above, below),
            None => (unit, ""),
        };
        let inner = match above.trim_matches(['(', ')']) {
            above if above.contains('/') => self.factor(above),
            above => self.product(above),
        };
        inner / self.product(below.trim_matches(['(', ')']))
    }

    fn product(&self, unit: &str) -> f64 {
        unit.split(' ').map(|factor| self.power(factor)).product()
    }

    fn power(&self, factor: &str) -> f64 {
        let (base, power) = match factor.split_once('^') {
            Some((base, power)) => (base, power.parse().expect("a whole power")),
            None => (factor, 1),
        };
        let base = match base {
            "" | "1" | "rad" => 1.0,
            "m" => self.length,
            "kg" => self.mass,
            "s" => self.time,
            "N" => self.energy() / self.length,
            "J" => self.energy(),
            "W" => self.energy() / self.time,
            other => panic!("the unit {other}"),
        };
        base.powi(power)
    }
}
