//! The request of a user to `mbs simulate`, checked before the run.

use std::ops::RangeInclusive;

use mbs_examples::scene::Scene;
use mbs_runtime::{AnySimulation, Method, Settings};

use super::failure::Failure;
use super::find::{absent, unknown};
use super::simulate::Simulate;

/// The accuracy of runs for which no method, order, step or tolerance is given.
const ACCURACY: f64 = 1e-6;

/// The range of times, s, which is that of steps in the library.
const TIMES: RangeInclusive<f64> = 1e-100..=1e100;
/// The most steps of a run: with more of them each is below the round-off of the time.
const MOST_STEPS: f64 = 1e15;

/// A run whose arguments were checked.
pub struct Request {
    /// Up to this time, s.
    pub duration: f64,
    /// Method and step.
    pub settings: Settings,
    parameters: Vec<(String, f64)>,
    inputs: Vec<(String, f64)>,
}

impl Request {
    /// Checks the arguments against the scene and fills in its defaults.
    pub fn new(arguments: &Simulate, scene: &Scene) -> Result<Self, Failure> {
        let tolerance = arguments.tolerance.as_deref().map(tolerance).transpose()?;
        let accuracy = arguments.accuracy.as_deref().map(accuracy).transpose()?;
        let chooses = [&arguments.step, &arguments.method, &arguments.order];
        let chooses = chooses.into_iter().any(Option::is_some);
        let mut settings = match (tolerance, accuracy) {
            (Some(tolerance), _) => Settings::for_tolerance(tolerance),
            (None, Some(accuracy)) => Settings::accuracy(accuracy),
            (None, None) if chooses => Settings::default(),
            (None, None) => Settings::accuracy(ACCURACY),
        };
        if let Some(text) = &arguments.order {
            settings.order = order(text)?;
        }
        let duration = positive("--time", arguments.time.as_deref(), scene.duration)?;
        let step = positive("--step", arguments.step.as_deref(), scene.step)?;
        if duration / step > MOST_STEPS {
            let is_constant = settings.tolerance.is_none() && settings.accuracy.is_none();
            return Err(Failure(match arguments.step {
                Some(_) if is_constant => format!(
                    "--step {step:e} is too small for --time {duration:e}: time would not advance; take a longer step"
                ),
                _ => format!(
                    "--time {duration:e} is too long for steps of about {step:e} s: time would not advance; take a shorter time"
                ),
            }));
        }
        if let Some(name) = &arguments.method {
            settings.method = method(name)?;
            // The order that fits a tolerance is for methods of several orders.
            if settings.method == Method::Radau && arguments.order.is_none() {
                settings.order = Settings::default().order;
            }
        }
        settings.step = step;
        let mut request = Request {
            duration,
            settings,
            parameters: Vec::new(),
            inputs: Vec::new(),
        };
        for text in &arguments.set {
            request.set(text, scene)?;
        }
        Ok(request)
    }

    /// Whether the run has the declared values of the scene, so that its reference applies.
    pub fn is_unchanged(&self) -> bool {
        self.parameters.is_empty() && self.inputs.is_empty()
    }

    /// The simulation at its start.
    pub fn build(&self, scene: &Scene) -> Result<Box<dyn AnySimulation>, Failure> {
        let mut simulation = (scene.build)(&self.parameters, self.settings)?;
        for (name, value) in &self.inputs {
            simulation.set_input(name, *value)?;
        }
        Ok(simulation)
    }

    /// Takes one `name=value`, of a parameter or an input.
    fn set(&mut self, text: &str, scene: &Scene) -> Result<(), Failure> {
        let Some((name, value)) = text.split_once('=') else {
            return Err(Failure(format!("--set {text}: write --set name=value")));
        };
        let value = finite(&format!("--set {name}"), value)?;
        let parameters = scene.model.parameters.iter().map(|q| q.name);
        let inputs = scene.model.inputs.iter().map(|q| q.name);
        if parameters.clone().any(|known| known == name) {
            self.parameters.push((name.to_owned(), value));
        } else if inputs.clone().any(|known| known == name) {
            self.inputs.push((name.to_owned(), value));
        } else {
            let known = parameters.chain(inputs);
            return Err(Failure(unknown("parameter or input", name, known)));
        }
        Ok(())
    }
}

fn order(text: &str) -> Result<u8, Failure> {
    match text.trim() {
        "2" => Ok(2),
        "4" => Ok(4),
        "6" => Ok(6),
        "8" => Ok(8),
        _ => Err(Failure(format!(
            "order {text} is not available; available: --order 2, 4, 6 and 8"
        ))),
    }
}

fn tolerance(text: &str) -> Result<f64, Failure> {
    match finite("--tolerance", text)? {
        value if (1e-12..=0.1).contains(&value) => Ok(value),
        _ => Err(Failure(format!(
            "--tolerance {text}: give a part of the motion from 1e-12 to 0.1, or a constant step with --step"
        ))),
    }
}

fn accuracy(text: &str) -> Result<f64, Failure> {
    match finite("--accuracy", text)? {
        value if (1e-11..=0.1).contains(&value) => Ok(value),
        _ => Err(Failure(format!(
            "--accuracy {text}: give a part of the size of the mechanism from 1e-11 to 0.1"
        ))),
    }
}

fn method(name: &str) -> Result<Method, Failure> {
    let known = Method::NAMES.iter().copied();
    let method = Method::by_name(name).ok_or_else(|| Failure(unknown("method", name, known)))?;
    match method {
        Method::TwoLevel | Method::Projected => Ok(method),
        _ if cfg!(feature = "laboratory") => Ok(method),
        _ => Err(Failure(absent(&format!("the method `{name}`")))),
    }
}

fn positive(option: &str, text: Option<&str>, default: f64) -> Result<f64, Failure> {
    let Some(text) = text else { return Ok(default) };
    match finite(option, text)? {
        value if TIMES.contains(&value) => Ok(value),
        value if value > 0.0 => Err(Failure(format!(
            "{option} {text}: give a time from {:e} to {:e}, in seconds",
            TIMES.start(),
            TIMES.end()
        ))),
        _ => Err(Failure(format!(
            "{option} {text}: give a time above zero, in seconds"
        ))),
    }
}

fn finite(option: &str, text: &str) -> Result<f64, Failure> {
    match text.trim().parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(Failure(format!(
            "{option}: `{text}` is not a finite number; write for example 0.001"
        ))),
    }
}
