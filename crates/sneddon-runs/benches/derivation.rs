//! What a derivation costs inside the program, and what its check adds, per profile of the catalogue.
#![allow(clippy::unwrap_used)]

use divan::Bencher;
use sneddon::contact::{Edge, relations};
use sneddon::expr::Bindings;
use sneddon::transform::{Evaluator, Method, Profile, check, derive};
use sneddon::{parse, print};

/// A smooth, a composite, a rooted, a worn, a capped and an open profile.
const PROFILES: &[(&str, &str)] = &[
    ("cone", "r*tan(theta)"),
    ("power", "C*r^n"),
    ("poly10", "r^10/20+r^7/3-r^3/5+r^2/2"),
    ("sphere", "R-sqrt(R^2-r^2)"),
    ("hyperboloid", "h*(sqrt(1+r^2/b^2)-1)"),
    ("worn_paraboloid", "piecewise(0, r<b, (r^2-b^2)/(2*R))"),
    ("rounded_edge_punch", "piecewise(0, r<b, (r-b)^2/(2*R))"),
    ("capped_cone", "piecewise(r^2*tan(theta)/(2*b), r<b, tan(theta)*(r-b/2))"),
    ("r2_gauss", "C*r^2*exp(-r^2/w^2)"),
    ("r2_log_r", "r^2*ln(r)"),
    ("power_log", "C*r^2*ln(1+r/b)"),
    ("lorentzian", "h*r^2/(r^2+w^2)"),
    ("wavy_paraboloid", "r^2/(2*R)+h*(1-cos(k*r))"),
    ("log_quadratic", "h*ln(1+r^2/w^2)"),
    ("r_arctan", "C*r*atan(r/w)"),
    ("erf", "h*erf(r/w)"),
    ("worn_sphere", "piecewise(0, r<b, sqrt(R^2-b^2)-sqrt(R^2-r^2))"),
];

fn main() {
    divan::main();
}

/// From the typed text to every printed formula.
#[divan::bench(args = PROFILES.iter().map(|(name, _)| *name))]
fn derivation(bencher: Bencher<'_, '_>, name: &str) {
    let text = profile(name);
    bencher.bench(|| {
        let profile = Profile::new(&parse::profile(text).unwrap()).unwrap();
        let relations = relations(&derive(&profile).unwrap(), &Edge::Smooth).unwrap();
        [Some(&relations.g), Some(&relations.d), Some(&relations.force), relations.pressure.as_ref()]
            .map(|derived| derived.map(|own| print::text(&own.formula).len()))
    });
}

/// The comparison with quadrature at 64 points.
#[divan::bench(args = PROFILES.iter().map(|(name, _)| *name))]
fn own_check(bencher: Bencher<'_, '_>, name: &str) {
    let solution = derive(&Profile::new(&parse::profile(profile(name)).unwrap()).unwrap()).unwrap();
    bencher.bench(|| check(&solution).unwrap());
}

/// One number from a compiled solution: in doubles, and with the second pass, which F of a hyperboloid needs at small a.
#[divan::bench(args = [("r-atan(r)", 0.8), ("r-atan(r)", 1e-3), ("r^2+sqrt(1+r^2)", 0.8), ("r^2/2-sqrt(1+r^2)", 1e-3)])]
fn number(bencher: Bencher<'_, '_>, (text, at): (&str, f64)) {
    let solution = derive(&Profile::new(&parse::profile(text).unwrap()).unwrap()).unwrap();
    let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Exact, 1e-13).unwrap();
    bencher.bench_local(|| (evaluator.height(at).unwrap(), evaluator.equivalent(at)));
}

fn profile(name: &str) -> &'static str {
    PROFILES.iter().find(|(own, _)| *own == name).map(|(_, text)| *text).unwrap()
}
