//! Finding two points between which a function changes its sign.

use super::super::error::NumError;
use super::super::work;

/// Two ends with opposite signs of the function, or one of them a root.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bracket {
    /// Lower end.
    pub lower: f64,
    /// Upper end.
    pub upper: f64,
    /// f(lower).
    pub at_lower: f64,
    /// f(upper).
    pub at_upper: f64,
    /// Calls of the function.
    pub evaluations: u64,
}

/// Doublings before the factor itself starts to be squared.
const DOUBLINGS: u32 = 8;

/// The first sign change above `start` > 0: the argument doubles eight times, after that the factor
/// is squared at each step, so that `ceiling` (at most the largest number) is reached in at most
/// about twenty evaluations. The last argument tried is `ceiling` itself.
///
/// The bracket may then span many orders of magnitude; [`bracketed`](super::bracketed) is made for that.
///
/// # Errors
/// * [`NumError::OutOfDomain`] unless 0 < start ≤ ceiling, both finite.
/// * [`NumError::NoBracket`] if the sign at `ceiling` is still that at `start`.
/// * [`NumError::NotFinite`] if `f` returns NaN; infinite values count by their sign.
///
/// ```
/// use sneddon_num::NumError;
/// use sneddon_num::roots::expand_bracket;
/// let bracket = expand_bracket(|x: f64| Ok::<f64, NumError>(x - 100.0), 1.0, 1e300)?;
/// assert_eq!((bracket.lower, bracket.upper), (64.0, 128.0));
/// # Ok::<(), NumError>(())
/// ```
pub fn expand_bracket<E: From<NumError>>(mut f: impl FnMut(f64) -> Result<f64, E>, start: f64, ceiling: f64) -> Result<Bracket, E> {
    for (what, got) in [("start of a bracket", start), ("ceiling of a bracket", ceiling)] {
        if got.is_nan() || got <= 0.0 || got.is_infinite() || start > ceiling {
            return Err(NumError::OutOfDomain { what, got, accepted: "0 < start <= ceiling, both finite" }.into());
        }
    }
    let mut evaluations = 0;
    let mut at = |x: f64| -> Result<f64, E> {
        evaluations += 1;
        let value = f(x)?;
        if value.is_nan() { Err(NumError::NotFinite { at: x }.into()) } else { Ok(value) }
    };
    let at_start = at(start)?;
    let (mut lower, mut at_lower) = (start, at_start);
    let mut factor = 2.0;
    let mut steps = 0;
    let (upper, at_upper) = loop {
        work::check().map_err(NumError::from)?;
        if at_lower == 0.0 {
            break (lower, at_lower);
        }
        if lower >= ceiling {
            return Err(NumError::NoBracket { lower: start, upper: ceiling, at_lower: at_start, at_upper: at_lower }.into());
        }
        let upper = (lower * factor).min(ceiling);
        let at_upper = at(upper)?;
        if at_upper == 0.0 || (at_upper > 0.0) != (at_lower > 0.0) {
            break (upper, at_upper);
        }
        (lower, at_lower) = (upper, at_upper);
        steps += 1;
        if steps >= DOUBLINGS {
            factor *= factor;
        }
    };
    Ok(Bracket { lower, upper, at_lower, at_upper, evaluations })
}
