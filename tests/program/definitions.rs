//! Special functions are set upright and defined below the formulas; labels, sources and widths are those of a paper.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeSet;
use std::process::Command;

fn written(arguments: &[&str]) -> String {
    let done = Command::new(env!("CARGO_BIN_EXE_sneddon")).args(arguments).output().unwrap();
    assert!(done.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8(done.stdout).unwrap()
}

/// The names of functions in LaTeX that are not elementary.
fn functions(latex: &str) -> BTreeSet<String> {
    let within = |command: &'static str| latex.split(command).skip(1).filter_map(|rest| rest.split('}').next());
    let named = ["\\operatorname{", "\\mathrm{", "\\mathbf{"].into_iter().flat_map(within);
    let greek = ["\\Gamma", "\\psi", "\\chi"].into_iter().filter(|own| latex.contains(own));
    let elementary = ["arsinh", "arcosh", "artanh", "d"];
    named.chain(greek).filter(|own| !elementary.contains(own)).map(str::to_owned).collect()
}

#[test]
fn every_special_function_of_a_document_is_defined_in_it() {
    let mut met = BTreeSet::new();
    for profile in [
        "C*r^n",
        "max(0,r^2/(2*R)-h)",
        "max(0,(r-b)*tan(theta))",
        "R-sqrt(R^2-r^2)+asin(r/R)",
        "h*r*exp(-r^2/w^2)",
        "h*(1-exp(-r^2/w^2))",
        "h*(1-besselj(0,k*r))",
        "h*(exp(r/w)-1)",
        "h*sin(k*r)",
        "h*sin(r^2/w^2)",
        "h*ln(1+r^2/w^2)",
        "h*r*ln(1+r/w)",
        "h*r*atan(r/w)",
        "piecewise(0, r<b, r^2*ln(r/b))",
        "max(0,r^2.5-b^2.5)",
        "r^2*acosh(1+r/w)",
        "h*sqrt(1+r/w)",
        "h*r^2/sqrt(r^4+w^4)",
    ] {
        let document = written(&["derive", profile, "--format", "latex", "--standalone"]);
        let (equations, notes) = document.split_once("\\subsection*{Notes}").unwrap();
        let used = functions(equations);
        let missing: Vec<_> = used.difference(&functions(notes)).cloned().collect();
        assert!(missing.is_empty(), "{profile}: {missing:?} are not defined in {notes}");
        met.extend(used);
    }
    assert!(met.len() >= 12, "{met:?}");
}

/// The force F and the modulus E* are italic, the elliptic integrals upright; nothing in a document is a word of the command line.
#[test]
fn a_document_speaks_as_a_paper_does() {
    let document = written(&["derive", "max(0,r^2/(2*R)-h)", "--format", "latex", "--standalone"]);
    for part in
        ["\\mathrm{F}\\left(", "F(a) =", "In closed form: Popov \\& Heß~\\cite{PopovHess2015} (3.22), (3.25)", "$p = -\\sigma_{zz}$"]
    {
        assert!(document.contains(part), "{part}: {document}");
    }
    for format in ["latex", "typst", "markdown", "mathml"] {
        let document = written(&["derive", "R-sqrt(R^2-r^2)", "--format", format, "--standalone"]);
        assert!(!document.contains(" | ") && document.contains("In closed form: Popov"), "{document}");
    }
}

/// A column of 345 pt has 72 characters.
#[test]
fn the_width_of_a_column_may_have_a_unit() {
    let with = |width: &str| written(&["derive", "max(0,r^2/(2*R)-h)", "--format", "latex", "--width", width]);
    for (width, characters) in [("246pt", "51"), ("8.65cm", "51"), ("86.5 mm", "51"), ("3.4in", "51"), ("345pt", "72")] {
        assert_eq!(with(width), with(characters), "{width}");
    }
    assert_ne!(with("51"), with("72"));
    for wrong in ["19", "1001", "-5pt", "12 furlongs", "nan", "infpt", "pt", "20pt"] {
        let done = Command::new(env!("CARGO_BIN_EXE_sneddon")).args(["derive", "r^2", "--width", wrong]).output().unwrap();
        let message = String::from_utf8(done.stderr).unwrap();
        assert!(done.status.code() == Some(2) && message.contains("expected 20 to 1000 characters"), "{wrong}: {message}");
    }
}

/// √2/√(2hR + 2R√(d² + h²)) and √d √(2h − d) are one root each.
#[test]
fn square_roots_are_joined() {
    for (profile, key, expected) in [
        ("max(0,r^2/(2*R)-h)", "a_of_d", "sqrt(R*(h + sqrt(d^2 + h^2)))"),
        ("max(0,r^2/(2*R)-h)", "F_of_d", "4*E*sqrt(R)*d/(3*sqrt(h + sqrt(d^2 + h^2)))*(2*h + sqrt(d^2 + h^2))"),
        ("sqrt(d_0)*sqrt(2*h-r)", "f", "sqrt(d_0*(2*h - r))"),
    ] {
        let document = written(&["derive", profile, "--quantity", key, "--json"]);
        assert!(document.contains(&format!("\"text\":\"{expected}")), "{profile}: {key} is not {expected} in {document}");
    }
}

/// The rules for the sphere and for other roots evaluate artanh in different forms; a formula contains it once.
#[test]
fn functions_of_several_rules_are_collected() {
    for profile in ["h*(1-(1-(r/R)^2)^(3/2))", "r^2*(R-sqrt(R^2-r^2))", "(R-sqrt(R^2-r^2))^3", "(R-sqrt(R^2-r^2))^5"] {
        for line in written(&["derive", profile, "--quantity", "g,F"]).lines().filter(|own| own.starts_with("g(") || own.starts_with("F("))
        {
            assert_eq!(line.matches("atanh").count(), 1, "{line}");
        }
    }
}

/// A part that depends on the variable of integration is a function of it, also where it does so through another part.
#[test]
fn parts_of_integrands_are_functions() {
    let text = written(&["derive", "r^3*ln(r)*exp(-r^2)", "--quantity", "p", "--format", "unicode"]);
    let rows: Vec<&str> = text.lines().skip_while(|line| !line.starts_with("where")).take_while(|line| !line.is_empty()).collect();
    assert!(text.contains(" ds") && rows.len() > 3, "{text}");
    for row in rows {
        let (left, right) = row.split_once(" = ").unwrap();
        let depends = right.split(|c: char| !c.is_alphanumeric()).any(|own| own == "s");
        assert!(depends == left.ends_with("(s)"), "{row}");
    }
}

/// Two derivations in one paper have no label in common.
#[test]
fn labels_name_their_derivation() {
    let labels = |profile: &str| -> Vec<String> {
        let text = written(&["derive", profile, "--steps", "--format", "latex"]);
        text.split("\\label{").skip(1).filter_map(|rest| rest.split('}').next()).map(str::to_owned).collect()
    };
    let long = "h*ln(1+r^2/w^2)+h*(1-exp(-r^2/w^2))+C*r^4";
    let lists = [labels("r^2/(2*R)"), labels("r^3/(2*R)"), labels(long), labels(&format!("{long}+C*r^6"))];
    let all: BTreeSet<&String> = lists.iter().flatten().collect();
    assert_eq!(all.len(), lists.iter().map(Vec::len).sum::<usize>(), "{lists:?}");
    assert!(lists.iter().all(|own| own.len() > 5), "{lists:?}");
}

/// Class "a parameter with the letter of a quantity or of a function": pages set it apart by an index, text and JSON keep it as typed.
#[test]
fn parameters_that_collide_are_set_apart() {
    let profiles: [(&str, &str, &[&str]); 7] = [
        // R_F has an index.
        ("C*sqrt(R+r)", "F", &[]),
        ("F*r^2+p*r^4", "F,p,g", &["F", "p"]),
        ("k*r+nu*r^3", "k,F", &["k"]),
        ("piecewise(0,r<K,(r^2-K^2)/(2*F))", "g,p", &["F"]),
        ("h*(1-cos(r^2/C^2))", "g,F", &["C"]),
        ("U*r^2+G*r", "F,p", &[]),
        ("g*r^2+f*r^3+F_0*r", "g,F", &["f", "g"]),
    ];
    for (profile, quantities, apart) in profiles {
        for format in ["latex", "typst", "markdown", "unicode", "mathml"] {
            for steps in [&[][..], &["--steps"]] {
                let text = written(&[&["derive", profile, "--quantity", quantities, "--format", format][..], steps].concat());
                let remarks: Vec<&str> = text.match_indices(" is the parameter ").map(|(at, own)| &text[at + own.len()..]).collect();
                let mut named: Vec<&str> = remarks.iter().filter_map(|own| own.split(' ').next()).collect();
                named.sort_unstable();
                // The short derivation also prints f, g, d, F, p and k on the left.
                let enough = if steps.is_empty() { named == apart } else { apart.iter().all(|own| named.contains(own)) };
                assert!(enough, "{profile} {format} {steps:?}: {named:?}");
            }
        }
        let text = written(&["derive", profile, "--quantity", quantities]);
        assert!(!text.contains(" is the parameter "), "{text}");
    }
    let text = written(&["derive", "F*r^2+p*r^4", "--quantity", "F", "--format", "latex"]);
    assert!(text.contains("F(a) &= \\frac{8}{15} E^{*} a^{3} (8 p a^{2} + 5 F_{0})"), "{text}");
}

/// Equations and differentials within sentences are one formula each.
#[test]
fn sentences_have_whole_formulas() {
    for profile in ["r^2/(2*R)+r*tan(theta)", "R-sqrt(R^2-r^2)", "max(0,r-b)", "h*exp(-r/w)", "C*r^n"] {
        for (format, broken) in [("latex", "$ = $"), ("typst", "$ \\= $"), ("mathml", "</math> = <math")] {
            for steps in ["--steps", "--steps=full"] {
                let text = written(&["derive", profile, steps, "--format", format]);
                assert!(!text.contains(broken) && !text.contains("$$"), "{profile} {format} {steps}: {text}");
            }
        }
        let text = written(&["derive", profile, "--steps", "--format", "latex"]);
        assert!(text.contains("$k = \\mathrm{d}F/\\mathrm{d}d$") && text.contains("$f(0) = "), "{text}");
    }
}

/// The name of a quantity that is not in the output is free.
#[test]
fn names_that_are_not_in_the_output_are_free() {
    assert!(written(&["derive", "r^2/(2*R)", "--symbols", "p=q", "--quantity", "p"]).contains("q(r) = 2*E/(pi*R)*sqrt(a^2 - r^2)"));
    let done =
        Command::new(env!("CARGO_BIN_EXE_sneddon")).args(["derive", "r^2", "--symbols", "p=q", "--quantity", "p,q"]).output().unwrap();
    assert_eq!(done.status.code(), Some(2));
}
