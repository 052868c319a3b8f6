//! The open catalogue: every profile answers, right to its own error estimate, against values with 40 to 50 digits.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use serde_json::Value;
use sneddon::contact::{Contact, Edge, relations};
use sneddon::expr::{Bindings, Expr};
use sneddon::transform::{self, Evaluator, Method, Profile, Reading, Solution, Status, Verdict, derive};
use sneddon::{expr::Formula, parse};
use sneddon_checks::decimal::Decimal;
use sneddon_checks::formulas;
use sneddon_checks::seeds::{cases, sample};

/// The profiles that must have closed formulas for g, d and F, right to 8 ulp.
const EXACT: [&str; 15] = [
    "cone",
    "paraboloid",
    "quartic",
    "sqrt",
    "power_n",
    "cone_paraboloid",
    "poly10",
    "sphere",
    "ellipsoid",
    "hyperboloid",
    "worn_paraboloid",
    "truncated_cone",
    "rounded_edge_punch",
    "capped_cone",
    "concave_paraboloid",
];
/// The bar for them.
const MOST_ULPS: f64 = 8.0;
/// The bar for every other number, relative.
const TOLERANCE: f64 = 1e-12;

/// One profile of the catalogue with its true values.
struct Entry {
    id: String,
    formula: Formula,
    /// Parameters as the exact decimals that were typed: they carry no rounding into the comparison.
    bindings: Bindings,
    truth: Value,
}

fn entries() -> Vec<Entry> {
    let truth: Value = serde_json::from_str(include_str!("../data/truth.json")).unwrap();
    let profiles: Value = serde_json::from_str(include_str!("../data/profiles.json")).unwrap();
    let entry = |profile: &Value| {
        let id = profile["id"].as_str().unwrap().to_owned();
        let bindings = profile["params"].as_object().unwrap().iter();
        Entry {
            formula: parse::profile(profile["f"].as_str().unwrap()).unwrap(),
            bindings: bindings.map(|(name, v)| (name.as_str(), parse::constant(v.as_str().unwrap()).unwrap())).collect(),
            truth: truth[&id].clone(),
            id,
        }
    };
    profiles.as_array().unwrap().iter().map(entry).collect()
}

impl Entry {
    /// Derived with its parameters set, and derived with symbols.
    fn solutions(&self) -> (Solution, Solution) {
        let symbolic = Profile::new(&self.formula).unwrap();
        let set = symbolic.substitute(&self.bindings).unwrap();
        (derive(&set).unwrap(), derive(&symbolic).unwrap())
    }

    fn text(&self, key: &str) -> &str {
        self.truth[key].as_str().unwrap()
    }

    fn map(&self, key: &str) -> impl Iterator<Item = (&str, &str)> {
        self.truth[key].as_object().unwrap().iter().map(|(at, value)| (at.as_str(), value.as_str().unwrap()))
    }

    fn is_exact(&self) -> bool {
        EXACT.contains(&self.id.as_str())
    }
}

fn contact<'a>(solution: &'a Solution, bindings: &Bindings) -> Contact<'a> {
    Contact::new(Evaluator::new(solution, bindings, Method::Auto, 1e-13).unwrap(), 1.0, None, 1e-13)
}

/// The true value, given at a decimal point, moved to the nearest f64 of that point: q + q′ δ.
///
/// δ is half an ulp at most, so that q′ needs no more than a few digits and the next term is below 1e-30.
fn moved(truth: &str, at: &str, quantity: impl Fn(f64) -> f64) -> Decimal {
    let (point, step) = (at.parse::<f64>().unwrap(), 1e-5);
    let slope = (quantity(point * (1.0 + step)) - quantity(point * (1.0 - step))) / (2.0 * step * point);
    let shift = Decimal::read(at).distance(point);
    Decimal::read(truth).moved(if shift == 0.0 { 0.0 } else { slope * shift })
}

/// Holds a reading against the truth: within its own error estimate, and within the bar.
fn hold(what: &str, reading: Reading, truth: &Decimal, ulps: bool) {
    let value = reading.estimate.value;
    let distance = truth.distance(value).abs();
    // What moved the truth to an f64 point has six digits next to an equator, of a shift below 1e-16: the bounds are tighter.
    let unknown = 1e-22 * value.abs();
    assert!(
        distance <= reading.estimate.error + unknown,
        "{what} = {value:e}: off by {distance:e}, estimated {:e}",
        reading.estimate.error
    );
    if ulps {
        assert!(truth.ulps(value) <= MOST_ULPS, "{what} = {value:e}: {:.1} ulp", truth.ulps(value));
    } else {
        assert!(truth.relative(value) <= TOLERANCE, "{what} = {value:e}: relative {:e}", truth.relative(value));
    }
}

/// g, d, F, G and p of every profile, with parameters set before the derivation and after it.
#[test]
fn every_profile_is_right() {
    let mut seen = 0;
    for (number, entry) in entries().into_iter().enumerate() {
        let (set, symbolic) = entry.solutions();
        let none = Bindings::default();
        let (first, second) = (contact(&set, &none), contact(&symbolic, &entry.bindings));
        for (way, own) in sample([("set", &first), ("bound", &second)], number, 2) {
            let what = |name: &str, at: &str| format!("{} ({way}): {name}({at})", entry.id);
            let slope = |x: f64| own.evaluator().equivalent(x).unwrap();
            for (x, truth) in entry.map("g") {
                let truth = moved(truth, x, |x| slope(x).estimate.value);
                hold(&what("g", x), slope(x.parse().unwrap()), &truth, entry.is_exact());
                seen += 1;
            }
            let text = entry.text("a");
            let a: f64 = text.parse().unwrap();
            let force = |a: f64| own.force(a).unwrap();
            hold(&what("F", text), force(a), &moved(entry.text("F"), text, |a| force(a).estimate.value), entry.is_exact());
            hold(&what("d", text), own.depth(a).unwrap(), &moved(entry.text("d"), text, |a| slope(a).estimate.value), entry.is_exact());
            let integral = |a: f64| own.integral(a).unwrap();
            hold(&what("G", text), integral(a), &moved(entry.text("G"), text, |a| integral(a).estimate.value), false);
            for (r, truth) in entry.map("p") {
                let pressure = |r: f64, a: f64| own.pressure(r, a).unwrap().unwrap();
                let at_r = moved(truth, r, |r| pressure(r, a).estimate.value);
                let point: f64 = r.parse().unwrap();
                let by_a =
                    Decimal::read(text).distance(a) * (pressure(point, a * (1.0 + 1e-7)).estimate.value / at_r.to_f64() - 1.0) / (1e-7 * a);
                hold(&what("p", r), pressure(point, a), &at_r.moved(by_a * at_r.to_f64()), false);
            }
        }
    }
    assert!(seen >= cases(1, 2) * 30 * 3);
}

/// Setting the parameters before the derivation or after it gives one number, within the two error estimates.
#[test]
fn the_order_of_deriving_and_setting_does_not_matter() {
    for entry in entries() {
        let (set, symbolic) = entry.solutions();
        let none = Bindings::default();
        let (first, second) = (contact(&set, &none), contact(&symbolic, &entry.bindings));
        let a: f64 = entry.text("a").parse().unwrap();
        let same = |one: Reading, two: Reading, what: &str| {
            let difference = (one.estimate.value - two.estimate.value).abs();
            assert!(difference <= one.estimate.error + two.estimate.error, "{}: {what} differ by {difference:e}", entry.id);
        };
        for part in (1..20).step_by(cases(4, 1)) {
            let x = a * f64::from(part) / 20.0;
            same(first.evaluator().equivalent(x).unwrap(), second.evaluator().equivalent(x).unwrap(), "g");
            same(first.force(x).unwrap(), second.force(x).unwrap(), "F");
            same(first.integral(x).unwrap(), second.integral(x).unwrap(), "G");
            if let (Ok(one), Ok(two)) = (first.pressure(0.7 * x, x).unwrap(), second.pressure(0.7 * x, x).unwrap()) {
                same(one, two, "p");
            }
        }
    }
}

/// The fifteen named profiles have closed formulas for g, d and F, with symbols and with numbers.
#[test]
fn closed_formulas_where_they_are_demanded() {
    let mut found = Vec::new();
    for entry in entries().into_iter().filter(Entry::is_exact) {
        let (set, symbolic) = entry.solutions();
        for solution in [&set, &symbolic] {
            assert!(solution.is_closed(), "{}", entry.id);
            let relations = relations(solution, &Edge::Smooth).unwrap();
            for derived in [&relations.g, &relations.d, &relations.force, &relations.stiffness] {
                assert_eq!(derived.status, Status::Exact, "{}", entry.id);
                assert!(!derived.formula.has_integral(), "{}", entry.id);
            }
        }
        found.push(entry.id);
    }
    assert_eq!(found.len(), EXACT.len());
}

/// The shown formulas, integrals included, are the evaluated numbers: to 1e-7, which the integrals' ends leave.
#[test]
fn shown_formulas_are_the_numbers() {
    for entry in entries() {
        let (set, symbolic) = entry.solutions();
        let values: Vec<(String, f64)> = entry.bindings.iter().map(|(s, v)| (s.name().to_owned(), formulas::number(v, &[]))).collect();
        for (solution, bound) in [(&set, false), (&symbolic, true)] {
            let own = contact(&symbolic, &entry.bindings);
            let relations = relations(solution, &Edge::Smooth).unwrap();
            let a: f64 = entry.text("a").parse().unwrap();
            for part in if bound { [0.31] } else { [0.83] } {
                let (x, r) = (part * a, part * part * a);
                let mut at = vec![("E", 1.0), ("x", x), ("a", x), ("r", r)];
                if bound {
                    at.extend(values.iter().map(|(name, v)| (name.as_str(), *v)));
                }
                for (name, shown, number) in [
                    ("g", &relations.g, own.evaluator().equivalent(x).unwrap()),
                    ("d", &relations.d, own.evaluator().equivalent(x).unwrap()),
                    ("F", &relations.force, own.force(x).unwrap()),
                    ("p", relations.pressure.as_ref().unwrap(), own.pressure(r, x).unwrap().unwrap()),
                ] {
                    let shown = formulas::value(&shown.formula, &at);
                    let number = number.estimate.value;
                    assert!(formulas::relative(shown, number) < 1e-7, "{}: {name} shown as {shown:e}, is {number:e}", entry.id);
                }
            }
        }
    }
}

/// Formulas of many pieces are sums over the pieces, each of which counts within its interval and beyond it.
#[test]
fn formulas_of_many_pieces_are_the_numbers() {
    let kinds: [fn(&str) -> String; 4] = [
        |r| format!("C*{r}"),
        |r| format!("({r})^2/(4*b)"),
        |r| format!("(-sqrt((15*b)^2-({r})^2))"),
        // Without a rule for a bounded segment.
        |r| format!("b*ln(2+sin({r}/b))"),
    ];
    // Every piece begins at the height where the one before it ends.
    let (mut pieces, mut height) = (Vec::new(), "0".to_owned());
    for i in 0..12 {
        let (begin, end) = (format!("({i}*b)"), format!("({}*b)", i + 1));
        pieces.push(format!("{height}+{}-{}", kinds[i % 4]("r"), kinds[i % 4](&begin)));
        height = format!("({height}+{}-{})", kinds[i % 4](&end), kinds[i % 4](&begin));
    }
    let list: Vec<String> = (1..).zip(&pieces).take(11).map(|(i, own)| format!("{own}, r<{i}*b")).collect();
    let text = format!("piecewise({}, {})", list.join(", "), pieces[11]);
    let solution = derive(&Profile::new(&parse::profile(&text).unwrap()).unwrap()).unwrap();
    let (b, c) = (0.25, 0.4);
    let set: Bindings = [("b", Expr::ratio(1, 4)), ("C", Expr::ratio(2, 5))].into_iter().collect();
    let own = contact(&solution, &set);
    let shown = relations(&solution, &Edge::Smooth).unwrap();
    for x in [0.2, 0.6, 1.3, 1.9, 2.6, 2.9] {
        for r in [0.3 * x, 0.9 * x] {
            let at = [("E", 1.0), ("x", x), ("a", x), ("r", r), ("b", b), ("C", c)];
            for (name, formula, number) in [
                ("g", &shown.g.formula, own.evaluator().equivalent(x).unwrap()),
                ("F", &shown.force.formula, own.force(x).unwrap()),
                ("p", &shown.pressure.as_ref().unwrap().formula, own.pressure(r, x).unwrap().unwrap()),
            ] {
                let (formula, number) = (formulas::value(formula, &at), number.estimate.value);
                assert!(formulas::relative(formula, number) < 1e-7, "{name} at x = {x}, r = {r}: {formula:e} and {number:e}");
            }
        }
    }
}

/// The program's own check passes on every profile, with symbols and with numbers.
#[test]
fn the_check_passes() {
    for (number, entry) in entries().into_iter().enumerate() {
        let (set, symbolic) = entry.solutions();
        for solution in sample([&set, &symbolic], number, 6) {
            let outcome = transform::check(solution).unwrap();
            if solution.terms().all(|term| term.is_open()) {
                assert!(outcome.verdict == Verdict::NotCompared && outcome.points == 0, "{}: {outcome:?}", entry.id);
                continue;
            }
            assert!(outcome.passed() && outcome.points >= 32, "{}: {outcome:?}", entry.id);
        }
    }
    // A check that is given a wrong answer fails: the force of the cone with another coefficient.
    let mut wrong = derive(&Profile::new(&parse::profile("r*tan(theta)").unwrap()).unwrap()).unwrap();
    let answer = &mut wrong.chains[0].intervals[0].terms[0].answer.as_mut().unwrap().1;
    answer.force.within = answer.force.within.scaled(&(Expr::one() + Expr::ratio(1, 1_000_000_000)));
    assert!(!transform::check(&wrong).unwrap().passed());
}
