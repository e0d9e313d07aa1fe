//! Numbers that are read by `serde`: NaN is `null` in JSON, as is ±∞, which comes back as NaN.

use serde::de::{Deserialize, Deserializer, Error, MapAccess, Visitor};
use std::fmt;

/// A number; `null` is NaN in formats for readers. (Other formats write NaN as a number, and may read numbers alone.)
struct Number(f64);

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        // Not as an `Option`: some formats mark its values (RON by `Some`), which were written as numbers.
        match deserializer.is_human_readable() {
            true => deserializer.deserialize_any(NumberOrNull).map(Number),
            false => f64::deserialize(deserializer).map(Number),
        }
    }
}

struct NumberOrNull;

impl<'de> Visitor<'de> for NumberOrNull {
    type Value = f64;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str("a number, or null for NaN")
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<f64, E> {
        Ok(value)
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<f64, E> {
        Ok(value as f64)
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<f64, E> {
        Ok(value as f64)
    }

    fn visit_unit<E: Error>(self) -> Result<f64, E> {
        Ok(f64::NAN)
    }

    fn visit_none<E: Error>(self) -> Result<f64, E> {
        Ok(f64::NAN)
    }

    /// `serde_json` with its feature `arbitrary_precision` has a number of any type as a map with its text.
    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<f64, A::Error> {
        let entry: Option<(String, String)> = map.next_entry()?;
        let number = entry.and_then(|(_, text)| text.parse().ok());
        number.ok_or_else(|| Error::custom("expected a number, or null for NaN"))
    }
}

/// Reads a number.
pub(crate) fn number<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    Number::deserialize(deserializer).map(|number| number.0)
}

/// Reads a list of numbers.
pub(crate) fn list<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<f64>, D::Error> {
    let numbers = Vec::<Number>::deserialize(deserializer)?;
    Ok(numbers.into_iter().map(|number| number.0).collect())
}

/// Reads a list of points.
pub(crate) fn points<'de, D>(deserializer: D) -> Result<Vec<[f64; 3]>, D::Error>
where
    D: Deserializer<'de>,
{
    let points = Vec::<[Number; 3]>::deserialize(deserializer)?;
    let points = points.into_iter();
    Ok(points.map(|point| point.map(|number| number.0)).collect())
}
