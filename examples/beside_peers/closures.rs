//! Profiles as compiled Rust closures, with what their author would state of them.

use super::{Place, TOLERANCE, median_ns, show};
use sneddon::num::quadrature::{AbelOptions, Radii, Start, Strip, abel};

/// One value of g by quadrature of f′ as a closure.
pub(crate) fn pointwise(place: &Place) {
    let plain = AbelOptions { rel_tol: TOLERANCE, ..AbelOptions::default() };
    let odd = AbelOptions { start: Start::Odd, ..plain };
    let algebraic = AbelOptions { start: Start::Algebraic, ..plain };
    match place.profile.as_str() {
        // R − r is taken from the distance, since r is rounded.
        "sphere" => measure(place, &AbelOptions { limit: Some(2.0), ..odd }, |at, out| {
            for ((own, r), below) in out.iter_mut().zip(at.r).zip(at.below_limit) {
                *own = r / (below * (2.0 + r)).sqrt();
            }
        }),
        "power" => measure(place, &algebraic, each(|r| 2.7 * r.powf(1.7))),
        "root" => measure(place, &algebraic, each(|r| 0.35 / r.sqrt())),
        "worn" => measure(place, &AbelOptions { from: 0.6, ..odd }, each(|r| 0.5 * r)),
        "kink" => measure(place, &AbelOptions { from: 0.6, ..plain }, each(|_| 0.3)),
        "cosine" => twice(place, &odd, Strip { height: 2.0, largest: 36.0 }, each(|r| 0.88 * (2.2 * r).sin())),
        "ln_cosh" => twice(place, &odd, Strip { height: 1.4, largest: 5.8 }, each(f64::tanh)),
        "gaussian" => {
            twice(place, &odd, Strip { height: 3.0, largest: 350.0 }, each(|r| 0.8 * r / 1.69 * (-r * r / 1.69).exp()));
        }
        _ => {}
    }
}

/// As it is, and told how large f′ is in a strip around the real axis: 0.88 cosh 4.4 < 36, tan 1.4 < 5.8, and for all real u
/// 0.8/1.69 (|u| + 3) e^((9 − u²)/1.69) < 350.
fn twice(place: &Place, options: &AbelOptions<'_>, strip: Strip, slope: impl Fn(Radii<'_>, &mut [f64])) {
    measure_as("closure", place, options, &slope);
    measure_as("told", place, &AbelOptions { strip: Some(strip), ..*options }, &slope);
}

/// f′ of one radius for a block of them.
fn each(slope: impl Fn(f64) -> f64) -> impl Fn(Radii<'_>, &mut [f64]) {
    move |at, out| {
        for (own, r) in out.iter_mut().zip(at.r) {
            *own = slope(*r);
        }
    }
}

fn measure(place: &Place, options: &AbelOptions<'_>, slope: impl Fn(Radii<'_>, &mut [f64])) {
    measure_as("closure", place, options, slope);
}

fn measure_as(form: &str, place: &Place, options: &AbelOptions<'_>, slope: impl Fn(Radii<'_>, &mut [f64])) {
    let call = || abel(&mut |at: Radii<'_>, out: &mut [f64]| slope(at, out), place.x, options).ok();
    let Some(found) = call() else { return };
    show(place, form, median_ns(call), found.value, found.evaluations);
}
