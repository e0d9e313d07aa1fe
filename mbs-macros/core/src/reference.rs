//! The reference page of the language, from the schema and the table of units.

use crate::dimension::{Dimension, UNITS};
use crate::model;
use crate::schema::{Absent, Expects, Field, Group, Kind, World};
use std::fmt::Write;

const HEADINGS: [(Group, &str); 5] = [
    (Group::Value, "Values"),
    (Group::Part, "Parts"),
    (Group::Joint, "Joints"),
    (Group::Constraint, "Conditions"),
    (Group::Force, "Forces"),
];

/// The page as Markdown.
pub fn page() -> String {
    let mut out = String::from(INTRODUCTION);
    let _ = writeln!(out, "\n## Worlds");
    for world in World::ALL {
        entry(&mut out, world.kind(), Some(world), "");
    }
    let _ = writeln!(out, "\n# Kinds of both worlds");
    kinds(&mut out, model::kinds().common(), None);
    for world in World::ALL {
        let _ = writeln!(out, "\n# Kinds of {}", world.describe());
        kinds(&mut out, model::kinds().own(world), Some(world));
    }
    units(&mut out);
    out
}

/// With the world behind each heading: the list of headings beside the page then says which world they belong to.
fn kinds(out: &mut String, kinds: &[Kind], world: Option<World>) {
    let of = world.map_or(String::new(), |world| format!(" of {}", world.describe()));
    for (group, heading) in HEADINGS {
        let mut list = kinds.iter().filter(|kind| kind.group == group).peekable();
        if list.peek().is_some() {
            let _ = writeln!(out, "\n## {heading}{of}");
        }
        list.for_each(|kind| entry(out, kind, world, &of));
    }
}

const INTRODUCTION: &str = "\
# The language

A declaration is a list of entries `name: Kind(arguments)`, in any order. Arguments marked *positional* may be given in
their order without a name; all others are `name = value`. Numbers carry units as suffixes (`0.15_m`, `9.81_m_per_s2`,
`30.0_deg`); a bare number is in SI units. `ground`, `t`, `pi`, `X`, `Y` and, in space, `Z` have fixed meanings.

Expressions know `+ − * /`, `sin cos tan asin acos atan sinh cosh tanh exp ln sqrt abs sign step`, `atan2 hypot min max`,
`x.powi(2)` and `x.powf(1.5)`, `name(x)` for a `Table` of this name, vectors `[x, y]` or `[x, y, z]` with `dot cross norm unit reject` and `.x .y .z`
(`reject(a, b)` is a without its part along b; in the plane `cross` is a number), `rate(…)` for the time derivative of an
expression of positions, and `law(path, argument, …)` for functions of your own (`fn([f64; K]) -> (f64, [f64; K])`, value and
partials).

Lines `/// …` before an entry document it. Inside an entry there are no documentation and no attributes, and no `pub`: all fields
are public.

Parts have `velocity`, the axes `x`, `y` and `z`, points (`a`, `b`, `center` of a bar; `origin` and `center` of a body;
`origin` of a particle and of the ground), `point(x, y)` or `point(x, y, z)` in their own axes, and `velocity_at(point)`; in
the plane also `angle` and `rate`, in space `angular_velocity` and `frame([x, y, z], axis)`, a place and an axis for a joint.
Points have components and `velocity`; a coordinate has `rate`. The name of a particle also stands for its point `origin`, where an
argument takes a point: `Distance(ground.origin, bob, length = 1.0_m)`. Joints have what their kind says below, of the second
partner against the first: `angle`, `rate`, `stroke`, `speed`. In the plane the angle is between the x axes of the
partners, in space it is 0 in the home pose. Angles of bars, bodies and joints are counted over full turns.

Forces have `force` or `torque`, which every expression that may move can read: the tension of a `SpringDamper` and the torque of a
`TorsionSpring` as their laws give them, positive where they oppose a growing deflection; the force of a `Stop` along its target,
positive from the lower stop; the force of a `Friction` along its speed, negative while the speed is positive; the value of a
`Force`, a `Torque` or a `Wrench`, in its axes; and both of a `Bushing`, as vectors on its second partner in the axes of the first.

An `Output` can also read what follows from the equations of motion: `acceleration` of parts and points, in space
`angular_acceleration` of parts, `rate(…)` of expressions of velocities, and components of reactions, as in
`pin.reaction.fx` or `motor.reaction.torque`, with the names of `MODEL.reactions`.

`name: Each(0..5, |i| Kind(…))` is a *family*: one entry for each index of the range `0..5` or `0..=4`, with the names
`name[0]` to `name[4]`. An expression names a member by `name[…]` with whole numbers, indices and `+ − * / %`, as in
`crank[i - 1].b`; elsewhere an index is an ordinary number. `Each([x, y], |x| …)` and `Each([x, y], |i, x| …)` go over a list,
whose items may be taken apart: `Each([(x, y), (z, w)], |(a, b)| …)`. `Each((0..5, 0..3), |i, j| …)` has two indices:
`name[i][j]`. `if i == 0 { … } else { … }` takes the branch of each member, inside expressions or around its kind; an `if`
without `else` around the kind leaves members out. A family of `Param`, `Input` or `Output` is an array in the program,
`name: [f64; 5]`; its indices begin at 0. A family has at most 10000 members, and no families inside.

`name: Assembly(Path, port = …)` puts the entries of an *assembly* in place, which `assembly!` declares: its entries are
`name.entry`, its parameters, inputs and outputs fields of `name`. Inside, `name: Port(Point)`, or of a `Part`, `Frame`,
`Number`, `Vector` or `Table`, is what the surroundings give, and `Port(Number, default = 1.0)` what they may give.
Parameters of an assembly may be given, too: this changes their defaults.

In space places (`at`, `from`, `to`), orientations, the axes of joints and lengths are those of the home pose, and so are the
points and axes of parts in them: `to = arm.b + [0.0, 0.0, 0.2_m]`, `axis = unit(arm.b - arm.a)`, `length = norm(arm.b)`, directly or by a `Let`, which moves with
its parts everywhere else.

Initial values are guesses, which assembly changes until the joints fit. `Exactly(…)` around one holds it, as in
`angle = Exactly(0.4_rad)` and `rate = Exactly(9.0_rad_per_s)`: then the others follow. As many positions
may be held as the holonomic rows leave free, as many velocities as there are degrees of freedom, and values that follow from these.
Given to a port, `Exactly(…)` holds the initial values of which the port is the whole, as in `angle = port`; in an expression the port is its
value.

Masses, inertias and lengths that follow from parameters are checked with the defaults by the compiler, and with the values
of the program when a simulation is made.

Rows that follow from others are found and named; they are harmless, and part of the mechanism's documentation. Where they
would be a mistake, `deny: Redundant()` makes each an error at its joint. An entry that nothing uses is an error; while a
declaration grows, `allow: Unused()` lets it pass.

Generated code names its library `::mbs_runtime`. Where a crate has it under another name, or only through another crate, it
gives the path first: `mechanism!(crate = product::mbs, SliderCrank { … })`, and `assembly!` alike.

This page is written by the compiler's own table of kinds, and tested to be up to date.
";

fn entry(out: &mut String, kind: &Kind, world: Option<World>, of: &str) {
    let _ = writeln!(out, "\n### `{}`{of}\n\n{}\n", kind.name, kind.doc);
    let _ = writeln!(out, "| argument | takes | if left out | |");
    let _ = writeln!(out, "|---|---|---|---|");
    let fields = kind.fields.iter();
    fields.for_each(|field| row(out, field, world));
}

fn row(out: &mut String, field: &Field, world: Option<World>) {
    let positional = if field.positional {
        " *(positional)*"
    } else {
        ""
    };
    let held = match field.initial {
        Some(_) => "; may be held by `Exactly(…)`",
        None => "",
    };
    let absent = match field.default {
        Absent::Required => "required",
        Absent::Assumed(text) => text,
    };
    let _ = writeln!(
        out,
        "| `{}`{positional} | {}{held} | {absent} | {} |",
        field.name,
        takes(field.expects, world),
        field.doc
    );
}

fn takes(expects: Expects, world: Option<World>) -> String {
    let moving = "; may change with time, state and inputs";
    match expects {
        Expects::Known(dimension) => dimension.to_string(),
        Expects::KnownAny => "a number".to_owned(),
        Expects::KnownVector(dimension) => format!("vector of {dimension}"),
        Expects::Moving(dimension) => format!("{dimension}{moving}"),
        Expects::MovingAny => format!("a number{moving}"),
        Expects::ScheduledAny => "a number; an expression of `t`, parameters and inputs".to_owned(),
        Expects::HolonomicAny => {
            "a number; an expression of positions, parameters and `t`".to_owned()
        }
        Expects::Driven => "a number; an expression of positions or velocities".to_owned(),
        Expects::MovingVector(dimension) => format!("vector of {dimension}{moving}"),
        Expects::FollowingAny => "a number; an expression of positions and parameters".to_owned(),
        Expects::FollowingVector(dimension) => {
            format!("vector of {dimension}; an expression of coordinates and parameters")
        }
        Expects::Anything => "an expression or a list".to_owned(),
        Expects::Sampled => "a number, a vector or a point".to_owned(),
        Expects::Point => "a point".to_owned(),
        Expects::Part | Expects::PartAngle => "a part or `ground`".to_owned(),
        Expects::Axis => match world {
            Some(World::Planar) => "`X`, `Y` or components `[x, y]`".to_owned(),
            _ => "`X`, `Y`, `Z` or components `[x, y, z]`".to_owned(),
        },
        Expects::Attachment => "a part with `at =`, a point, or a frame".to_owned(),
        Expects::Joint => "a joint".to_owned(),
        Expects::Orientation => "`turn(axis, angle)`, `quaternion(w, x, y, z)`, `axes(x, y)`, a part (as it is in the home pose), or a list of these, each in the axes that the one before has turned".to_owned(),
        Expects::Formulation => "`Auto`, `Natural`, `Reference` or `Joint`".to_owned(),
        Expects::Shape => "`Cuboid(x, y, z)`, `Cylinder(radius, length, axis)` or `Sphere(radius)`".to_owned(),
        Expects::Inertia => {
            "moment of inertia (kg m²), `diag(a, b, c)`, three rows, `Cuboid(x, y, z)`, `Cylinder(radius, length, axis)` or `Sphere(radius)`".to_owned()
        }
        Expects::Gains(dimension) => format!("{dimension}: one, three, or a 3 × 3 matrix"),
        Expects::Frame => "`Frame([x, y], angle)`".to_owned(),
        Expects::Law => "the path of a law, or a `Table`".to_owned(),
        Expects::Numbers => "a list of numbers and parameters, or the name of a family of parameters".to_owned(),
        Expects::Word(words) => words_of(words),
        Expects::Unit => "an SI unit".to_owned(),
        Expects::Flag => "`true` or `false`".to_owned(),
        Expects::Count => "a whole number".to_owned(),
    }
}

fn words_of(words: &[&str]) -> String {
    let words: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
    words.join(" or ")
}

fn units(out: &mut String) {
    let _ = writeln!(
        out,
        "\n## Units\n\nJoined by `_`, divided after `per`, powers as digits: `kg_m2`, `N_s_per_m`.\n"
    );
    let _ = writeln!(out, "| unit | in SI | of |");
    let _ = writeln!(out, "|---|---|---|");
    for (name, factor, dimension) in UNITS {
        let unit = if *dimension == Dimension::NONE {
            "rad".to_owned()
        } else {
            dimension.unit()
        };
        let _ = writeln!(out, "| `{name}` | {factor} {unit} | {dimension} |");
    }
}
