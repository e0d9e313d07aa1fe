//! Bars and bodies of the plane.

use super::part::{Guess, Part, Representation, StartPlace};
use crate::model::arguments::Arguments;
use crate::model::formulation::{self, Formulation};
use crate::model::geometry::{Frame, Tensor, Vector};
use crate::model::resolver::Resolver;
use crate::model::value::Value;
use crate::symbolic::{Expr, Symbol};
use crate::syntax::Entry;

impl Resolver<'_> {
    pub(in crate::model) fn planar_bar(&mut self, entry: &Entry) -> Option<Value> {
        let needs_angle = self.needs_angle.contains(&entry.name.to_string());
        let formulation = self.planar_bar_wish(entry, needs_angle);
        let mut arguments = Arguments::new(self, entry);
        let mass = arguments.mass("mass");
        let guess = Guess {
            origin: arguments.start_place("from"),
            end: arguments.start_place("to"),
            velocity: None,
            angle: arguments.scalar("angle"),
            rate: arguments.scalar("rate"),
            spin: None,
        };
        let free = arguments.flag("free");
        let length = match (arguments.has("length"), &guess.origin, &guess.end) {
            (true, ..) => arguments.scalar("length"),
            (false, Some(StartPlace::Known(from)), Some(StartPlace::Known(to))) => {
                let difference = arguments.graph().vector_sub(*to, *from);
                Some(arguments.graph().norm(difference))
            }
            _ if arguments.are_misplaced() => None,
            (false, Some(_), Some(_)) => arguments.fail(
                "length",
                format!(
                    "`{}` has no length; give `length =`: where a point of another part starts follows from the joints, and a length is known before",
                    entry.name
                ),
            ),
            _ => arguments.fail(
                "length",
                format!(
                    "`{}` has no length; give `length =`, or its home pose by `from =` and `to =`",
                    entry.name
                ),
            ),
        }?;
        arguments.refuse_not_positive(
            "length",
            length,
            "a bar has a positive length; for a point mass use `Particle`",
        )?;
        let prescribed = if arguments.has("frame") {
            arguments.refuse_start("frame")?;
            Some(arguments.prescribed_frame("frame")?)
        } else {
            None
        };
        let mass = mass?;
        let name = entry.name.to_string();
        let squared = self.graph.square(length);
        let twelfth = self.graph.scale(1.0 / 12.0, mass);
        let inertia = self.graph.mul(twelfth, squared);
        let half = self.graph.scale(0.5, length);
        let zero = self.graph.zero();
        let center = [half, zero, zero];
        let (representation, locals, frame) = match prescribed {
            Some((origin, angle)) => (
                Representation::Prescribed,
                Vec::new(),
                self.prescribed(&name, origin, angle),
            ),
            None if needs_angle
                || formulation.unwrap_or(self.formulation) != Formulation::Natural =>
            {
                let (locals, frame) = self.reference(&name, center);
                (Representation::Reference, locals, frame)
            }
            None => {
                let (locals, frame) = self.planar_natural(&name, length);
                (Representation::Natural, locals, frame)
            }
        };
        self.add_part(Part {
            name,
            kind: "Bar",
            span: entry.span(),
            representation,
            formulation,
            locals,
            mass,
            inertia: planar_inertia(inertia, zero),
            length: Some(length),
            center,
            frame,
            guess,
            home: None,
            shape: None,
            free,
        })
    }

    /// What a bar asks for. Its end points have no angle that counts full turns.
    fn planar_bar_wish(&mut self, entry: &Entry, needs_angle: bool) -> Option<Formulation> {
        let wish = self.wish(entry, &formulation::ALL)?;
        if wish == Formulation::Natural && needs_angle {
            let name = &entry.name;
            return self.fail(
                entry.span(),
                format!("the angle of `{name}` is used, which its end points do not have; ask for `Reference` or `Joint`, or leave `coordinates =` out"),
            );
        }
        Some(wish)
    }

    pub(in crate::model) fn planar_body(&mut self, entry: &Entry) -> Option<Value> {
        let formulation = self.wish(entry, &formulation::OF_BODIES);
        let mut arguments = Arguments::new(self, entry);
        let (mass, inertia) = (arguments.mass("mass"), arguments.mass("inertia"));
        let center = arguments.vector("center_of_mass");
        let guess = Guess {
            origin: arguments.start_place("at"),
            end: None,
            velocity: arguments.vector("velocity"),
            angle: arguments.scalar("angle"),
            rate: arguments.scalar("rate"),
            spin: None,
        };
        let free = arguments.flag("free");
        let prescribed = if arguments.has("frame") {
            arguments.refuse_start("frame")?;
            Some(arguments.prescribed_frame("frame")?)
        } else {
            None
        };
        let (mass, inertia) = (mass?, inertia?);
        let name = entry.name.to_string();
        let zero = self.graph.zero();
        let center = center.unwrap_or([zero; 3]);
        let (representation, locals, frame) = match prescribed {
            Some((origin, angle)) => (
                Representation::Prescribed,
                Vec::new(),
                self.prescribed(&name, origin, angle),
            ),
            None => {
                let (locals, frame) = self.reference(&name, center);
                (Representation::Reference, locals, frame)
            }
        };
        self.add_part(Part {
            name,
            kind: "Body",
            span: entry.span(),
            representation,
            formulation,
            locals,
            mass,
            inertia: planar_inertia(inertia, zero),
            length: None,
            center,
            frame,
            guess,
            home: None,
            shape: None,
            free,
        })
    }

    /// Natural coordinates: the end points. The axis is (b − a)/L, and its rate (b − a) × (ḃ − ȧ)/L².
    fn planar_natural(&mut self, name: &str, length: Expr) -> (Vec<u32>, Frame) {
        let (locals, difference) = self.end_points(name);
        let one = self.graph.one();
        let inverse = self.graph.div(one, length);
        let axis = self.graph.vector_scale(inverse, difference);
        let spread = self.graph.vector_rate(difference);
        let cross = self.graph.planar_cross(difference, spread);
        let rate = self.graph.product(&[(cross, 1), (length, -2)]);
        let origin = self.free_position(locals[0]);
        let frame = self.planar_frame(origin, axis, None, rate);
        (locals, frame)
    }

    /// Reference coordinates: centre of mass and angle.
    fn reference(&mut self, name: &str, center: Vector) -> (Vec<u32>, Frame) {
        let locals = [("x", "m"), ("y", "m"), ("angle", "rad")]
            .map(|(axis, unit)| self.local(format!("{name}.{axis}"), unit));
        let [x, y, angle] = locals.map(|local| self.graph.symbol(Symbol::LocalPosition(local)));
        let axis = self.named_direction(name, angle);
        let axes = self.graph.planar_axes(axis);
        let offset = self.graph.turn(&axes, center);
        let zero = self.graph.zero();
        let origin = self.graph.vector_sub([x, y, zero], offset);
        let rate = self.graph.symbol(Symbol::LocalVelocity(locals[2]));
        let frame = self.planar_frame(origin, axis, Some(angle), rate);
        (locals.to_vec(), frame)
    }

    fn prescribed(&mut self, name: &str, origin: Vector, angle: Expr) -> Frame {
        let axis = self.named_direction(name, angle);
        let rate = self.graph.rate(angle);
        self.planar_frame(origin, axis, Some(angle), rate)
    }

    fn planar_frame(
        &mut self,
        origin: Vector,
        axis: Vector,
        angle: Option<Expr>,
        rate: Expr,
    ) -> Frame {
        let zero = self.graph.zero();
        Frame {
            origin,
            axes: self.graph.planar_axes(axis),
            angle,
            spin: [zero, zero, rate],
        }
    }

    fn named_direction(&mut self, name: &str, angle: Expr) -> Vector {
        let axis = self.graph.direction(angle);
        self.graph.suggest_name(axis[0], format!("cos_{name}"));
        self.graph.suggest_name(axis[1], format!("sin_{name}"));
        axis
    }
}

/// The tensor of a planar part: about z.
fn planar_inertia(inertia: Expr, zero: Expr) -> Tensor {
    let mut tensor = [[zero; 3]; 3];
    tensor[2][2] = inertia;
    tensor
}
