//! What quadrature costs in evaluations of f′, without a clock, and that its estimates hold where other programs' do not.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use sneddon::num::kappa::kappa;
use sneddon::num::quadrature::{AbelOptions, AbelTransform, Radii, Start, Strip, abel, abel_force};
use sneddon::num::{Estimate, NumError, special};
use sneddon_checks::random::Stream;
use std::f64::consts::PI;

type Blocks<'a> = Box<dyn FnMut(Radii<'_>, &mut [f64]) + 'a>;

/// A closure over one radius and its distance below the limit, as one over blocks; of one type, because each type compiles the rules anew.
fn blocks<'a>(f: impl Fn(f64, f64) -> f64 + 'a) -> Blocks<'a> {
    Box::new(move |at, out| {
        for ((o, r), below) in out.iter_mut().zip(at.r).zip(at.below_limit) {
            *o = f(*r, *below);
        }
    })
}

/// The estimate, also that of a failure which carries one.
fn best(found: Result<Estimate, NumError>) -> Estimate {
    match found {
        Ok(found) => found,
        Err(NumError::ToleranceNotReached { value, error, evaluations, .. } | NumError::EvaluationLimit { value, error, evaluations }) => {
            Estimate::estimated(value, error, evaluations)
        }
        Err(error) => panic!("{error}"),
    }
}

const PLAIN: AbelOptions<'static> = AbelOptions {
    rel_tol: 1e-12,
    abs_tol: 0.0,
    max_evaluations: 200_000,
    start: Start::Smooth,
    from: 0.0,
    breakpoints: &[],
    limit: None,
    roundings: 8.0,
    strip: None,
};
const ODD: AbelOptions<'static> = AbelOptions { start: Start::Odd, ..PLAIN };
const ALGEBRAIC: AbelOptions<'static> = AbelOptions { start: Start::Algebraic, ..PLAIN };

/// The slopes of the eight profiles that the peers were measured with, at 1e−12: true values as two doubles, 60 digits.
#[test]
fn closures_at_the_points_of_the_peers() {
    let sphere = |r: f64, below: f64| r / (below * (2.0 + r)).sqrt();
    let limit = AbelOptions { limit: Some(2.0), ..ODD };
    let power = |r: f64, _: f64| 2.7 * r.powf(1.7);
    let worn = |r: f64, _: f64| r / 2.0;
    let waves = |r: f64, _: f64| 0.88 * (2.2 * r).sin();
    let root = |r: f64, _: f64| 0.35 / r.sqrt();
    let tanh = |r: f64, _: f64| r.tanh();
    let gauss = |r: f64, _: f64| 0.8 * r / 1.69 * (-r * r / 1.69).exp();
    let cone = |_: f64, _: f64| 0.3;
    let told = AbelOptions { from: 0.6, ..ODD };
    type Slope = fn(f64, f64) -> f64;
    // Eight nodes and four guards are the least; 20, 36, … with each rule up the ladder.
    let cases: [(&str, Slope, f64, AbelOptions<'_>, f64, f64, u64); 18] = [
        ("sphere", sphere, 0.01, limit, 5.000041667291678e-05, -4.68231531095681e-23, 12),
        ("sphere", sphere, 0.5, limit, 0.12770640594149768, -9.632703916039247e-18, 12),
        ("sphere", sphere, 1.9, limit, 3.480383563823163, 2.6822765263702647e-17, 12),
        ("sphere", sphere, 1.999999, limit, 15.201797068264066, 6.57990429014747e-16, 12),
        ("r^2.7", power, 0.5, ALGEBRAIC, 0.34702969148051105, 1.44889357399546e-17, 64),
        ("r^2.7", power, 3.0, ALGEBRAIC, 43.79000655242253, 8.62512085793683e-17, 64),
        ("worn", worn, 0.7, told, 0.1261942946412396, -1.5967914457653162e-18, 12),
        ("worn", worn, 0.6001, told, 0.0032870200181963917, 1.247491505402188e-19, 12),
        ("worn", worn, 3.0, told, 4.409081537009721, -1.3575737878393824e-16, 12),
        ("waves", waves, 0.5, ODD, 0.42200170898021305, -1.8467486086090226e-17, 12),
        ("waves", waves, 3.0, ODD, -0.21010914478826972, -1.3141019886611072e-17, 20),
        ("waves", waves, 100.0, ODD, -4.375809195569985, 4.710157979099557e-17, 260),
        ("root", root, 0.5, ALGEBRAIC, 0.6489261370554801, 5.131972101683943e-17, 48),
        ("ln cosh", tanh, 0.5, ODD, 0.23713379766125792, -1.2250893573344202e-17, 12),
        ("ln cosh", tanh, 3.0, ODD, 3.985952806663719, 7.428235670852729e-17, 36),
        ("gauss", gauss, 0.5, ODD, 0.10733460237993639, 3.283726390980711e-19, 12),
        ("gauss", gauss, 3.0, ODD, 0.45773112020843737, -1.4654810204000704e-17, 36),
        ("cone", cone, 3.0, AbelOptions { from: 0.6, ..PLAIN }, 1.2324945654041093, -8.176800068179843e-17, 12),
    ];
    for (name, slope, x, options, high, low, most) in cases {
        let found = abel(&mut blocks(slope), x, &options).unwrap();
        let off = ((found.value - high) - low).abs();
        assert!(off <= found.error && found.error <= 1e-12 * high.abs(), "{name} at {x}: off {off:e}, {found:?}");
        assert!(off <= 1e-14 * high.abs(), "{name} at {x}: off {off:e}");
        assert!(found.evaluations <= most, "{name} at {x}: {found:?}");
    }
}

/// Where other programs return 0 ± 0, or claim more digits than they have.
#[test]
fn failures_of_the_peers_are_answered() {
    // A kink that nobody told, x just beyond it: a typed failure or an estimate that holds, and never 0 ± 0.
    let worn = |r: f64, _: f64| if r > 0.6 { r / 2.0 } else { 0.0 };
    for beyond in [1e-1, 1e-4, 1e-6, 1e-8, 1e-10] {
        let x: f64 = 0.6 + beyond;
        let truth = 0.5 * x * ((x - 0.6) * (x + 0.6)).sqrt();
        for options in [PLAIN, ODD] {
            let found = best(abel(&mut blocks(worn), x, &options));
            assert!((found.value - truth).abs() <= found.error && found.error > 0.0, "{beyond:e}: {found:?}, is {truth:e}");
        }
    }
    // The sphere next to its equator, with the rounding of r and without.
    for gap in [1e-2, 1e-4, 1e-6, 1e-9] {
        let x: f64 = 2.0 - gap;
        let truth = 0.5 * x * (2.0 * x / (2.0 - x)).ln_1p();
        let by_r = |r: f64, _: f64| r / ((2.0 - r) * (2.0 + r)).sqrt();
        for options in [PLAIN, ODD] {
            let found = best(abel(&mut blocks(by_r), x, &options));
            assert!((found.value - truth).abs() <= found.error + 1e-15 * truth, "{gap:e}: {found:?}, is {truth:e}");
        }
        let by_distance = |r: f64, below: f64| r / (below * (2.0 + r)).sqrt();
        for start in [Start::Odd, Start::Smooth] {
            let options = AbelOptions { start, limit: Some(2.0), rel_tol: 1e-14, ..PLAIN };
            let found = best(abel(&mut blocks(by_distance), x, &options));
            assert!((found.value - truth).abs() <= found.error + 1e-15 * truth, "{gap:e}: {found:?}, is {truth:e}");
            assert!(start == Start::Smooth || found.evaluations == 12, "{gap:e}: {found:?}");
        }
    }
    // A Gaussian far out, and 35 waves.
    let gauss = |r: f64, _: f64| 0.8 * r / 1.69 * (-r * r / 1.69).exp();
    for options in [PLAIN, ODD] {
        let found = best(abel(&mut blocks(gauss), 100.0, &options));
        assert!((found.value - 0.4000338085719223).abs() <= found.error && found.error < 1e-12, "{found:?}");
        let loose = AbelOptions { rel_tol: 1e-3, ..options };
        let found = best(abel(&mut blocks(|r, _| 0.88 * (2.2 * r).sin()), 100.0, &loose));
        assert!((found.value + 4.375809195569985).abs() <= found.error, "{found:?}");
    }
    // Nothing below x: zero without an error, after a search.
    let found = abel(&mut blocks(|_, _| 0.0), 1.0, &PLAIN).unwrap();
    assert!(found.value == 0.0 && found.error == 0.0 && found.evaluations > 100);
}

#[test]
fn limits_of_evaluations_and_domains_are_typed() {
    let few = AbelOptions { max_evaluations: 60, ..PLAIN };
    let found = abel(&mut blocks(|r, _| 1.0 / (r * r + 1e-10)), 1.0, &few);
    assert!(matches!(found, Err(NumError::EvaluationLimit { evaluations, .. }) if evaluations < 200), "{found:?}");
    for x in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(abel(&mut blocks(|r, _| r), x, &PLAIN), Err(NumError::OutOfDomain { .. })));
    }
    let limit = AbelOptions { limit: Some(1.0), ..PLAIN };
    assert!(matches!(abel(&mut blocks(|r, _| r), 1.0, &limit), Err(NumError::OutOfDomain { .. })));
    assert!(matches!(abel(&mut blocks(|_, _| f64::NAN), 1.0, &PLAIN), Err(NumError::NotFinite { .. })));
    assert_eq!(abel(&mut blocks(|r, _| r), 0.0, &PLAIN).unwrap().value, 0.0);
    let tight = AbelOptions { rel_tol: 1e-17, ..PLAIN };
    assert!(matches!(abel(&mut blocks(|r, _| r), 1.0, &tight), Err(NumError::ToleranceNotReached { .. })));
}

/// Evenly over the orders of magnitude, given as exponents of ten.
fn log(stream: &mut Stream, low: f64, high: f64) -> f64 {
    10f64.powf(stream.uniform(low, high))
}

type Slope = Box<dyn Fn(f64, f64) -> f64>;

/// f′, x, what is told of it, g, and the relative error that g itself may have.
fn case(family: u32, stream: &mut Stream) -> (Slope, f64, AbelOptions<'static>, f64, f64) {
    let hint = if stream.unit() < 0.5 { ODD } else { PLAIN };
    match family {
        0 => {
            let x = 1.0 - log(stream, -7.0, -0.01);
            let g = 0.5 * x * (2.0 * x / (1.0 - x)).ln_1p();
            let told = stream.unit() < 0.5;
            let f: Slope = if told {
                Box::new(|r, below| r / (below * (1.0 + r)).sqrt())
            } else {
                Box::new(|r, _| r / ((1.0 - r) * (1.0 + r)).sqrt())
            };
            (f, x, AbelOptions { limit: told.then_some(1.0), ..hint }, g, 4e-15)
        }
        1 => {
            let (n, x) = (stream.uniform(0.1, 7.0), log(stream, -3.0, 3.0));
            (
                Box::new(move |r, _| n * r.powf(n - 1.0)),
                x,
                if n < 2.0 || stream.unit() < 0.5 { ALGEBRAIC } else { PLAIN },
                kappa(n) * x.powf(n),
                2e-14,
            )
        }
        2 => {
            let (w, x) = (log(stream, -2.5, 1.0), 1.0);
            let z: f64 = x / w;
            (Box::new(move |r, _| 2.0 * r / (w * w) * (-r * r / (w * w)).exp()), x, hint, 2.0 * z * special::dawson(z), 4e-15)
        }
        3 => {
            let x = log(stream, -2.0, 4.0);
            (Box::new(|r: f64, _| r / 1f64.hypot(r)), x, hint, x * x.atan(), 2e-15)
        }
        4 => {
            let k = log(stream, -1.0, 2.6);
            // r is rounded: the waves are known to no more than their phase, and so is the value.
            (Box::new(move |r, _| k * (k * r).sin()), 1.0, hint, 0.5 * PI * k * special::struveh(0.0, k), 1e-15 * (4.0 + k))
        }
        5 => {
            // A steep power beside a narrow step: rᵏ(1 − exp(−r²/w²)), by moments of the step.
            let (k, w) = (f64::from(3 + 2 * (stream.unit() * 3.0) as i32), log(stream, -3.5, -1.2));
            let power = kappa(k + 1.0) / (k + 1.0);
            let (mut step, mut term) = (0.0, 0.5 * (1..=((k as i32 - 1) / 2)).map(f64::from).product::<f64>() * w.powf(k + 1.0));
            for j in 0..7 {
                step += term;
                let j = f64::from(j);
                term *= (2.0 * j + 1.0) / (2.0 * j + 2.0) * (0.5 * (k + 1.0) + j) * w * w;
            }
            (Box::new(move |r, _| -r.powf(k) * (-r * r / (w * w)).exp_m1()), 1.0, hint, power - step, 4e-15)
        }
        6 => {
            let (b, x) = (0.6, 0.6 + log(stream, -6.0, 1.0));
            let angle = ((x - b) * (x + b)).sqrt().atan2(b);
            (Box::new(|_, _| 1.0), x, AbelOptions { from: b, ..hint }, x * angle, 2e-15)
        }
        _ => {
            let (k, x) = (log(stream, -2.0, 1.3), 1.0);
            // f = ln(1 + k²r²): g = 2 x asinh(kx)·k/√(1 + k²x²)
            let z: f64 = k * x;
            (Box::new(move |r, _| 2.0 * k * k * r / (1.0 + k * k * r * r)), x, hint, 2.0 * z * z.asinh() / 1f64.hypot(z), 4e-15)
        }
    }
}

/// 4000 cases, or as many as the variable CASES says.
fn cases() -> usize {
    std::env::var("CASES").ok().and_then(|own| own.parse().ok()).unwrap_or(4000)
}

#[test]
fn the_estimate_is_never_below_the_true_error() {
    let mut stream = Stream::new(20_261_121);
    let (mut violations, mut reached) = (Vec::new(), 0);
    let cases = cases();
    for _ in 0..cases {
        let family = (stream.unit() * 8.0) as u32;
        let (f, x, options, truth, doubt) = case(family, &mut stream);
        let options = AbelOptions { rel_tol: log(&mut stream, -13.5, -2.0), max_evaluations: 20_000, roundings: 16.0, ..options };
        let found = abel(&mut blocks(f), x, &options);
        reached += usize::from(found.is_ok());
        let found = best(found);
        let off = (found.value - truth).abs();
        if off.is_nan() || off > found.error + doubt * truth.abs() {
            violations.push(format!("family {family} at {x}: {:e}, {options:?}, {found:?}, is {truth:e}, off {off:e}", options.rel_tol));
        }
    }
    assert!(violations.is_empty(), "{} of {cases}: {violations:#?}", violations.len());
    assert!(reached > cases * 8 / 10, "{reached} of {cases} reached their tolerance");
}

/// The same of transforms that keep what f′ has shown: at the place that is asked first, and when it is known.
#[test]
fn the_estimate_of_a_transform_is_never_below_the_true_error() {
    let mut stream = Stream::new(20_261_123);
    let (mut violations, mut reached, mut saved) = (Vec::new(), 0, 0);
    let cases = cases();
    for _ in 0..cases {
        let family = (stream.unit() * 8.0) as u32;
        let (f, x, options, truth, doubt) = case(family, &mut stream);
        let start = if options.start == Start::Smooth && stream.unit() < 0.8 { Start::Odd } else { options.start };
        let options = AbelOptions { rel_tol: log(&mut stream, -13.5, -2.0), max_evaluations: 20_000, roundings: 16.0, start, ..options };
        let up_to = (x * stream.uniform(1.0, 3.0)).min(options.limit.map_or(f64::INFINITY, f64::next_down)).max(x);
        let mut transform = AbelTransform::new(blocks(&f), up_to, options).unwrap();
        let first = transform.g(x);
        let second = transform.g(x);
        reached += usize::from(second.is_ok());
        let (first, second) = (best(first), best(second));
        let alone = best(abel(&mut blocks(&f), x, &options));
        saved += usize::from(second.evaluations < alone.evaluations);
        for found in [first, second] {
            let off = (found.value - truth).abs();
            if off.is_nan() || off > found.error + doubt * truth.abs() {
                violations.push(format!("family {family} at {x}: {options:?}, {found:?}, is {truth:e}, off {off:e}"));
            }
        }
    }
    assert!(violations.is_empty(), "{} of {cases}: {violations:#?}", violations.len());
    assert!(reached > cases * 8 / 10 && saved > cases / 4, "{reached} of {cases} reached their tolerance, {saved} with fewer evaluations");
}

/// g and F of a paraboloid, f′ = r: x² and 2a³/3, at all lengths, with few evaluations where f′ is known; and f′ is asked nowhere beyond.
#[test]
fn transforms_at_all_lengths_and_within_their_range() {
    for exponent in (-140..=100).step_by(4) {
        let x = 1.3 * 10f64.powi(exponent);
        let slope = move |at: Radii<'_>, out: &mut [f64]| {
            assert!(at.r.iter().all(|r| *r > 0.0 && *r <= 1.1 * x));
            out.copy_from_slice(at.r);
        };
        let mut transform = AbelTransform::new(slope, 1.1 * x, ODD).unwrap();
        for place in [x, 0.9 * x, 0.3 * x, 1.1 * x] {
            let (g, force) = (transform.g(place).unwrap(), transform.force(place).unwrap());
            assert!((g.value - place * place).abs() <= g.error && g.error <= 1e-12 * g.value, "{place:e}: {g:?}");
            let truth = 2.0 * place * place * place / 3.0;
            let off = (force.value - truth).abs();
            assert!(off <= force.error && (force.error <= 1e-12 * truth || truth < 1e-300), "{place:e}: {force:?}");
        }
        for place in [x, 0.3 * x] {
            let force = transform.force(place).unwrap();
            assert!(transform.g(place).unwrap().evaluations <= 4 && (force.evaluations <= 4 || force.value < 1e-300), "{place:e}");
        }
        assert!(matches!(transform.g(1.2 * x), Err(NumError::OutOfDomain { .. })));
    }
    // What no double holds is refused, and what is lost below the smallest one is said.
    let paraboloid = |at: Radii<'_>, out: &mut [f64]| out.copy_from_slice(at.r);
    let mut transform = AbelTransform::new(paraboloid, 1e160, ODD).unwrap();
    assert!(matches!(transform.g(1e160), Err(NumError::OutOfDomain { .. })));
    assert!(matches!(abel_force(&mut blocks(|r, _| r), 1e120, &ODD), Err(NumError::OutOfDomain { .. })));
    for a in [1e-106, 1e-108, 1e-150] {
        let found = best(transform.force(a));
        assert!((found.value - 2.0 * a * a * a / 3.0).abs() <= found.error && found.error > 0.0, "{a:e}: {found:?}");
    }
    // Failures too have an error where the value is lost, and no value that is no number.
    let sharp = AbelOptions { rel_tol: 1e-17, ..ODD };
    assert!(matches!(abel(&mut blocks(|r, _| r), 1e160, &sharp), Err(NumError::OutOfDomain { .. })));
    for found in [abel(&mut blocks(|r, _| r), 1e-165, &sharp), abel_force(&mut blocks(|r, _| r), 1e-115, &sharp)] {
        assert!(matches!(found, Err(NumError::ToleranceNotReached { value: 0.0, error, .. }) if error > 0.0), "{found:?}");
    }
    // An absolute tolerance beyond all values.
    for x in [1e-158, 1e-200, 1e-306] {
        let narrow = move |r: f64, _: f64| (r / x) / (0.01 + (r / x) * (r / x));
        let options = AbelOptions { abs_tol: 1e5, ..ODD };
        let (found, other) = (best(abel_force(&mut blocks(narrow), x, &options)), best(abel(&mut blocks(narrow), x, &options)));
        assert!(found.error < 1e5 && other.error < 1e5, "{x:e}: {found:?} {other:?}");
    }
    assert_eq!(transform.g(0.0).unwrap().value, 0.0);
    for x in [-1.0, f64::NAN] {
        assert!(matches!(transform.g(x), Err(NumError::OutOfDomain { .. })));
        assert!(matches!(AbelTransform::new(paraboloid, x, ODD), Err(NumError::OutOfDomain { .. })));
    }
    assert!(AbelTransform::new(paraboloid, 1.0, AbelOptions { limit: Some(1.0), ..ODD }).is_err());
}

/// Kinks, starts, ends and strips that are told are heeded, and what has no expansion is found as by itself.
#[test]
fn transforms_of_what_is_not_smooth() {
    let bent = |r: f64, _: f64| if r > 0.6 { 0.5 * r + 0.3 } else { 0.5 * r };
    let options = AbelOptions { breakpoints: &[0.6], ..ODD };
    let mut transform = AbelTransform::new(blocks(bent), 2.0, options).unwrap();
    let (x, known): (f64, f64) = (1.7, 0.59);
    let truth = 0.5 * x * x + 0.3 * x * ((x - 0.6) * (x + 0.6)).sqrt().atan2(0.6);
    for _ in 0..2 {
        let (beyond, below) = (transform.g(x).unwrap(), transform.g(known).unwrap());
        assert!((beyond.value - truth).abs() <= beyond.error && (below.value - 0.5 * known * known).abs() <= below.error);
    }
    assert!(transform.g(known).unwrap().evaluations <= 4);
    // A kink that is not told, f′ that is not odd, that is stated to be nothing, and one without a value beyond x.
    let cases: [(Slope, AbelOptions<'_>, f64, f64); 5] = [
        (Box::new(bent), ODD, x, truth),
        (Box::new(|r, _| r * r), ODD, 1.5, 0.25 * PI * 1.5 * 1.5 * 1.5),
        (Box::new(|r, _| r), PLAIN, 1.5, 2.25),
        (Box::new(|r, _| r), AbelOptions { strip: Some(Strip { height: 1.0, largest: 3.0 }), ..ODD }, 1.5, 2.25),
        (Box::new(|r, _| r / ((1.5 - r) * (1.5 + r)).sqrt()), ODD, 1.2, 1.2 * f64::atanh(0.8)),
    ];
    for (index, (slope, options, x, truth)) in cases.into_iter().enumerate() {
        let mut transform = AbelTransform::new(blocks(&slope), 2.0, options).unwrap();
        let (first, second) = (best(transform.g(x)), best(transform.g(x)));
        let alone = best(abel(&mut blocks(&slope), x, &options));
        assert!((second.value - truth).abs() <= second.error + 4e-16 * truth, "{index}: {second:?}, is {truth:e}");
        assert!(second.value == alone.value && second.evaluations == alone.evaluations, "{index}: {second:?}, {alone:?}");
        assert!(first.evaluations >= second.evaluations && first.evaluations <= second.evaluations + 208, "{index}: {first:?}");
    }
    // Nothing is expanded beyond the limit of evaluations, and what was asked in vain counts.
    for most in [0, 12, 79, 80, 150, 250] {
        let options = AbelOptions { max_evaluations: most, ..ODD };
        for slope in [(|r, _| f64::tanh(r)) as fn(f64, f64) -> f64, |r, _| (30.0 * r).sin() + 1e-3 * (r - 0.5).abs()] {
            let asked = std::cell::Cell::new(0);
            let counting = |r: f64, below: f64| {
                asked.set(asked.get() + 1);
                slope(r, below)
            };
            let found = best(AbelTransform::new(blocks(counting), 3.0, options).unwrap().g(3.0));
            assert!(found.evaluations == asked.get() && found.evaluations <= most + 61, "{most}: {found:?}, {}", asked.get());
        }
    }
    // Something narrow at the axis, where no node is: it is seen between the last node and the axis.
    for width in [1e-3f64, 1e-5, 1e-8] {
        let slope = move |r: f64, _: f64| r + 1e-3 * r / (r * r + width * width);
        let mut transform = AbelTransform::new(blocks(slope), 1.0, AbelOptions { rel_tol: 1e-6, ..ODD }).unwrap();
        let z = 1.0 / width;
        let truth = 1.0 + 1e-3 * z.asinh() / (1.0 + width * width).sqrt();
        for _ in 0..2 {
            let found = best(transform.g(1.0));
            assert!((found.value - truth).abs() <= found.error, "{width:e}: {found:?}, is {truth:e}");
        }
    }
}

/// Closures that say how large f′ is in a strip: no more nodes than that takes, and estimates that hold, of g and of F.
#[test]
fn strips_suffice() {
    let mut stream = Stream::new(20_261_122);
    let (mut asked, mut untold) = (0, 0);
    for round in 0..2000 {
        let (x, height) = (log(&mut stream, -3.0, 1.0), log(&mut stream, -1.0, 0.6));
        let tolerance = log(&mut stream, -13.0, -2.0);
        let start = if stream.unit() < 0.7 { Start::Odd } else { Start::Smooth };
        // f′ = sin r: g = (π/2) x H₀(x), Struve's function; f′ = r/(1 + r²): g = x arsinh(x)/√(1 + x²).
        let (slope, largest, truth): (fn(f64, f64) -> f64, f64, f64) = if round % 2 == 0 {
            (|r, _| r.sin(), height.cosh(), 0.5 * PI * x * special::struveh(0.0, x))
        } else {
            let height = height.min(0.9);
            let largest = x.hypot(2.0 * height).max(1.0) / (1.0 - height * height);
            (|r, _| r / (1.0 + r * r), largest, x * x.asinh() / 1f64.hypot(x))
        };
        let height = if round % 2 == 0 { height } else { height.min(0.9) };
        let options = AbelOptions { strip: Some(Strip { height, largest }), start, rel_tol: tolerance, ..PLAIN };
        let found = best(abel(&mut blocks(slope), x, &options));
        let off = (found.value - truth).abs();
        assert!(off <= found.error + 4e-16 * truth.abs(), "{round}: {x} {options:?}, {found:?}, is {truth:e}");
        let plain = best(abel(&mut blocks(slope), x, &AbelOptions { strip: None, ..options }));
        (asked, untold) = (asked + found.evaluations, untold + plain.evaluations);
    }
    assert!(3 * asked < 2 * untold, "{asked} evaluations, {untold} where nothing is told");
    // F of f′ = r: 2a³/3.
    let options = AbelOptions { strip: Some(Strip { height: 1.0, largest: 4.0 }), ..ODD };
    let found = abel_force(&mut blocks(|r, _| r), 3.0, &options).unwrap();
    assert!((found.value - 18.0).abs() <= found.error && found.evaluations < 40, "{found:?}");
    // A strip that is none is not used.
    for strip in
        [Strip { height: 0.0, largest: 1.0 }, Strip { height: f64::NAN, largest: 1.0 }, Strip { height: 1.0, largest: f64::INFINITY }]
    {
        let found = abel(&mut blocks(|r, _| r.tanh()), 3.0, &AbelOptions { strip: Some(strip), ..ODD }).unwrap();
        assert!(found.evaluations == 36, "{strip:?}: {found:?}");
    }
}

/// A force without the cancellation of a g − G: the sphere, (R² + a²)/2 artanh(a/R) − aR/2.
#[test]
fn forces_of_closures() {
    let by_distance = |r: f64, below: f64| r / (below * (2.0 + r)).sqrt();
    let options = AbelOptions { limit: Some(2.0), ..ODD };
    for a in [0.5f64, 1.5, 1.99] {
        let truth = 0.5 * ((4.0 + a * a) * (a / 2.0).atanh() - 2.0 * a);
        let found = abel_force(&mut blocks(by_distance), a, &options).unwrap();
        assert!((found.value - truth).abs() <= found.error + 2e-14 * truth, "{a}: {found:?}, is {truth:e}");
        assert!(found.evaluations <= 40, "{a}: {found:?}");
    }
}
