//! All kinds of both worlds.

use super::kind::{Kind, World};

/// All kinds of entries, by what has them: both worlds, or one of them.
#[derive(Debug)]
pub struct Kinds {
    common: Vec<Kind>,
    planar: Vec<Kind>,
    spatial: Vec<Kind>,
}

impl Kinds {
    /// Of the kinds that both worlds share, those of the plane, and those of space; each from several tables.
    pub fn new([common, planar, spatial]: [Vec<Kind>; 3]) -> Kinds {
        // As on the page of the language: values, parts, joints, conditions, forces.
        let sorted = |mut kinds: Vec<Kind>| {
            kinds.sort_by_key(|kind| kind.group);
            kinds
        };
        Kinds {
            common: sorted(common),
            planar: sorted(planar),
            spatial: sorted(spatial),
        }
    }

    /// The kinds that both worlds share.
    pub fn common(&self) -> &[Kind] {
        &self.common
    }

    /// The kinds that belong to one world alone.
    pub fn own(&self, world: World) -> &[Kind] {
        match world {
            World::Planar => &self.planar,
            World::Spatial => &self.spatial,
        }
    }

    /// All kinds of a world.
    pub fn of(&self, world: World) -> impl Iterator<Item = &Kind> {
        self.common.iter().chain(self.own(world))
    }

    /// The kind of this name, in one world.
    pub fn kind(&self, world: World, name: &str) -> Option<&Kind> {
        self.of(world).find(|kind| kind.name == name)
    }

    /// The kind of this name, in any world.
    pub fn any(&self, name: &str) -> Option<&Kind> {
        World::ALL.iter().find_map(|&world| self.kind(world, name))
    }

    /// The names of all kinds, each once.
    pub fn names(&self) -> impl Iterator<Item = &'static str> + Clone {
        let known = |name: &str| self.planar.iter().any(|kind| kind.name == name);
        let new = self.spatial.iter().filter(move |kind| !known(kind.name));
        let all = self.common.iter().chain(&self.planar).chain(new);
        all.map(|kind| kind.name)
    }
}
