//! How far the program's numbers are from 30-digit values, rule by rule and quantity by quantity.

use crate::decimal::Decimal;
use crate::formulas::{Values, contact, derived_with};
use crate::rows::rows;
use sneddon::transform::rules::RULES;
use std::collections::BTreeMap;

/// One place of one rule.
pub struct Measured {
    pub rule: String,
    pub quantity: String,
    /// The arguments, for messages.
    pub place: String,
    /// Error in ulps of the true value.
    pub ulps: f64,
    /// The condition number, at least 1.
    pub condition: f64,
    /// |value − true| over the program's own estimate.
    pub honesty: f64,
    /// The path that answered.
    pub method: &'static str,
}

/// The figures of one rule and quantity.
#[derive(Clone, Copy, Default)]
pub struct Tally {
    pub count: usize,
    /// Largest and mean error in ulps, each divided by the condition number where that exceeds 1.
    pub largest: f64,
    pub mean: f64,
    /// Largest unscaled error in ulps.
    pub plain: f64,
    /// Largest error over estimate.
    pub honesty: f64,
    /// Places that quadrature answered, because the closed form lost too many digits there.
    pub integrated: usize,
}

/// Evaluates every row of a file that `tests/oracle/statements.py` wrote.
pub fn measure(text: &str) -> Vec<Measured> {
    let mut solutions = BTreeMap::new();
    let mut found = Vec::new();
    for row in rows(text) {
        let [id, quantity, place, truth, condition] = row[..] else { panic!("{row:?}") };
        let values: Vec<(&str, f64)> =
            place.split(' ').map(|pair| pair.split_once('=').unwrap()).map(|(name, v)| (name, v.parse().unwrap())).collect();
        let rule = RULES.iter().find(|rule| rule.id == id).unwrap_or_else(|| panic!("no rule {id}"));
        let solution = solutions.entry(id).or_insert_with(|| derived_with(rule.pattern, &[]));
        let (parameters, at): (Vec<_>, Vec<_>) = values.iter().partition(|(name, _)| rule.parameters.iter().any(|p| p.name == *name));
        let get = |name: &str| number(&at, name);
        let own = contact(solution, &parameters, 1.0, None);
        let reading = match quantity {
            "g" => own.depth(get("x")),
            "F" => own.force(get("a")),
            _ => own.pressure(get("r"), get("a")).map(|reading| reading.unwrap_or_else(|reason| panic!("{}", reason.text()))),
        };
        let reading = reading.unwrap_or_else(|error| panic!("{id} {quantity} {place}: {error}"));
        let (truth, estimate) = (Decimal::read(truth), reading.estimate);
        // The reference ends after 30 digits.
        let distance = (truth.distance(estimate.value).abs() - 1e-29 * estimate.value.abs()).max(0.0);
        found.push(Measured {
            rule: id.to_owned(),
            quantity: quantity.to_owned(),
            place: place.to_owned(),
            ulps: truth.ulps(estimate.value),
            condition: condition.parse::<f64>().unwrap().max(1.0),
            honesty: if distance == 0.0 { 0.0 } else { distance / estimate.error },
            method: reading.method,
        });
    }
    found
}

/// The figures per rule and quantity.
pub fn tally(measured: &[Measured]) -> BTreeMap<(String, String), Tally> {
    let mut figures: BTreeMap<(String, String), Tally> = BTreeMap::new();
    for one in measured {
        let own = figures.entry((one.rule.clone(), one.quantity.clone())).or_default();
        let relative = one.ulps / one.condition;
        own.mean = (own.mean * own.count as f64 + relative) / (own.count + 1) as f64;
        own.count += 1;
        own.largest = own.largest.max(relative);
        own.plain = own.plain.max(one.ulps);
        own.honesty = own.honesty.max(one.honesty);
        own.integrated += usize::from(one.method != "exact");
    }
    figures
}

fn number(values: &Values<'_>, name: &str) -> f64 {
    values.iter().find(|(own, _)| *own == name).unwrap().1
}
