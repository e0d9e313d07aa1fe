//! The frames of a spatial joint on its partners, as declared.

use super::Arguments;
use crate::diagnostics::Place;
use crate::model::defaults::OF_ANGLES;
use crate::model::geometry::{Attachment, Axes, Owner, Point, Vector};
use crate::model::joint_frames::JointFrames;
use crate::model::joint_variables::JointVariable;
use crate::model::resolver::Resolver;
use crate::model::value::Value;
use crate::schema::JointTraits;
use crate::symbolic::Expr;
use crate::syntax::Entry;

impl Resolver<'_> {
    pub(in crate::model) fn joint_frames(&mut self, entry: &Entry) -> Option<Value> {
        let (parent, child) = Arguments::new(self, entry).attachments()?;
        let home = self.home(parent.point.owner);
        let axes = self.graph.compose(&home.axes, &parent.local);
        let letters = std::array::from_fn(|k| {
            let along = axes[k].map(|x| self.by_default(x).abs());
            let ground = along.iter().position(|x| (x - 1.0).abs() < 1e-9);
            ground.map_or(["u", "v", "w"][k], |axis| ["x", "y", "z"][axis])
        });
        let traits = self.kind_of(entry)?.traits();
        Some(Value::Joint(Box::new(JointFrames {
            name: entry.name.to_string(),
            kind: entry.kind.to_string(),
            turns: traits.turns,
            slides: traits.slides,
            along: parent.axes[2],
            parent,
            child,
            letters,
        })))
    }

    /// A frame turned about its axis, so that the joint has the angle zero in the home pose: a frame is declared by its
    /// place and its axis, and nothing says where its other axes point.
    fn without_twist(&mut self, frame: Attachment, home: &Axes, triad: &Axes) -> Attachment {
        let axis = self.graph.turn(home, frame.local[2]);
        let [along, across] =
            [frame.local[0], frame.local[1]].map(|axis| self.graph.turn(home, axis));
        let twist = self.graph.dot(across, triad[0]);
        let same = self.graph.dot(along, triad[0]);
        let twist = self.settled(twist, OF_ANGLES);
        let upright = self.graph.is_zero(twist) && self.by_default(same) > 0.0;
        let cosine = self.graph.dot(axis, triad[2]);
        // Axes that are far apart are an error of the home pose, which is found later.
        if upright || !(self.by_default(cosine) > 0.5) {
            return frame;
        }
        let part = self.graph.dot(triad[0], axis);
        let part = self.graph.vector_scale(part, axis);
        let first = self.graph.vector_sub(triad[0], part);
        let first = self.graph.unit(first);
        let second = self.graph.cross(axis, first);
        let [first, second] = [first, second].map(|axis| self.graph.components(home, axis));
        let Point {
            owner,
            local,
            label,
            ..
        } = frame.point;
        self.attach(owner, local, [first, second, frame.local[2]], label)
    }

    /// The frame of a part at a place of its own, with axes of its own.
    pub(in crate::model) fn attach(
        &mut self,
        owner: Owner,
        local: Vector,
        axes: Axes,
        label: String,
    ) -> Attachment {
        let frame = self.frame(owner);
        Attachment {
            point: self.point_of(owner, local, label),
            local: axes,
            axes: self.graph.compose(&frame.axes, &axes),
        }
    }
}

/// A partner of a joint, as far as it was given.
enum Hold {
    Part(Owner),
    Point(Owner, Vector, String),
    Frame(Attachment),
}

impl Hold {
    fn owner(&self) -> Owner {
        match self {
            Hold::Part(owner) | Hold::Point(owner, ..) => *owner,
            Hold::Frame(frame) => frame.point.owner,
        }
    }
}

impl Arguments<'_, '_> {
    /// The frames of `parent` and `child`: given as such, or as parts or points with `at =` and `axis =`.
    fn attachments(&mut self) -> Option<(Attachment, Attachment)> {
        let (parent, child) = (self.hold("parent"), self.hold("child"));
        let (parent, child) = (parent?, child?);
        if parent.owner() == child.owner() {
            let owner = self.owner_name(parent.owner());
            return self.fail(
                "child",
                format!("both sides belong to `{owner}`: a joint holds two different parts"),
            );
        }
        let at = self.home_place("at");
        if at.is_none() && self.has("at") {
            return None;
        }
        for (field, hold) in [("parent", &parent), ("child", &child)] {
            let name = self.owner_name(hold.owner());
            match (hold, at) {
                (Hold::Part(_), None) => return self.fail(field, format!("where on `{name}` is this joint? Give its place in the home pose by `at =`, or name a point, such as `{name}.point(x, y, z)`")),
                (Hold::Point(..) | Hold::Frame(_), Some(_)) => return self.fail("at", format!("`{field}` says already where the joint takes hold of `{name}`; keep one of them")),
                _ => {}
            }
        }
        let triad = self.triad(&[&parent, &child])?;
        let name = self.entry_name();
        let mut attach = |field: &str, hold: Hold| -> Option<Attachment> {
            self.held_axes(field, hold.owner())?;
            let resolver = self.resolver();
            let home = resolver.home(hold.owner());
            let axes = triad.map(|axis| resolver.graph.components(&home.axes, axis));
            Some(match hold {
                Hold::Frame(frame) => resolver.without_twist(frame, &home.axes, &triad),
                Hold::Point(owner, local, label) => resolver.attach(owner, local, axes, label),
                Hold::Part(owner) => {
                    let at = at?;
                    let arm = resolver.graph.vector_sub(at, home.origin);
                    // A particle has no point but itself; where it is not at this place, the check of the home pose tells.
                    let local = match resolver.is_particle(owner) {
                        true => resolver.graph.zero_vector(),
                        false => resolver.graph.components(&home.axes, arm),
                    };
                    let label = format!("{} at {name}", resolver.owner_name(owner));
                    resolver.attach(owner, local, axes, label)
                }
            })
        };
        let parent = attach("parent", parent);
        let child = attach("child", child);
        Some((parent?, child?))
    }

    /// The axes of the joint in the home pose, in the ground's axes: z along `axis =`, or those of the first frame.
    fn triad(&mut self, holds: &[&Hold]) -> Option<Axes> {
        let frame = holds.iter().find_map(|hold| match hold {
            Hold::Frame(frame) => Some(frame.clone()),
            _ => None,
        });
        match (frame, self.has("axis")) {
            (Some(_), true) => self.fail(
                "axis",
                "the frame of a partner gives the axis already; keep one of them",
            ),
            (Some(frame), false) => {
                let resolver = self.resolver();
                let home = resolver.home(frame.point.owner);
                Some(resolver.graph.compose(&home.axes, &frame.local))
            }
            // The gains of a bushing are in its parent's axes.
            (None, false) if self.kind_name() == "Bushing" => {
                let parent = holds.first()?.owner();
                Some(self.resolver().home(parent).axes)
            }
            (None, false) => Some(self.graph().ground_axes()),
            (None, true) => {
                let axis = self.direction("axis")?;
                Some(self.resolver().axes_along(axis))
            }
        }
    }

    fn hold(&mut self, field: &str) -> Option<Hold> {
        let syntax = self.syntax(field)?;
        match self.evaluate(syntax)? {
            Value::Frame(owner) => {
                let names = self.resolver().point_names(owner);
                if self.is_particle(owner) && names == ["origin"] && !self.has("at") {
                    let point = self.resolver().named_point(owner, "origin")?;
                    return Some(Hold::Point(owner, point.local, point.label));
                }
                Some(Hold::Part(owner))
            }
            Value::Point(point) => Some(Hold::Point(point.owner, point.local, point.label)),
            Value::Attachment(frame) => Some(Hold::Frame(*frame)),
            other => {
                let what = other.describe();
                self.fail_at(
                    Place::of(syntax),
                    format!("`{field}` is a part, a point or a frame, but this is {what}"),
                )
            }
        }
    }

    /// Refuses a partner without the orientation that the joint holds.
    fn held_axes(&mut self, field: &str, owner: Owner) -> Option<()> {
        if !self.holds_orientation() {
            return Some(());
        }
        let name = self.owner_name(owner);
        if self.is_particle(owner) {
            return self.fail(field, format!("`{name}` is a particle and has no orientation to hold; use `Spherical`, or a `Body`"));
        }
        if self.is_slender(owner) {
            return self.fail(field, format!("`{name}` is a slender bar: it has no inertia about itself, so that its turning about itself would be undetermined; give it `radius =` or `inertia =`, or join it by `Spherical`"));
        }
        Some(())
    }

    /// The z axis of a frame in the home pose.
    pub fn home_direction(&mut self, frame: &Attachment) -> Vector {
        let resolver = self.resolver();
        let home = resolver.home(frame.point.owner);
        resolver.graph.turn(&home.axes, frame.local[2])
    }

    /// A frame at the same point, with other axes of the home pose.
    pub fn reattached(&mut self, frame: &Attachment, axes: Axes) -> Attachment {
        let owner = frame.point.owner;
        let resolver = self.resolver();
        let home = resolver.home(owner);
        let local = axes.map(|axis| resolver.graph.components(&home.axes, axis));
        let outside = resolver.frame(owner);
        Attachment {
            point: frame.point.clone(),
            local,
            axes: resolver.graph.compose(&outside.axes, &local),
        }
    }

    /// A joint named by another entry.
    pub fn joint(&mut self, field: &str) -> Option<JointFrames> {
        let syntax = self.syntax(field)?;
        match self.evaluate(syntax)? {
            Value::Joint(joint) => Some(*joint),
            other => {
                let what = other.describe();
                self.fail_at(
                    Place::of(syntax),
                    format!("`{field}` is a joint, but this is {what}"),
                )
            }
        }
    }

    /// The joints of this world that have such traits, for messages: "`Revolute`, `Cylindrical` or `Screw`".
    pub fn joints_that(&self, are_so: impl Fn(JointTraits) -> bool) -> String {
        let Resolver { kinds, world, .. } = &*self.resolver;
        let joints = kinds.own(*world).iter().filter_map(|kind| {
            let traits = kind.joint?;
            are_so(traits).then(|| format!("`{}`", kind.name))
        });
        let names: Vec<String> = joints.collect();
        match names.as_slice() {
            [first @ .., last] if !first.is_empty() => format!("{} or {last}", first.join(", ")),
            names => names.concat(),
        }
    }

    /// The frames of this entry itself; `None` where they were wrong, which is recorded already.
    pub fn own_frames(&mut self) -> Option<JointFrames> {
        match self.own_value()? {
            Value::Joint(joint) => Some(*joint),
            _ => None,
        }
    }

    /// The points of this entry's partners, if both were given as such.
    pub fn given_points(&mut self) -> Option<[Point; 2]> {
        let mut points = ["parent", "child"].into_iter().map(|field| {
            let syntax = self.syntax(field)?;
            match self
                .resolver()
                .silently(|resolver| resolver.evaluate(syntax))?
            {
                Value::Point(point) => Some(point),
                Value::Frame(owner) => self.resolver().named_point(owner, "origin"),
                _ => None,
            }
        });
        Some([points.next()??, points.next()??])
    }

    /// The angle of the child against the parent about the axis, counted over full turns, rad.
    pub fn joint_angle(&mut self, joint: &JointFrames) -> Expr {
        self.resolver().joint_variable(joint, JointVariable::Angle)
    }

    /// The angular velocity of the child against the parent about the axis, rad/s.
    pub fn joint_rate(&mut self, joint: &JointFrames) -> Expr {
        self.resolver().joint_variable(joint, JointVariable::Rate)
    }

    /// How fast the child slides along the axis against the parent, m/s.
    pub fn joint_speed(&mut self, joint: &JointFrames) -> Expr {
        self.resolver().joint_variable(joint, JointVariable::Speed)
    }

    /// How far the child has slid along the axis, m.
    pub fn stroke(&mut self, joint: &JointFrames) -> Expr {
        self.resolver().joint_variable(joint, JointVariable::Stroke)
    }

    /// Right-handed axes whose third is a direction in parameters.
    pub fn axes_along(&mut self, direction: Vector) -> Axes {
        self.resolver().axes_along(direction)
    }

    /// A direction of unit length in the ground's axes in the home pose, in parameters.
    pub fn direction(&mut self, field: &str) -> Option<Vector> {
        let syntax = self.syntax(field)?;
        self.at_home(|arguments| arguments.direction_of(field, syntax))
    }
}
