//! What the programs of this package share: places, the clock, and the line that each measurement becomes.

use std::fs;
use std::hint::black_box;

/// One place of `points.csv`.
pub struct Place {
    /// The work, `profile@x`.
    pub work: String,
    /// The profile's name.
    pub profile: String,
    /// The place.
    pub x: f64,
    /// The true value as two doubles.
    pub truth: (f64, f64),
}

/// The places, in the order of the file.
pub fn places(file: &str) -> Vec<Place> {
    let text = fs::read_to_string(file).unwrap_or_else(|error| panic!("{file}: {error}"));
    let number = |text: &str| text.parse::<f64>().expect("a number");
    let rows = text.lines().skip(1).map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        let [work, profile, x, value, rest] = cells[..] else { panic!("{file}: {line}") };
        Place { work: work.to_owned(), profile: profile.to_owned(), x: number(x), truth: (number(value), number(rest)) }
    });
    rows.collect()
}

impl Place {
    /// |found − truth|/|truth|.
    pub fn error(&self, found: f64) -> f64 {
        ((found - self.truth.0) - self.truth.1).abs() / self.truth.0.abs()
    }

    /// Where f′ jumps or bends.
    pub fn kink(&self) -> Option<f64> {
        matches!(self.profile.as_str(), "worn" | "kink").then_some(0.6)
    }
}

/// f′ of a profile.
pub fn slope(profile: &str) -> fn(f64) -> f64 {
    match profile {
        "sphere" => |r| r / ((2.0 - r) * (2.0 + r)).sqrt(),
        "power" => |r| 2.7 * r.powf(1.7),
        "worn" => |r| if r > 0.6 { 0.5 * r } else { 0.0 },
        "cosine" => |r| 0.88 * (2.2 * r).sin(),
        "root" => |r| 0.35 / r.sqrt(),
        "ln_cosh" => f64::tanh,
        "gaussian" => |r| 0.8 * r / 1.69 * (-r * r / 1.69).exp(),
        "kink" => |r| if r > 0.6 { 0.3 } else { 0.0 },
        other => panic!("no profile {other}"),
    }
}

/// Nanoseconds of processor time of this process, so that other programs on the machine do not count.
fn now() -> f64 {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    time.tv_sec as f64 * 1e9 + time.tv_nsec as f64
}

/// Batches, and the nanoseconds that one of them should last.
const BATCHES: usize = 15;
const BATCH: f64 = 1e6;

/// The median time of a call over the batches.
pub fn median_ns<T>(mut call: impl FnMut() -> T) -> f64 {
    let start = now();
    for _ in 0..8 {
        black_box(call());
    }
    // A call of no time at all is one of 20 ns.
    let once = ((now() - start) / 8.0).max(20.0);
    let repeats = (BATCH / once).max(1.0) as usize;
    let mut times: Vec<f64> = (0..BATCHES)
        .map(|_| {
            let start = now();
            for _ in 0..repeats {
                black_box(call());
            }
            (now() - start) / repeats as f64
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[BATCHES / 2]
}

/// One measurement.
pub fn line(work: &str, who: &str, form: &str, ns: f64, error: f64, evaluations: u64) {
    println!("{work},{who},{form},{ns:.5},{error:.3e},{evaluations}");
}
