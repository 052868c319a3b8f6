//! Patterns of the rules multiplied with each other and with powers of r: closed forms against quadrature.
//!
//! `SNEDDON_PRODUCTS` sets the number of draws, `SNEDDON_PRODUCTS_SEED` the first seed.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use sneddon::parse;
use sneddon::transform::rules::RULES;
use sneddon::transform::{Evaluator, Method, Profile, Sampler, derive, reach};
use sneddon_checks::random::Stream;

/// Draws of the sample.
const SAMPLE: u64 = 150;

fn setting(name: &str, otherwise: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(otherwise)
}

/// One profile: a product with a power, of two patterns, or a pattern of a power of r.
fn drawn(stream: &mut Stream) -> String {
    let smooth: Vec<&str> = RULES.iter().map(|rule| rule.pattern).filter(|pattern| !pattern.contains("piecewise")).collect();
    let mut pick = || smooth[(stream.unit() * smooth.len() as f64) as usize];
    let (first, second) = (pick(), pick());
    let power = (stream.unit() * 5.0) as u32;
    match (stream.unit() * 4.0) as u32 {
        0 => format!("r^{power}*({first})"),
        1 => format!("({first})*({second})"),
        2 => format!("r^{}*({first})^2", power / 2),
        _ => format!("r^{power}*({first})+({second})"),
    }
}

/// What was closed and compared, or what is wrong.
fn compared(text: &str, seed: u64) -> Result<bool, String> {
    let Ok(profile) = Profile::new(&parse::profile(text).unwrap()) else { return Ok(false) };
    let Ok(solution) = derive(&profile) else { return Ok(false) };
    if !solution.verification.demoted.is_empty() {
        return Err(format!("{text}: {:?}", solution.verification.demoted));
    }
    if solution.terms().all(|term| term.is_open()) {
        return Ok(false);
    }
    let mut sampler = Sampler::new(seed);
    let Some(bindings) = sampler.parameters(&solution) else { return Ok(false) };
    let build = |method| Evaluator::new(&solution, &bindings, method, 1e-11);
    let (Ok(auto), Ok(plain)) = (build(Method::Auto), build(Method::Quadrature)) else { return Ok(false) };
    let mut any = false;
    for x in sampler.points(reach(&auto).min(2.0), 2) {
        let pairs = [(auto.slope(x), plain.slope(x)), (auto.force(x), plain.force(x))];
        for (one, other) in pairs {
            let (Ok(one), Ok(other)) = (one, other) else { continue };
            let (one, other) = (one.estimate, other.estimate);
            if one.error + other.error > 1e-7 * one.value.abs() {
                continue;
            }
            // Estimates of quadratures are not proven: a wrong closed form is off by far more.
            if (one.value - other.value).abs() > one.error + other.error + 1e-10 * one.value.abs() {
                return Err(format!("{text} at {x}, {bindings:?}: {one:?} against {other:?}"));
            }
            any = true;
        }
    }
    Ok(any)
}

#[test]
fn products_of_patterns_are_right() {
    let (count, seed) = (setting("SNEDDON_PRODUCTS", SAMPLE), setting("SNEDDON_PRODUCTS_SEED", 1));
    let (mut closed, mut wrong) = (0, Vec::new());
    for own in seed..seed + count {
        let text = drawn(&mut Stream::new(own));
        match compared(&text, own) {
            Ok(any) => closed += u64::from(any),
            Err(fault) => wrong.push(fault),
        }
    }
    println!("{count} profiles, {closed} with something closed compared, {} wrong", wrong.len());
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(4 * closed > count, "{closed} of {count}");
}
