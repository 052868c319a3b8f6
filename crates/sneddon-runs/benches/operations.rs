//! Nanoseconds per operation of a tape for every kind of value, to compare with the costs in `sneddon-expr`.

use sneddon::eval::{
    Algebra, BlockInput, BlockScratch, BoundedAlgebra, FloatAlgebra, IntervalAlgebra, PreciseAlgebra, RegionAlgebra, Tape, WideAlgebra,
};
use sneddon::expr::{Formula, Symbol};
use sneddon::num::{Bounded, Precise, Region, Wide};
use sneddon::parse;
use std::hint::black_box;
use std::time::Instant;

/// Expressions with one operation more than the first.
const FORMULAS: [&str; 25] = [
    "r",
    "r+2",
    "r*3",
    "2/r",
    "sqrt(r)",
    "r^7",
    "r^(3/10)",
    "exp(r)",
    "ln(r)",
    "sin(r)",
    "atan(r)",
    "asin(r)",
    "tanh(r)",
    "cosh(r)",
    "asinh(r)",
    "atanh(r)",
    "erf(r)",
    "gamma(r)",
    "besselj(0,r)",
    "besseli(0,r)",
    "struveh(0,r)",
    "dawson(r)",
    "elliprc(1,r)",
    "elliprf(0,1,r)",
    "hyp2f1(1/2,1/3,2,r)",
];
/// Number of arguments in (0, 1).
const PLACES: usize = 64;
/// The fastest of this many measurements counts.
const ROUNDS: usize = 10;
/// Number of runs over all arguments in a measurement.
const RUNS: usize = 50;

fn tape(text: &str) -> Tape {
    let Ok(Formula::Closed(expr)) = parse::formula(text) else { panic!("{text} is no expression") };
    Tape::compile(&[expr], &[Symbol::new("r")]).unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// The nanoseconds of one run, the fastest of several measurements.
fn fastest(mut run: impl FnMut(usize)) -> f64 {
    let measure = |_| {
        let begin = Instant::now();
        (0..RUNS * PLACES).for_each(|index| run(index % PLACES));
        begin.elapsed().as_secs_f64() * 1e9 / (RUNS * PLACES) as f64
    };
    (0..ROUNDS).map(measure).fold(f64::INFINITY, f64::min)
}

fn places() -> impl Iterator<Item = f64> {
    (0..PLACES).map(|index| (index as f64 + 0.37) / PLACES as f64)
}

fn scalar<A: Algebra>(tape: &Tape, mut algebra: A, value: impl Fn(f64) -> A::Value) -> f64 {
    let mut slots = Vec::new();
    let places: Vec<A::Value> = places().map(value).collect();
    fastest(|index| {
        black_box(tape.run(&mut algebra, &places[index..=index], &mut slots));
    })
}

fn main() {
    let titles = ["float", "bounded", "30 digits", "wide", "region", "interval", "block", "bounded block"];
    println!("{:20}{}", "", titles.map(|title| format!("{title:>15}")).concat());
    let values: Vec<f64> = places().collect();
    let (mut out, mut errors, mut scratch) = (vec![0.0; PLACES], vec![0.0; PLACES], BlockScratch::default());
    let mut base = [0.0; 8];
    for text in FORMULAS {
        let tape = tape(text);
        let block = fastest(|_| {
            black_box(tape.run_block(&[&values], &mut out, &mut scratch));
        });
        let input = BlockInput { values: &values, errors: &[] };
        let bounded = fastest(|_| {
            black_box(tape.run_block_bounded(&[input], &mut out, &mut errors, &mut scratch));
        });
        let row = [
            scalar(&tape, FloatAlgebra, |x| x),
            scalar(&tape, BoundedAlgebra, Bounded::exact),
            scalar(&tape, PreciseAlgebra, Precise::exact),
            scalar(&tape, WideAlgebra, |x| Wide::new(Precise::exact(x))),
            scalar(&tape, RegionAlgebra, |x| Region::new((x, 1.01 * x), (-0.01 * x, 0.01 * x))),
            scalar(&tape, IntervalAlgebra, |x| Region::interval(x, 1.01 * x)),
            block / PLACES as f64,
            bounded / PLACES as f64,
        ];
        let more: Vec<String> = row.iter().zip(base).map(|(own, base)| format!("{:15.1}", own - base)).collect();
        println!("{text:20}{}", more.concat());
        if text == "r" {
            base = row;
        }
    }
}
