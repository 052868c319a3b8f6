//! Benchmarks this crate at the points used for other libraries; prints one line
//! `work,who,form,ns per point,relative error,evaluations` per measurement.
//!
//! `benches/peers/run` calls it together with the other libraries; to run it alone, use
//! `cargo run --release -p sneddon-runs --bin beside_peers benches/peers/points.csv`.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stdout)]

mod closures;

use sneddon::expr::{Bindings, Expr, Number};
use sneddon::parse;
use sneddon::transform::{Curve, Evaluator, Method, PressureCurve, Profile, Slice, Solution, derive};
use std::fs;
use std::hint::black_box;

const TOLERANCE: f64 = 1e-12;
/// The contact radius of the pressures.
const RADIUS: f64 = 3.0;
/// Pressures over one contact.
const MANY: usize = 100;

/// One place of `points.csv`.
struct Case {
    work: String,
    profile: String,
    x: f64,
    /// The true value as two doubles.
    truth: (f64, f64),
}

impl Case {
    fn error(&self, found: f64) -> f64 {
        ((found - self.truth.0) - self.truth.1).abs() / self.truth.0.abs()
    }
}

fn main() {
    let file = std::env::args().nth(1).expect("the file of points");
    let text = fs::read_to_string(&file).expect("the file of points");
    let number = |text: &str| text.parse::<f64>().expect("a number");
    let places: Vec<Case> = text
        .lines()
        .skip(1)
        .map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            let [work, profile, x, value, rest] = cells[..] else { panic!("{file}: {line}") };
            Case { work: work.to_owned(), profile: profile.to_owned(), x: number(x), truth: (number(value), number(rest)) }
        })
        .collect();
    for place in &places {
        let solution = solution(&place.profile);
        pointwise(place, &evaluator(&solution, Method::Quadrature));
        if place.work.starts_with(place.profile.as_str()) {
            closures::pointwise(place);
        }
    }
    curve(&places);
    for (work, profile, low, high) in [
        ("closed paraboloid", "paraboloid", 0.01, 3.0),
        ("closed sphere", "sphere", 0.01, 1.99),
        ("closed power", "power", 0.01, 3.0),
        ("closed root", "root", 0.01, 3.0),
        ("closed worn", "worn", 0.61, 3.0),
        ("closed kink", "kink", 0.61, 3.0),
    ] {
        closed(work, profile, low, high);
    }
}

/// The profiles as a user types them, with parameters for their numbers and the values as doubles.
fn typed(profile: &str) -> (&'static str, &'static [(&'static str, f64)]) {
    match profile {
        "paraboloid" => ("r^2/(2*R)", &[("R", 2.0)]),
        "sphere" => ("R-sqrt(R^2-r^2)", &[("R", 2.0)]),
        "power" => ("r^2.7", &[]),
        "worn" => ("piecewise(0, r<b, (r^2-b^2)/(2*R))", &[("b", 0.6), ("R", 2.0)]),
        "cosine" => ("h*(1-cos(k*r))", &[("h", 0.4), ("k", 2.2)]),
        "root" => ("h*sqrt(r)", &[("h", 0.7)]),
        "ln_cosh" => ("ln(cosh(r))", &[]),
        "gaussian" => ("h*(1-exp(-r^2/q))", &[("h", 0.4), ("q", 1.69)]),
        "kink" => ("h*max(0, r-b)", &[("h", 0.3), ("b", 0.6)]),
        other => panic!("no profile {other}"),
    }
}

fn solution(profile: &str) -> Solution {
    let (text, numbers) = typed(profile);
    let exact = |value: f64| Expr::number(Number::from_f64(value).expect("a finite number"));
    let bindings: Bindings = numbers.iter().map(|(name, value)| (*name, exact(*value))).collect();
    let profile = Profile::new(&parse::profile(text).expect("a profile").substitute(&bindings)).expect("a profile");
    derive(&profile).expect("a solution")
}

fn evaluator(solution: &Solution, method: Method) -> Evaluator<'_> {
    Evaluator::new(solution, &Bindings::default(), method, TOLERANCE).expect("numbers")
}

/// One value by quadrature of the profile as typed; many values for pressures.
fn pointwise(place: &Case, evaluator: &Evaluator<'_>) {
    let x = place.x;
    match place.work.split('@').next() {
        Some("force") => typed_call(place, || evaluator.force(x).ok().map(|own| (2.0 * own.estimate.value, own.estimate.evaluations))),
        Some("pressure") => {
            typed_call(place, || evaluator.pressure(x, RADIUS).ok().flatten().map(|own| (own.estimate.value, own.estimate.evaluations)));
            pressures(place, evaluator);
        }
        _ => typed_call(place, || evaluator.equivalent(x).ok().map(|own| (own.estimate.value, own.estimate.evaluations))),
    }
}

fn typed_call(place: &Case, call: impl Fn() -> Option<(f64, u64)>) {
    let Some((value, evaluations)) = call() else { return };
    show(place, "typed", median_ns(&call), value, evaluations);
}

fn show(place: &Case, form: &str, ns: f64, value: f64, evaluations: u64) {
    line(&place.work, form, ns, place.error(value), evaluations);
}

/// The pressure curve of one contact, including the set-up time.
fn pressures(place: &Case, evaluator: &Evaluator<'_>) {
    let typed = evaluator.typed().expect("f′");
    let sum = |from: usize| -> Option<f64> {
        let curve = PressureCurve::new(typed, RADIUS).ok()?;
        let mut total = 0.0;
        for index in from..MANY {
            total += curve.at(RADIUS * (index as f64 + 0.5) / MANY as f64).ok()??.value;
        }
        Some(total)
    };
    let once = || PressureCurve::new(typed, RADIUS).ok()?.at(place.x).ok()?;
    let (Some(_), Some(single)) = (sum(0), once()) else { return };
    line("pressure 100 points", "typed", median_ns(|| sum(0)) / MANY as f64, place.error(single.value), 0);
}

/// The whole curve of ln cosh at 10⁵ points, built beforehand like the plan of the other library.
fn curve(places: &[Case]) {
    const POINTS: usize = 100_000;
    let solution = solution("ln_cosh");
    let evaluator = evaluator(&solution, Method::Quadrature);
    let curve = Curve::new(evaluator.typed().expect("f′"), RADIUS, TOLERANCE).expect("a curve");
    let x: Vec<f64> = (0..POINTS).map(|i| RADIUS * (i as f64 + 0.5) / POINTS as f64).collect();
    let mut g = vec![0.0; POINTS];
    let known = places.iter().filter(|place| place.work.starts_with("ln_cosh@"));
    let error = known.map(|place| place.error(curve.equivalent(place.x).expect("g").value)).fold(0.0, f64::max);
    let ns = median_ns(|| curve.equivalent_slice(black_box(&x), &mut g).is_ok()) / POINTS as f64;
    line("curve", "curve", ns, error, curve.evaluations());
}

/// A closed form over 10⁶ points, without error bounds.
fn closed(work: &str, profile: &str, low: f64, high: f64) {
    const POINTS: usize = 1_000_000;
    let solution = solution(profile);
    let evaluator = evaluator(&solution, Method::Exact);
    let x: Vec<f64> = (0..POINTS).map(|i| low + (high - low) * (i as f64 + 0.5) / POINTS as f64).collect();
    let mut g = vec![0.0; POINTS];
    let mut fill = || evaluator.equivalents(black_box(&x), Slice::values(&mut g)).is_ok();
    if fill() {
        line(work, "slice", median_ns(fill) / POINTS as f64, 0.0, 0);
    }
}

/// Processor time of this process in nanoseconds, over all threads, so that other programs do not count.
#[cfg(unix)]
fn now() -> f64 {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    time.tv_sec as f64 * 1e9 + time.tv_nsec as f64
}

/// Wall-clock time in nanoseconds, on systems without a clock of processor time.
#[cfg(not(unix))]
fn now() -> f64 {
    static START: std::sync::OnceLock<std::time::Instant> = std::sync::OnceLock::new();
    START.get_or_init(std::time::Instant::now).elapsed().as_secs_f64() * 1e9
}

/// The median time of a call over 15 batches of a millisecond, or of one call each if a call takes longer.
fn median_ns<T>(mut call: impl FnMut() -> T) -> f64 {
    const BATCHES: usize = 15;
    let start = now();
    black_box(call());
    black_box(call());
    let once = (0.5 * (now() - start)).max(20.0);
    let repeats = (1e6 / once).max(1.0) as usize;
    let batch = |_| {
        let start = now();
        for _ in 0..repeats {
            black_box(call());
        }
        (now() - start) / repeats as f64
    };
    let mut times: Vec<f64> = (0..BATCHES).map(batch).collect();
    times.sort_by(f64::total_cmp);
    times[BATCHES / 2]
}

fn line(work: &str, form: &str, ns: f64, error: f64, evaluations: u64) {
    println!("{work},ours,{form},{ns:.5},{error:.3e},{evaluations}");
}
