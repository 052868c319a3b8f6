//! Who imports whom, file by file: paths resolved through re-exports, and the cycles between files.

use std::collections::{BTreeMap, BTreeSet};

/// A module as its names from the crate's root down.
pub(crate) type Module = Vec<String>;

/// The modules that each module names, without its own parents and children; `sources` has the code of every module without comments.
pub(crate) fn imports(sources: &BTreeMap<Module, String>) -> BTreeMap<Module, BTreeSet<Module>> {
    let leaves: BTreeMap<&Module, Vec<Leaf>> = sources.iter().map(|(module, code)| (module, leaves(code))).collect();
    let crates = Crate { sources, leaves: &leaves };
    let related = |a: &Module, b: &Module| a.starts_with(b) || b.starts_with(a);
    sources
        .keys()
        .map(|module| {
            let named = leaves[module].iter().filter_map(|leaf| crates.resolve(crates.absolute(module, &leaf.path)?, 0));
            (module.clone(), named.filter(|other| !related(module, other)).collect())
        })
        .collect()
}

/// Returns every path that a module names, from the root of the crate.
pub(crate) fn names(module: &Module, code: &str) -> Vec<Module> {
    leaves(code).into_iter().filter_map(|leaf| absolute(module, &leaf.path, |_| false)).collect()
}

/// The groups of modules of which each names every other one, directly or not.
pub(crate) fn cycles(graph: &BTreeMap<Module, BTreeSet<Module>>) -> Vec<Vec<String>> {
    let reach = |from: &Module| {
        let (mut seen, mut pending) = (BTreeSet::new(), vec![from.clone()]);
        while let Some(next) = pending.pop() {
            for other in graph.get(&next).into_iter().flatten() {
                if seen.insert(other.clone()) {
                    pending.push(other.clone());
                }
            }
        }
        seen
    };
    let reached: BTreeMap<&Module, BTreeSet<Module>> = graph.keys().map(|module| (module, reach(module))).collect();
    let mut found: BTreeSet<Vec<String>> = BTreeSet::new();
    for (module, others) in &reached {
        if others.contains(*module) {
            let group = others.iter().filter(|other| reached.get(other).is_some_and(|back| back.contains(*module)));
            found.insert(group.map(|own| own.join("/")).collect());
        }
    }
    found.into_iter().collect()
}

/// A path that is imported, and the name under which it is exported again.
struct Leaf {
    path: Module,
    exported: Option<String>,
}

struct Crate<'a> {
    sources: &'a BTreeMap<Module, String>,
    leaves: &'a BTreeMap<&'a Module, Vec<Leaf>>,
}

impl Crate<'_> {
    fn absolute(&self, module: &Module, path: &Module) -> Option<Module> {
        absolute(module, path, |child| self.sources.contains_key(child))
    }

    /// The module in whose file the last name of a path is defined.
    fn resolve(&self, path: Module, depth: u32) -> Option<Module> {
        const DEEPEST: u32 = 20;
        let end = (0..=path.len()).rev().find(|end| self.sources.contains_key(&path[..*end]))?;
        let module = path[..end].to_vec();
        let again = path.get(end).and_then(|name| self.leaves[&module].iter().find(|leaf| leaf.exported.as_ref() == Some(name)));
        match again.and_then(|leaf| self.absolute(&module, &leaf.path)) {
            Some(first) if depth < DEEPEST => self.resolve([first.as_slice(), &path[end + 1..]].concat(), depth + 1),
            _ => Some(module).filter(|module| !module.is_empty()),
        }
    }
}

/// Returns a path from the crate's root, or `None` for a path into another crate.
fn absolute(module: &Module, path: &Module, is_module: impl Fn(&Module) -> bool) -> Option<Module> {
    let ups = path.iter().take_while(|part| *part == "super").count();
    match path.first()?.as_str() {
        "crate" => Some(path[1..].to_vec()),
        "self" => Some([module.as_slice(), &path[1..]].concat()),
        "super" if ups <= module.len() => Some([&module[..module.len() - ups], &path[ups..]].concat()),
        first => is_module(&[module.as_slice(), &[first.to_owned()]].concat()).then(|| [module.as_slice(), path].concat()),
    }
}

/// The paths behind `use`, and those with `crate::` or `super::` elsewhere.
fn leaves(code: &str) -> Vec<Leaf> {
    let mut found = Vec::new();
    for statement in code.split(';') {
        let Some((before, group)) = split_use(statement) else {
            found.extend(inline(statement).into_iter().map(|path| Leaf { path, exported: None }));
            continue;
        };
        found.extend(inline(before).into_iter().map(|path| Leaf { path, exported: None }));
        let public = before.trim_end().rsplit(['\n', '}']).next().is_some_and(|line| line.trim_start().starts_with("pub"));
        for (path, name) in expanded(group) {
            found.push(Leaf { path, exported: public.then_some(name) });
        }
    }
    found
}

/// What stands before the word `use`, and behind it.
fn split_use(statement: &str) -> Option<(&str, &str)> {
    let word = |at: usize| {
        let before = statement[..at].chars().next_back();
        before.is_none_or(|own| !(own.is_alphanumeric() || own == '_')).then(|| (&statement[..at], &statement[at + 4..]))
    };
    statement.match_indices("use ").find_map(|(at, _)| word(at))
}

/// Every path of a group such as `a::{b, c::{d as e}}`, with the name that it has here.
fn expanded(group: &str) -> Vec<(Module, String)> {
    let group = group.trim();
    let parts = |text: &str| text.split("::").map(|part| part.trim().to_owned()).filter(|part| !part.is_empty()).collect::<Module>();
    if let Some((front, rest)) = group.split_once('{') {
        let inner = rest.strip_suffix('}').unwrap_or(rest);
        let (mut level, mut begin, mut items) = (0, 0, Vec::new());
        for (at, own) in inner.char_indices() {
            match own {
                '{' => level += 1,
                '}' => level -= 1,
                ',' if level == 0 => {
                    items.push(&inner[begin..at]);
                    begin = at + 1;
                }
                _ => {}
            }
        }
        items.push(&inner[begin..]);
        let front = parts(front);
        let items = items.into_iter().filter(|item| !item.trim().is_empty());
        return items.flat_map(expanded).map(|(path, name)| ([front.as_slice(), &path].concat(), name)).collect();
    }
    let (path, renamed) = group.split_once(" as ").map_or((group, None), |(path, name)| (path, Some(name.trim().to_owned())));
    let mut path = parts(path);
    if path.len() > 1 && path.last().is_some_and(|last| last == "self") {
        path.pop();
    }
    let name = renamed.or_else(|| path.last().cloned()).unwrap_or_default();
    vec![(path, name)]
}

/// Paths with `crate::` or `super::` in code that imports nothing.
fn inline(code: &str) -> Vec<Module> {
    let is_part = |own: char| own.is_alphanumeric() || own == '_' || own == ':';
    let words = code.split(|own: char| !is_part(own));
    let paths = words.filter(|word| word.starts_with("crate::") || word.starts_with("super::"));
    paths.map(|path| path.split("::").filter(|part| !part.is_empty()).map(str::to_owned).collect()).collect()
}
