//! Units on the command line: answers with units are those of the same call in one bare system, and what does not fit is refused.
#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used)]

use std::process::{Command, Output};

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_sneddon")).args(arguments).output().unwrap()
}

fn json(arguments: &[&str]) -> serde_json::Value {
    let done = run(arguments);
    assert!(done.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&done.stderr));
    serde_json::from_slice(&done.stdout).unwrap()
}

fn values(document: &serde_json::Value) -> Vec<f64> {
    document["points"].as_array().unwrap().iter().map(|point| point["value"].as_f64().unwrap()).collect()
}

#[test]
fn numbers_are_those_of_a_bare_system() {
    // Lengths in nm, pressures in GPa: forces in GPa nm² = nN, stiffnesses in N/m, energies in GPa nm³ = 1e-18 J.
    for (quantity, unit) in
        [("f", "nm"), ("g", "nm"), ("d", "nm"), ("F", "nN"), ("k", "N/m"), ("p_mean", "GPa"), ("U", "aJ"), ("G", "nm^2")]
    {
        let with = ["eval", "R-sqrt(R^2-r^2)", "--set", "R=20 nm", "--quantity", quantity, "--at", "5 nm,0.006 um,100 angstrom"];
        let with: Vec<&str> = with.into_iter().chain(["--effective-modulus", "70 GPa", "--json"]).collect();
        let bare =
            ["eval", "R-sqrt(R^2-r^2)", "--set", "R=20", "--quantity", quantity, "--at", "5,6,10", "--effective-modulus", "70", "--json"];
        let (with, bare) = (json(&with), json(&bare));
        assert_eq!(with["units"]["value"], unit, "{quantity}");
        assert_eq!(values(&with), values(&bare), "{quantity}");
        assert!(bare.get("units").is_none());
    }
    let curve = ["eval", "r*tan(theta)", "--quantity", "p", "--radius", "1 um", "--at", "0.2 um:0.8 um:4", "--json", "--set"];
    let degrees = json(&curve.iter().copied().chain(["theta=20 deg"]).collect::<Vec<_>>());
    let radians = json(&curve.iter().copied().chain(["theta=pi/9"]).collect::<Vec<_>>());
    assert_eq!(values(&degrees), values(&radians));
    assert_eq!(degrees["units"]["value"], "E*");
}

#[test]
fn formulas_are_counted_in_the_first_unit_of_length() {
    let document = json(&["derive", "min(r^2/(2*R),h)", "--set", "R=20 nm", "--set", "h=0.01 um", "--json"]);
    assert_eq!(document["profile"]["text"], "min(10, r^2/40)");
    let told = String::from_utf8(run(&["derive", "r^2/R", "--set", "R=2 um"]).stderr).unwrap();
    assert!(told.contains("um"), "{told}");
}

#[test]
fn what_does_not_fit_is_refused() {
    let cases: [&[&str]; 9] = [
        &["eval", "r^2/R", "--set", "R=20 nm", "--quantity", "g", "--at", "5"],
        &["eval", "r^2/R", "--set", "R=20", "--quantity", "g", "--at", "5 nm"],
        &["eval", "r^2/R", "--set", "R=20 nN", "--quantity", "g", "--at", "5 nm"],
        &["eval", "r^2/R", "--set", "R=20 nm", "--quantity", "g", "--at", "5 GPa"],
        &["eval", "r^2/R", "--set", "R=20 parsec", "--quantity", "g", "--at", "5 nm"],
        &["eval", "r^2/R", "--set", "R=20 nm", "--quantity", "F", "--at", "5 nm", "--effective-modulus", "3"],
        &["eval", "r^2/R", "--set", "R=20 nm", "--quantity", "p", "--at", "5 nm", "--radius", "7"],
        &["eval", "r^2/2", "--quantity", "g", "--at", "5 nm"],
        &["eval", "r^2/R", "--set", "R=-20 nm", "--quantity", "g", "--at", "5 nm"],
    ];
    for case in cases {
        let done = run(case);
        assert_eq!(done.status.code(), Some(2), "{case:?}");
        assert!(done.stdout.is_empty() && String::from_utf8_lossy(&done.stderr).contains("help: "), "{case:?}");
    }
}
