//! Laws that hold for every profile: superposition, scaling, stiffness, balance of force and energy, inversion, rewriting.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use sneddon::contact::{Contact, Edge, relations};
use sneddon::expr::{Bindings, Symbol, derivative, normal};
use sneddon::num::quadrature::{Options, Panel, Point, integrate};
use sneddon::num::{Bounded, Estimate};
use sneddon::transform::{Evaluator, Method, Status};
use sneddon_checks::formulas::{bindings, contact, derived, derived_with, formula, number, relative, typed, value};
use sneddon_checks::random::Stream;
use sneddon_checks::seeds::cases;
use std::f64::consts::PI;

/// Profiles with closed and with open terms; H scales the height and L the radius.
const TEMPLATES: [&str; 11] = [
    "H*(L*r)^2/4",
    "H*(L*r)^(3/2)",
    "H*(L*r*tan(3/10)+(L*r)^2/4)",
    "H*(4-sqrt(16-(L*r)^2))",
    "H*(sqrt(1+(L*r)^2/2)-1)",
    "piecewise(0, r<(1/2)/L, H*((L*r)^2-1/4))",
    "piecewise(0, r<(1/2)/L, H*(L*r-1/2))",
    "piecewise(H*(L*r)^2, r<(1/2)/L, H*(L*r-1/4))",
    "piecewise(0, r<(1/2)/L, H*(sqrt(16-1/4)-sqrt(16-(L*r)^2)))",
    "H*(1-exp(-(L*r)^2/9))",
    "H*ln(1+(L*r)^2/2)",
];

/// The template with numbers for H and L.
fn profile(template: &str, height: &str, length: &str) -> String {
    template.replace('H', &format!("({height})")).replace('L', &format!("({length})"))
}

fn plain(template: &str) -> String {
    profile(template, "1", "1")
}

/// Equal within the sum of both error estimates, which must be small themselves.
fn same(what: &str, one: Estimate, two: Estimate) {
    let (difference, allowed) = ((one.value - two.value).abs(), one.error + two.error);
    assert!(difference <= allowed, "{what}: {} and {} differ by {difference:e} > {allowed:e}", one.value, two.value);
    assert!(allowed <= 1e-9 * one.value.abs().max(two.value.abs()), "{what}: known to {allowed:e} only");
}

fn scaled(estimate: Estimate, factor: f64) -> Estimate {
    Estimate::from_bounded(estimate.bounded() * Bounded::rounded(factor), 0)
}

fn pressure(own: &Contact<'_>, r: f64, a: f64) -> Option<Estimate> {
    own.pressure(r, a).unwrap().ok().map(|reading| reading.estimate)
}

/// (3.25)–(3.26): at equal a, g, F, p and G of α f₁ + β f₂ are α times the first plus β times the second.
#[test]
fn solutions_superpose() {
    let mut stream = Stream::new(11);
    for _ in 0..25 {
        let (first, second) = (plain(stream.pick::<&str>(&TEMPLATES)), plain(stream.pick::<&str>(&TEMPLATES)));
        // Positive factors, so that the sum does not cancel below its parts' errors.
        let (alpha, beta) = (stream.short(0.1, 3.0), stream.short(0.1, 3.0));
        let sum = derived(&format!("{alpha}*({first})+{beta}*({second})"));
        let (one, two) = (derived(&first), derived(&second));
        let [sum, one, two] = [&sum, &one, &two].map(|solution| contact(solution, &[], 2.0, None));
        let (a, part) = (stream.uniform(0.6, 2.5), stream.uniform(0.1, 0.9));
        let add = |u: Estimate, v: Estimate| scaled(u, alpha) + scaled(v, beta);
        let what = format!("{alpha}*({first})+{beta}*({second}) at {a}");
        let slope = |own: &Contact<'_>| own.evaluator().equivalent(a).unwrap().estimate;
        let force = |own: &Contact<'_>| own.force(a).unwrap().estimate;
        let integral = |own: &Contact<'_>| own.integral(a).unwrap().estimate;
        same(&what, slope(&sum), add(slope(&one), slope(&two)));
        same(&what, force(&sum), add(force(&one), force(&two)));
        same(&what, integral(&sum), add(integral(&one), integral(&two)));
        let at = |own: &Contact<'_>| pressure(own, part * a, a).unwrap();
        same(&what, at(&sum), add(at(&one), at(&two)));
    }
}

/// f → C f(λ r): g → C g(λx), F → (C/λ) F(λa), p → C λ p(λr; λa).
#[test]
fn solutions_scale() {
    let mut stream = Stream::new(12);
    for template in TEMPLATES {
        // Powers of two keep λa exact.
        for (height, length) in [("1000", 1024.0), ("1/1000", 1.0 / 64.0), ("3", 0.5)] {
            let c = typed(height, &[]);
            let own = derived(&plain(template));
            let other = derived(&profile(template, height, &format!("{length}")));
            let (own, other) = (contact(&own, &[], 1.0, None), contact(&other, &[], 1.0, None));
            let (a, part) = (stream.uniform(0.6, 2.5), stream.uniform(0.1, 0.9));
            let what = format!("{template} with H = {height}, L = {length} at {a}");
            let slope = |own: &Contact<'_>, x| own.evaluator().equivalent(x).unwrap().estimate;
            same(&what, slope(&other, a / length), scaled(slope(&own, a), c));
            let force = |own: &Contact<'_>, a| own.force(a).unwrap().estimate;
            same(&what, force(&other, a / length), scaled(force(&own, a), c / length));
            let (r, at) = (part * a, pressure(&own, part * a, a).unwrap());
            same(&what, pressure(&other, r / length, a / length).unwrap(), scaled(at, c * length));
        }
    }
}

/// The derivative from six points: error h⁶, so that h = 1e-2 of a leaves about 1e-12, and 1e-13 of noise.
fn rate(f: impl Fn(f64) -> f64, at: f64) -> f64 {
    let h = 1e-2 * at;
    let pair = |k: f64| f(at + k * h) - f(at - k * h);
    (45.0 * pair(1.0) - 9.0 * pair(2.0) + pair(3.0)) / (60.0 * h)
}

/// (3.22): dF = 2 E a dd; and the energy that the contact stores is the work, dU = F dd.
#[test]
fn stiffness_and_work() {
    let mut stream = Stream::new(13);
    for template in TEMPLATES {
        let solution = derived(&plain(template));
        let own = contact(&solution, &[], 3.0, None);
        for _ in 0..3 {
            let a = stream.uniform(0.7, 2.5);
            let depth = rate(|a| own.depth(a).unwrap().estimate.value, a);
            let force = rate(|a| own.force(a).unwrap().estimate.value, a);
            let stiffness = own.stiffness(a).unwrap().estimate.value;
            // Near the breakpoint the sixth derivative grows with (a − b)^(−11/2).
            assert!(relative(force, stiffness * depth) < 1e-6, "{template} at {a}: {force}, {}", stiffness * depth);
        }
        let a = 2.0;
        let work = rate(|a| own.energy(a).unwrap().estimate.value, a);
        let expected = own.force(a).unwrap().estimate.value * rate(|a| own.depth(a).unwrap().estimate.value, a);
        assert!(relative(work, expected) < 1e-8, "{template}: dU/da = {work}, F dd/da = {expected}");
    }
    // U = n/(2n+1) F d under C rⁿ.
    for (text, n) in [("r^2/4", 2.0), ("r*tan(3/10)", 1.0), ("r^(5/2)", 2.5)] {
        let solution = derived(text);
        let own = contact(&solution, &[], 3.0, None);
        let product = own.force(1.3).unwrap().estimate.value * own.depth(1.3).unwrap().estimate.value;
        assert!(relative(own.energy(1.3).unwrap().estimate.value, n / (2.0 * n + 1.0) * product) < 1e-12, "{text}");
    }
}

/// F = 2π ∫ p r dr: the pressure carries the force; and F/(2E) + G = a g.
#[test]
fn pressure_carries_the_force() {
    for template in TEMPLATES.iter().step_by(cases(9, 1)) {
        let solution = derived(&plain(template));
        let (modulus, a) = (2.0, 1.6);
        let own = contact(&solution, &[], modulus, None);
        let force = own.force(a).unwrap().estimate;
        let mut inside = |point: Point| match pressure(&own, point.x, a) {
            Some(p) => p.bounded() * Bounded::exact(point.x),
            // The infinite pressure at a kink is integrable.
            None => Bounded::exact(0.0),
        };
        let panels = [Panel::singular(0.0, 0.5), Panel::singular(0.5, a)];
        let total = integrate(&mut inside, &panels, &Options { rel_tol: 1e-7, charge_x: false, ..Options::default() }).unwrap();
        assert!(relative(2.0 * PI * total.value, force.value) < 1e-7, "{template}: {} and {}", 2.0 * PI * total.value, force.value);
        let whole = scaled(own.evaluator().equivalent(a).unwrap().estimate, a);
        same(template, own.integral(a).unwrap().estimate + scaled(force, 0.5 / modulus), whole);
    }
}

/// Next to the edge p → (E*/π) g′(a) √(2(a − r)/a), also beside a piece that ends far below, and p(0) is that of a smooth apex.
#[test]
fn pressure_next_to_the_edge_and_at_the_axis() {
    let template = "piecewise(r^2/2, r<1/4, 1/32+(r-1/4)*(1/4+atan(r-1/4)))";
    let solution = derived(&plain(template));
    let a = 1.5;
    let own = contact(&solution, &[], 1.0, None);
    let slope = |x: f64| own.evaluator().equivalent(x).unwrap().estimate.value;
    let rise = (slope(a * (1.0 + 1e-5)) - slope(a * (1.0 - 1e-5))) / (2e-5 * a);
    for gap in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
        let r = a * (1.0 - gap);
        let share = (a - r) / a;
        let p = pressure(&own, r, a).unwrap().value;
        let limit = rise / PI * (2.0 * share).sqrt();
        assert!(relative(p, limit) < 1e-8 + 3.0 * share, "{gap}: {p} and {limit}");
    }
    let axis = pressure(&own, 0.0, a).unwrap().value;
    for r in [1e-300, 1e-30, 1e-12] {
        assert!(relative(pressure(&own, r, a).unwrap().value, axis) < 1e-10, "{r}");
    }
}

/// At a kink of f the pressure is infinite, however many closed terms of both signs meet there.
#[test]
fn pressure_at_a_kink_is_infinite() {
    for template in TEMPLATES.iter().filter(|template| template.starts_with("piecewise(0")) {
        let solution = derived(&plain(template));
        for method in [Method::Auto, Method::Exact, Method::Quadrature] {
            let own = Evaluator::new(&solution, &Bindings::default(), method, 1e-12).unwrap();
            let closed = solution.terms().all(|term| !term.has_open_pressure());
            match own.pressure(0.5, 1.6) {
                Err(_) => assert!(method == Method::Exact && !closed, "{template}"),
                found => assert_eq!(found.unwrap(), None, "{template} {method:?}"),
            }
            assert!(closed || method == Method::Exact || own.pressure(0.5f64.next_up(), 1.6).unwrap().is_some());
        }
    }
}

/// Under a rounded tip the pressure has a limit at the axis, and reaches it at any radius that a number can hold.
#[test]
fn pressure_next_to_the_axis() {
    for template in ["H*(L*r)^2/4", "H*(1-exp(-(L*r)^2/9))", "H*ln(1+(L*r)^2/2)", "piecewise(0, r<(1/2)/L, H*(L*r-1/2))"] {
        let solution = derived(&plain(template));
        let own = contact(&solution, &[], 1.0, None);
        let centre = pressure(&own, 0.0, 1.6).unwrap();
        for exponent in [-20, -50, -150, -300] {
            same(template, pressure(&own, 10f64.powi(exponent), 1.6).unwrap(), centre);
        }
    }
}

/// Roots of both signs inside an inverse function: expanding g′ comes to an end, and changes nothing.
#[test]
fn expanding_two_roots_ends() {
    let slope = derivative(formula("x*asinh(sqrt(x^2-9/25)/sqrt(4-x^2))").as_closed().unwrap(), &Symbol::new("x")).unwrap();
    let expanded = normal::expanded(&slope, &Symbol::new("x")).unwrap();
    for x in [0.7, 1.1, 1.9] {
        assert!(relative(number(&expanded, &[("x", x)]), number(&slope, &[("x", x)])) < 1e-12);
    }
}

/// Outside, u continues d − f(a) and tends to F/(π E r).
#[test]
fn displacement_outside() {
    for template in TEMPLATES {
        let solution = derived(&plain(template));
        let (modulus, a) = (2.0, 1.6);
        let own = contact(&solution, &[], modulus, None);
        let at = |r: f64| own.displacement(r, a).unwrap().estimate.value;
        // u − (d − f) grows as (r − a)^(3/2) beyond the linear part.
        assert!((at(a) - at(a * (1.0 + 1e-9))).abs() < 1e-8 * own.depth(a).unwrap().estimate.value, "{template}");
        let (far, force) = (1e6 * a, own.force(a).unwrap().estimate.value);
        // The next term is (a/r)².
        assert!(relative(at(far), force / (PI * modulus * far)) < 1e-11, "{template}");
        assert!(at(2.0 * a) > at(3.0 * a) && at(3.0 * a) > 0.0);
    }
    let solution = derived("r^2/(2*R)");
    let own = contact(&solution, &[("R", 2.0)], 1.0, None);
    let hertz = typed("((2*a^2-r^2)*asin(a/r)+a*sqrt(r^2-a^2))/(pi*R)", &[("a", 1.1), ("r", 1.7), ("R", 2.0)]);
    assert!(relative(own.displacement(1.7, 1.1).unwrap().estimate.value, hertz) < 1e-14);
}

/// a(d) inverts d(a), within its own error; F(d) is F(a(d)).
#[test]
fn depth_and_radius_invert_each_other() {
    let mut stream = Stream::new(15);
    let mut explicit = 0;
    for template in TEMPLATES {
        let solution = derived(&plain(template));
        let (own, relations) = (contact(&solution, &[], 1.0, None), relations(&solution, &Edge::Smooth).unwrap());
        for _ in 0..8 {
            let a = stream.uniform(0.55, 2.4);
            let d = own.depth(a).unwrap().estimate;
            let found = own.contact_radius(d.value).unwrap().estimate;
            // d is rounded: an ulp of d moves a by up to two of its own here.
            assert!((found.value - a).abs() <= found.error + 4e-16 * a, "{template}: {} for {a}", found.value);
            assert!(found.error < 1e-10 * a, "{template}: {found:?}");
            if let (Some(radius), Some(force)) = (&relations.contact_radius_of_depth, &relations.force_of_depth) {
                let at = [("d", d.value), ("E", 1.0)];
                let ulps = |one: f64, two: f64| relative(one, two) / f64::EPSILON;
                assert!(ulps(value(&radius.formula, &at), found.value) <= 4.0, "{template} at d = {}", d.value);
                let through = own.force(found.value).unwrap().estimate.value;
                assert!(ulps(value(&force.formula, &at), through) <= 16.0, "{template} at d = {}", d.value);
                explicit += 1;
            }
        }
    }
    assert!(explicit >= 4 * 8, "{explicit}");
}

/// Many ways of typing one profile give one answer, closed wherever one of them is.
#[test]
fn rewriting_changes_nothing() {
    let groups: [&[&str]; 9] = [
        &["R-sqrt(R^2-r^2)", "R*(1-sqrt(1-r^2/R^2))", "r^2/(R+sqrt(R^2-r^2))", "R-sqrt((R-r)*(R+r))", "R-R*sqrt(1-(r/R)^2)"],
        &["h*(sqrt(1+r^2/b^2)-1)", "sqrt(h^2+(h*r/b)^2)-h", "h*(sqrt(b^2+r^2)-b)/b", "h*r^2/(b*(b+sqrt(b^2+r^2)))"],
        &["piecewise(0, r<b, (r-b)^2/(2*R))", "piecewise(0, r<b, r^2/(2*R)-b*r/R+b^2/(2*R))", "piecewise(0, r<b, (b-r)*(b-r)/R/2)"],
        &["piecewise(0, r<b, (r-b)^3)", "piecewise(0, r<b, r^3-3*r^2*b+3*r*b^2-b^3)", "max(r-b, 0)^3"],
        &["r^2/(2*R)+r*tan(theta)", "(r^2+2*R*r*tan(theta))/(2*R)", "r*(r+2*R*tan(theta))/(2*R)", "r*tan(theta)-(-r)^2/(-2*R)"],
        &["C*sqrt(r)", "C*r^(1/2)", "C*r/sqrt(r)", "(C^2*r)^(1/2)", "C/r^(-0.5)"],
        &["piecewise(0, r<b, r^2-b^2, r<c, c^2-b^2)", "piecewise(0, r<b, (r-b)*(r+b), r<c, (c-b)*(c+b))"],
        &["abs(r-b)-b", "piecewise(-r, r<b, r-2*b)", "max(r-b, b-r)-b"],
        &["h*(1-exp(-r^2/b^2))", "h-h/exp((r/b)^2)", "h*(exp(r^2/b^2)-1)*exp(-r^2/b^2)"],
    ];
    let values = [("R", 4.0), ("h", 0.5), ("b", 0.75), ("c", 1.5), ("C", 0.5), ("theta", 0.25)];
    for group in groups {
        let solutions: Vec<_> = group.iter().map(|text| derived(text)).collect();
        let status = |index: usize| {
            let found = relations(&solutions[index], &Edge::Smooth).unwrap();
            [Some(found.g.status), Some(found.force.status), found.pressure.map(|own| own.status)]
        };
        let first = contact(&solutions[0], &values, 1.0, None);
        for (index, text) in group.iter().enumerate().skip(1) {
            assert_eq!(status(index), status(0), "{text}");
            let own = contact(&solutions[index], &values, 1.0, None);
            for a in [0.5, 1.25, 2.5] {
                let close = |what: &str, one: Estimate, two: Estimate| {
                    let (difference, allowed) = ((one.value - two.value).abs(), one.error + two.error);
                    assert!(difference <= allowed, "{text}: {what} at {a}: {one:?} and {two:?}");
                };
                close("g", own.evaluator().equivalent(a).unwrap().estimate, first.evaluator().equivalent(a).unwrap().estimate);
                close("F", own.force(a).unwrap().estimate, first.force(a).unwrap().estimate);
                close("p", pressure(&own, 0.7 * a, a).unwrap(), pressure(&first, 0.7 * a, a).unwrap());
            }
            // Setting the numbers first must not change what is recognised.
            let set = derived_with(text, &values);
            if status(0)[0] == Some(Status::Exact) {
                assert!(set.is_closed(), "{text}");
            }
            let numeric = contact(&set, &[], 1.0, None).evaluator().equivalent(2.5).unwrap().estimate.value;
            assert!(relative(numeric, number_of(&first)) < 1e-13, "{text}");
        }
    }
}

fn number_of(own: &Contact<'_>) -> f64 {
    own.evaluator().equivalent(2.5).unwrap().estimate.value
}

/// A solver may share one evaluator between its threads.
#[test]
fn evaluators_are_shared_between_threads() {
    fn shared<T: Send + Sync>(_: &T) {}
    let solution = derived("h*(1-cos(r))");
    let evaluator = Evaluator::new(&solution, &bindings(&[("h", 2.0)]), Method::Auto, 1e-13).unwrap();
    shared(&evaluator);
    let values: Vec<f64> = std::thread::scope(|scope| {
        let run = || evaluator.equivalent(0.5).unwrap().estimate.value;
        [scope.spawn(run), scope.spawn(run)].map(|worker| worker.join().unwrap()).to_vec()
    });
    assert_eq!(values[0], values[1]);
}
