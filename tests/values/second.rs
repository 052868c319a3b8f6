//! The second pass of evaluation: its bounds cover the truth, and cancellation leaves numbers right to the last digit.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

use sneddon::eval::{PreciseAlgebra, Tape};
use sneddon::expr::{Bindings, Expr, Formula, Symbol, shown_to_30_digits};
use sneddon::num::Precise;
use sneddon::parse;
use sneddon::transform::{ClosedForm, Evaluator, Method, Profile, Reading, derive};
use sneddon_checks::decimal::Decimal;

fn expression(text: &str) -> Expr {
    match parse::formula(text).unwrap_or_else(|error| panic!("{text}: {error}")) {
        Formula::Closed(expr) => expr,
        other => panic!("{text}: {other:?}"),
    }
}

/// Random expressions at random points, see `tests/oracle/second.py`: no bound is below the true error, neither that of the
/// second pass alone nor that of the value which is handed on; and that value is right to the last digit nearly everywhere.
#[test]
fn bounds_cover_the_truth_and_values_keep_their_digits() {
    let inputs = [Symbol::new("x"), Symbol::new("y")];
    let (mut rows, mut known, mut total, mut largest, mut second, mut tightness) = (0, 0, 0.0, 0.0_f64, 0, Vec::new());
    for line in include_str!("../oracle/second.csv").lines() {
        let [text, x, y, value] = line.split(';').collect::<Vec<_>>().try_into().unwrap();
        let (x, y, truth) = (x.parse::<f64>().unwrap(), y.parse::<f64>().unwrap(), Decimal::read(value));
        let expr = expression(text);
        rows += 1;

        let tape = Tape::compile(&[shown_to_30_digits(&expr)], &inputs).unwrap();
        let precise = tape.run(&mut PreciseAlgebra, &[Precise::exact(x), Precise::exact(y)], &mut Vec::new()).unwrap();
        if precise.is_finite() {
            let error = truth.distance_of(&[precise.value.hi, precise.value.lo]).abs();
            // The reference has 60 digits.
            assert!(error <= precise.error + 1e-59 * truth.to_f64().abs(), "{line}: {precise:?}, true error {error:e}");
            if error > 1e-50 * truth.to_f64().abs() {
                tightness.push(precise.error / error);
            }
        }

        let form = ClosedForm::new(&expr, &inputs).unwrap();
        let found = form.value(&[x, y]);
        let error = truth.distance(found.value).abs();
        let covered = found.error.is_nan() || error <= found.error + 1e-59 * truth.to_f64().abs();
        assert!(covered, "{line}: {found:?}, true error {error:e}");
        if found.error <= 8.0 * f64::EPSILON * found.value.abs() {
            known += 1;
            total += truth.ulps(found.value);
            largest = largest.max(truth.ulps(found.value));
            second += usize::from(found.error <= 1.01 * 0.5 * f64::EPSILON * found.value.abs());
        }
    }
    tightness.sort_by(f64::total_cmp);
    let mean = total / f64::from(known);
    println!("{known} of {rows} rows have their digits ({second} to half an ulp): mean {mean:.3} ulp, largest {largest:.2} ulp");
    println!("bound of the second pass over its error: median {:.1}", tightness[tightness.len() / 2]);
    // The others cancel beyond what 30 digits hold.
    assert!(mean < 0.3 && largest < 4.0 && f64::from(known) > 0.8 * f64::from(rows), "{known} of {rows}, {mean}, {largest}");
}

/// Profiles whose closed forms cancel, see `tests/oracle/cancelling.py`: right within 8 ulps everywhere, within 1 on average.
#[test]
fn cancelling_profiles_keep_their_digits() {
    let (mut rows, mut total, mut largest, mut failed) = (0, 0.0, (0.0_f64, ""), String::new());
    for line in include_str!("../oracle/cancelling.csv").lines() {
        let [text, quantity, place, value] = line.split(';').collect::<Vec<_>>().try_into().unwrap();
        let truth = Decimal::read(value);
        let place: Vec<f64> = place.split(',').map(|text| text.parse().unwrap()).collect();
        let solution = derive(&Profile::new(&parse::profile(text).unwrap()).unwrap()).unwrap();
        let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
        let reading = match (quantity, place.as_slice()) {
            ("g", [x]) => evaluator.equivalent(*x),
            ("F", [a]) => evaluator.force(*a),
            ("G", [a]) => evaluator.integral(*a),
            ("h", [r]) => evaluator.height(*r),
            ("p", [r, a]) => evaluator.pressure(*r, *a).map(Option::unwrap),
            _ => panic!("{line}"),
        };
        let Reading { estimate, method } = reading.unwrap();
        let (error, ulps) = (truth.distance(estimate.value).abs(), truth.ulps(estimate.value));
        if error > estimate.error {
            failed += &format!("{line}: {estimate:?}, true error {error:e}\n");
        }
        rows += 1;
        total += ulps;
        if ulps > largest.0 {
            largest = (ulps, line);
        }
        if ulps > 8.0 {
            failed += &format!("{line}: {ulps:.2} ulp, bound {:e}, {method}\n", estimate.relative_error());
        }
    }
    println!("{rows} rows: mean {:.3} ulp, largest {:.2} at {}", total / f64::from(rows), largest.0, largest.1);
    assert!(failed.is_empty() && total < f64::from(rows), "\n{failed}");
}
