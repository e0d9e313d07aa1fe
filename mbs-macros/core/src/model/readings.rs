//! What only outputs can read: accelerations v̇, and the reactions of joints. Both follow from the equations of motion, which
//! the other entries make.

use super::geometry::Vector;
use super::resolver::Resolver;
use super::value::Value;
use crate::diagnostics::Place;
use crate::dimension::Dimension;
use crate::schema::Group;
use crate::symbolic::{Graph, Symbol};
use crate::syntax::reference;
use syn::Expr as Syntax;

/// A component of a reaction that an output reads: [`Symbol::Reaction`].
#[derive(Debug, Clone)]
pub struct Reading {
    /// The name of the joint or constraint.
    pub joint: String,
    /// The component, as [`Reaction`](crate::equations::Reaction) names it.
    pub component: String,
    /// Where it is read.
    pub place: Place,
}

impl Resolver<'_> {
    /// The rate of a velocity, in an output.
    pub(super) fn acceleration(
        &mut self,
        velocity: Vector,
        dimension: Option<Dimension>,
        place: impl Into<Place>,
    ) -> Option<Value> {
        self.check_acceleration_level(place, "this is an acceleration")?;
        Some(Value::Vector(
            self.graph.vector_rate(velocity),
            dimension.map(|d| d.over(Dimension::TIME)),
        ))
    }

    /// `joint.reaction`, of a joint or constraint with rows.
    pub(super) fn reaction_of(&mut self, joint: &Syntax, place: Place) -> Option<Option<Value>> {
        let name = reference(joint)?.ok()?.text();
        let kind = self.kind_of(self.entry(*self.names.get(&name)?))?;
        matches!(kind.group, Group::Joint | Group::Constraint).then(|| {
            self.check_acceleration_level(place, "this is a reaction")?;
            Some(Value::Reaction(name))
        })
    }

    /// `joint.reaction.fx`. Which components there are is known with the equations of motion.
    pub(super) fn reaction_component(
        &mut self,
        joint: &str,
        component: &str,
        place: impl Into<Place>,
    ) -> Value {
        let mut readings = self.readings.iter();
        let known = readings.position(|own| own.joint == joint && own.component == component);
        let index = known.unwrap_or_else(|| {
            self.readings.push(Reading {
                joint: joint.to_owned(),
                component: component.to_owned(),
                place: place.into(),
            });
            self.readings.len() - 1
        });
        let dimension = match component {
            "fx" | "fy" | "fz" | "force" => Some(Dimension::FORCE),
            "tx" | "ty" | "tz" | "torque" => Some(Dimension::TORQUE),
            _ => None,
        };
        let symbol = self.graph.symbol(Symbol::Reaction(index as u32));
        Value::Scalar(symbol, dimension)
    }

    /// Refuses what follows from the equations of motion where they would depend on it.
    pub(super) fn check_acceleration_level(
        &mut self,
        place: impl Into<Place>,
        what: &str,
    ) -> Option<()> {
        match self.at_acceleration_level {
            true => Some(()),
            false => self.fail(
                place,
                format!("{what}: it follows from the equations of motion, and only an `Output` can read it; a force can have an `Input` that the program sets from this output"),
            ),
        }
    }
}

/// Whether a value follows from the equations of motion.
pub(super) fn is_at_acceleration_level(value: &Value, graph: &Graph) -> bool {
    value.depends_on(graph, |symbol| {
        matches!(symbol, Symbol::LocalAcceleration(_) | Symbol::Reaction(_))
    })
}
