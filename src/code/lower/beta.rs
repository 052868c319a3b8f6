//! The incomplete Beta function of a segment from b to x, with b^2/x^2 from the lengths.

use super::equal::equal;
use super::{Recorder, Step};
use crate::eval::Algebra;

/// The integral of t^(a - 1) (1 - t)^(b - 1) from 0 to the given end, if the end or 1 less it is the square of a ratio of lengths: a
/// difference from 1 would lose its digits where the end is next to 1.
pub(super) fn from_zero(recorder: &mut Recorder, a: u32, b: u32, end: u32) -> Option<u32> {
    let one = recorder.number(1.0);
    let rest = recorder.subtract(one, end);
    if let Some((short, long)) = ratio(recorder, rest) {
        let quotient = recorder.divide(short, long);
        let rest = recorder.multiply(quotient, quotient);
        return Some(recorder.named("betainc_from_zero", &[a, b, end, rest]));
    }
    let (short, long) = ratio(recorder, end)?;
    let (gap, sum) = (recorder.subtract(long, short), recorder.add(long, short));
    let (first, second) = (recorder.divide(gap, long), recorder.divide(sum, long));
    let rest = recorder.multiply(first, second);
    Some(recorder.named("betainc_from_zero", &[a, b, end, rest]))
}

/// Two inputs or constants, the square of whose ratio is a value.
fn ratio(recorder: &mut Recorder, value: u32) -> Option<(u32, u32)> {
    let is_length = |own: &Step| matches!(own, Step::Input(_) | Step::Constant(..));
    let lengths: Vec<u32> = (0..).zip(&recorder.steps).filter(|(_, own)| is_length(own)).map(|(place, _)| place).collect();
    lengths.iter().flat_map(|short| lengths.iter().map(move |long| (*short, *long))).find(|(short, long)| {
        let ratio = recorder.divide(*short, *long);
        let square = recorder.multiply(ratio, ratio);
        equal(recorder, square, value)
    })
}
