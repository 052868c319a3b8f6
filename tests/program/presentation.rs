//! `--digits` and `--inverse-hyperbolic` of `derive` and `invert`, and decimals that stay decimals.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used)]

use serde_json::Value;
use sneddon::parse;
use sneddon_checks::formulas::{relative, typed};
use sneddon_checks::random::Stream;
use sneddon_checks::seeds::cases;
use std::process::{Command, Output};

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_sneddon")).args(arguments).output().unwrap()
}

fn answer(arguments: &[&str]) -> String {
    let done = run(arguments);
    assert!(done.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8(done.stdout).unwrap()
}

fn json(arguments: &[&str]) -> Value {
    serde_json::from_str(&answer(&[arguments, &["--json"]].concat())).unwrap()
}

/// The formulas of an answer in one notation, by key.
fn formulas(document: &Value, notation: &str) -> Vec<(String, String)> {
    let entries = document.as_object().unwrap().iter();
    entries.filter_map(|(key, own)| Some((key.clone(), own.get(notation)?.as_str()?.to_owned()))).collect()
}

/// Every number in a text without its exponent of ten; digits within names do not count.
fn numbers(text: &str) -> Vec<String> {
    let text = text.replace("e-", "e").replace("10^{-", "e");
    let mut found: Vec<String> = Vec::new();
    let mut before = ' ';
    let mut open = false;
    for letter in text.chars() {
        let is_part = letter.is_ascii_digit() || letter == '.';
        open = is_part && (open || !(before.is_alphanumeric() || before == '_'));
        match found.last_mut().filter(|_| open && (before.is_ascii_digit() || before == '.')) {
            Some(number) => number.push(letter),
            None if open => found.push(letter.to_string()),
            None => {}
        }
        before = letter;
    }
    found
}

fn significant(number: &str) -> usize {
    let digits = number.replace('.', "");
    digits.trim_start_matches('0').trim_end_matches('0').len()
}

/// A random decimal with five digits, none of which is lost in a product with 2 or 5.
fn decimal(stream: &mut Stream) -> String {
    let digits = 10 * stream.whole(1_001, 9_999) + stream.pick(&[1, 3, 7, 9]);
    format!("{}.{:03}", digits / 1000, digits % 1000)
}

#[test]
fn logarithms_equal_the_functions_that_they_replace() {
    let profiles = [
        "R-sqrt(R^2-r^2)",
        "h*asinh(r/w)",
        "h*ln(1+r^2/w^2)",
        "r^2*atanh(r/R)",
        "r*tan(theta)",
        "C*acosh(1+r/b)",
        "piecewise(0,r<b,h*asinh(r/w)-h*asinh(b/w))",
    ];
    let mut stream = Stream::new(38);
    for profile in profiles.into_iter().step_by(cases(2, 1)) {
        let plain = json(&["derive", profile]);
        let logarithms = json(&["derive", profile, "--inverse-hyperbolic", "log"]);
        assert_eq!(json(&["derive", profile, "--inverse-hyperbolic", "ar"]), plain);
        assert_eq!(plain["check"], logarithms["check"]);
        for _ in 0..3 {
            let mut values: Vec<(&str, f64)> =
                ["R", "h", "w", "b", "C", "E", "d"].into_iter().map(|name| (name, stream.uniform(2.0, 3.0))).collect();
            let a = stream.uniform(0.5, 1.9);
            values.extend([("theta", 0.3), ("a", a), ("x", a), ("r", a * stream.uniform(0.2, 0.9))]);
            for ((key, plain), (_, logarithm)) in formulas(&plain, "text").into_iter().zip(formulas(&logarithms, "text")) {
                assert!(!["asinh", "acosh", "atanh"].iter().any(|name| logarithm.contains(name)), "{profile}: {logarithm}");
                let (plain, logarithm) = (typed(&plain, &values), typed(&logarithm, &values));
                assert!(plain == logarithm || relative(plain, logarithm) < 1e-7, "{key} of {profile}: {plain} {logarithm}");
            }
        }
        for format in ["text", "unicode", "latex", "markdown", "typst", "mathml", "json"] {
            let shown = answer(&["derive", profile, "--inverse-hyperbolic", "log", "--format", format]);
            // Rules have such names too.
            for name in ["asinh", "acosh", "atanh", "arsinh", "arcosh", "artanh"] {
                let written = [format!("{name}("), format!("{{{name}}}"), format!(">{name}<")];
                assert!(!written.iter().any(|own| shown.contains(own)), "{profile}: {shown}");
            }
        }
        for more in ["--steps", "--steps=full"] {
            let steps = answer(&["derive", profile, "--inverse-hyperbolic", "log", more]);
            assert!(!["asinh(", "acosh(", "atanh("].iter().any(|own| steps.contains(own)), "{steps}");
        }
    }
}

#[test]
fn decimals_stay_decimals_and_read_back() {
    let mut stream = Stream::new(1273);
    for _ in 0..4 {
        let c = decimal(&mut stream);
        let digits = c.replace('.', "");
        for profile in ["C*r^2", "r^2/C", "r^2/(2*C)", "C-sqrt(C^2-r^2)", "r*atan(r/C)"] {
            let (decimals, fractions) = (profile.replace('C', &c), profile.replace('C', &format!("({digits}/1000)")));
            let (decimals, fractions) = (json(&["derive", &decimals]), json(&["derive", &fractions]));
            for ((key, text), (_, fraction)) in formulas(&decimals, "text").into_iter().zip(formulas(&fractions, "text")) {
                assert_eq!(parse::formula(&text).unwrap(), parse::formula(&fraction).unwrap(), "{key} of {profile}: {text}");
                assert!(!text.contains(&digits) || key == "a_of_d" || key == "F_of_d", "{key} of {profile} with {c}: {text}");
            }
        }
    }
    let of = |arguments: &[&str], key: &str| json(arguments)[key]["text"].as_str().unwrap().to_owned();
    assert_eq!(of(&["derive", "r^2/12.73"], "profile"), "r^2/12.73");
    assert_eq!(of(&["derive", "12.73*r^2"], "g"), "25.46*x^2");
    assert_eq!(of(&["derive", "r^2/(2*R)", "--set", "R=12.73"], "g"), "x^2/12.73");
    assert_eq!(of(&["derive", "R-sqrt(R^2-r^2)", "--set", "R=12.73"], "g"), "x*atanh(x/12.73)");
    assert_eq!(of(&["derive", "1.25e-30*r^2"], "g"), "2.5e-30*x^2");
    let sphere = ["derive", "h*(1-sqrt(1-r^2/R^2))", "--set", "h=1.853", "--set", "R=5.024"];
    assert_eq!(of(&sphere, "g"), "1.853/5.024*x*atanh(x/5.024)");
    // Fractions that were typed stay fractions.
    assert_eq!(of(&["derive", "1273/100*r^2"], "g"), "1273/50*x^2");
    assert_eq!(of(&["derive", "1273/100*r^2+0.5*r"], "profile"), "1273/100*r^2 + 0.5*r");
}

#[test]
fn rounded_numbers_have_so_many_digits() {
    let profiles = [
        "C*r^2",
        "r^2/C",
        "C-sqrt(C^2-r^2)",
        "C*r^2.375",
        "C*ln(1+r^2/C^2)",
        "piecewise(0,r<C/20,(r^2-(C/20)^2)/3.456789)",
        "C*(1-exp(-r^2/3.71^2))",
        "C*1e-25*r^3",
        "1234/5677*r^2",
    ];
    let mut stream = Stream::new(17);
    for profile in profiles.into_iter().step_by(cases(2, 1)) {
        let profile = profile.replace('C', &decimal(&mut stream));
        let plain = json(&["derive", &profile]);
        for digits in [1, 2, 3, 6, 12, 17] {
            let count = digits.to_string();
            let rounded = json(&["derive", &profile, "--digits", &count]);
            assert_eq!(rounded["digits"], digits);
            assert_eq!(rounded["check"], plain["check"]);
            for (key, text) in formulas(&rounded, "text").into_iter().chain(formulas(&rounded, "latex")) {
                let longest = numbers(&text).into_iter().max_by_key(|own| significant(own)).unwrap_or_default();
                // Exponents and constant arguments are exact, and squares below a root are squares of rounded numbers.
                let has = |parts: &[&str]| parts.iter().any(|own| profile.contains(own));
                let most = if has(&["sqrt", "ln(", "piecewise"]) { 2 * digits } else { digits };
                // gamma(2.1875), for the exponent 2.375.
                let most = if has(&["^2.375"]) { most.max(5) } else { most };
                assert!(significant(&longest) <= most, "{key} of {profile} to {digits}: {longest} in {text}");
            }
            let values = [("a", 2.5), ("x", 2.5), ("r", 0.7), ("E", 1.3), ("d", 0.4)];
            for ((key, plain), (_, rounded)) in formulas(&plain, "text").into_iter().zip(formulas(&rounded, "text")) {
                let (plain, rounded) = (typed(&plain, &values), typed(&rounded, &values));
                // The terms of the logarithm's force and pressure cancel next to the axis.
                let cancels = if profile.contains("ln(") { 1e5 } else { 20.0 };
                let allowed = 1e-7 + cancels / 10_f64.powi(i32::try_from(digits).unwrap());
                assert!(relative(plain, rounded) < allowed, "{key} of {profile} to {digits}: {plain} {rounded}");
            }
        }
    }
}

/// Rounding changes no law: exponents and constant arguments stay, no term or piece vanishes, and roots vanish where they did.
#[test]
fn rounding_keeps_what_a_formula_is() {
    let of =
        |profile: &str, digits: &str, key: &str| json(&["derive", profile, "--digits", digits])[key]["text"].as_str().unwrap().to_owned();
    assert_eq!(of("r^2/ln(1.0004)", "3", "profile"), "r^2/ln(1.0004)");
    assert_eq!(of("r^2/atanh(0.9999)", "3", "profile"), "r^2/atanh(0.9999)");
    assert_eq!(of("r^1.999", "2", "profile"), "r^1.999");
    assert_eq!(of("1.001*r^1.001", "2", "profile"), "r^1.001");
    assert!(of("r^1234.5", "2", "F").contains("a^1235.5"));
    assert_eq!(of("1.00001e10*r^2", "3", "profile"), "10000000000*r^2");
    assert_eq!(of("sqrt(1.0004+r^2)-sqrt(1.0001+r^2)", "3", "profile"), "sqrt(1.0004 + r^2) - sqrt(1.0001 + r^2)");
    assert_eq!(of("1.2345-sqrt(1.2345^2-r^2)", "3", "profile"), "1.23 - sqrt(1.5129 - r^2)");
    let pieces = of("piecewise(0,r<1.0001,r-1.0001,r<1.0004,(r-1.0001)^2/0.0003)", "3", "profile");
    assert!(pieces.contains("r < 1.0001") && pieces.contains("r < 1.0004"), "{pieces}");
    // The edge of the flat end is where the root vanishes.
    let worn = of("piecewise(0,r<1.23456,(r^2-1.23456^2)/2)", "3", "g");
    assert!(worn.contains("x < 1.23,") && worn.contains("sqrt(x^2 - 1.5129)"), "{worn}");
}

#[test]
fn every_format_rounds_and_says_so() {
    let shown = [("text", "F(a) = 33.9*E*a^3"), ("unicode", "F(a) = 33.9·E*·a³"), ("latex", "F(a) &= 33.9 E^{*} a^{3}")];
    let others = [("markdown", "33.9 E^{*} a^{3}"), ("typst", "33.9 E^* a^(3)"), ("mathml", "<mn>33.9</mn>"), ("json", "\"33.9*E*a^3\"")];
    for (format, formula) in shown.into_iter().chain(others) {
        for more in [&[][..], &["--steps"], &["--steps=full"]] {
            let text = answer(&[&["derive", "12.73*r^2", "--digits", "3", "--format", format], more].concat());
            assert!(!text.contains("33.94") && !text.contains("101.84"), "{text}");
            assert!(!more.is_empty() || text.contains(formula), "{format}: {text}");
            assert_eq!(text.matches("rounded to 3 significant digits").count(), 1, "{format}: {text}");
        }
    }
    let text = answer(&["derive", "1.26*r^2", "--digits", "1", "--quantity", "f,a"]);
    assert!(text.contains("f(r) = r^2\n") && text.contains("rounded to 1 significant digit\n"), "{text}");
    let exact = json(&["derive", "12.73*r^2"]);
    assert!(exact.get("digits").is_none() && !exact["notes"].to_string().contains("rounded"));
}

#[test]
fn short_fractions_and_whole_numbers_stay_and_long_ones_are_rounded() {
    for profile in ["3/2*r^2", "4/3*r^3+r^2/7", "123*r^2", "2/3*sqrt(r^2+w^2)-2/3*w", "r*tan(theta)"] {
        let (plain, rounded) = (json(&["derive", profile]), json(&["derive", profile, "--digits", "3"]));
        assert_eq!(formulas(&plain, "text"), formulas(&rounded, "text"));
        assert_eq!(formulas(&plain, "latex"), formulas(&rounded, "latex"));
    }
    let long = json(&["derive", "12345*r^2", "--digits", "3"]);
    assert_eq!((long["g"]["text"].as_str(), long["a_of_d"]["text"].as_str()), (Some("24700*x^2"), Some("0.00636*sqrt(d)")));
    let force = |digits| json(&["derive", "1000/3*r^2", "--quantity", "F", "--digits", digits])["F"]["text"].clone();
    assert_eq!(force("4"), "8000/9*E*a^3");
    assert_eq!(force("3"), "889*E*a^3");
}

#[test]
fn an_inversion_is_presented_in_the_same_way() {
    let plain = json(&["invert", "x*atanh(x/12.73)+x*asinh(x/3)"]);
    let other = json(&["invert", "x*atanh(x/12.73)+x*asinh(x/3)", "--digits", "3", "--inverse-hyperbolic", "log"]);
    assert_eq!(other["digits"], 3);
    assert_eq!(plain["check"], other["check"]);
    let g = other["g"]["text"].as_str().unwrap();
    assert!(g.contains("ln((1 + x/12.7)/(1 - x/12.7))") && !g.contains("asinh"), "{g}");
    let text = answer(&["invert", "x^2/12.73", "--digits", "2", "--steps"]);
    assert!(text.contains("r^2/25") && text.contains("rounded to 2 significant digits"), "{text}");
}

#[test]
fn other_numbers_of_digits_are_refused() {
    for command in [["derive", "r^2"], ["invert", "x^2"]] {
        for refused in ["0", "18", "-2", "3.5", "x", "", "999999999999999999999"] {
            let done = run(&[&command[..], &["--digits", refused]].concat());
            assert_eq!((done.status.code(), done.stdout.len()), (Some(2), 0), "{refused}");
            let message = String::from_utf8(done.stderr).unwrap();
            assert!(message.contains("--digits") && message.contains("expected a whole number from 1 to 17"), "{message}");
        }
        let done = run(&[&command[..], &["--inverse-hyperbolic", "ln"]].concat());
        assert_eq!((done.status.code(), done.stdout.len()), (Some(2), 0));
    }
}

/// 0.5 equals 1/2 and is printed as it was typed, also where the other form occurs beside it.
#[test]
fn numbers_keep_their_form_beside_equal_ones() {
    for (profile, expected) in [
        ("max(0,r-0.5)", "F(a) = piecewise(0, a < 0.5, E*(a^2*acos(0.5/a) + 0.5*sqrt(a^2 - 0.25)))"),
        ("abs(r-0.5)+r^1.5", "sqrt(a^2 - 0.25)"),
    ] {
        let done = Command::new(env!("CARGO_BIN_EXE_sneddon")).args(["derive", profile]).output().unwrap();
        let text = String::from_utf8(done.stdout).unwrap();
        assert!(text.contains(expected) && !text.contains("(1/2"), "{text}");
    }
}
