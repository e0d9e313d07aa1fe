//! Names and the values of their entries: evaluated at their first use, so that entries may be in any order.

use super::arguments::Arguments;
use super::geometry::{Owner, Point, Vector};
use super::quantities::{Law, Quantity, quantity};
use super::resolver::{Resolver, State};
use super::value::Value;
use crate::diagnostics::{Place, did_you_mean};
use crate::dimension::Dimension;
use crate::names::is_one_of_many;
use crate::schema::{RESERVED, World};
use crate::symbolic::{Graph, Symbol};
use crate::syntax::{Entry, Reference, is_constant};

/// Errors up to which names like an unknown one are searched: each search compares with all names, and nobody reads so
/// many hints.
const SEARCHED: usize = 50;

impl<'d> Resolver<'d> {
    /// Notes the names of all entries.
    pub(super) fn declare(&mut self) {
        for (index, entry) in self.declaration.entries.iter().enumerate() {
            self.states.push(State::Waiting);
            self.names.insert(entry.name.to_string(), index);
        }
    }

    /// Parameters and inputs first, so that they are listed as declared.
    pub(super) fn quantities(&mut self) {
        for (index, entry) in self.declaration.entries.iter().enumerate() {
            if entry.kind == "Param" || entry.kind == "Input" {
                self.force(index);
            }
        }
    }

    pub(super) fn gravity(&mut self) -> Vector {
        let zero = self.graph.zero();
        let Some(world) = &self.declaration.world else {
            return [zero; 3];
        };
        Arguments::new(self, world)
            .vector("gravity")
            .unwrap_or([zero; 3])
    }

    /// The unit vector against gravity.
    pub(super) fn up(&self, gravity: Vector) -> [f64; 3] {
        let down = gravity.map(|x| self.by_default(x));
        let length = down.iter().map(|x| x * x).sum::<f64>().sqrt();
        match self.world {
            _ if length > 0.0 => down.map(|x| if x == 0.0 { 0.0 } else { -x / length }),
            World::Planar => [0.0, 1.0, 0.0],
            World::Spatial => [0.0, 0.0, 1.0],
        }
    }

    /// The value of what an expression names.
    pub(super) fn lookup(&mut self, reference: &Reference, place: Place) -> Option<Value> {
        let name = reference.text();
        if !reference.indices.is_empty() || self.declaration.family(&name).is_some() {
            self.check_indices(reference, place)?;
        }
        self.value_named(&name, place)
    }

    /// Refuses indices that are not those of a member.
    fn check_indices(&mut self, reference: &Reference, place: Place) -> Option<()> {
        let (word, text) = (&reference.base, reference.text());
        let declaration = self.declaration;
        let Some(family) = declaration.family(word) else {
            if !self.names.contains_key(word) && !RESERVED.contains(&word.as_str()) {
                return self.unknown(word, reference.word.span().into());
            }
            return self.fail(
                place,
                format!("`{word}` is one entry and no family; leave the index out"),
            );
        };
        if self.names.contains_key(&text) {
            return Some(());
        }
        if declaration.instance(&text).is_some() {
            return self.unknown(&text, place);
        }
        let ([first, last], example) = (family.ends(), family.example());
        if reference.indices.len() != family.ranges.len() {
            return self.fail(
                place,
                format!(
                    "`{word}` is a family: name a member, `{example}`, from `{first}` to `{last}`"
                ),
            );
        }
        match family.contains(&reference.indices) {
            false => self.fail(
                place,
                format!(
                    "there is no `{text}`; the members of `{word}` go from `{first}` to `{last}`"
                ),
            ),
            true => self.fail(
                place,
                format!("there is no `{text}`; the `if` of `{word}` leaves it out"),
            ),
        }
    }

    fn unknown<T>(&mut self, name: &str, place: Place) -> Option<T> {
        let declaration = self.declaration;
        if let Some(instance) = declaration.instance(name) {
            let inside = format!("{name}.");
            let first = declaration.entries.iter().map(|entry| entry.name.as_str());
            let first = first.into_iter().find(|entry| entry.starts_with(&inside));
            return self.fail(
                place,
                format!(
                    "`{name}` is an assembly; name one of its entries, as in `{}`",
                    first.unwrap_or(instance.name.as_str())
                ),
            );
        }
        if let Some((outer, own)) = name.rsplit_once('.')
            && let Some(instance) = declaration.instance(outer)
        {
            let definition = &instance.definition;
            if definition.ports.iter().any(|port| port.name == own) {
                return self.fail(
                    place,
                    format!(
                        "`{own}` is a port of the assembly `{}`, and only the entries of the assembly read it: write here what it was given",
                        definition.name
                    ),
                );
            }
            let inside = format!("{outer}.");
            let known = declaration
                .entries
                .iter()
                .filter(|entry| entry.name.assembly() == outer);
            let known: Vec<&str> = known
                .map(|entry| &entry.name.base()[inside.len()..])
                .collect();
            let hint = did_you_mean(own, known.iter().copied());
            return self.fail(
                place,
                format!(
                    "the assembly `{}` has no entry or port `{own}`{hint}",
                    definition.name
                ),
            );
        }
        // The names of an assembly alone, which has no world, have been looked up before.
        if declaration.world.is_none() && self.errors.are_at(place) {
            return None;
        }
        let hint = self.name_like(name);
        self.fail(place, format!("nothing here is named `{name}`{hint}"))
    }

    /// The value of this name.
    pub(super) fn value_named(&mut self, name: &str, place: Place) -> Option<Value> {
        let number = |value: f64, graph: &mut Graph| graph.constant(value);
        match name {
            "ground" => return Some(Value::Frame(Owner::Ground)),
            "t" => {
                return Some(Value::Scalar(
                    self.graph.symbol(Symbol::Time),
                    Some(Dimension::TIME),
                ));
            }
            "pi" => {
                return Some(Value::Scalar(
                    number(std::f64::consts::PI, &mut self.graph),
                    None,
                ));
            }
            "Z" if self.world == World::Planar => {
                return self.fail(
                    place,
                    "a planar world has no axis Z; use X, Y or components [x, y]",
                );
            }
            "X" | "Y" | "Z" => {
                let axes = self.graph.ground_axes();
                let axis = axes[usize::from(name.as_bytes()[0] - b'X')];
                return Some(Value::Vector(axis, Some(Dimension::NONE)));
            }
            _ => {}
        }
        let Some(&index) = self.names.get(name) else {
            return self.unknown(name, place);
        };
        if !self.silent {
            self.note_use(name);
        }
        if matches!(self.states[index], State::Working) {
            return self.fail(place, format!("`{name}` depends on itself; let it name only entries that do not lead back to it"));
        }
        self.force(index);
        if let Some(syntax) = self.moving_value(index) {
            if let Some(known) = self.home_values.get(&index) {
                return Some(known.clone());
            }
            let value = self.evaluate(syntax)?;
            self.home_values.insert(index, value.clone());
            return Some(value);
        }
        match &self.states[index] {
            State::Done(Some(value)) => Some(value.clone()),
            State::Done(None) => {
                let entry = self.entry(index);
                if self.is_value(entry) {
                    // Its own error is recorded already.
                    return None;
                }
                let hint = match self.load_names(index).first() {
                    Some(load) => format!("; read `{name}.{load}`"),
                    None => String::new(),
                };
                self.fail(
                    place,
                    format!(
                        "`{name}` is declared as `{}`, which has no value that an expression could use{hint}",
                        entry.kind
                    ),
                )
            }
            State::Waiting | State::Working => None,
        }
    }

    /// The expression of a `Let` whose value moves, where that in the home pose is asked for.
    fn moving_value(&self, index: usize) -> Option<&'d syn::Expr> {
        let entry = self.entry(index);
        if !self.in_home_pose || entry.kind != "Let" {
            return None;
        }
        let State::Done(Some(value)) = &self.states[index] else {
            return None;
        };
        let moves = |symbol: Symbol| !symbol.is_parameter_like();
        let is_moving = value.depends_on(&self.graph, moves);
        is_moving.then(|| entry.positional.first()).flatten()
    }

    /// Whether an entry or a word of the language has this name.
    pub(super) fn is_declared(&self, name: &str) -> bool {
        self.names.contains_key(name) || RESERVED.contains(&name)
    }

    pub(super) fn note_use(&mut self, name: &str) {
        if !self.used.contains(name) {
            self.used.insert(name.to_owned());
        }
    }

    /// What an unknown name may be a misspelling of, in words.
    fn name_like(&mut self, name: &str) -> String {
        // What is being evaluated cannot be what it reads, and the same name elsewhere may mean it.
        if let Some(&own) = self.names.get(&name.to_lowercase())
            && matches!(self.states[own], State::Working)
            && is_constant(name)
        {
            return constant_hint(name);
        }
        if let Some(hint) = self.hints.get(name) {
            return hint.clone();
        }
        let hint = match self.errors.count() < SEARCHED {
            true => self.search(name),
            false => String::new(),
        };
        self.hints.insert(name.to_owned(), hint.clone());
        hint
    }

    fn search(&self, name: &str) -> String {
        let mut names = self.names.keys();
        if is_constant(name) && names.all(|known| !known.eq_ignore_ascii_case(name)) {
            return constant_hint(name);
        }
        let families = self.declaration.families.iter();
        let families: Vec<String> = families.map(|family| family.name.to_string()).collect();
        let own = self.names.keys().filter(|name| !is_one_of_many(name));
        let own = own.chain(&families).map(String::as_str);
        let mut known: Vec<&str> = own
            .chain(["ground", "t", "X", "Y", "Z", "pi"])
            .filter(|name| *name != "Z" || self.world == World::Spatial)
            .collect();
        known.sort_unstable();
        did_you_mean(name, known)
    }

    fn is_value(&self, entry: &Entry) -> bool {
        let kind = entry.kind.to_string();
        matches!(
            kind.as_str(),
            "Param"
                | "Input"
                | "Let"
                | "Table"
                | "Point"
                | "Coordinate"
                | "State"
                | "Bar"
                | "Body"
                | "Particle"
        ) || self.has_frames(entry)
            || self.is_planar_joint(entry)
    }

    /// Whether every entry that has a value has been evaluated; joints of the plane are where an expression names them.
    pub(super) fn is_evaluated(&self) -> bool {
        let mut entries = self.declaration.entries.iter().zip(&self.states);
        entries.all(|(entry, state)| matches!(state, State::Done(_)) || self.is_planar_joint(entry))
    }

    /// The value of an entry.
    pub(super) fn value_of(&mut self, entry: &Entry) -> Option<Value> {
        let index = *self.names.get(&entry.name.to_string())?;
        self.force(index);
        match &self.states[index] {
            State::Done(value) => value.clone(),
            State::Waiting | State::Working => None,
        }
    }

    /// Evaluates an entry that has a value, once.
    pub(super) fn force(&mut self, index: usize) {
        if !matches!(self.states[index], State::Waiting) {
            return;
        }
        let entry = self.entry(index);
        let hinged = self.has_frames(entry) || self.is_planar_joint(entry);
        if hinged && self.misplaced.contains(&self.entry(index).name.to_string()) {
            self.states[index] = State::Done(None);
            return;
        }
        self.states[index] = State::Working;
        let silent = std::mem::replace(&mut self.silent, false);
        let in_home_pose = std::mem::replace(&mut self.in_home_pose, false);
        let entry = self.entry(index);
        let before = self.errors.enter(entry.name.as_str());
        let value = match entry.kind.to_string().as_str() {
            "Param" => self.parameter(entry),
            "Input" => self.input(entry),
            "Let" => entry
                .positional
                .first()
                .and_then(|syntax| self.evaluate(syntax)),
            "Table" => self.table(entry),
            "Point" => self.ground_point(entry),
            "Coordinate" => self.coordinate(entry),
            "State" => self.state(entry),
            "Bar" if self.world == World::Planar => self.planar_bar(entry),
            "Bar" => self.spatial_bar(entry),
            "Body" if self.world == World::Planar => self.planar_body(entry),
            "Body" => self.spatial_body(entry),
            "Particle" => self.particle(entry),
            _ if self.has_frames(entry) => self.joint_frames(entry),
            _ if self.is_planar_joint(entry) => self.planar_joint(entry),
            _ => None,
        };
        self.errors.leave(before);
        (self.silent, self.in_home_pose) = (silent, in_home_pose);
        self.states[index] = State::Done(value);
    }

    /// The points that have a name of their own.
    pub(super) fn declared_points(&self) -> impl Iterator<Item = Point> {
        let entries = self.declaration.entries.iter().zip(&self.states);
        entries.filter_map(|(entry, state)| match state {
            State::Done(Some(Value::Point(point))) => Some(Point {
                label: entry.name.to_string(),
                ..point.clone()
            }),
            _ => None,
        })
    }

    fn parameter(&mut self, entry: &Entry) -> Option<Value> {
        let mut arguments = Arguments::new(self, entry);
        if !arguments.has("value") && arguments.are_misplaced() {
            return None;
        }
        let constant = arguments.constant()?;
        let field = if constant.is_some() {
            "nominal"
        } else {
            "value"
        };
        let (default, dimension) = arguments.number(field)?;
        let symbol = Symbol::Parameter(self.parameters.len() as u32);
        self.graph.set_name(symbol, entry.name.to_string());
        self.parameters.push(Quantity {
            constant,
            ..quantity(entry, default, dimension)
        });
        Some(Value::Scalar(self.graph.symbol(symbol), dimension))
    }

    fn input(&mut self, entry: &Entry) -> Option<Value> {
        let mut arguments = Arguments::new(self, entry);
        if !arguments.has("value") && arguments.are_misplaced() {
            return None;
        }
        let (default, dimension) = arguments.number("value")?;
        let symbol = Symbol::Input(self.inputs.len() as u32);
        self.graph.set_name(symbol, entry.name.to_string());
        self.inputs.push(quantity(entry, default, dimension));
        Some(Value::Scalar(self.graph.symbol(symbol), dimension))
    }

    fn ground_point(&mut self, entry: &Entry) -> Option<Value> {
        let position = Arguments::new(self, entry).vector("position")?;
        let label = entry.name.to_string();
        Some(Value::Point(Point {
            position,
            owner: Owner::Ground,
            local: position,
            free: None,
            label,
        }))
    }

    /// A user's law.
    pub(super) fn law(&mut self, path: &syn::Expr, arguments: usize) -> Option<u32> {
        if !matches!(path, syn::Expr::Path(_)) {
            return self.fail(
                Place::of(path),
                "expected the path of a function `fn([f64; K]) -> (f64, [f64; K])`",
            );
        }
        if let Some(table) = self.table_named(path) {
            return self.fail(
                Place::of(path),
                format!("`{table}` is a table and no law: write `{table}(…)`"),
            );
        }
        let same = |law: &Law| law.arguments == arguments && tokens(&law.path) == tokens(path);
        if let Some(known) = self.laws.iter().position(same) {
            return Some(known as u32);
        }
        self.laws.push(Law {
            path: path.clone(),
            arguments,
        });
        Some(self.laws.len() as u32 - 1)
    }
}

fn tokens(syntax: &syn::Expr) -> String {
    quote::ToTokens::to_token_stream(syntax).to_string()
}

fn constant_hint(name: &str) -> String {
    let own = name.to_lowercase();
    format!(
        "; a constant of Rust is the default of a parameter: `{own}: Param({name}, nominal = …)`, with about its value and its unit"
    )
}
