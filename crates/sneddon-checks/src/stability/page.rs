//! Generates `docs/stability.md`: the results at the limits of the domain of every rule.

use crate::stability::{Cell, LARGEST, Outcome};
use sneddon::transform::rules::RULES;
use std::collections::BTreeMap;
use std::fmt::Write;

const QUANTITIES: [&str; 8] = ["g", "F", "G", "p", "u", "U", "a(d)", "F(d)"];

/// The whole document.
pub fn page(cells: &[Cell]) -> String {
    let mut text = String::from("# Stability\n\n");
    text.push_str(
        "This document is written by `cargo run --release -p sneddon-runs --bin stability`; a test checks that it is up to date.\n\n",
    );
    text.push_str("Every rule is tested at the limits of its domain: radii from 1e-300 of its length up to one step below its limit, breakpoints that vanish or meet, exponents from 1e-300 to 10 000, wave numbers from tiny to large, lengths of 1e-200 and 1e200.\n");
    text.push_str("The references are the rules' stated formulas at sufficiently many digits (`tests/oracle/extremes.py`, which derives the limits from the data of the rules); g, F and G at radius x or a, p and u at (r, a), U the strain energy.\n");
    text.push_str("Named shapes are pressed to depths down to 1e-300 of their length, with vanishing flat ends and angles: a(d) and F(d), for which a state has no estimate.\n\n");
    text.push_str("The condition number κ is the sum of |v ∂ ln|value|/∂v| over all arguments v: the change of the true value in ulps when every argument changes by one ulp.\n");
    let faults: Vec<String> = cells.iter().filter_map(Cell::fault).collect();
    let except = if faults.is_empty() { String::new() } else { format!(", but for the {} listed below the table", faults.len()) };
    let _ = writeln!(text, "The error of every number is at most {LARGEST}·max(1, κ) ulp, and at most its estimate{except}.\n");
    summary(cells, &mut text);
    if !faults.is_empty() {
        text.push_str("\nBeyond the limit:\n\n");
        for fault in faults {
            let _ = writeln!(text, "- {fault}");
        }
    }
    let without: Vec<&str> = RULES.iter().map(|rule| rule.id).filter(|id| !cells.iter().any(|cell| cell.rule == *id)).collect();
    if !without.is_empty() {
        let _ = writeln!(text, "\nReferences are still missing for {} of {} rules: {}.", without.len(), RULES.len(), without.join(", "));
    }
    text.push_str("\n## Every cell\n\n");
    text.push_str("An entry is error ≤ estimate, both in ulps of the true value, and κ if it exceeds 16.\n");
    text.push_str("*overflow*: the true value exceeds the largest double, and an error is returned; *refused*: a typed error, or a bound without a reliable digit; —: no reference.\n");
    let mut rules: Vec<&str> = cells.iter().map(|cell| cell.rule.as_str()).collect();
    rules.dedup();
    for rule in rules {
        let own: Vec<&Cell> = cells.iter().filter(|cell| cell.rule == rule).collect();
        table(rule, &own, &mut text);
    }
    text
}

/// The figures of one rule and quantity, or of one quantity.
#[derive(Default)]
struct Figures<'a> {
    numbers: usize,
    overflows: usize,
    refused: usize,
    honesty: f64,
    worst: Option<(&'a Cell, f64)>,
}

impl<'a> Figures<'a> {
    fn add(&mut self, cell: &'a Cell) {
        match &cell.outcome {
            Outcome::Number { ulps, honesty, .. } => {
                self.numbers += 1;
                self.honesty = self.honesty.max(*honesty);
                let relative = ulps / cell.condition;
                if self.worst.is_none_or(|(_, worst)| relative > worst) {
                    self.worst = Some((cell, relative));
                }
            }
            Outcome::Overflow => self.overflows += 1,
            Outcome::Refused(_) | Outcome::Wrong(_) => self.refused += 1,
        }
    }
}

fn summary(cells: &[Cell], text: &mut String) {
    let mut all: BTreeMap<usize, Figures<'_>> = BTreeMap::new();
    for cell in cells {
        let place = QUANTITIES.iter().position(|own| *own == cell.quantity).unwrap();
        all.entry(place).or_default().add(cell);
    }
    text.push_str("| quantity | cells | numbers | overflow | refused | largest error, ulp/max(1, κ) | there | largest error over estimate |\n|---|---|---|---|---|---|---|---|\n");
    for (place, own) in all {
        let (cell, relative) = own.worst.unwrap();
        let cells = own.numbers + own.overflows + own.refused;
        let _ = writeln!(
            text,
            "| {} | {cells} | {} | {} | {} | {relative:.2} | {}, {} | {:.2} |",
            QUANTITIES[place], own.numbers, own.overflows, own.refused, cell.rule, cell.corner, own.honesty
        );
    }
}

fn table(rule: &str, cells: &[&Cell], text: &mut String) {
    let quantities: Vec<&str> = QUANTITIES.into_iter().filter(|own| cells.iter().any(|cell| cell.quantity == *own)).collect();
    let _ = writeln!(text, "\n### {rule}\n\n| corner | {} |\n|---{}|", quantities.join(" | "), "|---".repeat(quantities.len()));
    let mut corners: Vec<&str> = Vec::new();
    for cell in cells {
        if !corners.contains(&cell.corner.as_str()) {
            corners.push(&cell.corner);
        }
    }
    for corner in corners {
        let entry = |quantity: &str| {
            let own = cells.iter().find(|cell| cell.corner == corner && cell.quantity == quantity);
            own.map_or_else(|| "—".to_owned(), |cell| shown(cell))
        };
        let entries: Vec<String> = quantities.iter().map(|quantity| entry(quantity)).collect();
        let _ = writeln!(text, "| {corner} | {} |", entries.join(" | "));
    }
}

fn shown(cell: &Cell) -> String {
    match &cell.outcome {
        Outcome::Number { ulps, claimed, .. } => {
            let condition = if cell.condition > 16.0 { format!(", κ {:.0e}", cell.condition) } else { String::new() };
            let stated = if claimed.is_finite() { format!(" ≤ {}", short(*claimed)) } else { String::new() };
            format!("{}{stated}{condition}", short(*ulps))
        }
        Outcome::Overflow => "overflow".to_owned(),
        Outcome::Refused(_) => "refused".to_owned(),
        Outcome::Wrong(_) => "wrong".to_owned(),
    }
}

fn short(ulps: f64) -> String {
    if ulps < 100.0 { format!("{ulps:.1}") } else { format!("{ulps:.0e}") }
}

/// The document without its figures, which depend on the elementary functions of the machine.
pub fn skeleton(page: &str) -> Vec<String> {
    page.lines()
        .map(|line| line.chars().filter(|c| !c.is_ascii_digit() && !matches!(c, '.' | 'κ' | ',' | 'e' | '-' | ' ')).collect())
        .collect()
}
