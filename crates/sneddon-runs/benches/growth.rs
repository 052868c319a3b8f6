//! How the work of a derivation and of a number grows with the size of the profile: exponents between sizes that double.

use sneddon::expr::Bindings;
use sneddon::num::work::{Budget, Exhausted, left, within};
use sneddon::parse;
use sneddon::transform::{Evaluator, Method, Profile, Solution, TransformError, derive};

/// A family of profiles, by the number of its parts.
type Family = (&'static str, fn(usize) -> String, &'static [usize]);

const FAMILIES: &[Family] = &[
    ("powers", |n| joined(n, "+", |i| format!("{i}*r^{}", i + 1)), &[25, 50, 100, 200]),
    ("logarithms", |n| joined(n, "+", |i| format!("ln(1+r/{i})")), &[20, 40, 80, 160]),
    ("kinks", |n| joined(n, "+", |i| format!("max(0,r-{i})")), &[25, 50, 100]),
    ("numeric pieces", pieces, &[12, 25, 50, 100]),
    ("nested roots", |n| (0..n).fold("1+r^2".to_owned(), |inner, _| format!("1+sqrt({inner})")), &[8, 16, 32, 64]),
    ("nested sines", |n| (0..n).fold("r^2".to_owned(), |inner, _| format!("sin({inner})")), &[8, 16, 32, 64]),
    ("nested fractions", |n| (0..n).fold("r".to_owned(), |inner, _| format!("r^2/(1+{inner})")), &[8, 16, 32, 64]),
    ("factors r+i", |n| joined(n, "*", |i| format!("(r+{i})")), &[10, 20, 40, 80]),
    ("(1+r)^n", |n| format!("(1+r)^{n}"), &[20, 40, 80, 160]),
    ("max(0,r-b)^n", |n| format!("max(0,r-b)^{n}"), &[20, 40, 80, 160]),
];

fn joined(n: usize, by: &str, part: impl Fn(usize) -> String) -> String {
    (1..=n).map(part).collect::<Vec<_>>().join(by)
}

/// f′ = i between the radii i and i + 1.
fn pieces(n: usize) -> String {
    let piece = |i: usize| format!("{i}*(r-{i})+{}", i * (i - 1) / 2);
    let inner: String = (1..n).map(|i| format!(", {}, r<{}", piece(i), i + 1)).collect();
    format!("piecewise(0, r<1{inner}, {})", piece(n))
}

/// The steps of the work; `None` if a minute does not suffice.
fn steps<T>(work: impl FnOnce() -> Result<T, TransformError>) -> Option<(T, u64)> {
    let most = Budget::seconds(60.0);
    let found = within(most, || {
        let result = work()?;
        Ok::<_, TransformError>((result, most.count() - left()))
    });
    match found {
        Ok(found) => Some(found),
        Err(TransformError::Exhausted(Exhausted { .. })) => None,
        Err(other) => {
            println!("  {other}");
            None
        }
    }
}

fn formulas(text: &str) -> Result<Solution, TransformError> {
    let formula = parse::profile(text).unwrap_or_else(|error| panic!("{text}: {error}"));
    let solution = derive(&Profile::new(&formula)?)?;
    let _ = (solution.equivalent_profile(), solution.force(), solution.pressure());
    Ok(solution)
}

fn number(solution: &Solution) -> Result<(), TransformError> {
    let set: Bindings = solution.profile.parameters().iter().map(|own| (own.name(), sneddon::expr::Expr::ratio(1, 2))).collect();
    let evaluator = Evaluator::new(solution, &set, Method::Auto, 1e-13)?;
    evaluator.equivalent(0.7).map(|_| ())
}

fn main() {
    println!("{:16} {:>6} {:>14} {:>6} {:>14} {:>6}", "family", "n", "formulas", "exp", "number", "exp");
    for (name, family, sizes) in FAMILIES {
        let mut before: Option<(usize, u64, u64)> = None;
        for n in *sizes {
            let Some((solution, derived)) = steps(|| formulas(&family(*n))) else {
                println!("{name:16} {n:6} {:>14}", "no answer");
                break;
            };
            let computed = steps(|| number(&solution)).map_or(0, |(_, steps)| steps);
            let exponent = |now: u64, pick: fn(&(usize, u64, u64)) -> u64| {
                before
                    .as_ref()
                    .map_or("-".to_owned(), |own| format!("{:.1}", (now as f64 / pick(own) as f64).ln() / (*n as f64 / own.0 as f64).ln()))
            };
            println!(
                "{name:16} {n:6} {derived:14} {:>6} {computed:14} {:>6}",
                exponent(derived, |own| own.1),
                exponent(computed, |own| own.2)
            );
            before = Some((*n, derived, computed));
        }
    }
}
