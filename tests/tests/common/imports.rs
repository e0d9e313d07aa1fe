//! Which file of a crate imports which, read from the sources.
//!
//! A file imports another where a path in it (in a `use` or elsewhere) leads to an item that is defined there. Names that
//! a `mod.rs` hands on by `use` count for the file that defines them; `mod` declarations and names handed on by
//! `pub use` are no imports.

use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::{fs, iter};
use syn::{Item, UseTree, Visibility};

/// Files of a crate by their paths within `src`, each with those that it imports.
pub type Imports = BTreeMap<String, BTreeSet<String>>;

/// A file as far as imports go.
struct Source {
    /// Its path within `src`.
    file: String,
    /// Names of the items that it defines.
    defines: BTreeSet<String>,
    /// Names that it takes from elsewhere, with their paths.
    names: BTreeMap<String, Vec<String>>,
    /// All paths in it, but those that it only hands on.
    paths: BTreeSet<Vec<String>>,
}

/// The sources of a crate by the paths of their modules.
struct Sources {
    modules: BTreeMap<Vec<String>, Source>,
}

/// The imports of the crate whose sources are in `src`.
pub fn imports(src: &Path) -> Imports {
    let mut files = Vec::new();
    collect(src, &mut files);
    let modules = files.iter().map(|file| {
        let relative = file.strip_prefix(src).expect("it is inside");
        let text = fs::read_to_string(file).expect("a source");
        let module = module_of(relative);
        let source = Source::read(relative.display().to_string(), &text);
        (module, source)
    });
    let sources = Sources {
        modules: modules.collect(),
    };
    let of_each = sources.modules.iter().map(|(module, source)| {
        let targets = source.paths.iter();
        let targets = targets.filter_map(|path| sources.target(module, path, 0));
        let targets = targets.filter(|target| *target != source.file);
        (source.file.clone(), targets.collect())
    });
    of_each.collect()
}

/// The circles of imports, each with the files in it, the largest first.
pub fn circles(imports: &Imports) -> Vec<Vec<String>> {
    let reach: BTreeMap<&String, BTreeSet<&String>> = imports
        .keys()
        .map(|file| {
            let mut found = BTreeSet::new();
            let mut waiting = vec![file];
            while let Some(next) = waiting.pop() {
                let targets = imports.get(next).into_iter().flatten();
                waiting.extend(targets.filter(|target| found.insert(*target)));
            }
            (file, found)
        })
        .collect();
    let circles: BTreeSet<Vec<String>> = imports
        .keys()
        .filter(|file| reach[file].contains(file))
        .map(|file| {
            let both = reach[file]
                .iter()
                .filter(|other| reach[*other].contains(file));
            both.map(|other| (*other).clone()).collect()
        })
        .collect();
    let mut circles: Vec<Vec<String>> = circles.into_iter().collect();
    circles.sort_by_key(|circle| std::cmp::Reverse(circle.len()));
    circles
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            collect(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
}

/// `model/parts/mod.rs` and `model/parts.rs` are the module `model::parts`.
fn module_of(relative: &Path) -> Vec<String> {
    let text = relative.with_extension("").display().to_string();
    let names = text.split(['/', '\\']).map(str::to_owned);
    let mut names: Vec<String> = names.collect();
    if names
        .last()
        .is_some_and(|last| last == "mod" || last == "lib")
    {
        names.pop();
    }
    names
}

impl Source {
    fn read(file: String, text: &str) -> Source {
        let mut source = Source {
            file,
            defines: BTreeSet::new(),
            names: BTreeMap::new(),
            paths: BTreeSet::new(),
        };
        for item in syn::parse_file(text).expect("it is Rust").items {
            source.item(&item);
        }
        source
    }

    fn item(&mut self, item: &Item) {
        let name = match item {
            Item::Use(item) => {
                let handed_on = !matches!(item.vis, Visibility::Inherited);
                self.tree(Vec::new(), &item.tree, handed_on);
                return;
            }
            Item::Mod(item) if item.content.is_none() => return,
            // Tests beside the code may import what they like.
            Item::Mod(_) => return,
            Item::Fn(item) => Some(&item.sig.ident),
            Item::Struct(item) => Some(&item.ident),
            Item::Enum(item) => Some(&item.ident),
            Item::Trait(item) => Some(&item.ident),
            Item::Type(item) => Some(&item.ident),
            Item::Const(item) => Some(&item.ident),
            Item::Static(item) => Some(&item.ident),
            _ => None,
        };
        self.defines.extend(name.map(ToString::to_string));
        self.tokens(item.to_token_stream());
    }

    fn tree(&mut self, mut path: Vec<String>, tree: &UseTree, handed_on: bool) {
        let mut add = |path: Vec<String>, name: String| {
            if !handed_on {
                self.paths.insert(path.clone());
            }
            self.names.insert(name, path);
        };
        match tree {
            UseTree::Path(step) => {
                path.push(step.ident.to_string());
                self.tree(path, &step.tree, handed_on);
            }
            UseTree::Name(name) if name.ident == "self" => {
                let name = path.last().cloned().unwrap_or_default();
                add(path, name);
            }
            UseTree::Name(name) => {
                path.push(name.ident.to_string());
                add(path, name.ident.to_string());
            }
            UseTree::Rename(rename) => {
                path.push(rename.ident.to_string());
                add(path, rename.rename.to_string());
            }
            UseTree::Glob(_) => add(path, String::new()),
            UseTree::Group(group) => {
                for tree in &group.items {
                    self.tree(path.clone(), tree, handed_on);
                }
            }
        }
    }

    /// The paths `a::b::c` among tokens.
    fn tokens(&mut self, tokens: TokenStream) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let is = |index: usize, punct: char| matches!(tokens.get(index), Some(TokenTree::Punct(found)) if found.as_char() == punct);
        let mut index = 0;
        while index < tokens.len() {
            match &tokens[index] {
                TokenTree::Group(group) => self.tokens(group.stream()),
                TokenTree::Ident(first) => {
                    let mut path = vec![first.to_string()];
                    while is(index + 1, ':') && is(index + 2, ':') {
                        let Some(TokenTree::Ident(next)) = tokens.get(index + 3) else {
                            break;
                        };
                        path.push(next.to_string());
                        index += 3;
                    }
                    if path.len() > 1 {
                        self.paths.insert(path);
                    }
                }
                _ => {}
            }
            index += 1;
        }
    }
}

impl Sources {
    /// The file that defines what a path in a module leads to; `None` for what is no item of this crate.
    fn target(&self, module: &[String], path: &[String], depth: usize) -> Option<String> {
        let mut module = module.to_vec();
        let mut steps = path.iter();
        let first = path.first()?;
        match first.as_str() {
            "crate" => module.clear(),
            "super" => {
                module.pop()?;
            }
            "self" => {}
            child => {
                let mut inside = module.clone();
                inside.push(child.to_owned());
                let source = self.modules.get(&module)?;
                if self.modules.contains_key(&inside) {
                    module = inside;
                } else if let Some(known) = source.names.get(child).filter(|_| path.len() > 1) {
                    // A name taken from elsewhere leads on, where it is a module.
                    let start = self.module(&module, known)?;
                    return self.walk(start, path[1..].iter(), depth);
                } else {
                    return None;
                }
            }
        }
        steps.next();
        self.walk(module, steps, depth)
    }

    fn walk<'a>(
        &self,
        mut module: Vec<String>,
        steps: impl Iterator<Item = &'a String>,
        depth: usize,
    ) -> Option<String> {
        for step in steps {
            if step == "super" {
                module.pop()?;
                continue;
            }
            let inside: Vec<String> = module.iter().chain(iter::once(step)).cloned().collect();
            if self.modules.contains_key(&inside) {
                module = inside;
                continue;
            }
            let source = self.modules.get(&module)?;
            if source.defines.contains(step) || depth > 8 {
                return Some(source.file.clone());
            }
            return match source.names.get(step) {
                Some(path) => self.target(&module, path, depth + 1),
                None => Some(source.file.clone()),
            };
        }
        Some(self.modules.get(&module)?.file.clone())
    }

    /// The module that a path leads to, if it is one.
    fn module(&self, module: &[String], path: &[String]) -> Option<Vec<String>> {
        let mut module = module.to_vec();
        for (place, step) in path.iter().enumerate() {
            match (place, step.as_str()) {
                (0, "crate") => module.clear(),
                (_, "super") => {
                    module.pop()?;
                }
                (0, "self") => {}
                _ => module.push(step.clone()),
            }
        }
        self.modules.contains_key(&module).then_some(module)
    }
}
