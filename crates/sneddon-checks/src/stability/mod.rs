//! Tests every rule at the limits of its domain against the reference values of `tests/oracle/extremes.py`.

pub mod page;

use crate::decimal::Decimal;
use crate::formulas::{bindings, contact, derived_with};
use crate::rows::rows;
use rayon::prelude::*;
use sneddon::contact::{Contact, ContactError};
use sneddon::num::Estimate;
use sneddon::scene::{Loads, Run, Scene};
use sneddon::transform::rules::RULES;
use sneddon::transform::{Profile, Reading};
use std::collections::BTreeMap;

/// The result of one cell: a rule, a corner of its domain, and a quantity.
#[derive(Clone, Debug)]
pub struct Cell {
    pub rule: String,
    pub corner: String,
    pub quantity: String,
    /// The arguments, for messages.
    pub place: String,
    /// The condition number, at least 1.
    pub condition: f64,
    pub outcome: Outcome,
}

/// The number or the refusal.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// A number.
    Number {
        /// Error in ulps of the true value.
        ulps: f64,
        /// The program's estimate of the error, in the same ulps.
        claimed: f64,
        /// |value − true| over the estimate.
        honesty: f64,
        /// The path of the computation.
        method: &'static str,
    },
    /// Too large for a double, and refused with a typed error.
    Overflow,
    /// A typed error, or a bound without a reliable digit, although the true value is in the range of doubles.
    Refused(String),
    /// A number, or another error, although the true value overflows.
    Wrong(String),
}

impl Cell {
    /// A description of the fault, if any.
    pub fn fault(&self) -> Option<String> {
        let said = match &self.outcome {
            Outcome::Number { ulps, honesty, .. } if *ulps > LARGEST * self.condition || *honesty > 1.0 => {
                format!("{ulps:.1} ulp, error over estimate {honesty:.2}")
            }
            Outcome::Wrong(said) => said.clone(),
            _ => return None,
        };
        Some(format!("{} {} at {} ({}): {said}, condition {:.1e}", self.rule, self.quantity, self.corner, self.place, self.condition))
    }
}

/// The largest error in ulps over the condition number that a cell may have.
pub const LARGEST: f64 = 16.0;

/// Evaluates every `every`th corner in the output of `tests/oracle/extremes.py`, with the rules distributed over the cores.
pub fn cells(text: &str, every: usize) -> Vec<Cell> {
    let rows = rows(text);
    let rules: Vec<_> = rows.chunk_by(|one, two| one[0] == two[0]).collect();
    rules.par_iter().flat_map_iter(|rows| of_rule(rows, every)).collect()
}

fn of_rule(rows: &[Vec<&str>], every: usize) -> Vec<Cell> {
    let mut solutions = BTreeMap::new();
    let mut found = Vec::new();
    // Test selected corners with all of their quantities, and every quantity in at least one corner.
    let mut corners: Vec<(&str, bool)> = Vec::new();
    let mut quantities: Vec<&str> = Vec::new();
    for row in rows {
        let place = corners.iter().position(|(own, _)| *own == row[1]).unwrap_or_else(|| {
            corners.push((row[1], corners.len().is_multiple_of(every)));
            corners.len() - 1
        });
        if !quantities.contains(&row[2]) {
            quantities.push(row[2]);
            corners[place].1 = true;
        }
    }
    for row in rows.iter().filter(|row| corners.contains(&(row[1], true))) {
        let [id, corner, quantity, place, truth, condition] = row[..] else { panic!("{row:?}") };
        let values: Vec<(&str, f64)> =
            place.split(' ').map(|pair| pair.split_once('=').unwrap()).map(|(name, v)| (name, v.parse().unwrap())).collect();
        let mut keep = |outcome| {
            found.push(Cell {
                rule: id.to_owned(),
                corner: corner.to_owned(),
                quantity: quantity.to_owned(),
                place: place.to_owned(),
                condition: condition.parse::<f64>().unwrap().max(1.0),
                outcome,
            });
        };
        if let Some(name) = id.strip_prefix("shape ") {
            keep(judged(truth, indented(name, quantity, &values)));
            continue;
        }
        let rule = RULES.iter().find(|rule| rule.id == id).unwrap_or_else(|| panic!("no rule {id}"));
        let solution = solutions.entry(id).or_insert_with(|| derived_with(rule.pattern, &[]));
        let (parameters, at): (Vec<_>, Vec<_>) = values.iter().partition(|(name, _)| rule.parameters.iter().any(|p| p.name == *name));
        let get = |name: &str| at.iter().find(|(own, _)| *own == name).map(|(_, v)| *v);
        let own = contact(solution, &parameters, get("E").unwrap_or(1.0), None);
        keep(judged(truth, read(&own, quantity, get)));
    }
    found
}

fn read(own: &Contact<'_>, quantity: &str, get: impl Fn(&str) -> Option<f64>) -> Result<Reading, String> {
    let at = |name: &str| get(name).unwrap();
    let found: Result<Reading, ContactError> = match quantity {
        "g" => own.depth(at("x")),
        "F" => own.force(at("a")),
        "G" => own.integral(at("a")),
        "u" => own.displacement(at("r"), at("a")),
        "U" => own.energy(at("a")),
        _ => match own.pressure(at("r"), at("a")) {
            Ok(Ok(reading)) => Ok(reading),
            Ok(Err(reason)) => return Err(reason.text().to_owned()),
            Err(error) => Err(error),
        },
    };
    found.map_err(|error| error.to_string())
}

/// A named shape pressed to a depth: a(d) or F(d). A state has no error estimate.
fn indented(name: &str, quantity: &str, values: &[(&str, f64)]) -> Result<Reading, String> {
    let has = |name: &str| values.iter().any(|(own, _)| *own == name);
    let shape = sneddon::scene::shape(name).unwrap();
    let way = shape.ways.iter().find(|way| way.parameters.iter().all(|p| has(p.name))).unwrap();
    let (depth, parameters): (Vec<_>, Vec<_>) = values.iter().partition(|(name, _)| *name == "d");
    let formula = sneddon::parse::profile(way.f).unwrap().substitute(&bindings(&parameters));
    let profile = Profile::new(&formula).map_err(|error| error.to_string())?;
    let rim = shape.rim.map(|rim| values.iter().find(|(own, _)| *own == rim).unwrap().1);
    let scene = Scene { loads: Loads::List(vec![depth[0].1]), tolerance: 1e-13, rim, ..Scene::of(profile) };
    let solution = scene.solution().map_err(|error| error.to_string())?;
    let row = Run::new(&scene, &solution).map_err(|error| error.to_string())?.row(0).unwrap();
    let Some(state) = row.indented.state else { return Err(row.why().unwrap_or("no state").to_owned()) };
    let value = if quantity == "a(d)" { state.radius } else { state.force };
    Ok(Reading { estimate: Estimate::estimated(value, f64::INFINITY, 0), method: "state" })
}

fn judged(truth: &str, found: Result<Reading, String>) -> Outcome {
    let overflows = truth.ends_with("inf") || Decimal::read(truth).to_f64().is_infinite();
    match found {
        Err(_) if overflows => Outcome::Overflow,
        Err(said) => Outcome::Refused(said),
        Ok(reading) if overflows => Outcome::Wrong(format!("{:?} where the true value is too large", reading.estimate)),
        Ok(reading) => {
            let (truth, estimate) = (Decimal::read(truth), reading.estimate);
            if !estimate.value.is_finite() || estimate.error.is_nan() {
                return Outcome::Wrong(format!("{estimate:?}"));
            }
            let stated = reading.method != "state";
            if stated && estimate.error > 1e-3 * estimate.value.abs() && estimate.error > 1e-300 {
                return Outcome::Refused(format!("{:e} with an error of up to {:e}", estimate.value, estimate.error));
            }
            // The reference ends after 25 digits.
            let distance = (truth.distance(estimate.value).abs() - 1e-24 * estimate.value.abs()).max(0.0);
            let near = truth.to_f64().abs();
            Outcome::Number {
                ulps: truth.ulps(estimate.value),
                claimed: estimate.error / (near.next_up() - near),
                honesty: if distance == 0.0 { 0.0 } else { distance / estimate.error },
                method: reading.method,
            }
        }
    }
}
