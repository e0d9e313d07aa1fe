//! `angle`, `rate`, `stroke` and `speed` of a joint: from the frames of its partners, or, where the tree has made the
//! joint a coordinate, that coordinate itself.

use super::geometry::Owner;
use super::joint_frames::JointFrames;
use super::joint_variables::{AskedVariable, JointVariable};
use super::resolver::{Resolver, State};
use super::tree::Tree;
use super::value::Value;
use crate::dimension::Dimension;
use crate::schema::World;
use crate::symbolic::{Expr, Function, Node, Substitution, Symbol};
use proc_macro2::Span;
use std::collections::BTreeMap;

impl Resolver<'_> {
    /// A variable of the child against the parent: the angle about the axis, counted over full turns, rad; its rate; how far
    /// the child has slid along the axis, m; its rate.
    pub(super) fn joint_variable(&mut self, joint: &JointFrames, variable: JointVariable) -> Expr {
        let mut asked = self.joint_variables.iter();
        if let Some(known) =
            asked.find(|known| known.joint == joint.name && known.variable == variable)
        {
            return known.expr;
        }
        let expr = match variable {
            JointVariable::Angle => match self.world {
                World::Planar => self.relative_angle(joint),
                World::Spatial => self.spatial_angle(joint),
            },
            JointVariable::Rate => self.turning_rate(joint),
            JointVariable::Stroke => self.slide(joint),
            JointVariable::Speed => {
                let stroke = self.slide(joint);
                self.graph.rate(stroke)
            }
        };
        let expr = self.graph.function(Function::Same, expr);
        self.joint_variables.push(AskedVariable {
            joint: joint.name.clone(),
            variable,
            expr,
        });
        expr
    }

    /// The rate of an expression of positions; that of a joint's angle or stroke by its name.
    pub(super) fn rate_of(&mut self, expr: Expr) -> Expr {
        self.rate_with(expr, &mut BTreeMap::new())
    }

    /// The same, with the rates of sums that were found: sums may be in several others.
    fn rate_with(&mut self, expr: Expr, found: &mut BTreeMap<Expr, Expr>) -> Expr {
        if let Some(&rate) = found.get(&expr) {
            return rate;
        }
        if let Node::Sum { terms, .. } = self.graph.node(expr).clone() {
            let rates = terms.iter();
            let rates = rates.map(|&(x, c)| (self.rate_with(x, found), c.value()));
            let rates: Vec<_> = rates.collect();
            let rate = self.graph.linear(0.0, &rates);
            found.insert(expr, rate);
            return rate;
        }
        let mut asked = self.joint_variables.iter();
        let known = asked.find(|known| known.expr == expr);
        let known = known.and_then(|known| {
            let rate = known.variable.rate()?;
            let index = *self.names.get(&known.joint)?;
            match &self.states[index] {
                State::Done(Some(Value::Joint(joint))) => Some((joint.clone(), rate)),
                _ => None,
            }
        });
        match known {
            Some((joint, rate)) => self.joint_variable(&joint, rate),
            None => self.graph.rate(expr),
        }
    }

    fn slide(&mut self, joint: &JointFrames) -> Expr {
        let gap = self
            .graph
            .vector_sub(joint.child.point.position, joint.parent.point.position);
        self.graph.dot(joint.along, gap)
    }

    fn spatial_angle(&mut self, joint: &JointFrames) -> Expr {
        let [x, y, _] = joint.parent.axes;
        let turned = joint.child.axes[0];
        let (sin, cos) = (self.graph.dot(y, turned), self.graph.dot(x, turned));
        let angle = self.graph.atan2(sin, cos);
        self.counted(&joint.name, None, angle)
    }

    fn turning_rate(&mut self, joint: &JointFrames) -> Expr {
        let spins =
            [joint.child.point.owner, joint.parent.point.owner].map(|owner| self.frame(owner).spin);
        let relative = self.graph.vector_sub(spins[0], spins[1]);
        self.graph.dot(joint.parent.axes[2], relative)
    }

    /// Replaces the variables of joints that are coordinates by these.
    pub(super) fn name_variables(&mut self, tree: &Tree, substitution: &mut Substitution) {
        for known in &self.joint_variables {
            let mut joints = tree.joints.iter();
            let Some(joint) = joints.find(|joint| joint.joint == known.joint) else {
                continue;
            };
            // A helix slides by its lead for each radian.
            let local = match known.variable {
                JointVariable::Angle | JointVariable::Rate => {
                    joint.angles().first().map(|&local| (local, None))
                }
                JointVariable::Stroke | JointVariable::Speed => joint.stroke(),
            };
            let Some((local, lead)) = local else { continue };
            let symbol = match known.variable {
                JointVariable::Angle | JointVariable::Stroke => Symbol::LocalPosition(local),
                JointVariable::Rate | JointVariable::Speed => Symbol::LocalVelocity(local),
            };
            let coordinate = match substitution.get(symbol) {
                Some(coordinate) => coordinate,
                None => self.graph.symbol(symbol),
            };
            let value = match lead {
                Some(lead) => self.graph.mul(lead, coordinate),
                None => coordinate,
            };
            substitution.equate(known.expr, value);
        }
    }

    /// `angle`, `rate`, `stroke`, `speed` of a joint.
    pub(super) fn joint_member(
        &mut self,
        joint: &JointFrames,
        member: &str,
        span: Span,
    ) -> Option<Value> {
        let mut known = Vec::new();
        if joint.turns {
            known.extend(["angle", "rate"]);
        }
        if joint.slides {
            known.extend(["stroke", "speed"]);
        }
        if matches!(member, "angle" | "rate")
            && joint.turns
            && let Some(particle) = self.particle_of(joint)
        {
            let name = &joint.name;
            return self.fail(
                span,
                format!("`{name}` has no `{member}`: `{particle}` is a particle and has no orientation; use a `Body` or a `Bar`"),
            );
        }
        if !known.contains(&member) {
            let advice = match (member, known.is_empty()) {
                (_, true) => format!("a `{}` leaves no single motion to name", joint.kind),
                ("angle" | "rate", _) if !joint.turns => {
                    format!("a `{}` does not turn", joint.kind)
                }
                ("stroke" | "speed", _) if !joint.slides => {
                    format!("a `{}` does not slide", joint.kind)
                }
                _ => String::new(),
            };
            return self.no_such_member(
                &Value::Joint(Box::new(joint.clone())),
                member,
                &known,
                &advice,
                span,
            );
        }
        let (variable, dimension) = match member {
            "angle" => (JointVariable::Angle, Dimension::NONE),
            "rate" => (JointVariable::Rate, Dimension::RATE),
            "stroke" => (JointVariable::Stroke, Dimension::LENGTH),
            _ => (JointVariable::Speed, Dimension::VELOCITY),
        };
        Some(Value::Scalar(
            self.joint_variable(joint, variable),
            Some(dimension),
        ))
    }

    /// The name of a partner that is a particle.
    pub(super) fn particle_of(&self, joint: &JointFrames) -> Option<String> {
        let mut parts = joint.owners().into_iter().filter_map(Owner::part);
        let found = parts.find(|&part| self.parts[part].kind == "Particle")?;
        Some(self.parts[found].name.clone())
    }
}
