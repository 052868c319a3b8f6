//! Scaling laws: the quantities of s f(r/s) must equal those of f times powers of s, for s from 2⁻⁹⁹⁰ to 2⁹⁰⁰.
#![allow(clippy::unwrap_used, clippy::panic)]

use sneddon::contact::Contact;
use sneddon::expr::Bindings;
use sneddon::num::Estimate;
use sneddon::parse;
use sneddon::transform::{Evaluator, Method, Profile, derive};
use sneddon_checks::seeds::cases;

/// Returns f, g, F/E* and p of s f(r/s) at s x, each divided by its power of s; `None` for a refused number.
fn numbers(text: &str, power: i32, x: f64) -> [Option<Estimate>; 4] {
    let unit = f64::from(power).exp2();
    let scaled = format!("2^({power})*({})", text.replace('r', &format!("(r/2^({power}))")));
    let solution = derive(&Profile::new(&parse::profile(&scaled).unwrap()).unwrap()).unwrap();
    let contact = Contact::new(Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-12).unwrap(), 1.0, None, 1e-12);
    let in_units = |found: Estimate, times: usize| (0..times).fold(found, |own, _| own.scaled(1.0 / unit));
    [
        contact.profile(x * unit).ok().map(|own| in_units(own.estimate, 1)),
        contact.depth(x * unit).ok().map(|own| in_units(own.estimate, 1)),
        contact.force(x * unit).ok().map(|own| in_units(own.estimate, 2)),
        contact.pressure(0.3 * x * unit, x * unit).ok().and_then(Result::ok).map(|own| own.estimate),
    ]
}

fn agree(text: &str, powers: &[i32], x: f64) -> usize {
    let usual = numbers(text, 0, x).map(Option::unwrap);
    let mut answered = 0;
    for power in powers {
        for (index, (found, usual)) in numbers(text, *power, x).into_iter().zip(usual).enumerate() {
            let Some(found) = found else { continue };
            // Numbers with fewer than ten digits are checked, but not counted.
            answered += usize::from(found.error <= 1e-10 * usual.value.abs());
            let off = (found.value - usual.value).abs();
            assert!(
                off <= found.error + usual.error,
                "{} of {text} in units of 2^{power}: {found:?} instead of {usual:?}",
                ["f", "g", "F", "p"][index]
            );
        }
    }
    answered
}

/// Class "kinks are searched from 1e-30 to 1e30": on the wrong side of all of them min(…) was 0 ± 0, and |…| had the other sign.
#[test]
fn kinks_are_found_in_every_unit() {
    let powers = [-990, -900, -700, -500, -330, -100, 100, 330, 500, 700, 900];
    let texts = [
        "min(1-exp(-r),0.2)",
        "abs(sinh(r)-0.5)",
        "min(cosh(r)-1,0.5)",
        "min(r^2/(1+r^2),0.3)",
        "max(0,ln(1+r)-0.25)",
        "min(r^6,0.3)",
        "abs(r^4-0.3)",
    ];
    let answered: usize = texts.iter().step_by(cases(5, 1)).map(|text| agree(text, &powers, 0.9)).sum();
    assert!(answered >= cases(60, 257), "{answered}");
}

/// Class "signs next to the axis are read at r = 1e-9": a sphere of 10 pm in metres was said not to be real there.
#[test]
fn arguments_are_positive_next_to_the_axis_in_every_unit() {
    let powers = [-900, -330, -100, -40, 40, 100, 330];
    let texts = ["(2*r-r^2)^(1/2)", "acos(1-r)-(2*r-r^2)^(1/2)", "(r-r^3)^(1/3)", "ln(1+r-r^2)", "(r-r^2)^(3/4)"];
    let answered: usize = texts.iter().step_by(cases(2, 1)).map(|text| agree(text, &powers, 0.3)).sum();
    assert!(answered >= cases(60, 100), "{answered}");
}

/// Class "the argument of a logarithm leaves the range of doubles on its way": ln(1 + r²/s²) was 0 with a bound of 0.99.
#[test]
fn arguments_beyond_the_range_of_doubles_are_charged() {
    let powers = [-900, -700, -540, 520, 540, 700, 900];
    let texts = ["ln(1+r^2)", "-ln(1-r^2/16)", "ln(cosh(r))*r", "ln(1+r^2)^2+r^2", "tan(r^2/4)", "atanh(r^2/4)", "asin(r^2/4)"];
    let answered: usize = texts.iter().step_by(cases(2, 1)).map(|text| agree(text, &powers, 0.7)).sum();
    assert!(answered >= cases(70, 137), "{answered}");
}
