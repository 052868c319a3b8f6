//! The stress on the axis against 50-digit values and against its laws.
#![allow(clippy::unwrap_used, clippy::panic)]

use sneddon::contact::Contact;
use sneddon::eval::constant_value;
use sneddon::expr::{Bindings, Expr, Formula};
use sneddon::parse;
use sneddon::transform::{Closure, Evaluator, Interpolation, Method, Profile, Reading, Solution, Superposed, derive};
use sneddon_checks::seeds::{cases, sample};
use std::f64::consts::PI;

fn solution(text: &str) -> Solution {
    derive(&Profile::new(&parse::profile(text).unwrap()).unwrap()).unwrap()
}

fn contact(solution: &Solution, depth: Option<f64>) -> Contact<'_> {
    Contact::new(Evaluator::new(solution, &Bindings::default(), Method::Auto, 1e-13).unwrap(), 1.0, depth, 1e-13)
}

/// Smooth edges, rims, kinks, tips with infinite curvature; z from 1e-9 to 1e5.
#[test]
fn stresses_have_their_reference_values() {
    let table = include_str!("../oracle/axial.csv");
    let (mut worst, mut count) = (0.0f64, 0);
    for line in table.lines().skip(1) {
        let [profile, a, d, z, stress] = line.split(';').collect::<Vec<_>>().try_into().unwrap();
        let number = |text: &str| text.parse::<f64>().unwrap();
        let solution = solution(profile);
        let depth = (!d.is_empty()).then(|| number(d));
        let found = contact(&solution, depth).axial_stress(number(z), number(a)).unwrap().unwrap().estimate;
        let off = (found.value - number(stress)).abs();
        assert!(off <= found.error, "{line}: {found:?} is off by {off:e}");
        assert!(found.error <= 1e-12 * found.value.abs(), "{line}: {found:?}");
        worst = worst.max(off / number(stress).abs());
        count += 1;
    }
    assert_eq!(count, 196);
    println!("largest relative error: {worst:e}");
    assert!(worst < 2e-14, "{worst:e}");
}

/// Hertz: −p₀/(1 + z²/a²), from far below to far above the contact radius.
#[test]
fn hertz_is_closed() {
    let solution = solution("r^2/4");
    let contact = contact(&solution, None);
    for step in -30..=30 {
        let z = 10f64.powi(step);
        let found = contact.axial_stress(z, 1.5).unwrap().unwrap().estimate;
        let expected = -1.5 / PI / (1.0 + z * z / 2.25);
        assert!((found.value - expected).abs() <= found.error.max(4.0 * f64::EPSILON * expected.abs()), "{z:e}: {found:?} {expected:?}");
        assert!(found.error <= 1e-12 * expected.abs(), "{z:e}: {found:?}");
    }
}

/// Class "a length squared leaves the range of doubles": the stress under a scaled profile is the same, in units from 2⁻¹⁰¹² to 2¹⁰⁰⁰.
#[test]
fn stresses_do_not_depend_on_the_unit() {
    let mut answered = 0;
    let shapes = [
        "r^2/(2*R)",
        "R-sqrt(R^2-r^2)",
        "R*ln(cosh(r/R))",
        "R*sqrt(r/R)",
        "R*(1-exp(-r/R))",
        "max(0,r-R/4)",
        "R*abs(r/R-0.25)^3",
        "R*abs(r/R-0.2)^1.5",
        "R*max(0,r/R-0.2)^1.2",
        "R*max(0,r/R-0.2)^2.5",
    ];
    for (number, text) in shapes.into_iter().enumerate().step_by(cases(2, 1)) {
        let stress = |unit: f64| {
            let text = text.replace('R', &format!("({unit:e})"));
            contact(&solution(&text), None).axial_stress(0.2 * unit, 0.5 * unit).map(|found| found.unwrap().estimate)
        };
        let usual = stress(1.0).unwrap();
        for unit in
            sample([-1012, -1004, -996, -984, -900, -700, -540, -500, 400, 500, 540, 700, 1000], number / 2, 5).map(|k| f64::from(k).exp2())
        {
            let Ok(found) = stress(unit) else { continue };
            answered += 1;
            let off = (found.value - usual.value).abs();
            assert!(off <= found.error + usual.error, "{text}, R = {unit:e}: {found:?} instead of {usual:?}");
        }
    }
    // Next to underflow, in units below 1e-296, some stresses have no digit that is certain, and no value.
    assert!(answered >= cases(12, 120), "{answered}");
}

/// Class "a length compared with a number": f′ of these shapes is nearly constant from 1e-12 of the axis on, in a small enough unit.
#[test]
fn pressures_on_the_axis_are_proven_in_every_unit() {
    for text in ["R*ln(cosh(r/R))", "sqrt(R^2+r^2)-R"] {
        let pressure = |unit: f64| {
            let text = text.replace('R', &format!("({unit:e})"));
            contact(&solution(&text), None).pressure(0.0, 0.5 * unit).unwrap().unwrap().estimate
        };
        let usual = pressure(1.0);
        for unit in [1e-200, 1e-30, 1e-18, 1e-14, 1e-9, 1e9, 1e30] {
            let found = pressure(unit);
            assert!((found.value - usual.value).abs() <= found.error + usual.error, "{text}, R = {unit:e}: {found:?} instead of {usual:?}");
            assert_eq!(found.bound, usual.bound, "{text}, R = {unit:e}: {found:?}");
        }
    }
}

/// z = 0 gives −p(0), and nothing at a cone's apex; far away the contact is a point force, σ = −3F/(2π z²).
#[test]
fn both_ends_are_known() {
    let (sphere, cone) = (solution("2-sqrt(4-r^2)"), solution("r/5"));
    let contact = contact(&sphere, None);
    let at_surface = contact.axial_stress(0.0, 1.0).unwrap().unwrap().estimate;
    assert_eq!(at_surface.value, -contact.pressure(0.0, 1.0).unwrap().unwrap().estimate.value);
    let far = contact.axial_stress(1e6, 1.0).unwrap().unwrap().estimate.value;
    let point = -1.5 * contact.force(1.0).unwrap().estimate.value / PI / 1e12;
    assert!((far / point - 1.0).abs() < 1e-11);
    let pointed = Contact::new(Evaluator::new(&cone, &Bindings::default(), Method::Auto, 1e-13).unwrap(), 1.0, None, 1e-13);
    assert!(pointed.axial_stress(0.0, 1.0).unwrap().unwrap_err().text().contains("apex"));
    assert!(pointed.axial_stress(-1.0, 1.0).is_err() && pointed.axial_stress(f64::NAN, 1.0).is_err());
}

/// Class "parts that cancel miss a loose tolerance", also for displacements and pressures.
#[test]
fn sums_of_parts_that_cancel_meet_the_tolerance() {
    for tolerance in [0.1, 1e-3, 1e-6] {
        for text in ["gamma(1+r)", "abs(sin(5*r))", "r^r"] {
            let solution = solution(text);
            let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, tolerance).unwrap();
            let contact = Contact::new(evaluator, 1.0, None, tolerance);
            let stress = contact.axial_stress(0.4, 0.9).unwrap().unwrap().estimate;
            let displacement = contact.displacement(1.5, 0.9).unwrap().estimate;
            let pressure = contact.pressure(0.05, 0.9).unwrap().unwrap().estimate;
            for found in [stress, displacement, pressure] {
                assert!(found.error <= tolerance * found.value.abs(), "{text}, {tolerance:e}: {found:?}");
            }
        }
    }
}

/// Profiles with closed displacements outside the contact, and whether their stresses on the axis are closed too.
const FIELDS: [(&str, bool); 14] = [
    ("r^2/4", true),
    ("r/5", true),
    ("r^3/7", true),
    ("r^8/9", true),
    ("r^11/9", true),
    ("r^(1/2)/3", true),
    ("r^(27/10)/3+r/8", true),
    ("piecewise(0,r<0.3,(r^2-0.09)/4)", true),
    ("piecewise(r^2/4,r<0.3,r^2/2-0.0225)", true),
    ("piecewise(0,r<0.3,(r-0.3)/4)", false),
    ("min(r^2/4,0.04)", true),
    ("2-sqrt(4-r^2)", false),
    ("sqrt(1+r^2)-1", false),
    ("max(0,r-0.2)^2+r^3", false),
];

/// Closed fields agree with quadrature within both errors, near and far; the formulas as they are shown agree with the values.
#[test]
fn closed_fields_are_those_of_quadrature() {
    let a = 0.7;
    let mut worst = 0.0f64;
    for (text, has_stress) in FIELDS {
        let solution = solution(text);
        let by = |method| Contact::new(Evaluator::new(&solution, &Bindings::default(), method, 1e-13).unwrap(), 1.0, None, 1e-13);
        let (closed, plain) = (by(Method::Auto), by(Method::Quadrature));
        let mut compare = |field: Superposed, place: f64, found: Reading, truth: Reading, factor: f64| {
            let (own, other) = (found.estimate, truth.estimate);
            assert_eq!(found.method, "exact", "{text} {field:?}({place:e})");
            assert!((own.value - other.value).abs() <= own.error + other.error, "{text} {field:?}({place:e}): {own:?}, {other:?}");
            // Farther away the terms of pieces cancel even with thirty digits.
            assert!(own.relative_error() < 1e-13 || place > 1e3, "{text} {field:?}({place:e}): {own:?}");
            let formula = solution.field(field).unwrap().formula;
            let coordinate = if field == Superposed::Outside { "r" } else { "z" };
            let values: Bindings = [("a", exact(a)), (coordinate, exact(place))].into_iter().collect();
            let shown = factor * value(&formula, &values);
            // As printed, terms cancel far away.
            if (1e-2..2.0).contains(&place) {
                worst = worst.max((shown / own.value - 1.0).abs());
            }
        };
        for share in [1.0 + 1e-14, 1.0 + 1e-12, 1.0 + 1e-9, 1.0 + 1e-6, 1.001, 1.7, 30.0, 1e5] {
            let r = share * a;
            compare(Superposed::Outside, r, closed.displacement(r, a).unwrap(), plain.displacement(r, a).unwrap(), 1.0);
        }
        for z in [1e-9, 1e-3, 0.2, 0.7, 5.0, 1e3, 1e8].into_iter().filter(|_| has_stress) {
            let stress = |contact: &Contact<'_>| contact.axial_stress(z, a).unwrap().unwrap();
            compare(Superposed::Axial, z, stress(&closed), stress(&plain), -1.0 / PI);
        }
    }
    println!("largest difference of shown formulas: {worst:e}");
    assert!(worst < 1e-9, "{worst:e}");
}

fn exact(value: f64) -> Expr {
    parse::constant(&format!("{value:?}")).unwrap()
}

/// The value of a closed formula, whose pieces end at breakpoints of a.
fn value(formula: &Formula, values: &Bindings) -> f64 {
    let number = |expr: &Expr| constant_value(expr, values).unwrap().value;
    match formula {
        Formula::Closed(expr) => number(expr),
        Formula::Sum(parts) => parts.iter().map(|part| value(part, values)).sum(),
        Formula::Scaled(factor, inner) => number(factor) * value(inner, values),
        Formula::Piecewise { variable, pieces, last } => {
            let at = number(&Expr::from(variable.clone()));
            value(pieces.iter().find(|(_, end)| at < number(end)).map_or(last, |(piece, _)| piece), values)
        }
        Formula::Integral { .. } => panic!("{formula:?}"),
    }
}

/// Closures and tables answer as the formula does.
#[test]
fn closures_and_tables_answer_too() {
    let formula = solution("r^2/4");
    let expected = contact(&formula, None).axial_stress(0.3, 1.0).unwrap().unwrap().estimate;
    let closure = Contact::new(Closure::with_f_prime(|r| r * r / 4.0, |r| r / 2.0).profile().unwrap(), 1.0, None, 1e-12);
    let r: Vec<f64> = (0..=64).map(|i| f64::from(i) / 32.0).collect();
    let z: Vec<f64> = r.iter().map(|r| r * r / 4.0).collect();
    let table = Contact::new(Profile::from_points(&r, &z, Interpolation::MonotoneCubic).unwrap(), 1.0, None, 1e-12);
    for found in [closure.axial_stress(0.3, 1.0), table.axial_stress(0.3, 1.0)] {
        let found = found.unwrap().unwrap().estimate;
        assert!((found.value - expected.value).abs() <= found.error + expected.error, "{found:?} {expected:?}");
        assert!(found.error < 1e-10);
    }
}
