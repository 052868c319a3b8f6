//! The whole curve's times, building included, as lines `work,peer,form,ns per point,largest error,evaluations`.
//!
//! `cargo bench -p sneddon-runs --bench curve`; the shortest of many runs counts, which a busy machine disturbs least.
#![allow(clippy::unwrap_used)]

use sneddon::expr::Bindings;
use sneddon::parse;
use sneddon::transform::{Curve, Evaluator, Method, Profile, derive};
use std::hint::black_box;
use std::time::Instant;

const POINTS: usize = 100_000;

fn shortest(runs: usize, mut work: impl FnMut()) -> f64 {
    let time = |work: &mut dyn FnMut()| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64() * 1e9
    };
    (0..runs).map(|_| time(&mut work)).fold(f64::INFINITY, f64::min)
}

fn main() {
    // A test run of all targets only wants to know that this starts.
    if std::env::args().any(|argument| argument == "--test") {
        return;
    }
    let list = [("ln_cosh", "ln(cosh(r))", 0.01, 3.0), ("ln_cosh_50", "ln(cosh(r))", 3.0, 50.0), ("gaussian", "1-exp(-r^2)", 0.01, 3.0)];
    for (name, text, from, to) in list {
        let solution = derive(&Profile::new(&parse::profile(text).unwrap()).unwrap()).unwrap();
        let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Quadrature, 1e-13).unwrap();
        let profile = evaluator.typed().unwrap();
        let places: Vec<f64> = (0..POINTS).map(|i| from + (to - from) * i as f64 / (POINTS - 1) as f64).collect();
        let mut values = vec![0.0; POINTS];
        let whole = shortest(40, || {
            let curve = Curve::new(profile, to, 1e-12).unwrap();
            curve.equivalent_slice(black_box(&places), &mut values).unwrap();
        });
        let build = shortest(200, || {
            black_box(Curve::new(profile, to, 1e-12).unwrap());
        });
        let curve = Curve::new(profile, to, 1e-12).unwrap();
        let alone = shortest(40, || curve.equivalent_slice(black_box(&places), &mut values).unwrap());
        let pick: Vec<usize> = (0..200).map(|i| i * POINTS / 200 + 250).collect();
        let error = |i: &usize| (values[*i] / evaluator.equivalent(places[*i]).unwrap().estimate.value - 1.0).abs();
        let worst = pick.iter().map(error).fold(0.0, f64::max);
        println!("curve@{name},ours,with building,{:.3},{worst:.1e},{}", whole / POINTS as f64, curve.evaluations());
        println!("curve@{name},ours,evaluation,{:.3},{worst:.1e},0", alone / POINTS as f64);
        println!("curve@{name},ours,building alone,{build:.0},{:.1e},{}", curve.error_bound(), curve.evaluations());
        let radii: Vec<f64> = (0..100).map(|i| to * (f64::from(i) + 0.5) / 100.0).collect();
        let mut worst = 0.0_f64;
        let pressure = shortest(100, || {
            let pressures = curve.pressures(to).unwrap();
            for r in &radii {
                black_box(pressures.at(*r).unwrap());
            }
        });
        let pressures = curve.pressures(to).unwrap();
        for r in radii.iter().step_by(7) {
            let own = pressures.at(*r).unwrap().unwrap();
            let exact = evaluator.pressure(*r, to).unwrap().unwrap().estimate;
            worst = worst.max((own.value / exact.value - 1.0).abs());
        }
        println!("pressure_100@{name},ours,with building,{:.1},{worst:.1e},{}", pressure / 100.0, pressures.evaluations());
    }
}
