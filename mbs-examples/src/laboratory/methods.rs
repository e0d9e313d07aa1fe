//! The methods that are compared, each with the settings that its users would choose.

use mbs_runtime::{
    BaumgarteSettings, BdfSettings, GeneralizedAlphaSettings, Method, PaperSettings,
    PenaltySettings, Settings,
};

/// Algorithm 1 halves its steps down to this fraction of the step; the halved steps cannot be interrupted.
const SMALLEST: f64 = 1e-3;
/// The penalty that Algorithm 1 needs at the singular poses of the paper's mechanisms with steps of 1e-3 s; its default
/// is for longer steps.
const HEAVY: f64 = 1e4;
/// Its label.
const PAPER_HEAVY: &str = "alf3f-paper 1e4";

/// The parameter that refines a method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Control {
    /// The length of its steps.
    Step,
    /// The tolerance of its error control.
    Tolerance,
    /// The accuracy from which the runtime chooses method, order and steps.
    Accuracy,
}

impl Control {
    /// `step_s`, `tolerance` or `accuracy`.
    pub fn name(self) -> &'static str {
        match self {
            Control::Step => "step_s",
            Control::Tolerance => "tolerance",
            Control::Accuracy => "accuracy",
        }
    }
}

/// A method of one order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Entry {
    /// Unique, for legends and files: `two-level 4`.
    pub label: &'static str,
    /// With its settings.
    pub method: Method,
    /// [`Settings::order`], where the method has orders to choose from.
    pub order: u8,
    /// The parameter that refines it.
    pub control: Control,
}

impl Entry {
    /// A method by its name on the command line.
    fn named(label: &'static str, name: &str, order: u8) -> Option<Self> {
        Some(Entry::of(label, Method::by_name(name)?, order))
    }

    /// A method with these settings.
    fn of(label: &'static str, method: Method, order: u8) -> Self {
        let control = match method {
            Method::Bdf(_)
            | Method::Baumgarte(BaumgarteSettings {
                adaptive: Some(_), ..
            }) => Control::Tolerance,
            _ => Control::Step,
        };
        Entry {
            label,
            method,
            order,
            control,
        }
    }

    /// Its settings for a run of a mechanism over `duration` seconds; `control` is a step (s), a tolerance or an accuracy. Settings
    /// with the unit of a frequency depend on the duration: for motions of milliseconds a user chooses a stiffer
    /// stabilisation than for motions of seconds. Runs of ten seconds have the default values.
    pub fn settings(&self, duration: f64, control: f64) -> Settings {
        let pace = 10.0 / duration;
        // The first step.
        let first = duration / 1000.0;
        match (self.control, self.method) {
            (Control::Accuracy, _) => {
                return Settings {
                    step: first,
                    ..Settings::accuracy(control)
                };
            }
            (Control::Tolerance, Method::TwoLevel) => {
                return Settings {
                    step: first,
                    ..Settings::for_tolerance(control)
                };
            }
            _ => {}
        }
        let method = match self.method {
            Method::Baumgarte(settings) => Method::Baumgarte(BaumgarteSettings {
                gain: pace * settings.gain,
                adaptive: settings.adaptive.map(|_| control),
            }),
            Method::Penalty(settings) => Method::Penalty(PenaltySettings {
                penalty: pace * pace * settings.penalty,
                ..settings
            }),
            Method::Paper(settings) => Method::Paper(PaperSettings {
                smallest_step: SMALLEST * control,
                ..settings
            }),
            Method::MAlf(settings) => Method::MAlf(PaperSettings {
                penalty: pace * pace * settings.penalty,
                max_penalty: pace * pace * settings.max_penalty,
                smallest_step: SMALLEST * control,
                ..settings
            }),
            Method::Bdf(settings) => Method::Bdf(BdfSettings {
                tolerance: control,
                ..settings
            }),
            other => other,
        };
        let step = match self.control {
            Control::Step => control,
            // The longest step that it may take.
            Control::Tolerance | Control::Accuracy => duration / 50.0,
        };
        Settings {
            method,
            order: self.order,
            step,
            ..Settings::default()
        }
    }
}

/// Every method of the charts, ours first.
pub fn entries() -> Vec<Entry> {
    let stabilised = Method::GeneralizedAlpha(GeneralizedAlphaSettings {
        stabilised: true,
        ..GeneralizedAlphaSettings::default()
    });
    let adaptive = Method::Baumgarte(BaumgarteSettings {
        adaptive: Some(1e-6),
        ..BaumgarteSettings::default()
    });
    let heavy = Method::Paper(PaperSettings {
        penalty: HEAVY,
        ..PaperSettings::default()
    });
    let with = |label, method| Some(Entry::of(label, method, 2));
    let chosen = |label, control| {
        Some(Entry {
            control,
            ..Entry::of(label, Method::TwoLevel, 2)
        })
    };
    [
        chosen("accuracy", Control::Accuracy),
        Entry::named("two-level 2", "two-level", 2),
        Entry::named("two-level 4", "two-level", 4),
        Entry::named("two-level 6", "two-level", 6),
        Entry::named("two-level 8", "two-level", 8),
        chosen("two-level tolerance", Control::Tolerance),
        Entry::named("alf3f-paper", "alf3f-paper", 2),
        with(PAPER_HEAVY, heavy),
        Entry::named("m-alf", "m-alf", 2),
        Entry::named("index3-projections", "index3-projections", 2),
        Entry::named("generalized-alpha", "generalized-alpha", 2),
        with("generalized-alpha stab.", stabilised),
        Entry::named("bdf", "bdf", 2),
        Entry::named("radau", "radau", 2),
        Entry::named("rattle", "rattle", 2),
        Entry::named("projected 4", "projected", 4),
        Entry::named("projected 6", "projected", 6),
        Entry::named("projected 8", "projected", 8),
        Entry::named("baumgarte 4", "baumgarte", 4),
        Entry::named("baumgarte 8", "baumgarte", 8),
        with("baumgarte adaptive", adaptive),
        Entry::named("penalty", "penalty", 2),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// The entry of this label.
pub fn entry(label: &str) -> Option<Entry> {
    entries().into_iter().find(|entry| entry.label == label)
}
