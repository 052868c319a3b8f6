//! Poles, ends and contact radii as the program shows them.
#![allow(clippy::unwrap_used)]

use serde_json::Value;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6, LN_2};
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

fn run(words: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_sneddon")).args(words).output().unwrap()
}

fn values(done: &Output) -> Vec<Option<f64>> {
    let document: Value = serde_json::from_slice(&done.stdout).unwrap();
    document["points"].as_array().unwrap().iter().map(|own| own["value"].as_f64()).collect()
}

/// Class "one point without a value": the others keep theirs, whichever method has been asked for. The values are those of ½x·ln((2+x)/(2-x)).
#[test]
fn a_place_beyond_the_end_leaves_the_others_alone() {
    let g = |x: f64| 0.5 * x * ((2.0 + x) / (2.0 - x)).ln();
    for method in ["auto", "exact", "quadrature", "curve", "series"] {
        let done = run(&["eval", "2-sqrt(4-r^2)", "--quantity", "g", "--at", "0.5,2.5,1.25", "--method", method, "--json"]);
        let [Some(one), None, Some(other)] = values(&done)[..] else { panic!("{method}: {done:?}") };
        let document: Value = serde_json::from_slice(&done.stdout).unwrap();
        for (index, value, truth) in [(0, one, g(0.5)), (2, other, g(1.25))] {
            let error = document["points"][index]["error_estimate"].as_f64().unwrap();
            assert!((value - truth).abs() <= error + 2.0 * f64::EPSILON * truth && error < 1e-6, "{method}: {value} {truth} {error}");
        }
        assert!(document["points"][1]["why"].as_str().unwrap().contains("which ends at r = 2"), "{method}");
        let done = run(&["eval", "2-sqrt(4-r^2)", "--quantity", "g", "--at", "2.5", "--method", method, "--json"]);
        assert!(done.status.code() == Some(2) && done.stdout.is_empty(), "{method}: {done:?}");
    }
}

/// Class "a number beyond a pole": g of tan(r) at 1.9 was 3.5e14 with exit code 0. The ends are by mpmath.
#[test]
fn places_beyond_a_pole_are_bad_input() {
    for (profile, at, end) in [
        ("tan(r)", "1.9", FRAC_PI_2),
        ("tan(3*r)", "0.6", FRAC_PI_6),
        ("1/cos(r)", "2", FRAC_PI_2),
        ("1/(2-exp(r))", "0.8", LN_2),
        ("r^2/(1-1.4*tanh(r))", "1", 0.8958797346140275),
        ("1/sin(1+r)", "2.5", 2.141592653589793),
        ("1/besselj(0,r)", "3", 2.404825557695773),
        ("r*atanh(r/2)", "2.5", 2.0),
        ("r^2/(3-cosh(r))", "1.9", 1.762747174039086),
    ] {
        for quantity in ["g", "F"] {
            let done = run(&["eval", profile, "--quantity", quantity, "--at", at]);
            let told = String::from_utf8(done.stderr).unwrap();
            assert_eq!(done.status.code(), Some(2), "{profile}: {told}");
            let named = told.split("which ends at r = ").nth(1).and_then(|own| own.trim().parse::<f64>().ok());
            assert!(done.stdout.is_empty() && named.is_some_and(|own| (own / end - 1.0).abs() < 4e-16), "{profile} {quantity}: {told}");
        }
    }
}

/// Class "no contact radius where there is one": the radius that is found has the depth, and one depth without a radius leaves the others.
#[test]
fn radii_are_found_with_values_of_the_parameters() {
    for (profile, sets, depths) in [
        ("h*(1-exp(-r^2/w^2))", &["h=1", "w=0.1"][..], &["0.3", "1.076", "1.28", "1.3"][..]),
        ("h*(1-exp(-r^2/w^2))", &["h=1", "w=0.5"], &["1.076", "1.3"]),
        ("h*sin(pi*r/l)^2", &["h=2e-9", "l=5e-8"], &["1e-9", "2.9e-9"]),
        ("h*(1-1/cosh(r/w))", &["h=1e-9", "w=3e-9"], &["8e-10"]),
        ("h*(1-1/(1+(r/w)^2))", &["h=3e-9", "w=2e-8"], &["2e-9"]),
        ("-h*ln(cos(r/w))", &["h=1e-9", "w=1e-8"], &["1e-9", "1e-8"]),
        ("c*(cosh(r/c)-1)", &["c=1e-3"], &["1e-6", "1", "1e100"]),
        ("c*(cosh(r/c)-1)", &["c=1e-6"], &["1e-3", "5"]),
        ("R-(R^n-r^n)^(1/n)", &["R=1e-6", "n=4"], &["1e-9", "9e-7"]),
        ("R*acos(1-r/R)-sqrt(2*R*r-r^2)", &["R=1"], &["0.3", "2.9"]),
    ] {
        let set: Vec<&str> = sets.iter().flat_map(|own| ["--set", own]).collect();
        let radii = run(&[&["eval", profile, "--quantity", "a", "--json", "--at", &depths.join(",")], &set[..]].concat());
        assert_eq!(radii.status.code(), Some(0), "{profile}: {}", String::from_utf8_lossy(&radii.stderr));
        for (depth, radius) in depths.iter().zip(values(&radii)) {
            let depth: f64 = depth.parse().unwrap();
            // The largest g of the first profile is 1.2849 h, by mpmath.
            let Some(a) = radius else {
                assert!(profile.contains("exp(-r^2") && depth == 1.3, "{profile} has no radius at {depth}");
                continue;
            };
            let back = values(&run(&[&["eval", profile, "--quantity", "d", "--json", "--at", &format!("{a:e}")], &set[..]].concat()));
            let found = back.first().copied().flatten().unwrap();
            assert!((found / depth - 1.0).abs() < 1e-14, "{profile}: d({a:e}) = {found:e} and not {depth:e}");
        }
    }
}

/// Class "eval and solve search differently": a depth as load of a scene and as a point of eval have the same radius.
#[test]
fn scenes_find_the_same_radii() {
    let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("ends");
    fs::create_dir_all(&place).unwrap();
    for (shape, profile, sets, depth) in [
        // Waves are refused by `solve`, because the contact would open.
        (
            "shape = \"flat-with-rounded-edge\"\nparameters = { b = \"1 um\", R = \"0.2 um\" }",
            "piecewise(0, r<b, (r-b)^2/(2*R))",
            &["b=1e-6", "R=2e-7"][..],
            1e-9,
        ),
        (
            "shape = \"flat-with-rounded-edge\"\nparameters = { b = \"30 nm\", R = \"5 um\" }",
            "piecewise(0, r<b, (r-b)^2/(2*R))",
            &["b=3e-8", "R=5e-6"],
            1e-7,
        ),
        ("f = \"R-(R^n-r^n)^(1/n)\"\nparameters = { R = \"2 um\", n = 3 }", "R-(R^n-r^n)^(1/n)", &["R=2e-6", "n=3"], 3e-8),
        ("f = \"R-(R^n-r^n)^(1/n)\"\nparameters = { R = \"2 um\", n = 4 }", "R-(R^n-r^n)^(1/n)", &["R=2e-6", "n=4"], 1.9e-6),
        ("f = \"c*(cosh(r/c)-1)\"\nparameters = { c = \"20 nm\" }", "c*(cosh(r/c)-1)", &["c=2e-8"], 1e-6),
        ("f = \"-h*ln(cos(r/w))\"\nparameters = { h = \"1 nm\", w = \"10 nm\" }", "-h*ln(cos(r/w))", &["h=1e-9", "w=1e-8"], 1e-8),
    ] {
        let scene = format!(
            "[profile]\n{shape}\n[material]\nE = \"72 GPa\"\nnu = 0.17\n[load]\ndepth = \"{depth:e} m\"\n[outputs]\n\
             units = {{ length = \"m\", force = \"N\", pressure = \"Pa\" }}\n"
        );
        fs::write(place.join("scene.toml"), scene).unwrap();
        let program =
            Command::new(env!("CARGO_BIN_EXE_sneddon")).args(["solve", "scene.toml", "--json"]).current_dir(&place).output().unwrap();
        let document: Value = serde_json::from_slice(&program.stdout).unwrap();
        let solved = document["rows"][0]["a"].as_f64();
        let used: Vec<&str> = sets.iter().flat_map(|own| ["--set", own]).collect();
        let at = format!("{depth:e}");
        let found = values(&run(&[&["eval", profile, "--quantity", "a", "--json", "--at", &at], &used[..]].concat()))[0];
        let (solved, found) = (solved.unwrap(), found.unwrap());
        assert!((solved / found - 1.0).abs() < 1e-14, "{shape}: {solved:e} and {found:e}");
    }
}
