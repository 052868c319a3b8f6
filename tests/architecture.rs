//! The house holds: arrows between the rooms of `src` and `crates/sneddon-expr` point down, every file says what it is, and none grows too large.
//!
//! The table of rooms below is the only place that says who may know whom; `docs/architecture.md` explains it.
#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used)]

#[path = "architecture/imports.rs"]
mod imports;

use imports::{Module, cycles, imports, names};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// A room: a directory or a file directly under `src`, or under the sources of `crates/sneddon-expr`.
struct Room {
    name: &'static str,
    /// The rooms that it may name with `crate::…`; all of them stand above it in the table.
    may_use: &'static [&'static str],
}

/// Every room, from the bottom up. A room that may be used stands earlier: hence no circles.
const ROOMS: &[Room] = &[
    // The separate crate `crates/sneddon-num`, so the compiler enforces this row.
    Room { name: "num", may_use: &[] },
    // The separate crate `crates/sneddon-expr` has the next four rooms, and the façade re-exports them.
    // The function table's rows carry their values, and those are computed in num.
    Room { name: "expr", may_use: &["num"] },
    // Three rooms side by side: none of them knows another one.
    Room { name: "parse", may_use: &["expr"] },
    // num for the flag that stops work, because the layout of long formulas takes a second.
    Room { name: "print", may_use: &["num", "expr"] },
    Room { name: "eval", may_use: &["num", "expr"] },
    // Across, once: print, for the expressions that stand in error texts. Never parse: rules build expressions, they do not read text.
    Room { name: "integrate", may_use: &["num", "expr", "eval", "print"] },
    Room { name: "derive", may_use: &["num", "expr", "eval", "print", "integrate"] },
    Room { name: "evaluate", may_use: &["num", "expr", "eval", "print", "integrate", "derive"] },
    // The public names of the three.
    Room { name: "transform", may_use: &["integrate", "derive", "evaluate"] },
    // print for the texts of conditions, as in transform.
    Room { name: "contact", may_use: &["num", "expr", "eval", "print", "transform"] },
    // Beside scene: closed forms as programs in other languages, with claims that the sampled error bounds support.
    Room { name: "code", may_use: &["num", "expr", "eval", "print", "transform", "contact"] },
    // A scene file holds expressions: with cli the only room that reads text.
    Room { name: "scene", may_use: &["num", "expr", "parse", "print", "eval", "transform", "contact"] },
    // Measures what stands below it; text and formats are no concern of it.
    Room { name: "tradeoff", may_use: &["num", "expr", "transform", "contact"] },
    // A solver's data beside the exact solution of a scene; the small profiles that a periodic box adds are read as text.
    Room { name: "validate", may_use: &["num", "expr", "parse", "transform", "contact", "scene"] },
    // A report turns records into formats.
    Room { name: "report", may_use: &["num", "expr", "print", "transform", "contact", "scene", "tradeoff", "validate"] },
    // The only room with input and output.
    Room {
        name: "cli",
        may_use: &["num", "expr", "parse", "print", "eval", "transform", "contact", "code", "scene", "tradeoff", "validate", "report"],
    },
];

/// The directories of the rooms.
const SOURCES: [&str; 2] = ["src", "crates/sneddon-expr/src"];

/// Files beside the rooms: the façade, which re-exports, and the program, which calls `cli`.
const ROOTS: [&str; 2] = ["lib", "main"];

/// The only rooms that read files, arguments or the environment, or write to a stream.
const WITH_INPUT_AND_OUTPUT: [&str; 2] = ["cli", "main"];

/// The largest number of lines of a file in `src`.
const LONGEST_FILE: usize = 600;

#[test]
fn arrows_point_down() {
    let mut faults = Vec::new();
    for file in source_files() {
        let (room, depth) = place(&file);
        if ROOTS.contains(&room.as_str()) {
            continue;
        }
        let text = fs::read_to_string(&file).unwrap();
        faults.extend(bad_arrows(&room, depth, &text).into_iter().map(|fault| format!("{}: {fault}", file.display())));
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn the_table_names_every_room_and_has_no_circles() {
    let mut before: BTreeSet<&str> = BTreeSet::new();
    for room in ROOMS {
        for used in room.may_use {
            assert!(before.contains(used), "{} may use {used}, which does not stand below it", room.name);
        }
        assert!(before.insert(room.name), "{} stands twice", room.name);
    }
    let entries = SOURCES.iter().flat_map(|directory| fs::read_dir(root().join(directory)).unwrap());
    for entry in entries {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        assert!(before.contains(name.as_str()) || ROOTS.contains(&name.as_str()), "{} is not in the table of rooms", path.display());
    }
}

#[test]
fn input_and_output_stay_in_one_room() {
    let mut faults = Vec::new();
    let numbers = rust_files(&root().join("crates/sneddon-num/src"));
    for file in source_files().into_iter().filter(|file| !WITH_INPUT_AND_OUTPUT.contains(&place(file).0.as_str())).chain(numbers) {
        let code = code_only(&fs::read_to_string(&file).unwrap());
        for word in ["std::fs", "std::env", "std::process", "println!", "eprintln!", "print!(", "eprint!(", "dbg!("] {
            if code.contains(word) {
                faults.push(format!("{}: {word}", file.display()));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn every_file_says_what_it_is_and_is_not_too_long() {
    let mut faults = Vec::new();
    let tests = rust_files(&root().join("tests"));
    for file in rust_files(&root().join("src")).into_iter().chain(member_files()).chain(tests) {
        let text = fs::read_to_string(&file).unwrap();
        if !text.starts_with("//! ") {
            faults.push(format!("{} does not open with a //! line", file.display()));
        }
        let lines = text.lines().count();
        if !file.starts_with(root().join("tests")) && lines > LONGEST_FILE {
            faults.push(format!("{} has {lines} lines, at most {LONGEST_FILE} are accepted", file.display()));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// What one room may name of another below it, beyond which their borders would blur.
const NARROW: &[(&str, &str, &[&str])] = &[
    ("derive", "integrate", &["TransformError", "NumericProfile", "Segment", "Growth", "growth"]),
    (
        "evaluate",
        "derive",
        &[
            "Solution",
            "SolvedInterval",
            "Superposed",
            "Pair",
            "closed_form",
            "Profile",
            "Chain",
            "Inverse",
            "Verification",
            "Sampler",
            "Stream",
            "Barrier",
            "is_below",
            "is_approximate",
            "domain",
        ],
    ),
];

#[test]
fn borders_between_rooms_are_narrow() {
    let mut faults = Vec::new();
    for (module, code) in sources("src") {
        for (room, below, allowed) in NARROW.iter().filter(|(room, ..)| module.first().is_some_and(|first| first == room)) {
            let named = names(&module, &code).into_iter().filter(|path| path.first().is_some_and(|first| first == below));
            let foreign = named.filter(|path| !path.iter().any(|part| allowed.contains(&part.as_str())));
            faults.extend(foreign.map(|path| format!("{}: {room} may not name {}", module.join("/"), path.join("::"))));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The number of groups of files that name each other in a circle; files and their own folders do not count.
const CYCLES: [(&str, usize); 3] = [("src", 4), ("crates/sneddon-expr/src", 4), ("crates/sneddon-num/src", 0)];

#[test]
fn there_are_no_more_cycles_between_files() {
    for (directory, most) in CYCLES {
        let found = cycles(&imports(&sources(directory)));
        let list = found.iter().map(|group| group.join(", ")).collect::<Vec<_>>().join("\n");
        assert_eq!(found.len(), most, "cycles in {directory}:\n{list}");
    }
}

/// The most files at the root of a folder.
const MOST_FILES: usize = 15;
/// Folders that are lists and may grow, with their numbers.
const LONG_FOLDERS: &[(&str, usize)] = &[("src/derive/rules", 40)];

#[test]
fn folders_are_short() {
    let mut count: BTreeMap<String, usize> = BTreeMap::new();
    for file in source_files().into_iter().chain(rust_files(&root().join("crates/sneddon-num/src"))) {
        *count.entry(file.parent().unwrap().strip_prefix(root()).unwrap().display().to_string()).or_default() += 1;
    }
    let most = |folder: &str| LONG_FOLDERS.iter().find(|(own, _)| *own == folder).map_or(MOST_FILES, |(_, most)| *most);
    let faults: Vec<String> =
        count.iter().filter(|(folder, own)| **own > most(folder)).map(|(folder, own)| format!("{folder} has {own} files")).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The code of every module below a directory, without comments, strings and tests.
fn sources(directory: &str) -> BTreeMap<Module, String> {
    let base = root().join(directory);
    let module = |file: &Path| {
        let mut parts: Module =
            file.strip_prefix(&base).unwrap().with_extension("").iter().map(|part| part.to_str().unwrap().to_owned()).collect();
        if parts.last().is_some_and(|last| last == "mod") || parts == ["lib"] {
            parts.pop();
        }
        parts
    };
    let code = |file: &Path| {
        let code = code_only(&fs::read_to_string(file).unwrap());
        code.split("#[cfg(test)]").next().unwrap_or_default().to_owned()
    };
    rust_files(&base).iter().map(|file| (module(file), code(file))).collect()
}

#[test]
fn unsafe_code_is_forbidden() {
    let manifest = |directory: &str| {
        let text = fs::read_to_string(root().join(directory).join("Cargo.toml")).unwrap();
        text.lines().map(|line| line.split('#').next().unwrap().replace(' ', "")).collect::<Vec<_>>().join("\n")
    };
    let section = manifest("").split("[workspace.lints.rust]\n").nth(1).map(|rest| rest.split("\n[").next().unwrap().to_owned());
    assert!(section.is_some_and(|lints| lints.contains("unsafe_code=\"forbid\"")), "the workspace does not forbid unsafe code");
    for member in ["", "crates/sneddon-expr", "crates/sneddon-num"] {
        assert!(
            manifest(member).contains("[lints]\nworkspace=true"),
            "the manifest in \"{member}\" does not take the lints of the workspace"
        );
    }
}

// The checker itself.

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// The files of every room.
fn source_files() -> Vec<PathBuf> {
    SOURCES.iter().flat_map(|directory| rust_files(&root().join(directory))).collect()
}

/// The files of the other members in Rust.
fn member_files() -> Vec<PathBuf> {
    rust_files(&root().join("crates"))
}

fn rust_files(directory: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut pending = vec![directory.to_path_buf()];
    while let Some(next) = pending.pop() {
        for entry in fs::read_dir(&next).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                pending.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// The room of a file, and the number of modules from the crate's root down to its own.
fn place(file: &Path) -> (String, usize) {
    let below = SOURCES.iter().find_map(|directory| file.strip_prefix(root().join(directory)).ok()).unwrap();
    let parts: Vec<String> = below.with_extension("").iter().map(|part| part.to_str().unwrap().to_owned()).collect();
    let own = usize::from(parts.last().is_some_and(|last| last == "mod"));
    (parts[0].clone(), parts.len() - own)
}

/// Every path in the text that leaves the room for one that its row of the table does not name.
///
/// `depth` is the number of modules from the crate's root to this one: so many `super::` lead out of the room.
fn bad_arrows(room: &str, depth: usize, text: &str) -> Vec<String> {
    let Some(row) = ROOMS.iter().find(|row| row.name == room) else { return vec![format!("{room} is not in the table of rooms")] };
    let mut faults = Vec::new();
    for (line, target) in targets(&code_only(text), depth) {
        let known = ROOMS.iter().any(|row| row.name == target);
        if target == room || row.may_use.contains(&target.as_str()) {
            continue;
        }
        let what = if known { "an arrow that the table does not allow" } else { "a path to the façade or to no room" };
        faults.push(format!("line {line}: {room} → {target} is {what}"));
    }
    faults
}

/// First segments behind `crate::`, and behind enough `super::` to leave the room, with their lines.
fn targets(code: &str, depth: usize) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    let bytes = code.as_bytes();
    let mut at = 0;
    while at < code.len() {
        let rest = &code[at..];
        let starts_word = at == 0 || !is_word(bytes[at - 1]);
        let length = word(rest).len();
        if !starts_word || length == 0 {
            at += rest.chars().next().map_or(1, char::len_utf8);
            continue;
        }
        let line = code[..at].matches('\n').count() + 1;
        let mut behind = &rest[length..];
        match &rest[..length] {
            "crate" => {
                if let Some(path) = after_colons(behind) {
                    found.extend(first_segments(path).into_iter().map(|segment| (line, segment)));
                }
            }
            "super" if depth > 0 => {
                let mut ups = 1;
                while let Some(path) = after_colons(behind) {
                    if word(path) == "super" {
                        ups += 1;
                        behind = &path[word(path).len()..];
                    } else {
                        if ups >= depth {
                            // Within an inline module this may still be the own room: only other rooms' names count.
                            let rooms = first_segments(path).into_iter().filter(|segment| ROOMS.iter().any(|row| row.name == segment));
                            found.extend(rooms.map(|segment| (line, segment)));
                        }
                        break;
                    }
                }
                at = code.len() - behind.len();
                continue;
            }
            _ => {}
        }
        at += length;
    }
    found
}

/// What follows `::`, blanks aside.
fn after_colons(text: &str) -> Option<&str> {
    text.trim_start().strip_prefix("::").map(str::trim_start)
}

fn is_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_' || !byte.is_ascii()
}

/// The identifier that the text begins with, perhaps empty.
fn word(text: &str) -> &str {
    let end = text.bytes().position(|byte| !is_word(byte)).unwrap_or(text.len());
    &text[..end]
}

/// The first segments of a path or of a group of paths: `{a, b::{c, d}}` gives a and b.
fn first_segments(path: &str) -> Vec<String> {
    let Some(group) = path.strip_prefix('{') else { return vec![word(path).to_owned()] };
    let (mut level, mut fresh, mut segments) = (0, true, Vec::new());
    let mut at = 0;
    while at < group.len() {
        let rest = &group[at..];
        let own = word(rest);
        if !own.is_empty() {
            if level == 0 && fresh {
                segments.push(own.to_owned());
            }
            fresh = false;
            at += own.len();
            continue;
        }
        let character = rest.chars().next().unwrap_or(' ');
        match character {
            '{' => level += 1,
            '}' if level == 0 => break,
            '}' => level -= 1,
            ',' if level == 0 => fresh = true,
            _ => {}
        }
        at += character.len_utf8();
    }
    segments
}

/// The text with comments, strings and characters blanked out; lines stay where they are.
fn code_only(text: &str) -> String {
    let mut code = String::with_capacity(text.len());
    let mut rest = text;
    let mut before = ' ';
    while let Some(first) = rest.chars().next() {
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            block_comment(rest)
        } else if first == '"' {
            quoted(rest, 1)
        } else if let Some(length) = raw_string(rest).filter(|_| !(before.is_alphanumeric() || before == '_')) {
            length
        } else if first == '\'' {
            character(rest).unwrap_or(0)
        } else {
            0
        };
        if length == 0 {
            code.push(first);
            before = first;
            rest = &rest[first.len_utf8()..];
        } else {
            code.extend(rest[..length].chars().map(|own| if own == '\n' { '\n' } else { ' ' }));
            before = ' ';
            rest = &rest[length..];
        }
    }
    code
}

fn block_comment(text: &str) -> usize {
    let (mut level, mut at) = (0, 0);
    while at < text.len() {
        if text[at..].starts_with("/*") {
            level += 1;
            at += 2;
        } else if text[at..].starts_with("*/") {
            level -= 1;
            at += 2;
            if level == 0 {
                return at;
            }
        } else {
            at += text[at..].chars().next().map_or(1, char::len_utf8);
        }
    }
    text.len()
}

/// The length of a string with escapes whose first byte after the opening quote is at `at`.
fn quoted(text: &str, mut at: usize) -> usize {
    while let Some(own) = text[at..].chars().next() {
        at += own.len_utf8();
        match own {
            '"' => return at,
            '\\' => at += text[at..].chars().next().map_or(0, char::len_utf8),
            _ => {}
        }
    }
    text.len()
}

/// The length of `r"…"`, `r#"…"#` and their byte kin.
fn raw_string(text: &str) -> Option<usize> {
    let behind = text.strip_prefix("br").or_else(|| text.strip_prefix('r'))?;
    let hashes = behind.bytes().take_while(|byte| *byte == b'#').count();
    let inner = behind[hashes..].strip_prefix('"')?;
    let end = format!("\"{}", "#".repeat(hashes));
    let start = text.len() - inner.len();
    Some(inner.find(&end).map_or(text.len(), |at| start + at + end.len()))
}

/// The length of a character literal; `None` for a lifetime.
fn character(text: &str) -> Option<usize> {
    let inner = text.strip_prefix('\'')?;
    if let Some(escape) = inner.strip_prefix('\\') {
        let skipped = escape.chars().next()?.len_utf8();
        return escape[skipped..].find('\'').map(|at| 2 + skipped + at + 1);
    }
    let own = inner.chars().next()?.len_utf8();
    inner[own..].starts_with('\'').then_some(own + 2)
}

// The checker fails where it must.

#[test]
fn a_planted_arrow_is_found() {
    for (room, depth, text, target) in [
        ("num", 1, "use crate::expr::Expr;", "expr"),
        ("expr", 2, "fn f() { crate::eval::walk() }", "eval"),
        ("parse", 2, "use crate::print;", "print"),
        ("print", 1, "use crate::{expr::{Expr, Formula}, parse};", "parse"),
        ("eval", 1, "use crate::{\n    expr::Expr, // {comment}\n    transform::{self, Term},\n};", "transform"),
        ("transform", 3, "pub(super) use crate :: contact::Contact;", "contact"),
        ("transform", 3, "let e = crate::parse::profile(\"r\");", "parse"),
        ("contact", 2, "use super::super::cli::run;", "cli"),
        ("print", 1, "use super::parse::formula;", "parse"),
        ("report", 1, "use crate::derive;", "derive"),
        ("report", 1, "let a = 'c'; use crate::cli;", "cli"),
        ("report", 1, "fn f<'a>(s: &'a str) -> crate::cli::Failure {}", "cli"),
    ] {
        let faults = bad_arrows(room, depth, text);
        assert_eq!(faults.len(), 1, "{text}: {faults:?}");
        assert!(faults[0].contains(&format!("{room} → {target} ")), "{text}: {faults:?}");
    }
    let two = bad_arrows("num", 1, "use crate::{expr, num::Bounded, eval::{self}};");
    assert_eq!(two.len(), 2, "{two:?}");
    assert!(bad_arrows("num", 1, "\n\nuse crate::expr;")[0].starts_with("line 3:"));
    assert!(!bad_arrows("attic", 1, "").is_empty());
}

#[test]
fn allowed_arrows_and_mere_words_pass() {
    for (room, depth, text) in [
        ("expr", 2, "use crate::num::kappa; use crate::expr::Expr; use super::super::error::ExprError;"),
        ("expr", 2, "use crate::{expr::{normal, Sign}, num::{forms, special::{rf, rd}}};"),
        ("num", 2, "// use crate::expr::Expr;\n/* crate::eval /* crate::cli */ crate::cli */"),
        ("num", 2, "//! [`crate::cli`]\nlet s = \"use crate::expr\"; let r = r#\"crate::\"eval\"#; let c = '\"'; let q = '\\'';"),
        ("num", 2, "let a_crate = 1; mycrate::expr::f(); macro_super::expr();"),
        ("contact", 2, "use super::report::Edge;"),
        ("parse", 3, "pub(in crate::parse) enum Names {} use super::super::{ParseError, Reason};"),
        ("cli", 2, "use crate::{parse, print, eval, transform, contact, report::Record};"),
    ] {
        let faults = bad_arrows(room, depth, text);
        assert!(faults.is_empty(), "{text}: {faults:?}");
    }
}
