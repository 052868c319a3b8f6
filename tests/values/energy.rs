//! The strain energy and the pressure on the axis: proven bounds, against values of 20 digits from `tests/oracle/energy.py` and laws.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use sneddon::contact::{Contact, ContactError};
use sneddon::expr::Bindings;
use sneddon::num::Bound;
use sneddon::parse;
use sneddon::transform::{Evaluator, Method, Profile, Solution, TransformError, derive};
use sneddon_checks::decimal::Decimal;
use sneddon_checks::seeds::{cases, sample};

fn solution(text: &str) -> Solution {
    derive(&Profile::new(&parse::profile(text).unwrap()).unwrap()).unwrap()
}

fn contact(solution: &Solution, method: Method, depth: Option<f64>) -> Contact<'_> {
    Contact::new(Evaluator::new(solution, &Bindings::default(), method, 1e-12).unwrap(), 1.0, depth, 1e-12)
}

/// Class "U is always estimated": where g is proven, so is U, by closed forms and by quadrature, under smooth edges and rims.
#[test]
fn energies_are_proven() {
    let (mut count, mut worst) = (0, 0.0f64);
    for (number, line) in include_str!("../oracle/energy.csv").lines().filter(|line| !line.starts_with('#')).enumerate() {
        let [text, depth, a, truth] = line.split(';').collect::<Vec<_>>()[..] else { panic!("{line}") };
        let (depth, a, truth) = (depth.parse().ok(), a.parse().unwrap(), Decimal::read(truth));
        let solution = solution(text);
        for method in sample([Method::Auto, Method::Quadrature], number, 4) {
            let own = contact(&solution, method, depth);
            let found = own.energy(a).unwrap().estimate;
            // Next to the end of a sphere g itself is estimated by quadrature.
            let expected = own.evaluator().equivalent(a).unwrap().estimate.bound;
            assert_eq!(found.bound, expected, "{line}, {method:?}: {found:?}");
            assert!(expected == Bound::Proven || (method == Method::Quadrature && a == 0.999), "{line}");
            assert!(truth.distance(found.value) <= found.error, "{line}, {method:?}: {found:?}");
            worst = worst.max(found.relative_error());
            count += 1;
        }
    }
    println!("{count} energies, the widest bound {worst:.1e}");
    // The widest is that of a contact that has just passed a kink, where d − g cancels.
    assert!(count >= cases(15, 60) && worst < 5e-12, "{count}, {worst:e}");
}

/// Class "p(0) is often estimated": open pressures on the axis are proven, and their method of quadrature agrees with that of closed forms.
#[test]
fn pressures_on_the_axis_are_proven() {
    let open = [
        "ln(cosh(r))",
        "1-exp(-r^2)",
        "r^2*ln(1+r)",
        "r^2/(1+r)",
        "asinh(r^2)",
        "1-cosh(r)+r^2",
        "r^2*besselj(0,r)",
        "r^3*exp(-r)",
        "1-cos(r)",
        "r^2*atan(r)",
        "erf(r)*r^2",
        "r^2.5*tanh(r)",
        "r^2*sqrt(1+r)",
        "max(0,r-0.5)",
        "piecewise(0,r<0.5,(r-0.5)^2)",
        // Breakpoints that no double is.
        "piecewise(0,r<0.2,(r-0.2)^2)",
        "piecewise(0,r<0.2,(r-0.2)^1.5)",
        "max(0,r-0.1)^1.5+r^2",
        "max(r-0.2,r^2)",
        "max(r-0.3,sinh(r)^2)",
        // What vanishes at the axis beside a fractional power.
        "ln(1+r^2)*(0.4+sqrt(r))",
        "r^1.7*sin(r)+r-sin(r)",
        "r^0.7*(r-ln(1+r))+1-cos(r)",
    ];
    let closed = ["r^2/2", "R-sqrt(R^2-r^2)", "sqrt(1+r^2)-1", "r^3", "r^1.5", "piecewise(0,r<0.5,(r^2-0.25)/2)"];
    for text in open.iter().chain(&closed).map(|text| text.replace('R', "2")) {
        let solution = solution(&text);
        let at = |method| contact(&solution, method, None).pressure(0.0, 1.0).unwrap().unwrap().estimate;
        let (auto, numeric) = (at(Method::Auto), at(Method::Quadrature));
        for own in [auto, numeric] {
            assert!(own.bound == Bound::Proven && own.relative_error() < 1e-12, "{text}: {own:?}");
        }
        assert!((auto.value - numeric.value).abs() <= auto.error + numeric.error, "{text}: {auto:?}, {numeric:?}");
    }
}

/// dU/dd = F, by central differences over depths that are proven.
#[test]
fn the_force_is_the_derivative_of_the_energy() {
    for text in ["ln(cosh(r))", "max(0,r-0.5)", "r^2*exp(-r/4)", "r^1.3+r^2", "r^1.37+r^2.41+r"] {
        let solution = solution(text);
        let own = contact(&solution, Method::Auto, None);
        let (a, step) = (0.9, 1e-4);
        let at = |a: f64| (own.depth(a).unwrap().estimate.value, own.energy(a).unwrap().estimate.value);
        let ((before, less), (after, more)) = (at(a - step), at(a + step));
        let force = own.force(a).unwrap().estimate.value;
        let ratio = (more - less) / (after - before) / force;
        // The third difference: (Δd)² F″/6 of F.
        assert!((ratio - 1.0).abs() < 3e-8, "{text}: {ratio}");
    }
}

/// Class "a number without a digit": the integrand is a square, so that an error as large as the value says that waves were missed.
#[test]
fn energies_without_a_digit_are_refused() {
    for (text, a, has_digits) in
        [("sin(30*r)*r^2", 1.0, true), ("sin(1e6*r)*r^2", 1.0, false), ("struveh(0,r)*r^2", 10.0, true), ("struveh(0,r)*r^2", 1e6, false)]
    {
        let solution = solution(text);
        match contact(&solution, Method::Auto, None).energy(a) {
            Ok(found) => assert!(has_digits && found.estimate.error < 1e-12 * found.estimate.value, "{text} at {a}: {found:?}"),
            Err(ContactError::Transform(TransformError::NoDigits { .. })) => assert!(!has_digits, "{text} at {a}"),
            Err(other) => panic!("{text} at {a}: {other}"),
        }
    }
}
