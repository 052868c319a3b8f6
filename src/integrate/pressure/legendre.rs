//! The pressure of a smooth odd f′ by its Legendre expansion in r²: no inner integral and no second derivative.

use crate::integrate::integral::{NumericProfile, NumericSegment};
use crate::integrate::source::f_prime::Scratch;
use crate::num::Estimate;
use crate::num::bounded::UNIT;
use crate::num::quadrature::{Extent, Known};
use crate::num::spectral::{Basis, Rule, pressures, rise, rule};
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// Numbers of nodes to try, in increasing order.
const COUNTS: [usize; 5] = [12, 16, 24, 48, 96];
/// Numbers of nodes for which samples can estimate the truncation error.
const JUDGED: [usize; 3] = [COUNTS[2], COUNTS[3], COUNTS[4]];
/// Most nodes and guards.
const MOST_NODES: usize = COUNTS[4] + GUARDS;
/// Below this magnitude, f′ may have lost digits at the nodes near the axis.
const DEEP: f64 = 1e-150;
/// Number of values of f′ evaluated together.
const BLOCK: usize = 16;
/// Beyond this fraction of the limit of f′, other methods are used.
const NEAR_THE_LIMIT: f64 = 0.9;
/// Number of points at which the expansion is compared with f′.
const GUARDS: usize = 6;
/// Coefficients are examined in groups of this size.
const GROUP: usize = 6;
/// Smallest rate of decrease to assume, however fast the coefficients decrease.
const LEAST_FALL: f64 = 0.1;

impl NumericProfile {
    /// ∫_s^a g′(x)/√(x² − s²) dx if one odd f′ without a kink reaches from the axis to a; `None` if it does not, or if the
    /// expansion does not meet the tolerance.
    ///
    /// f′ = r Σ c_k P_k(2r²/a² − 1), and p is the sum of the known pressures of the terms. The truncation error is estimated from
    /// the decrease of c_k and from values of f′ between nodes, mainly near the axis, where steep powers hide narrow features.
    pub(crate) fn pressure_by_series(&self, s: f64, a: f64, tolerance: f64) -> Option<Estimate> {
        if !(0.0..a).contains(&s) {
            return None;
        }
        let segment = self.expandable(a)?;
        let mut evaluations = 0;
        for count in JUDGED {
            let expansion = segment.expand(count, a, GUARDS)?;
            evaluations += expansion.evaluations;
            let found = expansion.at(s);
            // Coefficients of f′/r may underflow where f′ does not.
            if found.value == 0.0 {
                return None;
            }
            if found.doubt + found.left_out <= 0.95 * tolerance * found.value.abs() {
                // If the truncation error exceeds the rounding noise, report at least the requested tolerance as the error.
                let least = if found.left_out > found.doubt { 0.97 * tolerance * found.value.abs() } else { 0.0 };
                return Some(Estimate::estimated(found.value, least.max(found.doubt + found.left_out), evaluations));
            }
            if found.doubt > tolerance * found.value.abs() {
                return None;
            }
        }
        None
    }

    /// The same with a number of terms proven sufficient by an enclosure of f′ around [−a, a]; `None` without a proof.
    ///
    /// h(u) = f′/r is analytic in the ellipse of ρ = e^(2σ) around u = 2r²/a² − 1 ∈ [−1, 1] if f′ is analytic in the ellipse of σ
    /// around [−a, a]. If |h| ≤ M there, |c_k| ≤ (2k + 1) M √(ρ² + ρ⁻²)/(ρ^(k+1) (1 − ρ⁻²)) (Wang and Xiang, Math. Comp. 81,
    /// 2012). Gauss's rule adds to c_k its values for P_k c_j P_j, j ≥ 2N − k. A term gives |Φ_k| ≤ 1 + π/2, because g = ± a x
    /// sin((2k+1)θ)/(2k+1), x = a sin θ.
    pub(crate) fn pressure_by_proven_series(&self, s: f64, a: f64, tolerance: f64) -> Option<Estimate> {
        if !(s > 0.0 && s < a) {
            return None;
        }
        let segment = self.expandable(a)?;
        let known = segment.series_rule(a, |low, high| segment.terms_that_suffice(low, high))?;
        let expansion = segment.expand(*COUNTS.get(known.rule)?, a, 0)?;
        let found = expansion.at(s);
        // f′ and its coefficients may underflow near the axis long before the pressure does.
        if !(found.value.abs() > DEEP && expansion.scale > DEEP) {
            return None;
        }
        let left_out = a * known.left_out * (1.0 + FRAC_PI_2) * (1.0 + 1e-9);
        let error = found.doubt + left_out;
        let enough = error <= tolerance * found.value.abs() || left_out <= 0.1 * error;
        enough.then_some(Estimate { error, evaluations: expansion.evaluations, ..Estimate::exact(found.value) })
    }

    /// The expansion for a whole contact of radius a, if its truncation error is at most the rounding error.
    pub(crate) fn pressure_terms(&self, a: f64) -> Option<Expansion> {
        // The curve uses squares of lengths.
        let segment = self.expandable(a).filter(|_| (a * a).is_normal())?;
        let mut evaluations = 0;
        for count in JUDGED {
            let expansion = segment.expand(count, a, GUARDS)?;
            evaluations += expansion.evaluations;
            let middle = expansion.at(0.5 * a);
            if middle.left_out <= middle.doubt {
                return Some(Expansion { evaluations, ..expansion });
            }
        }
        None
    }

    /// The only segment, if it is odd and smooth from the axis to a.
    fn expandable(&self, a: f64) -> Option<&NumericSegment> {
        let [segment] = self.segments.as_slice() else { return None };
        let whole = segment.lower.value == 0.0 && segment.upper.is_none_or(|upper| upper.value - upper.error >= a);
        let near = segment.limit.as_ref().is_some_and(|limit| a > NEAR_THE_LIMIT * limit.value.value);
        (whole && !near && segment.odd && !segment.singular).then_some(segment)
    }
}

/// f′ = r Σ c_k P_k(2r²/a² − 1) on [0, a].
pub(crate) struct Expansion {
    a: f64,
    rule: Arc<Rule>,
    coefficients: Vec<f64>,
    /// Bounds on the errors of f′/r at the nodes.
    errors: Vec<f64>,
    /// The largest |f′/r| at a node.
    scale: f64,
    /// The truncation error of the sum, from terms beyond the last and from values between nodes.
    missing: f64,
    pub(crate) evaluations: u64,
}

/// p(s)·π/E* from one expansion.
pub(crate) struct PressureSum {
    pub(crate) value: f64,
    /// Bound on the effect of rounding.
    pub(crate) doubt: f64,
    /// Bound on the truncation error of the expansion.
    pub(crate) left_out: f64,
}

impl Expansion {
    /// The pressure at s, with the weight of every value of f′ in it.
    pub(crate) fn at(&self, s: f64) -> PressureSum {
        let a = self.a;
        // Use dimensionless ratios: the product of two lengths may leave the range of doubles.
        let sine = (((a - s) / a) * ((a + s) / a)).sqrt();
        let own = pressures(self.coefficients.len(), s / a, sine);
        let value: f64 = self.coefficients.iter().zip(&own.values).map(|(c, p)| c * p).sum();
        let noise: f64 = self.errors.iter().enumerate().map(|(i, error)| self.rule.share_of(i, &own.values).abs() * error).sum();
        let weight: f64 = own.values.iter().map(|p| p.abs()).sum();
        let sums = self.coefficients.iter().zip(&own.sizes).enumerate();
        let rounding: f64 = sums.map(|(k, (c, size))| 8.0 * (k as f64 + 2.0) * c.abs() * size).sum();
        let doubt = a * (noise + UNIT * (8.0 * self.scale * weight + rounding));
        let largest = own.values.iter().fold(0.0, |most: f64, p| if p.abs() > most { p.abs() } else { most });
        PressureSum { value: a * value, doubt: doubt * (1.0 + 8.0 * UNIT), left_out: a * self.missing * largest }
    }

    /// b_j with dg/dx² = Σ b_j P_j(2x²/a² − 1).
    pub(crate) fn rise(&self) -> Vec<f64> {
        rise(&self.coefficients)
    }

    /// The error of p(s) relative to 2√(a² − s²), at points given by √(1 − s²/a²).
    pub(crate) fn relative_doubt(&self, sine: f64) -> f64 {
        let found = self.at(self.a * ((1.0 - sine) * (1.0 + sine)).sqrt());
        (found.doubt + found.left_out) / (2.0 * self.a * sine)
    }
}

impl NumericSegment {
    /// The smallest number of terms with a negligible truncation error of f′/r for all contact radii from `low` to `high`.
    fn terms_that_suffice(&self, low: f64, high: f64) -> Option<Known> {
        /// Half-widths of the ellipses.
        const SIGMAS: [f64; 8] = [3.2, 2.4, 1.8, 1.3, 0.95, 0.7, 0.5, 0.35];
        /// A fraction of the largest value far below the rounding error.
        const NOTHING: f64 = 0.05 * f64::EPSILON;
        if !self.f_prime.is_expression() {
            return None;
        }
        let size = [0.3, 0.6, 0.95].map(|share| (self.f_prime.plain(share * low) / (share * low)).abs());
        let size = size.into_iter().filter(|size| size.is_finite()).fold(0.0, f64::max);
        let extent = Extent::new(0.0, high, None);
        let mut slots = Vec::new();
        let bounds: Vec<(f64, f64)> = SIGMAS
            .into_iter()
            .filter_map(|sigma| {
                // The factor accounts for the division by |r|/a on the ellipse.
                let (region, factor) = self.around(low, &extent, sigma, false)?;
                let largest = self.largest_f_prime(region, &mut slots) * factor / low;
                (largest * (1.0 + 1e-9) < f64::INFINITY).then_some((sigma, largest * (1.0 + 1e-9)))
            })
            .collect();
        COUNTS.into_iter().enumerate().find_map(|(rule, count)| {
            let left_out = bounds.iter().map(|(sigma, largest)| left_out(count, *sigma, *largest)).fold(f64::INFINITY, f64::min);
            (left_out <= NOTHING * size).then_some(Known { rule, left_out })
        })
    }

    /// The expansion with the given number of terms; `None` if f′ is not finite.
    fn expand(&self, count: usize, a: f64, guarded: usize) -> Option<Expansion> {
        let rule = rule(count, 0.0);
        let lowest = rule.nodes().first()?.unit;
        let guards = guards(lowest);
        let all = count + guarded;
        let mut units = [0.0; MOST_NODES];
        units.iter_mut().zip(rule.nodes().iter().map(|node| node.unit).chain(guards)).for_each(|(slot, unit)| *slot = unit);
        // f′/r at the nodes and at the guards, with bounds.
        let (mut values, mut errors) = ([0.0; MOST_NODES], [0.0; MOST_NODES]);
        let mut scratch = Scratch::take();
        let blocks = values[..all].chunks_mut(BLOCK).zip(errors[..all].chunks_mut(BLOCK)).zip(units[..all].chunks(BLOCK));
        for ((values, errors), units) in blocks {
            let (mut radii, mut doubts) = ([0.0; BLOCK], [0.0; BLOCK]);
            for ((r, doubt), unit) in radii.iter_mut().zip(&mut doubts).zip(units) {
                *r = (a * unit.sqrt()).max(f64::MIN_POSITIVE);
                *doubt = 4.0 * UNIT * *r;
            }
            self.f_prime.block(&radii[..units.len()], &doubts[..units.len()], values, errors, &mut scratch);
            for ((value, error), r) in values.iter_mut().zip(errors).zip(radii) {
                *value /= r;
                *error = *error / r + 6.0 * UNIT * value.abs();
            }
        }
        let (values, seen) = values[..all].split_at(count);
        let (errors, seen_errors) = errors[..all].split_at(count);
        let scale = values.iter().fold(0.0, |most: f64, v| if v.abs() > most { v.abs() } else { most });
        let doubts = errors.iter().fold(0.0, |most: f64, e| if *e <= most { most } else { *e });
        if !(scale.is_finite() && doubts.is_finite() && values.iter().all(|v| v.is_finite())) {
            return None;
        }
        let coefficients = rule.coefficients(values);
        // The rounding error of every coefficient is about this.
        let plateau = 2.0 * doubts + 8.0 * UNIT * scale;
        // Without guards, the caller provides the truncation error.
        let missing =
            if guarded == 0 { 0.0 } else { tail(&coefficients, plateau) + missed(&coefficients, &guards, seen, seen_errors, plateau) };
        Some(Expansion { a, rule, coefficients, errors: errors.to_vec(), scale, missing, evaluations: all as u64 })
    }
}

/// A bound on the coefficients beyond `count` terms and on the errors of the rule, for |f′/r| ≤ `largest` in the ellipse.
fn left_out(count: usize, sigma: f64, largest: f64) -> f64 {
    let rho = (2.0 * sigma).exp();
    let q = 1.0 / rho;
    let front = largest * rho.hypot(q) / (rho * (1.0 - q * q));
    // Σ_{j ≥ m} (2j + 1) q^j.
    let from = |m: usize| q.powf(m as f64) * ((2 * m + 1) as f64 / (1.0 - q) + 2.0 * q / (1.0 - q).powi(2));
    let mixed: f64 = (0..count).map(|k| (2 * k + 1) as f64 * from(2 * count - k)).sum();
    front * (from(count) + mixed) * (1.0 + 1e-9)
}

/// The estimated sum of the neglected coefficients, from the decrease of the last ones.
fn tail(coefficients: &[f64], plateau: f64) -> f64 {
    let group = |back: usize| {
        let end = coefficients.len().saturating_sub(back * GROUP);
        let own = coefficients.get(end.saturating_sub(GROUP)..end).unwrap_or_default();
        own.iter().fold(0.0, |most: f64, c| if c.abs() > most { c.abs() } else { most })
    };
    let (last, middle, first) = (group(0), group(1), group(2));
    let fall = |now: f64, before: f64| if now <= plateau { 0.0 } else { now / before.max(plateau) };
    let rate = fall(last, middle).max(fall(middle, first)).max(LEAST_FALL);
    if rate >= 0.9 { f64::INFINITY } else { 10.0 * last / (1.0 - rate) * rate.max(last / last.max(plateau) * LEAST_FALL) }
}

/// r²/a² of the guards: near the axis below the first node, and between nodes above.
fn guards(lowest: f64) -> [f64; GUARDS] {
    let near = |part: f64| part * part * lowest;
    [near(0.55), near(0.2), near(0.07), near(1e-6), 0.618, 1.0 - 0.4 * lowest]
}

/// The deviation of the expansion from f′/r at the guards.
fn missed(coefficients: &[f64], units: &[f64; GUARDS], seen: &[f64], errors: &[f64], plateau: f64) -> f64 {
    let basis = Basis::new(0.0, 0.0, coefficients.len());
    let mut worst = 0.0;
    for ((unit, seen), error) in units.iter().zip(seen).zip(errors) {
        let (value, size) = basis.sum(coefficients, 2.0 * unit - 1.0);
        let off = (seen - value).abs() - error - plateau - 8.0 * coefficients.len() as f64 * UNIT * size;
        worst = if off <= worst {
            worst
        } else if off.is_nan() {
            f64::INFINITY
        } else {
            off
        };
    }
    worst
}
