//! States: values with a rate of their own.
//!
//! A state x is the velocity of a coordinate ∫x dt with a 1 on the diagonal of M, and its rate is the force on this
//! coordinate, so that every method integrates it as it integrates velocities. Nothing depends on the coordinate, no
//! row has a coefficient of the velocity, and neither T nor the power of the forces contains them.

use super::part::{Guess, Part, Representation};
use crate::dimension::Dimension;
use crate::model::ScalarState;
use crate::model::arguments::Arguments;
use crate::model::geometry::Frame;
use crate::model::quantities::quantity;
use crate::model::requirements::Wanted;
use crate::model::resolver::Resolver;
use crate::model::value::Value;
use crate::symbolic::{Expr, Symbol};
use crate::syntax::Entry;

const POSITIVE_SCALE: &str = "a scale has to be positive: give a usual size of the state";

impl Resolver<'_> {
    pub(in crate::model) fn state(&mut self, entry: &Entry) -> Option<Value> {
        let mut arguments = Arguments::new(self, entry);
        let (initial, dimension) = match arguments.has("initial") {
            true => arguments.quantity("initial")?,
            false => (arguments.graph().zero(), None),
        };
        let stated = arguments.unit()?;
        if let Some(stated) = stated {
            arguments.check_unit(dimension, stated)?;
        }
        let dimension = stated.or(dimension).unwrap_or(Dimension::NONE);
        let default = arguments.by_default(initial);
        let scaled_by = match arguments.has("scale") {
            true => scale(&mut arguments, dimension)?,
            false => initial,
        };
        // As the runtime does with other parameters (`mbs-runtime/src/scalar_state.rs`).
        let scale = match arguments.by_default(scaled_by) {
            size if size.is_finite() && size != 0.0 => size.abs(),
            _ => 1.0,
        };
        let own = quantity(entry, default, Some(dimension));
        let (graph, name) = (&mut self.graph, own.name.clone());
        let zero = graph.zero();
        let integral = dimension.times(Dimension::TIME).unit();
        let local = self.local(format!("{name}.integral"), &integral);
        let velocity = Symbol::LocalVelocity(local);
        self.graph.set_name(velocity, name.clone());
        let value = self.graph.symbol(velocity);
        self.parts.push(Part {
            name,
            kind: "State",
            span: entry.span(),
            representation: Representation::State,
            formulation: None,
            locals: vec![local],
            mass: zero,
            inertia: [[zero; 3]; 3],
            length: None,
            center: [zero; 3],
            frame: Frame {
                origin: [zero; 3],
                axes: [[zero; 3]; 3],
                angle: None,
                spin: [zero; 3],
            },
            guess: Guess {
                rate: Some(initial),
                ..Guess::default()
            },
            home: None,
            shape: None,
            free: false,
        });
        self.scalar_states.push(ScalarState {
            quantity: own,
            local,
            scale,
            scaled_by,
            rate: zero,
        });
        Some(Value::Scalar(value, Some(dimension)))
    }

    /// Reads the rates of the states, which may depend on all that moves.
    pub(in crate::model) fn state_rates(&mut self) {
        for entry in &self.declaration.entries {
            if entry.kind != "State" {
                continue;
            }
            let before = self.errors.enter(entry.name.as_str());
            let rate = self.state_rate(entry);
            let name = entry.name.as_str();
            let mut states = self.scalar_states.iter_mut();
            let state = states.find(|state| state.quantity.name == name);
            if let (Some(rate), Some(state)) = (rate, state) {
                state.rate = rate;
            }
            self.errors.leave(before);
        }
    }

    fn state_rate(&mut self, entry: &Entry) -> Option<Expr> {
        let Some(Value::Scalar(_, Some(dimension))) = self.value_of(entry) else {
            return None;
        };
        let mut arguments = Arguments::new(self, entry);
        let (rate, found) = arguments.quantity("rate")?;
        let expected = dimension.over(Dimension::TIME);
        match found {
            Some(found) if found != expected => arguments.fail(
                "rate",
                format!(
                    "this state is {dimension}, and its rate {expected}, but this is {found}; the unit of `initial =`, or `unit =`, says what the state is"
                ),
            ),
            _ => Some(rate),
        }
    }

    /// The state that an expression depends on.
    pub(in crate::model) fn state_in(&self, value: &Value) -> Option<&ScalarState> {
        let mut states = self.scalar_states.iter();
        states.find(|state| {
            let own = Symbol::LocalVelocity(state.local);
            value.depends_on(&self.graph, |symbol| symbol == own)
        })
    }
}

/// The usual size of a state.
fn scale(arguments: &mut Arguments, dimension: Dimension) -> Option<Expr> {
    let (scale, found) = arguments.quantity("scale")?;
    let size = arguments.by_default(scale);
    if found.is_some_and(|found| found != dimension) {
        return arguments.fail("scale", format!("the scale of this state is {dimension}"));
    }
    if !(size > 0.0 && size.is_finite()) {
        return arguments.fail("scale", POSITIVE_SCALE);
    }
    arguments.require("scale", &[scale], Wanted::Positive(POSITIVE_SCALE));
    Some(scale)
}
