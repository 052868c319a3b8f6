//! The source's chapter 3, result by result: the derived formulas are the chapter's, and their numbers are right.
//!
//! (3.40)–(3.42) state constants of triangular and square punches; `tests/scenes` checks the punches that a scene describes by them.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use sneddon::contact::{Edge, Relations, SpringFoundation, relations};
use sneddon::expr::{Expr, Formula};
use sneddon::num::kappa::kappa;
use sneddon_checks::formulas::{contact, derived, derived_with, formula, number, relative, typed, value};
use sneddon_checks::random::Stream;

/// A name with the interval from which its value is drawn.
type Range = (&'static str, f64, f64);

/// Intervals for everything that the chapter names.
const RANGES: [Range; 12] = [
    ("E", 0.5, 9.0),
    ("R", 0.5, 5.0),
    ("R_1", 0.5, 5.0),
    ("theta", 0.05, 1.3),
    ("C", 0.2, 3.0),
    ("n", 0.3, 7.0),
    ("b", 0.2, 1.0),
    ("h", 0.01, 0.3),
    ("c", 0.5, 2.0),
    ("d", 0.01, 3.0),
    ("d_o", 0.6, 3.0),
    ("F_N", 0.1, 9.0),
];
/// Draws for every comparison of formulas.
const DRAWS: usize = 60;
/// Two formulas for one quantity agree to this; both are evaluated as they stand, so cancellation of the chapter's counts.
const SAME: f64 = 2e-13;

/// One draw: every parameter, r < a < 0.97 R and x, with R from its interval.
fn draw(stream: &mut Stream) -> Vec<(&'static str, f64)> {
    let mut values: Vec<(&str, f64)> = RANGES.iter().map(|(name, low, high)| (*name, stream.uniform(*low, *high))).collect();
    let big = values.iter().find(|(name, _)| *name == "R").unwrap().1;
    let a = big * stream.uniform(0.1, 0.97);
    values.extend([("a", a), ("x", a), ("r", a * stream.uniform(0.05, 0.95))]);
    values
}

/// The derived formula equals the one of the chapter at random admissible values.
fn same(equation: &str, derived: &Formula, chapter: &str) {
    let chapter = formula(chapter);
    let mut stream = Stream::new(equation.bytes().map(u64::from).sum());
    let mut compared = 0;
    while compared < DRAWS {
        let values = draw(&mut stream);
        let (own, theirs) = (value(derived, &values), value(&chapter, &values));
        assert!(relative(own, theirs) <= SAME, "{equation}: {own:e}, the chapter has {theirs:e} at {values:?}");
        compared += usize::from(own != 0.0);
    }
}

fn smooth(profile: &str) -> Relations {
    relations(&derived(profile), &Edge::Smooth).unwrap()
}

fn explicit(found: &Relations) -> (&Formula, &Formula) {
    (&found.contact_radius_of_depth.as_ref().unwrap().formula, &found.force_of_depth.as_ref().unwrap().formula)
}

#[test]
fn stiffness_and_springs() {
    // (3.1), (3.22): k = D E = 2 E a
    same("(3.1)", &smooth("r^2/(2*R)").stiffness.formula, "2*a*E");
    // (3.3)–(3.5): D/Δx springs of stiffness E Δx make up D E, whatever Δx is.
    for springs in [1, 7, 1000] {
        let state = SpringFoundation::new(|_| 0.0, 1.5, springs, 2.0).unwrap().indent(0.25);
        assert!(relative(state.stiffness, 2.0 * 3.0) < 1e-15);
        assert!(relative(state.force, 2.0 * 3.0 * 0.25) < 1e-14);
        assert!(relative(state.contact_radius, 1.5) < 1e-15);
    }
}

#[test]
fn hertz_by_foundation_and_by_the_rule_of_popov() {
    // (3.6)–(3.10): a foundation under x²/(2R₁), a = √(2R₁d), F = (4√2/3) E √(R₁ d³).
    let (r1, e, d) = (0.8, 3.0, 0.2f64);
    let a = (2.0 * r1 * d).sqrt();
    let state = SpringFoundation::new(|x| x * x / (2.0 * r1), 1.1 * a, 20_000, e).unwrap().indent(d);
    let exact = typed("4*sqrt(2)*E/3*sqrt(R_1*d^3)", &[("E", e), ("R_1", r1), ("d", d)]);
    // The sum's error is at most E Δx² g′(a)/2 here, relative 1e-8.
    assert!(relative(state.force, exact) < 1e-8);
    // The number of springs is whole: a is right to Δx.
    assert!((state.contact_radius - a).abs() <= 1.1 * a / 20_000.0);
    // (3.11)–(3.13): with R₁ = R/2 these are Hertz's.
    let hertz = smooth("r^2/(2*R)");
    same("(3.6), (3.11)", &hertz.g.formula, "x^2/(2*(R/2))");
    same("(3.12)", explicit(&hertz).0, "sqrt(R*d)");
    same("(3.10), (3.11)", explicit(&hertz).1, "4*sqrt(2)*E/3*sqrt(R/2*d^3)");
    same("(3.13)", explicit(&hertz).1, "4/3*E*sqrt(R*d^3)");
    // (3.38)–(3.39), σ = −p, with d = a²/R.
    same("(3.39)", &hertz.pressure.as_ref().unwrap().formula, "2/pi*E*(a^2/R/R)^(1/2)*sqrt(1-(r/a)^2)");
}

#[test]
fn rule_of_hess() {
    // Table 3.1 prints three decimals.
    let table = [1.311, 1.571, 2.0, 2.356, 2.667, 2.945, 3.2, 3.436, 3.657, 3.866, 4.063];
    for (index, printed) in table.into_iter().enumerate() {
        let n = if index == 0 { "1/2".to_owned() } else { index.to_string() };
        let own = value(&smooth(&format!("r^({n})")).g.formula, &[("x", 1.0)]);
        assert!((own - printed).abs() <= 0.5e-3 + 1e-12, "kappa({n}) = {own}");
        assert!(relative(own, kappa(if index == 0 { 0.5 } else { index as f64 })) < 1e-15);
    }
    let power = smooth("C*r^n");
    // (3.16), with Γ as (3.17) defines it
    same("(3.15)–(3.16)", &power.g.formula, "C*sqrt(pi)/2*n*gamma(n/2)/gamma(n/2+1/2)*x^n");
    same("(3.20)–(3.21)", &power.d.formula, "C*kappa(n)*a^n");
    same("(3.23)", &power.force.formula, "2*E*C*kappa(n)*n/(n+1)*a^(n+1)");
    same("(3.24), (3.46)", explicit(&power).1, "2*n/(n+1)*E*(C*kappa(n))^(-1/n)*d^((n+1)/n)");
    same("(3.45)", explicit(&power).0, "(d/(C*kappa(n)))^(1/n)");
}

#[test]
fn superposition() {
    // (3.18)–(3.19): each power by its own factor; (3.25)–(3.26): forces and depths add at the same a.
    let sum = smooth("C*r^n + h*r^3 + r^2/(2*R)");
    same("(3.19)", &sum.g.formula, "C*kappa(n)*x^n + h*kappa(3)*x^3 + kappa(2)*x^2/(2*R)");
    let parts = ["C*r^n", "h*r^3", "r^2/(2*R)"].map(smooth);
    let total = |pick: fn(&Relations) -> &Formula| Formula::sum(parts.iter().map(|part| pick(part).clone()));
    let mut stream = Stream::new(25);
    for _ in 0..DRAWS {
        let values = draw(&mut stream);
        for pick in [(|own| &own.force.formula) as fn(&Relations) -> &Formula, |own| &own.d.formula] {
            assert!(relative(value(pick(&sum), &values), value(&total(pick), &values)) < 4e-15);
        }
    }
}

#[test]
fn worn_paraboloid() {
    let worn = smooth("piecewise(0, r<b, (r^2-b^2)/(2*R))");
    // (3.27) with (3.29); the quadrature of the definition keeps eight digits.
    let (values, definition) = ([("x", 1.7), ("b", 0.6), ("R", 2.0)], "x*integral(r/R/sqrt(x^2-r^2), r, b, x)");
    assert!(relative(value(&worn.g.formula, &values), typed(definition, &values)) < 1e-7);
    same("(3.30)", &worn.g.formula, "piecewise(0, x<b, x/R*sqrt(x^2-b^2))");
    same("(3.32)", &worn.d.formula, "piecewise(0, a<b, a/R*sqrt(a^2-b^2))");
    same("(3.34)", &worn.force.formula, "piecewise(0, a<b, 2*E/(3*R)*(2*a^2+b^2)*sqrt(a^2-b^2))");
    // The chapter's (3.35) subtracts 1 from a root near 1; with d above 0.01 that costs three digits.
    let mut stream = Stream::new(35);
    let chapter = formula("sqrt(2)*E*b^3/(3*R)*(2+sqrt(1+(2*R/b^2*d)^2))*sqrt(-1+sqrt(1+(2*R/b^2*d)^2))");
    for _ in 0..DRAWS {
        let values = draw(&mut stream);
        assert!(relative(value(explicit(&worn).1, &values), value(&chapter, &values)) < 1e-10);
    }
    // (3.31): the foundation's own displacement d − g vanishes at the edge that a(d) gives.
    for _ in 0..DRAWS {
        let mut values = draw(&mut stream);
        let a = value(explicit(&worn).0, &values);
        values.push(("x", a));
        let depth = number(&Expr::symbol("d"), &values);
        assert!(relative(value(&worn.g.formula, &values), depth) < 1e-12);
    }
    // b → 0 gives Popov's rule back.
    let whole = smooth("piecewise(0, r<0.000001, (r^2-0.000001^2)/(2*R))");
    assert!(relative(value(&whole.g.formula, &[("x", 1.0), ("R", 2.0)]), 0.5) < 1e-12);
}

#[test]
fn problems_1_to_3() {
    let cone = smooth("r*tan(theta)");
    same("(3.43)", explicit(&cone).0, "2/pi*d/tan(theta)");
    same("(3.44)", explicit(&cone).1, "2/pi*E*d^2/tan(theta)");
    same("problem 1", &cone.g.formula, "pi/2*tan(theta)*x");
    let both = smooth("r^2/(2*R)+r*tan(theta)");
    same("(3.47)", &both.g.formula, "x^2/R+pi/2*x*tan(theta)");
    same("(3.48)", &both.d.formula, "a^2/R+pi/2*a*tan(theta)");
    same("(3.51)", &both.force.formula, "2*E*((a^2/R+pi/2*a*tan(theta))*a-a^3/(3*R)-pi/4*a^2*tan(theta))");
    // (3.49) and (3.52) as printed cancel for a steep cone and a small depth: up to five digits for these draws.
    let (radius, force) = explicit(&both);
    let (printed_radius, printed_force) = (
        formula("sqrt((pi/4*R*tan(theta))^2+R*d)-pi/4*R*tan(theta)"),
        formula(
            "pi^3*R^2*tan(theta)^3*E/96*(sqrt(1+16*d/(pi^2*R*tan(theta)^2))-1)\
             *(1+32*d/(R*pi^2*tan(theta)^2)-sqrt(1+16*d/(pi^2*R*tan(theta)^2)))",
        ),
    );
    let mut stream = Stream::new(52);
    for _ in 0..DRAWS {
        let values = draw(&mut stream);
        assert!(relative(value(radius, &values), value(&printed_radius, &values)) < 1e-11);
        assert!(relative(value(force, &values), value(&printed_force, &values)) < 1e-9);
    }
}

#[test]
fn flat_punch_and_cone_stress() {
    // (3.53)–(3.56): F = 2 E a d, p = F/(2π a √(a²−r²)).
    let punch = relations(&derived("0"), &Edge::Rim(Expr::symbol("d"))).unwrap();
    same("(3.53)", &punch.force.formula, "2*E*a*d");
    same("(3.56)", &punch.pressure.as_ref().unwrap().formula, "2*E*a*d/(2*pi*a*sqrt(a^2-r^2))");
    // Outside the contact the stress is 0, at the rim it is infinite.
    let solution = derived("0");
    let own = contact(&solution, &[], 2.0, Some(0.3));
    assert_eq!(own.pressure(1.1, 1.0).unwrap().unwrap().estimate.value, 0.0);
    assert!(own.pressure(1.0, 1.0).unwrap().is_err());
    assert!(relative(own.pressure(0.6, 1.0).unwrap().unwrap().estimate.value, 2.0 * 0.3 / (std::f64::consts::PI * 0.8)) < 1e-15);
    // (3.57)–(3.58): σ = −p
    let cone = smooth("r*tan(theta)");
    same("(3.57)–(3.58)", &cone.pressure.as_ref().unwrap().formula, "1/2*E*tan(theta)*ln(a/r+sqrt((a/r)^2-1))");
    let solution = derived("r*tan(theta)");
    let own = contact(&solution, &[("theta", 0.3)], 1.0, None);
    assert_eq!(own.pressure(2.0, 1.5).unwrap().unwrap().estimate.value, 0.0);
    assert!(own.pressure(0.0, 1.5).unwrap().is_err());
}

#[test]
fn concave_punch() {
    // (3.59)–(3.63): f = −h r²/c², complete contact a = c, d₀ the displacement of the centre.
    let profile = "-h*r^2/c^2";
    let found = relations(&derived(profile), &Edge::Rim(Expr::symbol("d_o"))).unwrap();
    let at_rim = |formula: &Formula| formula.substitute(&[("a", Expr::symbol("c"))].into_iter().collect());
    same("(3.60)", &found.g.formula, "-2*h/c^2*x^2");
    same("(3.61)", &at_rim(&found.force.formula), "2*E*c*(d_o+2/3*h)");
    let pressure = at_rim(&found.pressure.as_ref().unwrap().formula);
    let mut stream = Stream::new(63);
    for _ in 0..DRAWS {
        let mut values = draw(&mut stream);
        let c = number(&Expr::symbol("c"), &values);
        values.push(("r", c * stream.uniform(0.0, 0.99)));
        let chapter = typed("E/pi*(d_o-2*h+4*h*(r/c)^2)/sqrt(c^2-r^2)", &values);
        // d₀ ≥ 0.6 ≥ 2h: the two parts never cancel by more than their sum.
        assert!(relative(value(&pressure, &values), chapter) < 1e-13 || chapter.abs() < 1e-2);
    }
    // (3.59): inside, u = d₀ + h r²/c²; d₀ ≥ 2h is where the pressure at the centre changes its sign.
    let (h, c) = (0.25, 1.5);
    let solution = derived(profile);
    let at = |depth: f64, r: f64| {
        let own = contact(&solution, &[("h", h), ("c", c)], 2.0, Some(depth));
        (own.pressure(r, c).unwrap().unwrap().estimate, own.displacement(r, c).unwrap().estimate.value)
    };
    let (centre, _) = at(2.0 * h, 0.0);
    assert!(centre.value.abs() <= centre.error.max(1e-16), "{centre:?}");
    assert!(at(2.0 * h + 1e-9, 0.0).0.value > 0.0 && at(2.0 * h - 1e-9, 0.0).0.value < 0.0);
    assert!(relative(at(0.7, 0.9).1, 0.7 + h * 0.36) < 1e-15);
}

#[test]
fn problem_8_the_exact_sphere() {
    let sphere = smooth("R-sqrt(R^2-r^2)");
    same("(3.74)", &sphere.g.formula, "x*asinh(x/sqrt(R^2-x^2))");
    same("(3.74), logarithm", &sphere.g.formula, "1/2*x*ln((R+x)/(R-x))");
    same("(3.75)", &sphere.d.formula, "1/2*a*ln((R+a)/(R-a))");
    // (3.77), (3.78) as printed lose the digits of (R/a)²: a ≥ 0.1 R costs two.
    let mut stream = Stream::new(78);
    let printed =
        [formula("2*E*a*(1/2*a*ln((R+a)/(R-a))-R/2+(R^2-a^2)/(4*a)*ln((R+a)/(R-a)))"), formula("E*(R^2+a^2)/2*ln((R+a)/(R-a))-E*R*a")];
    for _ in 0..DRAWS {
        let values = draw(&mut stream);
        for chapter in &printed {
            assert!(relative(value(&sphere.force.formula, &values), value(chapter, &values)) < 1e-11);
        }
    }
    // The series that the chapter mentions: R − √(R²−r²) = Σ binomial terms, term by term through Heß's rule.
    let series = smooth("r^2/2+r^4/8+r^6/16+5*r^8/128+7*r^10/256+21*r^12/1024");
    let (x, own) = (0.05, smooth("1-sqrt(1-r^2)"));
    assert!(relative(value(&series.g.formula, &[("x", x)]), value(&own.g.formula, &[("x", x)])) < 1e-15);
}

/// Order of convergence of the spring foundation's force: the least squares slope of log error over log Δx.
///
/// The edge stays at the same place between two springs, so that the error is one power of Δx.
fn order(g: impl Fn(f64) -> f64, a: f64, d: f64, force: f64, pick: fn(sneddon::contact::FoundationState) -> f64) -> f64 {
    let mut points = Vec::new();
    for springs in [200, 400, 800, 1600, 3200, 6400] {
        let spacing = a / (f64::from(springs) + 0.25);
        let count = springs as usize + 3;
        let state = SpringFoundation::new(&g, spacing * count as f64, count, 1.0).unwrap().indent(d);
        points.push((spacing.ln(), relative(pick(state), force).ln()));
    }
    let mean = |f: fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / points.len() as f64;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>() / points.iter().map(|p| (p.0 - x).powi(2)).sum::<f64>()
}

#[test]
fn the_foundation_converges_to_the_exact_solution() {
    // Theory: the midpoint sum of d − g has an error Δx² from the edge, where it is a ramp; under x^n with n < 1 the
    // tip gives Δx^(n+1). Contact radius and stiffness count springs: order 1.
    for (profile, values, a, expected) in [
        ("r^2/(2*R)", &[("R", 2.0)] as &[_], 0.7, 2.0),
        ("r*tan(theta)", &[("theta", 0.4)], 0.7, 2.0),
        ("R-sqrt(R^2-r^2)", &[("R", 2.0)], 1.5, 2.0),
        ("C*r^(1/2)", &[("C", 0.7)], 0.7, 1.5),
    ] {
        let solution = derived_with(profile, values);
        let own = contact(&solution, &[], 1.0, None);
        let g = |x: f64| own.evaluator().equivalent(x).map_or(f64::INFINITY, |g| g.estimate.value);
        let (d, force) = (g(a), own.force(a).unwrap().estimate.value);
        let measured = order(g, a, d, force, |state| state.force);
        assert!((measured - expected).abs() < 0.03, "{profile}: order {measured}");
        let radius = order(g, a, d, a, |state| state.contact_radius);
        assert!((radius - 1.0).abs() < 0.01, "{profile}: order of a {radius}");
        let stiffness = order(g, a, d, own.stiffness(a).unwrap().estimate.value, |state| state.stiffness);
        assert!((stiffness - 1.0).abs() < 0.01, "{profile}: order of k {stiffness}");
    }
}
