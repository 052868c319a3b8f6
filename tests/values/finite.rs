//! Finite values of profiles that are 0/0, inf/inf or infinitely curved somewhere in double precision, against values of 30 digits.
//!
//! `tests/oracle/finite.py` has the profiles and their references.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use sneddon::contact::{Contact, ContactError};
use sneddon::expr::{Bindings, Expr, Number};
use sneddon::parse;
use sneddon::transform::{
    Check, Closure, Evaluator, Interpolation, Method, NumericProfile, Profile, Quantities, Reading, TransformError, Verdict, check, derive,
};
use sneddon_checks::decimal::Decimal;
use sneddon_checks::seeds::{cases, sample};

/// The largest relative error of a number.
const LARGEST: f64 = 2e-12;

fn exact(text: &str) -> Expr {
    Expr::number(Number::from_f64(text.parse().unwrap()).unwrap())
}

fn profile(text: &str, parameters: &str) -> Profile {
    let pairs = parameters.split_whitespace().map(|own| own.split_once('=').unwrap());
    let values: Bindings = pairs.map(|(name, value)| (name, exact(value))).collect();
    Profile::new(&parse::profile(text).unwrap().substitute(&values)).unwrap_or_else(|error| panic!("{text}: {error}"))
}

#[test]
fn what_is_finite_is_answered_within_its_bound() {
    let (mut faults, mut count, mut worst) = (Vec::new(), 0, 0.0f64);
    for line in include_str!("../oracle/finite.csv").lines().filter(|line| !line.starts_with('#')).step_by(cases(5, 1)) {
        let [text, parameters, quantity, radius, at, truth] = line.split(';').collect::<Vec<_>>()[..] else { panic!("{line}") };
        let solution = derive(&profile(text, parameters)).unwrap();
        let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-12).unwrap();
        let contact = Contact::new(evaluator, 1.0, None, 1e-12);
        let at: f64 = at.parse().unwrap();
        let found = match quantity {
            "g" => contact.evaluator().equivalent(at).map_err(|error| error.to_string()),
            "F" => contact.force(at).map_err(|error| error.to_string()),
            _ => contact.pressure(at, radius.parse().unwrap()).map(|own| own.unwrap()).map_err(|error| error.to_string()),
        };
        let truth = Decimal::read(truth);
        count += 1;
        match found {
            Ok(found) => {
                let (error, relative) = (truth.distance(found.estimate.value), truth.relative(found.estimate.value));
                worst = worst.max(if error > f64::MIN_POSITIVE { relative } else { 0.0 });
                // What lies below the smallest doubles is 0 within them.
                if error > found.estimate.error || (relative > LARGEST && error > f64::MIN_POSITIVE) {
                    faults.push(format!("{text} ({parameters}), {quantity} at {at}: {found:?}, {error:e}"));
                }
            }
            Err(error) => faults.push(format!("{text} ({parameters}), {quantity} at {at}: {error}")),
        }
    }
    println!("{count} values, the largest relative error {worst:.1e}");
    assert!(count >= cases(30, 150), "the table is too short");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn removable_places_with_symbols_fail_no_check() {
    for text in ["sin(k*r)/(k*r)", "r/tanh(r/w)", "(1-exp(-r/w))/r", "sin(k*r)^2/r", "r/(exp(r/w)-1)", "r^2/(2*R)+(1-cos(k*r))/r"] {
        let Check { verdict, why, .. } = check(&derive(&profile(text, "")).unwrap()).unwrap();
        assert!(verdict != Verdict::Failed && (verdict == Verdict::Passed || why.is_some()), "{text}: {verdict:?}");
    }
}

/// g of a sum of |u| by pieces that are typed: the kinks are known, and located as well.
#[test]
fn kinks_without_end_are_located_as_far_as_they_are_needed() {
    let slope = |text: &str, x: f64| {
        let solution = derive(&profile(text, "")).unwrap();
        Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-12).unwrap().equivalent(x).map(|own| own.estimate)
    };
    // 1/2 − cos 2r changes its sign at π/6, 5π/6, 7π/6, …
    let pieces = "piecewise(1/2-cos(2*r)-2*(1/2-cos(2*r)),r<pi/6,1/2-cos(2*r),r<5*pi/6,-(1/2-cos(2*r)),r<7*pi/6,1/2-cos(2*r))";
    for x in [0.5, 1.0, 2.0, 3.5, 4.0] {
        let (found, typed) = (slope("abs(1-cos(r/0.5)-0.5)", x).unwrap(), slope(pieces, x).unwrap());
        assert!((found.value - typed.value).abs() <= found.error + typed.error && found.error < 1e-11, "{x}: {found:?} {typed:?}");
    }
    assert!(slope("abs(sin(r))", 1e4).is_err() && slope("abs(sin(r))", 60.0).is_ok());
    for text in ["min(r^1.3,1-exp(-(0.5*r)))", "abs(2.34*((1-cos(2*r))/r)-0.149)", "abs(sin(r)^2/(3/4)-0.19)"] {
        assert!(slope(text, 1.9).is_ok(), "{text}");
    }
}

/// Class "a number for a place that is none": NaN, infinities and negative places are refused by every quantity of every kind of profile.
#[test]
fn places_that_are_no_finite_radii_are_refused() {
    fn of_a_contact<P: Quantities>(contact: &Contact<'_, P>, at: f64) -> Vec<(&'static str, bool)> {
        let own = contact.evaluator();
        vec![
            ("g", own.equivalent(at).is_err()),
            ("F/2E", own.force(at).is_err()),
            ("G", own.integral(at).is_err()),
            ("f", own.height(at).is_err()),
            ("p of r", own.pressure(at, 0.5).is_err()),
            ("p of a", own.pressure(0.2, at).is_err()),
            ("u of r", own.displacement(at, 0.5).is_err()),
            ("u of a", own.displacement(0.7, at).is_err()),
            ("sigma_zz of z", own.axial(at, 0.5).is_err()),
            ("sigma_zz of a", own.axial(0.2, at).is_err()),
            ("profile", contact.profile(at).is_err()),
            ("d", contact.depth(at).is_err()),
            ("F", contact.force(at).is_err()),
            ("k", contact.stiffness(at).is_err()),
            ("p_mean", contact.mean_pressure(at).is_err()),
            ("u_1d of x", contact.line_displacement(at, 0.5).is_err()),
            ("u_1d of a", contact.line_displacement(0.2, at).is_err()),
            ("q of x", contact.line_load(at, 0.5).is_err()),
            ("q of a", contact.line_load(0.2, at).is_err()),
            ("pressure of r", contact.pressure(at, 0.5).is_err()),
            ("pressure of a", contact.pressure(0.2, at).is_err()),
            ("displacement of r", contact.displacement(at, 0.5).is_err()),
            ("displacement of a", contact.displacement(0.2, at).is_err()),
            ("U", contact.energy(at).is_err()),
            ("a", contact.contact_radius(at).is_err()),
        ]
    }
    fn of_quadrature(own: &NumericProfile, at: f64) -> Vec<(&'static str, bool)> {
        let tolerance = 1e-12;
        vec![
            ("slope", own.equivalent(at, tolerance).is_err()),
            ("force", own.force(at, tolerance).is_err()),
            ("integral", own.integral(at, tolerance).is_err()),
            ("height", own.height(at, tolerance).is_err()),
            ("pressure of r", own.pressure(at, 0.5, tolerance).is_err()),
            ("pressure of a", own.pressure(0.2, at, tolerance).is_err()),
            ("stress of r", own.pressure_by_elliptic_kernel(at, 0.5, tolerance).is_err()),
            ("stress of a", own.pressure_by_elliptic_kernel(0.2, at, tolerance).is_err()),
            ("axial of z", own.axial(at, 0.5, tolerance).is_err()),
            ("axial of a", own.axial(0.2, at, tolerance).is_err()),
            ("displacement of r", own.displacement(at, 0.5, tolerance).is_err()),
            ("displacement of a", own.displacement(0.7, at, tolerance).is_err()),
        ]
    }
    let mut faults = Vec::new();
    let mut take = |profile: &str, at: f64, found: Vec<(&'static str, bool)>| {
        faults.extend(found.into_iter().filter(|(_, refused)| !refused).map(|(quantity, _)| format!("{profile}: {quantity} at {at}")));
    };
    let closure = || Closure::with_f_prime(|r| r * r, |r| 2.0 * r).profile().unwrap();
    let radii: Vec<f64> = (0..40).map(|i| 0.05 * f64::from(i)).collect();
    let heights: Vec<f64> = radii.iter().map(|r| r * r).collect();
    let table = || Profile::from_points(&radii, &heights, Interpolation::MonotoneCubic).unwrap();
    for at in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0, -f64::MIN_POSITIVE] {
        for text in ["r^2/2", "sqrt(1+r^2)-1", "ln(cosh(r))", "piecewise(0,r<1,(r-1)^2)", "1-sqrt(1-r^2)", "2*r"] {
            let solution = derive(&profile(text, "")).unwrap();
            for method in [Method::Auto, Method::Quadrature] {
                let evaluator = Evaluator::new(&solution, &Bindings::default(), method, 1e-12).unwrap();
                take(text, at, of_a_contact(&Contact::new(evaluator, 1.0, None, 1e-12), at));
            }
            let intervals = solution.chains.iter().flat_map(|chain| &chain.intervals);
            let pieces: Vec<_> = intervals.map(|own| (own.segment.clone(), own.f_prime.clone())).collect();
            take(text, at, of_quadrature(&NumericProfile::new(&pieces, &Bindings::default()).unwrap(), at));
        }
        take("a closure", at, of_a_contact(&Contact::new(closure(), 1.0, None, 1e-12), at));
        take("a table", at, of_a_contact(&Contact::new(table(), 1.0, None, 1e-12), at));
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Class "an infinity or NaN that is called proven": what leaves the range of doubles is refused, one by one and in lists.
#[test]
fn values_beyond_the_range_of_doubles_are_refused() {
    for (text, quantity, at) in [
        ("r^2/4", "F", 1e200),
        ("r^2/4", "d", 1e200),
        ("0.625*r^1.34375", "U", 5e99),
        ("r^2/4", "U", 1e120),
        ("r^2/4", "U", 1e155),
        ("0.3*r", "p_mean", 1e-300),
        ("ln(cosh(r))", "p_mean", 1e-200),
        ("r^3", "G", 1e100),
    ] {
        let solution = derive(&profile(text, "")).unwrap();
        let contact = Contact::new(Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-12).unwrap(), 1.0, None, 1e-12);
        let found = match quantity {
            "F" => contact.force(at).is_ok() || contact.forces(&[1.0, at]).is_ok(),
            "d" => contact.depth(at).is_ok() || contact.depths(&[1.0, at]).is_ok(),
            "U" => !matches!(contact.energy(at), Err(ContactError::Transform(TransformError::Overflow { symbol: "a", .. }))),
            "G" => contact.integral(at).is_ok(),
            _ => contact.mean_pressure(at).is_ok_and(|own| own.is_ok()),
        };
        assert!(!found, "{quantity} of {text} at {at:e}");
    }
}

/// Class "0 ± 0 for a value below the smallest doubles": a positive value that underflows to 0 has a positive error.
#[test]
fn values_that_underflow_have_an_error() {
    let mut answered = 0;
    for (number, text) in
        ["r^2", "ln(cosh(r))", "r^3", "besselj(0,r)^2*r^2", "r^2*tanh(r)", "1-sqrt(1-r^2)", "sin(r)^2", "r^2/(1+r)"].into_iter().enumerate()
    {
        let solution = derive(&profile(text, "")).unwrap();
        for (way, method) in [Method::Auto, Method::Quadrature].into_iter().enumerate() {
            let contact = Contact::new(Evaluator::new(&solution, &Bindings::default(), method, 1e-12).unwrap(), 1.0, None, 1e-12);
            for a in sample([1e-70, 1e-108, 1e-112, 1e-162, 1e-170, 1e-200, 1e-308], number + way, 9) {
                let numbers = [("d", contact.depth(a)), ("F", contact.force(a)), ("G", contact.integral(a)), ("U", contact.energy(a))];
                for (quantity, found) in numbers {
                    let Ok(Reading { estimate, .. }) = found else { continue };
                    answered += 1;
                    assert!(estimate.value > 0.0 || estimate.error > 0.0, "{quantity} of {text} at {a:e}: {estimate:?}");
                }
            }
        }
    }
    assert!(answered >= cases(38, 407), "{answered}");
}

/// Class "a mean over an area that underflows": p_mean of a paraboloid is 4a/(3πR) E* while the force is not 0; below that, the error names
/// the underflow.
#[test]
fn mean_pressures_do_not_need_the_area() {
    let expected = 4.0 / (3.0 * std::f64::consts::PI);
    let mean = |radius: f64| {
        let solution = derive(&profile(&format!("r^2/(2*({radius:e}))"), "")).unwrap();
        let contact = Contact::new(Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-12).unwrap(), 1.0, None, 1e-12);
        contact.mean_pressure(radius).map(|own| own.unwrap().estimate).map_err(|error| error.to_string())
    };
    // Below 1e-150 the force has fewer and fewer digits.
    let sharp = [1e150, 1e9, 1.0, 1e-9, 1e-120, 1e-150].map(|radius| (radius, 3.5e-16));
    for (radius, largest) in sharp.into_iter().chain([(1e-154, 1e-14), (1e-157, 5e-9), (1e-160, 5e-3), (1e-161, 0.5)]) {
        let found = mean(radius).unwrap();
        assert!((found.value - expected).abs() <= found.error, "{radius:e}: {found:?}");
        assert!(found.error <= largest, "{radius:e}: {found:?}");
    }
    for (radius, reason) in [(1e-170, "too small"), (1e-300, "too small"), (1e170, "too large")] {
        assert!(mean(radius).unwrap_err().contains(reason), "{radius:e}: {:?}", mean(radius));
    }
}

/// Class "quadrature next to underflow": g(s x; s R) = s g(x; R) down to the smallest doubles.
#[test]
fn lengths_next_to_underflow_keep_their_bounds() {
    let quadrature = |text: &str, scale: f64, x: f64| {
        let parameters: Bindings = [("R", exact(&format!("{scale:e}")))].into_iter().collect();
        let solution = derive(&Profile::new(&parse::profile(text).unwrap().substitute(&parameters)).unwrap()).unwrap();
        let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Quadrature, 1e-10).unwrap();
        evaluator.equivalent(x * scale).map(|found| found.estimate)
    };
    let mut answered = 0;
    for text in ["R-sqrt(R^2-r^2)", "R*ln(cosh(r/R))", "r^2/(2*R)", "R*(1-cos(r/R))", "R*(r/R)^2.5", "R*sqrt(r/R)", "R*(1-exp(-r/R))"] {
        for (number, x) in [0.0105, 0.24, 0.93].into_iter().enumerate() {
            let usual = quadrature(text, 1.0, x).unwrap();
            for scale in sample([600, 960, 980, 990, 997, 1005, 1012], number, 3).map(|k| f64::from(-k).exp2()) {
                let Ok(found) = quadrature(text, scale, x) else { continue };
                answered += 1;
                let (error, bound) = ((found.value - scale * usual.value).abs(), found.error + scale * usual.error + f64::from_bits(1));
                assert!(error <= bound, "{text}, x = {x}, R = {scale:e}: {error:e} beyond {bound:e} of {:e}", found.value);
            }
        }
    }
    assert!(answered >= cases(40, 120), "{answered}");
}
