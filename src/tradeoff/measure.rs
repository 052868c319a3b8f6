//! The measurement: true errors first, then times in batches whose order is shuffled from round to round.

use super::candidate::{Candidate, Run};
use super::problem::{Problem, SEED};
use super::{Truth, clock};
use crate::num::Estimate;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// The measurement of one method at one setting.
#[derive(Clone, Debug)]
pub struct Row {
    /// The method.
    pub method: &'static str,
    /// The step of its ladder.
    pub setting: String,
    /// The largest true relative error over the points, or the reference's resolution where that is larger.
    pub error: f64,
    /// True if `error` is the reference's resolution: the true error is at most that.
    pub at_most: bool,
    /// The median of the true relative errors.
    pub median_error: f64,
    /// The largest relative error that the method itself stated; `None` if it states none.
    pub claimed: Option<f64>,
    /// Whether no stated error was below the true one; `None` if none is stated.
    pub honest: Option<bool>,
    /// Time for one point, without the set-up.
    pub time: Time,
    /// Nanoseconds from the profile to the first value: the median of up to three runs.
    pub set_up: f64,
    /// Evaluations of f′ per point, or springs.
    pub evaluations: f64,
    /// True on the Pareto front: nothing else is both as accurate and faster.
    pub front: bool,
}

/// Nanoseconds per point over the rounds.
#[derive(Clone, Copy, Debug)]
pub struct Time {
    /// The median round.
    pub median: f64,
    /// A quarter of the rounds took less.
    pub low: f64,
    /// A quarter of the rounds took more.
    pub high: f64,
}

/// The reason of what was not measured because the time was used up.
const NO_TIME: &str = "no time was left";

/// A method or a step of its ladder without a result.
#[derive(Clone, Debug)]
pub struct Skipped {
    /// The method.
    pub method: &'static str,
    /// The step, or nothing for the whole ladder.
    pub setting: Option<String>,
    /// The reason.
    pub why: String,
}

impl Skipped {
    /// Returns true for what was not measured because the time was used up.
    pub fn is_cut(&self) -> bool {
        self.why == NO_TIME
    }
}

/// The target duration of one batch in nanoseconds.
const BATCH: f64 = 1e6;
/// Times that a set-up is run, and rounds that every candidate takes.
const AT_LEAST: usize = 3;
/// Nanoseconds after which a set-up or a batch is not repeated further: a long measurement varies little.
const ENOUGH: f64 = 5e7;
/// Points of a slice; those of the problem are repeated to fill it.
const SLICE: usize = 131_072;

/// A candidate whose errors are known, and its times so far.
struct Measured<'a> {
    candidate: Candidate<'a>,
    row: Row,
    slice: Vec<f64>,
    passes: usize,
    times: Vec<f64>,
    /// Nanoseconds of all batches.
    spent: f64,
}

/// Errors and times of every candidate; failed candidates and candidates without remaining time are listed separately.
pub(super) fn measure<'a>(
    problem: &Problem<'_>,
    truths: &[Truth],
    candidates: Vec<Candidate<'a>>,
    budget: Duration,
    rounds: usize,
) -> (Vec<Row>, Vec<Skipped>) {
    let start = Instant::now();
    // Errors and set-ups may take half of the time, rounds the rest.
    let half = start + budget / 2;
    let (mut measured, mut skipped) = (Vec::new(), Vec::new());
    for mut candidate in candidates {
        let outcome = if Instant::now() > half { Err(NO_TIME.to_owned()) } else { errors(problem, truths, &mut candidate, half) };
        match outcome {
            Ok(row) => measured.push(Measured::new(problem, candidate, row)),
            Err(why) => skipped.push(Skipped { method: candidate.method, setting: Some(candidate.setting), why }),
        }
    }
    let mut order: Vec<usize> = (0..measured.len()).collect();
    let mut state = SEED;
    for round in 0..rounds.max(1) {
        shuffle(&mut order, &mut state);
        for index in &order {
            // One round is the least that a time can rest on.
            if round > 0 && start.elapsed() > budget {
                break;
            }
            if let Some(own) = measured.get_mut(*index)
                && (round < AT_LEAST || own.spent < ENOUGH)
            {
                own.batch(problem);
            }
        }
    }
    (measured.into_iter().map(Measured::finish).collect(), skipped)
}

/// One pass over the points: the values against the truth.
fn errors(problem: &Problem<'_>, truths: &[Truth], candidate: &mut Candidate<'_>, deadline: Instant) -> Result<Row, String> {
    let (mut found, mut made) = (Vec::new(), 0.0_f64);
    match &mut candidate.run {
        Run::Point(run) => {
            for (index, at) in problem.points.iter().enumerate() {
                let why = |why: String| format!("at {} = {at:?}: {why}", problem.quantity.coordinate());
                if Instant::now() > deadline {
                    return Err(NO_TIME.to_owned());
                }
                found.push(run(index, *at).map_err(why)?);
            }
        }
        Run::Slice(run) => {
            // The slice whose time is measured: a short one may go another way.
            let points = slice(problem);
            let mut values = vec![f64::NAN; points.len()];
            let mut pass = || {
                let before = clock::now();
                run(&points, &mut values).map(|()| clock::now() - before)
            };
            // What the first slice makes for those after it.
            made = pass()? - pass()?;
            values.truncate(problem.points.len());
            found.extend(values.into_iter().map(|value| Estimate::estimated(value, f64::INFINITY, 0)));
        }
    }
    if found.iter().any(|own| !own.value.is_finite()) {
        return Err("a value is not finite".to_owned());
    }
    let (mut largest, mut at_most, mut all) = (0.0, false, Vec::new());
    let (mut claimed, mut honest) = (0.0_f64, true);
    for (own, truth) in found.iter().zip(truths) {
        let size = truth.value.value.hi.abs();
        let (error, resolution) = (truth.distance(own.value) / size, truth.resolution());
        all.push(error.max(resolution));
        if error.max(resolution) > largest {
            (largest, at_most) = (error.max(resolution), error < resolution);
        }
        claimed = claimed.max(own.error / size);
        honest &= truth.distance(own.value) <= own.error + truth.value.error;
    }
    all.sort_by(f64::total_cmp);
    let mut set_ups: Vec<f64> = Vec::new();
    while set_ups.len() < AT_LEAST && set_ups.iter().sum::<f64>() < ENOUGH && (set_ups.is_empty() || Instant::now() <= deadline) {
        let before = clock::now();
        (candidate.set_up)()?;
        set_ups.push(clock::now() - before);
    }
    let told = claimed.is_finite();
    Ok(Row {
        method: candidate.method,
        setting: candidate.setting.clone(),
        error: largest,
        at_most,
        median_error: all.get(all.len() / 2).copied().unwrap_or(largest),
        claimed: told.then_some(claimed),
        honest: told.then_some(honest),
        time: Time { median: f64::NAN, low: f64::NAN, high: f64::NAN },
        set_up: quantile(&mut set_ups, 0.5) + made.max(0.0),
        evaluations: found.iter().map(|own| own.evaluations as f64).sum::<f64>() / found.len() as f64,
        front: false,
    })
}

impl<'a> Measured<'a> {
    fn new(problem: &Problem<'_>, candidate: Candidate<'a>, row: Row) -> Self {
        let slice = match candidate.run {
            Run::Point(_) => Vec::new(),
            Run::Slice(_) => slice(problem),
        };
        let mut own = Self { candidate, row, slice, passes: 1, times: Vec::new(), spent: 0.0 };
        // The first batch warms up; its length says how many passes fill a batch.
        let took = own.timed(problem);
        own.passes = (BATCH / took.max(1.0)).clamp(1.0, 1e6) as usize;
        own
    }

    fn batch(&mut self, problem: &Problem<'_>) {
        let took = self.timed(problem);
        let points = if self.slice.is_empty() { problem.points.len() } else { self.slice.len() };
        self.times.push(took / (self.passes * points) as f64);
        self.spent += took;
    }

    /// Nanoseconds of all passes of a batch.
    fn timed(&mut self, problem: &Problem<'_>) -> f64 {
        let mut values = vec![0.0; self.slice.len()];
        let before = clock::now();
        for _ in 0..self.passes {
            match &mut self.candidate.run {
                Run::Point(run) => {
                    for (index, at) in problem.points.iter().enumerate() {
                        black_box(run(index, black_box(*at)).is_ok());
                    }
                }
                Run::Slice(run) => {
                    black_box(run(black_box(&self.slice), &mut values).is_ok());
                    black_box(&values);
                }
            }
        }
        clock::now() - before
    }

    fn finish(mut self) -> Row {
        let time =
            Time { median: quantile(&mut self.times, 0.5), low: quantile(&mut self.times, 0.25), high: quantile(&mut self.times, 0.75) };
        Row { time, ..self.row }
    }
}

/// The points again and again, as many as a slice has.
fn slice(problem: &Problem<'_>) -> Vec<f64> {
    problem.points.iter().copied().cycle().take(SLICE.max(problem.points.len())).collect()
}

/// The value below which that part of the list lies.
fn quantile(list: &mut [f64], part: f64) -> f64 {
    list.sort_by(f64::total_cmp);
    let index = (part * list.len().saturating_sub(1) as f64).round() as usize;
    list.get(index).copied().unwrap_or(0.0)
}

/// Fisher–Yates with a 64-bit xorshift; the same on every machine.
fn shuffle(order: &mut [usize], state: &mut u64) {
    for last in (1..order.len()).rev() {
        *state ^= *state << 13;
        *state ^= *state >> 7;
        *state ^= *state << 17;
        let other = usize::try_from(*state % (last as u64 + 1)).unwrap_or(0);
        order.swap(last, other);
    }
}
