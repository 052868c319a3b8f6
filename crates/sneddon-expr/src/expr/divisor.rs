//! The greatest common divisor of long integers, by Lehmer's algorithm.

use crate::num::work;
use num_bigint::{BigInt, BigUint};
use num_integer::Integer;
use num_traits::{One, ToPrimitive};

/// Number of leading bits from which quotients are computed.
const LEADING: u64 = 62;
/// Steps of work per word of the shorter number; `charge` counts the part that is quadratic in the words.
const STEPS_PER_WORD: u64 = 200;

/// Returns the greatest common divisor.
///
/// The quotients of Euclid's algorithm are computed from leading bits, about thirty bits at a time, which avoids most long
/// divisions (D. E. Knuth, The Art of Computer Programming, volume 2, 4.5.2, algorithm L).
pub(super) fn common_divisor(one: &BigInt, other: &BigInt) -> BigInt {
    if one.is_one() || other.is_one() {
        return BigInt::one();
    }
    let (mut large, mut small) = (one.magnitude().clone(), other.magnitude().clone());
    if large < small {
        std::mem::swap(&mut large, &mut small);
    }
    work::spend(STEPS_PER_WORD * (small.bits() / 64));
    loop {
        if let Some(word) = small.to_u64() {
            if word == 0 {
                return large.into();
            }
            return (&large % word).to_u64().map_or_else(BigInt::one, |last| word.gcd(&last).into());
        }
        (large, small) = match quotients(&large, &small) {
            Some([own, next]) => (combined(&large, &small, own), combined(&large, &small, next)),
            None => {
                let rest = &large % &small;
                (small, rest)
            }
        };
    }
}

/// The coefficients of both numbers after as many divisions as their leading bits decide; `None` if they decide none.
fn quotients(large: &BigUint, small: &BigUint) -> Option<[(i64, i64); 2]> {
    let shift = large.bits().checked_sub(LEADING)?;
    let (mut p, mut q) = ((large >> shift).to_i64()?, (small >> shift).to_i64()?);
    let (mut own, mut next) = ((1, 0), (0, 1));
    while q + next.0 != 0 && q + next.1 != 0 {
        let quotient = (p + own.0) / (q + next.0);
        if quotient != (p + own.1) / (q + next.1) {
            break;
        }
        let after: (i64, i64) = (own.0 - quotient * next.0, own.1 - quotient * next.1);
        (own, next) = (next, after);
        (p, q) = (q, p - quotient * q);
    }
    (own.1 != 0).then_some([own, next])
}

/// x·p + y·q for coefficients of opposite signs and a positive sum.
fn combined(x: &BigUint, y: &BigUint, (p, q): (i64, i64)) -> BigUint {
    let (one, other) = (x * p.unsigned_abs(), y * q.unsigned_abs());
    if p > 0 || q < 0 { one - other } else { other - one }
}
