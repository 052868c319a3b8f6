//! `sneddon tradeoff`: the form of what it writes, the truth of the errors that it reports, and its exit codes. No times are judged.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used)]

use serde_json::Value;
use sneddon::expr::Bindings;
use sneddon::num::DoubleDouble;
use sneddon::parse;
use sneddon::tradeoff::{Options, Problem, Quantity, Study, run as study};
use sneddon::transform::{self, Evaluator, Method, PreciseProfile, Profile, Slice, Solution, derive};
use sneddon_checks::seeds::cases;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};
use std::time::Duration;

/// The rows that the tests read come first, so that a second suffices where not all are needed.
fn program(arguments: &[&str], seconds: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_sneddon")).arg("tradeoff").args(arguments).args(["--budget", seconds]).output().unwrap()
}

fn json(arguments: &[&str]) -> Value {
    let done = program(&[arguments, &["--json"]].concat(), "60");
    assert!(done.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&done.stderr));
    serde_json::from_slice(&done.stdout).unwrap()
}

fn place(name: &str) -> PathBuf {
    let directory = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("tradeoff");
    fs::create_dir_all(&directory).unwrap();
    directory.join(name)
}

fn rows<'a>(document: &'a Value, method: &str) -> Vec<&'a Value> {
    document["rows"].as_array().unwrap().iter().filter(|row| row["method"] == method).collect()
}

#[test]
fn json_has_every_method_and_its_keys() {
    let path = place("sphere.svg");
    let document = json(&["R-sqrt(R^2-r^2)", "--set", "R=2", "--at", "1,1.5", "-o", path.to_str().unwrap()]);
    is_one_well_formed_svg(&fs::read_to_string(&path).unwrap());
    // F(a) = E* [(R² + a²) artanh(a/R) − R a] (Segedin) with E* = 1, R = 2, a = 1.
    let (value, law) = (document["points"][0]["value"].as_f64().unwrap(), 5.0 * 0.5_f64.atanh() - 2.0);
    assert!((value - law).abs() < 1e-15 * law, "{value} {law}");
    assert_eq!(document["quantity"], "F");
    assert_eq!(document["parameters"]["R"], 2.0);
    for method in ["closed form", "quadrature", "one rule", "whole curve", "power series", "spring foundation"] {
        let missing = document["skipped"].as_array().unwrap().iter().any(|own| own["method"] == method && own["setting"].is_null());
        assert!(missing || rows(&document, method).len() > 1, "{method}");
    }
    for row in document["rows"].as_array().unwrap() {
        for key in ["true_relative_error", "median_relative_error", "ns_per_point", "ns_low", "ns_high", "set_up_ns", "evaluations"] {
            assert!(row[key].as_f64().is_some_and(|own| own >= 0.0), "{key}: {row}");
        }
        for key in ["at_most", "front"] {
            assert!(row[key].is_boolean(), "{key}: {row}");
        }
        let stated = row["stated_relative_error"].is_null() == row["honest"].is_null();
        assert!(stated && row["setting"].is_string(), "{row}");
    }
    assert!(document["rows"].as_array().unwrap().iter().any(|row| row["front"] == true));
    assert!(document["reference"]["relative_error"].as_f64().unwrap() < 1e-20);
    assert!(document["advice"].as_array().unwrap().iter().all(|own| own["wanted"].is_f64()));
    assert!(!document["sentences"].as_array().unwrap().is_empty());
}

/// Hertz, R = 1: p = (2E*/π) √(a² − r²).
#[test]
fn points_carry_the_pressure_of_the_contact() {
    studied("r^2/2", Quantity::Pressure, (Some(1.0), Some(vec![0.6])), |found| {
        let value = found.problem.factor() * found.truths[0].value.value.hi;
        assert!((value - 1.6 * std::f64::consts::FRAC_1_PI).abs() < 1e-15, "{value}");
    });
}

#[test]
fn csv_has_one_line_per_row_and_one_cell_per_column() {
    let done = program(&["r^2.5", "--quantity", "g", "--csv", "--at", "0.5"], "60");
    assert!(done.status.success());
    let text = String::from_utf8(done.stdout).unwrap();
    let mut lines = text.lines();
    let columns = lines.next().unwrap();
    assert!(columns.starts_with("method,setting,true_relative_error,at_most,"));
    let count = columns.split(',').count();
    let rest: Vec<&str> = lines.collect();
    assert!(rest.len() > 8 && rest.iter().all(|line| line.split(',').count() == count), "{text}");
}

#[test]
fn text_names_the_reference_and_what_to_pick() {
    let done = program(&["ln(cosh(r))", "--quantity", "g", "--tol", "1e-6", "--at", "0.5"], "60");
    let text = String::from_utf8(done.stdout).unwrap();
    assert!(text.contains("true errors against: double-exponential rule with 30 digits"), "{text}");
    assert!(text.contains("For a relative error of 1e-6 use "), "{text}");
    assert!(text.contains("closed form: no closed form is known"), "{text}");
}

fn is_one_well_formed_svg(text: &str) {
    assert!(text.len() < 60_000, "{} bytes", text.len());
    balanced(text);
    for part in ["<svg ", "Pareto front", "closed form", "quadrature", "time per point, ns", "largest relative error"] {
        assert!(text.contains(part), "{part}");
    }
    assert!(!text.contains("NaN") && !text.contains("inf"));
}

/// Tags open and close in order, and nothing stands outside the root.
fn balanced(text: &str) {
    let mut open: Vec<&str> = Vec::new();
    let mut roots = 0;
    for part in text.split('<').skip(1) {
        let (tag, rest) = part.split_once('>').expect("a tag that ends");
        assert!(!open.is_empty() || rest.trim().is_empty() || !tag.starts_with('/'), "text outside the root");
        let name = tag.trim_start_matches('/').split_whitespace().next().unwrap().trim_end_matches('/');
        if tag.starts_with('/') {
            assert_eq!(open.pop(), Some(name));
        } else if !tag.ends_with('/') {
            roots += usize::from(open.is_empty());
            open.push(name);
        }
        assert!(!rest.contains('&') || rest.contains("&amp;") || rest.contains("&lt;") || rest.contains("&gt;"), "{rest}");
    }
    assert!(open.is_empty() && roots == 1, "{open:?}, {roots} roots");
}

#[test]
fn bad_input_says_what_is_wrong_and_writes_nothing() {
    let path = place("untouched.svg");
    fs::write(&path, "as it was").unwrap();
    let name = path.to_str().unwrap();
    let nowhere = place("missing").join("plot.svg");
    let cases: &[(&[&str], &str)] = &[
        (&["r^"], "column 3"),
        (&["r^2/R"], "the parameter R has no value"),
        (&["1"], "flat profile"),
        (&["2-sqrt(4-r^2)", "--at", "2"], "not inside the domain"),
        (&["r^2", "--at", "-1"], "negative"),
        (&["r^2", "--radius", "1"], "--radius requires --quantity p"),
        (&["r^2", "--quantity", "k"], "--quantity k: tradeoff measures only g, F and p"),
        (&["r^2", "--tol", "0"], "not positive"),
        (&["r^2", "--json", "--csv"], "cannot be used with"),
        (&["r^2", "--at", "0"], "no reference value"),
        (&["r^2", "-o", "plot.png"], ".svg, .txt"),
        (&["r^2", "-o", nowhere.to_str().unwrap()], "does not exist"),
    ];
    for (arguments, part) in cases {
        let with_file = if arguments.contains(&"-o") { Vec::new() } else { vec!["-o", name] };
        let done = program(&[arguments, with_file.as_slice()].concat(), "1");
        let message = String::from_utf8_lossy(&done.stderr);
        assert_eq!(done.status.code(), Some(2), "{arguments:?}: {message}");
        assert!(done.stdout.is_empty() && message.contains(part), "{arguments:?}: {message}");
        assert_eq!(fs::read_to_string(&path).unwrap(), "as it was", "{arguments:?}");
    }
}

fn solved(text: &str) -> Solution {
    derive(&Profile::new(&parse::profile(text).unwrap()).unwrap()).unwrap()
}

/// Laws that a wrong reference would break: dF/dd = 2E*a, hence F(a) = 2E*(a g(a) − ∫₀^a g), and powers by their κ.
#[test]
fn the_slow_integral_agrees_with_the_closed_form() {
    for (text, points) in [
        ("r", vec![0.3, 2.0]),
        ("r^2.7", vec![0.1, 3.0]),
        ("0.7*sqrt(r)", vec![0.01, 0.5]),
        ("2-sqrt(4-r^2)", vec![1e-6, 0.5, 1.9, 1.999999]),
        ("0.4*(1-cos(2.2*r))", vec![0.5, 3.0, 40.0]),
        ("piecewise(0, r<0.6, (r^2-0.36)/4)", vec![0.600_001, 0.7, 3.0]),
        ("0.3*max(0, r-0.6)", vec![0.61, 3.0]),
        ("ln(1+r^2)", vec![0.5, 20.0]),
        ("r^2*ln(r)", vec![0.5, 2.0]),
    ] {
        let solution = solved(text);
        let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Exact, 1e-13).unwrap();
        let slow = PreciseProfile::new(&solution.profile).unwrap();
        for x in points {
            use sneddon::transform::Superposed::{Equivalent, Force, Pressure};
            for (quantity, inputs) in [(Equivalent, vec![x]), (Force, vec![x]), (Pressure, vec![0.3 * x, x]), (Pressure, vec![0.95 * x, x])]
            {
                let Some(closed) = evaluator.with_30_digits(quantity, &inputs).unwrap().filter(|own| own.is_finite()) else { continue };
                let Some(own) = slow.value(quantity, &inputs) else { panic!("{text}: {quantity:?} at {inputs:?}") };
                let difference = own.sub(closed);
                assert!(difference.value.hi.abs() <= difference.error, "{text}: {quantity:?} at {inputs:?}: {own:?} {closed:?}");
                assert!(own.error < 1e-20 * own.value.hi.abs(), "{text}: {quantity:?} at {inputs:?}: {own:?}");
            }
        }
    }
}

/// Runs a study with one batch for each time, because errors do not depend on the number of batches.
fn studied(text: &str, quantity: Quantity, (radius, at): (Option<f64>, Option<Vec<f64>>), look: impl FnOnce(&Study<'_>)) {
    let solution = solved(text);
    let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
    let problem = Problem::new(&solution, &evaluator, quantity, radius, at).unwrap();
    look(&study(problem, &Options { budget: Duration::from_secs(120), rounds: 1, wanted: vec![1e-6] }).unwrap());
}

/// The error of n springs under the paraboloid is known: F is a midpoint sum of (d − x²/R), and everything else is exact.
#[test]
fn reported_errors_are_the_true_ones_and_the_front_is_a_front() {
    studied("r^2/2", Quantity::Force, (None, Some(vec![1.0])), |found| {
        let mut springs = 0;
        for row in found.rows.iter().filter(|row| row.method == "spring foundation") {
            let n: f64 = row.setting.rsplit('/').next().unwrap().parse().unwrap();
            // 2Δx Σ (1 − x_i²) = 4/3 + 1/(6n²)·… : the midpoint rule of −x² over [0, 1] is high by 1/(12 n²).
            let law = (2.0 / (12.0 * n * n)) / (4.0 / 3.0);
            assert!((row.error / law - 1.0).abs() < 1e-4 + 1e-14 / law, "n = {n}: {:e} for {law:e}", row.error);
            springs += 1;
        }
        assert!(springs >= 5);
        let closed: Vec<_> = found.rows.iter().filter(|row| row.method == "closed form").collect();
        assert!(!closed.is_empty() && closed.iter().all(|row| row.error < 2e-16 && row.honest != Some(false)));
        for row in &found.rows {
            assert!(row.honest != Some(false), "{} {}", row.method, row.setting);
        }
        hold_front(found);
    });
    if cases(false, true) {
        studied("ln(1+r^2)", Quantity::Equivalent, (None, None), hold_front);
    }
}

/// Nothing on the front is beaten, everything else is.
fn hold_front(found: &Study<'_>) {
    for (index, row) in found.rows.iter().enumerate() {
        let floor = |error: f64| error.max(0.5 * f64::EPSILON);
        let beaten = found
            .rows
            .iter()
            .enumerate()
            .any(|(other, own)| other != index && own.time.median < row.time.median && floor(own.error) <= floor(row.error));
        assert!(!(row.front && beaten), "{} {}", row.method, row.setting);
    }
    let best = found.rows.iter().map(|row| row.error).fold(f64::INFINITY, f64::min);
    assert!(found.rows.iter().any(|row| row.front && row.error <= best.max(0.5 * f64::EPSILON)));
    let pick = found.advice[0].pick.unwrap();
    assert!(found.rows[pick].error <= 1e-6 && found.rows[pick].front);
}

/// Where a closed form exists, its slice has every digit: Struve and Dawson functions, products of Bessel functions, forms that cancel.
#[test]
fn a_slice_of_the_closed_form_has_every_digit() {
    for (text, quantity) in [
        ("1-cos(r)", Quantity::Equivalent),
        ("1-exp(-r^2)", Quantity::Force),
        ("r*erf(r)", Quantity::Equivalent),
        ("r^2*exp(-r)", Quantity::Force),
        ("ln(1+r^2)", Quantity::Force),
        ("2-sqrt(4-r^2)", Quantity::Pressure),
    ] {
        let solution = solved(text);
        let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
        let Problem { points, radius, .. } = Problem::new(&solution, &evaluator, quantity, None, None).unwrap();
        // As long as the slices that a study measures, because short slices may be evaluated differently.
        let long: Vec<f64> = points.iter().copied().cycle().take(131_072).collect();
        let mut values = vec![0.0; long.len()];
        let out = Slice::values(&mut values);
        let inner = match quantity {
            Quantity::Equivalent => evaluator.equivalents(&long, out).map(|()| transform::Superposed::Equivalent),
            Quantity::Force => evaluator.forces(&long, out).map(|()| transform::Superposed::Force),
            _ => evaluator.pressures(&long, radius.unwrap(), out).map(|()| transform::Superposed::Pressure),
        };
        let inner = inner.unwrap();
        for (at, value) in points.iter().zip(values) {
            let inputs: Vec<f64> = std::iter::once(*at).chain(radius).collect();
            let truth = evaluator.with_30_digits(inner, &inputs).unwrap().unwrap();
            assert!(truth.error < 1e-20 * truth.value.hi.abs(), "{text} at {at}: {truth:?}");
            let error = truth.value.sub(DoubleDouble::from(value)).hi.abs() / truth.value.hi.abs();
            // Three quarters of a unit in the last place of a number next to a power of two.
            assert!(error < 0.75 * f64::EPSILON, "{text} at {at}: {error:e}");
        }
    }
}
