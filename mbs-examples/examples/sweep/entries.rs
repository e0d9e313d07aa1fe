//! The methods of the sweep, each with the parameter that refines it.

use mbs_runtime::{BaumgarteSettings, BdfSettings, GeneralizedAlphaSettings, Method, Settings};

/// A method of one order.
#[derive(Clone, Copy)]
pub struct Entry {
    /// Its name in tables.
    pub label: &'static str,
    method: Method,
    order: u8,
    /// Whether a tolerance refines it, not the step.
    pub tolerant: bool,
    /// How often it is drawn.
    pub share: usize,
}

impl Entry {
    /// The factor by which the error is expected to exceed that of a run with a part of the step.
    pub fn loss(&self, part: f64) -> f64 {
        let order = if self.tolerant { 2 } else { self.order };
        part.powi(-i32::from(order))
    }

    /// Stages of a step.
    pub fn stages(&self) -> f64 {
        match self.order {
            2 => 1.0,
            4 => 7.0,
            6 => 13.0,
            _ => 17.0,
        }
    }

    /// The usual step as a multiple of that of order 2: that of less stages a second.
    pub fn stride(&self) -> f64 {
        match self.order {
            2 => 1.0,
            4 => 4.0,
            6 => 8.0,
            _ => 16.0,
        }
    }

    /// Its settings; `tolerance` counts only where it refines the method.
    pub fn settings(&self, step: f64, tolerance: f64, placement: bool) -> Settings {
        if self.tolerant && self.method == Method::TwoLevel {
            return Settings {
                step,
                placement,
                ..Settings::for_tolerance(tolerance)
            };
        }
        let method = match self.method {
            Method::Bdf(settings) => Method::Bdf(BdfSettings {
                tolerance,
                ..settings
            }),
            Method::Baumgarte(settings) => Method::Baumgarte(BaumgarteSettings {
                adaptive: settings.adaptive.map(|_| tolerance),
                ..settings
            }),
            other => other,
        };
        Settings {
            method,
            order: self.order,
            step,
            placement,
            ..Settings::default()
        }
    }
}

/// All of them.
pub fn entries() -> Vec<Entry> {
    let stabilised = Method::GeneralizedAlpha(GeneralizedAlphaSettings {
        stabilised: true,
        ..GeneralizedAlphaSettings::default()
    });
    let adaptive = Method::Baumgarte(BaumgarteSettings {
        adaptive: Some(1e-6),
        ..BaumgarteSettings::default()
    });
    let of = |label, method, order, tolerant, share| Entry {
        label,
        method,
        order,
        tolerant,
        share,
    };
    let named = |label, name, order, share| {
        Method::by_name(name).map(|method| of(label, method, order, name == "bdf", share))
    };
    [
        named("two-level 2", "two-level", 2, 8),
        named("two-level 4", "two-level", 4, 5),
        named("two-level 6", "two-level", 6, 5),
        named("two-level 8", "two-level", 8, 8),
        Some(of("two-level tolerance", Method::TwoLevel, 2, true, 4)),
        named("projected 4", "projected", 4, 2),
        named("projected 6", "projected", 6, 2),
        named("projected 8", "projected", 8, 4),
        named("alf3f-paper", "alf3f-paper", 2, 1),
        named("m-alf", "m-alf", 2, 1),
        named("index3-projections", "index3-projections", 2, 1),
        named("generalized-alpha", "generalized-alpha", 2, 1),
        Some(of("generalized-alpha stab.", stabilised, 2, false, 1)),
        named("bdf", "bdf", 2, 1),
        named("radau", "radau", 2, 1),
        named("rattle", "rattle", 2, 1),
        named("baumgarte 4", "baumgarte", 4, 1),
        named("baumgarte 8", "baumgarte", 8, 1),
        Some(of("baumgarte adaptive", adaptive, 4, true, 1)),
        named("penalty", "penalty", 2, 1),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// The entry of this label.
pub fn entry(label: &str) -> Entry {
    let found = entries().into_iter().find(|entry| entry.label == label);
    found.expect("a label of the list")
}
