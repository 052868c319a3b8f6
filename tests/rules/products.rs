//! Patterns of the rules multiplied with each other and with powers of r, and composed: closed forms against quadrature.
//!
//! `SNEDDON_PRODUCTS` sets the number of draws, `SNEDDON_PRODUCTS_SEED` the first seed.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use sneddon::parse;
use sneddon::transform::rules::RULES;
use sneddon::transform::{Evaluator, Method, Profile, Sampler, derive, reach};
use sneddon_checks::random::Stream;
use sneddon_checks::seeds::{cases, over_seeds};

/// Draws of the sample.
const SAMPLE: u64 = 150;

fn setting(name: &str, otherwise: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(otherwise)
}

/// One profile: a product with a power, of two patterns, a sum, or a pattern of a power of r, of another pattern or of a multiple of it.
fn drawn(stream: &mut Stream) -> String {
    let smooth: Vec<&str> = RULES.iter().map(|rule| rule.pattern).filter(|pattern| !pattern.contains("piecewise")).collect();
    let mut pick = || smooth[(stream.unit() * smooth.len() as f64) as usize];
    let (first, second) = (pick(), pick());
    let power = (stream.unit() * 5.0) as u32;
    // The inner one at r, in the place of r.
    let composed = |inner: &str| composition(first, inner);
    match (stream.unit() * 7.0) as u32 {
        0 => format!("r^{power}*({first})"),
        1 => format!("({first})*({second})"),
        2 => format!("r^{}*({first})^2", power / 2),
        3 => format!("r^{power}*({first})+({second})"),
        4 => composed(["r^2", "r^3", "r^(1/2)", "r^(3/2)", "r^2/c"][power as usize]),
        5 => composed(&format!("({second})")),
        _ => format!("({second})*({})", composed(["r^2", "r^(1/2)", "r^3", "r/2", "r^4"][power as usize])),
    }
}

/// A pattern with an expression in the place of its r.
fn composition(pattern: &str, inner: &str) -> String {
    let is_part = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
    let mut out = String::new();
    for (at, c) in pattern.char_indices() {
        let alone = !is_part(pattern[..at].chars().next_back()) && !is_part(pattern[at + 1..].chars().next());
        if c == 'r' && alone { out.push_str(&format!("({inner})")) } else { out.push(c) }
    }
    out
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
        let pairs = [(auto.equivalent(x), plain.equivalent(x)), (auto.force(x), plain.force(x))];
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
    let (count, seed) = (setting("SNEDDON_PRODUCTS", cases(SAMPLE / 3, SAMPLE)), setting("SNEDDON_PRODUCTS_SEED", 1));
    let examine = |own: u64| match compared(&drawn(&mut Stream::new(own)), own) {
        Ok(any) => (u64::from(any), Vec::new()),
        Err(fault) => (0, vec![format!("{own}: {fault}")]),
    };
    let (closed, wrong) = over_seeds((count, seed), examine, |all, own| {
        all.0 += own.0;
        all.1.extend(own.1);
    });
    println!("{count} profiles, {closed} with something closed compared, {} wrong", wrong.len());
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(4 * closed > count, "{closed} of {count}");
}
