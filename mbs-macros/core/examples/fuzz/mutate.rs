//! Changes of declarations, by tokens and by meaning.

use super::tree::{self, Tree};
use mbs_macros_core::dimension::UNITS;
use mbs_macros_core::model;
use mbs_macros_core::schema::World;
use proc_macro2::Delimiter;

/// Xorshift: an input is made again from its number.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64, number: u64) -> Self {
        let mixed =
            (seed ^ 0x9e37_79b9_7f4a_7c15).wrapping_add(number.wrapping_mul(0xbf58_476d_1ce4_e5b9));
        let mut random = Random(mixed | 1);
        (0..4).for_each(|_| {
            random.below(1);
        });
        random
    }

    pub fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % limit.max(1) as u64) as usize
    }

    fn of<'a, T: ?Sized>(&mut self, list: &[&'a T]) -> &'a T {
        list[self.below(list.len())]
    }
}

const STRANGERS: &[&str] = &[
    "ground",
    "t",
    "X",
    "Y",
    "Z",
    "pi",
    "world",
    "origin",
    "angle",
    "velocity",
    "rate",
    "a",
    "b",
    "x",
    "y",
    "z",
    "center",
    "point",
    "frame",
    "stroke",
    "speed",
    "angular_velocity",
    "velocity_at",
    "mass",
    "inertia",
    "length",
    "from",
    "to",
    "at",
    "axis",
    "orientation",
    "position",
    "coordinates",
    "ratio",
    "true",
    "0.0",
    "-",
    "*",
    "/",
    "+",
    "=",
    ":",
    ",",
    ".",
    "#",
    "\"text\"",
    "fn",
    "None",
    "Joint",
    "Natural",
    "Reference",
    "Auto",
    "turn",
    "diag",
    "Frame",
    "law",
    "Each",
    "0..3",
    "1..=2",
    "|i|",
    "|i, j|",
    "[i]",
    "[i - 1]",
    "if",
    "else",
];
const NUMBERS: &[&str] = &[
    "0.0",
    "0",
    "1.0",
    "-1.0",
    "1e-300",
    "1e-12",
    "1e12",
    "1e300",
    "1e308",
    "-1e308",
    "1e999",
    "0.5",
    "3.0",
    "1000000000",
    "(0.0 / 1.0)",
    "(1e308 * 10.0)",
    "(1.0 - 1.0)",
    "0.0_m",
    "1e-9_m",
    "90.0_deg",
    "1.0_kg",
    "1.0_in",
    "1.0_Hz",
];
const WRAPS: &[&str] = &[
    "sin", "cos", "tan", "sqrt", "ln", "exp", "abs", "sign", "step", "asin", "acos", "atan",
    "unit", "norm", "rate",
];

/// A changed declaration.
pub fn mutant(seeds: &[Vec<Tree>], random: &mut Random) -> Vec<Tree> {
    // The smaller of two: large ones take long.
    let mut two = [0, 1].map(|_| random.below(seeds.len()));
    two.sort_by_key(|&index| tree::count(&seeds[index]));
    let mut trees = seeds[two[0]].clone();
    let other = seeds[random.below(seeds.len())].clone();
    for _ in 0..1 + random.below(3) {
        match random.below(3) {
            0 => by_tokens(&mut trees, random),
            _ => by_meaning(&mut trees, &other, random),
        }
    }
    trees
}

fn by_tokens(trees: &mut Vec<Tree>, random: &mut Random) {
    let mut number = random.below(tree::count(trees));
    let kind = random.below(6);
    let stranger = Tree::Leaf(random.of(STRANGERS).to_owned());
    tree::at(trees, &mut number, &mut |list, place| match kind {
        0 => {
            list.remove(place);
        }
        1 => list.insert(place, list[place].clone()),
        2 if place > 0 => list.swap(place - 1, place),
        3 => list[place] = stranger.clone(),
        4 => list.insert(place, stranger.clone()),
        _ => list[place] = Tree::Group(Delimiter::Parenthesis, vec![list[place].clone()]),
    });
}

fn by_meaning(trees: &mut Vec<Tree>, other: &[Tree], random: &mut Random) {
    match random.below(12) {
        // Entries.
        0 => with_entries(trees, |entries| {
            let from = random.below(entries.len());
            let copy = entries[from].clone();
            entries.insert(random.below(entries.len()), copy);
        }),
        1 => with_entries(trees, |entries| {
            entries.remove(random.below(entries.len()));
        }),
        2 => with_entries(trees, |entries| {
            let (a, b) = (random.below(entries.len()), random.below(entries.len()));
            entries.swap(a, b);
        }),
        3 => {
            let mut strangers = other.to_vec();
            let mut found = Vec::new();
            with_entries(&mut strangers, |entries| {
                found = entries[random.below(entries.len())].clone();
            });
            with_entries(trees, |entries| entries.push(found.clone()));
        }
        // Names and kinds.
        4 => {
            let names = names(trees);
            if !names.is_empty() {
                let name = names[random.below(names.len())].clone();
                let uses = tree::places(
                    trees,
                    &|tree| matches!(tree, Tree::Leaf(leaf) if names.contains(leaf)),
                );
                replace(trees, &uses, name, random);
            }
        }
        5 => {
            let world = World::ALL[random.below(2)];
            let kinds: Vec<&str> = model::kinds()
                .own(world)
                .iter()
                .chain(model::kinds().common())
                .map(|kind| kind.name)
                .collect();
            let uses = tree::places(
                trees,
                &|tree| matches!(tree, Tree::Leaf(leaf) if kinds.contains(&leaf.as_str())),
            );
            let kind = random.of(&kinds).to_owned();
            replace(trees, &uses, kind, random);
        }
        6 => {
            let words = ["Planar", "Spatial"];
            let uses = tree::places(
                trees,
                &|tree| matches!(tree, Tree::Leaf(leaf) if words.contains(&leaf.as_str())),
            );
            let world = random.of(&["Planar", "Spatial"]).to_owned();
            replace(trees, &uses[..uses.len().min(1)], world, random);
        }
        // Arguments.
        7 => with_arguments(trees, random, |arguments, random| {
            arguments.remove(random.below(arguments.len()));
        }),
        8 => with_arguments(trees, random, |arguments, random| {
            let (a, b) = (random.below(arguments.len()), random.below(arguments.len()));
            arguments.swap(a, b);
        }),
        9 => with_arguments(trees, random, |arguments, random| {
            let last = random.below(arguments.len());
            let argument = &mut arguments[last];
            let is_named = argument.len() > 2 && argument[1] == Tree::Leaf("=".to_owned());
            let value = argument.split_off(if is_named { 2 } else { 0 });
            let wrapped = match random.below(4) {
                0 => tree::parse("law(f,)"),
                1 => tree::parse("-()"),
                2 => tree::parse("[]"),
                _ => tree::parse(&format!("{}()", random.of(WRAPS))),
            };
            let mut wrapped = wrapped.unwrap_or_default();
            if let Some(Tree::Group(_, inside)) = wrapped.last_mut() {
                inside.extend(value);
            }
            argument.extend(wrapped);
        }),
        // Numbers and units.
        10 => {
            let uses = tree::places(trees, &is_number);
            let number = random.of(NUMBERS).to_owned();
            replace(trees, &uses, number, random);
        }
        _ => {
            let uses = tree::places(trees, &is_number);
            let (unit, _, _) = UNITS[random.below(UNITS.len())];
            let digits = random.of(&["1.0", "0.3", "2.5"]);
            replace(trees, &uses, format!("{digits}_{unit}"), random);
        }
    }
}

fn is_number(tree: &Tree) -> bool {
    matches!(tree, Tree::Leaf(leaf) if leaf.starts_with(|c: char| c.is_ascii_digit()))
}

fn replace(trees: &mut Vec<Tree>, places: &[usize], text: String, random: &mut Random) {
    if places.is_empty() {
        return;
    }
    let mut number = places[random.below(places.len())];
    let with = tree::parse(&text).unwrap_or_default();
    tree::at(trees, &mut number, &mut |list, place| {
        list.splice(place..=place, with.clone());
    });
}

fn with_entries(trees: &mut [Tree], change: impl FnOnce(&mut Vec<Vec<Tree>>)) {
    if let Some(Tree::Group(_, inside)) = trees.last_mut() {
        let mut entries = tree::split(inside);
        if !entries.is_empty() {
            change(&mut entries);
            *inside = tree::join(&entries);
        }
    }
}

fn with_arguments(
    trees: &mut Vec<Tree>,
    random: &mut Random,
    change: impl FnOnce(&mut Vec<Vec<Tree>>, &mut Random),
) {
    let groups = tree::places(trees, &|tree| match tree {
        Tree::Group(Delimiter::Parenthesis | Delimiter::Bracket, inside) => !inside.is_empty(),
        _ => false,
    });
    if groups.is_empty() {
        return;
    }
    let mut number = groups[random.below(groups.len())];
    let mut change = Some(change);
    tree::at(trees, &mut number, &mut |list, place| {
        if let (Tree::Group(_, inside), Some(change)) = (&mut list[place], change.take()) {
            let mut arguments = tree::split(inside);
            if !arguments.is_empty() {
                change(&mut arguments, random);
                *inside = tree::join(&arguments);
            }
        }
    });
}

/// The names of the entries.
fn names(trees: &mut [Tree]) -> Vec<String> {
    let mut names = Vec::new();
    with_entries(trees, |entries| {
        for entry in entries {
            if let [Tree::Leaf(name), Tree::Leaf(colon), ..] = entry.as_slice()
                && colon == ":"
                && name != "world"
            {
                names.push(name.clone());
            }
        }
    });
    names
}
