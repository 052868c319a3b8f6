//! Quadrature of the catalogue's profiles as they are typed: what it costs in evaluations of f′, and that p comes out by itself.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use serde_json::Value;
use sneddon::expr::{Bindings, Expr};
use sneddon::num::Bounded;
use sneddon::parse;
use sneddon::transform::{Evaluator, Method, NumericProfile, Profile, Solution, derive};
use sneddon_checks::decimal::Decimal;
use sneddon_checks::random::Stream;

const TOLERANCE: f64 = 1e-12;

/// Most evaluations for g at the first and at the last of the catalogue's places, for F, and for p in the middle of its places.
const COUNTS: [(&str, [u64; 4]); 30] = [
    ("cone", [2, 2, 6, 144]),
    ("paraboloid", [2, 2, 2, 30]),
    ("quartic", [2, 2, 2, 30]),
    ("sqrt", [932, 932, 200, 2186]),
    ("power_n", [172, 172, 102, 1464]),
    ("cone_paraboloid", [5, 5, 7, 288]),
    ("poly10", [7, 12, 12, 1346]),
    ("power_log", [24, 40, 40, 480]),
    // f′ has a logarithm at the axis: its bounds are proven by enclosures, which take more values than an estimate.
    ("r2_log_r", [250, 262, 126, 1554]),
    ("sphere", [2, 12, 24, 1350]),
    ("ellipsoid", [2, 12, 24, 1346]),
    ("hyperboloid", [2, 28, 28, 96]),
    ("lorentzian", [3, 40, 40, 676]),
    ("waviness", [2, 8, 9, 30]),
    ("wavy_paraboloid", [2, 8, 8, 30]),
    ("gaussian", [2, 12, 12, 84]),
    ("exp_growth", [6, 12, 14, 800]),
    ("log_quadratic", [2, 32, 32, 96]),
    ("r_arctan", [2, 32, 32, 96]),
    ("log_linear", [6, 20, 20, 480]),
    ("erf", [6, 22, 22, 1228]),
    ("r2_gauss", [2, 14, 14, 676]),
    ("ln_cosh", [2, 24, 24, 96]),
    ("worn_paraboloid", [0, 2, 2, 1310]),
    ("truncated_cone", [0, 2, 6, 1350]),
    ("rounded_edge_punch", [0, 5, 7, 1316]),
    ("capped_cone", [2, 23, 27, 1382]),
    ("worn_sphere", [0, 12, 24, 1338]),
    ("worn_cosine", [0, 6, 6, 1272]),
    ("concave_paraboloid", [2, 2, 2, 30]),
];

fn each(mut visit: impl FnMut(&str, &NumericProfile, &Value)) {
    let truth: Value = serde_json::from_str(include_str!("../data/truth.json")).unwrap();
    let profiles: Value = serde_json::from_str(include_str!("../data/profiles.json")).unwrap();
    for profile in profiles.as_array().unwrap() {
        let id = profile["id"].as_str().unwrap();
        let parameters = profile["params"].as_object().unwrap().iter();
        let bindings: Bindings = parameters.map(|(name, v)| (name.as_str(), parse::constant(v.as_str().unwrap()).unwrap())).collect();
        let formula = parse::profile(profile["f"].as_str().unwrap()).unwrap();
        let solution: Solution = derive(&Profile::new(&formula.substitute(&bindings)).unwrap()).unwrap();
        let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Quadrature, TOLERANCE).unwrap();
        visit(id, evaluator.typed().unwrap(), &truth[id]);
    }
}

/// The catalogue's places of a quantity with their true values.
fn places<'a>(truth: &'a Value, quantity: &str) -> Vec<(f64, &'a str)> {
    let mut list: Vec<_> =
        truth[quantity].as_object().unwrap().iter().map(|(at, value)| (at.parse().unwrap(), value.as_str().unwrap())).collect();
    list.sort_by(|one: &(f64, &str), two| one.0.total_cmp(&two.0));
    list
}

#[test]
fn evaluations_per_profile() {
    let mut off = Vec::new();
    each(|id, typed, truth| {
        let slope = |x: f64| typed.equivalent(x, TOLERANCE).unwrap().evaluations;
        let (g, p) = (places(truth, "g"), places(truth, "p"));
        let a: f64 = truth["a"].as_str().unwrap().parse().unwrap();
        let pressure = p.get(p.len() / 2).map_or(0, |(r, _)| typed.pressure(*r, a, TOLERANCE).unwrap().map_or(0, |own| own.evaluations));
        let own = [slope(g[0].0), slope(g[g.len() - 1].0), typed.force(a, TOLERANCE).unwrap().evaluations, pressure];
        let most = COUNTS.iter().find(|(name, _)| *name == id).map_or([0; 4], |(_, most)| *most);
        if own.iter().zip(most).any(|(own, most)| *own > most) {
            off.push(format!("(\"{id}\", {own:?}),"));
        }
    });
    assert!(off.is_empty(), "more evaluations than before:\n{}", off.join("\n"));
}

/// The one rule that f′ itself says is enough, against the closed form: at places of every size, with estimates that hold and a fraction
/// of the evaluations that the other rules take.
#[test]
fn rules_that_are_known_to_suffice() {
    let mut stream = Stream::new(20_261_122);
    let (mut met, mut all) = (0, 0);
    for (text, end, most) in [
        ("r^2/(2*R)", 1e9, 2),
        ("r - r^3/9", 1e3, 8),
        ("h*(1-exp(-r^2/q))", 6.0, 56),
        ("h*(1-cos(k*r))", 10.0, 24),
        ("R-sqrt(R^2-r^2)", 0.69, 16),
        ("sqrt(h^2+r^2)-h", 4.0, 40),
        ("R*(exp(r/R)-1)", 20.0, 24),
        ("h*ln(1+r^2/q)", 4.0, 48),
        ("h*max(0, r-b)", 1e3, 7),
        ("piecewise(0, r<b, (r^2-b^2)/(2*R))", 1e6, 2),
        ("h*r^2/(q+r^2)", 4.0, 48),
        ("r*atan(r/R)", 3.0, 48),
    ] {
        let numbers: Bindings =
            [("R", 1), ("h", 2), ("q", 3), ("k", 2), ("b", 1)].map(|(name, v)| (name, Expr::integer(v))).into_iter().collect();
        let formula = parse::profile(text).unwrap().substitute(&numbers);
        let solution = derive(&Profile::new(&formula).unwrap()).unwrap();
        let own = Evaluator::new(&solution, &Bindings::default(), Method::Quadrature, TOLERANCE).unwrap();
        let closed = Evaluator::new(&solution, &Bindings::default(), Method::Exact, 1e-15).unwrap();
        for _ in 0..200 {
            let x = stream.log_uniform(1e-7, 1.0) * end;
            for (found, truth) in
                [(own.equivalent(x), closed.equivalent(x)), (own.force(x), closed.force(x)), (own.integral(x), closed.integral(x))]
            {
                let (found, truth) = (found.unwrap().estimate, truth.unwrap().estimate);
                let off = (found.value - truth.value).abs();
                assert!(off <= found.error + truth.error, "{text} at {x}: {found:?}, is {truth:?}");
                assert!(found.evaluations <= most, "{text} at {x}: {found:?}");
                met += usize::from(found.error <= TOLERANCE * found.value.abs());
                all += 1;
            }
        }
    }
    // What cancels does not.
    assert!(100 * met > 98 * all, "{met} of {all} within the tolerance");
}

/// One integral of f′ and f″ with Carlson's kernel, no closed form and no expansion: 1e−13 at every place of the catalogue.
#[test]
fn pressures_by_one_integral() {
    let mut places_seen = 0;
    let mut worst: (f64, String) = (0.0, String::new());
    each(|id, typed, truth| {
        let a: f64 = truth["a"].as_str().unwrap().parse().unwrap();
        for (r, exact) in places(truth, "p") {
            let found = typed.pressure_by_elliptic_kernel(r, a, 1e-13).unwrap().unwrap();
            let own = found.bounded() * Bounded::rounded(std::f64::consts::FRAC_1_PI);
            let exact = Decimal::read(exact);
            let relative = exact.relative(own.value);
            // The places are decimals, which doubles round.
            assert!(exact.distance(own.value).abs() <= own.error + 1e-15 * own.value.abs(), "{id}: p({r}) {own:?}, off by {relative:e}");
            if relative > worst.0 {
                worst = (relative, format!("{id}: p({r}), {own:?}"));
            }
            places_seen += 1;
        }
    });
    assert!(places_seen >= 60, "{places_seen}");
    assert!(worst.0 <= 1e-13, "{worst:?}");
}
