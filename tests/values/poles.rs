//! Poles and ends of profiles: numbers up to them, the place beyond them, and none where there is none.
//!
//! `tests/oracle/poles.py` has the profiles with their ends and references.
#![allow(clippy::unwrap_used, clippy::panic)]

use sneddon::expr::Bindings;
use sneddon::parse;
use sneddon::print;
use sneddon::transform::{Evaluator, Method, Profile, Solution, TransformError, derive};
use sneddon_checks::decimal::Decimal;
use sneddon_checks::formulas::typed;
use sneddon_checks::random::Stream;
use sneddon_checks::seeds::cases;
use std::f64::consts::FRAC_PI_2;

fn solution(text: &str) -> Solution {
    derive(&Profile::new(&parse::profile(text).unwrap()).unwrap_or_else(|error| panic!("{text}: {error}"))).unwrap()
}

/// The end that the error names, if the place is refused as one outside the domain.
fn end_beyond(text: &str, at: f64) -> Option<f64> {
    let solution = solution(text);
    let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-12).unwrap();
    let ends =
        [evaluator.equivalent(at).map(|_| ()), evaluator.force(at).map(|_| ()), evaluator.pressure(0.3 * at, at).map(|_| ())].map(|own| {
            match own {
                Err(TransformError::OutOfDomain { limit, .. }) => limit.rsplit(' ').next()?.parse::<f64>().ok(),
                _ => None,
            }
        });
    assert!(ends.iter().all(|own| *own == ends[0]), "{text} at {at}: {ends:?}");
    ends[0]
}

/// Poles of functions at the axis, which doubles do not see because π/2 is rounded; and profiles that are real at the axis only.
#[test]
fn profiles_that_begin_with_a_pole_are_refused() {
    let refused = |text: &str| Profile::new(&parse::profile(text).unwrap()).err();
    for text in [
        "tan(acos(r))",
        "tan(pi/2-r)",
        "1/cos(asin(1-r))",
        "ln(cos(acos(r)))",
        "sqrt(r)*tan(acos(r))",
        "r^2*tan(acos(r^3))",
        "tan(asin(b/(b+r)))",
        "tan(2*atan(1-r/b))",
        "ln(r)",
        "ln(-ln(r))",
        "ln(r/b)^2",
    ] {
        assert!(matches!(refused(text), Some(TransformError::SingularAtAxis { .. })), "{text}");
    }
    // Finite limits that are not found are not called infinite.
    for text in ["digamma(r)+1/r", "-1/ln(r)", "atan(ln(r))", "h/(1-ln(r/b))", "(sin(r)/r)^(1/r^2)", "r*digamma(r/b)", "r^2*polygamma(1,r)"]
    {
        assert!(matches!(refused(text), Some(TransformError::UnknownAtAxis { .. })), "{text}: {:?}", refused(text));
    }
    for text in ["asin(1+r)", "sin(asin(1+r/b))", "cos(2*acos(1+r/b))", "tanh(acosh(b/(b+r)))"] {
        assert!(matches!(refused(text), Some(TransformError::NotReal { .. })), "{text}");
    }
    // Signs next to the axis that doubles do not show, because r/tanh(r) − 1 = r²/3 is lost in the rounding of 1.
    for (text, height) in [("sqrt(r/tanh(r)-1)", 0.172_689_111_111_623), ("acosh(r/sin(r))", 0.173_901_485_682_104_37)] {
        let solution = solution(text);
        let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-12).unwrap();
        let found = evaluator.height(0.3).unwrap().estimate;
        assert!((found.value - height).abs() <= found.error, "{text}: {found:?} and {height}");
    }
    // Factors outweigh the pole, and the limit of f is subtracted.
    for (text, height) in [
        ("r*tan(acos(r))", (1.0f64 - 0.09).sqrt() - 1.0),
        ("r*tan(pi/2-r)", 0.3 / 0.3f64.tan() - 1.0),
        // 1 + 0.3 ψ(0.3) and 0.3 artanh(1/1.3), by mpmath.
        ("r*digamma(r)", -0.050_757_266_660_039_9),
        ("r*atanh(1/(1+r))", 0.305_532_289_089_156),
    ] {
        let solution = solution(text);
        let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-12).unwrap();
        let found = evaluator.height(0.3).unwrap().estimate.value;
        assert!((found - height).abs() < 4e-16, "{text}: {found} and {height}");
    }
}

/// Class "a number beyond a pole".
#[test]
fn numbers_before_the_end_are_right_and_those_beyond_are_refused_with_its_place() {
    for line in include_str!("../oracle/poles.csv").lines().filter(|line| !line.starts_with('#')) {
        let [text, end, at, truth] = line.split(';').collect::<Vec<_>>()[..] else { panic!("{line}") };
        let (end, at) = (end.parse::<f64>().unwrap(), at.parse::<f64>().unwrap());
        let solution = solution(text);
        let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-12).unwrap();
        let found = evaluator.equivalent(at).unwrap_or_else(|error| panic!("{text} at {at:?}: {error}")).estimate;
        let error = Decimal::read(truth).distance(found.value).abs();
        assert!(error <= found.error, "{text} at {at:?}: {found:?}, true error {error:e}");
        // Next to a pole the rounding of x alone counts: ε end/(end − x).
        let largest = 16.0 * f64::EPSILON * end / (end - at);
        assert!(found.error <= 4.0 * largest.max(1e-12) * found.value.abs(), "{text} at {at:?}: {found:?}");
        for beyond in [end * (1.0 + 1e-12), 1.2 * end, 7.0 * end] {
            let place = end_beyond(text, beyond);
            assert!(place.is_some_and(|own| (own / end - 1.0).abs() < 4e-15), "{text} at {beyond:?}: {place:?}, {end:?}");
        }
    }
}

/// A function that rises from 0, as text over u, and its inverse.
type Rising = (&'static str, fn(f64) -> f64);

const RISING: &[Rising] = &[
    ("exp(U)-1", f64::ln_1p),
    ("sinh(U)", f64::asinh),
    ("cosh(U)-1", |c| (1.0 + c).acosh()),
    ("U^3+U", |c| {
        let root = (0.25 * c * c + 1.0 / 27.0).sqrt();
        (0.5 * c + root).cbrt() - (root - 0.5 * c).cbrt()
    }),
    ("U*sqrt(1+U^2)", |c| (0.5 * ((1.0 + 4.0 * c * c).sqrt() - 1.0)).sqrt()),
    ("ln(1+U)", f64::exp_m1),
    ("asinh(U)", f64::sinh),
    ("atan(U)", f64::tan),
    ("U+atan(U)*0", |c| c),
    ("1-exp(-U^2)", |c| (-(-c).ln_1p()).sqrt()),
];

const AROUND: &[&str] = &["1/(D)", "r^2/(D)", "ln(D)", "sqrt(D)", "(D)^(-5/2)", "r/(D)^2", "acosh(1+D)", "exp(1/(D))", "gamma(D)"];

#[test]
fn every_function_of_a_falling_denominator_ends_at_its_zero() {
    let mut stream = Stream::new(0x901e);
    for _ in 0..cases(20, 1500) {
        let ((rising, inverse), around) = (stream.pick(RISING), stream.pick(AROUND));
        let (c, w) = (stream.short(0.1, 0.9), stream.log_uniform(1e-9, 1e9));
        let text = around.replace('D', &format!("{c:?}-({})", rising.replace('U', &format!("(r/{w:?})"))));
        let end = w * inverse(c);
        for beyond in [1.001 * end, 3.0 * end] {
            let place = end_beyond(&text, beyond);
            assert!(place.is_some_and(|own| (own / end - 1.0).abs() < 1e-13), "{text} at {beyond:?}: {place:?}, {end:?}");
        }
        let solution = solution(&text);
        let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-12).unwrap();
        let before = evaluator.equivalent(0.9 * end).map(|own| own.estimate);
        assert!(before.is_ok(), "{text} at {:?}: {before:?}", 0.9 * end);
    }
}

/// Class "the end of an argument that min or max does not use": f is defined only where all that was typed is. The formulas of
/// `min(1-sqrt(1-r^2),0.5)` went on to r = 1.8.
#[test]
fn profiles_end_where_an_argument_of_min_or_max_does() {
    let mut stream = Stream::new(0x9a7);
    // The kink of exp(1/D) is not sharp in doubles, which is refused.
    let around: Vec<&str> = AROUND.iter().copied().filter(|own| !own.starts_with("exp")).collect();
    for _ in 0..cases(20, 500) {
        let ((rising, inverse), around) = (stream.pick(RISING), stream.pick(&around));
        let (c, w) = (stream.short(0.1, 0.9), stream.log_uniform(1e-9, 1e9));
        let inner = around.replace('D', &format!("{c:?}-({})", rising.replace('U', &format!("(r/{w:?})"))));
        let end = w * inverse(c);
        let height = typed(&inner, &[("r", 0.6 * end)]);
        let (limit, part) = (stream.pick(&["min", "max"]), stream.pick(&["", "(r/W)^2+", "2*"]).replace('W', &format!("{w:?}")));
        let text = format!("{part}{limit}({inner},{height:?})");
        for beyond in [1.001 * end, 3.0 * end] {
            let place = end_beyond(&text, beyond);
            assert!(place.is_some_and(|own| (own / end - 1.0).abs() < 1e-13), "{text} at {beyond:?}: {place:?}, {end:?}");
        }
        assert_eq!(end_beyond(&text, 0.9 * end), None, "{text}");
    }
    for (text, end) in [
        ("max(0.2,cos(r)^0.5)", FRAC_PI_2),
        ("min(1-sqrt(1-r^2),0.5)", 1.0),
        ("min(1,asin(r))", 1.0),
        ("min(0.4,-ln(1-r))", 1.0),
        ("r^2+max(sqrt(1-r^2),0.5)", 1.0),
        ("min(0.3,max(0,1-sqrt(1-r^2)-0.1))", 1.0),
        ("abs(min(0.3,0.1-sqrt(4-r^2)/20)-0.02)", 2.0),
    ] {
        for beyond in [1.0 + 1e-12, 1.8, 4.6, 6.3].map(|own| own * end) {
            let place = end_beyond(text, beyond);
            assert!(place.is_some_and(|own| (own / end - 1.0).abs() < 4e-15), "{text} at {beyond:?}: {place:?}");
        }
        assert_eq!(end_beyond(text, 0.999 * end), None, "{text}");
    }
    // The arguments of a piece count within that piece only.
    assert_eq!(end_beyond("piecewise(min(1-sqrt(1-r^2),0.1), r<0.9, 0.1)", 1.8), None);
    // The order of these is known from their signs.
    for (text, end) in [("max(r,ln(1-r))", 1.0), ("min(sqrt(1-r),2+r)", 1.0), ("r^2+max(2,tanh(ln(2-r)))", 2.0)] {
        assert_eq!(end_beyond(text, 2.5), Some(end), "{text}");
    }
    for text in ["max(0,sqrt(r-1)-1)", "max(0,ln(r-1))", "max(0.5,acosh(r))"] {
        assert!(matches!(Profile::new(&parse::profile(text).unwrap()), Err(TransformError::NotReal { .. })), "{text}");
    }
}

/// Class "kinks at a pole": abs, min and max of what has a pole. All of these were refused at every radius, or without the place.
#[test]
fn profiles_with_kinks_end_at_the_pole_of_an_argument() {
    for (text, end) in [
        ("r^2/abs(1.3-r)", 1.3),
        ("r^2/abs(1.2-r^2)", 1.2f64.sqrt()),
        ("abs(1.1-r)^(-3/2)", 1.1),
        ("r^2+ln(abs(1.7-r))", 1.7),
        ("r^2/max(0,1-r)", 1.0),
        ("r^2/min(1,2-r)", 2.0),
        ("r^2/abs(cos(r))", FRAC_PI_2),
        ("ln(abs(cos(r)))*r", FRAC_PI_2),
        ("r^2+abs(tan(r))", FRAC_PI_2),
        ("min(tan(2*r),2)", 0.5 * FRAC_PI_2),
        ("abs(1/(3-cosh(r)))", 3f64.acosh()),
        ("max(r,1/(2-r))", 2.0),
        ("abs(gamma(1.5-r)-0.7)", 1.5),
        ("r^2/(sin(r)+cos(2*r))", FRAC_PI_2),
        ("r^2/(1-r*exp(1-r))", 1.0),
    ] {
        for beyond in [1.001, 1.7, 4.0].map(|own| own * end) {
            let place = end_beyond(text, beyond);
            assert!(place.is_some_and(|own| (own / end - 1.0).abs() < 4e-15), "{text} at {beyond:?}: {place:?}");
        }
        assert_eq!(end_beyond(text, 0.99 * end), None, "{text}");
    }
    // Infinite arguments that are not used, or under a factor that is zero there, end nothing.
    for text in ["min(2,1/abs(1-r))", "abs(r-1)*ln(abs(r-1))", "piecewise(0, r<2.5, max(0,4-4/(r-1))-4/3)", "sqrt(abs(r-1))"] {
        assert_eq!(end_beyond(text, 2.8), None, "{text}");
    }
}

/// Class "a kink that jumps": |u| over what vanishes with u. Numbers beyond the jump were called proven, and the jump was left out.
#[test]
fn profiles_that_jump_at_a_kink_are_refused() {
    for text in [
        "abs((b-r)*(r+c))/(b-r)",
        "max(0,(r-b)*(r+c))/(r-b)",
        "r*abs(b-r)/(b-r)",
        "abs(b*r-r^2)/(b-r)",
        "r+abs(cos(r))/cos(r)",
        "abs(r^2-2)/(r-sqrt(2))*r",
        "r*min(1-r,r-1)/(r-1)",
    ] {
        let found = Profile::new(&parse::profile(text).unwrap());
        assert!(matches!(found, Err(TransformError::Jump { .. })), "{text}: {found:?}");
    }
    for text in ["abs(r-b)^0.05", "abs(r-b)*ln(abs(r-b))", "abs(r-1)^3/(r-1)", "1e-9*r+abs(r-b)", "r+1e-12*max(0,r-b)", "abs(r-b)/(r+1e-3)"]
    {
        assert!(Profile::new(&parse::profile(text).unwrap()).is_ok(), "{text}");
    }
}

/// Poles that accumulate at the axis are refused at once; the search for them did not end.
#[test]
fn poles_that_accumulate_at_the_axis_are_refused() {
    for text in ["r*abs(tan(ln(r/3)))", "r/abs(cos(ln(r)))"] {
        assert!(end_beyond(text, 0.3).is_some_and(|end| end < 1e-300), "{text}");
    }
}

/// Kinks beyond the pole of an argument: the sign is that beyond the pole. mpmath at 30 digits.
#[test]
fn a_kink_beyond_a_pole_has_the_right_side() {
    for (text, at, truth) in [
        ("min(2,1/abs(1-r))", 2.8, "-1.2712880981185973710253334853516"),
        ("piecewise(0, r<2.5, max(0,4-4/(r-1))-4/3)", 5.0, "2.7054755050907167248323154567231"),
        ("piecewise(0, r<2.5, abs(4-4/(r-1))-4/3)", 2.8, "1.8279266752475235881903959692061"),
    ] {
        let solution = solution(text);
        let found = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-12).unwrap().equivalent(at).unwrap().estimate;
        let error = Decimal::read(truth).distance(found.value).abs();
        assert!(error <= found.error, "{text} at {at:?}: {found:?}, true error {error:e}");
    }
}

#[test]
fn a_denominator_that_comes_close_to_zero_ends_nothing() {
    let never = [
        "r^2/(1.001-sin(r))",
        "1/(1.0001+cos(r))",
        "r^2/((r-1)^2+1e-6)",
        "ln(1.001+cos(3*r))",
        "r^2/(1-tanh(r)^2+1e-9)",
        "sqrt(1+cos(r))",
        "sin(r)/r",
        "r/(exp(r)-1)",
        "(1-cos(r))/r",
        "r/tan(r/9)",
        "r^2/(2-tanh(r))",
        "r^2/(1+r*exp(-r)-0.3)",
    ];
    for text in never {
        for at in [1e-150, 1e-6, 0.9, 3.0, 4.5] {
            let solution = solution(text);
            let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-12).unwrap();
            let found = evaluator.check_domain("x", at);
            assert!(found.is_ok(), "{text} at {at:?}: {found:?}");
        }
    }
}

/// Between r = 4.9 and 5.1 only, where no power of two lies.
#[test]
fn a_narrow_range_of_poles_is_found() {
    for (text, end) in [("1/((r-5)^2-1e-2)", 4.9), ("ln((r-5)^2-1e-2)", 4.9), ("r^2/(cos(r)+0.9999)", (-0.9999f64).acos())] {
        let place = end_beyond(text, 6.0);
        assert!(place.is_some_and(|own| (own / end - 1.0).abs() < 1e-13), "{text}: {place:?}");
        assert_eq!(end_beyond(text, 0.99 * end), None, "{text}");
    }
}

/// Class "a condition does not name the end".
#[test]
fn conditions_name_the_end() {
    let expected = [
        ("tan(k*r)", &["r < pi/(2*k)"][..]),
        ("-ln(cos(r/w))", &["r < pi/2*w"]),
        ("R*acos(1-r/R)-sqrt(2*R*r-r^2)", &["r < 2*R"]),
        ("R-sqrt(R^2-(r-b)^2)", &["b < R", "r < b + R"]),
        ("piecewise(0, r<b, R-sqrt(R^2-(r-b)^2))", &["r < b + R"]),
        ("1/(c-exp(r/w))", &[]),
        ("1/(2-exp(r/w))", &["r < w*ln(2)"]),
        ("h*(1/cos(q*r)-1)", &["r < pi/(2*q)"]),
        ("acosh(2-r/w)", &["r < w"]),
        ("r^2/(1-c*tanh(r/w))", &["0 < 1 - c*tanh(r/w)"]),
        ("r^2/besselj(0,r/w)", &["r < 2.404825557695773*w"]),
        ("ln(1-(r/R)^3)", &["r < R"]),
        ("R^2/(R-r)", &["r < R"]),
        ("r^2/(1+cos(r/w))", &["r < pi*w"]),
    ];
    for (text, expected) in expected {
        let profile = Profile::new(&parse::profile(text).unwrap()).unwrap();
        let conditions: Vec<String> = profile.conditions.iter().map(print::text_condition).collect();
        assert!(expected.iter().all(|own| conditions.iter().any(|found| found == own)), "{text}: {conditions:?}");
    }
}

/// Class "angles are not exact".
#[test]
fn angles_have_exact_values() {
    for (text, same) in [
        ("r*tan(pi/6)", "r*sqrt(3)/3"),
        ("r*cos(pi/3)", "r/2"),
        ("r*sin(5*pi/4)", "-r*sqrt(2)/2"),
        ("r*cos(-7*pi/6)", "-r*sqrt(3)/2"),
        ("r*tan(3*pi/4)", "-r"),
        ("r*asin(1/2)", "r*pi/6"),
        ("r*acos(-1)", "r*pi"),
        ("r*atan(1)", "r*pi/4"),
        ("r^2+r*tan(pi)", "r^2"),
    ] {
        assert_eq!(parse::profile(text).unwrap(), parse::profile(same).unwrap(), "{text}");
    }
    // Terms that cancel for every angle appear neither in the answer nor in its conditions.
    let answer = solution("r^2+r*tan(theta)-r*sin(theta)/cos(theta)");
    assert!(answer.is_closed() && answer.conditions.is_empty(), "{:?}", answer.conditions);
    let acute = solution("r^2+r*sin(theta)-r*sqrt(1-cos(theta)^2)");
    assert!(print::text(&acute.equivalent_profile().formula).contains("theta"));
    assert!(Profile::new(&parse::profile("r*tan(t)-r*sin(t)/cos(t)").unwrap()).unwrap().is_flat());
}

/// Class "a coefficient that vanishes for all parameters is stated to be positive": half and triple angles, sums of two angles, hyperbolic
/// functions and fractions with opposite denominators.
#[test]
fn coefficients_that_vanish_identically_are_dropped() {
    for zero in [
        "tan(theta)-2*tan(theta/2)/(1-tan(theta/2)^2)",
        "sin(3*theta)-3*sin(theta)+4*sin(theta)^3",
        "tan(3*theta)-(3*tan(theta)-tan(theta)^3)/(1-3*tan(theta)^2)",
        "sin(theta+phi)-sin(theta)*cos(phi)-cos(theta)*sin(phi)",
        "tan(theta/2)-(1-cos(theta))/sin(theta)",
        "cosh(b)^2-sinh(b)^2-1",
        "tanh(b)-sinh(b)/cosh(b)",
        "1/(1-(1-c^2)/c^2)-c^2/(2*c^2-1)",
        "sqrt(b)/(c-1)+sqrt(b)/(1-c)",
    ] {
        let answer = solution(&format!("r^2+r*({zero})"));
        let shown = print::text(&answer.equivalent_profile().formula);
        assert!(shown == "2*x^2" && answer.conditions.is_empty(), "{zero}: {shown}, {:?}", answer.conditions);
        assert!(Profile::new(&parse::profile(&format!("r*({zero})")).unwrap()).unwrap().is_flat(), "{zero}");
    }
    // These vanish for some parameters only.
    for other in ["sin(3*theta)-3*sin(theta)+3*sin(theta)^3", "cosh(b)^2-sinh(b)^2-b", "1/(1-c)+1/(c-2)", "sin(theta)-sqrt(1-cos(theta)^2)"]
    {
        assert!(!Profile::new(&parse::profile(&format!("r*({other})")).unwrap()).unwrap().is_flat(), "{other}");
    }
}
