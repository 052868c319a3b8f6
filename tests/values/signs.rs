//! Solutions in which the sign of an offset such as R − b depends on the parameters: a closed form for one sign is not used for the
//! other.
#![allow(clippy::unwrap_used, clippy::panic)]

use sneddon::expr::{Bindings, Expr};
use sneddon::parse;
use sneddon::print;
use sneddon::transform::{Evaluator, Method, Profile, Reading, Solution, TransformError, derive};
use sneddon_checks::random::Stream;
use sneddon_checks::seeds::cases;

fn solution(text: &str) -> Solution {
    derive(&Profile::new(&parse::profile(text).unwrap()).unwrap()).unwrap()
}

/// Closed forms against quadrature of f as typed, below the end of the profile. For `1/(R-b-r)` with R = 2 and b = 1, g(0.5) was
/// −0.47 for 1.95, with a proven bound of 3e-17.
#[test]
fn closed_forms_hold_for_either_sign_of_an_offset() {
    let mut stream = Stream::new(0x519);
    let (mut compared, mut exact) = (0, 0);
    for text in [
        "1/(R-b-r)",
        "1/((R-b)-2*r)",
        "1/(R-b-r)^2",
        "r/(R-b-r)",
        "r^2/(R-b+r)",
        "1/(b-R+r)^3",
        "ln(R-b-r)",
        "ln(abs(R-b)+r)",
        "1/(R-b-r^2)",
        "1/(1+r^2/(R^2-b^2))",
        "r^3/(R^2-b^2+r^2)",
        "sqrt(R-b-r)",
        "(R-b+r)^(3/2)",
        "sqrt(R^2-b^2+r^2)",
        "exp(-r/(R-b))",
        "r*exp(-r^2/(R-b))",
        "atan(r/(R-b))",
        "atanh(r/(R-b))",
        "sin(r/(R-b))",
        "1/((R-b)^2+r^2)",
        "ln((R-b)^2+r^2)",
        "sqrt((R-b)^2+r^2)",
        "r*atan(r/(R^2-2*R*b+b^2))",
        "r^3/((R-b)^2-r^2)",
    ] {
        let solution = solution(text);
        for _ in 0..cases(4, 60) {
            let sides = [(); 2].map(|()| f64::round(64.0 * stream.uniform(0.5, 4.0)) as i64);
            let set: Bindings = ["R", "b"].into_iter().zip(sides.map(|own| Expr::ratio(own, 64))).collect();
            let (Ok(own), Ok(other)) =
                (Evaluator::new(&solution, &set, Method::Auto, 1e-12), Evaluator::new(&solution, &set, Method::Quadrature, 1e-12))
            else {
                continue;
            };
            let a = own.limit().min(2.0) * stream.uniform(0.1, 0.9);
            let r = a * stream.uniform(0.1, 0.9);
            type Read<'a> = &'a dyn Fn(&Evaluator<'_>) -> Result<Option<Reading>, TransformError>;
            let reads: [Read<'_>; 3] = [&|own| own.equivalent(a).map(Some), &|own| own.force(a).map(Some), &|own| own.pressure(r, a)];
            for read in reads {
                let (Ok(Some(one)), Ok(Some(two))) = (read(&own), read(&other)) else { continue };
                compared += 1;
                exact += usize::from(one.method == "exact");
                let (one, two) = (one.estimate, two.estimate);
                let off = (one.value - two.value).abs();
                assert!(off <= one.error + two.error, "{text} at {set:?}, r = {r}, a = {a}: {one:?} and {two:?}");
            }
        }
    }
    assert!(compared >= 150 && exact >= 60, "{compared} numbers, {exact} from closed forms");
}

/// Class "impossible conditions": a square in a divisor is not negative, whatever it was expanded to. `1/((R-b)^2+r^2)` had formulas for
/// 0 < 2bR − b² − R².
#[test]
fn conditions_on_squares_and_divisors_are_possible() {
    for (text, expected) in [
        ("1/((R-b)^2+r^2)", &["0 < (R - b)^2"][..]),
        ("sqrt(R^2-2*R*b+b^2+r^2)", &["0 < (R - b)^2"]),
        ("-1/(R^2+b^2-2*R*b+r^2)^2", &["0 < (R - b)^2"]),
        ("1/((R+b)^2+r^2)", &[]),
    ] {
        let own = solution(text);
        let shown: Vec<String> = own.conditions.iter().map(print::text_condition).collect();
        assert_eq!(shown, expected, "{text}");
        assert!(own.terms().any(|term| term.answer.is_some()), "{text}");
    }
    for (text, expected) in [
        ("r^2/(R-b)", "b < R"),
        ("r^2*k/(b-R)", "R < b"),
        ("r^2/(R-b)^2", "0 < (R - b)^2"),
        ("r*tan(theta)", "0 < tan(theta)"),
        ("r^2/sqrt(R-b)", "b < R"),
        ("r^2/(b-R)^3", "R < b"),
        ("r^2/(R^3-3*R^2*b+3*R*b^2-b^3)", "b < R"),
        ("r*(32*c^5-80*c^4*k+80*c^3*k^2-40*c^2*k^3+10*c*k^4-k^5)", "0 < c - k/2"),
    ] {
        let explicit = sneddon::contact::explicit(&solution(text)).unwrap();
        let shown: Vec<String> = explicit.conditions.iter().map(print::text_condition).collect();
        assert_eq!(shown, [expected], "{text}");
    }
}

/// Class "impossible conditions": a coefficient that is negative for all parameters has no contact radius and no condition.
#[test]
fn no_condition_is_stated_that_no_parameters_meet() {
    for text in ["r^2/(R-b)/(b-R)", "r^2/(2*b*c-b^2-c^2)", "-r*(R-b)^2", "r^3*(k-m)^4*(2*k*m-k^2-m^2)", "r^2*(b-c)/(c-b)^3"] {
        let own = solution(text);
        assert!(sneddon::contact::explicit(&own).is_none() && own.conditions.is_empty(), "{text}: {:?}", own.conditions);
    }
}

/// The conditions name the pole if they also imply the sign of the divisor at the axis; otherwise they state that it keeps its sign.
#[test]
fn conditions_name_the_pole_of_a_difference() {
    for (text, expected) in [
        ("1/(R-b-r)", &["b < R", "r < R - b"][..]),
        ("1/(R-b-r)^2", &["b < R", "r < R - b"]),
        ("r/(R-b-r)", &["b < R", "r < R - b"]),
        ("ln(R-b-r)", &["b < R", "r < R - b"]),
        ("1/(R-b-r^2)", &["b < R", "r < sqrt(R - b)"]),
        ("1/(R^2-b^2-r^2)", &["b < R", "r < sqrt(R^2 - b^2)"]),
        ("tanh(r)/(R-b-r^3)", &["0 < (R - b)*(R - r^3 - b)"]),
        ("1/(r^2-(k-m)^2)", &["0 < (k - m)^2", "r < abs(k - m)"]),
        ("r^2/(r^2-k^2+2*k*m-m^2)", &["0 < (k - m)^2", "r < abs(k - m)"]),
        ("r^4/(r^4-(k-m)^4)", &["0 < (k - m)^2", "r < abs(k - m)"]),
        ("1/(r^2-(k-m)^4)", &["0 < (k - m)^2", "r < (k - m)^2"]),
        ("tan(r/(b-c))", &["r < pi/2*abs(b - c)"]),
        ("ln(cos(2*r/(b-c)))", &["r < pi/4*abs(b - c)"]),
        // The kinks of products of differences are the zeros of the factors.
        ("r*sqrt(abs((b-r)*(r+c)))", &[]),
        ("r*max(0,(r-b)*(r+c))^(3/2)", &[]),
        ("r*sqrt(abs(r^2+b*r-1))", &[]),
        ("ln(abs((b-r)*(r+c)))", &["r < b"]),
        ("sqrt(abs((b^2-r^2)*(r^2+c^2)))", &[]),
        // Decimals, offsets and signs that half of the usual parameters do not show.
        ("r*sqrt(r/b-0.3*r+1)", &["0 < r/b - 0.3*r + 1"]),
        ("r*sqrt(1-r^2/b+0.3*r^2)", &["0 < 0.3*r^2 - r^2/b + 1"]),
        ("tan(ln(r+b))", &["0 < cos(ln(b))*cos(ln(r + b))"]),
        ("r/tan(b-r)", &["0 < sin(b)*sin(b - r)"]),
        ("r*acosh(1/(1+r+b))", &["0 < 1/(b + 1) - 1"]),
        ("r^2/(r/b-r)", &[]),
        ("abs(r-b)/(c-r)", &["b < c", "r < c"]),
        ("abs(r-b)^2.5", &[]),
        ("r^2/max(R-r,c)", &["c < R"]),
        ("min(R-sqrt(R^2-r^2),h)", &["h < R", "r < R"]),
        ("max(0,R-sqrt(R^2-r^2)-h)", &["h < R", "r < R"]),
        ("piecewise(R-sqrt(R^2-r^2), r<b, R-sqrt(R^2-b^2))", &["b < R"]),
        ("r^2/abs(R-r)", &["r < R"]),
        ("r^2/max(0,R-r^2)", &["r < sqrt(R)"]),
    ] {
        let shown: Vec<String> = solution(text).conditions.iter().map(print::text_condition).collect();
        assert_eq!(shown, expected, "{text}");
    }
}
