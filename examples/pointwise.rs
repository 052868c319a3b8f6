//! CPU time, true error and evaluations of pointwise quadrature at the points that the peers were measured at.
//!
//! `cargo run --release --example pointwise [FILE of points]`: one line per point and way, comma separated.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stdout)]

use sneddon::expr::Bindings;
use sneddon::num::quadrature::{AbelOptions, Radii, Start, abel};
use sneddon::num::{Estimate, NumError};
use sneddon::parse;
use sneddon::transform::{Evaluator, Method, Profile, derive};
use std::hint::black_box;
use std::time::Instant;

/// Name, profile, x, kink, and the value as two doubles.
struct Place {
    id: String,
    profile: usize,
    x: f64,
    kink: f64,
    truth: (f64, f64),
}

const TYPED: [&str; 8] = [
    "2-sqrt(4-r^2)",
    "r^2.7",
    "max(0,r^2-0.36)/4",
    "0.4*(1-cos(2.2*r))",
    "0.7*sqrt(r)",
    "ln(cosh(r))",
    "0.4*(1-exp(-r^2/1.69))",
    "0.3*max(0,r-0.6)",
];

/// Nanoseconds: the smallest of many short batches, which others on the machine do not interrupt.
fn time(mut once: impl FnMut()) -> f64 {
    let start = Instant::now();
    for _ in 0..20 {
        once();
    }
    let repeat = ((2e5 * 20.0 / start.elapsed().as_nanos() as f64) as usize).clamp(1, 100_000);
    let batch = |_| {
        let start = Instant::now();
        for _ in 0..repeat {
            once();
        }
        start.elapsed().as_nanos() as f64 / repeat as f64
    };
    (0..60).map(batch).fold(f64::INFINITY, f64::min)
}

fn show(place: &Place, way: &str, found: Result<Estimate, NumError>, ns: f64) {
    let (found, word) = match found {
        Ok(found) => (found, "ok"),
        Err(NumError::ToleranceNotReached { value, error, evaluations, .. } | NumError::EvaluationLimit { value, error, evaluations }) => {
            (Estimate { value, error, evaluations }, "best")
        }
        Err(error) => {
            println!("{},{way},{error}", place.id);
            return;
        }
    };
    let off = ((found.value - place.truth.0) - place.truth.1).abs();
    let size = place.truth.0.abs();
    let honest = if off <= found.error { 'H' } else { 'D' };
    println!("{},{way},{:.1e},{:.1e},{},{ns:.1},{honest},{word}", place.id, off / size, found.error / size, found.evaluations);
}

/// The closure of a profile, and what is known of it.
fn closures(place: &Place) -> Vec<(&'static str, AbelOptions<'static>)> {
    let plain = AbelOptions::default();
    let odd = AbelOptions { start: Start::Odd, ..plain };
    match place.profile {
        1 => vec![("limit", AbelOptions { limit: Some(2.0), ..odd }), ("odd", odd), ("plain", plain)],
        2 | 5 => vec![("algebraic", AbelOptions { start: Start::Algebraic, ..plain }), ("plain", plain)],
        3 => vec![("told", AbelOptions { from: 0.6, ..odd }), ("plain told", AbelOptions { from: 0.6, ..plain }), ("untold", plain)],
        8 => vec![("told", AbelOptions { from: 0.6, ..plain }), ("untold", plain)],
        _ => vec![("odd", odd), ("plain", plain)],
    }
}

fn main() {
    let file = std::env::args().nth(1).unwrap_or_else(|| "benches/peers/points.txt".to_owned());
    let text = std::fs::read_to_string(&file).expect("the file of points");
    println!("point,way,relative error,estimate,evaluations,ns,honest,status");
    for line in text.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        let [id, profile, x, kink, high, low] = words[..] else { continue };
        let number = |text: &str| text.parse::<f64>().unwrap();
        let place = Place {
            id: id.to_owned(),
            profile: profile.parse().unwrap(),
            x: number(x),
            kink: number(kink),
            truth: (number(high), number(low)),
        };
        let _ = place.kink;
        macro_rules! run {
            ($f:expr) => {
                for (way, options) in closures(&place) {
                    let mut slope = |at: Radii<'_>, out: &mut [f64]| {
                        for ((o, r), below) in out.iter_mut().zip(at.r).zip(at.below_limit) {
                            *o = $f(*r, *below);
                        }
                    };
                    let found = abel(&mut slope, place.x, &options);
                    let ns = time(|| {
                        let _ = black_box(abel(&mut slope, black_box(place.x), &options));
                    });
                    show(&place, way, found, ns);
                }
            };
        }
        match place.profile {
            1 => {
                for (way, options) in closures(&place) {
                    let limit = options.limit.is_some();
                    let mut slope = |at: Radii<'_>, out: &mut [f64]| {
                        if limit {
                            for ((o, r), below) in out.iter_mut().zip(at.r).zip(at.below_limit) {
                                *o = r / (below * (2.0 + r)).sqrt();
                            }
                        } else {
                            for (o, r) in out.iter_mut().zip(at.r) {
                                *o = r / ((2.0 - r) * (2.0 + r)).sqrt();
                            }
                        }
                    };
                    let found = abel(&mut slope, place.x, &options);
                    let ns = time(|| {
                        let _ = black_box(abel(&mut slope, black_box(place.x), &options));
                    });
                    show(&place, way, found, ns);
                }
            }
            2 => run!(|r: f64, _: f64| 2.7 * r.powf(1.7)),
            3 => run!(|r: f64, _: f64| if r > 0.6 { r / 2.0 } else { 0.0 }),
            4 => run!(|r: f64, _: f64| 0.88 * (2.2 * r).sin()),
            5 => run!(|r: f64, _: f64| 0.35 / r.sqrt()),
            6 => run!(|r: f64, _: f64| r.tanh()),
            7 => run!(|r: f64, _: f64| 0.4 * 2.0 * r / 1.69 * (-r * r / 1.69).exp()),
            _ => run!(|r: f64, _: f64| if r > 0.6 { 0.3 } else { 0.0 }),
        }
        let solution = derive(&Profile::new(&parse::profile(TYPED[place.profile - 1]).unwrap()).unwrap()).unwrap();
        let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Quadrature, 1e-12).unwrap();
        let numeric = evaluator.typed().unwrap();
        let as_estimate = |found: Result<Estimate, _>| found.map_err(|_| NumError::NotFinite { at: place.x });
        let found = as_estimate(numeric.slope(place.x, 1e-12));
        let ns = time(|| {
            let _ = black_box(numeric.slope(black_box(place.x), 1e-12));
        });
        show(&place, "typed", found, ns);
    }
}
