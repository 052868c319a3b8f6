//! Profiles as compiled Rust closures, with what their author would state of them.

use super::{Place, TOLERANCE, median_ns, show};
use sneddon::num::quadrature::{AbelOptions, AbelTransform, Radii, Start, Strip, abel};

/// Places that are asked of one transform.
const MANY: usize = 1000;
/// The share of x on which they lie.
const WIDTH: f64 = 0.1;

/// Next to the equator of the sphere, and over as many waves, there is no expansion.
const NEAR: f64 = 1.95;
const FAR: f64 = 50.0;

/// f′ of the sphere of radius 2; 2 − r is taken from the distance, since r is rounded.
fn sphere(at: Radii<'_>, out: &mut [f64]) {
    for ((own, r), below) in out.iter_mut().zip(at.r).zip(at.below_limit) {
        *own = r / (below * (2.0 + r)).sqrt();
    }
}

/// One value of g by quadrature of f′ as a closure.
pub(crate) fn pointwise(place: &Place) {
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

/// As it is, and told how large f′ is in a strip around the real axis: 0.88 cosh 4.4 < 36, tan 1.4 < 5.8, and for all real u
/// 0.8/1.69 (|u| + 3) e^((9 − u²)/1.69) < 350.
fn twice(place: &Place, options: &AbelOptions<'_>, strip: Strip, slope: impl Fn(Radii<'_>, &mut [f64])) {
    smooth(place, options, &slope);
    measure_as("told", place, &AbelOptions { strip: Some(strip), ..*options }, &slope);
}

/// Values at many places next to the one in question, and one alone of which nothing is known.
fn smooth(place: &Place, options: &AbelOptions<'_>, slope: impl Fn(Radii<'_>, &mut [f64])) {
    measure_as("alone", place, options, &slope);
    let near: Vec<f64> = (0..MANY).map(|i| place.x * (1.0 - WIDTH * i as f64 / MANY as f64)).collect();
    let transform = || AbelTransform::new(&slope, place.x, *options);
    let call = || {
        // What f′ is expanded for is counted too.
        let mut transform = transform().ok()?;
        near.iter().map(|x| transform.g(*x).map(|found| found.value)).sum::<Result<f64, _>>().ok()
    };
    let Ok(mut known) = transform() else { return };
    // The second one is the first that costs no more than its own evaluations.
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

fn measure(place: &Place, options: &AbelOptions<'_>, slope: impl Fn(Radii<'_>, &mut [f64])) {
    measure_as("closure", place, options, slope);
}

fn measure_as(form: &str, place: &Place, options: &AbelOptions<'_>, slope: impl Fn(Radii<'_>, &mut [f64])) {
    let call = || abel(&mut |at: Radii<'_>, out: &mut [f64]| slope(at, out), place.x, options).ok();
    let Some(found) = call() else { return };
    show(place, form, median_ns(call), found.value, found.evaluations);
}
