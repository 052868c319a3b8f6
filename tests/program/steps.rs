//! Steps: every equation that a derivation states holds in numbers, every rule's steps exist, and the short derivation has every result.
#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used)]

use sneddon::contact::{Edge, Formulas, Quantity, Step, relations, steps};
use sneddon::eval::constant_value;
use sneddon::expr::{Bindings, Expr, Formula, Number, Symbol};
use sneddon::transform::{Profile, Sampler, derive, rules::RULES};
use sneddon::{parse, print};
use sneddon_checks::seeds::cases;

/// Profiles of every kind: whole axis, segments, several terms, open terms, parameters called t.
const PROFILES: [&str; 24] = [
    "r^2/(2*R)",
    "r*tan(theta)",
    "C*r^n",
    "r^2.5",
    "r*tan(theta)+r^2/(2*R)",
    "R-sqrt(R^2-r^2)",
    "max(r^2/(2*R)-h,0)",
    "min(r*tan(theta),h)",
    "h*(1-exp(-r^2/w^2))",
    "w*(sqrt(1+r^2/w^2)-1)",
    "h*ln(1+r^2/w^2)",
    "h*r^2/(r^2+w^2)",
    "A*(cosh(r/L)-1)",
    "A*(1-cos(k*r))",
    "A*(1-besselj(0,k*r))",
    "C*(exp(r/L)-1)",
    "r^2*ln(1+r/R)",
    "t*r^2+r^4",
    "piecewise(0,r<b,(r-b)*tan(theta),r<c,(c-b)*tan(theta))",
    "max(r-b,0)^2/(2*R)",
    "r^2*atan(r/w)",
    "sinh(r)^3",
    "1+r^3/3",
    "r^4/(8*R^3)+r^2/(2*R)",
];

#[test]
fn stated_equations_hold() {
    let mut compared = 0;
    for text in PROFILES {
        let typed = parse::profile(text).unwrap();
        let solution = derive(&Profile::new(&typed).unwrap()).unwrap();
        let found = relations(&solution, &Edge::Smooth).unwrap();
        let list = steps(&typed, &solution, &Edge::Smooth, &found).unwrap();
        let mut values = Sampler::new(11).parameters(&solution).unwrap();
        // Inside of every domain, and beyond the first kinks for some of them.
        for x in [Expr::ratio(1, 40), Expr::ratio(3, 10), Expr::ratio(9, 10)] {
            values.insert(Symbol::new("x"), x.clone());
            compared += equal_in_terms(text, &list, &values, x.as_number().unwrap().to_f64());
        }
    }
    assert!(compared >= 100, "{compared} comparisons");
}

/// Compares every step that states g of a term with the integral over the slope that the term states.
fn equal_in_terms(text: &str, list: &[Step], values: &Bindings, x: f64) -> usize {
    let equivalent = list.iter().find(|step| step.title == "Equivalent profile").unwrap();
    let mut compared = 0;
    for term in &equivalent.steps {
        let slope = term.right.as_ref().unwrap().as_closed().unwrap();
        for step in term.steps.iter().filter(|step| step.left.as_ref().is_some_and(|left| left.starts_with('g'))) {
            if step.title == "Beyond the segment" || !applies(step, values) {
                continue;
            }
            let lower = lower_limit(term, values);
            if x <= lower * 1.001 {
                continue;
            }
            let wanted = x * abel(slope, lower, x, values);
            // Beyond the end of the profile nothing is stated.
            if wanted.is_nan() {
                continue;
            }
            let stated = number(step.right.as_ref().unwrap(), values);
            let close = (stated - wanted).abs() <= 1e-9 * wanted.abs();
            assert!(close, "{text}: {} at x = {x}: {stated} instead of {wanted}", step.title);
            compared += 1;
        }
    }
    compared
}

/// True where the place lies below the end of the segment that the step is about.
fn applies(step: &Step, values: &Bindings) -> bool {
    let reason = step.reason.written(print::Notation::Text);
    let Some((_, end)) = reason.rsplit_once("x <= ") else { return true };
    let end = number(&parse::formula(end.trim_end_matches('.')).unwrap(), values);
    let x = number(&Formula::Closed(Expr::symbol("x")), values);
    x < end
}

/// Where the segment of a term begins, as its reason says.
fn lower_limit(term: &Step, values: &Bindings) -> f64 {
    let reason = term.reason.written(print::Notation::Text);
    let begin = reason.strip_prefix("For ").and_then(|rest| rest.split_once(" <= r")).map(|(begin, _)| begin);
    begin.map_or(0.0, |begin| number(&parse::formula(begin).unwrap(), values))
}

/// ∫ f′/√(x² − r²) dr from `lower` to x.
fn abel(slope: &Expr, lower: f64, x: f64, values: &Bindings) -> f64 {
    let start = (lower / x).asin();
    tanh_sinh(start, std::f64::consts::FRAC_PI_2, |t| {
        let mut here = values.clone();
        here.insert(Symbol::new("r"), exact(x * t.sin()));
        number(&Formula::Closed(slope.clone()), &here)
    })
}

fn exact(value: f64) -> Expr {
    Expr::number(Number::from_f64(value).unwrap())
}

/// A formula in numbers; integrals by a rule of this test's own.
fn number(formula: &Formula, values: &Bindings) -> f64 {
    match formula {
        Formula::Closed(expr) => constant_value(&values.apply(expr), &Bindings::default()).unwrap().value,
        Formula::Sum(parts) => parts.iter().map(|part| number(part, values)).sum(),
        Formula::Scaled(factor, inner) => number(&Formula::Closed(factor.clone()), values) * number(inner, values),
        Formula::Piecewise { variable, pieces, last } => {
            let place = number(&Formula::Closed(Expr::from(variable.clone())), values);
            let inside = pieces.iter().find(|(_, end)| place < number(&Formula::Closed(end.clone()), values));
            inside.map_or_else(|| number(last, values), |(value, _)| number(value, values))
        }
        Formula::Integral { integrand, variable, lower, upper } => {
            let limit = |own: &Expr| number(&Formula::Closed(own.clone()), values);
            let (lower, upper) = (limit(lower), limit(upper));
            let angular = *variable != Symbol::new("r");
            let at = |place: f64| {
                let mut here = values.clone();
                here.insert(variable.clone(), exact(place));
                number(integrand, &here)
            };
            if angular {
                tanh_sinh(lower, upper, at)
            } else {
                tanh_sinh((lower / upper).asin(), std::f64::consts::FRAC_PI_2, |t| at(upper * t.sin()) * upper * t.cos())
            }
        }
    }
}

/// The double-exponential rule.
fn tanh_sinh(lower: f64, upper: f64, function: impl Fn(f64) -> f64) -> f64 {
    let length = upper - lower;
    let mut sum = 0.0;
    let step = 0.0625;
    for index in -72..=56 {
        let s = step * f64::from(index);
        let inner = std::f64::consts::FRAC_PI_2 * s.sinh();
        // The distance to the lower end keeps its digits.
        let place = lower + length / (1.0 + (-2.0 * inner).exp());
        let weight = std::f64::consts::FRAC_PI_2 * s.cosh() / inner.cosh().powi(2);
        if place > lower && place < upper {
            sum += weight * function(place);
        }
    }
    step * 0.5 * length * sum
}

#[test]
fn small_contacts_are_the_limit() {
    for (text, begin) in [
        ("R-sqrt(R^2-r^2)", "r^2/(2*R)"),
        ("h*(1-exp(-r^2/w^2))", "h*r^2/w^2"),
        ("A*(1-cos(k*r))", "A*k^2*r^2/2"),
        ("h*ln(1+r^4/w^4)", "h*r^4/w^4"),
        ("r*tan(theta)+r^2/(2*R)", "r*tan(theta)"),
        ("C*(exp(r/L)-1)", "C*r/L"),
    ] {
        let typed = parse::profile(text).unwrap();
        let solution = derive(&Profile::new(&typed).unwrap()).unwrap();
        let found = relations(&solution, &Edge::Smooth).unwrap();
        let list = steps(&typed, &solution, &Edge::Smooth, &found).unwrap();
        let step = list.iter().find(|step| step.title == "Small contacts").unwrap_or_else(|| panic!("{text} has no limit"));
        let difference = step.right.clone().unwrap().as_closed().unwrap() - parse::profile(begin).unwrap().as_closed().unwrap();
        let expanded = sneddon::expr::normal::expanded(&difference, &Symbol::new("r")).unwrap();
        assert!(expanded.is_zero(), "{text} begins as {}", print::text(step.right.as_ref().unwrap()));
    }
}

#[test]
fn every_rule_is_named_in_its_steps() {
    for rule in RULES {
        let typed = parse::profile(rule.pattern).unwrap();
        let solution = derive(&Profile::new(&typed).unwrap()).unwrap();
        let Ok(found) = relations(&solution, &Edge::Smooth) else { continue };
        let list = steps(&typed, &solution, &Edge::Smooth, &found).unwrap();
        let equivalent = list.iter().find(|step| step.title == "Equivalent profile").unwrap();
        let named = |step: &Step| step.reason.written(print::Notation::Text).contains("by the verified statement of the rule");
        let answered = equivalent.steps.iter().filter(|term| term.steps.iter().any(named)).count();
        assert!(answered > 0 || solution.terms().count() > 12, "{}", rule.id);
    }
}

#[test]
fn quantities_by_definition_have_the_values_of_eval() {
    const A: f64 = 0.7;
    for (f, set) in [("r^2/(2*R)", "R=3"), ("R-sqrt(R^2-r^2)", "R=2"), ("h*(1-exp(-r^2/w^2))", "h=1"), ("r*tan(theta)+r^2/(2*R)", "R=5")] {
        let mut typed = parse::profile(f).unwrap();
        let mut sets = vec![set.to_owned()];
        for name in ["w", "theta"].into_iter().filter(|name| f.contains(name)) {
            sets.push(format!("{name}=1.25"));
        }
        for own in &sets {
            let (name, value) = own.split_once('=').unwrap();
            typed = typed.substitute(&Bindings::one(name, parse::constant(value).unwrap()));
        }
        let profile = Profile::new(&typed).unwrap();
        let solution = derive(&profile).unwrap();
        let found = relations(&solution, &Edge::Smooth).unwrap();
        let all = Formulas { relations: &found, typed: &typed, solution: &solution, has_rim: false };
        for quantity in Quantity::ALL {
            // The integrals that remain in a pressure are singular at r; other tests compare pressures.
            let Some(derived) = quantity.formula(&all).filter(|_| *quantity != Quantity::Pressure) else { continue };
            // Over the contact radius, or at a place within and, for the surface, outside the contact.
            let places: &[f64] = match (quantity, quantity.coordinate()) {
                (Quantity::Displacement, _) => &[0.4, 1.1],
                (_, "a") => &[A],
                (_, "d") => &[0.15],
                _ => &[0.4],
            };
            for at in places {
                let values: Bindings = [("a", exact(A)), ("E", Expr::one()), (quantity.coordinate(), exact(*at))].into_iter().collect();
                let stated = number(&derived.formula, &values);
                let wanted = evaluated(f, &sets, *quantity, *at, A);
                assert!((stated - wanted).abs() <= 1e-9 * wanted.abs(), "{quantity:?} of {f} at {at}: {stated} instead of {wanted}");
            }
        }
    }
}

/// What `eval` answers.
fn evaluated(f: &str, sets: &[String], quantity: Quantity, at: f64, a: f64) -> f64 {
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_sneddon"));
    command.args(["eval", f, "--quantity", quantity.key(), "--at", &at.to_string(), "--json"]);
    if quantity.needs_radius() {
        command.args(["--radius", &a.to_string()]);
    }
    sets.iter().for_each(|own| {
        command.args(["--set", own]);
    });
    let done = command.output().unwrap();
    let document: serde_json::Value =
        serde_json::from_slice(&done.stdout).unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&done.stderr)));
    document["points"][0]["value"].as_f64().unwrap()
}

/// Arguments of `derive` of every kind: closed, in pieces, partly and wholly open, without a pressure, under a rim, with other names.
const DERIVED: [&[&str]; 14] = [
    &["r^2/(2*R)"],
    &["C*r^n"],
    &["1+r^2/(2*R)+r*tan(theta)"],
    &["R-sqrt(R^2-r^2)"],
    &["piecewise(0,r<b,(r^2-b^2)/(2*R))"],
    &["piecewise(0,r<b,(r-b)*tan(theta),r<c,(c-b)*tan(theta))"],
    &["max(r^2/(2*R)-h,0)+h*ln(1+r^3/w^3)"],
    &["ln(cosh(r))"],
    &["piecewise(0,r<0.3,sqrt(r^2-0.09))"],
    &["0", "--depth", "d"],
    &["-h*r^2/a^2", "--depth", "d"],
    &["r^2/(2*R)", "--depth", "0.3"],
    &["r^2/(2*R)", "--set", "R=12.73", "--symbols", "E=E_r", "--digits", "3"],
    &["r^2*atan(r/w)", "--inverse-hyperbolic", "log", "--quantity", "F"],
];

/// The keys of results with the left side and the title of their steps.
const RESULTS: [(&str, &[&str], &str); 7] = [
    ("g", &["g(x)"], "Equivalent profile"),
    ("d", &["d(a)", "d"], "Depth"),
    ("F", &["F(a)"], "Force"),
    ("p", &["p(r)"], "Pressure"),
    ("k", &["k(a)"], "Stiffness"),
    ("a_of_d", &["a(d)"], "Contact radius at a depth"),
    ("F_of_d", &["F(d)"], "Force at a depth"),
];

#[test]
fn the_short_derivation_has_every_result_once() {
    for arguments in DERIVED.into_iter().step_by(cases(2, 1)) {
        let plain = json("derive", &arguments.iter().copied().filter(|own| !["--quantity", "F"].contains(own)).collect::<Vec<_>>());
        let document = json("derive", &[arguments, &["--steps"]].concat());
        assert_eq!(document["steps"], json("derive", &[arguments, &["--steps=short"]].concat())["steps"]);
        let steps = document["steps"].as_array().unwrap();
        assert!((8..=12).contains(&steps.len()), "{arguments:?}: {} steps", steps.len());
        for step in steps {
            assert_eq!(step["steps"], serde_json::json!([]), "{arguments:?}: {step}");
            assert!(!step["reason"].as_str().unwrap().is_empty(), "{arguments:?}: {step}");
        }
        let with = |left: &str| steps.iter().filter(|own| own["left"]["text"] == left).collect::<Vec<_>>();
        assert_eq!((with("f(r)").len(), with("f'(r)").len()), (1, 1), "{arguments:?}");
        for (key, lefts, title) in RESULTS {
            let stated: Vec<_> = lefts.iter().flat_map(|left| with(left)).collect();
            let result = &plain[key];
            // Why there is no formula; F(d) shares the sentence about a(d). That d is d states nothing.
            if result.is_null() || result["text"] == "d" {
                let is_explained = steps.iter().any(|own| own["title"] == title && own["right"].is_null());
                assert!(stated.is_empty() && (is_explained || key == "F_of_d" || key == "a_of_d"), "{arguments:?}: {key}");
                continue;
            }
            let [step] = stated.as_slice() else { panic!("{arguments:?}: {} steps with {key}", stated.len()) };
            assert_eq!(step["title"], title);
            for notation in ["text", "latex"] {
                assert_eq!(step["right"][notation], result[notation], "{arguments:?}: {key}");
            }
            if !["g", "F", "p"].contains(&key) || arguments.contains(&"--digits") {
                continue;
            }
            assert_eq!(step["reference"], result["reference"], "{arguments:?}: {key}");
            let reason = step["reason"].as_str().unwrap();
            assert!(reason.contains("= ") && reason.contains("integral("), "{arguments:?}: {reason}");
            let rules = result["rules"].as_array().unwrap();
            assert!(rules.iter().all(|own| reason.contains(own.as_str().unwrap())), "{arguments:?}: {reason}");
            let stays = result["text"].as_str().unwrap().contains("integral(");
            assert_eq!(reason.contains("integral remains") || reason.contains("remaining integral"), stays, "{arguments:?}: {reason}");
        }
    }
}

#[test]
fn the_full_derivation_is_the_tree_of_the_library() {
    for text in PROFILES.into_iter().filter(|text| !text.contains('.')) {
        let typed = parse::profile(text).unwrap();
        let solution = derive(&Profile::new(&typed).unwrap()).unwrap();
        let found = relations(&solution, &Edge::Smooth).unwrap();
        let document = json("derive", &[text, "--steps=full"]);
        same(text, &steps(&typed, &solution, &Edge::Smooth, &found).unwrap(), &document["steps"]);
    }
}

/// Compares titles, equations and steps within steps.
fn same(text: &str, list: &[Step], written: &serde_json::Value) {
    let written = written.as_array().unwrap();
    assert_eq!(list.len(), written.len(), "{text}");
    for (step, own) in list.iter().zip(written) {
        assert_eq!(own["title"], step.title, "{text}");
        assert_eq!(own["left"]["text"].as_str(), step.left.as_deref(), "{text}: {}", step.title);
        assert_eq!(own["right"]["text"].as_str().map(str::to_owned), step.right.as_ref().map(print::text), "{text}: {}", step.title);
        same(text, &step.steps, &own["steps"]);
    }
}

#[test]
fn every_format_has_both_derivations() {
    for (command, given) in [("derive", "r*tan(theta)+r^2/(2*R)"), ("derive", "ln(cosh(r))"), ("invert", "x*atanh(x/R)")] {
        for format in ["text", "unicode", "latex", "markdown", "typst", "mathml"].into_iter().step_by(cases(4, 1)) {
            let [plain, short, full] =
                ["--steps", "--steps=short", "--steps=full"].map(|flag| answer(command, &[given, flag, "--format", format]));
            assert_eq!(plain, short);
            assert!(short.len() < full.len(), "{given} as {format}");
            let inner = |page: &str| page.contains("2.1 ") || page.contains("3.1 ");
            assert!(!inner(&short.replace("(3.1)", "")) && inner(&full), "{given} as {format}: {short}");
        }
    }
}

#[test]
fn the_short_inversion_has_the_result_and_its_definition() {
    for given in ["x*atanh(x/R)", "x^2/R", "ln(1+x^4/w^4)", "x^3*exp(sin(x))"] {
        let document = json("invert", &[given, "--steps"]);
        let [equivalent, profile] = document["steps"].as_array().unwrap().as_slice() else { panic!("{given}: {document}") };
        for (step, key) in [(equivalent, "g"), (profile, "f")] {
            assert_eq!(step["right"]["text"], document[key]["text"], "{given}");
            assert_eq!(step["steps"], serde_json::json!([]), "{given}");
        }
        assert!(profile["reason"].as_str().unwrap().contains("f(r) = 2/pi*integral(g(x)/sqrt(r^2 - x^2), x, 0, r)"), "{profile}");
        let full = json("invert", &[given, "--steps=full"]);
        assert!(!full["steps"][1]["steps"].as_array().unwrap().is_empty(), "{given}");
    }
}

#[test]
fn other_lengths_of_derivations_are_refused() {
    for (command, given) in [("derive", "r^2"), ("invert", "x^2")] {
        for refused in [&["--steps=long"][..], &["--steps="], &["--steps=Full"], &["--steps", "full"], &["--steps", "--steps=full"]] {
            let done = run(command, &[&[given], refused].concat());
            assert_eq!((done.status.code(), done.stdout.len()), (Some(2), 0), "{command} {refused:?}");
            assert!(!done.stderr.is_empty());
        }
    }
}

fn run(command: &str, arguments: &[&str]) -> std::process::Output {
    std::process::Command::new(env!("CARGO_BIN_EXE_sneddon")).arg(command).args(arguments).output().unwrap()
}

fn answer(command: &str, arguments: &[&str]) -> String {
    let done = run(command, arguments);
    assert!(done.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8(done.stdout).unwrap()
}

fn json(command: &str, arguments: &[&str]) -> serde_json::Value {
    serde_json::from_str(&answer(command, &[arguments, &["--json"]].concat())).unwrap()
}
