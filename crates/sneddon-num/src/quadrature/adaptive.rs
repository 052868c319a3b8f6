//! Global adaptive Gauss–Kronrod quadrature with an error estimate: the piece with the largest error is refined first.

use super::super::bounded::Bounded;
use super::super::error::NumError;
use super::super::estimate::Estimate;
use super::refine::Work;
use super::sample::{Order, Part};
use super::transform::Map;
use super::{Integrand, Panel, Point};

/// Options of [`integrate`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Accepted error relative to |value|; 0 to use `abs_tol` alone.
    pub rel_tol: f64,
    /// Accepted absolute error; the larger of the two tolerances counts.
    pub abs_tol: f64,
    /// Maximum number of evaluations of the integrand.
    pub max_evaluations: u64,
    /// Whether the effect of the rounding of [`Point::x`] is added to the error. Switch it off
    /// only for integrands that use the distances alone, or carry the rounding of x in their own
    /// bound ([`Point::bounded_x`]).
    pub charge_x: bool,
    /// The rule applied to every piece.
    pub rule: Rule,
}

/// The Gauss–Kronrod rule of a quadrature.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Rule {
    /// 15 points for loose tolerances, 21 for sharp ones, 31 where they are predicted to suffice.
    #[default]
    Cheapest,
    /// 15 points on every piece.
    Kronrod15,
    /// 21 points on every piece.
    Kronrod21,
    /// 31 points on every piece.
    Kronrod31,
    /// 61 points on every piece.
    Kronrod61,
}

impl Rule {
    /// The named rules, smallest first.
    pub const NAMED: [Self; 4] = [Self::Kronrod15, Self::Kronrod21, Self::Kronrod31, Self::Kronrod61];

    /// The number of points; 0 if it is chosen by the tolerance.
    #[must_use]
    pub const fn points(self) -> u64 {
        match self {
            Self::Cheapest => 0,
            Self::Kronrod15 => 15,
            Self::Kronrod21 => 21,
            Self::Kronrod31 => 31,
            Self::Kronrod61 => 61,
        }
    }
}

impl Options {
    /// The rule that pieces start with.
    fn order(&self) -> Order {
        match self.rule {
            // 21 points usually meet a sharp tolerance at once where 15 need a second attempt.
            Rule::Cheapest if self.rel_tol >= 1e-8 => Order::Points15,
            Rule::Cheapest | Rule::Kronrod21 => Order::Points21,
            Rule::Kronrod15 => Order::Points15,
            Rule::Kronrod31 => Order::Points31,
            Rule::Kronrod61 => Order::Points61,
        }
    }

    /// The absolute tolerance for this value.
    pub(super) fn target(&self, value: f64) -> f64 {
        self.abs_tol.max(self.rel_tol * value.abs())
    }
}

impl Default for Options {
    /// Relative tolerance 1e−12, 200 000 evaluations, rounding of x charged.
    fn default() -> Self {
        Self { rel_tol: 1e-12, abs_tol: 0.0, max_evaluations: 200_000, charge_x: true, rule: Rule::Cheapest }
    }
}

/// The integral of `integrand` over all panels.
///
/// The integrand returns its value with a bound on its own rounding error; it is called at inner
/// points only. Panels are summed up; they need not touch. Break the range at every kink, and
/// declare algebraic and logarithmic ends as [`EndBehaviour::Singular`](super::EndBehaviour).
///
/// Accuracy: `error` is the sum of the truncation error of the rules (estimated from the decay of the
/// integrand's coefficients on the nodes), the integrand's error bounds, and the rounding of nodes,
/// weights and sums. It is based on samples: a feature that affects no node, such as a narrow spike
/// or a kink just inside the end of a piece, is not detected; hence place panel ends at kinks. A panel
/// of zeros is searched with eight times as many points first.
///
/// # Errors
/// * [`NumError::ToleranceNotReached`]: only rounding noise remains, or no refinement helps; carries
///   the best value and its error bound.
/// * [`NumError::EvaluationLimit`]: the same after `max_evaluations` (overrun by one panel at most);
///   the error is infinite if some panel has not been looked at.
/// * [`NumError::NotFinite`]: the integrand returned an infinity or NaN.
/// * [`NumError::OutOfDomain`]: a panel with ends that are not finite or in the wrong order, or a
///   sum beyond the largest number.
///
/// ```
/// use sneddon_num::quadrature::{Options, Panel, integrate};
/// use sneddon_num::Bounded;
/// // ∫₀¹ dx/√(1 − x) = 2, from the exact distance to the upper end.
/// let panels = [Panel::singular(0.0, 1.0)];
/// let mut f = |p: sneddon_num::quadrature::Point| Bounded::exact(1.0) / p.bounded_from_upper().sqrt();
/// let options = Options { charge_x: false, ..Options::default() };
/// let two = integrate(&mut f, &panels, &options)?;
/// assert!((two.value - 2.0).abs() <= two.error && two.error <= 2e-12);
/// # Ok::<(), sneddon_num::NumError>(())
/// ```
pub fn integrate(integrand: &mut impl FnMut(Point) -> Bounded, panels: &[Panel], options: &Options) -> Result<Estimate, NumError> {
    let mut block = |points: &[Point], heights: &mut [Bounded]| {
        for (point, height) in points.iter().zip(heights) {
            *height = integrand(*point);
        }
    };
    integrate_blocks(&mut block, panels, options)
}

/// As [`integrate`], for an integrand that fills in its values for a block of points, all points of a rule at a time.
///
/// # Errors
/// As [`integrate`].
///
/// ```
/// use sneddon_num::quadrature::{Options, Panel, Point, integrate_blocks};
/// use sneddon_num::Bounded;
/// let mut cubes = |points: &[Point], heights: &mut [Bounded]| {
///     for (p, h) in points.iter().zip(heights) {
///         *h = Bounded::exact(p.x.powi(3));
///     }
/// };
/// let found = integrate_blocks(&mut cubes, &[Panel::smooth(0.0, 2.0)], &Options::default())?;
/// assert!((found.value - 4.0).abs() <= found.error && found.evaluations == 21);
/// # Ok::<(), sneddon_num::NumError>(())
/// ```
pub fn integrate_blocks(
    integrand: &mut impl FnMut(&[Point], &mut [Bounded]),
    panels: &[Panel],
    options: &Options,
) -> Result<Estimate, NumError> {
    over_panels(integrand, panels, options)
}

fn over_panels(integrand: &mut Integrand<'_>, panels: &[Panel], options: &Options) -> Result<Estimate, NumError> {
    let order = options.order();
    let mut work = Work::default();
    for panel in panels {
        let Some(map) = Map::new(panel)? else {
            continue;
        };
        work.may_start(options)?;
        let (cut, used) = map.cut_tails(integrand)?;
        work.count(cut, used);
        if !map.is_smooth() {
            // The substituted integrand is bell-shaped and not resolved by a single rule.
            for index in 0..BELL_PIECES {
                let place = Part { index, level: BELL_PIECES.ilog2() };
                let piece = work.measure(order, map, place, 0, options, integrand)?;
                work.push(piece);
            }
            continue;
        }
        let whole = Part { index: 0, level: 0 };
        let piece = work.measure(order, map, whole, 0, options, integrand)?;
        if panels.len() == 1 {
            // The common case: a single rule suffices, and nothing is allocated.
            let found = work.alone(&piece, options);
            if found.error <= options.target(found.value) {
                return Ok(found);
            }
        }
        work.push(piece);
    }
    work.refine(order, options, integrand)
}

/// Pieces that a singular panel starts with.
const BELL_PIECES: u64 = 8;
