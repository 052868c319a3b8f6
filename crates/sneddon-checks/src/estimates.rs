//! Whether estimates are honest: numbers by quadrature at random tolerances against closed forms.

use crate::formulas::bindings;
use crate::profiles::Sample;
use crate::random::Stream;
use sneddon::parse;
use sneddon::transform::{Evaluator, Method, Profile, Reading, TransformError, derive};

/// The results of all comparisons.
#[derive(Clone, Debug, Default)]
pub struct Honesty {
    /// Numbers whose true value is known ten times as well as they claim to know it.
    pub numbers: usize,
    /// Numbers whose estimate is within the requested tolerance.
    pub met: usize,
    /// Typed refusals, and numbers that closed forms cannot judge.
    pub refused: usize,
    pub undecided: usize,
    /// The largest ratio of the true error to its estimate.
    pub largest: f64,
    /// Numbers whose error exceeds their estimate.
    pub faults: Vec<String>,
}

impl Honesty {
    pub fn add(&mut self, other: Self) {
        self.numbers += other.numbers;
        self.met += other.met;
        self.refused += other.refused;
        self.undecided += other.undecided;
        self.largest = self.largest.max(other.largest);
        self.faults.extend(other.faults);
    }
}

/// A random quantity of the profile at a random point, with a random tolerance.
pub fn examine(sample: &Sample, stream: &mut Stream) -> Honesty {
    let mut found = Honesty::default();
    let Ok(formula) = parse::profile(&sample.text) else { return found };
    let set = formula.substitute(&bindings(&sample.values));
    let Ok(solution) = Profile::new(&set).and_then(|profile| derive(&profile)) else { return found };
    let Ok(exact) = Evaluator::new(&solution, &bindings(&[]), Method::Exact, 1e-15) else { return found };
    for _ in 0..4 {
        let tolerance = 10f64.powf(-2.0 - 12.0 * stream.unit());
        let Ok(own) = Evaluator::new(&solution, &bindings(&[]), Method::Quadrature, tolerance) else { continue };
        one(sample, &exact, &own, tolerance, stream, &mut found);
    }
    found
}

fn one(sample: &Sample, exact: &Evaluator<'_>, own: &Evaluator<'_>, tolerance: f64, stream: &mut Stream, found: &mut Honesty) {
    let end = own.limit().min(4.0);
    let a = place(end, &own.breakpoints_below(end), stream);
    let r = a * stream.unit();
    let quantity = *stream.pick(&["g", "g", "F", "p", "u", "G", "f"]);
    let read = |from: &Evaluator<'_>| -> Result<Option<Reading>, TransformError> {
        match quantity {
            "g" => from.equivalent(a).map(Some),
            "F" => from.force(a).map(Some),
            "G" => from.integral(a).map(Some),
            "f" => from.height(a).map(Some),
            "u" => from.displacement(a, r).map(Some),
            _ => from.pressure(r, a),
        }
    };
    // Only what is closed as a whole is known.
    let Ok(Some(truth)) = read(exact) else { return };
    let reading = match read(own) {
        Ok(Some(reading)) => reading,
        Ok(None) => return,
        Err(_) => {
            found.refused += 1;
            return;
        }
    };
    let (claimed, known) = (reading.estimate.error, truth.estimate.error);
    let difference = (reading.estimate.value - truth.estimate.value).abs();
    if difference > claimed + known || claimed.is_nan() || reading.estimate.value.is_nan() {
        let (own, other) = (reading.estimate, truth.estimate);
        let over = difference / claimed;
        found.faults.push(format!(
            "{sample:?}: {quantity} at a = {a:e}, r = {r:e}, tolerance {tolerance:.1e}: {own:?} against {other:?}, off by {over:.2} estimates"
        ));
    }
    if known <= 0.1 * claimed || difference == 0.0 {
        found.numbers += 1;
        found.met += usize::from(claimed <= tolerance * reading.estimate.value.abs());
        if claimed > 0.0 {
            found.largest = found.largest.max((difference - known) / claimed);
        }
    } else {
        found.undecided += 1;
    }
}

/// A radius: an ordinary one, a tiny one, one just beyond a breakpoint, or one next to the end.
fn place(end: f64, breakpoints: &[f64], stream: &mut Stream) -> f64 {
    match stream.whole(0, 9) {
        0 => stream.log_uniform(1e-8, 1e-2) * end,
        1 => end * (1.0 - stream.log_uniform(1e-12, 1e-2)),
        2 if !breakpoints.is_empty() => (stream.pick(breakpoints) * (1.0 + stream.log_uniform(1e-12, 1e-2))).min(0.999 * end),
        _ => stream.short(0.02, 0.98 * end),
    }
}
