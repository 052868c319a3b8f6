//! Sines, cosines and tangents of multiples of π/6 and π/4, and the arcs that have such values.

use crate::expr::Expr;
use crate::num::work;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::ToPrimitive;
use std::sync::LazyLock;

/// Steps of π/12 in a whole turn.
const TURN: u8 = 24;

/// cos u where u is a multiple of π/6 or π/4.
pub(super) fn cosine(u: &Expr) -> Option<Expr> {
    steps(u).and_then(cosine_of)
}

/// sin u where u is a multiple of π/6 or π/4.
pub(super) fn sine(u: &Expr) -> Option<Expr> {
    // sin u = cos(u − π/2)
    steps(u).and_then(|steps| cosine_of((steps + TURN - 6) % TURN))
}

/// tan u where u is a multiple of π/6 or π/4 and no pole.
pub(super) fn tangent(u: &Expr) -> Option<Expr> {
    let (sine, cosine) = (sine(u)?, cosine(u)?);
    (!cosine.is_zero()).then(|| sine / cosine)
}

/// arcsin v for v of −1, −√3/2, −√2/2, −1/2, 0, 1/2, √2/2, √3/2 and 1.
pub(super) fn arcsine(v: &Expr) -> Option<Expr> {
    Some(angle(6) - arccosine(v)?)
}

/// arccos v for the same values.
pub(super) fn arccosine(v: &Expr) -> Option<Expr> {
    static COSINES: Values = LazyLock::new(|| (0..=TURN / 2).filter_map(|steps| Some((cosine_of(steps)?, angle(steps)))).collect());
    arc(&COSINES, v)
}

/// arctan v for v of 0, ±√3/3, ±1 and ±√3.
pub(super) fn arctangent(v: &Expr) -> Option<Expr> {
    static TANGENTS: Values = LazyLock::new(|| {
        let acute = (0..6).filter_map(|steps| Some((tangent(&angle(steps))?, angle(steps))));
        acute.flat_map(|(value, angle)| [(-&value, -&angle), (value, angle)]).collect()
    });
    arc(&TANGENTS, v)
}

/// The exact values of a function, each with its angle.
type Values = LazyLock<Vec<(Expr, Expr)>>;

fn arc(values: &'static Values, v: &Expr) -> Option<Expr> {
    // The first call computes them for the whole process.
    work::uncounted(|| values.iter()).find(|(value, _)| value == v).map(|(_, angle)| angle.clone())
}

/// Returns the angle `steps`·π/12.
fn angle(steps: u8) -> Expr {
    Expr::ratio(i64::from(steps), i64::from(TURN) / 2) * Expr::pi()
}

/// Returns the angle modulo 2π in units of π/12, or `None` if it is not a whole number of them.
fn steps(u: &Expr) -> Option<u8> {
    if u.is_zero() {
        return Some(0);
    }
    let (number, rest) = u.split_coefficient();
    if rest != Expr::pi() {
        return None;
    }
    let steps = number.value() * BigRational::from_integer(BigInt::from(TURN / 2));
    steps.is_integer().then(|| steps.to_integer().mod_floor(&BigInt::from(TURN)).to_u8()).flatten()
}

/// Returns the cosine of `steps`·π/12, or `None` if that angle is not a multiple of π/6 or π/4.
fn cosine_of(steps: u8) -> Option<Expr> {
    let half_root = |n: i64| Expr::integer(n).sqrt() / Expr::integer(2);
    // cos(2π − u) = cos u and cos(π − u) = −cos u.
    let acute = if steps > TURN / 2 { TURN - steps } else { steps };
    let (acute, negative) = if acute > TURN / 4 { (TURN / 2 - acute, true) } else { (acute, false) };
    let value = match acute {
        0 => Expr::one(),
        2 => half_root(3),
        3 => half_root(2),
        4 => Expr::ratio(1, 2),
        6 => Expr::zero(),
        _ => return None,
    };
    Some(if negative { -value } else { value })
}
