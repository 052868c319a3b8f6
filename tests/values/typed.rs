//! Profiles as people type them, from a generator that shares no code with the program, against values of 30 digits.
//!
//! `tests/oracle/adversary` draws the profiles and encloses their g, F and p by ball arithmetic; this is a sample of them.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use sneddon::contact::Contact;
use sneddon::expr::{Bindings, Expr, Number};
use sneddon::parse;
use sneddon::transform::{Evaluator, Method, Profile, Reading, derive};
use sneddon_checks::decimal::Decimal;
use sneddon_checks::seeds::cases;
use std::collections::BTreeMap;

/// A row: quantity, contact radius, place, true value.
type Row<'t> = [&'t str; 4];

fn table(text: &'static str) -> BTreeMap<(&'static str, &'static str), Vec<Row<'static>>> {
    let mut profiles: BTreeMap<_, Vec<_>> = BTreeMap::new();
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let [text, parameters, quantity, radius, at, truth] = line.split(';').collect::<Vec<_>>()[..] else { panic!("{line}") };
        profiles.entry((text, parameters)).or_default().push([quantity, radius, at, truth]);
    }
    profiles
}

fn exact(text: &str) -> Expr {
    Expr::number(Number::from_f64(text.parse().unwrap()).unwrap())
}

fn reading(contact: &Contact<'_>, [quantity, radius, at, _]: Row<'_>) -> Reading {
    let at = at.parse().unwrap();
    match quantity {
        "g" => contact.evaluator().equivalent(at).unwrap(),
        "F" => contact.force(at).unwrap(),
        "p" => contact.pressure(at, radius.parse().unwrap()).unwrap().unwrap(),
        other => panic!("{other} is no quantity of this table"),
    }
}

#[test]
fn no_value_of_a_typed_profile_is_beyond_its_bound() {
    // Profiles such as r^10·J₂(r) cancel, but not this much.
    compare(include_str!("../oracle/typed.csv"), 150, 450, 1e-9);
}

/// Class "a kink that no double holds": places beside it, where the rounding of the kink moves the pressure by more than anything else.
/// The distances to it are computed from all digits of the kink.
#[test]
fn pressures_beside_kinks_at_decimals_keep_their_bounds() {
    // Next to the kink itself g and F have the rounding of the kink in their bounds, p has not.
    compare(include_str!("../oracle/kinks.csv"), 45, 420, 1e-6);
}

fn compare(text: &'static str, fewest: usize, numbers: usize, largest: f64) {
    let (mut faults, mut count, mut worst) = (Vec::new(), 0, 0.0f64);
    let profiles = table(text);
    for ((text, parameters), rows) in profiles.iter().step_by(cases(3, 1)) {
        let values: Bindings =
            parameters.split_whitespace().map(|own| own.split_once('=').unwrap()).map(|(name, value)| (name, exact(value))).collect();
        let profile = Profile::new(&parse::profile(text).unwrap().substitute(&values)).unwrap_or_else(|error| panic!("{text}: {error}"));
        let solution = derive(&profile).unwrap();
        let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
        let contact = Contact::new(evaluator, 1.0, None, 1e-13);
        for row in rows {
            let (found, truth) = (reading(&contact, *row).estimate, Decimal::read(row[3]));
            let (error, relative) = (truth.distance(found.value), truth.relative(found.value));
            (count, worst) = (count + 1, worst.max(relative));
            if error > found.error || relative > largest {
                faults.push(format!("{text} ({parameters}), {} at {}: {found:?} for {}", row[0], row[2], row[3]));
            }
        }
    }
    println!("{count} values of {} profiles, the largest relative error {worst:.1e}", profiles.len());
    assert!(profiles.len() >= fewest && count >= numbers / cases(3, 1), "the table is too short");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
