//! The language as Rust: kinds are structs whose fields are their arguments; what can follow a dot are fields and methods of
//! the type of a name.

use crate::schema::{Group, Kind, Kinds, World};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// All of it, for a world.
pub(super) fn emit(world: World, kinds: &'static Kinds) -> TokenStream {
    let worlds = World::ALL.into_iter().map(World::kind);
    let arguments = kinds.of(world).chain(worlds).map(arguments);
    let members = kinds.of(world).filter_map(|kind| members(world, kind));
    let (vector, ground) = match world {
        World::Planar => (PLANAR_VECTOR, PLANAR_GROUND),
        World::Spatial => (SPATIAL_VECTOR, SPATIAL_GROUND),
    };
    let [vector, ground, family, common] = [vector, ground, FAMILY, COMMON].map(parsed);
    quote! {
        #( #arguments )*
        mod members {
            #( #members )*
            #vector
            #ground
            #family
        }
        #common
    }
}

/// A kind with its arguments.
fn arguments(kind: &Kind) -> TokenStream {
    let (name, about) = (format_ident!("{}", kind.name), kind.doc);
    let fields = kind.fields.iter().map(|field| {
        let (name, doc) = (format_ident!("{}", field.name), field.doc);
        quote! { #[doc = #doc] pub #name: Value, }
    });
    quote! { #[doc = #about] pub struct #name { #( #fields )* } }
}

/// What can follow the name of an entry of this kind.
fn members(world: World, kind: &Kind) -> Option<TokenStream> {
    let name = format_ident!("{}", kind.name);
    let traits = kind.traits();
    let text = match (kind.group, kind.name, world) {
        (Group::Part, "Coordinate", _) => COORDINATE.to_owned(),
        (Group::Part, part, _) => {
            let points = match part {
                "Bar" => BAR,
                "Body" => BODY,
                _ => PARTICLE,
            };
            let own = match world {
                World::Planar => PLANAR_PART,
                World::Spatial => SPATIAL_PART,
            };
            format!("{points}{own}")
        }
        (Group::Joint | Group::Constraint, ..) => {
            let turns = if traits.turns { TURNS } else { "" };
            let slides = if traits.slides { SLIDES } else { "" };
            format!("{turns}{slides}{JOINT}")
        }
        (Group::Force, force, world) => match (force, world) {
            ("SpringDamper", _) => FORCE.to_owned(),
            ("TorsionSpring", _) | ("Torque", World::Planar) => TORQUE.to_owned(),
            ("Stop" | "Friction", _) => format!("{FORCE}{TORQUE}"),
            ("Force", _) => FORCE_VECTOR.to_owned(),
            ("Torque", World::Spatial) => TORQUE_VECTOR.to_owned(),
            _ => format!("{FORCE_VECTOR}{TORQUE_VECTOR}"),
        },
        (Group::Value, ..) => return None,
    };
    let (about, fields) = (kind.doc, parsed(&text));
    let methods = match (kind.group, world) {
        (Group::Part, World::Planar) => parsed(PLANAR_METHODS),
        (Group::Part, World::Spatial) => parsed(SPATIAL_METHODS),
        _ => TokenStream::new(),
    };
    Some(quote! {
        #[doc = #about]
        pub struct #name { #fields }
        impl #name { #methods }
    })
}

/// Text of this file as tokens.
fn parsed(text: &str) -> TokenStream {
    let lines = text
        .lines()
        .map(|line| match line.trim().strip_prefix("/// ") {
            // As an attribute, which an editor reads in the output of a macro.
            Some(doc) => format!("#[doc = {doc:?}]\n"),
            None => format!("{line}\n"),
        });
    lines.collect::<String>().parse().unwrap_or_default()
}

const COORDINATE: &str = "
/// Its rate.
pub rate: f64,
";
const BAR: &str = "
/// Its first end.
pub a: Place,
/// Its second end.
pub b: Place,
/// Its centre of mass.
pub center: Place,
/// Its length, m.
pub length: f64,
";
const BODY: &str = "
/// The origin of its axes.
pub origin: Place,
/// Its centre of mass.
pub center: Place,
";
const PARTICLE: &str = "
/// Its place.
pub origin: Place,
";
const PLANAR_PART: &str = "
/// Angle of its x axis against that of the ground, counted over full turns, rad.
pub angle: f64,
/// Angular velocity, rad/s.
pub rate: f64,
/// Velocity of its origin, or of end `a` of a bar, m/s.
pub velocity: Vector,
/// Acceleration of the same, m/s²: in an `Output`.
pub acceleration: Vector,
/// Its x axis.
pub x: Vector,
/// Its y axis.
pub y: Vector,
";
const SPATIAL_PART: &str = "
/// Angular velocity in the axes of the ground, rad/s.
pub angular_velocity: Vector,
/// Its rate, rad/s²: in an `Output`.
pub angular_acceleration: Vector,
/// Velocity of its origin, or of end `a` of a bar, m/s.
pub velocity: Vector,
/// Acceleration of the same, m/s²: in an `Output`.
pub acceleration: Vector,
/// Its x axis.
pub x: Vector,
/// Its y axis.
pub y: Vector,
/// Its z axis.
pub z: Vector,
";
const PLANAR_METHODS: &str = "
/// A point of it, by its coordinates in its own axes, m.
pub fn point(&self, x: f64, y: f64) -> Place { loop {} }
/// Velocity of the point of it that is at this place, m/s.
pub fn velocity_at(&self, place: Place) -> Vector { loop {} }
";
const SPATIAL_METHODS: &str = "
/// A point of it, by its coordinates in its own axes, m.
pub fn point(&self, x: f64, y: f64, z: f64) -> Place { loop {} }
/// A place in it and an axis, in its own axes, for a joint.
pub fn frame(&self, place: [f64; 3], axis: [f64; 3]) -> Place { loop {} }
/// Velocity of the point of it that is at this place, m/s.
pub fn velocity_at(&self, place: Place) -> Vector { loop {} }
";
const TURNS: &str = "
/// Angle of the second partner against the first, counted over full turns, rad.
pub angle: f64,
/// Its rate, rad/s.
pub rate: f64,
";
const SLIDES: &str = "
/// How far the second partner has slid along the axis, m.
pub stroke: f64,
/// Its rate, m/s.
pub speed: f64,
";
const JOINT: &str = "
/// Force and torque on the second partner: in an `Output`.
pub reaction: Reaction,
";
const FORCE: &str = "
/// Tension, or the force along what is stopped or braked, N.
pub force: f64,
";
const TORQUE: &str = "
/// The same of what turns, N m.
pub torque: f64,
";
const FORCE_VECTOR: &str = "
/// N.
pub force: Vector,
";
const TORQUE_VECTOR: &str = "
/// N m.
pub torque: Vector,
";
const PLANAR_VECTOR: &str = "
pub struct Vector { pub x: f64, pub y: f64 }
/// A point.
pub struct Place {
    /// m.
    pub x: f64,
    /// m.
    pub y: f64,
    /// m/s.
    pub velocity: Vector,
    /// m/s²: in an `Output`.
    pub acceleration: Vector,
}
/// Force and torque on the second partner of a joint.
pub struct Reaction {
    /// N.
    pub fx: f64,
    /// N.
    pub fy: f64,
    /// Of a joint that holds the angle, N m.
    pub torque: f64,
    /// Of a `Drive` of a length, N.
    pub force: f64,
    /// Of a condition of one's own: its multiplier.
    pub lambda: f64,
}
";
const SPATIAL_VECTOR: &str = "
pub struct Vector { pub x: f64, pub y: f64, pub z: f64 }
/// A point.
pub struct Place {
    /// m.
    pub x: f64,
    /// m.
    pub y: f64,
    /// m.
    pub z: f64,
    /// m/s.
    pub velocity: Vector,
    /// m/s²: in an `Output`.
    pub acceleration: Vector,
}
/// Force and torque on the second partner of a joint.
pub struct Reaction {
    /// N.
    pub fx: f64,
    /// N.
    pub fy: f64,
    /// N.
    pub fz: f64,
    /// N m.
    pub tx: f64,
    /// N m.
    pub ty: f64,
    /// N m.
    pub tz: f64,
    /// Of a `Drive` of an angle, N m.
    pub torque: f64,
    /// Of a `Drive` of a length, N.
    pub force: f64,
    /// Of a condition of one's own: its multiplier.
    pub lambda: f64,
}
";
const PLANAR_GROUND: &str = "
pub struct Ground {
    /// The origin of the world.
    pub origin: Place,
    /// The x axis of the world.
    pub x: Vector,
    /// The y axis of the world.
    pub y: Vector,
}
impl Ground {
    /// A point that rests, m.
    pub fn point(&self, x: f64, y: f64) -> Place { loop {} }
}
";
const SPATIAL_GROUND: &str = "
pub struct Ground {
    /// The origin of the world.
    pub origin: Place,
    /// The x axis of the world.
    pub x: Vector,
    /// The y axis of the world.
    pub y: Vector,
    /// The z axis of the world.
    pub z: Vector,
}
impl Ground {
    /// A point that rests, m.
    pub fn point(&self, x: f64, y: f64, z: f64) -> Place { loop {} }
    /// A place that rests, and an axis, for a joint.
    pub fn frame(&self, place: [f64; 3], axis: [f64; 3]) -> Place { loop {} }
}
";
const FAMILY: &str = "
/// One for each index.
pub struct Family<T>(T);
impl<T, I> ::core::ops::Index<I> for Family<T> {
    type Output = T;
    fn index(&self, _: I) -> &T { loop {} }
}
";
const COMMON: &str = "
pub struct Value;
/// What rests.
static ground: members::Ground = any();
/// Time, s.
static t: f64 = any();
/// π.
static pi: f64 = any();
/// The axis x.
static X: members::Vector = any();
/// The axis y.
static Y: members::Vector = any();
/// The axis z.
static Z: members::Vector = any();
fn any<T>() -> T { loop {} }
fn given<T, U>(_: T) -> U { loop {} }
/// Holds an initial value: assembly lets the rest follow.
pub fn Exactly<T>(value: T) -> T { value }
/// Sine of an angle, rad.
pub fn sin(x: f64) -> f64 { loop {} }
/// Cosine of an angle, rad.
pub fn cos(x: f64) -> f64 { loop {} }
/// Tangent of an angle, rad.
pub fn tan(x: f64) -> f64 { loop {} }
/// Angle with this sine, rad.
pub fn asin(x: f64) -> f64 { loop {} }
/// Angle with this cosine, rad.
pub fn acos(x: f64) -> f64 { loop {} }
/// Angle with this tangent, rad.
pub fn atan(x: f64) -> f64 { loop {} }
/// Hyperbolic sine.
pub fn sinh(x: f64) -> f64 { loop {} }
/// Hyperbolic cosine.
pub fn cosh(x: f64) -> f64 { loop {} }
/// Hyperbolic tangent.
pub fn tanh(x: f64) -> f64 { loop {} }
/// Exponential.
pub fn exp(x: f64) -> f64 { loop {} }
/// Natural logarithm.
pub fn ln(x: f64) -> f64 { loop {} }
/// Square root; the unit is that of the root.
pub fn sqrt(x: f64) -> f64 { loop {} }
/// Absolute value.
pub fn abs(x: f64) -> f64 { loop {} }
/// −1, 0 or 1.
pub fn sign(x: f64) -> f64 { loop {} }
/// 1 above 0, else 0.
pub fn step(x: f64) -> f64 { loop {} }
/// Angle of the vector (x, y), rad.
pub fn atan2(y: f64, x: f64) -> f64 { loop {} }
/// Length of the vector (a, b).
pub fn hypot(a: f64, b: f64) -> f64 { loop {} }
/// The smaller one.
pub fn min(a: f64, b: f64) -> f64 { loop {} }
/// The larger one.
pub fn max(a: f64, b: f64) -> f64 { loop {} }
/// Scalar product.
pub fn dot<A, B>(a: A, b: B) -> f64 { loop {} }
/// Vector product; in the plane its component z.
pub fn cross<A, B, C>(a: A, b: B) -> C { loop {} }
/// Length of a vector.
pub fn norm<A>(a: A) -> f64 { loop {} }
/// The vector of length 1 in this direction.
pub fn unit<A>(a: A) -> members::Vector { loop {} }
/// a without its part along b.
pub fn reject<A, B>(a: A, b: B) -> members::Vector { loop {} }
/// Principal moments of inertia.
pub fn diag<A>(a: A, b: A, c: A) -> A { loop {} }
/// The time derivative.
pub fn rate<A>(a: A) -> A { loop {} }
/// A turn about an axis, rad.
pub fn turn<A>(axis: A, angle: f64) -> Value { loop {} }
";
