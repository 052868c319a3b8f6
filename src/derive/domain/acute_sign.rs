//! The sign of an expression in one slope angle, for every acute angle.

use crate::derive::domain::numeric_sign::certain_sign;
use crate::eval::{BoundedAlgebra, IntervalAlgebra, Tape};
use crate::expr::{Expr, Symbol};
use crate::num::{Bounded, Region};

/// The part of the range of the angle that enclosures cover, …
const INNER: (f64, f64) = (0.03, 0.97);
/// … with at most this many of them.
const MOST_ENCLOSURES: usize = 2_000;
/// Quarters of decades of the distances from the ends of the range at which the sign is looked at beyond that part.
const DISTANCES: std::ops::Range<i32> = -48..-6;

/// 1 or −1 if an expression in one parameter has this sign everywhere between 0 and `end`, where the slope angles in it are acute.
///
/// Enclosures prove it in the inner part of the range; next to the ends, where the expression may tend to 0 as tan θ − sin θ does, it is
/// looked at from place to place.
pub(crate) fn same_sign(expr: &Expr, parameter: &Symbol, end: f64) -> Option<f64> {
    let tape = Tape::compile(std::slice::from_ref(expr), std::slice::from_ref(parameter)).ok()?;
    let at = |share: f64| tape.run(&mut BoundedAlgebra, &[Bounded::rounded(end * share)], &mut Vec::new()).and_then(certain_sign);
    let sign = at(0.5)?;
    let near = DISTANCES.map(|power| 10f64.powf(0.25 * f64::from(power))).flat_map(|distance| [distance, 1.0 - distance]);
    if near.filter_map(at).any(|own| own != sign) || [INNER.0, INNER.1].map(at) != [Some(sign); 2] {
        return None;
    }
    let (mut open, mut slots) = (vec![INNER], Vec::new());
    for _ in 0..MOST_ENCLOSURES {
        let Some((from, to)) = open.pop() else { return Some(sign) };
        let found = tape.run(&mut IntervalAlgebra, &[Region::interval(end * from, end * to)], &mut slots).and_then(Region::real_range);
        if found.is_none_or(|(low, high)| if sign > 0.0 { low <= 0.0 } else { high >= 0.0 }) {
            let middle = 0.5 * (from + to);
            open.extend([(from, middle), (middle, to)]);
        }
    }
    None
}
