//! `eval --explain` and `--method ID`: every way to a number, and one of them alone.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::panic)]

use serde_json::Value;
use sneddon::transform::WAYS;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_sneddon")).arg("eval").args(arguments).output().unwrap()
}

fn points(arguments: &[&str]) -> Vec<Value> {
    let done = run(&[arguments, &["--json"]].concat());
    assert!(done.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&done.stderr));
    let document: Value = serde_json::from_slice(&done.stdout).unwrap();
    document["points"].as_array().unwrap().clone()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

/// The way of every point is in its list with the same number, and each way of the list gives its number again by `--method`.
#[test]
fn every_way_of_the_list_is_a_method() {
    let calls: [&[&str]; 7] = [
        &["r^2/(2*R)", "--set", "R=2", "--quantity", "p", "--at", "0.5,0.75", "--radius", "1"],
        &["max(0,r-0.3)+ln(1+r^3)", "--quantity", "F", "--at", "0.5"],
        &["ln(1+r^3)", "--quantity", "a", "--at", "0.5"],
        &["ln(1+r^3)", "--quantity", "U", "--at", "0.5"],
        &["ln(1+r^3)", "--quantity", "sigma_zz", "--at", "0.2", "--radius", "1"],
        &["r^2*besselj(0,r)", "--quantity", "u", "--at", "0.5,1.5", "--radius", "1"],
        &["R-sqrt(R^2-r^2)", "--set", "R=2 um", "--quantity", "F", "--at", "0.5 um", "--effective-modulus", "3 GPa"],
    ];
    for call in calls {
        let explained = points(&[call, &["--explain"]].concat());
        for (place, point) in explained.iter().enumerate() {
            let ways = point["ways"].as_array().unwrap();
            let chosen = ways.iter().find(|own| own["id"] == point["way"]).unwrap_or_else(|| panic!("{call:?}: {point}"));
            let off = (number(&chosen["value"]) - number(&point["value"])).abs();
            assert!(off <= number(&chosen["error_estimate"]) + number(&point["error_estimate"]), "{call:?}: {point}");
            assert!(ways.len() > 2, "{call:?}: {point}");
            for way in ways {
                let id = way["id"].as_str().unwrap();
                assert!(way["value"].is_null() != way["why"].is_null() && way["value"].is_null() == way["bound"].is_null(), "{way}");
                // `--method series` gives the series of these quantities term by term.
                let is_other_series = id == "series" && ["g", "F", "G", "p"].contains(&call[call.len() - 3]);
                if way["value"].is_null() || is_other_series || id == "auto" {
                    continue;
                }
                let again = points(&[call, &["--method", id]].concat());
                assert_eq!((&again[place]["value"], &again[place]["way"]), (&way["value"], &way["id"]), "{call:?} {id}");
            }
        }
    }
}

/// Points of a_of_F are forces, a list that reaches the work limit is still written, and `--precision` rounds its numbers too.
#[test]
fn points_limits_and_digits_of_the_list() {
    let call = ["r^2/R", "--set", "R=1 um", "--effective-modulus", "1 GPa", "--quantity", "a_of_F"];
    let found = points(&[&call[..], &["--at", "1 uN"]].concat());
    // F = (8/3) E* a³/R.
    assert!((number(&found[0]["value"]) - 0.375e-3_f64.cbrt()).abs() < 1e-15, "{found:?}");
    let refused = run(&[&call[..], &["--at", "1 nm"]].concat());
    assert!(refused.status.code() == Some(2) && String::from_utf8_lossy(&refused.stderr).contains("is a length, not a force"));
    // a(d) of a logarithm is a root, and F(d) rests on it.
    let force = points(&["ln(1+r^3)", "--quantity", "F_of_d", "--at", "0.5"]);
    assert_eq!(force[0]["method"], "root");
    let shown = run(&["r^2", "--quantity", "F", "--at", "0.7", "--explain", "--precision", "3"]);
    assert!(shown.status.success() && !String::from_utf8(shown.stdout).unwrap().contains("0.9146"));
    let done = run(&["ln(1+r^3)", "--quantity", "p", "--at", "0.1:0.9:40", "--radius", "1", "--explain", "--budget", "0.25", "--json"]);
    let document: Value = serde_json::from_slice(&done.stdout).unwrap();
    assert!(done.status.code() == Some(1) && document["complete"] == false, "{:?}", document["why"]);
    let cut = document["points"].as_array().unwrap();
    let is_unasked = |way: &Value| way["why"].as_str().is_some_and(|why| why.contains("the work limit is reached"));
    assert!(cut.iter().all(|point| point["value"].is_number()));
    assert!(cut.iter().flat_map(|point| point["ways"].as_array().unwrap()).any(is_unasked));
}

/// Quantities that follow from what was given are found in none of the ways.
#[test]
fn what_is_not_computed_has_one_entry() {
    let stiffness = points(&["r^2", "--quantity", "k", "--at", "0.5", "--explain"]);
    let ways = stiffness[0]["ways"].as_array().unwrap();
    assert!(ways.len() == 1 && ways[0]["id"] == "exact" && ways[0]["value"] == stiffness[0]["value"], "{stiffness:?}");
}

#[test]
fn a_way_without_an_answer_says_why() {
    let refused = |arguments: &[&str], expected: &str| {
        let done = run(arguments);
        let error = String::from_utf8_lossy(&done.stderr).into_owned();
        assert!(done.status.code() == Some(2) && done.stdout.is_empty() && error.contains(expected), "{arguments:?}: {error}");
    };
    let call = ["ln(1+r^3)", "--quantity", "g", "--at", "0.5", "--method"];
    refused(&[&call[..], &["doubles"]].concat(), "method doubles cannot compute this number: a term has no closed form");
    refused(&[&call[..], &["legendre"]].concat(), "method legendre does not compute g");
    refused(&[&call[..], &["simpson"]].concat(), "expected one of auto, exact, quadrature, series, curve, doubles,");
    refused(&[&call[..], &["auto", "--explain", "--csv"]].concat(), "cannot be used with");
    // Of several points those with an answer keep it.
    let some = points(&["piecewise(r^2,r<1,2*r-1)", "--quantity", "g", "--at", "0.5,1.5", "--method", "series"]);
    assert!(some[0]["value"].is_f64(), "{some:?}");
}

/// `docs/ways.md` lists every way, as the program describes it.
#[test]
fn the_page_lists_every_way() {
    let page = fs::read_to_string(PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("docs/ways.md")).unwrap();
    let row =
        |way: &sneddon::transform::Way| format!("| `{}` | {} | {} | {} |", way.key, way.title, way.quantities.join(", "), way.bound.name());
    let rows: Vec<String> = WAYS.iter().map(row).collect();
    let shown: Vec<&str> = page.lines().filter(|line| line.starts_with("| `")).collect();
    assert_eq!(shown, rows, "expected these rows in docs/ways.md:\n{}", rows.join("\n"));
}
