//! The rules as numbers, from a ≪ R to the last digits before a kink or an equator, against 28-digit values.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use sneddon_checks::decimal::Decimal;
use sneddon_checks::formulas::{contact, derived_with};
use sneddon_checks::rows::rows;
use std::collections::BTreeMap;

/// A case of the reference file: the rule it belongs to and its profile.
const CASES: [(&str, &str, &str); 9] = [
    ("power", "heß-power", "C*r^n"),
    ("segment", "polynomial-segment", "piecewise(0, r<b, A*(r-b)+C*(r^2-b^2))"),
    ("shifted", "polynomial-segment", "piecewise(0, r<b, (r-b)^k)"),
    ("between", "polynomial-segment", "piecewise(0, r<b, r^k-b^k, r<c, c^k-b^k)"),
    ("worn", "polynomial-segment", "piecewise(0, r<b, C*(r^2-b^2))"),
    ("sphere", "sphere", "h*(1-sqrt(1-r^2/R^2))"),
    ("hyperboloid", "hyperboloid", "h*(sqrt(1+r^2/b^2)-1)"),
    ("worn_sphere", "worn-sphere", "piecewise(0, r<b, h*(sqrt(R^2-b^2)-sqrt(R^2-r^2)))"),
    ("worn_hyperboloid", "worn-hyperboloid", "piecewise(0, r<c, h*(sqrt(b^2+r^2)-sqrt(b^2+c^2)))"),
];

/// The largest error in ulps per case and quantity (g, F, p): measured, with little headroom.
const LIMITS: [(&str, [f64; 3]); 9] = [
    ("power", [1.8, 2.2, 6.0]),
    ("segment", [2.6, 2.5, 0.0]),
    ("shifted", [2.8, 2.0, 0.0]),
    ("between", [3.0, 2.3, 0.0]),
    ("worn", [0.0, 0.0, 4.5]),
    ("sphere", [2.4, 3.3, 2.6]),
    ("hyperboloid", [1.8, 3.0, 2.9]),
    ("worn_sphere", [2.5, 3.2, 0.0]),
    ("worn_hyperboloid", [2.2, 3.0, 0.0]),
];
const QUANTITIES: [&str; 3] = ["g", "F", "p"];

#[test]
fn every_rule_is_right_everywhere() {
    let mut worst: BTreeMap<(&str, &str), (f64, usize)> = BTreeMap::new();
    let mut solutions = BTreeMap::new();
    for row in rows(include_str!("../oracle/rules.csv")) {
        let [case, quantity, arguments, truth] = row[..] else { panic!("{row:?}") };
        let values: Vec<(&str, f64)> =
            arguments.split(' ').map(|pair| pair.split_once('=').unwrap()).map(|(n, v)| (n, v.parse().unwrap())).collect();
        let get = |name: &str| values.iter().find(|(own, _)| *own == name).unwrap().1;
        let (_, rule, profile) = CASES.iter().find(|(id, ..)| *id == case).unwrap();
        let parameters: Vec<(&str, f64)> = values.iter().copied().filter(|(name, _)| !["x", "a", "r"].contains(name)).collect();
        // A whole exponent must be known before the derivation; everything else is bound afterwards.
        let order: Vec<(&str, f64)> = parameters.iter().copied().filter(|(name, _)| *name == "k").collect();
        let key = (case, order.first().map_or(0, |(_, k)| *k as u32));
        let solution = solutions.entry(key).or_insert_with(|| derived_with(profile, &order));
        assert!(solution.terms().all(|t| t.answer.as_ref().is_some_and(|(own, _)| own.id == *rule)), "{case}");
        let own = contact(solution, &parameters, 1.0, None);
        let reading = match quantity {
            "g" => own.evaluator().equivalent(get("x")).unwrap(),
            "F" => own.force(get("a")).unwrap(),
            _ => own.pressure(get("r"), get("a")).unwrap().unwrap(),
        };
        let (truth, found) = (Decimal::read(truth), reading.estimate);
        assert_eq!(reading.method, "exact", "{case} {quantity} {arguments}");
        let distance = truth.distance(found.value).abs();
        // The references have 28 digits, some bounds more.
        assert!(distance <= found.error + 1e-28 * found.value.abs(), "{case} {quantity} {arguments}: {found:?} is off by {distance:e}");
        let (ulps, entry) = (truth.ulps(found.value), worst.entry((case, quantity)).or_default());
        *entry = (entry.0.max(ulps), entry.1 + 1);
        if ulps > 8.0 {
            eprintln!("{case} {quantity} {arguments}: {ulps:.1} ulp");
        }
    }
    println!("{worst:?}");
    for (case, limits) in LIMITS {
        for (quantity, limit) in QUANTITIES.into_iter().zip(limits).filter(|(_, limit)| *limit > 0.0) {
            let (ulps, count) = worst[&(case, quantity)];
            assert!(ulps <= limit, "{case}: {quantity} is {ulps:.2} ulp off");
            assert!(count >= 20, "{case}: {quantity} has {count} rows");
        }
    }
}
