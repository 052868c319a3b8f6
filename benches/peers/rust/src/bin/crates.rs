//! gkquad and bilby on g(x) = x ∫ f′(x sin t) dt at 1e-12, pointwise.

use gkquad::{Tolerance, prelude::*};
use peers::{Place, line, median_ns, places, slope};
use std::cell::Cell;
use std::f64::consts::FRAC_PI_2;

const TOLERANCE: f64 = 1e-12;

fn main() {
    let file = std::env::args().nth(1).expect("the file of points");
    for place in places(&file).iter().filter(|place| place.work.starts_with(&format!("{}@", place.profile))) {
        // One instance of the integrators per profile, so that the compiler sees the formula.
        match place.profile.as_str() {
            "sphere" => every(place, |r| r / ((2.0 - r) * (2.0 + r)).sqrt()),
            "power" => every(place, |r| 2.7 * r.powf(1.7)),
            "worn" => every(place, |r| if r > 0.6 { 0.5 * r } else { 0.0 }),
            "cosine" => every(place, |r| 0.88 * (2.2 * r).sin()),
            "root" => every(place, |r| 0.35 / r.sqrt()),
            "ln_cosh" => every(place, f64::tanh),
            "gaussian" => every(place, |r| 0.8 * r / 1.69 * (-r * r / 1.69).exp()),
            _ => every(place, slope(&place.profile)),
        }
    }
}

fn every(place: &Place, f: impl Fn(f64) -> f64 + Copy) {
    let (x, count) = (place.x, Cell::new(0_u64));
    let integrand = |t: f64| {
        count.set(count.get() + 1);
        x * f(x * t.sin())
    };
    let told = place.kink().map(|kink| (kink / x).asin());
    let show = |form: &str, who: &str, call: &dyn Fn() -> Option<f64>| {
        count.set(0);
        let Some(value) = call() else { return };
        let evaluations = count.get();
        line(&place.work, who, form, median_ns(call), place.error(value), evaluations);
    };
    show("qags", "gkquad", &|| {
        let relative = Tolerance::Relative(TOLERANCE);
        let result = match told {
            Some(kink) => {
                Integrator::with_algorithm(integrand, QAGP::new()).tolerance(relative).max_iters(1000).points(&[kink]).run(0.0..FRAC_PI_2)
            }
            None => Integrator::with_algorithm(integrand, QAGS::new()).tolerance(relative).max_iters(1000).run(0.0..FRAC_PI_2),
        };
        result.estimate().ok()
    });
    for (form, pair) in [("gk21", bilby::GKPair::G10K21), ("gk51", bilby::GKPair::G25K51)] {
        let adaptive =
            bilby::AdaptiveIntegrator::default().with_pair(pair).with_abs_tol(0.0).with_rel_tol(TOLERANCE).with_max_evals(100_000);
        show(form, "bilby", &|| {
            let result = match told {
                Some(kink) => adaptive.integrate_with_breaks(0.0, FRAC_PI_2, &[kink], integrand),
                None => adaptive.integrate(0.0, FRAC_PI_2, integrand),
            };
            result.ok().filter(|own| own.converged).map(|own| own.value)
        });
    }
}
