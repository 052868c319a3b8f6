//! Bracketed root finding that never loses the root, over any range of magnitudes.

#[cfg(test)]
mod tests;

use super::error::NumError;
use super::work;

/// Options of [`bracketed`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RootOptions {
    /// Accepted width of the final bracket relative to the root; 0 for neighbouring numbers.
    pub rel_tol: f64,
    /// Accepted absolute width of the final bracket; the larger of the two counts.
    pub abs_tol: f64,
    /// Most calls of the function. The method itself needs at most about 260, usually 10.
    pub max_evaluations: u64,
}

impl Default for RootOptions {
    /// Down to neighbouring numbers, 400 evaluations.
    fn default() -> Self {
        Self { rel_tol: 0.0, abs_tol: 0.0, max_evaluations: 400 }
    }
}

/// A root with the interval that certainly contains a change of sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Root {
    /// The end of the final bracket with the smaller |f|, or a point where f = 0.
    pub x: f64,
    /// Lower end of the final bracket (equal to `x` where f = 0 there).
    pub lower: f64,
    /// Upper end of the final bracket.
    pub upper: f64,
    /// f(x).
    pub residual: f64,
    /// Calls of the function.
    pub evaluations: u64,
}

/// Where `f` changes its sign between `lower` and `upper`.
///
/// Method: inverse quadratic interpolation where Chandrupatla's criterion trusts it, else bisection
/// halfway between the two ends *in the order of the floating-point numbers*: halving the
/// exponent while the ends are many orders of magnitude apart, the mantissa later. Three steps that
/// do not halve the bracket are followed by such a bisection, so that 1e−300 … 1e300 needs
/// at most about 260 evaluations and usually far fewer.
///
/// Accuracy: by default the ends of the final bracket are neighbouring numbers, or f(x) = 0. For
/// a function that rounding makes jump about zero it is one of its changes of sign.
///
/// Infinite function values count by their sign. `f` may fail with its own error.
///
/// # Errors
/// * [`NumError::NoBracket`]: the same sign at both ends.
/// * [`NumError::NotFinite`]: `f` returned NaN, or an end is not finite.
/// * [`NumError::EvaluationLimit`]: carries the best point and the bracket's width.
///
/// ```
/// use sneddon_num::NumError;
/// use sneddon_num::roots::{RootOptions, bracketed};
/// let f = |x: f64| Ok::<f64, NumError>(x * x - 2.0);
/// let root = bracketed(f, 1e-300, 1e150, &RootOptions::default())?;
/// assert!((root.x - 2f64.sqrt()).abs() <= f64::EPSILON);
/// # Ok::<(), NumError>(())
/// ```
pub fn bracketed<E: From<NumError>>(
    mut f: impl FnMut(f64) -> Result<f64, E>,
    lower: f64,
    upper: f64,
    options: &RootOptions,
) -> Result<Root, E> {
    let mut calls = 0;
    let mut at = |x: f64| -> Result<End, E> {
        calls += 1;
        let value = f(x)?;
        if value.is_nan() || !x.is_finite() {
            return Err(NumError::NotFinite { at: x }.into());
        }
        Ok(End { x, value })
    };
    let (first, second) = (at(lower)?, at(upper)?);
    let mut state = State { newest: second, other: first, previous: first };
    if first.value == 0.0 {
        return Ok(state.root(first, 2));
    }
    if second.value == 0.0 {
        return Ok(state.root(second, 2));
    }
    if first.sign() == second.sign() {
        let (at_lower, at_upper) = (first.value, second.value);
        return Err(NumError::NoBracket { lower, upper, at_lower, at_upper }.into());
    }
    let mut evaluations = 2;
    // Bracket to be halved, and how many steps it has already had for that.
    let (mut wide, mut slow) = (state.gap(), 0);
    loop {
        work::check().map_err(NumError::from)?;
        let best = state.best();
        let width = (state.newest.x - state.other.x).abs();
        let wanted = options.abs_tol.max(options.rel_tol * best.x.abs());
        if state.gap() <= 1 || width <= wanted {
            return Ok(state.root(best, evaluations));
        }
        if evaluations >= options.max_evaluations {
            return Err(NumError::EvaluationLimit { value: best.x, error: width, evaluations }.into());
        }
        let x = if slow >= MOST_SLOW { state.middle() } else { state.interpolated(wanted) };
        let next = at(x)?;
        evaluations += 1;
        if next.value == 0.0 {
            return Ok(state.root(next, evaluations));
        }
        state.take(next);
        if state.gap() <= wide / 2 {
            (wide, slow) = (state.gap(), 0);
        } else {
            slow += 1;
        }
    }
}

/// Steps that may fail to halve the bracket before a bisection is forced.
const MOST_SLOW: u32 = 3;
/// Ends further apart than this factor are bisected by exponent before anything is interpolated.
const FAR: f64 = 1e3;

/// A point and the function's value there.
#[derive(Clone, Copy, Debug)]
struct End {
    x: f64,
    value: f64,
}

impl End {
    fn sign(self) -> bool {
        self.value > 0.0
    }
}

struct State {
    /// The latest point; the root lies between it and `other`.
    newest: End,
    other: End,
    /// The point that left the bracket last: the third one of the interpolation.
    previous: End,
}

impl State {
    /// Number of floating-point steps across the bracket.
    fn gap(&self) -> u64 {
        position(self.newest.x).abs_diff(position(self.other.x))
    }

    fn best(&self) -> End {
        if self.newest.value.abs() <= self.other.value.abs() { self.newest } else { self.other }
    }

    fn take(&mut self, next: End) {
        if next.sign() == self.newest.sign() {
            self.previous = self.newest;
        } else {
            self.previous = self.other;
            self.other = self.newest;
        }
        self.newest = next;
    }

    /// Halfway in the order of the floating-point numbers.
    fn middle(&self) -> f64 {
        let (a, b) = (position(self.newest.x), position(self.other.x));
        number(a.midpoint(b))
    }

    /// The next point to try: inside of the bracket, and not on its ends.
    fn interpolated(&self, wanted: f64) -> f64 {
        let (low, high) = (self.newest.x.min(self.other.x), self.newest.x.max(self.other.x));
        let same_sign = low > 0.0 || high < 0.0;
        let (small, large) = (low.abs().min(high.abs()), low.abs().max(high.abs()));
        // Across many orders of magnitude (or zero), linear interpolation is useless.
        if !same_sign || small * FAR < large {
            return self.middle();
        }
        let Some(share) = self.share() else {
            return self.middle();
        };
        // A quarter of the tolerance, or one number, beyond the estimate: closes the other side.
        let margin = 0.25 * wanted;
        let x = self.newest.x + share * (self.other.x - self.newest.x);
        let (floor, ceiling) = ((low + margin).max(low.next_up()), (high - margin).min(high.next_down()));
        if floor <= ceiling { x.clamp(floor, ceiling) } else { self.middle() }
    }

    /// The next point as a fraction of the way from the newest point to the other: by inverse quadratic interpolation where
    /// Chandrupatla's criterion (1997) holds, and by the secant while only two points are known. Returns `None` where the criterion
    /// fails and where the point is outside the bracket.
    fn share(&self) -> Option<f64> {
        let (a, b, c) = (self.newest, self.other, self.previous);
        let share = if c.x == b.x || c.x == a.x {
            a.value / (a.value - b.value)
        } else {
            let xi = (a.x - b.x) / (c.x - b.x);
            let phi = (a.value - b.value) / (c.value - b.value);
            if phi * phi >= xi || (1.0 - phi) * (1.0 - phi) >= 1.0 - xi {
                return None;
            }
            let alpha = (c.x - a.x) / (b.x - a.x);
            a.value / (b.value - a.value) * c.value / (b.value - c.value)
                + alpha * a.value / (c.value - a.value) * b.value / (c.value - b.value)
        };
        (share > 0.0 && share < 1.0).then_some(share)
    }

    fn root(&self, at: End, evaluations: u64) -> Root {
        let (lower, upper) =
            if at.value == 0.0 { (at.x, at.x) } else { (self.newest.x.min(self.other.x), self.newest.x.max(self.other.x)) };
        Root { x: at.x, lower, upper, residual: at.value, evaluations }
    }
}

/// The place of a finite number in the order of all of them; both zeros are 0.
fn position(x: f64) -> i64 {
    let size = (x.to_bits() & (u64::MAX >> 1)) as i64;
    if x.is_sign_negative() { -size } else { size }
}

/// The number at a place.
fn number(position: i64) -> f64 {
    let size = f64::from_bits(position.unsigned_abs());
    if position < 0 { -size } else { size }
}
