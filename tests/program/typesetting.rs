//! The flags about how formulas are set: whole documents, widths, names, quantities and steps, and what is refused.
#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used)]

use sneddon::expr::Symbol;
use sneddon::parse;
use sneddon_checks::seeds::sample;
use std::process::{Command, Output};

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_sneddon")).args(arguments).output().unwrap()
}

fn answer(arguments: &[&str]) -> String {
    let done = run(arguments);
    assert!(done.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8(done.stdout).unwrap()
}

fn json(arguments: &[&str]) -> serde_json::Value {
    serde_json::from_str(&answer(arguments)).unwrap()
}

#[test]
fn only_the_quantities_that_were_asked_for_are_derived() {
    let document = json(&["derive", "r^2/(2*R)", "--quantity", "F,U,a", "--json"]);
    let keys: Vec<&str> =
        ["f", "g", "d", "F", "p", "k", "U", "a_of_d", "F_of_d"].into_iter().filter(|key| document.get(key).is_some()).collect();
    assert_eq!(keys, ["F", "U", "a_of_d"]);
    let text = answer(&["derive", "r^2/(2*R)", "--quantity", "p"]);
    assert!(text.contains("p(r) = ") && !text.contains("F(a) = "), "{text}");
    let every = "f,g,G,d,F,a,k,p,u,U,p_mean,sigma_zz,q,u_1d";
    for format in ["text", "unicode", "latex", "markdown", "typst", "mathml", "json"] {
        assert!(!answer(&["derive", "R-sqrt(R^2-r^2)", "--quantity", every, "--format", format]).is_empty());
    }
}

#[test]
fn other_names_are_shown_everywhere() {
    let symbols = ["--symbols", "E=E_r,d=\\delta,R=R_{tip}"];
    let mut arguments = vec!["derive", "r^2/(2*R)", "--json"];
    arguments.extend(symbols);
    let document = json(&arguments);
    assert_eq!(document["F_of_d"]["text"], "4/3*E_r*sqrt(R_tip)*delta^(3/2)");
    let latex = document["F_of_d"]["latex"].as_str().unwrap();
    assert!(latex.contains("E_{r}") && latex.contains("\\delta") && latex.contains("R_{\\mathrm{tip}}"), "{latex}");
    let names = parse::formula(document["F_of_d"]["text"].as_str().unwrap()).unwrap().symbols();
    assert!(["E", "d", "R"].iter().all(|own| !names.contains(&Symbol::new(own))));
    for format in ["text", "latex", "typst", "mathml", "markdown"] {
        for steps in ["--steps", "--steps=full"] {
            let mut arguments = vec!["derive", "r^2/(2*R)", steps, "--format", format];
            arguments.extend(symbols);
            let text = answer(&arguments);
            assert!(!text.contains("E^{*}") && !text.contains("F(d)"), "{format}: {text}");
        }
    }
    for refused in ["E=R", "E=pi", "R=a", "E=x,R=x", "Q=T", "E", "E=", "E=1+1", "E=A,E=B", "E=F"] {
        let done = run(&["derive", "r^2/(2*R)", "--symbols", refused]);
        assert_eq!(done.status.code(), Some(2), "{refused}");
        assert!(done.stdout.is_empty());
    }
    // Two names may change places.
    let swapped = json(&["derive", "r^2/(2*R)", "--symbols", "a=d,d=a", "--json"]);
    assert_eq!(swapped["d"]["text"], "d^2/R");
}

#[test]
fn formulas_are_broken_at_the_width() {
    let profile = "r^2/(2*R)+r^3/(3*L^2)+h*(1-exp(-r^2/w^2))+r*tan(theta)+w*(sqrt(1+r^2/w^2)-1)";
    let text = answer(&["derive", profile, "--quantity", "g", "--width", "60"]);
    let formula: Vec<&str> = text.lines().skip_while(|line| !line.starts_with("g(x)")).take_while(|line| !line.contains("exact")).collect();
    assert!(formula.len() > 1, "{text}");
    assert!(formula.iter().all(|line| line.chars().count() <= 70), "{formula:#?}");
    let (_, right) = formula.concat().split_once('=').map(|(left, right)| (left.to_owned(), right.to_owned())).unwrap();
    let whole = json(&["derive", profile, "--quantity", "g", "--json"]);
    assert_eq!(parse::formula(&right).unwrap(), parse::formula(whole["g"]["text"].as_str().unwrap()).unwrap());
    let latex = answer(&["derive", profile, "--quantity", "g", "--width", "40", "--format", "latex"]);
    assert!(latex.matches("\\quad").count() >= 2, "{latex}");
    assert_eq!(run(&["derive", "r^2", "--width", "5"]).status.code(), Some(2));
}

#[test]
fn documents_are_whole() {
    let latex = answer(&["derive", "r^2/(2*R)", "--format", "latex", "--standalone"]);
    for part in [
        "\\documentclass",
        "\\begin{document}",
        "\\label{eq:r-2-2-R:F}",
        "\\bibitem{PopovHess2015}",
        "@book{PopovHess2015",
        "\\end{document}",
    ] {
        assert!(latex.contains(part), "{part}");
    }
    assert_eq!(latex.matches("\\begin{").count(), latex.matches("\\end{").count());
    assert!(answer(&["derive", "r^2", "--format", "typst", "--standalone"]).starts_with("#set page"));
    assert!(answer(&["derive", "r^2", "--format", "mathml", "--standalone"]).starts_with("<!DOCTYPE html>"));
    assert!(answer(&["invert", "x^2/R", "--format", "latex", "--standalone", "--steps"]).contains("\\end{document}"));
    for format in ["text", "json"] {
        assert_eq!(run(&["derive", "r^2", "--format", format, "--standalone"]).status.code(), Some(2));
    }
}

#[test]
fn steps_are_data() {
    let document = json(&["derive", "r^2/(2*R)", "--steps=full", "--json"]);
    let steps = document["steps"].as_array().unwrap();
    let mut count = 0;
    let mut open: Vec<&serde_json::Value> = steps.iter().collect();
    while let Some(step) = open.pop() {
        count += 1;
        for key in ["title", "left", "right", "reason", "reference", "steps"] {
            assert!(step.get(key).is_some(), "{key} of {step}");
        }
        assert_eq!(step["left"].is_null(), step["right"].is_null());
        open.extend(step["steps"].as_array().unwrap());
    }
    assert!(count >= 12, "{count}");
    assert!(json(&["derive", "r^2/(2*R)", "--json"]).get("steps").is_none());
    let inverse = json(&["invert", "x^2/R", "--steps=full", "--json"]);
    assert!(inverse["steps"].as_array().unwrap().len() >= 2);
}

/// Class "lost characters": no letter of a rule's source or of a step is missing in LaTeX, and no MathML row has bare text.
#[test]
fn no_character_is_lost() {
    for (index, rule) in sample(sneddon::transform::rules::RULES, 0, 8).enumerate() {
        for more in sample([&[][..], &["--steps"], &["--steps=full"]], index, 3) {
            let latex = answer(&[&["derive", rule.pattern, "--format", "latex", "--standalone"], more].concat());
            assert!(!latex.contains('?') && !latex.contains("[U+"), "{}: {latex}", rule.id);
        }
        // The output with every step contains every formula of the output without them.
        let mathml = answer(&["derive", rule.pattern, "--steps=full", "--format", "mathml"]);
        // Text is allowed only inside <mi>, <mn>, <mo> and <mtext>.
        for row in mathml.split("<mrow>").skip(1) {
            assert!(row.is_empty() || row.starts_with('<'), "{}: {}", rule.id, row.chars().take(60).collect::<String>());
        }
        for after in ["</mo>", "</mi>", "</mn>", "</mrow>", "</mfrac>", "</msup>"] {
            let bare = mathml.split("<math").skip(1).filter_map(|own| own.split("</math>").next());
            for part in bare.flat_map(|own| own.split(after).skip(1).map(str::to_owned).collect::<Vec<_>>()) {
                assert!(part.is_empty() || part.starts_with('<'), "{}: {}", rule.id, part.chars().take(60).collect::<String>());
            }
        }
    }
}
