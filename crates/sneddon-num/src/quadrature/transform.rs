//! Panels, and the variable maps that make an integrand smooth on them.

use super::super::bounded::{Bounded, UNIT};
use super::super::error::NumError;
use super::Integrand;

/// A node of the quadrature, with its distances to both ends of the panel that the caller gave.
///
/// The distances are computed without cancellation and may be as small as 1e−300 of the panel.
/// An integrand that varies rapidly, or is singular, at an end must use the distance to that end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The place, rounded; it may coincide with an end of the panel.
    pub x: f64,
    /// x − lower, positive; relative error below 5e−16.
    pub from_lower: f64,
    /// upper − x, positive; relative error below 5e−16.
    pub from_upper: f64,
}

impl Point {
    /// x with the bound on its rounding, for integrands that use x itself.
    #[must_use]
    pub fn bounded_x(&self) -> Bounded {
        let distance = self.from_lower.min(self.from_upper);
        let rounded = Bounded::rounded(self.x);
        Bounded { value: self.x, error: rounded.error + 4.0 * UNIT * distance }
    }

    /// The distance to the lower end with its error bound.
    #[must_use]
    pub fn bounded_from_lower(&self) -> Bounded {
        Bounded { value: self.from_lower, error: 4.0 * UNIT * self.from_lower }
    }

    /// The distance to the upper end with its error bound.
    #[must_use]
    pub fn bounded_from_upper(&self) -> Bounded {
        Bounded { value: self.from_upper, error: 4.0 * UNIT * self.from_upper }
    }
}

/// How the integrand behaves at the ends of a panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EndBehaviour {
    /// Many times differentiable up to both ends.
    Smooth,
    /// At one or both ends like r^α with α > −1, or logarithmic, r being the distance to that end.
    Singular,
}

/// A piece of the range of integration: lower ≤ upper, and the behaviour at the ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Panel {
    /// Lower end.
    pub lower: f64,
    /// Upper end.
    pub upper: f64,
    /// The behaviour at the ends.
    pub kind: EndBehaviour,
}

impl Panel {
    /// A panel on which the integrand is smooth, ends included.
    #[must_use]
    pub const fn smooth(lower: f64, upper: f64) -> Self {
        Self { lower, upper, kind: EndBehaviour::Smooth }
    }

    /// A panel with an algebraic or logarithmic singularity at one or both ends.
    #[must_use]
    pub const fn singular(lower: f64, upper: f64) -> Self {
        Self { lower, upper, kind: EndBehaviour::Singular }
    }

    /// Smooth panels from 0 to the first of the rising ends, from there to the next, and so on.
    pub fn chain(ends: impl IntoIterator<Item = f64>) -> Vec<Self> {
        let between = |lower: &mut f64, upper| Some(Self::smooth(std::mem::replace(lower, upper), upper));
        ends.into_iter().scan(0.0, between).collect()
    }
}

/// Largest ln(1/relative distance) to an end: ln(1e300).
const DEEPEST: f64 = 690.775_527_898_213_7;
/// Distances stay above this, where they still have all their digits.
const SMALLEST: f64 = 1e-305;

/// The map from the unit interval onto a panel.
///
/// A smooth panel maps linearly. A singular one by r/(L − r) = exp(π sinh u), u running over
/// [−T, T]: the double-exponential substitution, used as a map and not as a rule, so that the
/// adaptive rule and its error estimate are the same for both.
#[derive(Clone, Copy, Debug)]
pub(super) struct Map {
    lower: f64,
    upper: f64,
    length: f64,
    /// T for a singular panel, 0 for a smooth one.
    reach: f64,
}

impl Map {
    /// Checks the panel; `None` for an empty one.
    pub(super) fn new(panel: &Panel) -> Result<Option<Self>, NumError> {
        let Panel { lower, upper, kind } = *panel;
        let length = upper - lower;
        if !length.is_finite() || length < 0.0 {
            return Err(NumError::OutOfDomain {
                what: "length of an integration panel",
                got: length,
                accepted: "finite ends, lower <= upper",
            });
        }
        if length == 0.0 {
            return Ok(None);
        }
        let reach = match kind {
            EndBehaviour::Smooth => 0.0,
            EndBehaviour::Singular => {
                let depth = DEEPEST.min((length / SMALLEST).ln()).max(1.0);
                (depth / std::f64::consts::PI).asinh()
            }
        };
        Ok(Some(Self { lower, upper, length, reach }))
    }

    pub(super) fn is_smooth(&self) -> bool {
        self.reach == 0.0
    }

    /// The point at fraction `t` of the map's own variable, where `rest` = 1 − t without
    /// cancellation, and dx/dt there.
    #[inline]
    pub(super) fn point(&self, t: f64, rest: f64) -> (Point, f64) {
        if self.is_smooth() {
            return (self.at(self.length * t, self.length * rest), self.length);
        }
        let (exp, inverse) = {
            let exp = (self.reach * (t - rest).abs()).exp();
            (exp, 1.0 / exp)
        };
        let (sinh, cosh) = (0.5 * (exp - inverse), 0.5 * (exp + inverse));
        // q ≤ 1 is the ratio of the two distances, the smaller one first.
        let q = (-std::f64::consts::PI * sinh).exp();
        let far = self.length / (1.0 + q);
        let near = far * q;
        let slope = near / (1.0 + q) * (std::f64::consts::TAU * self.reach) * cosh;
        let point = if t < rest { self.at(near, far) } else { self.at(far, near) };
        (point, slope)
    }

    #[inline]
    fn at(&self, from_lower: f64, from_upper: f64) -> Point {
        // From the nearer end, so that x is rounded once.
        let x = if from_lower <= from_upper { self.lower + from_lower } else { self.upper - from_upper };
        Point { x, from_lower, from_upper }
    }

    /// How far rounding can move the nodes between fractions `t0` and `t1` of the map's variable,
    /// in that variable (unit interval); with `charge_x` also by the rounding of x.
    pub(super) fn displacement(&self, t0: f64, t1: f64, charge_x: bool) -> f64 {
        let nodes = if self.is_smooth() {
            // Relative to the nearer end: see the duty of integrands in [`Point`].
            4.0 * UNIT * t1.min(1.0 - t0)
        } else {
            2.0 * UNIT
        };
        if !charge_x {
            return nodes;
        }
        let size = if self.is_smooth() {
            let ends = [self.lower + self.length * t0, self.lower + self.length * t1];
            ends[0].abs().max(ends[1].abs())
        } else {
            self.lower.abs().max(self.upper.abs()).min(self.length * 4.0)
        };
        nodes + UNIT * size / self.length
    }

    /// Bound on what the substitution leaves out at both ends, from the local exponent of the
    /// integrand there; and the number of evaluations used. Infinite where the exponent is ≤ −1.
    pub(super) fn cut_tails(&self, integrand: &mut Integrand<'_>) -> Result<(f64, u64), NumError> {
        if self.is_smooth() {
            return Ok((0.0, 0));
        }
        let mut total = 0.0;
        for lower_end in [true, false] {
            let mut near = [(0.0, 0.0); 2];
            for (slot, t) in near.iter_mut().zip([0.0, 0.01]) {
                let (point, _) = if lower_end { self.point(t, 1.0 - t) } else { self.point(1.0 - t, t) };
                let mut found = [Bounded::exact(0.0)];
                integrand(&[point], &mut found);
                let height = found[0].value;
                if !height.is_finite() {
                    return Err(NumError::NotFinite { at: point.x });
                }
                *slot = (if lower_end { point.from_lower } else { point.from_upper }, height.abs());
            }
            let [(r, height), (further, other)] = near;
            if height == 0.0 {
                continue;
            }
            let exponent = if other == 0.0 { 0.0 } else { (height / other).ln() / (r / further).ln() };
            let room = 1.0 + exponent;
            // ∫₀^r C s^α ds = r·f(r)/(1 + α), doubled because α is measured.
            total += if room > 0.0 { 2.0 * r * height / room } else { f64::INFINITY };
        }
        Ok((total, 4))
    }
}
