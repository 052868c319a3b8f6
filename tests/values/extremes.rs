//! Every rule in the corners of its domain: within 16·max(1, condition number) ulp, within its own estimate, or refused with a reason.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use sneddon::transform::rules::RULES;
use sneddon_checks::seeds::cases;
use sneddon_checks::stability::page::{page, skeleton};
use sneddon_checks::stability::{Cell, Outcome, cells};
use std::collections::BTreeSet;
use std::sync::OnceLock;

const REFERENCES: &str = include_str!("../oracle/extremes.csv");

const REFRESH: &str = "run `cargo run --release -p sneddon-runs --bin stability > docs/stability.md`";

/// Refusals of numbers that a double could hold; fewer is better.
const REFUSED: usize = 174;

/// The cells of both tests, evaluated once.
fn found() -> &'static [Cell] {
    // One corner in fourteen of each rule is enough to notice a change; all of them take 13 s of processor time.
    static FOUND: OnceLock<Vec<Cell>> = OnceLock::new();
    FOUND.get_or_init(|| cells(REFERENCES, cases(14, 1)))
}

#[test]
fn corners_keep_their_digits() {
    let found = found();
    let faults: Vec<String> = found.iter().filter_map(|cell| cell.fault()).collect();
    let refused: Vec<String> =
        found.iter().filter(|cell| matches!(cell.outcome, Outcome::Refused(_))).map(|cell| format!("{cell:?}")).collect();
    let seen: BTreeSet<&str> = found.iter().map(|cell| cell.rule.as_str()).collect();
    let without: Vec<&str> = RULES.iter().map(|rule| rule.id).filter(|id| !seen.contains(id)).collect();
    assert!(without.is_empty(), "run `just rule ID` for {}", without.join(", "));
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
    assert!(refused.len() <= cases(7, REFUSED), "{} refusals:\n{}", refused.len(), refused.join("\n"));
}

#[test]
fn the_document_is_the_programs() {
    let written = include_str!("../../docs/stability.md").split("\n## Random scenes").next().unwrap();
    let own = page(found());
    let sections = |text: &str| -> Vec<Vec<String>> { text.split("\n### ").skip(cases(1, 0)).map(skeleton).collect() };
    let (own, written) = (sections(&own), sections(written));
    assert_eq!(own.len(), written.len(), "{REFRESH}");
    for (own, written) in own.iter().zip(&written) {
        assert!(own[0] == written[0] && own.len() >= written.len() / cases(14, 1), "{} {}: {REFRESH}", own[0], written[0]);
        for line in own {
            assert!(written.contains(line), "{} {line}: {REFRESH}", own[0]);
        }
    }
}
