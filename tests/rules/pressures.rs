//! Printed pressures with integrals: what closes of them and what stays add up to the numbers.
#![allow(clippy::unwrap_used)]

use sneddon::print;
use sneddon::transform::Status;
use sneddon_checks::formulas::{Values, contact, derived, derived_with, value};

/// Truncated, rounded and capped tips, kinks in both directions, ends of pieces between, and logarithms beside powers.
const OPEN: &[(&str, &Values<'static>)] = &[
    ("max(0,r-b)", &[("b", 0.6)]),
    ("max(0,r-b)^3", &[("b", 0.6)]),
    ("abs(r-b)", &[("b", 0.9)]),
    ("min(s*r,h)", &[("s", 0.7), ("h", 0.5)]),
    ("piecewise(0, r<b, (r-b)^2/(2*R))", &[("b", 0.6), ("R", 2.0)]),
    ("piecewise(r^2*s/(2*b), r<b, s*(r-b/2))", &[("b", 0.6), ("s", 0.4)]),
    ("piecewise(r*s, r<b, s*b+(r-b)^2/(2*R), r<c, s*b+(c-b)^2/(2*R)+(r-c)^3)", &[("b", 0.5), ("c", 1.1), ("s", 0.3), ("R", 2.0)]),
    ("max(0,r-b)+max(0,r-c)", &[("b", 0.4), ("c", 0.9)]),
    ("r^2/(2*R)+C*abs(r-b)", &[("b", 0.9), ("C", 0.2), ("R", 2.0)]),
    ("max(0,r-b)*tan(t)", &[("b", 0.6), ("t", 0.4)]),
    ("piecewise(C*r^4*ln(r), r<b, C*b^4*ln(b))", &[("b", 1.2), ("C", 1.2)]),
    ("min(C*r^2.5, h)", &[("C", 0.8), ("h", 0.5)]),
    ("C*r^2*ln(1+r/b)", &[("b", 0.7), ("C", 1.2)]),
    ("h*((w^2+r^2)*ln(1+r^2/w^2)-r^2)", &[("h", 0.7), ("w", 1.2)]),
    // Odd powers over (x² ± w²)^k.
    ("h*ln(1+r^2/w^2)", &[("h", 0.7), ("w", 1.2)]),
    ("-h*ln(1-r^2/R^2)", &[("h", 0.7), ("R", 2.5)]),
    ("h*r^2/(r^2+w^2)", &[("h", 0.7), ("w", 1.2)]),
    ("h/(1+r^2/w^2)^2", &[("h", -0.7), ("w", 1.2)]),
    ("r^6/(r^2+w^2)^2", &[("w", 1.2)]),
    ("h*r^2/(R^2-r^2)^3", &[("h", 0.7), ("R", 2.5)]),
    // Pieces that begin at the axis, with one end or more.
    ("piecewise(R-sqrt(R^2-r^2), r<b, R-sqrt(R^2-b^2)+(r-b)*s)", &[("R", 2.0), ("b", 0.6), ("s", 0.4)]),
    (
        "piecewise(h*atan(r/w), r<b, h*atan(b/w)+(r-b)*s, r<c, h*atan(b/w)+(c-b)*s)",
        &[("h", 0.7), ("w", 1.2), ("b", 0.6), ("c", 1.1), ("s", 0.4)],
    ),
    ("piecewise(r^2+h*(sqrt(1+r^2/w^2)-1), r<b, b^2+h*(sqrt(1+b^2/w^2)-1))", &[("h", 0.7), ("w", 1.2), ("b", 0.6)]),
    ("piecewise(C*r*ln(r), r<b, C*b*ln(b))", &[("C", 0.7), ("b", 0.6)]),
];

/// Radii within every piece of the profiles, and the contact radius.
const RADII: [f64; 5] = [0.05, 0.35, 0.75, 1.05, 1.35];
const A: f64 = 1.5;

fn hold(profile: &str, values: &Values<'_>, status: Status, tolerance: f64) {
    let printed = derived(profile).pressure().unwrap();
    assert_eq!(printed.status, status, "{profile}");
    let solution = derived_with(profile, values);
    let contact = contact(&solution, &[], 1.0, None);
    let numbers = RADII.map(|r| contact.pressure(r, A).unwrap().unwrap().estimate.value);
    // Printed terms cancel where the pressure is small.
    let largest = numbers.iter().fold(0.0_f64, |largest, number| largest.max(number.abs()));
    for (r, number) in RADII.into_iter().zip(numbers) {
        let own = value(&printed.formula, &[values, &[("r", r), ("a", A), ("E", 1.0)]].concat());
        assert!((own - number).abs() < tolerance * largest, "{profile}: p({r}) = {number:e}, the formula is {own:e}");
    }
}

#[test]
fn what_closes_beside_an_integral_adds_up() {
    for (profile, values) in OPEN {
        hold(profile, values, Status::Partial, TOLERANCE);
    }
}

/// x arcosh(x/b) by parts, and odd powers times ln x.
#[test]
fn pressures_of_logarithms_close() {
    let values: &Values<'_> = &[("b", 0.7), ("C", 1.2)];
    hold("piecewise(0, r<b, C*r^2*ln(r/b))", values, Status::Exact, 4e-15);
    hold("piecewise(C*r^2*ln(r), r<b, C*b^2*ln(b))", values, Status::Exact, 4e-15);
}

/// Poles beside the root of a kink, by R_J, for either sign, for a tip without its end, and for a rim that is rounded and cut.
#[test]
fn pressures_with_elliptic_integrals_of_the_third_kind_close() {
    let above: &Values<'_> = &[("b", 0.7), ("c", 0.6), ("h", 0.9)];
    let below: &Values<'_> = &[("R", 1.7), ("c", 0.6), ("h", 0.9)];
    hold("piecewise(0, r<c, h*(1/sqrt(1+c^2/b^2)-1/sqrt(1+r^2/b^2)))", above, Status::Exact, 4e-15);
    hold("piecewise(0, r<c, h*(1/sqrt(1-r^2/R^2)-1/sqrt(1-c^2/R^2)))", below, Status::Exact, 4e-15);
    hold("max(0, h-1/sqrt(1+r^2))", &[("h", 0.85)], Status::Exact, 4e-15);
    hold("min(1-1/sqrt(1+r^2/w^2), h)", &[("h", 0.2), ("w", 1.2)], Status::Exact, 4e-15);
}

/// g is a polynomial under odd powers of √(r² − b²).
#[test]
fn pressures_under_powers_of_a_difference_of_squares_close() {
    let values: &Values<'_> = &[("b", 0.6), ("C", 0.9)];
    hold("piecewise(0, r<b, C*(r^2-b^2)^(3/2))", values, Status::Exact, 4e-15);
    hold("piecewise(0, r<b, C*r^2*(r^2-b^2)^(5/2))", values, Status::Exact, 1e-14);
}

/// A polynomial of degree 20 has a hundred elementary terms, so that each of its powers is one term over ₂F₁.
#[test]
fn pressures_of_long_polynomials_have_one_term_for_each_power() {
    let product = |n: u32| (1..=n).map(|i| format!("(1+r/{i})")).collect::<Vec<_>>().join("*");
    for (profile, is_long) in
        [("(1+r)^6".to_owned(), false), ("(1+r)^20".to_owned(), true), (product(16), true), ("r^30".to_owned(), false)]
    {
        hold(&profile, &[], Status::Exact, 3e-15);
        let printed = print::text(&derived(&profile).pressure().unwrap().formula);
        assert_eq!(printed.contains("hyp2f1"), is_long, "{profile}: {printed}");
    }
}

/// ∫ x e^(∓x²/w²)/√(x²−r²) dx closes by the error functions, once the terms of g are added up.
#[test]
fn pressures_of_gaussian_g_close() {
    let values: &Values<'_> = &[("h", 0.7), ("w", 1.2)];
    hold("h*(1-exp(-r^2/(2*w^2))*besseli(0,r^2/(2*w^2)))", values, Status::Exact, 4e-15);
    hold("h*(exp(r^2/(2*w^2))*besseli(0,r^2/(2*w^2))-1)", values, Status::Exact, 4e-15);
}

/// Integrals of the checks keep seven digits, because a root vanishes at their lower ends.
const TOLERANCE: f64 = 1e-7;

/// Class "a slope angle within a root, a logarithm or an arctangent": the rules of a plain parameter apply, under an acute angle.
#[test]
fn angles_in_kernels_are_parameters() {
    let shapes = [
        ("sqrt(h^2+r^2*S^2)-h", true),
        ("sqrt(h^2+r^2/S^2)-h", true),
        ("h*(sqrt(1+r^2*S^2/h^2)-1)", true),
        ("1/S-sqrt(1/S^2-r^2/9)", true),
        ("h*ln(1+r^2*S^2/h^2)", false),
        ("h*atan(r*S/h)", true),
        ("h*(1-exp(-r^2*S^2))", false),
        ("h*(1-cos(r*S/h))", false),
        ("max(0,sqrt(h^2+r^2*S^2)-2*h)", false),
    ];
    let theta: f64 = 0.4;
    for (shape, has_pressure) in shapes {
        for (function, value) in [("tan(t)", theta.tan()), ("sin(t)", theta.sin()), ("cos(t)", theta.cos())] {
            let text = shape.replace('S', function);
            let own = derived(&text);
            assert_eq!(own.equivalent_profile().status, Status::Exact, "{text}");
            let shown = print::text(&own.equivalent_profile().formula);
            assert!(!shown.contains("hyp"), "{text}: {shown}");
            assert_eq!(own.pressure().unwrap().status == Status::Exact, has_pressure, "{text}");
            let plain = derived_with(&shape.replace('S', "s"), &[("s", value), ("h", 0.7)]);
            let angle = derived_with(&text, &[("t", theta), ("h", 0.7)]);
            let [plain, angle] = [&plain, &angle].map(|own| contact(own, &[], 1.0, None));
            for a in [0.9, 1.6] {
                let pairs = [
                    (plain.force(a).unwrap().estimate, angle.force(a).unwrap().estimate),
                    (plain.pressure(0.3, a).unwrap().unwrap().estimate, angle.pressure(0.3, a).unwrap().unwrap().estimate),
                ];
                for (plain, angle) in pairs {
                    // The slope itself is rounded once.
                    let allowed = plain.error + angle.error + 4.0 * f64::EPSILON * plain.value.abs();
                    assert!((plain.value - angle.value).abs() <= allowed, "{text}, a = {a}: {plain:?}, {angle:?}");
                }
            }
        }
    }
}
