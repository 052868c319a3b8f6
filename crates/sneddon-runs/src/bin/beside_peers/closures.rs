//! Profiles as compiled Rust closures, with the properties that their author would declare.

use super::{Case, TOLERANCE, median_ns, show};
use sneddon::num::quadrature::{AbelOptions, AbelTransform, Radii, Start, Strip, abel};

/// Number of points evaluated with one transform.
const MANY: usize = 1000;
/// The width of the range of points, relative to x.
const WIDTH: f64 = 0.1;

/// Beyond these limits f′ has no expansion: close to the equator of the sphere, and over many waves of the cosine.
const NEAR: f64 = 1.95;
const FAR: f64 = 50.0;

/// f′ of the sphere of radius 2; 2 − r is taken from the distance, since r is rounded.
fn sphere(at: Radii<'_>, out: &mut [f64]) {
    for ((own, r), below) in out.iter_mut().zip(at.r).zip(at.below_limit) {
        *own = r / (below * (2.0 + r)).sqrt();
    }
}

/// One value of g by quadrature of f′ as a closure.
pub(crate) fn pointwise(place: &Case) {
    let plain = AbelOptions { rel_tol: TOLERANCE, ..AbelOptions::default() };
    let odd = AbelOptions { start: Start::Odd, ..plain };
    let algebraic = AbelOptions { start: Start::Algebraic, ..plain };
    match place.profile.as_str() {
        "sphere" if place.x < NEAR => smooth(place, &AbelOptions { limit: Some(2.0), ..odd }, sphere),
        "sphere" => measure(place, &AbelOptions { limit: Some(2.0), ..odd }, sphere),
        "power" => measure(place, &algebraic, each(|r| 2.7 * r.powf(1.7))),
        "root" => measure(place, &algebraic, each(|r| 0.35 / r.sqrt())),
        "worn" => measure(place, &AbelOptions { from: 0.6, ..odd }, each(|r| 0.5 * r)),
        "kink" => measure(place, &AbelOptions { from: 0.6, ..plain }, each(|_| 0.3)),
        "cosine" if place.x > FAR => measure(place, &odd, each(|r| 0.88 * (2.2 * r).sin())),
        "cosine" => twice(place, &odd, Strip { height: 2.0, largest: 36.0 }, each(|r| 0.88 * (2.2 * r).sin())),
        "ln_cosh" => twice(place, &odd, Strip { height: 1.4, largest: 5.8 }, each(f64::tanh)),
        "gaussian" => {
            twice(place, &odd, Strip { height: 3.0, largest: 350.0 }, each(|r| 0.8 * r / 1.69 * (-r * r / 1.69).exp()));
        }
        _ => {}
    }
}

/// Measures without and with a bound on f′ in a strip around the real axis: 0.88 cosh 4.4 < 36, tan 1.4 < 5.8, and
/// 0.8/1.69 (|u| + 3) e^((9 − u²)/1.69) < 350 for all real u.
fn twice(place: &Case, options: &AbelOptions<'_>, strip: Strip, slope: impl Fn(Radii<'_>, &mut [f64])) {
    smooth(place, options, &slope);
    measure_as("told", place, &AbelOptions { strip: Some(strip), ..*options }, &slope);
}

/// Measures values at many points close to the given one, and a single value without a known strip.
fn smooth(place: &Case, options: &AbelOptions<'_>, slope: impl Fn(Radii<'_>, &mut [f64])) {
    measure_as("alone", place, options, &slope);
    let near: Vec<f64> = (0..MANY).map(|i| place.x * (1.0 - WIDTH * i as f64 / MANY as f64)).collect();
    let transform = || AbelTransform::new(&slope, place.x, *options);
    let call = || {
        // The evaluations for the expansion of f′ are counted too.
        let mut transform = transform().ok()?;
        near.iter().map(|x| transform.g(*x).map(|found| found.value)).sum::<Result<f64, _>>().ok()
    };
    let Ok(mut known) = transform() else { return };
    // The second value is the first one without the cost of the expansion.
    let (Ok(_), Ok(found)) = (known.g(place.x), known.g(place.x)) else { return };
    show(place, "closure", median_ns(call) / MANY as f64, found.value, found.evaluations);
}

/// f′ of one radius for a block of them.
fn each(slope: impl Fn(f64) -> f64) -> impl Fn(Radii<'_>, &mut [f64]) {
    move |at, out| {
        for (own, r) in out.iter_mut().zip(at.r) {
            *own = slope(*r);
        }
    }
}

fn measure(place: &Case, options: &AbelOptions<'_>, slope: impl Fn(Radii<'_>, &mut [f64])) {
    measure_as("closure", place, options, slope);
}

fn measure_as(form: &str, place: &Case, options: &AbelOptions<'_>, slope: impl Fn(Radii<'_>, &mut [f64])) {
    let call = || abel(&mut |at: Radii<'_>, out: &mut [f64]| slope(at, out), place.x, options).ok();
    let Some(found) = call() else { return };
    show(place, form, median_ns(call), found.value, found.evaluations);
}
