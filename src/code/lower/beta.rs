//! The incomplete Beta function of a segment from b to x, with b^2/x^2 from the lengths.

use super::equal::{CLOSE, SETS, samples};
use super::{Recorder, Step};
use crate::code::tree::Operator;
use crate::eval::Algebra;

/// The integral of t^(a - 1) (1 - t)^(b - 1) from 0 to the given end.
///
/// 1 less the end is needed as well; it is not computed as a difference where that would lose its digits. If the end or 1 less it is the
/// square of a ratio of lengths, the other one is computed from these lengths, and if the end is a difference from 1, its subtrahend is used.
pub(super) fn from_zero(recorder: &mut Recorder, a: u32, b: u32, end: u32) -> u32 {
    let one = recorder.number(1.0);
    let subtrahend = match recorder.steps.get(end as usize) {
        Some(Step::Binary(Operator::Subtract, whole, part)) if *whole == one => Some(*part),
        _ => None,
    };
    let difference = subtrahend.unwrap_or_else(|| recorder.subtract(one, end));
    let rest = if let Some((short, long)) = ratio(recorder, difference) {
        let quotient = recorder.divide(short, long);
        recorder.multiply(quotient, quotient)
    } else if let Some((short, long)) = ratio(recorder, end) {
        let (gap, sum) = (recorder.subtract(long, short), recorder.add(long, short));
        let (first, second) = (recorder.divide(gap, long), recorder.divide(sum, long));
        recorder.multiply(first, second)
    } else {
        difference
    };
    recorder.named("betainc_from_zero", &[a, b, end, rest])
}

/// The most values that are taken for lengths.
const MOST_LENGTHS: usize = 64;

/// Two values, the square of whose ratio is a value; the last ones, because powers are corrected after they are computed.
fn ratio(recorder: &Recorder, value: u32) -> Option<(u32, u32)> {
    let all = samples(recorder);
    let squares = all.get(value as usize).copied().flatten()?;
    let lengths: Vec<(u32, [f64; SETS])> = (0..).zip(all).take(MOST_LENGTHS).filter_map(|(place, own)| Some((place, own?))).collect();
    let is_ratio = |short: &[f64], long: &[f64]| {
        let all = short.iter().zip(long).zip(&squares);
        all.into_iter().all(|((short, long), square)| ((short / long).powi(2) - square).abs() <= CLOSE * square.abs())
    };
    let pairs = lengths.iter().rev().flat_map(|short| lengths.iter().rev().map(move |long| (short, long)));
    pairs.into_iter().find(|(short, long)| is_ratio(&short.1, &long.1)).map(|(short, long)| (short.0, long.0))
}
