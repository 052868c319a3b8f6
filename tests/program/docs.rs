//! The documents tell the truth: their shell examples run and answer as shown, their links and file names lead somewhere.
// The examples are lines of a POSIX shell.
#![cfg(all(feature = "cli", unix))]
#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used)]

use sneddon_checks::chapter::side_by_side::{compared, page, skeleton};
use sneddon_checks::seeds::sample;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Documents that must exist; every other one in `docs` is tested if it is there.
const REQUIRED: [&str; 2] = ["README.md", "docs/grammar.md"];

/// One command of a document, and what stands below it.
#[derive(Debug, PartialEq, Eq)]
struct Example {
    /// The line of the document, counted from 1.
    line: usize,
    command: String,
    /// The exit code that a comment `# exit N` behind the command announces, else 0.
    exit: i32,
    /// The lines below the command; none where only the command is shown.
    output: Vec<String>,
}

/// With `SNEDDON_WRITE` set the documents are given the answers of today instead: `just examples`.
#[test]
fn examples_run_and_answer_as_shown() {
    let mut faults = Vec::new();
    for document in documents() {
        let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("docs").join(document.file_stem().unwrap());
        copy_examples(&place);
        let text = fs::read_to_string(&document).unwrap();
        if std::env::var_os("SNEDDON_WRITE").is_some() {
            fs::write(&document, rewritten(&text, &place)).unwrap();
            continue;
        }
        for example in examples(&text) {
            if let Some(fault) = fault(&example, &place) {
                faults.push(format!("{}:{}: {}\n{fault}", document.display(), example.line, example.command));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n\n"));
}

#[test]
fn help_shows_examples_that_run() {
    let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("docs").join("help");
    fs::create_dir_all(&place).unwrap();
    let mut faults = Vec::new();
    let overview = help(&[]);
    let commands = overview.split("Commands:\n").nth(1).unwrap().lines().take_while(|line| line.starts_with("  "));
    let first_lines = commands.filter(|line| !line.starts_with("   "));
    let names = first_lines.filter_map(|line| line.split_whitespace().next()).filter(|name| *name != "help");
    for arguments in names.map(|name| vec![name]).chain([vec![]]) {
        let text = help(&arguments);
        let shown = text.split("Examples:\n").nth(1).unwrap_or("").lines().take_while(|line| line.starts_with("  "));
        let commands: Vec<String> = shown.map(|line| line.trim().to_owned()).collect();
        if commands.is_empty() {
            faults.push(format!("sneddon {} --help shows no example", arguments.join(" ")));
        }
        for command in commands {
            // What a debug build measures may be cut short by the clock.
            let command = if command.starts_with("sneddon tradeoff") { format!("{command} --budget 100") } else { command };
            let example = Example { line: 0, command, exit: 0, output: Vec::new() };
            faults.extend(fault(&example, &place).map(|fault| format!("{}\n{fault}", example.command)));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n\n"));
}

/// Copies the scenes and the data that the documents use into a directory of their examples.
fn copy_examples(place: &Path) {
    fs::create_dir_all(place.join("examples")).unwrap();
    for entry in fs::read_dir(root().join("examples")).unwrap().map(|entry| entry.unwrap().path()) {
        if entry.extension().is_some_and(|extension| ["toml", "csv"].iter().any(|own| extension == *own)) {
            fs::copy(&entry, place.join("examples").join(entry.file_name().unwrap())).unwrap();
        }
    }
}

fn help(arguments: &[&str]) -> String {
    let done = Command::new(env!("CARGO_BIN_EXE_sneddon")).args(arguments).arg("--help").output().unwrap();
    assert!(done.status.success(), "{arguments:?}");
    String::from_utf8(done.stdout).unwrap()
}

/// The Rust lines of the grammar, as they stand there.
#[test]
fn text_that_was_printed_reads_back() {
    use sneddon::{parse, print};
    let force = parse::formula("2*E*integral(r^2*exp(r)/sqrt(a^2 - r^2), r, 0, a)").unwrap();
    assert_eq!(parse::formula(&print::text(&force)).unwrap(), force);
}

/// `docs/rules.md` is what the program writes.
#[test]
fn the_catalogue_of_rules_is_fresh() {
    let done = Command::new(env!("CARGO_BIN_EXE_sneddon")).args(["rules", "--format", "markdown", "--standalone"]).output().unwrap();
    assert!(done.status.success());
    let written = fs::read_to_string(root().join("docs/rules.md")).unwrap();
    let stale = "docs/rules.md is stale: cargo run -- rules --format markdown --standalone > docs/rules.md";
    assert!(String::from_utf8(done.stdout).unwrap() == written, "{stale}");
}

/// The chapter's formulas equal the derived ones, and `docs/side-by-side.md` shows both.
#[test]
fn the_chapter_beside_the_program_is_fresh() {
    let found = compared();
    for own in &found {
        assert!(own.difference < 1e-13, "{}: the formulas differ by {:e}", own.equation.number, own.difference);
    }
    let (own, written) = (page(&found), fs::read_to_string(root().join("docs/side-by-side.md")).unwrap());
    let stale = "docs/side-by-side.md is stale: cargo run --release -p sneddon-runs --bin side_by_side > docs/side-by-side.md";
    assert!(skeleton(&own) == skeleton(&written), "{stale}");
}

/// Every profile of `docs/pressures.md` has the notes under whose headings it stands, and those under the last one have none.
#[test]
fn open_pressures_say_why_as_the_page_has_it() {
    let page = fs::read_to_string(root().join("docs/pressures.md")).unwrap();
    let (mut reason, mut rows) = (None, BTreeMap::<&str, (&str, Vec<String>)>::new());
    for line in page.lines() {
        if line.starts_with("## ") {
            reason = None;
        } else if let Some(rest) = line.strip_prefix("The integral in p(r) ") {
            reason = Some(format!("the integral in p(r) {}", rest.trim_end_matches('.')));
        } else if let Some((profile, part)) = line.strip_prefix("- `").and_then(|rest| rest.split_once('`')) {
            let status = match (&reason, part) {
                (None, _) => "exact",
                (_, " (in part)") => "partial",
                _ => "numeric",
            };
            rows.entry(profile).or_insert((status, Vec::new())).1.extend(reason.clone());
        }
    }
    let [exact, partial, numeric] = ["exact", "partial", "numeric"].map(|own| rows.values().filter(|(status, _)| *status == own).count());
    let stated = format!(
        "Of the {} profiles below, {exact} have a closed pressure, {partial} have one that is closed in part, and {numeric} have an integral alone.",
        rows.len()
    );
    assert!(page.contains(&stated), "{stated}");
    for (profile, (status, mut reasons)) in sample(rows, 0, 6) {
        let done = Command::new(env!("CARGO_BIN_EXE_sneddon")).args(["derive", profile, "--json"]).output().unwrap();
        let found: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
        assert_eq!(found["p"]["status"], status, "{profile}");
        let notes = found["notes"].as_array().unwrap().iter().filter_map(|note| note.as_str());
        let mut notes: Vec<&str> = notes.filter(|note| note.contains("the integral in p(r)")).collect();
        notes.sort_unstable();
        reasons.sort_unstable();
        assert_eq!(notes, reasons, "{profile}");
    }
}

#[test]
fn required_documents_exist() {
    for name in REQUIRED {
        assert!(root().join(name).is_file(), "{name} is missing");
    }
    let grammar = fs::read_to_string(root().join("docs/grammar.md")).unwrap();
    assert!(!examples(&grammar).is_empty(), "docs/grammar.md shows no example that runs");
}

#[test]
fn links_and_file_names_lead_somewhere() {
    let mut faults = Vec::new();
    for document in documents() {
        let text = fs::read_to_string(&document).unwrap();
        for link in links(&text) {
            if !document.parent().unwrap().join(&link).exists() {
                faults.push(format!("{}: the link to {link} leads nowhere", document.display()));
            }
        }
        for name in file_names(&text) {
            if !root().join(&name).exists() {
                faults.push(format!("{}: there is no {name}", document.display()));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn every_dependency_has_its_line() {
    let document = root().join("docs/dependencies.md");
    if !document.is_file() {
        return;
    }
    let text = fs::read_to_string(document).unwrap();
    let mut listed: Vec<&str> = text.lines().filter_map(|line| line.strip_prefix("| `")?.split('`').next()).collect();
    let members = ["", "crates/sneddon-expr", "crates/sneddon-num", "crates/sneddon-checks", "crates/sneddon-runs", "fuzz"];
    let manifests = members.map(|member| fs::read_to_string(root().join(member).join("Cargo.toml")).unwrap());
    let mut declared: Vec<&str> = manifests.iter().flat_map(|own| dependencies(own)).filter(|own| !own.starts_with("sneddon")).collect();
    for list in [&mut listed, &mut declared] {
        list.sort_unstable();
        list.dedup();
    }
    assert_eq!(listed, declared, "docs/dependencies.md on the left, the manifests on the right");
}

/// The names in the sections of dependencies of a manifest.
fn dependencies(manifest: &str) -> Vec<&str> {
    let mut inside = false;
    let mut found = Vec::new();
    for line in manifest.lines() {
        if line.starts_with('[') {
            inside = line.ends_with("dependencies]");
        } else if let (true, Some((name, _))) = (inside, line.split_once('=')) {
            found.push(name.trim().trim_end_matches(".workspace"));
        }
    }
    found
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn documents() -> Vec<PathBuf> {
    let mut found: Vec<PathBuf> = fs::read_dir(root().join("docs")).unwrap().map(|entry| entry.unwrap().path()).collect();
    found.push(root().join("README.md"));
    found.retain(|path| path.is_file() && path.extension().is_some_and(|extension| extension == "md"));
    found.sort();
    found
}

/// The document with what its examples answer below them.
fn rewritten(text: &str, place: &Path) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    for example in examples(text).iter().rev().filter(|example| !example.output.is_empty()) {
        let first = example.line - 1 + example.command.lines().count();
        let (_, answer) = run(example, place);
        lines.splice(first..first + example.output.len(), answer.trim_end().lines().map(str::to_owned));
    }
    lines.join("\n") + "\n"
}

/// Runs one example in the given directory: its exit code, and what a terminal shows.
fn run(example: &Example, place: &Path) -> (Option<i32>, String) {
    let program = Path::new(env!("CARGO_BIN_EXE_sneddon"));
    let path = format!("{}:{}", program.parent().unwrap().display(), std::env::var("PATH").unwrap_or_default());
    // Both streams go where a terminal shows them.
    let script = format!("exec 2>&1\n{}", example.command);
    let done = Command::new("sh").args(["-c", &script]).current_dir(place).env("PATH", path).env("NO_COLOR", "1").output().unwrap();
    (done.status.code(), String::from_utf8_lossy(&done.stdout).into_owned())
}

/// What differs from what is shown, if anything does.
fn fault(example: &Example, place: &Path) -> Option<String> {
    let (exit, answer) = run(example, place);
    if exit != Some(example.exit) {
        return Some(format!("exit {exit:?} instead of {}\n{answer}", example.exit));
    }
    let shown = example.output.join("\n");
    let differs = !example.output.is_empty() && shown.trim_end() != answer.trim_end();
    differs.then(|| format!("--- shown\n{shown}\n--- answered\n{answer}"))
}

/// The commands `$ sneddon …` and `$ … | sneddon …` of the blocks marked `console`.
fn examples(text: &str) -> Vec<Example> {
    let mut found: Vec<Example> = Vec::new();
    let (mut inside, mut open) = (false, false);
    let mut lines = text.lines().enumerate();
    while let Some((number, line)) = lines.next() {
        if line.trim_start().starts_with("```") {
            inside = !inside && line.trim() == "```console";
            open = false;
        } else if !inside {
            continue;
        } else if let Some(typed) = line.strip_prefix("$ ") {
            let mut command = typed.to_owned();
            while command.ends_with('\\') {
                let Some((_, more)) = lines.next() else { break };
                command.push('\n');
                command.push_str(more);
            }
            open = command.starts_with("sneddon ") || command.contains("| sneddon ");
            if open {
                let exit = command.rsplit_once("# exit ").and_then(|(_, code)| code.trim().parse().ok()).unwrap_or(0);
                found.push(Example { line: number + 1, command, exit, output: Vec::new() });
            }
        } else if let (true, Some(last)) = (open, found.last_mut()) {
            last.output.push(line.to_owned());
        }
    }
    found
}

/// The targets of relative links, without their fragments.
fn links(text: &str) -> Vec<String> {
    outside_blocks(text)
        .split("](")
        .skip(1)
        .filter_map(|rest| rest.split(')').next())
        .map(|target| target.split('#').next().unwrap_or("").to_owned())
        .filter(|target| !target.is_empty() && !target.contains("://") && !target.contains(' '))
        .collect()
}

/// Names in backticks that begin with a directory of this project.
fn file_names(text: &str) -> Vec<String> {
    let text = outside_blocks(text);
    let quoted = text.split('`').skip(1).step_by(2);
    let ours = |name: &&str| ["src/", "crates/", "tests/", "docs/", "benches/", "examples/"].iter().any(|start| name.starts_with(start));
    let plain = |name: &&str| name.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"/._-".contains(&byte));
    quoted.filter(ours).filter(plain).map(str::to_owned).collect()
}

fn outside_blocks(text: &str) -> String {
    let mut inside = false;
    let mut kept = String::new();
    for line in text.lines() {
        if line.trim_start().starts_with("```") {
            inside = !inside;
        } else if !inside {
            kept.push_str(line);
            kept.push('\n');
        }
    }
    kept
}

// The reader itself.

#[test]
fn examples_are_found_with_what_they_show() {
    let text = "# Title\n$ sneddon outside\n```console\n$ cargo build\nmuch\n$ sneddon rules | \\\n  wc -l\n6\n$ echo r | sneddon derive -\n\
                $ sneddon derive 'x'  # exit 2\nline\n\nline\n```\n```sh\n$ sneddon no\n```\n";
    let found = examples(text);
    let expected = [
        (6, "sneddon rules | \\\n  wc -l", 0, vec!["6"]),
        (9, "echo r | sneddon derive -", 0, vec![]),
        (10, "sneddon derive 'x'  # exit 2", 2, vec!["line", "", "line"]),
    ];
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (own, (line, command, exit, output)) in found.iter().zip(expected) {
        let output = output.into_iter().map(str::to_owned).collect();
        assert_eq!(*own, Example { line, command: command.to_owned(), exit, output });
    }
}

#[test]
fn a_wrong_example_is_found() {
    let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    let example = |command: &str, exit, output: &[&str]| Example {
        line: 1,
        command: command.to_owned(),
        exit,
        output: output.iter().map(|line| (*line).to_owned()).collect(),
    };
    assert_eq!(fault(&example("echo 3", 0, &["3"]), &place), None);
    assert_eq!(fault(&example("echo 3 >&2; exit 2", 2, &["3", ""]), &place), None);
    assert!(fault(&example("echo 3", 0, &["4"]), &place).is_some());
    assert!(fault(&example("exit 1", 0, &[]), &place).is_some());
}

#[test]
fn links_and_names_are_found() {
    let text =
        "[a](theory.md#x) [b](https://example.org/) [c](#here) `src/lib.rs` `src/expr/*` `cargo test`\n```\n[d](no.md) `src/no.rs`\n```\n";
    assert_eq!(links(text), ["theory.md"]);
    assert_eq!(file_names(text), ["src/lib.rs"]);
}
