//! Force elements, one file each: what the declaration says (`read`, stage 2) and what they contribute (stage 3).
//! Those of one world are in `planar` and `spatial`. A new force element needs its file, a line in `read` and an entry in
//! the schema.

mod force;
mod planar;
mod spatial;
mod spring_damper;

use crate::model::{Arguments, Axes, Owner, Point};
use crate::schema::World;
use crate::symbolic::{Expr, Graph};
use std::fmt::Debug;

/// A force element.
pub trait Force: Debug {
    /// What it contributes, in local coordinates.
    fn action(&self, graph: &mut Graph) -> Action;

    /// The points it acts on.
    fn points(&self) -> Vec<&Point> {
        Vec::new()
    }

    /// Parts it acts on otherwise than by points.
    fn owners(&self) -> Vec<Owner> {
        Vec::new()
    }
}

/// What a force element contributes.
#[derive(Debug, Default)]
pub struct Action {
    /// Potential energy.
    pub potential: Option<Expr>,
    /// Forces without potential.
    pub loads: Vec<Load>,
}

/// A scalar force against the rate it works on: its power is their product, its generalized force on coordinate i
/// is force · ∂rate/∂vᵢ.
#[derive(Debug, Clone, Copy)]
pub struct Load {
    /// Linear in the velocities.
    pub rate: Expr,
    /// The force.
    pub force: Expr,
}

/// Reads a force element.
pub fn read(kind: &str, arguments: &mut Arguments) -> Option<Box<dyn Force>> {
    match kind {
        "SpringDamper" => spring_damper::read(arguments),
        "Force" => force::read(arguments),
        _ => match arguments.world() {
            World::Planar => planar::read(kind, arguments),
            World::Spatial => spatial::read(kind, arguments),
        },
    }
}

/// The axes in which the components of a force are given, by `axes =`.
fn force_in(arguments: &mut Arguments) -> Option<Axes> {
    if !arguments.has("axes") {
        return Some(arguments.graph().ground_axes());
    }
    let owner = arguments.part("axes")?;
    let name = arguments.owner_name(owner);
    if arguments.is_particle(owner) || arguments.is_slender(owner) {
        return arguments.fail("axes", format!("`{name}` has no axes; use a `Body`"));
    }
    Some(arguments.frame(owner).axes)
}

/// How a spring and damper answers to a deflection: linearly, or by a user's law of [deflection, rate].
#[derive(Debug)]
enum Characteristic {
    Linear {
        stiffness: Expr,
        damping: Expr,
        free: Expr,
    },
    Law(u32),
}

impl Characteristic {
    /// Reads `stiffness`, `damping` and the free deflection, or `law`.
    fn read(arguments: &mut Arguments, free: &str) -> Option<Characteristic> {
        if arguments.has("law") {
            if let Some(field) = ["stiffness", "damping", free]
                .into_iter()
                .find(|field| arguments.has(field))
            {
                return arguments.fail(
                    field,
                    "a law takes the place of stiffness, damping and free length; keep one of them",
                );
            }
            return arguments.law("law", 2).map(Characteristic::Law);
        }
        if !arguments.has("stiffness") && !arguments.has("damping") {
            return arguments.fail(
                "",
                "this element does nothing; give it `stiffness =`, `damping =` or `law =`",
            );
        }
        let stiffness = arguments.scalar_or("stiffness", 0.0);
        let damping = arguments.scalar_or("damping", 0.0);
        let free = arguments.scalar_or(free, 0.0);
        Some(Characteristic::Linear {
            stiffness: stiffness?,
            damping: damping?,
            free: free?,
        })
    }

    /// The action against a growing deflection.
    fn action(&self, graph: &mut Graph, deflection: Expr, rate: Expr) -> Action {
        match *self {
            Characteristic::Linear {
                stiffness,
                damping,
                free,
            } => {
                let stretch = graph.sub(deflection, free);
                let square = graph.square(stretch);
                let energy = graph.mul(stiffness, square);
                let energy = graph.scale(0.5, energy);
                let drag = graph.mul(damping, rate);
                let force = graph.neg(drag);
                let loads = if graph.is_zero(force) {
                    Vec::new()
                } else {
                    vec![Load { rate, force }]
                };
                Action {
                    potential: (!graph.is_zero(energy)).then_some(energy),
                    loads,
                }
            }
            Characteristic::Law(law) => {
                let tension = graph.law(law, &[deflection, rate]);
                let force = graph.neg(tension);
                Action {
                    potential: None,
                    loads: vec![Load { rate, force }],
                }
            }
        }
    }
}
