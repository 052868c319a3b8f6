//! Input as people have it: left sides, superscripts, roots, implied products, named shapes, and what is suggested where a name is wrong.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::panic)]

use serde_json::Value;
use sneddon::eval::constant_value;
use sneddon::expr::{Bindings, Expr};
use sneddon::parse;
use std::process::{Command, Output};

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_sneddon")).args(arguments).output().unwrap()
}

fn json(arguments: &[&str]) -> Value {
    let done = run(arguments);
    assert!(done.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&done.stderr));
    serde_json::from_slice(&done.stdout).unwrap()
}

fn refused(arguments: &[&str]) -> String {
    let done = run(arguments);
    let message = String::from_utf8(done.stderr).unwrap();
    assert!(done.status.code() == Some(2) && done.stdout.is_empty(), "{arguments:?}: {message}");
    message
}

#[test]
fn other_spellings_are_read() {
    for (typed, meant) in [
        ("f(r) = r^2/(2*R)", "r^2/(2*R)"),
        (" f ( r )=r^2/R", "r^2/R"),
        ("f = r^2/R", "r^2/R"),
        ("r²/(2*R)", "r^2/(2*R)"),
        ("R-√(R²-r²)", "R-sqrt(R^2-r^2)"),
        ("r³·w⁻¹⁰", "r^3/w^10"),
        ("r^2*√2", "r^2*sqrt(2)"),
        ("r^2/√R", "r^2/sqrt(R)"),
        ("h·rⁿ", "h*r^n"),
        ("−r²/R + r²", "-r^2/R+r^2"),
        ("√(r)²", "sqrt(r)^2"),
        ("2^r²", "2^(r^2)"),
    ] {
        assert_eq!(parse::profile(typed), parse::profile(meant), "{typed}");
        assert!(parse::profile(meant).is_ok(), "{meant}");
    }
    assert_eq!(parse::equivalent("g(x) = x²/R"), parse::equivalent("x^2/R"));
    assert_eq!(parse::pressure("p(r) = p_0*√(1-r²/a²)"), parse::pressure("p_0*sqrt(1-r^2/a^2)"));
    // A root whose end is not clear, and signs that are no exponents.
    for typed in ["√R²*r", "√r^2", "√√r", "√", "√-r", "√2r", "r²⁻", "r⁻", "√sin(r)", &"√".repeat(100_000)] {
        assert!(parse::profile(typed).is_err(), "{:.20}", typed);
    }
}

/// What the help says, taken word for word, is the profile that was meant.
#[test]
fn advice_can_be_followed_literally() {
    for (typed, meant) in [
        ("r^2/2R", "r^2/(2*R)"),
        ("r²/2R", "r^2/(2*R)"),
        ("r^2/(2R)", "r^2/(2*R)"),
        ("2r", "2*r"),
        ("r^2/2R^2", "r^2/(2*R^2)"),
        ("r^2/2 R h", "r^2/(2*R*h)"),
        ("r^2/2R + r^4/8R^3", "r^2/(2*R)+r^4/(8*R^3)"),
        ("r^2/R^2 h", "r^2/(R^2*h)"),
        ("r tan θ", "r*tan(theta)"),
        ("r tan(θ)", "r*tan(theta)"),
        ("r/tan θ", "r/tan(theta)"),
        ("1/2 r^2", "1/2*r^2"),
        ("1/2r^2", "1/2*r^2"),
        ("h(1-cos(2 pi r/w))", "h*(1-cos(2*pi*r/w))"),
        ("R(1-sqrt(1-r^2/R^2))", "R*(1-sqrt(1-r^2/R^2))"),
        ("r^2/2(R+h)", "r^2/(2*(R+h))"),
        ("f(r) = r^2/2R", "r^2/(2*R)"),
        ("2 sin r", "2*sin(r)"),
        ("h r^2/c^2", "h*r^2/c^2"),
        ("exp(-r^2/2w^2) - 1", "exp(-r^2/(2*w^2))-1"),
        ("r^2R", "r^2*R"),
    ] {
        let error = parse::profile(typed).unwrap_err();
        let advice = error.accepted().strip_prefix("write ").unwrap_or_else(|| panic!("{typed}: {}", error.accepted()));
        assert_eq!(parse::profile(advice), parse::profile(meant), "{typed}: {advice}");
        assert!(parse::profile(meant).is_ok(), "{meant}");
    }
}

#[test]
fn named_shapes_are_profiles() {
    let named = json(&["derive", "--shape", "sphere", "--json"]);
    let typed = json(&["derive", "R-sqrt(R^2-r^2)", "--json"]);
    assert_eq!(named, typed);
    let named = json(&["eval", "--shape", "cone", "--set", "alpha=pi/3", "--quantity", "F", "--at", "1", "--json"]);
    // F = E* a^2 (pi/2) cot(alpha), with alpha the half-opening angle.
    let expected = std::f64::consts::FRAC_PI_2 / 3f64.sqrt();
    assert!((named["points"][0]["value"].as_f64().unwrap() - expected).abs() < 1e-15);
    assert_eq!(json(&["derive", "--shape", "Cone with spherical cap", "--json"])["g"]["status"], "exact");
    for arguments in [&["compare", "--shape", "hyperboloid", "--json"][..], &["derive", "--shape", "flat", "--depth", "d", "--json"]] {
        json(arguments);
    }
    assert!(refused(&["derive", "--shape", "sphere", "r^2"]).contains("cannot be used with"));
    assert!(refused(&["eval", "--shape", "sphere", "--quantity", "g", "--at", "1"]).contains("--set R=VALUE"));
}

/// Equivalent cones have the area of their pyramid at every depth: pi r^2 = A at f(r) = 1.
#[test]
fn pyramids_are_cones_of_equal_area() {
    let degree = std::f64::consts::PI / 180.0;
    for (name, area) in [
        ("berkovich", 3.0 * 3f64.sqrt() * (65.27 * degree).tan().powi(2)),
        ("vickers", 4.0 * (68.0 * degree).tan().powi(2)),
        ("cube-corner", 1.5 * 3f64.sqrt()),
    ] {
        let r = (area / std::f64::consts::PI).sqrt();
        let found = json(&["eval", "--shape", name, "--quantity", "f", "--at", &r.to_string(), "--json"]);
        let f = found["points"][0]["value"].as_f64().unwrap();
        assert!((f - 1.0).abs() < 1e-14, "{name}: {f}");
    }
    // A(h) = C0 h^2 + C1 h at h = f(r).
    let set = ["--set", "C0=24.5", "--set", "C1=0.3"];
    let found = json(&[&["eval", "--shape", "oliver-pharr", "--quantity", "f", "--at", "0.7", "--json"], &set[..]].concat());
    let h = found["points"][0]["value"].as_f64().unwrap();
    let area = (24.5 * h + 0.3) * h;
    assert!((area / (std::f64::consts::PI * 0.49) - 1.0).abs() < 1e-13, "{area}");
}

#[test]
fn the_nearest_name_is_suggested() {
    for (name, near) in [
        ("spheer", "sphere"),
        ("rounded-cone", "cone-with-spherical-cap"),
        ("Parabloid", "paraboloid"),
        ("berkovitch", "berkovich"),
        ("truncated cone", ""),
        ("hyperbolid", "hyperboloid"),
    ] {
        if near.is_empty() {
            json(&["derive", "--shape", name, "--json"]);
            continue;
        }
        for arguments in [&["derive", "--shape", name][..], &["scene", "new", name]] {
            let message = refused(arguments);
            assert!(message.contains(&format!("did you mean {near}?")), "{arguments:?}: {message}");
        }
    }
    for (unit, near) in [("kpa", "kPa"), ("gpa", "GPa"), ("NM", "nm"), ("micrometers", "um"), ("mpa", "mPa or MPa"), ("Degrees", "deg")] {
        let error = sneddon::scene::Unit::parse(unit).unwrap_err();
        assert!(error.accepted().unwrap().contains(&format!("did you mean {near}?")), "{unit}: {:?}", error.accepted());
    }
}

/// Popov & Heß (3.61): F = 2 E* a (d + 2 h/3) of a concave punch, whose radius stands in its own profile.
#[test]
fn a_rim_may_stand_in_its_profile() {
    let found = json(&["derive", "-h*r^2/a^2", "--depth", "d", "--json"]);
    let expected = parse::formula("E*a*(2*d+4/3*h)").unwrap();
    for key in ["F", "F_of_d"] {
        assert_eq!(parse::formula(found[key]["text"].as_str().unwrap()).unwrap(), expected, "{key}");
    }
    assert_eq!(parse::formula(found["g"]["text"].as_str().unwrap()).unwrap(), parse::formula("-2*h*x^2/a^2").unwrap());
    assert_eq!(found["check"]["passed"], true);
    assert!(found["a_of_d"].is_null());
    let text = String::from_utf8(run(&["derive", "-h*r^2/a^2", "--depth", "d"]).stdout).unwrap();
    assert!(text.contains("f(r) = -h*r^2/a^2"), "{text}");
    let flat = String::from_utf8(run(&["derive", "0", "--depth", "d"]).stdout).unwrap();
    assert!(flat.contains("F(d) = 2*E*a*d") && !flat.contains("no explicit form"), "{flat}");
    assert!(refused(&["derive", "-h*r^2/a^2"]).contains("if the depth is given"));
}

/// The answers, the steps, the notes and the errors call the radius of the rim a, and no piece depends on whether a < a/2.
#[test]
fn a_kink_at_a_share_of_the_rim() {
    let kink = &["derive", "max(0,r-a/2)", "--depth", "d"];
    let of = |list: &[&str]| json(&[list, &["--json"]].concat());
    let force = of(kink)["F"]["text"].as_str().unwrap().to_owned();
    // At a = 2 and E* = 1 it is the force of a kink at 1 under the depth 6.
    let set = Bindings::from_iter([("a", Expr::integer(2)), ("d", Expr::integer(6)), ("E", Expr::one())]);
    let value = constant_value(parse::formula(&force).unwrap().as_closed().unwrap(), &set).unwrap().value;
    let expected = of(&["eval", "max(0,r-1)", "--quantity", "F", "--at", "2", "--depth", "6"])["points"][0]["value"].as_f64().unwrap();
    assert!((value / expected - 1.0).abs() < 1e-15, "{force}: {value} instead of {expected}");
    let full = [kink, ["--steps=full"].as_slice()].concat();
    for (arguments, wanted) in [
        (kink.as_slice(), "pi/3*a <= d"),
        (kink, "f'(r) jumps at r = a/2"),
        (&full, "f'(r) = piecewise(0, r < a/2, 1)"),
        (&["derive", "piecewise(0,r<a/3,r^2)", "--depth", "1"], "the profile jumps by a^2/9 at r = a/3"),
        (&["derive", "a_rim*r^2", "--depth", "1"], "f(r) = a_rim*r^2"),
    ] {
        let done = run(arguments);
        let text = String::from_utf8([done.stdout, done.stderr].concat()).unwrap();
        assert!(text.contains(wanted) && !text.contains("a'") && !text.contains("a < a"), "{arguments:?}: {text}");
    }
}

/// The quantities of the one-dimensional model, the mean pressure and the stress on the axis of a paraboloid with R = 2, a = 1, E* = 3.
#[test]
fn more_quantities_have_numbers() {
    let value = |quantity: &str, at: &str, more: &[&str]| {
        let common = ["eval", "r^2/(2*R)", "--set", "R=2", "--effective-modulus", "3", "--quantity", quantity, "--at", at, "--json"];
        json(&[&common, more].concat())["points"][0].clone()
    };
    let close = |found: &Value, expected: f64| {
        let (value, error) = (found["value"].as_f64().unwrap(), found["error_estimate"].as_f64().unwrap());
        assert!((value - expected).abs() <= error + 2e-16 * expected.abs() && error < 1e-12, "{found}: {expected}");
    };
    let radius = ["--radius", "1"];
    // g = x^2/R, d = a^2/R, F = (4/3) E* a^3/R, p_0 = (2/pi) E* a/R.
    close(&value("u_1d", "0.5", &radius), 0.375);
    close(&value("q", "0.5", &radius), 1.125);
    close(&value("q", "1.5", &radius), 0.0);
    close(&value("p_mean", "1", &[]), 2.0 / std::f64::consts::PI);
    close(&value("sigma_zz", "0.5", &radius), -3.0 / std::f64::consts::PI / 1.25);
    close(&value("u_1d", "1", &["--radius", "1", "--depth", "0.75"]), 0.25);
    assert!(value("p_mean", "0", &[])["why"].is_string());
    assert!(refused(&["eval", "r^2", "--quantity", "q", "--at", "1"]).contains("--radius"));
}

#[test]
fn messages_are_one_safe_line() {
    let escape = "\u{1b}[2J\u{7}\u{202e}";
    for arguments in [
        vec!["derive".to_owned(), "r^2/R".to_owned(), "--set".to_owned(), format!("{escape}=1")],
        vec!["derive".to_owned(), "--shape".to_owned(), escape.to_owned()],
        vec!["solve".to_owned(), format!("/no/{escape}.toml")],
        vec!["derive".to_owned(), "r^2".to_owned(), "-o".to_owned(), format!("{escape}.xyz")],
        vec!["derive".to_owned(), "r^2/R".to_owned(), "--set".to_owned(), format!("{}=1", "k".repeat(5000))],
        vec!["solve".to_owned(), format!("/no/{}.toml", "p".repeat(2000))],
    ] {
        let list: Vec<&str> = arguments.iter().map(String::as_str).collect();
        let message = refused(&list);
        assert!(!message.contains(['\u{1b}', '\u{7}', '\u{202e}']), "{message}");
        for line in message.lines().filter(|line| !line.starts_with("help")) {
            assert!(line.chars().count() <= 300, "{line}");
        }
    }
}
