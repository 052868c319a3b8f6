//! `solve` as a page: the formulas of the shape and the values of a scene, read back from the tables of every notation.
#![cfg(all(feature = "cli", unix))]
#![allow(clippy::unwrap_used, clippy::panic)]

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

fn run(name: &str, scene: &str, arguments: &[&str]) -> Output {
    let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("pages");
    fs::create_dir_all(&place).unwrap();
    fs::write(place.join(name), scene).unwrap();
    Command::new(env!("CARGO_BIN_EXE_sneddon")).current_dir(&place).args(["solve", name]).args(arguments).output().unwrap()
}

fn page(name: &str, scene: &str, arguments: &[&str]) -> String {
    let done = run(name, scene, arguments);
    assert!(done.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8(done.stdout).unwrap()
}

/// Two loads on a sphere that is approximated by a paraboloid: F = (4/3) E* sqrt(R) d^(3/2), a = sqrt(R d).
const SCENE: &str = "
[profile]
f = 'r^2/(2*R)'
parameters = { R = '10 um' }
[material]
effective_modulus = '100 GPa'
[load]
depth = ['0.1 um', '0.4 um']
[outputs]
quantities = ['F', 'a', 'p']
at = ['0 um', '0.5 um']
units = { length = 'um', force = 'mN', pressure = 'GPa' }
";

#[test]
fn every_notation_has_formulas_and_values() {
    let force = |d: f64| 4.0 / 3.0 * 100.0 * 10.0_f64.sqrt() * d.powf(1.5);
    let pressure = |r: f64, d: f64| 2.0 / std::f64::consts::PI * 100.0 / 10.0 * (10.0 * d - r * r).sqrt();
    let formulas = [
        ("unicode", "F(a) = 4·E*·a³/(3·R)"),
        ("latex", "F(a) = \\frac{4 E^{*} a^{3}}{3 R}"),
        ("markdown", "F(a) = \\frac{4 E^{*} a^{3}}{3 R}"),
        ("typst", "F (a) = frac(4 E^* a^(3), 3 R)"),
        ("mathml", "<mi>R</mi>"),
    ];
    for (format, formula) in formulas {
        let text = page("scene.toml", SCENE, &["--format", format, "--precision", "8"]);
        assert!(text.contains(formula), "{format}: {text}");
        assert!(["10 µm", "10 $\\mu$m"].iter().any(|own| text.contains(own)), "{format}: {text}");
        for d in [0.1, 0.4] {
            for value in [force(d), (10.0 * d).sqrt(), pressure(0.0, d), pressure(0.5, d)] {
                // Eight digits, without zeros at the end.
                let digits = format!("{:.*}", 7 - value.log10().floor() as usize, value);
                let digits = digits.trim_end_matches('0').trim_end_matches('.');
                assert!(text.contains(digits), "{format}: {digits} in {text}");
            }
        }
    }
}

/// Class "a scene whose shape needs its numbers": two bodies, and a measured tip, which has values and no formulas.
#[test]
fn scenes_without_symbols_have_pages() {
    let two = SCENE.replace("[material]", "[counterbody]\nf = 'r^2/(2*R)'\nparameters = { R = '40 um' }\n[material]");
    let text = page("two.toml", &two, &["--format", "latex"]);
    assert!(text.contains("f(r) = \\frac{r^{2}}{16}") && text.contains("Lengths in the formulas are in $\\mu$m"), "{text}");
    let punch = SCENE
        .replace("f = 'r^2/(2*R)'\nparameters = { R = '10 um' }", "cross_section = 'square'\narea = '4 um^2'")
        .replace(", 'a', 'p'", "");
    let text = page("punch.toml", &punch, &["--format", "markdown"]);
    assert!(!text.contains("```math") && text.contains("| $d$ / µm | $F$ / mN |"), "{text}");
}

#[test]
fn rows_that_are_not_valid_say_so() {
    let scene = SCENE.replace("f = 'r^2/(2*R)'", "f = 'R-sqrt(R^2-r^2)'").replace("'0.4 um'", "'1 m'");
    let done = run("invalid.toml", &scene, &["--format", "markdown"]);
    let text = String::from_utf8(done.stdout).unwrap();
    assert_eq!(done.status.code(), Some(1));
    assert!(text.contains("| 1000000 |") || text.contains("$1000000$"), "{text}");
    assert!(text.contains("Not valid in 1 of 2 rows"), "{text}");
}

#[test]
fn a_whole_document_has_a_beginning_and_an_end() {
    let text = page("scene.toml", SCENE, &["--format", "latex", "--standalone"]);
    assert!(text.starts_with("\\documentclass") && text.trim_end().ends_with("\\end{document}"), "{text}");
    assert_eq!(text.matches("\\begin{tabular}").count(), 3);
    assert_eq!(text.matches("\\begin{tabular}").count(), text.matches("\\end{tabular}").count());
    for format in ["text", "json", "csv"] {
        let done = run("scene.toml", SCENE, &["--format", format, "--standalone"]);
        assert_eq!(done.status.code(), Some(2), "{format}");
    }
}
