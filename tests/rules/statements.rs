//! Every rule at random and at extreme places against 30-digit values of what it states.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use sneddon::transform::rules::RULES;
use sneddon_checks::accuracy::{measure, tally};

/// Largest and mean error in ulps, each over the condition number of the place.
const LARGEST: f64 = 16.0;
const MEAN: f64 = 2.0;

#[test]
fn every_rule_keeps_its_digits() {
    let measured = measure(include_str!("../oracle/statements.csv"));
    let mut faults = Vec::new();
    for one in &measured {
        if one.ulps > LARGEST * one.condition || one.honesty > 1.0 {
            let place = format!("{} {} at {}", one.rule, one.quantity, one.place);
            faults.push(format!("{place}: {:.1} ulp, condition {:.1}, error over estimate {:.2}", one.ulps, one.condition, one.honesty));
        }
    }
    let figures = tally(&measured);
    for ((rule, quantity), own) in &figures {
        println!(
            "{rule} {quantity}: {} places, largest {:.2}, mean {:.2}, {} by quadrature",
            own.count, own.largest, own.mean, own.integrated
        );
        if own.mean > MEAN {
            faults.push(format!("{rule} {quantity}: mean error {:.2} ulp", own.mean));
        }
    }
    for rule in RULES {
        for quantity in ["g", "F"] {
            let key = (rule.id.to_owned(), quantity.to_owned());
            assert!(figures.get(&key).is_some_and(|own| own.count >= 12), "{} {quantity} has too few rows", rule.id);
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
