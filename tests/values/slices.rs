//! Closed forms over slices: the numbers of the scalar way, whatever the order of the points and the number of threads.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

use sneddon::expr::Bindings;
use sneddon::num::work;
use sneddon::parse;
use sneddon::transform::{Evaluator, Method, Origin, Profile, Reading, Slice, Solution, Superposed, TransformError, derive};
use sneddon_checks::random::Stream;
use sneddon_checks::seeds::cases;
use std::sync::atomic::AtomicBool;

/// Whole, kinked, worn, capped, cancelling, half open, and with an end.
const PROFILES: &[&str] = &[
    "r^2/4",
    "r^2.7",
    "0.7*sqrt(r)",
    "2-sqrt(4-r^2)",
    "piecewise(0, r<0.6, (r^2-0.36)/4)",
    "piecewise(0, r<0.6, 0.3*(r-0.6))",
    "piecewise(r^2/2, r<0.5, r-0.375)",
    "piecewise(r, r<0.5, r^2+0.25, r<1.25, 3*r-1.9375)",
    "0.4*(1-cos(2.2*r))",
    "ln(cosh(r))",
    "r-atan(r)",
    "exp(-r^2)-1+r^3",
    "abs(r-0.7)+r^2",
];

fn solution(text: &str) -> Solution {
    derive(&Profile::new(&parse::profile(text).unwrap()).unwrap()).unwrap()
}

fn evaluator(solution: &Solution, tolerance: f64) -> Evaluator<'_> {
    Evaluator::new(solution, &Bindings::default(), Method::Auto, tolerance).unwrap()
}

fn points(stream: &mut Stream, count: usize) -> Vec<f64> {
    let near = |stream: &mut Stream| *stream.pick(&[0.5, 0.6, 0.7, 1.25]) * (1.0 + stream.log_uniform(1e-12, 1e-3));
    (0..count).map(|_| if stream.whole(0, 5) == 0 { near(stream) } else { stream.uniform(1e-6, 1.99) }).collect()
}

fn agrees(text: &str, at: f64, value: f64, error: f64, scalar: Reading) {
    let own = scalar.estimate;
    // Where one bound is just good enough and the other is not, only one value has taken the second pass.
    assert!(value == own.value || (value - own.value).abs() <= error + own.error, "{text} at {at}: {value} and {own:?}");
    let floor = 8.0 * f64::EPSILON * value.abs();
    assert!(error <= own.error.max(floor) && own.error <= error.max(floor), "{text} at {at}: {error} and {own:?}");
}

#[test]
fn slices_have_the_numbers_of_the_scalar_way() {
    let mut stream = Stream::new(44);
    let (mut same, mut all) = (0, 0);
    for text in PROFILES {
        let solution = solution(text);
        let evaluator = evaluator(&solution, 1e-13);
        let count = if text.contains("ln") { 20 } else { cases(250, 2500) };
        let x = points(&mut stream, count);
        let (mut values, mut errors) = (vec![0.0; count], vec![0.0; count]);
        let mut check = |values: &[f64], errors: &[f64], scalar: &dyn Fn(f64) -> Reading| {
            for place in (0..count).step_by(3) {
                let reading = scalar(x[place]);
                agrees(text, x[place], values[place], errors[place], reading);
                same += usize::from(values[place] == reading.estimate.value);
                all += 1;
            }
        };
        evaluator.equivalents(&x, Slice::bounded(&mut values, &mut errors)).unwrap();
        check(&values, &errors, &|x| evaluator.equivalent(x).unwrap());
        evaluator.forces(&x, Slice::bounded(&mut values, &mut errors)).unwrap();
        check(&values, &errors, &|a| evaluator.force(a).unwrap());
        evaluator.heights(&x, Slice::bounded(&mut values, &mut errors)).unwrap();
        check(&values, &errors, &|r| evaluator.height(r).unwrap());
        if count > 20 {
            let r: Vec<f64> = x.iter().take(cases(40, 200)).copied().collect();
            evaluator.pressures(&r, 1.995, Slice::bounded(&mut values[..r.len()], &mut errors[..r.len()])).unwrap();
            for place in (0..r.len()).step_by(5) {
                agrees(text, r[place], values[place], errors[place], evaluator.pressure(r[place], 1.995).unwrap().unwrap());
            }
        }
    }
    println!("{same} of {all} values are the same bit for bit");
    // Elsewhere one bound is just good enough and the other is not, and only one value has taken the second pass.
    assert!(f64::from(same as u32) > 0.98 * f64::from(all));
}

#[test]
#[cfg(feature = "parallel")]
fn the_number_of_threads_changes_nothing() {
    let solution = solution("piecewise(r, r<0.5, r^2+0.25, r<1.25, 3*r-1.9375)");
    let evaluator = evaluator(&solution, 1e-13);
    let count = cases(40_000, 100_000);
    let x = points(&mut Stream::new(45), count);
    let run = |threads: usize| {
        let (mut values, mut errors) = (vec![0.0; x.len()], vec![0.0; x.len()]);
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| evaluator.equivalents(&x, Slice::bounded(&mut values, &mut errors))).unwrap();
        (values, errors)
    };
    assert!(run(1) == run(3));
    // The first error by place, too.
    let mut far = x.clone();
    (far[7 * count / 10], far[9 * count / 10]) = (f64::INFINITY, f64::NAN);
    let mut values = vec![0.0; far.len()];
    for _ in 0..4 {
        let error = evaluator.equivalents(&far, Slice::values(&mut values)).unwrap_err();
        assert!(!format!("{error}").contains("NaN"), "{error}");
    }
}

/// Pressures that are dense in part, sparse in part, and 0 where r > a.
#[test]
#[cfg(feature = "parallel")]
fn polynomials_are_the_same_on_any_number_of_threads() {
    let solution = solution("2-sqrt(4-r^2)");
    let mut stream = Stream::new(48);
    let mut r: Vec<f64> = (0..100_000).map(|_| stream.uniform(1.5, 1.55)).collect();
    r.iter_mut().step_by(2000).for_each(|r| *r = stream.uniform(0.01, 1.9));
    (r[123], r[50_123]) = (1.96, 0.0);
    let run = |threads: usize| {
        // What is found depends on no other slice either.
        let evaluator = evaluator(&solution, 1e-15);
        let mut values = vec![0.0; r.len()];
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| evaluator.pressures(&r, 1.95, Slice::values(&mut values))).unwrap();
        values
    };
    let (one, three) = (run(1), run(3));
    assert!(one.iter().zip(&three).all(|(one, three)| one.to_bits() == three.to_bits()));
    assert!(one[123] == 0.0);
}

#[test]
fn what_cannot_be_answered_is_an_error() {
    let sphere = solution("2-sqrt(4-r^2)");
    let evaluator = evaluator(&sphere, 1e-13);
    let mut values = [0.0; 3];
    let short = evaluator.equivalents(&[1.0, 1.5], Slice::values(&mut values));
    assert!(matches!(short, Err(TransformError::Buffer { points: 2, buffer: 3 })));
    let outside = evaluator.equivalents(&[1.0, 2.5, 1.5], Slice::values(&mut values));
    assert!(matches!(outside, Err(TransformError::OutOfDomain { at: 2.5, .. })), "{outside:?}");
    evaluator.equivalents(&[], Slice::values(&mut [])).unwrap();
    let cone = solution("r");
    let (mut values, mut errors, mut origins) = ([0.0; 2], [0.0; 2], [Origin::CLOSED; 2]);
    let out = Slice { origins: Some(&mut origins), ..Slice::bounded(&mut values, &mut errors) };
    self::evaluator(&cone, 1e-13).pressures(&[0.0, 0.5], 1.0, out).unwrap();
    assert_eq!((values[0], errors[0], origins.map(|own| own.method)), (f64::INFINITY, f64::INFINITY, ["infinite", "exact"]));
}

/// The second pass is taken for digits that are wanted, and a looser tolerance never costs more evaluations.
#[test]
fn a_loose_tolerance_is_not_dearer_than_a_sharp_one() {
    let cancelling = solution("r-atan(r)");
    let at = |tolerance: f64| evaluator(&cancelling, tolerance).force(0.05).unwrap();
    let (sharp, loose) = (at(1e-13), at(1e-6));
    assert!(sharp.estimate.relative_error() < 2e-16 && sharp.method == "exact");
    // The bound of the first pass, which meets the tolerance, and no evaluation of f′.
    assert!(loose.estimate.relative_error() > 1e-15 && loose.estimate.relative_error() <= 1e-6, "{loose:?}");
    assert!(loose.method == "exact" && loose.estimate.evaluations == 0);
    for text in PROFILES.iter() {
        let solution = solution(text);
        let mut before = 0;
        for tolerance in [1e-3, 1e-6, 1e-9, 1e-11, 1e-12, 1e-13] {
            let evaluator = evaluator(&solution, tolerance);
            let readings = [0.3, 0.9, 1.7].map(|x| [evaluator.equivalent(x).unwrap(), evaluator.force(x).unwrap()]);
            let own: u64 = readings.as_flattened().iter().map(|reading| reading.estimate.evaluations).sum();
            assert!(own >= before, "{text}: {own} evaluations at {tolerance:e}, {before} at a looser one");
            before = own;
        }
    }
}

/// Where many points lie close together values alone have every digit, also where the form in doubles loses some; but for the places
/// next to a kink, an end, the edge of the contact or a change of sign, where that form stays.
#[test]
fn dense_slices_have_every_digit() {
    let (mut all, mut missed, mut worst) = (0, 0, 0.0f64);
    for text in [
        "r^2.7",
        "2-sqrt(4-r^2)",
        "piecewise(0, r<0.6, 0.3*(r-0.6))",
        "piecewise(r, r<0.5, r^2+0.25, r<1.25, 3*r-1.9375)",
        "0.4*(1-cos(2.2*r))",
        "exp(-r^2)-1+r^3",
        "abs(r-1.7)+r^2",
        "1-exp(-r^2)",
        "sin(3*r)^2",
        "r^2*exp(-r)",
        "1-besselj(0,r)",
    ] {
        let solution = solution(text);
        let evaluator = evaluator(&solution, 1e-13);
        let mut stream = Stream::new(46);
        let points: Vec<f64> = (0..150_000).map(|_| stream.uniform(0.9, 1.99)).collect();
        let mut values = vec![0.0; points.len()];
        let mut check = |quantity: Superposed, values: &[f64], radius: Option<f64>| {
            let largest = values.iter().fold(0.0, |most: f64, own| most.max(own.abs()));
            for place in (0..points.len()).step_by(241) {
                let inputs: Vec<f64> = std::iter::once(points[place]).chain(radius).collect();
                let Some(truth) = evaluator.with_30_digits(quantity, &inputs).unwrap().filter(|own| own.error < 1e-20 * own.value.hi.abs())
                else {
                    continue;
                };
                let unit = f64::from_bits(truth.value.hi.abs().to_bits() + 1) - truth.value.hi.abs();
                let off = ((values[place] - truth.value.hi) - truth.value.lo).abs() / unit;
                all += 1;
                missed += usize::from(off > 0.8);
                // Elsewhere, the form in doubles: close to a kink, to the end, or where the value vanishes.
                let share = off * unit / largest;
                worst = worst.max(share);
                assert!(share < 1e-15, "{text} {quantity:?} at {inputs:?}: {share:e}");
            }
        };
        evaluator.equivalents(&points, Slice::values(&mut values)).unwrap();
        check(Superposed::Equivalent, &values, None);
        evaluator.forces(&points, Slice::values(&mut values)).unwrap();
        check(Superposed::Force, &values, None);
        if evaluator.pressures(&points[..1], 1.995, Slice::values(&mut values[..1])).is_ok()
            && evaluator.with_30_digits(Superposed::Pressure, &[1.0, 1.995]).unwrap().is_some()
        {
            evaluator.pressures(&points, 1.995, Slice::values(&mut values)).unwrap();
            check(Superposed::Pressure, &values, Some(1.995));
        }
    }
    println!("{missed} of {all} values are off by more than 0.8 units, the worst by {worst:e} of the largest");
    // Next to the end, the edge and the changes of sign no part has enough points.
    assert!(all > 10_000 && missed * 17 < all);
}

#[test]
fn a_dense_slice_does_not_remember_those_before_it() {
    let solution = solution("1-exp(-r^2)");
    let (fresh, used) = (evaluator(&solution, 1e-13), evaluator(&solution, 1e-13));
    let mut stream = Stream::new(47);
    let dense: Vec<f64> = (0..4000).map(|_| stream.uniform(0.9, 1.3)).collect();
    let mixed: Vec<f64> = (0..4000).map(|i| if i < 500 { stream.uniform(1.0, 1.03) } else { stream.log_uniform(1e-300, 1e300) }).collect();
    let (mut values, mut others) = (vec![0.0; 4000], vec![0.0; 4000]);
    used.equivalents(&dense, Slice::values(&mut values)).unwrap();
    used.equivalents(&mixed, Slice::values(&mut values)).unwrap();
    fresh.equivalents(&mixed, Slice::values(&mut others)).unwrap();
    assert!(values.iter().zip(&others).all(|(one, other)| one.to_bits() == other.to_bits()));
    // What is sparse is the form in doubles, bit for bit that of a slice of one point.
    for place in (500..4000).step_by(50) {
        let mut alone = [0.0];
        fresh.equivalents(&mixed[place..place + 1], Slice::values(&mut alone)).unwrap();
        assert_eq!(alone[0], others[place], "{}", mixed[place]);
    }
}

/// Class "Ctrl-C is ignored": a stop ends a slice on every thread, and what was cut short is not kept.
#[test]
fn a_stop_ends_slices_and_leaves_nothing_behind() {
    static STOP: AtomicBool = AtomicBool::new(true);
    for text in ["besselj(0,r)^2*r", "r^2/besselj(0,r)", "r^2*tanh(r)/(1+r^3)", "1/besselj(0,r)-1"] {
        let solution = solution(text);
        let (stopped, fresh) = (evaluator(&solution, 1e-12), evaluator(&solution, 1e-12));
        let x: Vec<f64> = (1..=40_000).map(|i| 2e-5 * f64::from(i)).collect();
        let mut values = vec![0.0; x.len()];
        let ended = work::stoppable(&STOP, || stopped.equivalents(&x, Slice::values(&mut values)));
        assert!(ended.is_err_and(|error| error.to_string().contains("budget")), "{text}");
        assert_eq!(work::stoppable(&STOP, || stopped.limit()), fresh.limit(), "{text}");
        let last = |own: &Evaluator<'_>| own.equivalent(0.8).map(|own| own.estimate);
        assert_eq!(last(&stopped), last(&fresh), "{text}");
    }
}
