//! Formulas that are wider than their column: names for parts, ranges in place of pieces that are 0.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used)]

use sneddon::expr::{Bindings, Expr, Formula, shown_as_mathematics};
use sneddon::print::{self, Names, Notation};
use sneddon_checks::formulas::{formula, number, value};
use sneddon_checks::random::Stream;
use sneddon_checks::seeds::cases;
use std::process::Command;

/// Letters in a column.
const COLUMN: usize = 72;

fn answer(arguments: &[&str]) -> String {
    let done = Command::new(env!("CARGO_BIN_EXE_sneddon")).args(arguments).output().unwrap();
    assert!(done.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8(done.stdout).unwrap()
}

/// The profiles of the catalogue, and some whose pressures are among the widest.
fn profiles() -> Vec<String> {
    let catalogue: serde_json::Value = serde_json::from_str(include_str!("../data/profiles.json")).unwrap();
    let mut list: Vec<String> = catalogue.as_array().unwrap().iter().map(|own| own["f"].as_str().unwrap().to_owned()).collect();
    list.extend(
        [
            "piecewise(0, r<b, (r^2-b^2)/(2*R))",
            "piecewise(r*tan(theta), r<b, b*tan(theta)+(r^2-b^2)/(2*R))",
            "piecewise(0, r<b, h*(cos(k*b)-cos(k*r)))",
            "piecewise(0, r<c, h*(asinh(r/b)-asinh(c/b)))",
            "h*(r*atanh(r/R)+R/2*ln(1-r^2/R^2))",
            "C*r*atan(r/w)",
            "A*sin(k*r^2)+B*(1-cos(k*r^2))",
            "piecewise(0, r<b, h*((2*r^2-R^2)*asin(r/R)+r*sqrt(R^2-r^2)-(2*b^2-R^2)*asin(b/R)-b*sqrt(R^2-b^2)))",
            "r^2/(2*R)+h*(1-exp(-r^2/w^2))+C*r^(3/2)",
        ]
        .map(str::to_owned),
    );
    list
}

/// The value of a named part, whose definition may contain other names.
fn named(name: &str, parts: &[(String, Formula)], values: &[(&str, f64)]) -> Option<f64> {
    let (_, definition) = parts.iter().find(|own| own.0 == name)?;
    Some(value(definition, &with_parts(definition, parts, values)))
}

/// The values, with those of all names in a formula.
fn with_parts<'v>(within: &Formula, parts: &'v [(String, Formula)], values: &[(&'v str, f64)]) -> Vec<(&'v str, f64)> {
    let symbols = within.symbols();
    let used = parts.iter().filter(|own| symbols.iter().any(|symbol| symbol.name() == own.0));
    let more: Vec<_> = used.map(|(name, _)| (name.as_str(), named(name, parts, values).unwrap())).collect();
    values.iter().copied().chain(more).collect()
}

#[test]
fn named_parts_fit_and_mean_the_same() {
    let (mut stream, mut wide, mut compared) = (Stream::new(20_261_128), 0, 0);
    for text in profiles().iter().step_by(cases(2, 1)) {
        let document: serde_json::Value = serde_json::from_str(&answer(&["derive", text, "--json"])).unwrap();
        let derived: Vec<Formula> = ["g", "F", "p"].iter().filter_map(|key| Some(formula(document[key]["text"].as_str()?))).collect();
        // Far narrower columns need names in more formulas, some of which cannot be that narrow.
        for width in [COLUMN, COLUMN / 3] {
            let mut names = Names::avoiding(["a", "d", "F", "p", "E"]);
            derived.iter().for_each(|own| names.avoid_symbols(own));
            let mut parts: Vec<(String, Formula)> = Vec::new();
            for whole in &derived {
                let (short, new) = names.shortened(whole, Notation::Latex, width);
                wide += usize::from(!new.is_empty());
                for own in new.iter().map(|own| &own.1).chain([&short]).filter(|_| width == COLUMN) {
                    assert!(Notation::Latex.widest(own, width) <= width, "{text}: {}", print::latex(own));
                }
                parts.extend(new);
                // The definitions restore the formula as it is shown.
                let bindings: Bindings = parts.iter().map(|(name, own)| (name.as_str(), own.as_closed().unwrap().clone())).collect();
                let restored = (0..parts.len()).fold(short.clone(), |own, _| own.substitute(&bindings));
                assert_eq!(print::text(&restored), print::text(&whole.map(&shown_as_mathematics)), "{text}");
                if whole.has_integral() || short == *whole {
                    continue;
                }
                let symbols = whole.symbols();
                let values: Vec<(&str, f64)> = symbols.iter().map(|own| (own.name(), stream.uniform(0.3, 1.7))).collect();
                let (one, other) = (value(whole, &values), value(&short, &with_parts(&short, &parts, &values)));
                if one.is_finite() {
                    compared += 1;
                    // The largest difference is 4.2e-16: the same operations in another order.
                    assert!((one - other).abs() <= 8e-16 * one.abs(), "{text}: {one} and {other} at {values:?}");
                }
            }
        }
    }
    assert!(wide >= 40 && compared >= 15, "{wide} {compared}");
}

/// A pressure of two pieces stays wider than 44 letters, whatever is named; its parts fit all the same.
#[test]
fn parts_fit_where_the_whole_does_not() {
    let profile = "piecewise(h*ln(1+r^2/w^2), r<b, h*ln(1+b^2/w^2)+(r-b)*s)";
    let document: serde_json::Value = serde_json::from_str(&answer(&["derive", profile, "--json"])).unwrap();
    let whole = formula(document["p"]["text"].as_str().unwrap());
    let mut names = Names::avoiding(["a", "d", "F", "p", "E"]);
    names.avoid_symbols(&whole);
    let (short, parts) = names.shortened(&whole, Notation::Latex, 44);
    assert!(Notation::Latex.widest(&short, 44) > 44 && parts.len() > 5, "{}", print::latex(&short));
    for (name, own) in parts {
        assert!(Notation::Latex.widest(&own, 44) <= 44, "{name} = {}", print::latex(&own));
    }
}

/// A name is neither a parameter nor a quantity, and m is left to elliptic integrals.
#[test]
fn names_of_parts_are_free() {
    let page = answer(&["derive", "piecewise(0, r<q, (r^2-q^2)/(2*s))", "--format", "latex"]);
    let defined: Vec<&str> =
        page.lines().skip_while(|line| !line.contains("where")).skip(1).map_while(|line| line.split(" &=").next()).collect();
    let defined: Vec<&str> = defined.into_iter().map(str::trim).take_while(|name| !name.contains('(')).collect();
    assert!(defined.len() >= 4 && defined.iter().all(|name| !["q", "s", "m", "E", "F", "a", "r"].contains(name)), "{defined:?}");
}

/// Class "a piece of 0 for contacts that do not exist": the formulas of a contact radius give their range, in every notation but the
/// program's own.
#[test]
fn contact_radii_have_a_range_in_place_of_a_piece_of_zero() {
    for (text, end, latex) in [
        ("piecewise(0, r<b, (r-b)*tan(theta))", "b", "b"),
        ("piecewise(0, r<2*b, r-2*b)", "2*b", "2 b"),
        ("max(0, r-1/2)", "0.5", "\\frac{1}{2}"),
    ] {
        let page = |format: &str| answer(&["derive", text, "--quantity", "g,F", "--format", format]);
        let own = page("latex");
        assert!(own.contains(&format!(", \\quad a \\ge {latex}")) && own.contains("g(x) &= \\begin{cases} 0"), "{own}");
        assert!(page("typst").contains(", quad a >= ") && page("unicode").contains("a ≥ "), "{text}");
        assert!(page("mathml").contains("<mo>≥</mo>"), "{text}");
        let force = page("text").lines().find(|line| line.starts_with("F(a) = ")).unwrap()["F(a) = ".len()..].to_owned();
        let Formula::Piecewise { pieces, .. } = formula(&force) else { panic!("{force}") };
        assert!((number(&pieces[0].1, &[("b", 0.25)]) - number(&parsed(end), &[("b", 0.25)])).abs() < 1e-15, "{force}");
    }
}

/// A function of a place has values within the flat end as well: g, G and the steps keep the piece of 0.
#[test]
fn functions_of_a_place_keep_their_piece_of_zero() {
    let text = "piecewise(0, r<b, (r-b)*tan(theta))";
    let page = answer(&["derive", text, "--quantity", "g,G,F", "--symbols", "a=c", "--format", "latex"]);
    assert!(page.contains("g(x) &= \\begin{cases} 0") && page.contains("G(x) &= \\begin{cases} 0"), "{page}");
    assert!(page.contains(", \\quad c \\ge b"), "{page}");
    let steps = answer(&["derive", text, "--steps", "--format", "latex"]);
    assert!(steps.contains("g(x) = \\begin{cases} 0") || steps.contains("g(x) &= \\begin{cases} 0"), "{steps}");
}

fn parsed(text: &str) -> Expr {
    formula(text).as_closed().unwrap().clone()
}
