//! What expressions read of force elements: `spring.force`, `spring.torque`.

use super::arguments::Arguments;
use super::elements::bushing::{Displaced, relative_rotation};
use super::elements::force::{Bushing, Force, ForceElement};
use super::elements::laws::distance;
use super::elements::{ReadForce, read_force};
use super::geometry::{Attachment, Vector};
use super::resolver::Resolver;
use super::value::Value;
use crate::diagnostics::Place;
use crate::dimension::Dimension;
use crate::schema::Group;
use crate::syntax::reference;
use proc_macro2::Ident;
use syn::Expr as Syntax;

impl Resolver<'_> {
    /// A force element; `None` if it has an error, which is recorded, or reads itself.
    pub(super) fn force_element(&mut self, index: usize) -> Option<Force> {
        match self.force_elements.get(&index) {
            Some(ReadForce::Read(force)) => return force.clone(),
            Some(ReadForce::Working) => return None,
            None => {}
        }
        let entry = self.entry(index);
        let kind = self.kind_of(entry)?;
        if self.misplaced.contains(&entry.name.to_string()) {
            return None;
        }
        self.force_elements.insert(index, ReadForce::Working);
        let silent = std::mem::replace(&mut self.silent, false);
        let in_home_pose = std::mem::replace(&mut self.in_home_pose, false);
        let in_output = std::mem::replace(&mut self.at_acceleration_level, false);
        let before = self.errors.enter(entry.name.as_str());
        let force = match kind.name == "Friction" && self.has_state_in_speed(entry) {
            true => None,
            false => read_force(kind.name, &mut Arguments::new(self, entry)),
        };
        self.errors.leave(before);
        (self.silent, self.in_home_pose) = (silent, in_home_pose);
        self.at_acceleration_level = in_output;
        let read = ReadForce::Read(force.clone());
        self.force_elements.insert(index, read);
        force
    }

    /// `spring.force` or `spring.torque`, of an entry that is a force; `None` for other expressions.
    pub(super) fn load_of(&mut self, element: &Syntax, member: &Ident) -> Option<Option<Value>> {
        let name = reference(element)?.ok()?.text();
        let index = *self.names.get(&name)?;
        let entry = self.entry(index);
        if self.kind_of(entry)?.group != Group::Force {
            return None;
        }
        let is_load = member == "force" || member == "torque";
        if !is_load && self.has_frames(entry) {
            return None;
        }
        self.note_use(&name);
        Some(self.load(index, &name, member, Place::of(element)))
    }

    fn load(&mut self, index: usize, name: &str, member: &Ident, place: Place) -> Option<Value> {
        if matches!(self.force_elements.get(&index), Some(ReadForce::Working)) {
            return self.fail(place, format!("`{name}` depends on itself; let it name only entries that do not lead back to it"));
        }
        let force = self.force_element(index)?;
        let known = self.loads(&force.element);
        let found = known.iter().find(|(own, _)| member == own);
        if let Some((_, value)) = found {
            return Some(value.clone());
        }
        let own: Vec<&str> = known.iter().map(|(own, _)| *own).collect();
        let own = own.join(", ");
        self.fail(
            member.span(),
            format!("`{name}` has no `{member}` (it has: {own})"),
        )
    }

    /// What an expression can read of this entry, if it is a force.
    pub(super) fn load_names(&mut self, index: usize) -> Vec<&'static str> {
        let kind = self.kind_of(self.entry(index));
        if kind.is_none_or(|kind| kind.group != Group::Force) {
            return Vec::new();
        }
        let Some(force) = self.force_element(index) else {
            return Vec::new();
        };
        let known = self.loads(&force.element);
        known.into_iter().map(|(name, _)| name).collect()
    }

    /// Forces and torques of an element, by name.
    fn loads(&mut self, element: &ForceElement) -> Vec<(&'static str, Value)> {
        let along = |value, dimension| (name_of(dimension), Value::Scalar(value, dimension));
        let force = |value| ("force", Value::Vector(value, Some(Dimension::FORCE)));
        let torque = |value| ("torque", Value::Vector(value, Some(Dimension::TORQUE)));
        let graph = &mut self.graph;
        match element {
            ForceElement::Spring {
                from,
                to,
                characteristic,
            } => {
                let [length, rate] = distance(graph, *from, *to);
                let tension = characteristic.tension(graph, length, rate);
                vec![along(tension, Some(Dimension::FORCE))]
            }
            ForceElement::TorsionSpring {
                angles: [child, parent],
                rates: [spin, back],
                characteristic,
            } => {
                let (angle, rate) = (graph.sub(*child, *parent), graph.sub(*spin, *back));
                let tension = characteristic.tension(graph, angle, rate);
                vec![along(tension, Some(Dimension::TORQUE))]
            }
            ForceElement::Wrench {
                force: own,
                torque: None,
                ..
            } => vec![force(*own)],
            ForceElement::Wrench {
                force: own,
                torque: Some(turning),
                ..
            } => vec![force(*own), torque(*turning)],
            ForceElement::Torque { torque: own, .. } => vec![torque(*own)],
            ForceElement::Stop(stop) => vec![along(stop.force(graph), stop.dimension)],
            ForceElement::Load { load, dimension } => vec![along(load.force, *dimension)],
            ForceElement::Bushing(bushing) => {
                let now = self.displaced(bushing);
                let own = bushing.force(&mut self.graph, &now);
                let turning = bushing.torque(&mut self.graph, &now);
                vec![force(own), torque(turning)]
            }
        }
    }

    fn displaced(&mut self, bushing: &Bushing) -> Displaced {
        let Bushing { parent, child, .. } = bushing;
        let velocity = |resolver: &mut Self, frame: &Attachment| -> Vector {
            resolver.graph.vector_rate(frame.point.position)
        };
        let [moving, back] = [child, parent].map(|frame| velocity(self, frame));
        let [spin, turning] = [child, parent].map(|frame| self.frame(frame.point.owner).spin);
        let graph = &mut self.graph;
        let gap = graph.vector_sub(child.point.position, parent.point.position);
        let velocity = graph.vector_sub(moving, back);
        let swing = graph.cross(turning, gap);
        let rate = graph.vector_sub(velocity, swing);
        let relative = graph.vector_sub(spin, turning);
        let mut components = |vector| graph.components(&parent.axes, vector);
        Displaced {
            displacement: components(gap),
            rate: components(rate),
            spin: components(relative),
            rotation: relative_rotation(&mut self.graph, &parent.axes, &child.axes),
        }
    }
}

fn name_of(dimension: Option<Dimension>) -> &'static str {
    match dimension {
        Some(Dimension::TORQUE) => "torque",
        _ => "force",
    }
}
