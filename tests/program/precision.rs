//! `--precision` of `eval`, `solve` and `reference`: so many digits, and bounds that hold for what is shown.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used)]

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_sneddon")).args(arguments).output().unwrap()
}

/// The fields of a CSV, the header first.
fn rows(arguments: &[&str]) -> Vec<Vec<String>> {
    let done = run(arguments);
    assert!(done.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8(done.stdout).unwrap().lines().map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

/// Pairs of columns: a value and its error bound.
fn pairs(header: &[String]) -> Vec<(usize, usize)> {
    let value = |name: &str| header.iter().position(|own| own == name || own.starts_with(&format!("{name}_")));
    let pair = |(index, own): (usize, &String)| match own.split_once("_error") {
        Some((name, _)) => Some((value(name)?, index)),
        None => (own == "error").then_some((1, index)),
    };
    header.iter().enumerate().filter_map(pair).collect()
}

fn digits(field: &str) -> usize {
    let mantissa = field.split('e').next().unwrap().replace(['.', '-'], "");
    mantissa.trim_matches('0').len()
}

#[test]
fn values_have_so_many_digits_and_bounds_include_the_rounding() {
    let scene = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("precision.toml");
    fs::write(&scene, run(&["scene", "new", "sphere"]).stdout).unwrap();
    let scene = scene.to_str().unwrap();
    let calls: [&[&str]; 4] = [
        &["eval", "R-sqrt(R^2-r^2)", "--set", "R=2", "--quantity", "F", "--at", "1e-9,0.1,0.3,1.9", "--csv"],
        &["eval", "ln(cosh(r))", "--quantity", "p", "--at", "0:1:7", "--radius", "1", "--csv"],
        &["solve", scene, "--csv"],
        &["reference", scene, "--grid", "0:2 um:9"],
    ];
    for call in calls {
        let whole = rows(call);
        let pairs = pairs(&whole[0]);
        assert!(!pairs.is_empty(), "{call:?}: {:?}", whole[0]);
        for count in [1, 2, 5, 11, 16, 17] {
            let short = rows(&[call, &["--precision", &count.to_string()]].concat());
            assert_eq!(short.len(), whole.len());
            for (short, whole) in short.iter().zip(&whole).skip(1) {
                for (value, error) in pairs.iter().copied().filter(|(value, _)| !whole[*value].is_empty()) {
                    let number = |field: &str| field.parse::<f64>().unwrap();
                    // The load is an input and has all of its digits.
                    if number(&whole[error]) > 0.0 {
                        assert!(
                            digits(&short[value]) <= count as usize && digits(&short[error]) <= count as usize,
                            "{call:?} {count}: {short:?}"
                        );
                    }
                    let moved = (number(&short[value]) - number(&whole[value])).abs() + number(&whole[error]);
                    assert!(moved <= number(&short[error]), "{call:?} {count}: {short:?} for {whole:?}");
                    assert!(
                        number(&short[error]) <= moved * (1.0 + 1.1 * 10f64.powi(1 - count)),
                        "{call:?} {count}: the bound of {short:?} is loose"
                    );
                }
            }
        }
    }
    let text = run(&["eval", "r^2", "--quantity", "F", "--at", "0.1", "--precision", "4"]);
    assert!(String::from_utf8(text.stdout).unwrap().contains(" 0.002667 "));
}

#[test]
fn what_is_no_number_of_digits_is_refused() {
    for (more, expected) in [
        (["--precision", "0", "--csv"], "--precision 0 is out of range"),
        (["--precision", "18", "--csv"], "expected a whole number from 1 to 17"),
        (["--precision", "x", "--csv"], "--precision x is not a whole number"),
        (["--precision", "-3", "--csv"], "--precision -3 is out of range"),
        (["--precision", "4", "--json"], "--precision applies only to text and CSV"),
    ] {
        let done = run(&[["eval", "r^2", "--quantity", "F", "--at", "0.1"].as_slice(), &more].concat());
        let said = String::from_utf8(done.stderr).unwrap();
        assert!(done.status.code() == Some(2) && done.stdout.is_empty() && said.contains(expected), "{more:?}: {said}");
    }
}
