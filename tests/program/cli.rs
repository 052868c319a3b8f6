//! The program as its users meet it: the real binary, its answers, its exit codes and what it says about bad input.
#![allow(clippy::unwrap_used)]

use serde_json::Value;
use sneddon::parse;
use sneddon_checks::seeds::cases;
use std::fs;
use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Stdio};

const PROGRAM: &str = env!("CARGO_BIN_EXE_sneddon");

struct Ran {
    code: i32,
    stdout: String,
    stderr: String,
}

fn run_with(stdin: &[u8], arguments: &[&str]) -> Ran {
    let mut command = Command::new(PROGRAM);
    command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    // The program may stop reading early.
    let _ = child.stdin.take().unwrap().write_all(stdin);
    let output = child.wait_with_output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    Ran { code: output.status.code().unwrap_or(-1), stdout: text(output.stdout), stderr: text(output.stderr) }
}

fn run(arguments: &[&str]) -> Ran {
    run_with(b"", arguments)
}

/// The JSON of a command that must succeed.
fn json(arguments: &[&str]) -> Value {
    let ran = run(arguments);
    assert_eq!(ran.code, 0, "{arguments:?}: {}", ran.stderr);
    serde_json::from_str(&ran.stdout).unwrap()
}

/// Exit code 2, nothing on stdout, a message on stderr that contains all `parts`.
fn refused(stdin: &[u8], arguments: &[&str], parts: &[&str]) {
    let ran = run_with(stdin, arguments);
    let shown = format!("{:.200}", format!("{arguments:?}"));
    assert_eq!(ran.code, 2, "{shown}: {} {}", ran.stdout, ran.stderr);
    assert!(ran.stdout.is_empty(), "{shown}: {}", ran.stdout);
    for part in parts {
        assert!(ran.stderr.contains(part), "{shown}: {part:?} is missing in {}", ran.stderr);
    }
    assert!(ran.stderr.len() < 2000, "{shown}: {}", ran.stderr);
}

#[test]
fn profiles_that_are_none() {
    let deep = format!("{}r{}", "(".repeat(60_000), ")".repeat(60_000));
    let signs = format!("{}r", "-".repeat(5000));
    let cases: &[(&str, &[&str])] = &[
        ("r^", &["column 3", "unexpected end", "| r^\n  |   ^\n", "help:"]),
        ("y = r^2", &["column 3", "'=' is not allowed", "right-hand side"]),
        ("piecewise((0, r<b), (r-b, True))", &["column 13", "write piecewise(v0, r<b, v1)"]),
        ("piecewise(0, r>b, r-b)", &["column 14", "upper bound of its variable"]),
        ("foo(r)", &["column 1", "unknown function foo", "\n  | ^^^\n", "help:"]),
        ("r^2/0", &["column 5", "divisor is 0", "\n  |     ^\n"]),
        ("2r", &["column 2", "operator is missing", "2*r"]),
        ("sqrt(-1-r^2)", &["not real", "^"]),
        ("piecewise(0, r<2, r, r<1, r)", &["column 22", "increase", "^^^"]),
        ("piecewise(0, r<b, 1)", &["jumps by 1 at r = b", "meet", "^^^"]),
        ("1/r", &["r = 0", "expected", "^^^"]),
        ("ln(r)", &["r = 0", "expected", "^^^"]),
        ("r^(-1)", &["r = 0", "expected", "^^^"]),
        ("r^(10^400)", &["column 3", "exponent", "1000000"]),
        ("x^2", &["reserved", "r"]),
        ("gamma*r", &["gamma_0"]),
        ("", &["expression is empty", "^"]),
        ("0", &["flat", "--depth"]),
        ("--jsn", &["unknown option --jsn", "--help"]),
        (&signs, &["column 1001", "1000", "^"]),
        (&deep, &["column 1001", "1000", "^"]),
    ];
    for (profile, parts) in cases {
        refused(b"", &["derive", profile], parts);
        refused(b"", &["compare", profile], parts);
        if !matches!(*profile, "0" | "piecewise(0, r<b, 1)") {
            refused(b"", &["eval", profile, "--quantity", "g", "--at", "1"], &parts[..1]);
        }
    }
    refused(b"", &["eval", "0", "--quantity", "F", "--at", "1"], &["flat", "--depth"]);
    refused(b"", &["eval", "0", "--quantity", "F_of_d", "--at", "1"], &["F(d) of a flat punch depends on the radius of its rim"]);
}

#[test]
fn stdin_that_is_no_profile() {
    let deep = format!("{}r{}", "(".repeat(100_000), ")".repeat(100_000));
    refused(b"", &["derive", "-"], &["expression is empty"]);
    refused(deep.as_bytes(), &["derive", "-"], &["1000 levels", "column 1001"]);
    refused(&vec![b'7'; 1 << 20], &["derive", "-"], &["10000", "digits"]);
    refused(&vec![0; 1 << 20], &["derive", "-"], &["U+0000", "column 1"]);
    refused(&vec![b'r'; (1 << 20) + 1], &["derive", "-"], &["1048576 bytes"]);
    refused(b"r^2\xff", &["derive", "-"], &["byte 4", "UTF-8"]);
    refused(b"r^2 +\n 2 $ r", &["derive", "-"], &["line 2, column 4", "'$'", "  |    ^\n"]);
}

#[cfg(target_os = "linux")]
#[test]
fn bad_input_needs_little_memory() {
    let deep = format!("{}r{}", "(".repeat(100_000), ")".repeat(100_000));
    let digits = "7".repeat(1 << 20);
    for text in [deep.as_str(), &digits, "(1+r)^1000000", "r^(10^400)"] {
        let mut command = Command::new("sh");
        command.args(["-c", "ulimit -v 204800 && exec \"$0\" derive -", PROGRAM]);
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        let _ = child.stdin.take().unwrap().write_all(text.as_bytes());
        let code = child.wait().unwrap().code();
        assert!(matches!(code, Some(0..=2)), "{code:?} for {:.40}", text);
    }
}

#[test]
fn a_huge_power_is_answered_or_refused_soon() {
    let ran = run(&["derive", "(1+r)^1000000"]);
    assert!((0..=2).contains(&ran.code) && !ran.stderr.contains("budget"), "{}", ran.stderr);
}

#[test]
fn settings_that_are_none() {
    let derive = |set: &str, parts: &[&str]| refused(b"", &["derive", "r^2/(2*R)", "--set", set], parts);
    derive("R=-1", &["not positive", "^^", "help:"]);
    derive("R=0", &["not positive"]);
    derive("R=nan", &["nan", "^^^", "0.3"]);
    derive("R=inf", &["inf"]);
    derive("R=", &["--set R"]);
    derive("R", &["NAME=VALUE"]);
    derive("R=1e400", &["64-bit"]);
    derive("S=1", &["no parameter S", "it has R"]);
    derive("r=1", &["no parameter r"]);
    refused(b"", &["derive", "r^2/(2*R)", "--set", "R=1", "--set", "R=2"], &["twice"]);
    refused(b"", &["eval", "C*r^n", "--quantity", "g", "--at", "1"], &["C, n", "--set C=VALUE --set n=VALUE"]);
    refused(b"", &["eval", "C*r^2", "--quantity", "g", "--at", "1"], &["the parameter C has no value"]);
    // A letter and its name are one parameter.
    assert_eq!(run(&["derive", "r*tan(theta)", "--set", "θ=0.3"]).code, 0);
}

#[test]
fn points_that_are_none() {
    let eval = |list: &str, parts: &[&str]| refused(b"", &["eval", "r^2", "--quantity", "g", "--at", list], parts);
    eval("1 2", &["column 1", "1 2 is not one number", "commas between them"]);
    eval("0.5,1;2", &["column 5", "1;2 is not one number", "commas between them"]);
    eval("", &["--at is empty", "start:stop:count"]);
    eval("-1", &["negative", "^^"]);
    eval("nan", &["nan"]);
    eval("1,inf", &["inf"]);
    eval("1,,2", &["missing", "^"]);
    eval("1:2:0", &["0 points"]);
    eval("0:1:10000001", &["1000000"]);
    eval("log:0:1:5", &["must be positive"]);
    let sphere = ["eval", "R-sqrt(R^2-r^2)", "--set", "R=2", "--quantity"];
    for (quantity, at) in [("g", "2"), ("F", "2.5"), ("d", "2:3:4"), ("G", "2"), ("U", "2"), ("k", "2")] {
        refused(b"", &[&sphere[..], &[quantity, "--at", at]].concat(), &["domain", "2"]);
    }
    refused(b"", &[&sphere[..], &["p", "--at", "0.5", "--radius", "2"]].concat(), &["domain"]);
    refused(b"", &[&sphere[..], &["p", "--at", "0.5"]].concat(), &["--radius"]);
    refused(b"", &[&sphere[..], &["u", "--at", "0.5"]].concat(), &["--radius"]);
    refused(b"", &[&sphere[..], &["p", "--at", "0.5", "--radius", "-1"]].concat(), &["not positive"]);
    refused(b"", &[&sphere[..], &["g", "--at", "0.5", "--effective-modulus", "0"]].concat(), &["not positive"]);
    refused(b"", &[&sphere[..], &["g", "--at", "0.5", "--tol", "2"]].concat(), &["--tol"]);
    refused(b"", &[&sphere[..], &["z", "--at", "0.5"]].concat(), &["--quantity"]);
    refused(
        b"",
        &["eval", "h*(1-cos(k*r))^(1/3)*r", "--quantity", "g", "--at", "1", "--method", "exact", "--set", "h=1", "--set", "k=1"],
        &["closed form"],
    );
}

#[test]
fn derive_answers_by_the_agreed_keys() {
    let answer = json(&["derive", "r^2/(2*R)", "--json"]);
    assert_eq!(answer["profile"]["text"], "r^2/(2*R)");
    assert!(answer["profile"]["latex"].is_string());
    assert!(answer["conditions"].as_array().unwrap().iter().any(|c| c.as_str().unwrap().contains("d = g(a)")));
    for key in ["g", "d", "F", "p", "k", "a_of_d", "F_of_d"] {
        let formula = &answer[key];
        assert!(formula["text"].is_string() && formula["latex"].is_string(), "{key}");
        assert_eq!(formula["status"], "exact", "{key}");
        assert!(formula["rules"].is_array() && formula["reference"].is_array(), "{key}");
    }
    assert_eq!(answer["g"]["text"], "x^2/R");
    assert_eq!(answer["k"]["text"], "2*E*a");
    assert_eq!(answer["check"]["points"], 64);
    assert_eq!(answer["check"]["passed"], true);
    assert_eq!(answer["check"]["verdict"], "passed");
    let open = json(&["derive", "ln(cosh(r))", "--json"]);
    assert_eq!((&open["check"]["verdict"], &open["check"]["passed"]), (&Value::from("not compared"), &Value::Null));
    assert!(open["check"]["why"].as_str().is_some_and(|why| why.contains("closed")));
    assert!(answer["check"]["max_relative_difference"].as_f64().unwrap() < 1e-12);
    // The two ways to ask for JSON are one.
    assert_eq!(run(&["derive", "r^2", "--json"]).stdout, run(&["derive", "r^2", "--format", "json"]).stdout);
    // What has no explicit form is null.
    let sphere = json(&["derive", "R-sqrt(R^2-r^2)", "--json"]);
    assert!(sphere["a_of_d"].is_null() && sphere["F_of_d"].is_null());
    assert!(sphere["conditions"].as_array().unwrap().iter().any(|c| c == "r < R"));
}

#[test]
fn derive_reads_stdin_minus_signs_and_settings() {
    let plain = run(&["derive", "-h*r^2/c^2"]);
    assert_eq!(plain.code, 0, "{}", plain.stderr);
    assert!(plain.stdout.contains("g(x) = -2*h*x^2/c^2"), "{}", plain.stdout);
    assert_eq!(run_with(b"-h*r^2/c^2\n", &["derive", "-"]).stdout, plain.stdout);
    assert_eq!(run(&["derive", "--", "-h*r^2/c^2"]).stdout, plain.stdout);
    let help = run(&["derive", "-h"]);
    assert!(help.code == 0 && help.stdout.contains("Usage"));
    let set = json(&["derive", "C*r^4", "--set", "C=0.7", "--json"]);
    assert_eq!(set["profile"]["text"], "0.7*r^4");
    let shifted = json(&["derive", "h+r^2", "--json"]);
    assert_eq!(shifted["shift"]["text"], "h");
    assert!(run(&["derive", "h+r^2"]).stdout.contains("f(0) = h"));
}

#[test]
fn derive_with_a_rim() {
    let flat = json(&["derive", "0", "--depth", "d", "--json"]);
    assert_eq!(flat["F"]["text"], "2*E*a*d");
    assert_eq!(flat["d"]["text"], "d");
    assert!(flat["p"]["text"].as_str().unwrap().contains("sqrt(a^2 - r^2)"));
    assert!(flat["conditions"].as_array().unwrap().iter().any(|c| c.as_str().unwrap().contains("rim")));
    let number = json(&["derive", "0", "--depth", "3/2", "--json"]);
    assert_eq!(number["F"]["text"], "3*E*a");
    refused(b"", &["derive", "0", "--depth", "q"], &["q", "^"]);
}

#[test]
fn derive_sets_latex() {
    let ran = run(&["derive", "1+r^2/(2*R)", "--format", "latex"]);
    assert_eq!(ran.code, 0);
    for part in ["% condition: smooth edge: $d = g(a)$", "% $f(0) = 1$", "\\begin{align*}", "  g(x) &= ", "  F(d) &= ", "\\end{align*}"] {
        assert!(ran.stdout.contains(part), "{part}: {}", ran.stdout);
    }
    assert_eq!(ran.stdout.matches("\\\\\n").count(), 7, "{}", ran.stdout);
}

#[test]
fn text_is_made_to_be_read() {
    let ran = run(&["derive", "R-sqrt(R^2-r^2)"]);
    for part in [
        "f(r) = R - sqrt(R^2 - r^2)",
        "g(x) = ",
        "exact | rule sphere",
        "Popov",
        "r < R",
        "0 <= x",
        "effective modulus",
        "-sigma_zz",
        "64 points",
        "passed",
    ] {
        assert!(ran.stdout.contains(part), "{part}: {}", ran.stdout);
    }
    let table = run(&["eval", "1+r^2", "--quantity", "g", "--at", "0.5,10"]).stdout;
    assert!(table.contains("f(0) = 1"), "{table}");
    let words: Vec<Vec<&str>> = table.lines().map(|line| line.split_whitespace().collect()).collect();
    assert!(words.contains(&vec!["x", "g", "error", "method"]), "{table}");
    assert!(words.iter().any(|line| line.starts_with(&["0.5", "0.5"])), "{table}");
}

/// κ_n against 30-digit values of mpmath, and against the formula that a power-law profile has.
#[test]
fn kappa_tabulates_the_constants_of_powers() {
    let answer = json(&["kappa", "--at", "0.5,1.5,2.5,7.3,121,1e5", "--json"]);
    let expected = [
        1.311_028_777_146_059_9,
        1.797_210_352_103_388_3,
        2.185_047_961_910_1,
        3.503_877_742_323_193,
        13.814_969_044_106_28,
        396.333_720_593_664,
    ];
    for (point, expected) in answer["points"].as_array().unwrap().iter().zip(expected) {
        let (value, error) = (point["value"].as_f64().unwrap(), point["error_estimate"].as_f64().unwrap());
        assert!((value - expected).abs() <= error && error < 4e-15 * expected, "{point}: expected {expected}");
    }
    let exact = json(&["kappa", "--at", "0:9:10", "--json"]);
    for (n, point) in exact["points"].as_array().unwrap().iter().enumerate().skip(1) {
        let g = json(&["derive", &format!("r^{n}"), "--quantity", "g", "--json"]);
        let power = if n == 1 { "x".to_owned() } else { format!("x^{n}") };
        let (of_g, kappa) = (g["g"]["text"].as_str().unwrap(), point["exact"].as_str().unwrap());
        assert_eq!(parse::formula(of_g), parse::formula(&format!("({kappa})*{power}")), "n = {n}");
    }
    assert!(run(&["kappa", "--at", "2"]).stdout.contains("2  2        0      2"), "{}", run(&["kappa", "--at", "2"]).stdout);
    refused(b"", &["kappa", "--at", "-1"], &["the point -1 is negative"]);
    refused(b"", &["kappa", "--at", "1 um"], &["is a length, not a plain number"]);
}

#[test]
fn eval_answers_by_the_agreed_keys() {
    let answer = json(&["eval", "r^2/(2*R)", "--quantity", "F", "--at", "0.1,3", "--set", "R=2", "--effective-modulus", "4", "--json"]);
    assert_eq!(answer["quantity"], "F");
    assert_eq!(answer["method"], "exact");
    assert_eq!(answer["effective_modulus"], 4.0);
    let points = answer["points"].as_array().unwrap();
    assert_eq!(points[1]["at"], 3.0);
    assert_eq!(points[1]["value"], 72.0);
    assert_eq!(points[1]["method"], "exact");
    assert_eq!(points[1]["evaluations"], 0);
    assert!(points[1]["error_estimate"].as_f64().unwrap() < 1e-13);
    let quadrature = json(&["eval", "r^2", "--quantity", "g", "--at", "1", "--method", "quadrature", "--json"]);
    assert_eq!(quadrature["method"], "quadrature");
    assert!(quadrature["points"][0]["evaluations"].as_u64().unwrap() > 0);
}

#[test]
fn infinite_values_are_null_with_a_reason() {
    let cone = json(&["eval", "r", "--quantity", "p", "--at", "0,0.5", "--radius", "1", "--json"]);
    assert!(cone["points"][0]["value"].is_null());
    assert!(cone["points"][0]["why"].as_str().unwrap().contains("apex"));
    assert!(cone["points"][1]["value"].is_number() && cone["points"][1].get("why").is_none());
    let punch = json(&["eval", "0", "--quantity", "p", "--at", "0,1,2", "--radius", "1", "--depth", "0.1", "--json"]);
    assert!(punch["points"][1]["why"].as_str().unwrap().contains("rim"));
    assert_eq!(punch["points"][2]["value"], 0.0);
    let table = run(&["eval", "r", "--quantity", "p", "--at", "0", "--radius", "1"]).stdout;
    assert!(table.contains("apex"), "{table}");
}

#[test]
fn every_quantity_of_a_paraboloid() {
    // f = r²/2: g = x², F = 4a³/3, G = a³/3, U = 8a⁵/15, k = 2a, a = √d; p(0) = 2a/π, u(0) = d.
    let value = |quantity: &str, at: &str| {
        let answer = json(&["eval", "r^2/2", "--quantity", quantity, "--at", at, "--radius", "2", "--json"]);
        answer["points"][0]["value"].as_f64().unwrap()
    };
    let pi = std::f64::consts::PI;
    // u(r) = ((2a² − r²) asin(a/r) + a√(r² − a²))/π.
    let outside = ((8.0 - 9.0) * (2.0f64 / 3.0).asin() + 2.0 * 5.0f64.sqrt()) / pi;
    let expected = [
        ("f", "2", 2.0),
        ("g", "2", 4.0),
        ("d", "2", 4.0),
        ("F", "2", 32.0 / 3.0),
        ("p", "0", 4.0 / pi),
        ("u", "0", 4.0),
        ("u", "3", outside),
        ("k", "2", 4.0),
        ("G", "2", 8.0 / 3.0),
        ("U", "2", 256.0 / 15.0),
        ("a", "4", 2.0),
    ];
    for (quantity, at, want) in expected {
        let got = value(quantity, at);
        assert!((got - want).abs() <= 1e-12 * want, "{quantity}({at}) = {got}, not {want}");
    }
}

#[test]
fn a_falling_profile_is_answered_with_a_warning() {
    let ran = run(&["eval", "-r^2", "--quantity", "F", "--at", "1"]);
    assert_eq!(ran.code, 0);
    assert!(ran.stderr.contains("warning") && ran.stderr.contains("no valid contact"), "{}", ran.stderr);
    assert!(run(&["eval", "r^2", "--quantity", "F", "--at", "1"]).stderr.is_empty());
}

#[test]
fn compare_answers_by_the_agreed_keys_and_fails_with_exit_code_one() {
    let answer = json(&["compare", "R-sqrt(R^2-r^2)", "--json"]);
    for key in ["g", "d", "F", "p", "G"] {
        let own = &answer[key];
        assert!(own["max_relative_difference"].as_f64().unwrap() < 1e-11, "{key}: {own}");
        assert!(own["at"].is_number() && own["points"] == 64 && own["passed"] == true, "{key}: {own}");
    }
    let set = json(&["compare", "C*r^4", "--set", "C=0.7", "--radius", "2", "--tol", "1e-9", "--json"]);
    assert!(set["p"]["at"].as_f64().unwrap() < 2.0);
    assert_eq!(json(&["compare", "0", "--depth", "0.1", "--json"])["F"]["passed"], true);
    let strict = run(&["compare", "R-sqrt(R^2-r^2)", "--tol", "1e-30", "--json"]);
    assert_eq!(strict.code, 1, "{}", strict.stderr);
    assert_eq!(serde_json::from_str::<Value>(&strict.stdout).unwrap()["F"]["passed"], false);
    assert!(run(&["compare", "R-sqrt(R^2-r^2)", "--tol", "1e-30"]).stdout.contains("FAILED"));
}

/// Class "a comparison without points passes": nothing closed, so nothing is compared, and the exit code is 1.
#[test]
fn a_comparison_without_points_does_not_pass() {
    for profile in ["ln(cosh(r))", "h*sqrt(sqrt(r^2+w^2)-w)", "(1-exp(-r))/r"] {
        let ran = run(&["compare", profile, "--json"]);
        assert_eq!(ran.code, 1, "{profile}: {}", ran.stderr);
        let answer: Value = serde_json::from_str(&ran.stdout).unwrap();
        for key in ["g", "d", "F", "p", "G"] {
            let own = &answer[key];
            assert!(own["points"] == 0 && own["passed"].is_null() && own["verdict"] == "not compared" && own["why"].is_string(), "{own}");
        }
        let shown = run(&["compare", profile]);
        assert!(shown.code == 1 && !shown.stdout.contains("passed"), "{}", shown.stdout);
    }
    // What is closed beside what is not is compared, and decides.
    let partial = run(&["compare", "min(r*tan(theta),h)", "--json"]);
    let answer: Value = serde_json::from_str(&partial.stdout).unwrap();
    assert_eq!((partial.code, &answer["g"]["verdict"], &answer["p"]["verdict"]), (0, &"passed".into(), &"not compared".into()));
}

/// Returns the verdict of the check of `derive`, and whether g, d, F and p were compared.
fn compared(profile: &str) -> (String, [bool; 4]) {
    let derived = json(&["derive", profile, "--json"]);
    let verdict = derived["check"]["verdict"].as_str().unwrap().to_owned();
    (verdict, ["g", "d", "F", "p"].map(|key| derived[key]["compared"].as_bool().unwrap()))
}

/// Class "a comparison without digits passes": the quadrature of a power just above 0 has none, as the check of `derive` says too.
#[test]
fn a_comparison_without_digits_does_not_pass() {
    for profile in ["r^0.001", "r^0.005", "r^0.01", "r^0.03", "r^(1/200)"] {
        let ran = run(&["compare", profile, "--json"]);
        let answer: Value = serde_json::from_str(&ran.stdout).unwrap();
        assert_eq!((ran.code, &answer["g"]["points"], &answer["g"]["verdict"]), (1, &0.into(), &"not compared".into()), "{profile}");
        assert_eq!(compared(profile), ("not compared".to_owned(), [false; 4]), "{profile}");
    }
}

/// Class "a closed form that cancels next to the axis is not compared": farther out it has digits, for `derive` and `compare` alike.
#[test]
fn a_form_that_cancels_next_to_the_axis_is_compared_farther_out() {
    for profile in ["r^30*sinh(r)", "r^31*sinh(r)", "h*r^40*(cosh(r/w)-1)", "r^20*besselj(0,r)"].into_iter().step_by(cases(2, 1)) {
        let answer = json(&["compare", profile, "--json"]);
        assert_eq!((&answer["g"]["verdict"], &answer["F"]["verdict"]), (&"passed".into(), &"passed".into()), "{profile}");
        let (verdict, [g, d, force, _]) = compared(profile);
        assert!(verdict == "passed" && g && d && force, "{profile}");
    }
}

/// Class "the gate does not compare what the check compares": powers that underflow or overflow at some of its radii.
#[test]
fn high_powers_are_compared() {
    for profile in ["r^1000", "C*r^800", "r^300+r^2", "(1+r/b)^90", "r^(1001/2)"].into_iter().step_by(cases(2, 1)) {
        assert_eq!(compared(profile), ("passed".to_owned(), [true; 4]), "{profile}");
    }
    // Next to a kink f′ as a polynomial has no digits; pressures of high powers beyond a kink are integrals.
    for profile in
        ["exp(r^2)*r^40", "piecewise(0,r<b,(r-b)^20)", "max(0,r-b)^30", "piecewise(0,r<0.7,(r-0.7)^24)", "max(r,b)^50", "max(r,b)^100"]
            .into_iter()
            .step_by(cases(3, 1))
    {
        assert_eq!(compared(profile), ("passed".to_owned(), [true, true, true, false]), "{profile}");
    }
}

/// Class "a formula of many pages exhausts the budget": g is left as an integral, and its numbers come from quadrature.
#[test]
fn endless_formulas_are_left_as_integrals() {
    for profile in ["(1+r/b)^60.5", "(1+r/b)^(101/2)", "(1-r/b)^(141/2)"].into_iter().step_by(cases(3, 1)) {
        if cases(false, true) {
            let derived = json(&["derive", profile, "--json"]);
            assert_eq!((&derived["g"]["status"], &derived["k"]["status"]), (&"numeric".into(), &"exact".into()), "{profile}");
        }
        // g = n (π/2) x/b up to the share (n−1) (2/π) x/b, which is 4.5e-11 for the largest n.
        let point = &json(&["eval", profile, "--set", "b=1", "--quantity", "g", "--at", "1e-12", "--json"])["points"][0];
        let exponent = profile.rsplit('^').next().unwrap().trim_matches(['(', ')']);
        let exponent = exponent
            .split_once('/')
            .map_or_else(|| exponent.parse().unwrap(), |(p, q)| p.parse::<f64>().unwrap() / q.parse::<f64>().unwrap());
        let sign = if profile.contains('-') { -1.0 } else { 1.0 };
        let ratio = point["value"].as_f64().unwrap() / (sign * exponent * std::f64::consts::FRAC_PI_2 * 1e-12);
        assert!(point["method"] == "quadrature" && (ratio - 1.0).abs() < 5e-11, "{profile}: {ratio}");
    }
}

/// A value that is too large is told as that, and no other reason.
#[test]
fn a_comparison_says_why_there_is_none() {
    let answer = run(&["compare", "r^2", "--radius", "1e150", "--json"]);
    let answer: Value = serde_json::from_str(&answer.stdout).unwrap();
    assert!(answer["F"]["points"] == 0 && answer["F"]["why"].as_str().unwrap().contains("too large"), "{answer}");
}

/// Class "an expensive profile is not compared": fewer points of it are, by `derive` and `compare` alike, and a smaller budget says that it cut them.
#[test]
fn expensive_profiles_are_compared_at_fewer_points() {
    for profile in ["(1-r/b)^70", "(1-r/b)^76", "(1-r/b)^88"].into_iter().step_by(cases(3, 1)) {
        let check = &json(&["derive", profile, "--json"])["check"];
        assert!(check["verdict"] == "passed" && (1..64).contains(&check["points"].as_u64().unwrap()), "{profile}: {check}");
        if cases(false, true) {
            let answer = json(&["compare", profile, "--json"]);
            assert!(
                answer["g"]["verdict"] == "passed" && (1..64).contains(&answer["g"]["points"].as_u64().unwrap()),
                "{profile}: {answer}"
            );
        }
        let cut = run(&["compare", profile, "--json", "--budget", "0.7"]);
        let answer: Value = serde_json::from_str(&cut.stdout).unwrap();
        assert_eq!((cut.code, &answer["complete"]), (1, &false.into()), "{profile}: {answer}");
    }
}

/// Class "a call that was cut short is called bad input": one place or several without the budget for any.
#[test]
fn a_call_that_was_cut_short_says_so() {
    for places in ["0.1,0.5", "0.1", "0.1,0.2,0.5"].into_iter().take(cases(1, 3)) {
        let cut = run(&["eval", "r^3*sin(1/r)", "--quantity", "U", "--at", places, "--json", "--budget", "0.3"]);
        let answer: Value = serde_json::from_str(&cut.stdout).unwrap();
        assert_eq!((cut.code, &answer["complete"]), (1, &false.into()), "{places}: {answer} {}", cut.stderr);
    }
}

/// Each formula of `derive` says whether its closed forms met a quadrature.
#[test]
fn formulas_say_whether_they_were_compared() {
    let of = |profile: &str| json(&["derive", profile, "--json"]);
    let open = of("r^0.001");
    assert!(["g", "d", "p", "a_of_d"].iter().all(|key| open[key]["status"] == "exact" && open[key]["compared"] == false), "{open}");
    assert!(run(&["derive", "r^0.001"]).stdout.contains("exact, not compared with quadrature | rule"));
    let sphere = of("R-sqrt(R^2-r^2)");
    assert!(["g", "d", "F", "p", "k"].iter().all(|key| sphere[key]["compared"] == true), "{sphere}");
    assert_eq!(of("ln(cosh(r))")["F"]["compared"], false);
}

#[test]
fn rules_are_listed() {
    let document = json(&["rules", "--json"]);
    let list = document["rules"].as_array().unwrap();
    assert!(list.iter().any(|rule| rule["id"] == "heß-power"));
    for rule in list {
        for key in ["id", "name", "title", "pattern", "guard"] {
            assert!(rule[key].is_string(), "{key}: {rule}");
        }
        assert!(rule["result"]["g"].is_string() && rule["result"]["F"].is_string() && rule["source"].is_array(), "{rule}");
    }
    assert!(run(&["rules"]).stdout.contains("C*r^n"));
}

#[test]
fn catalogue_values_are_right_to_their_own_error_estimates() {
    let truth: Value = serde_json::from_str(include_str!("../data/truth.json")).unwrap();
    let profiles: Value = serde_json::from_str(include_str!("../data/profiles.json")).unwrap();
    let mut problems = Vec::new();
    for entry in profiles.as_array().unwrap().iter().step_by(cases(4, 1)) {
        let (id, f) = (entry["id"].as_str().unwrap(), entry["f"].as_str().unwrap());
        let sets: Vec<String> =
            entry["params"].as_object().unwrap().iter().map(|(k, v)| format!("--set={k}={}", v.as_str().unwrap())).collect();
        let own = &truth[id];
        let a = own["a"].as_str().unwrap();
        let table = |key: &str| -> Vec<(String, f64)> {
            own[key].as_object().unwrap().iter().map(|(at, value)| (at.clone(), value.as_str().unwrap().parse().unwrap())).collect()
        };
        let at_edge = |key: &str| vec![(a.to_owned(), own[key].as_str().unwrap().parse().unwrap())];
        for (quantity, wanted) in [("g", table("g")), ("d", at_edge("d")), ("F", at_edge("F")), ("G", at_edge("G")), ("p", table("p"))] {
            let list = wanted.iter().map(|(at, _)| at.as_str()).collect::<Vec<_>>().join(",");
            let mut arguments = vec!["eval", f, "--quantity", quantity, "--at", &list, "--radius", a, "--json"];
            arguments.extend(sets.iter().map(String::as_str));
            let answer = json(&arguments);
            // The values are those of the decimals, the program answers at the doubles next to them: half an ulp of every
            // parameter, as often as the value follows it.
            let mut follows = vec![0.0; wanted.len()];
            for (name, value) in entry["params"].as_object().unwrap() {
                let nudged = value.as_str().unwrap().parse::<f64>().unwrap() * (1.0 + 1e-6);
                let own = format!("--set={name}={nudged}");
                let others = arguments.iter().map(|word| if word.starts_with(&format!("--set={name}=")) { own.as_str() } else { word });
                let near = json(&others.collect::<Vec<_>>());
                for (index, total) in follows.iter_mut().enumerate() {
                    let value = |from: &Value| from["points"][index]["value"].as_f64().unwrap();
                    *total += 1e6 * (value(&near) - value(&answer)).abs() * f64::EPSILON / 2.0;
                }
            }
            for (((at, want), point), follows) in wanted.iter().zip(answer["points"].as_array().unwrap()).zip(follows) {
                let value = point["value"].as_f64().unwrap();
                let estimate = point["error_estimate"].as_f64().unwrap();
                let (error, ulp) = ((value - want).abs(), f64::EPSILON * want.abs());
                // Next to the edge the pressure is steep: the rounding of r and a counts a/(a − r) times.
                let (r, a): (f64, f64) = (at.parse().unwrap(), a.parse().unwrap());
                let rounding = follows + ulp * if quantity == "p" { 4.0 + 2.0 * a / (a - r) } else { 4.0 };
                if error > estimate + rounding {
                    problems.push(format!("{id}: {quantity}({at}) = {value} is off by {error:e}, its estimate is {estimate:e}"));
                }
                if quantity != "p" && point["method"] == "exact" && error > follows + 4.0 * ulp {
                    problems.push(format!("{id}: {quantity}({at}) = {value}, a closed form, is off by {:.1} ulp", error / ulp));
                }
            }
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

#[test]
fn examples_in_the_help_run_as_pasted() {
    let mut seen = 0;
    for command in ["", "derive", "eval", "compare", "rules", "completions"] {
        let arguments: Vec<&str> = [command, "--help"].into_iter().filter(|a| !a.is_empty()).collect();
        let help = run(&arguments).stdout;
        let (_, examples) = help.split_once("Examples:").unwrap_or_else(|| panic!("no example in the help of {command}"));
        for line in examples.lines().map(str::trim).filter(|line| line.starts_with("sneddon ") || line.starts_with("echo ")) {
            let script = format!("sneddon() {{ '{PROGRAM}' \"$@\"; }}\n{line}");
            let output = Command::new("sh").args(["-c", &script]).output().unwrap();
            assert!(output.status.success(), "{line}: {}", String::from_utf8_lossy(&output.stderr));
            assert!(!output.stdout.is_empty(), "{line}");
            seen += 1;
        }
    }
    assert!(seen >= 10);
}

#[test]
fn help_version_and_wrong_usage() {
    assert_eq!(run(&["--help"]).code, 0);
    let version = run(&["--version"]);
    assert_eq!((version.code, version.stdout.trim()), (0, concat!("sneddon ", env!("CARGO_PKG_VERSION"))));
    for arguments in [&[][..], &["nonsense"], &["derive"], &["eval", "r"], &["derive", "r", "--jsn"], &["derive", "r", "--format", "html"]]
    {
        let ran = run(arguments);
        assert_eq!(ran.code, 2, "{arguments:?}");
        assert!(ran.stdout.is_empty() && !ran.stderr.is_empty(), "{arguments:?}");
    }
}

/// Words for quantities and endings of files are no keys; the error names the key that is meant.
#[test]
fn keys_are_suggested_for_words_and_endings() {
    for (word, key) in [("force", "F"), ("depth", "d"), ("contact_radius", "a"), ("Pressure", "p"), ("energy", "U"), ("contact area", "A")]
    {
        refused(b"", &["eval", "r^2", "--quantity", word, "--at", "1"], &[word, &format!("did you mean {key}?")]);
    }
    for (command, ending, key) in [("derive", "tex", "latex"), ("invert", "html", "mathml"), ("derive", "typ", "typst")] {
        refused(b"", &[command, "r^2", "--format", ending], &[ending, &format!("did you mean {key}?")]);
    }
    let ran = run(&["derive", "r^2", "--format", "foo"]);
    assert!(ran.code == 2 && !ran.stderr.contains("tip"), "{}", ran.stderr);
}

#[test]
fn a_reader_that_leaves_is_no_failure() {
    let script = format!("'{PROGRAM}' eval r^2 --quantity g --at 0:1:100000 --json | head -c 10");
    let output = Command::new("sh").args(["-c", &script]).output().unwrap();
    assert!(output.status.success());
    assert_eq!(output.stdout.len(), 10);
    assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn answers_do_not_change_from_run_to_run() {
    let arguments = ["derive", "r^2/(2*R)+r*tan(theta)+h*(1-cos(k*r))", "--json"];
    assert_eq!(run(&arguments).stdout, run(&arguments).stdout);
}

#[test]
fn invert_answers_in_the_form_of_derive() {
    let found = json(&["invert", "x*atanh(x/R)", "--json"]);
    assert_eq!(found["f"]["text"], "R - sqrt(R^2 - r^2)");
    assert_eq!(found["f"]["status"], "exact");
    assert_eq!(found["conditions"][0], "r < R");
    assert_eq!(found["check"]["passed"], true);
    assert_eq!(found["g"]["text"], "x*atanh(x/R)");
    assert!(found["f"]["rules"].is_array() && found["f"]["reference"].is_array() && found["points"].is_null());
    let points = json(&["invert", "x^2/R", "--set", "R=2", "--at", "1,2", "--json"]);
    assert_eq!(points["points"][1]["value"], 1.0);
    assert_eq!(points["points"][1]["method"], "exact");
    // x is a length; f = r²/(2R).
    let with_units = json(&["invert", "x^2/R", "--set", "R=20 nm", "--at", "1 nm, 4 nm", "--json"]);
    assert_eq!(with_units["points"][1]["value"], 0.4);
    let pressed = json(&["invert", "--pressure", "p_0*sqrt(1-r^2/a^2)", "--set", "a=2", "--json"]);
    assert_eq!(pressed["F"]["text"], "8*pi/3*p_0");
}

#[test]
fn what_cannot_be_inverted() {
    refused(b"", &["invert", "r^2"], &["column 1", "\n  | ^\n", "the coordinate of g is x"]);
    refused(b"", &["invert", "1/x"], &["no finite value at x = 0", "| ^^^"]);
    refused(b"", &["invert", "piecewise(0, x<1, 1)"], &["jumps by 1 at x = 1", "expected pieces with equal values"]);
    refused(b"", &["invert", "x^2/R", "--at", "1"], &["parameter R has no value"]);
    refused(b"", &["invert", "--pressure", "p_0*exp(-r)"], &["--pressure", "exp(-r)", "(a^2-r^2)^s"]);
    refused(b"", &["invert"], &["required"]);
    refused(b"x^2+", &["invert", "-"], &["column 5"]);
}

#[test]
fn the_series_way_tells_its_remainder() {
    let sphere = ["eval", "R-sqrt(R^2-r^2)", "--quantity", "F", "--at", "0.5", "--set", "R=2", "--effective-modulus", "3", "--json"];
    let exact = json(&sphere);
    let series = json(&[&sphere[..], &["--method", "series", "--order", "12"]].concat());
    assert_eq!(series["points"][0]["method"], "series");
    let value = |found: &Value, key: &str| found["points"][0][key].as_f64().unwrap();
    let off = (value(&series, "value") - value(&exact, "value")).abs();
    assert!(off <= value(&series, "error_estimate") && off > 0.0);
    let asked = ["eval", "r^2", "--quantity", "g", "--at", "1"];
    refused(b"", &[&asked[..], &["--order", "5"]].concat(), &["--order", "--method series"]);
    refused(b"", &[&asked[..], &["--method", "series", "--order", "0"]].concat(), &["--order 0", "| ^"]);
    refused(b"", &["eval", "r^2*ln(r)", "--quantity", "g", "--at", "1", "--method", "series"], &["logarithm", "not analytic"]);
    refused(b"", &["eval", "r^2", "--quantity", "U", "--at", "1", "--method", "series", "--order", "5"], &["no series is known for U"]);
    refused(b"", &["eval", "atan(r)", "--quantity", "g", "--at", "3", "--method", "series"], &["not proven to converge at x = 3"]);
}

/// Class "an error as long as its input": at most 300 characters in all and 120 in the first line, whatever was typed.
#[test]
fn errors_are_short() {
    let long = "A".repeat(5000);
    let cases = [
        "derive r^2 --quantity L",
        "L",
        "derive r^2 --L",
        "derive r^2 --set L",
        "derive r^2 --set R=L",
        "solve L",
        "eval r^2 --quantity g --at L",
        "eval r^2 --quantity g --at 1 --radius L",
        "derive r^2 -o L.xyz",
        "plot L",
        "derive r^2 --format L",
        "validate L L",
        "scene new L",
        "derive --shape L",
        "derive r^2 --symbols L",
        "derive r^2 --budget L",
        "derive L(",
        "derive L*r^2+@",
        "derive r^2+L@+L",
        "compare r^2 --tol L",
        "completions L",
        "eval R*r^2 --set R=1L --quantity g --at 1",
        "eval L*r^2 --quantity g --at 1",
    ];
    for case in cases {
        let arguments: Vec<String> = case.split(' ').map(|own| own.replace('L', &long)).collect();
        let ran = run(&arguments.iter().map(String::as_str).collect::<Vec<_>>());
        let first = ran.stderr.lines().next().unwrap_or_default().chars().count();
        assert!(ran.code == 2 && ran.stderr.chars().count() <= 300 && first <= 120, "{case}: {first} characters\n{}", ran.stderr);
        assert!(ran.stderr.starts_with("error"), "{case}: {}", ran.stderr);
    }
    // A long name leaves out neither the reason nor the place.
    let (path, names) = (format!("{}/x.toml", "d".repeat(139)), (1..40).map(|i| format!("+name_of_parameter_{i}*r^2")).collect::<String>());
    assert!(run(&["solve", &path]).stderr.contains("No such file"));
    assert!(
        run(&["eval", &format!("r^2{names}"), "--quantity", "g", "--at", "1"]).stderr.lines().next().unwrap().ends_with("have no values")
    );
    // What fits stands whole.
    let short = run(&["derive", "r^2+foo(r)+@"]).stderr;
    assert!(short.contains("  | r^2+foo(r)+@\n  |            ^\nhelp: "), "{short}");
    assert!(run(&[]).stderr.contains("Commands:"));
}

/// Class "a constant without a value after --set": it is named, whatever function or quotient has it.
#[test]
fn constants_without_a_value_are_named() {
    for (profile, set, named) in [
        ("r*tan(theta)", "theta=90 deg", "tan(pi/2)"),
        ("r*tan(theta)", "theta=270 deg", "tan(3*pi/2)"),
        ("r^2/tan(theta)", "theta=180 deg", "1/0"),
        ("r/ln(k)", "k=1", "1/0"),
        ("r^2/(k-1)^3", "k=1", "1/0^3"),
        ("r*atanh(k)", "k=1", "atanh(1)"),
        ("r*acos(k)", "k=2", "acos(2)"),
        ("r*sqrt(k-2)", "k=1", "sqrt(-1)"),
        ("r*gamma(k-2)", "k=1", "gamma(-1)"),
        ("piecewise(0, r<1/(k-1), r-1/(k-1))", "k=1", "1/0"),
    ] {
        for command in [&["eval", "--quantity", "F", "--at", "1"][..], &["derive"], &["code", "--lang", "c"], &["plot", "--radius", "1"]] {
            let arguments = [&command[..1], &[profile, "--set", set], &command[1..]].concat();
            refused(b"", &arguments, &[&format!("{named} has no finite real value")]);
        }
    }
    refused(b"", &["eval", "r*tan(pi/2)", "--quantity", "F", "--at", "1"], &["tan has no real value"]);
}

/// Angles in degrees are exact: F = (π/2) E* tan θ a² keeps its digits next to a right angle. References: mpmath, 30 digits.
#[test]
fn angles_in_degrees_are_exact() {
    for (angle, force) in [
        ("45 deg", std::f64::consts::FRAC_PI_2),
        ("89.9999999999 deg", 900_000_000_000.000_000_111_840_9),
        ("1e-9 deg", 2.741_556_778_080_377_4e-11),
        ("89 deg", 89.990_861_291_817_47),
    ] {
        let answer = json(&["eval", "r*tan(theta)", "--set", &format!("theta={angle}"), "--quantity", "F", "--at", "1", "--json"]);
        let number = |key: &str| answer["points"][0][key].as_f64().unwrap();
        assert!((number("value") - force).abs() <= number("error_estimate"), "{angle}: {answer}");
        assert!(number("error_estimate") < 1e-13 * force, "{angle}: {answer}");
    }
}

/// What an answer leaves out, or rests on, is told on stderr.
#[test]
fn warnings_name_what_is_not_used_or_not_valid() {
    let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("warnings");
    fs::create_dir_all(&place).unwrap();
    let scene = place.join("scene.toml");
    let text =
        "[profile]\nf = \"r^2\"\n[material]\neffective_modulus = 1\n[load]\ndepth = 0.02\n[outputs]\nquantities = [\"p\"]\nat = [0.05]\n";
    fs::write(&scene, text).unwrap();
    let scene = scene.to_str().unwrap();
    let data = place.join("data.csv");
    fs::write(&data, "d,F\n1,2\n").unwrap();
    refused(b"", &["solve", data.to_str().unwrap()], &["data.csv", "invalid TOML", "expected a scene file, and data only after it"]);
    for (arguments, said) in [
        (&["eval", "r^2", "--quantity", "F", "--at", "1", "--radius", "3"][..], "the radius is not used"),
        (&["eval", "r*tan(theta)", "--quantity", "F", "--at", "1", "--set", "theta=20"], "theta = 20 is not below 90 deg"),
        (&["eval", "1-cos(r)", "--quantity", "a", "--at", "1,3"], "g decreases beyond x = 2.5"),
        (&["eval", "1-cos(r)", "--quantity", "F_of_d", "--at", "3"], "g decreases beyond x = 2.5"),
        (&["eval", "1-cos(r)", "--quantity", "p", "--at", "1", "--radius", "7"], "g decreases beyond x = 2.6"),
        (&["code", "r^2", "--lang", "nanite", "--quantity", "g"], "a nanite model contains F(d) only"),
        (&["derive", "-r^2"], "g is negative: no valid contact with a smooth edge"),
        (&["eval", "-r^2", "--quantity", "F", "--at", "1"], "g decreases from x = 0 on"),
        (&["plot", "SCENE", "--radius", "0.1"], "--radius and --effective-modulus are not used"),
        (&["reference", "SCENE", "--grid", "0:0.2:5", "--box", "4"], "--box and --between are not used"),
        (&["reference", "SCENE", "--grid", "0:0.2:5", "--between"], "--box and --between are not used"),
    ] {
        let arguments: Vec<&str> = arguments.iter().map(|own| if *own == "SCENE" { scene } else { *own }).collect();
        let arguments = arguments.as_slice();
        let ran = run(arguments);
        assert!(ran.code == 0 && ran.stderr.contains(said), "{arguments:?}: {}", ran.stderr);
    }
    for arguments in [
        &["eval", "1-cos(r)", "--quantity", "a", "--at", "1"][..],
        &["eval", "r*tan(theta)", "--quantity", "F", "--at", "1", "--set", "theta=20 deg"],
        &["eval", "max(0,r-1)", "--quantity", "F", "--at", "0.5,2"],
        &["code", "r^2", "--lang", "nanite"],
        &["derive", "-h*r^2/c^2", "--depth", "d"],
        &["derive", "r^2-r^4/R^2"],
    ] {
        assert_eq!(run(arguments).stderr, "", "{arguments:?}");
    }
}

/// Class "a function of another language": the advice says how a profile has it; others are suggested only if they are near.
#[test]
fn functions_that_do_not_exist_are_near_or_foreign() {
    for (profile, advice) in [
        ("csc(r)", "write 1/sin(…)"),
        ("If(r<1,0,1)", "write piecewise("),
        ("Heaviside(r-1)", "write piecewise(0, r<b, value)"),
        ("sgrt(r)", "expected sqrt"),
        ("sine(r)", "expected sin or sinh"),
        ("foo(r)", "expected a function such as"),
        ("cosine(r)", "expected a function such as"),
    ] {
        refused(b"", &["eval", profile, "--quantity", "F", "--at", "1"], &["unknown function", advice]);
    }
}

/// A model for nanite has the name of its shape and the units of its parameters.
#[test]
fn models_for_nanite_have_the_key_and_the_units_of_their_shape() {
    let cases = [
        ("R-sqrt(R^2-r^2)", "sneddon_sphere", "sphere (sneddon)", r#"["Pa", "m", "", "m", "N"]"#),
        ("r/tan(alpha)", "sneddon_cone_alpha", "cone with alpha (sneddon)", r#"["Pa", "rad", "", "m", "N"]"#),
        ("C*r^n", "sneddon_power", "power law (sneddon)", r#"["Pa", "SI", "", "", "m", "N"]"#),
        ("c_2*r^2+c_0*sqrt(r)+h*r", "sneddon_", "f(r) = c_2*r^2 + h*r + c_0*sqrt(r)", r#"["Pa", "m^0.5", "m^-1", "", "", "m", "N"]"#),
        ("piecewise(0, r<b, k*(r-b)^2)", "sneddon_", "f(r) = piecewise(", r#"["Pa", "m", "m^-1", "", "m", "N"]"#),
    ];
    for (profile, key, name, units) in cases {
        let text = run(&["code", profile, "--lang", "nanite"]).stdout;
        let line = |start: &str| text.lines().find(|own| own.starts_with(start)).unwrap_or_else(|| panic!("{profile}: no {start}"));
        assert!(line("model_key = ").contains(&format!("\"{key}")), "{profile}: {}", line("model_key"));
        assert!(line("model_name = ").contains(name), "{profile}: {}", line("model_name"));
        assert_eq!(line("parameter_units = "), format!("parameter_units = {units}"), "{profile}");
    }
    let cap = run(&["code", "--shape", "cone-with-spherical-cap", "--lang", "nanite"]).stdout;
    let names = r#"["Young's Modulus", "Radius of the tip", "Angle between flank and surface", "Poisson's Ratio","#;
    assert!(cap.contains(&format!("parameter_names = {names}")), "{cap}");
    // The starting values satisfy b < R.
    let worn = run(&["code", "piecewise(0, r<b, sqrt(R^2-b^2)-sqrt(R^2-r^2))", "--lang", "nanite"]).stdout;
    assert!(worn.contains("\"R\", value=4e-6") && worn.contains("\"b\", value=1e-6"), "{worn}");
    let sphere = ["code", "R-sqrt(R^2-r^2)", "--lang", "nanite", "--set"];
    refused(b"", &[&sphere[..], &["R=5 um"]].concat(), &["is in SI units, but the lengths of --set are in um"]);
    assert_eq!(run(&[&sphere[..], &["R=5e-6 m"]].concat()).code, 0);
}

/// Class "a quantity as it is written in formulas".
#[test]
fn quantities_are_suggested_by_their_letters() {
    for typed in ["F(d)", "Fd", "F_d", "f_of_D"] {
        refused(b"", &["code", "r^2", "--lang", "c", "--quantity", typed], &["did you mean F_of_d?"]);
    }
    refused(b"", &["eval", "r^2", "--at", "1", "--quantity", "a(d)"], &["did you mean a?"]);
}

/// Comments of generated code state the unit of lengths, E, the conditions once and the largest depth; `octave` is MATLAB.
#[test]
fn comments_of_code_state_units_and_the_domain() {
    let worn = "piecewise(0, r<b, sqrt(R^2-b^2)-sqrt(R^2-r^2))";
    let text = run(&["code", worn, "--quantity", "F_of_d", "--lang", "octave"]).stdout;
    assert!(text.contains("% Domain: d >= 0, d at most the largest value of g, E > 0, R > 0, b > 0, b < R.\n"), "{text}");
    assert!(text.contains("% Units: lengths in one unit; E is the effective modulus, a pressure;"), "{text}");
    let text = run(&["code", worn, "--set", "R=5 um", "--quantity", "g,F", "--lang", "c"]).stdout;
    assert!(text.contains("// Units: all lengths in um.\n") && text.contains("F in the unit of E times um^2.\n"), "{text}");
    // The helpers, which are not requested, state the unit too; names of languages ignore case.
    let text = run(&["code", "--shape", "worn-sphere", "--set", "R=5 um", "--quantity", "F_of_d", "--lang", "C"]).stdout;
    assert!(text.contains("// Units: all lengths in um.\n") && !text.contains("the same unit"), "{text}");
    let text = run(&["code", "--shape", "cone-with-spherical-cap", "--quantity", "g", "--lang", "c"]).stdout;
    assert!(text.contains("// Domain: 0 <= x <= 1e100, R > 0, theta > 0, theta < pi/2.\n"), "{text}");
}

/// Class "a file that is named for another language".
#[test]
fn code_for_a_file_of_another_language_is_refused() {
    let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("languages");
    fs::create_dir_all(&place).unwrap();
    for (name, language) in [("tip.py", "c"), ("tip.f90", "python"), ("tip.m", "rust"), ("tip.rs", "nanite"), ("tip.h", "fortran")] {
        let path = place.join(name);
        refused(b"", &["code", "r^2", "--lang", language, "-o", path.to_str().unwrap()], &["has the extension of"]);
        assert!(!path.exists());
    }
}
