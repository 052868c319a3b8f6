//! A benchmark of speed against accuracy as a table, JSON, CSV and a plot.

pub mod csv;
pub mod json;
pub mod markdown;
pub mod plot;
pub mod text;

use crate::expr::Formula;
use crate::tradeoff::{Advice, Row, Study};

/// A study with the profile as typed.
pub struct Tradeoff<'a> {
    /// The profile as typed.
    pub profile: &'a Formula,
    /// The parameters with their values.
    pub parameters: Vec<(String, f64)>,
    /// The measurements.
    pub study: &'a Study<'a>,
}

impl Tradeoff<'_> {
    /// Returns the sources of the reference values.
    fn reference(&self) -> String {
        let mut sources: Vec<&str> = self.study.truths.iter().map(|truth| truth.source).collect();
        sources.sort_unstable();
        sources.dedup();
        sources.join("; ")
    }

    /// Returns the largest relative error of the reference values.
    fn reference_error(&self) -> f64 {
        self.study.truths.iter().map(|truth| truth.value.error / truth.value.value.hi.abs()).fold(0.0, f64::max)
    }

    /// Returns the rows in the order of measurement, with a mark for the Pareto front.
    pub(crate) fn rows(&self) -> impl Iterator<Item = &Row> {
        self.study.rows.iter()
    }

    /// Returns the recommendations; equal recommendations share a sentence.
    fn sentences(&self) -> Vec<String> {
        let mut sentences = Vec::new();
        let all = &self.study.advice;
        let mut start = 0;
        while let Some(first) = all.get(start) {
            let same =
                all.iter().skip(start).take_while(|own| (own.pick, own.few.map(|few| few.0)) == (first.pick, first.few.map(|few| few.0)));
            let own: Vec<&Advice> = same.collect();
            start += own.len();
            let wanted: Vec<String> = own.iter().map(|advice| format!("{:e}", advice.wanted)).collect();
            sentences.push(self.sentence(&wanted.join(", "), first));
        }
        sentences.extend(self.cut().map(|own| format!("Incomplete: {own}.")));
        sentences
    }

    /// Returns the number of settings that the time did not suffice for, as a sentence without a period; `None` if all were measured.
    pub fn cut(&self) -> Option<String> {
        let count = self.study.skipped.iter().filter(|own| own.is_cut()).count();
        let settings = if count == 1 { "1 setting was" } else { &format!("{count} settings were") };
        (count > 0).then(|| format!("{settings} not measured, because the time was used up"))
    }

    fn sentence(&self, wanted: &str, advice: &Advice) -> String {
        let row = |index: Option<usize>| index.and_then(|index| self.study.rows.get(index));
        let Some(pick) = row(advice.pick) else {
            return format!("For a relative error of {wanted} no measured method is accurate enough.");
        };
        let cost = duration(pick.time.median);
        let first = format!("For a relative error of {wanted} use {} ({}), {cost} per point", pick.method, pick.setting);
        match advice.few.and_then(|(index, from)| Some((row(Some(index))?, from))) {
            Some((other, from)) => format!(
                "{first} after a set-up of {}; for fewer than {from} points {} ({}) is faster.",
                duration(pick.set_up),
                other.method,
                other.setting
            ),
            None => format!("{first}."),
        }
    }
}

/// Formats nanoseconds with three digits and a unit.
fn duration(nanoseconds: f64) -> String {
    let (value, unit) = match nanoseconds {
        t if t < 1e3 => (t, "ns"),
        t if t < 1e6 => (t / 1e3, "µs"),
        t if t < 1e9 => (t / 1e6, "ms"),
        t => (t / 1e9, "s"),
    };
    let digits = if value < 10.0 {
        2
    } else if value < 100.0 {
        1
    } else {
        0
    };
    format!("{value:.digits$} {unit}")
}
