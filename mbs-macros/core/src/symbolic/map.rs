//! Maps with small keys (indices, symbols, nodes).
//!
//! Procedural macros run unoptimised in users' builds, where the maps of the standard library take a third of the time
//! of a derivation, with any hasher: their groups of slots are calls of calls. Here a map is a list of entries with an
//! [`Index`], and the entries come in the order in which they were put in, so that every run is the same.

use super::index::Index;
use super::mixing::hash;
use std::borrow::Borrow;
use std::hash::Hash;

/// So few entries are found without an index.
const FEW: usize = 8;

/// Values by keys, which are never removed.
#[derive(Debug, Clone)]
pub(crate) struct Map<K, V> {
    entries: Vec<(K, V)>,
    /// Empty while there are few entries.
    index: Index,
}

impl<K, V> Default for Map<K, V> {
    fn default() -> Self {
        Map {
            entries: Vec::new(),
            index: Index::default(),
        }
    }
}

impl<K: Hash + Eq, V> Map<K, V> {
    /// Where the entry of a key is.
    fn find<Q: Hash + Eq + ?Sized>(&self, key: &Q) -> Option<usize>
    where
        K: Borrow<Q>,
    {
        let entries = self.entries.as_slice();
        if entries.len() <= FEW {
            let mut at = 0;
            while at < entries.len() {
                if entries[at].0.borrow() == key {
                    return Some(at);
                }
                at += 1;
            }
            return None;
        }
        let is_it = |at: u32| entries[at as usize].0.borrow() == key;
        let found = self.index.find(short(key), is_it);
        found.map(|at| at as usize)
    }

    /// Adds the entry of a key that is not there.
    fn push(&mut self, key: K, value: V) -> usize {
        let at = self.entries.len();
        if at == FEW {
            for (at, (key, _)) in self.entries.iter().enumerate() {
                self.index.insert(at as u32, short(key));
            }
        }
        if at >= FEW {
            self.index.insert(at as u32, short(&key));
        }
        self.entries.push((key, value));
        at
    }

    pub(crate) fn get<Q: Hash + Eq + ?Sized>(&self, key: &Q) -> Option<&V>
    where
        K: Borrow<Q>,
    {
        let at = self.find(key)?;
        Some(&self.entries[at].1)
    }

    pub(crate) fn contains_key<Q: Hash + Eq + ?Sized>(&self, key: &Q) -> bool
    where
        K: Borrow<Q>,
    {
        self.find(key).is_some()
    }

    /// Puts a value in place of the one before.
    pub(crate) fn insert(&mut self, key: K, value: V) {
        match self.find(&key) {
            Some(at) => self.entries[at].1 = value,
            None => {
                self.push(key, value);
            }
        }
    }

    pub(crate) fn get_mut(&mut self, key: &K) -> Option<&mut V> {
        let at = self.find(key)?;
        Some(&mut self.entries[at].1)
    }

    /// The value of a key, to be put there if there is none.
    pub(crate) fn entry(&mut self, key: K) -> Entry<'_, K, V> {
        Entry { map: self, key }
    }

    pub(crate) fn keys(&self) -> impl Iterator<Item = &K> {
        self.entries.iter().map(|(key, _)| key)
    }

    pub(crate) fn values(&self) -> impl Iterator<Item = &V> {
        self.entries.iter().map(|(_, value)| value)
    }

    pub(crate) fn len(&self) -> usize {
        self.entries.len()
    }
}

/// A key in a map, with or without a value.
pub(crate) struct Entry<'m, K, V> {
    map: &'m mut Map<K, V>,
    key: K,
}

impl<'m, K: Hash + Eq, V> Entry<'m, K, V> {
    pub(crate) fn or_insert_with(self, make: impl FnOnce() -> V) -> &'m mut V {
        let at = match self.map.find(&self.key) {
            Some(at) => at,
            None => self.map.push(self.key, make()),
        };
        &mut self.map.entries[at].1
    }

    pub(crate) fn or_insert(self, value: V) -> &'m mut V {
        self.or_insert_with(|| value)
    }

    pub(crate) fn or_default(self) -> &'m mut V
    where
        V: Default,
    {
        self.or_insert_with(V::default)
    }
}

impl<K: Hash + Eq, V> std::ops::Index<&K> for Map<K, V> {
    type Output = V;

    fn index(&self, key: &K) -> &V {
        self.get(key).expect("the map has the key")
    }
}

impl<K, V> IntoIterator for Map<K, V> {
    type Item = (K, V);
    type IntoIter = std::vec::IntoIter<(K, V)>;

    fn into_iter(self) -> Self::IntoIter {
        self.entries.into_iter()
    }
}

impl<K: Hash + Eq, V> FromIterator<(K, V)> for Map<K, V> {
    fn from_iter<I: IntoIterator<Item = (K, V)>>(entries: I) -> Self {
        let mut map = Map::default();
        for (key, value) in entries {
            map.insert(key, value);
        }
        map
    }
}

/// Keys alone.
#[derive(Debug, Clone)]
pub(crate) struct Set<K>(Map<K, ()>);

impl<K> Default for Set<K> {
    fn default() -> Self {
        Set(Map::default())
    }
}

impl<K: Hash + Eq> Set<K> {
    pub(crate) fn contains<Q: Hash + Eq + ?Sized>(&self, key: &Q) -> bool
    where
        K: Borrow<Q>,
    {
        self.0.contains_key(key)
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = &K> {
        self.0.keys()
    }

    /// Whether the key is new.
    pub(crate) fn insert(&mut self, key: K) -> bool {
        let is_new = !self.contains(&key);
        if is_new {
            self.0.push(key, ());
        }
        is_new
    }
}

/// The hash of one key, for an index.
fn short<Q: Hash + ?Sized>(key: &Q) -> u32 {
    hash(key) as u32
}
