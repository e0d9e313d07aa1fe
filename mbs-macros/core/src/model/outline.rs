//! What a mechanism is called and made of.

use super::drawing::Drawing;
use super::formulation::Formulation;
use super::parts::Part;
use super::quantities::{Law, Local, Quantity, ScalarState};
use super::tree::Tree;
use crate::schema::World;
use crate::symbolic::Table;
use std::sync::Arc;

/// Data of a model for later stages besides its equations: names, parts, and the reductions.
#[derive(Debug)]
pub struct Outline {
    /// The name given to `mechanism!`.
    pub name: String,
    /// Its documentation.
    pub doc: String,
    /// The plane or space.
    pub world: World,
    /// Its declaration as text.
    pub text: String,
    /// Parameters, in declaration order.
    pub parameters: Vec<Quantity>,
    /// Inputs, in declaration order.
    pub inputs: Vec<Quantity>,
    /// Outputs.
    pub outputs: Vec<Quantity>,
    /// Events.
    pub events: Vec<String>,
    /// The unit vector against gravity with default parameters; without gravity, y in the plane and z in space.
    pub up: [f64; 3],
    /// Coordinates of the parts on their own.
    pub locals: Vec<Local>,
    /// Bars, bodies, particles.
    pub parts: Vec<Part>,
    /// States, in declaration order.
    pub states: Vec<ScalarState>,
    /// Joints and constraints that leave rows.
    pub joints: Vec<String>,
    /// Joints of which rows were solved.
    pub solved: Vec<String>,
    /// Force elements.
    pub forces: Vec<String>,
    /// Joints that became coordinates.
    pub tree: Tree,
    /// The choice of coordinates.
    pub formulation: Formulation,
    /// What the reduction did, in sentences.
    pub reductions: Vec<String>,
    /// What an animation draws.
    pub drawing: Drawing,
    /// Paths of the users' laws and the number of their arguments.
    pub laws: Vec<Law>,
    /// Tables.
    pub tables: Vec<Arc<Table>>,
}
