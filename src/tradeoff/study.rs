//! One study: the truth, every ladder, the measurement, the front and the advice.

use super::candidate::Refused;
use super::measure::{Row, Skipped, measure};
use super::methods::METHODS;
use super::{Advice, Problem, TradeoffError, Truth, WANTED, clock, front, truth};
use crate::expr::Bindings;
use crate::transform::{Evaluator, Method};
use std::time::{Duration, Instant};

/// The tolerance of the evaluator that methods start from.
const SHARP: f64 = 1e-14;

/// The options of a study.
#[derive(Clone, Debug)]
pub struct Options {
    /// The time that the measurement may take, by the clock on the wall; a single slow value may run beyond it.
    pub budget: Duration,
    /// Number of batches that each time is the median of, at least 1; errors do not depend on it.
    pub rounds: usize,
    /// The accuracies for which advice is wanted.
    pub wanted: Vec<f64>,
}

/// The results of a study.
pub struct Study<'a> {
    /// The problem.
    pub problem: Problem<'a>,
    /// The reference at every point.
    pub truths: Vec<Truth>,
    /// The clock.
    pub clock: &'static str,
    /// One row per method and setting.
    pub rows: Vec<Row>,
    /// Methods without a result, and the reasons.
    pub skipped: Vec<Skipped>,
    /// Recommendations, one per accuracy.
    pub advice: Vec<Advice>,
}

impl Default for Options {
    /// Ten seconds; 15 batches; accuracies from 1e-3 to 1e-15.
    fn default() -> Self {
        Self { budget: Duration::from_secs(10), rounds: 15, wanted: WANTED.to_vec() }
    }
}

/// Measures every method at its ladder of settings.
///
/// A true error is the largest |value − truth|/|truth| over the points; one that is not 10³ times larger than the error of the
/// truth is given as a bound. Times are medians over rounds of batches, in an order that is shuffled with a fixed seed.
///
/// # Errors
/// [`TradeoffError::NoReference`] if the truth is known nowhere.
///
/// ```
/// use sneddon::{expr::Bindings, parse, tradeoff, transform::{Evaluator, Method, Profile, derive}};
/// let profile = Profile::new(&parse::profile("r^2/4").unwrap()).unwrap();
/// let solution = derive(&profile).unwrap();
/// let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
/// let problem = tradeoff::Problem::new(&solution, &evaluator, tradeoff::Quantity::Force, None, None).unwrap();
/// let options = tradeoff::Options { budget: std::time::Duration::from_secs(1), ..Default::default() };
/// let study = tradeoff::run(problem, &options).unwrap();
/// let closed = study.rows.iter().find(|row| row.method == "closed form" && row.honest.is_some()).unwrap();
/// assert!(closed.error < 5e-16 && closed.honest == Some(true));
/// ```
pub fn run<'a>(problem: Problem<'a>, options: &Options) -> Result<Study<'a>, TradeoffError> {
    on_one_core(move || measured(problem, options))
}

/// Long slices would be divided among the cores, which share more than a clock.
#[cfg(feature = "parallel")]
fn on_one_core<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    match rayon::ThreadPoolBuilder::new().num_threads(1).build() {
        Ok(one) => one.install(work),
        Err(_) => work(),
    }
}

#[cfg(not(feature = "parallel"))]
fn on_one_core<R>(work: impl FnOnce() -> R) -> R {
    work()
}

fn measured<'a>(mut problem: Problem<'a>, options: &Options) -> Result<Study<'a>, TradeoffError> {
    let start = Instant::now();
    let truths = truth::find(&mut problem, start + options.budget / 4)?;
    let evaluator = Evaluator::new(problem.solution, &Bindings::default(), Method::Quadrature, SHARP)?;
    let (mut candidates, mut skipped) = (Vec::new(), Vec::new());
    for method in METHODS {
        match method(&problem, &evaluator) {
            Ok(ladder) => candidates.extend(ladder),
            Err(Refused { method, why }) => skipped.push(Skipped { method, setting: None, why }),
        }
    }
    let left = options.budget.saturating_sub(start.elapsed());
    let (mut rows, dropped) = measure(&problem, &truths, candidates, left, options.rounds);
    skipped.extend(dropped);
    front::mark(&mut rows);
    let advice = options.wanted.iter().map(|wanted| front::advise(&rows, *wanted)).collect();
    Ok(Study { problem, truths, clock: clock::NAME, rows, skipped, advice })
}
