//! Pressures under tips that are straight between their kinks, against 40 digits and against the elliptic kernel.
#![allow(clippy::unwrap_used, clippy::panic)]

use sneddon::contact::Contact;
use sneddon::expr::Bindings;
use sneddon::num::{Bound, Estimate};
use sneddon::parse;
use sneddon::transform::{Evaluator, Method, Profile, Way, derive};
use sneddon_checks::decimal::Decimal;
use sneddon_checks::random::Stream;
use sneddon_checks::seeds::cases;

fn pressure(text: &str, way: &str, r: f64, a: f64) -> Estimate {
    let solution = derive(&Profile::new(&parse::profile(text).unwrap()).unwrap()).unwrap();
    let method = Method::Only(Way::of(way).unwrap());
    let contact = Contact::new(Evaluator::new(&solution, &Bindings::default(), method, 1e-13).unwrap(), 1.0, None, 1e-13);
    contact.pressure(r, a).unwrap_or_else(|error| panic!("{text} at {r:?} below {a:?}: {error}")).unwrap().estimate
}

/// p under max(0, r − b) at r, contact radius a: b, r, a, and p by mpmath with 40 digits.
const KINKS: &[(&str, f64, f64, &str)] = &[
    ("0.3", 0.5, 1.0, "0.6814116654960451733721654133440395407333"),
    ("0.3", 0.1, 1.0, "0.7751544326361513198608052407713610338486"),
    ("0.3", 0.0, 1.0, "0.7544086272806143223907705169332029684296"),
    ("0.3", 0.30000000000001, 1.0, "5.622943910059896737811633099391159208725"),
    ("0.3", 0.29999999999, 1.0, "4.523236124788993505068775596609014208147"),
    ("1e-9", 0.5, 1.0, "0.6584789484624083543125231742822049649319"),
    ("0.5", 1e-12, 1.0, "0.4948663069430585903801522121102389802081"),
    ("0.75", 0.999999999, 1.0, "0.0000264295602576985389143427326976805621047"),
    ("0.9999999", 0.5, 1.0, "0.0001643745343972574702832475103133659380156"),
    ("2e-300", 1e-300, 3e-300, "0.3805408591690759933858815807718526338225"),
    ("3e250", 1e200, 8e250, "0.6418201955102617542350127290842201154048"),
    ("1e-200", 2e-200, 1.0, "230.2710927676651576441422389194740248595"),
    ("0.9999999999", 0.99999999995, 1.0, "0.2805499448166116322990066220522396938592"),
    ("1/3", 0.34, 0.35, "0.3405911727949728768734491583541898729539"),
    ("sqrt(2)/2", 0.72, 0.8, "0.5554136226314358428598312694001137405395"),
];

#[test]
fn pressures_of_one_kink_have_forty_digits_behind_them() {
    for (b, r, a, truth) in KINKS {
        let found = pressure(&format!("max(0,r-{b})"), "straight", *r, *a);
        let truth = Decimal::read(truth);
        let off = truth.distance(found.value);
        assert!(off <= found.error, "b = {b}, r = {r:?}, a = {a:?}: {found:?} is off by {off:e}");
        assert!(found.error <= 1.1e-14 * found.value && found.bound == Bound::Proven, "b = {b}, r = {r:?}, a = {a:?}: {found:?}");
    }
}

/// Class "polygons": random broken lines, rising and falling, at random radii, next to kinks too.
#[test]
fn broken_lines_agree_with_the_elliptic_kernel() {
    let mut stream = Stream::new(93);
    for _ in 0..cases(40, 1000) {
        let kinks = 1 + (stream.uniform(0.0, 1.0) * 6.0) as usize;
        let places: Vec<f64> = (0..kinks).map(|_| (1e4 * stream.uniform(0.0, 1.0)).round() / 1e4).collect();
        let mut text = format!("{:?}*r", (stream.uniform(0.0, 1.0) * 100.0).round() / 100.0);
        for b in &places {
            let kink = if stream.uniform(0.0, 1.0) < 0.5 { "max(0,r-" } else { "abs(r-" };
            text += &format!("+{:?}*{kink}{b:?})", (1e3 * (stream.uniform(0.0, 1.0) - 0.2)).round() / 1e3);
        }
        let near = places.first().map_or(0.5, |b| b + 1e-9 * stream.uniform(0.0, 1.0));
        for r in [stream.uniform(0.0, 1.0), near, 0.999_999_9] {
            let (one, other) = (pressure(&text, "straight", r, 1.0), pressure(&text, "elliptic", r, 1.0));
            let off = (one.value - other.value).abs();
            assert!(off <= one.error + other.error, "{text} at r = {r:?}: {one:?} and {other:?} differ by {off:e}");
        }
    }
}

/// The answer takes this way, so that many kinks cost little: 200 kinks took 2.5 million steps at each radius.
#[test]
fn many_kinks_cost_little() {
    let tip = |n: usize| (1..n).map(|i| format!("max(0,r-{}/{n})", 2 * i + 1)).collect::<Vec<_>>().join("+");
    let solution = derive(&Profile::new(&parse::profile(&tip(200)).unwrap()).unwrap()).unwrap();
    let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
    let contact = Contact::new(evaluator, 1.0, None, 1e-13);
    // Prepares the terms.
    assert!(contact.pressure(0.1, 1.5).is_ok());
    let (found, steps, _) = sneddon::num::work::apart(u64::MAX, || contact.pressure(0.7013, 1.5).unwrap().unwrap().estimate);
    assert!(steps < 100_000 && found.bound == Bound::Proven, "{steps} steps: {found:?}");
}
