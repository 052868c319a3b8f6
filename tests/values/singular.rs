//! Pressures at the axis and at joints: finite where theory says so, against 25-digit values, and infinite elsewhere.
#![allow(clippy::unwrap_used, clippy::panic)]

use sneddon::contact::{Contact, Reason};
use sneddon::expr::Bindings;
use sneddon::num::Bound;
use sneddon::parse;
use sneddon::transform::{Evaluator, Method, Profile, Solution, TransformError, Way, derive};
use sneddon_checks::decimal::Decimal;
use sneddon_checks::random::Stream;
use sneddon_checks::seeds::cases;

fn solution(text: &str) -> Solution {
    derive(&Profile::new(&parse::profile(text).unwrap()).unwrap()).unwrap()
}

fn contact(solution: &Solution, method: Method) -> Contact<'_> {
    Contact::new(Evaluator::new(solution, &Bindings::default(), method, 1e-13).unwrap(), 1.0, None, 1e-13)
}

/// Cones that cancel, and tangential joints.
#[test]
fn finite_pressures_have_their_reference_values() {
    let (mut worst, mut count) = (0.0f64, 0);
    for line in include_str!("../oracle/apex.csv").lines().skip(1).step_by(cases(3, 1)) {
        let [profile, a, r, pressure] = line.split(';').collect::<Vec<_>>().try_into().unwrap();
        let number = |text: &str| text.parse::<f64>().unwrap();
        let solution = solution(profile);
        for method in [Method::Auto, Method::Quadrature] {
            let contact = contact(&solution, method);
            let found = contact.pressure(number(r), number(a)).unwrap().unwrap().estimate;
            let off = (found.value - number(pressure)).abs();
            assert!(off <= found.error, "{line}: {found:?} is off by {off:e}");
            assert!(found.error <= 1e-12 * found.value.abs(), "{line}: {found:?}");
            worst = worst.max(off / number(pressure).abs());
            count += 1;
            if number(r) == 0.0 {
                let stress = contact.axial_stress(0.0, number(a)).unwrap().unwrap().estimate;
                assert_eq!(stress.value, -found.value, "{line}");
            }
        }
    }
    assert_eq!(count, cases(42, 124));
    assert!(worst < 4e-14, "{worst:e}");
}

/// g(0.8) and p(0.3) at a = 0.8, by mpmath with 25 digits, and values of f′ that they may take.
///
/// Over the angle, pieces next to the axis are halved until r^s no longer matters, which took 4 to 20 times as many values for g; over its
/// root the integrand is analytic there. Next to r the pressure has the logarithm of its kernel, so that it gains less.
#[test]
fn fractional_powers_at_the_axis_take_few_values() {
    for (text, equivalent, pressure, most) in [
        ("r^(1/2)/(2+r^2)", "0.3666290549498609150110923", "0.09588058809445197051721", [70, 1400]),
        ("exp(r^(2/3))-1", "2.125198264466079332743119", "1.304312708269602029101", [90, 1600]),
        ("ln(1+r^(5/4))", "0.8804701237337822331853538", "0.597425217521448326418", [100, 1700]),
        ("r^(1/2)*cos(r)", "0.5890396362766583991336762", "0.1005451780227948919919", [60, 1500]),
        ("tanh(r^0.7)", "0.9033364003097953861951353", "0.4334699820910994782462", [200, 2300]),
        ("r^(3/5)*(2-r^2)^(1/2)", "1.194759557794919255933894", "0.5042860587970948373217", [130, 2300]),
    ] {
        let solution = solution(text);
        let contact = contact(&solution, Method::Only(Way::of("pieces").unwrap()));
        let found = [contact.depth(0.8).unwrap(), contact.pressure(0.3, 0.8).unwrap().unwrap()];
        for ((found, truth), most) in found.into_iter().zip([equivalent, pressure]).zip(most) {
            let (off, found) = (Decimal::read(truth).distance(found.estimate.value).abs(), found.estimate);
            assert!(found.bound == Bound::Proven && off <= found.error, "{text}: {found:?} is off by {off:e}");
            assert!(found.error <= 1e-13 * found.value && found.evaluations <= most, "{text}: {found:?}");
        }
    }
}

/// f ~ r^n has a finite p(0) for every n > 1, and for no other; a jump of f′ makes p infinite, a change of its slope does not.
#[test]
fn theory_decides_what_is_infinite() {
    let at = |text: &str, r: f64| contact(&solution(text), Method::Auto).pressure(r, 1.5).unwrap().map(|own| own.estimate.value);
    for text in ["r", "r^(1/2)", "r^(9/10)", "-r*ln(r)", "r+r^2*ln(1+r)", "exp(r)-1", "sin(r)", "r-r^2/(1+r)", "ln(1+r)+r^3"] {
        assert_eq!(at(text, 0.0), Err(Reason::Apex), "{text}");
    }
    for text in ["r^(1001/1000)", "r^2*ln(r)", "ln(1+r)-r", "1-cos(r)", "sqrt(1+r)-1-r/2", "max(0,r-1)^2"] {
        assert!(at(text, 0.0).is_ok_and(f64::is_finite), "{text}");
    }
    for text in ["max(0,r-1)", "piecewise(r^2,r<1,3*r-2)", "abs(r-1)", "piecewise(0,r<1,sqrt(r-1))", "max(0,r^2-1)"] {
        assert_eq!(at(text, 1.0), Err(Reason::Kink), "{text}");
    }
    // Concave: f′ is negative at the axis, or falls by a jump.
    for text in ["1-r", "abs(r-1)^3", "-sqrt(r)", "r^2-sin(r)", "r*ln(r)"] {
        assert_eq!(at(text, 0.0), Err(Reason::ConcaveApex), "{text}");
    }
    for text in ["min(r^2,r)", "piecewise(2*r,r<1,1+r)", "r^2-abs(r-1)", "-max(0,r-1)"] {
        assert_eq!(at(text, 1.0), Err(Reason::ConcaveKink), "{text}");
    }
    for text in ["piecewise(r^2,r<1,2*r-1)", "abs(r-1)^3", "max(0,r-1)^2"] {
        assert!(at(text, 1.0).is_ok_and(f64::is_finite), "{text}");
    }
}

/// Class "radii far below a kink": where the pressure of a piece that begins at the axis and ends at a kink b has a logarithm, it is
/// slope/π (π/2 arcosh(a/r) − ∫_b^a (x arccos(b/x))′/√(x² − r²) dx), of which the integral, by mpmath for r = 0, changes by (r/b)².
#[test]
fn pressures_far_below_a_kink_are_within_their_errors() {
    use std::f64::consts::{FRAC_PI_2, PI};
    let (a, slope, kink) = (1.9f64, 0.7, 2.484_971_103_166_057_5);
    let mut worst = 0.0f64;
    for text in ["piecewise(0.7*r,r<0.53,0.7*0.53)", "min(0.7*r,0.7*0.53)"] {
        let solution = solution(text);
        for key in ["pieces", "elliptic", "mixed", "recognised"] {
            let contact = contact(&solution, Method::Only(Way::of(key).unwrap()));
            let mut draw = Stream::new(7);
            for _ in 0..cases(40, 400) {
                let r = a * draw.log_uniform(1e-18, 1e-9);
                let truth = slope / PI * (FRAC_PI_2 * (a / r).acosh() - kink);
                let found = contact.pressure(r, a).unwrap().unwrap().estimate;
                let off = (found.value - truth).abs();
                assert!(off <= found.error + 4e-15, "{text} {key} {r:e}: {found:?}, off by {off:e}");
                worst = worst.max(off / truth);
            }
        }
    }
    assert!(worst < 1e-15, "{worst:e}");
}

/// The Evaluator refuses what is no place, and answers at once.
#[test]
fn places_and_tolerances_are_validated() {
    let solution = solution("r^2/2+r");
    let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
    let refused = |found: Result<(), TransformError>| assert!(matches!(found, Err(TransformError::Statement { .. })), "{found:?}");
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0, -f64::MIN_POSITIVE] {
        refused(evaluator.height(bad).map(|_| ()));
        refused(evaluator.equivalent(bad).map(|_| ()));
        refused(evaluator.force(bad).map(|_| ()));
        refused(evaluator.integral(bad).map(|_| ()));
        refused(evaluator.pressure(0.5, bad).map(|_| ()));
        refused(evaluator.pressure(bad, 0.5).map(|_| ()));
        refused(evaluator.displacement(bad, 0.5).map(|_| ()));
        refused(evaluator.displacement(2.0, bad).map(|_| ()));
        refused(evaluator.axial(bad, 0.5).map(|_| ()));
        refused(evaluator.axial(0.5, bad).map(|_| ()));
    }
    refused(evaluator.axial(0.0, 1.0).map(|_| ()));
    refused(evaluator.displacement(0.5, 1.0).map(|_| ()));
    for bad in [f64::NAN, 0.0, 1.0, -1e-13, f64::INFINITY] {
        refused(Evaluator::new(&solution, &Bindings::default(), Method::Auto, bad).map(|_| ()));
    }
}

/// Class "an infinite slope at a radius that no double holds": (r² − b²)^s from b on has g = s B(s, 1/2) x (x² − b²)^(s − 1/2).
#[test]
fn slopes_that_are_infinite_at_decimals_have_bounds() {
    // (s, s B(s, 1/2) from mpmath).
    for (s, factor) in [("0.5", std::f64::consts::FRAC_PI_2), ("0.7", 1.7540569034384752), ("0.4", 1.4716375921623523)] {
        for b in ["0.3", "0.7", "1.1"] {
            let solution = solution(&format!("piecewise(0, r < {b}, (r^2 - {b}^2)^{s})"));
            let (exponent, limit): (f64, f64) = (s.parse::<f64>().unwrap() - 0.5, b.parse().unwrap());
            for (method, most) in [(Method::Auto, 1e-15), (Method::Quadrature, 2e-5)] {
                let contact = contact(&solution, method);
                for x in [1.03, 1.5, 4.0].map(|share| share * limit) {
                    let truth = factor * x * ((x - limit) * (x + limit)).powf(exponent);
                    let found = contact.depth(x).unwrap().estimate;
                    // The truth is rounded, and so is b in it.
                    let off = (found.value - truth).abs() - 4e-15 * truth;
                    assert!(off <= found.error, "{s}, {b}, {x}: {found:?}, {truth}");
                    assert!(found.error <= most * truth, "{s}, {b}, {x}: {found:?}");
                }
            }
        }
    }
}
