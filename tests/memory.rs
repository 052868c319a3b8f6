//! A million points stay small; alone in its binary, because the figure is that of the process.
#![allow(clippy::unwrap_used)]

use sneddon::expr::Bindings;
use sneddon::transform::{Evaluator, Method, Profile, Slice, derive};

/// The largest resident memory so far in MB, where the system tells it.
fn peak() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM"))?;
    Some(line.split_whitespace().nth(1)?.parse::<f64>().ok()? / 1024.0)
}

#[test]
fn a_million_points_take_less_than_64_megabytes() {
    const COUNT: usize = 1_000_000;
    let profile = Profile::new(&sneddon::parse::profile("piecewise(r^2/2, r<0.5, r-0.375)").unwrap()).unwrap();
    let solution = derive(&profile).unwrap();
    let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-12).unwrap();
    let x: Vec<f64> = (0..COUNT).map(|i| 0.01 + 1.9 * i as f64 / COUNT as f64).collect();
    let Some(before) = peak() else { return };
    let (mut values, mut errors) = (vec![0.0; COUNT], vec![0.0; COUNT]);
    evaluator.equivalents(&x, Slice::bounded(&mut values, &mut errors)).unwrap();
    let own = peak().unwrap() - before;
    println!("{own:.1} MB beyond the input");
    assert!(own < 64.0, "{own} MB");
    assert!(values.iter().zip(&errors).all(|(value, error)| *error <= 1e-12 * value));
}
