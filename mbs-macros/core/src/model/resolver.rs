//! The state of stage 2 while it resolves names, shared by its files.

use super::elements::ReadForce;
use super::formulation::Formulation;
use super::geometry::Owner;
use super::joint_variables::{AskedVariable, UnwrappedAngle};
use super::needs_angle::needs_angle;
use super::parts::Part;
use super::quantities::{Law, Local, Quantity, ScalarState};
use super::readings::Reading;
use super::requirements::Requirement;
use super::value::Value;
use crate::diagnostics::{Errors, Place};
use crate::schema::{Group, Kind, Kinds, World};
use crate::symbolic::{Graph, Map, Set, Table};
use crate::syntax::{Declaration, Entry};
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// The value of an entry: it is evaluated at its first use.
pub(super) enum State {
    Waiting,
    Working,
    Done(Option<Value>),
}

/// A mechanism in space of as many entries may have many parts that are the same but for their places.
const MANY: usize = 40;

/// The state of stage 2.
pub struct Resolver<'d> {
    pub(super) declaration: &'d Declaration,
    pub(super) errors: &'d mut Errors,
    pub(super) kinds: &'static Kinds,
    pub(super) world: World,
    pub(super) formulation: Formulation,
    pub(super) graph: Graph,
    pub(super) parameters: Vec<Quantity>,
    pub(super) inputs: Vec<Quantity>,
    pub(super) locals: Vec<Local>,
    pub(super) parts: Vec<Part>,
    pub(super) scalar_states: Vec<ScalarState>,
    pub(super) laws: Vec<Law>,
    pub(super) tables: Vec<Arc<Table>>,
    /// What the program has to check.
    pub(super) requirements: Vec<Requirement>,
    /// Angles that are counted over full turns.
    pub(super) unwrapped_angles: Vec<UnwrappedAngle>,
    /// Variables of joints that an expression uses.
    pub(super) joint_variables: Vec<AskedVariable>,
    /// Components of reactions that outputs read.
    pub(super) readings: Vec<Reading>,
    /// Force elements that have been read.
    pub(super) force_elements: Map<usize, ReadForce>,
    /// Whether accelerations and reactions can be read: in outputs.
    pub(super) at_acceleration_level: bool,
    /// Whether points and axes of parts are those of the home pose: in places and directions that are given there.
    pub(super) in_home_pose: bool,
    /// The values in the home pose of each `Let` that moves.
    pub(super) home_values: Map<usize, Value>,
    /// Names that an expression uses.
    pub(super) used: Set<String>,
    /// Entries whose arguments are not those of their kind, which is an error already.
    pub(super) misplaced: HashSet<String>,
    /// Bars that need an angle.
    pub(super) needs_angle: HashSet<String>,
    pub(super) names: Map<String, usize>,
    /// What unknown names may be misspellings of, in words.
    pub(super) hints: HashMap<String, String>,
    pub(super) states: Vec<State>,
    pub(super) silent: bool,
    /// Depth of the nested evaluations.
    pub(super) depth: usize,
}

impl<'d> Resolver<'d> {
    pub(super) fn new(
        declaration: &'d Declaration,
        kinds: &'static Kinds,
        formulation: Formulation,
        errors: &'d mut Errors,
    ) -> Self {
        Resolver {
            declaration,
            errors,
            kinds,
            world: declaration.world_kind(),
            formulation,
            graph: match (declaration.world_kind(), declaration.entries.len()) {
                (World::Spatial, MANY..) => Graph::of_many(),
                _ => Graph::default(),
            },
            parameters: Vec::new(),
            inputs: Vec::new(),
            locals: Vec::new(),
            parts: Vec::new(),
            scalar_states: Vec::new(),
            laws: Vec::new(),
            tables: Vec::new(),
            requirements: Vec::new(),
            unwrapped_angles: Vec::new(),
            joint_variables: Vec::new(),
            readings: Vec::new(),
            force_elements: Map::default(),
            at_acceleration_level: false,
            in_home_pose: false,
            home_values: Map::default(),
            used: Set::default(),
            misplaced: HashSet::new(),
            needs_angle: needs_angle(declaration, kinds),
            names: Map::default(),
            hints: HashMap::new(),
            states: Vec::new(),
            silent: false,
            depth: 0,
        }
    }

    /// Records an error, and returns `None`.
    pub(super) fn fail<T>(
        &mut self,
        place: impl Into<Place>,
        message: impl std::fmt::Display,
    ) -> Option<T> {
        if !self.silent {
            self.errors.at(place, message);
        }
        None
    }

    /// Records an error made elsewhere, and returns `None`.
    pub(super) fn fail_with<T>(&mut self, error: syn::Error) -> Option<T> {
        if !self.silent {
            self.errors.push(error);
        }
        None
    }

    /// Records an error about an entry, which may be a member of a family.
    pub(super) fn fail_about(
        &mut self,
        entry: &str,
        place: impl Into<Place>,
        message: impl std::fmt::Display,
    ) {
        let before = self.errors.enter(entry);
        self.fail::<()>(place, message);
        self.errors.leave(before);
    }

    /// Runs something without recording its errors.
    pub(super) fn silently<T>(&mut self, run: impl FnOnce(&mut Self) -> T) -> T {
        let before = std::mem::replace(&mut self.silent, true);
        let result = run(self);
        self.silent = before;
        result
    }

    pub(super) fn entry(&self, index: usize) -> &'d Entry {
        &self.declaration.entries[index]
    }

    /// Adds a part.
    pub(super) fn add_part(&mut self, part: Part) -> Option<Value> {
        self.parts.push(part);
        Some(Value::Frame(Owner::Part(self.parts.len() - 1)))
    }

    /// The kind of an entry, where this world has it.
    pub(super) fn kind_of(&self, entry: &Entry) -> Option<&'static Kind> {
        self.kinds.kind(self.world, &entry.kind.to_string())
    }

    /// Whether an entry connects its two partners by frames: joints of space, and elastic joints.
    pub(super) fn has_frames(&self, entry: &Entry) -> bool {
        self.world == World::Spatial
            && self.kind_of(entry).is_some_and(|kind| {
                matches!(kind.group, Group::Joint | Group::Force)
                    && kind.fields.iter().any(|field| field.name == "at")
            })
    }
}
