//! f′ near the axis if its expression is 0/0 there: from the power series of f, with a bound of the truncation error.
//!
//! The slope of (1 − e^(−r))/r is an expression in which terms 1/r² cancel, so that all digits are lost at small r. f has a power
//! series with a proven remainder, whose derivative is f′ without cancellation. Away from the axis the expression is accurate.

use crate::integrate::integral::{NumericProfile, NumericSegment, compile_shifted, is_singular};
use crate::integrate::source::f_prime::{Numbers, Scratch, rescue_block, rescued};

use crate::eval::{BlockInput, BoundedAlgebra, FloatAlgebra, RegionAlgebra, RoundingAlgebra, Series, Tape, power_series};
use crate::expr::{Expr, Node, Number, Sign, Symbol, leading_term, multiplied_out, sign};
use crate::num::{Bounded, Region, work};

/// Number of coefficients.
const LENGTH: usize = 48;
/// Number of coefficients that an enclosure sums as regions; the others, which cancel little where the series is used, are summed
/// as magnitudes.
const HEAD: usize = 12;
/// Steps of work of such a sum.
const HEAD_STEPS: u64 = 150;
/// Exponents of the radii ρ to try first, as powers of 16.
const SCALES: std::ops::RangeInclusive<i32> = -25..=25;
/// Number of steps between the best radius and the next.
const BETWEEN: i32 = 16;
/// Fractions of ρ up to which the series may be used; below 1/2 the bound of the remainder decreases with the order.
const SHARES: [f64; 5] = [0.45, 0.37, 0.3, 0.2, 0.1];
/// Largest truncation error, relative to f′ at the upper end of the series.
const LEFT_OUT: f64 = 0.03 * f64::EPSILON;
/// Radii at which the expression must be accurate, in units of the length of the segment; powers far below 1 detect underflow.
const TRIALS: [f64; 4] = [1e-3, 1e-6, 1e-12, 1e-160];
/// Relative error above which a value counts as inaccurate.
const POOR: f64 = 1e-11;

/// f′, or (r f′)′, from its expression beyond a radius and from its series below.
pub(crate) struct Removable {
    tape: Tape,
    near: AxisSeries,
}

/// Σ r^power (c₀ + c₁ r + …), for 0 < r ≤ `until`.
#[derive(Clone, Debug)]
pub(crate) struct AxisSeries {
    groups: Vec<Group>,
    until: f64,
}

#[derive(Clone, Debug)]
struct Group {
    power: f64,
    /// The remainder of the power, a fraction that is not representable as a double.
    fraction: Number,
    coefficients: Vec<Bounded>,
    /// The truncation error is at most this times r^(power + number of coefficients).
    rest: f64,
}

/// True if an expression divides by a term that may vanish at the axis, and is inaccurate or has no enclosure there.
pub(crate) fn is_ragged(f_prime: &Expr, tape: &Tape, singular: bool, scale: f64) -> bool {
    let radius = Symbol::new("r");
    let divisor = |own: &Expr| match own.node() {
        Node::Power(base, exponent) if sign(exponent) != Sign::Positive && base.contains(&radius) => Some(base.clone()),
        _ => None,
    };
    let divisors: Vec<Expr> = f_prime.parts().filter_map(divisor).collect();
    if divisors.is_empty() {
        return false;
    }
    // An expression that is regular at the axis although its parts are not has no enclosure.
    let around = Region::new((-TRIALS[0] * scale, TRIALS[0] * scale), (0.0, 0.0));
    if !singular
        && one_may_vanish(&divisors, &radius)
        && !tape.run(&mut RegionAlgebra, &[around], &mut Vec::new()).is_some_and(|own| own.largest().is_finite())
    {
        return true;
    }
    let mut slots = Vec::new();
    TRIALS.iter().any(|share| {
        let own = tape.run(&mut BoundedAlgebra, &[Bounded::exact(share * scale)], &mut slots).unwrap_or(Bounded::exact(f64::NAN));
        // Underflow does not count as inaccurate, but NaN does.
        let poor = own.error > (POOR * own.value.abs()).max(1e-290);
        poor || !own.value.is_finite() || own.error.is_nan()
    })
}

/// Returns false if the value of every expression at r = 0 is finite and differs from 0 by more than its error.
///
/// If the value does not exist, as for r ln r, the value near the axis decides: it must not be small relative to one further
/// away.
fn one_may_vanish(expressions: &[Expr], radius: &Symbol) -> bool {
    const NEAR: f64 = 1e-30;
    let Ok(tape) = Tape::compile(expressions, std::slice::from_ref(radius)) else { return true };
    let values = |r: f64| tape.run_all(&mut BoundedAlgebra, &[Bounded::exact(r)], &mut Vec::new()).unwrap_or_default();
    let (at_axis, near, far) = (values(0.0), values(NEAR), values(TRIALS[0]));
    let is_small = |own: &Bounded, least: f64| own.value.abs() <= own.error.max(least);
    (0..expressions.len()).any(|index| {
        let known = |list: &[Bounded]| list.get(index).copied().filter(|own| own.is_finite());
        match (known(&at_axis), known(&near), known(&far)) {
            (Some(own), ..) => is_small(&own, 0.0),
            (None, Some(near), Some(far)) => is_small(&near, TRIALS[0] * far.value.abs()),
            _ => true,
        }
    })
}

impl AxisSeries {
    /// f′ of an f in r alone that is finite at the axis; `None` if no series of f is found.
    pub(crate) fn of(piece: &Expr) -> Option<Self> {
        // Sums within a product must not contain powers that differ by a fraction.
        Self::of_sum(piece).or_else(|| Self::of_sum(&multiplied_out(piece)))
    }

    fn of_sum(piece: &Expr) -> Option<Self> {
        let radii: Vec<f64> = SCALES.map(|k| f64::from(4 * k).exp2()).collect();
        let groups = series(piece, &radii)?;
        let (first, rho) = radii.iter().enumerate().rev().find_map(|(index, rho)| Some((Self::at(&groups, index, *rho)?, *rho)))?;
        let radii: Vec<f64> = (1..BETWEEN).map(|i| rho * (4.0 * f64::from(i) / f64::from(BETWEEN)).exp2()).collect();
        let finer = series(piece, &radii).and_then(|groups| {
            let all = radii.iter().enumerate().filter_map(|(index, rho)| Self::at(&groups, index, *rho));
            all.max_by(|a, b| a.until.total_cmp(&b.until))
        });
        Some(finer.filter(|own| own.until > first.until).unwrap_or(first))
    }

    /// The derivative of the series, with the bound at one of the radii, if its truncation error is small enough.
    fn at(groups: &[(Number, Series)], index: usize, rho: f64) -> Option<Self> {
        let derive = |(fraction, group): &(Number, Series)| Group::derived(fraction, group, *group.rest.get(index)?, rho);
        let derived = groups.iter().map(derive).collect::<Option<Vec<_>>>()?;
        SHARES.iter().find_map(|share| {
            let own = Self { groups: derived.clone(), until: share * rho };
            let left_out: f64 = own.groups.iter().map(|group| group.left_out(own.until)).sum();
            let size = own.value(Bounded::exact(own.until)).value.abs();
            (own.until.is_normal() && size.is_normal() && left_out <= LEFT_OUT * size).then_some(own)
        })
    }

    /// True if a power of r is fractional, so that f′ is not analytic at the axis.
    pub(crate) fn has_fractions(&self) -> bool {
        self.groups.iter().any(|group| group.whole_power().fract() != 0.0)
    }

    /// Returns true if the series has odd powers of r only.
    fn is_odd(&self) -> bool {
        let none = |own: &Bounded| own.value == 0.0 && own.error == 0.0;
        let is_odd = |power: f64| (0.5 * (power + 1.0)).fract() == 0.0;
        let odd = |group: &Group| group.coefficients.iter().enumerate().all(|(n, own)| none(own) || is_odd(group.whole_power() + n as f64));
        self.groups.iter().all(odd)
    }

    /// (r f′)′ from f′.
    fn bend(&self) -> Self {
        let groups = self.groups.iter().map(|group| {
            let factor = |n: usize| exponent(&group.fraction, group.power + 1.0 + n as f64);
            let coefficients = group.coefficients.iter().enumerate().map(|(n, own)| *own * factor(n)).collect();
            // Beyond the included terms, the factor grows more slowly than the powers of 1/2 decrease.
            Group { coefficients, rest: group.rest * 2.0 * factor(LENGTH).value, ..group.clone() }
        });
        Self { groups: groups.collect(), until: self.until }
    }

    fn value(&self, r: Bounded) -> Bounded {
        self.groups.iter().fold(Bounded::exact(0.0), |sum, group| {
            let own = group.coefficients.iter().rev().fold(Bounded::exact(0.0), |sum, c| sum * r + *c) * group.factor(r);
            sum + Bounded { error: own.error + group.left_out(r.value + r.error), ..own }
        })
    }

    fn plain(&self, r: f64) -> f64 {
        let value = |group: &Group| group.coefficients.iter().rev().fold(0.0, |sum, c| sum * r + c.value) * r.powf(group.whole_power());
        self.groups.iter().map(value).sum()
    }

    /// A bound on |f′| in a part of the disc; `None` outside.
    fn largest(&self, r: Region) -> Option<f64> {
        let size = r.largest();
        if size > self.until {
            return None;
        }
        let around = |own: &Bounded| Region::new(((own.value - own.error).next_down(), (own.value + own.error).next_up()), (0.0, 0.0));
        work::spend(HEAD_STEPS * self.groups.len() as u64);
        let mut total = 0.0;
        for group in &self.groups {
            let (head, tail) = group.coefficients.split_at(HEAD.min(group.coefficients.len()));
            let sum = head.iter().rev().fold(Region::real(0.0), |sum, c| sum * r + around(c));
            let beyond = tail.iter().rev().fold(0.0, |sum, c| sum * size + (c.value.abs() + c.error)) * size.powi(HEAD as i32);
            let most = (sum.largest() + beyond).next_up();
            total += most * r.power(Region::real(group.whole_power())).largest() + group.left_out(size);
        }
        // The magnitudes have at most 50 rounding errors.
        Some(total * (1.0 + 1e-13))
    }
}

/// The series of the terms, grouped by the fractional parts of powers of r that are not representable as doubles.
fn series(piece: &Expr, radii: &[f64]) -> Option<Vec<(Number, Series)>> {
    let mut parts: Vec<(Number, Vec<Expr>)> = Vec::new();
    for term in piece.terms() {
        let (fraction, rest) = split_fraction(&term);
        match parts.iter_mut().find(|(known, _)| *known == fraction) {
            Some((_, list)) => list.push(rest),
            None => parts.push((fraction, vec![rest])),
        }
    }
    let mut all = Vec::new();
    for (fraction, list) in parts {
        let whole = Expr::sum(list);
        let mut groups = power_series(&whole, LENGTH, radii).ok()?;
        if let ([only], Some(order)) = (groups.as_mut_slice(), leading_term(&whole).map(|term| term.exponent.to_f64())) {
            // The coefficient vanishes exactly, although the numbers that cancel are rounded.
            let below = only
                .coefficients
                .iter_mut()
                .enumerate()
                .filter(|(n, own)| only.shift + (*n as f64) < order - 0.5 && own.value.abs() <= own.error);
            below.for_each(|(_, own)| *own = Bounded::exact(0.0));
        }
        all.extend(groups.into_iter().map(|group| (fraction.clone(), group)));
    }
    Some(all)
}

/// The fractional part of a power of r that is a factor, and the term without it; 0 for powers representable as doubles.
fn split_fraction(term: &Expr) -> (Number, Expr) {
    let radius = Symbol::new("r");
    let (mut fraction, mut rest) = (Number::integer(0), Vec::new());
    for factor in term.factors() {
        let (base, exponent) = factor.split_power();
        match exponent.as_number() {
            Some(own) if base.as_symbol() == Some(&radius) && !own.is_exact_f64() => {
                let whole = Number::integer(own.to_f64().floor() as i64);
                fraction = &fraction + &(own - &whole);
                rest.push(base.pow(&Expr::number(whole)));
            }
            // (1 − cos r)^(3/5) is r^(6/5) times a power of a function that is nonzero at the axis.
            Some(own) if base.contains(&radius) && !own.is_exact_f64() => match leading_term(&base).map(|term| term.exponent) {
                Some(order) if !order.is_zero() => {
                    let power = &order * own;
                    let whole = Number::integer(power.to_f64().floor() as i64);
                    fraction = &fraction + &(&power - &whole);
                    let freed = multiplied_out(&(&base * Expr::from(radius.clone()).pow(&-Expr::number(order))));
                    rest.push(Expr::from(radius.clone()).pow(&Expr::number(whole)));
                    rest.push(freed.pow(&exponent));
                }
                _ => rest.push(factor),
            },
            _ => rest.push(factor),
        }
    }
    (fraction, Expr::product(rest))
}

/// A power: a double and a fraction.
fn exponent(fraction: &Number, power: f64) -> Bounded {
    if fraction.is_zero() { Bounded::exact(power) } else { Bounded::rounded(fraction.to_f64()) + Bounded::exact(power) }
}

impl Group {
    /// The derivative of r^shift Σ A_n r^n, where Σ |A_n| ρ^n ≤ `most` over n ≥ 1.
    fn derived(fraction: &Number, own: &Series, most: f64, rho: f64) -> Option<Self> {
        if !most.is_finite() {
            return None;
        }
        let mut coefficients = Vec::with_capacity(LENGTH);
        for (n, coefficient) in own.coefficients.iter().enumerate().take(LENGTH) {
            let nu = exponent(fraction, own.shift + n as f64);
            let power = nu.value;
            // f is finite at the axis, so the coefficient of a pole is 0, which must be recognized.
            let vanishes = power <= 0.0;
            if power < 0.0 && coefficient.value.abs() > coefficient.error {
                return None;
            }
            coefficients.push(if vanishes { Bounded::exact(0.0) } else { *coefficient * nu });
        }
        let order = coefficients.len() as f64;
        if coefficients.len() < LENGTH || order + own.shift < 8.0 {
            return None;
        }
        // |A_n| ≤ most/ρⁿ, and Σ (n + s) q^n |A_n| ρ^n ≤ most · max (n + s) q^n, which is the first for q ≤ 1/2.
        let rest = most * (order + own.shift + 1.0) * rho.powf(-order) * (1.0 + 1e-9);
        // Move the leading zeros into the power to avoid underflow.
        let zeros = coefficients.iter().take_while(|own| own.value == 0.0 && own.error == 0.0).count().min(LENGTH - 1);
        coefficients.drain(..zeros);
        (rest.is_finite()).then_some(Self { power: own.shift - 1.0 + zeros as f64, fraction: fraction.clone(), coefficients, rest })
    }

    fn whole_power(&self) -> f64 {
        self.power + self.fraction.to_f64()
    }

    /// The leading power of r.
    fn factor(&self, r: Bounded) -> Bounded {
        let whole = if self.power == 0.0 { Bounded::exact(1.0) } else { r.powf(Bounded::exact(self.power)) };
        if self.fraction.is_zero() { whole } else { whole * r.powf(Bounded::rounded(self.fraction.to_f64())) }
    }

    fn left_out(&self, r: f64) -> f64 {
        self.rest * r.powf(self.whole_power() + self.coefficients.len() as f64) * (1.0 + 1e-12)
    }
}

impl Removable {
    /// f′ by its tape away from the axis.
    pub(crate) fn f_prime(tape: Tape, near: &AxisSeries) -> Self {
        Self { tape, near: near.clone() }
    }

    /// (r f′)′ by its tape away from the axis.
    pub(crate) fn bend(tape: Tape, near: &AxisSeries) -> Self {
        Self { tape, near: near.bend() }
    }

    fn is_near(&self, r: f64) -> bool {
        r <= 0.999 * self.near.until
    }

    pub(crate) fn at(&self, r: Bounded, slots: &mut Vec<Bounded>) -> Option<Bounded> {
        if self.is_near(r.value) {
            return Some(self.near.value(r));
        }
        self.tape.run(&mut BoundedAlgebra, &[r], slots).map(|own| rescued(&self.tape, r, own))
    }

    pub(crate) fn near_by(&self, r: Bounded, slots: &mut Vec<Bounded>) -> Option<Bounded> {
        if !self.is_near(r.value) {
            return self.tape.run(&mut RoundingAlgebra, &[r], slots);
        }
        // Every operation of the scheme is counted, even if it is exact here.
        let size: f64 = self.near.groups.iter().map(|group| group.size(r.value)).sum();
        let own = self.near.value(r);
        Some(Bounded { error: own.error + 4.0 * f64::EPSILON * size, ..own })
    }

    pub(crate) fn plain(&self, r: f64) -> Option<f64> {
        if self.is_near(r) {
            return Some(self.near.plain(r));
        }
        let own = self.tape.run(&mut FloatAlgebra, &[r], &mut Vec::new())?;
        Some(rescued(&self.tape, Bounded::exact(r), Bounded::exact(own)).value)
    }

    /// Values with their bounds at many points.
    pub(crate) fn block(&self, radii: &[f64], doubts: &[f64], values: &mut [f64], errors: &mut [f64], scratch: &mut Scratch) -> Option<()> {
        self.tape.run_block_bounded(&[BlockInput { values: radii, errors: doubts }], values, errors, scratch.room())?;
        for (((value, error), r), doubt) in
            values.iter_mut().zip(errors.iter_mut()).zip(radii).zip(doubts).filter(|(((_, _), r), _)| self.is_near(**r))
        {
            let own = self.near.value(Bounded { value: *r, error: *doubt });
            (*value, *error) = (own.value, own.error);
        }
        rescue_block(&self.tape, radii, doubts, values, errors);
        Some(())
    }

    /// A bound on the magnitude in a part of the complex plane.
    pub(crate) fn largest(&self, r: Region, slots: &mut Vec<Region>) -> f64 {
        match self.near.largest(r) {
            Some(own) => own,
            None => self.tape.run(&mut RegionAlgebra, &[r], slots).map_or(f64::INFINITY, Region::largest),
        }
    }
}

impl Group {
    /// Σ |c| r^n.
    fn size(&self, r: f64) -> f64 {
        self.coefficients.iter().rev().fold(0.0, |sum, c| sum * r + c.value.abs()) * r.powf(self.whole_power())
    }
}

impl NumericProfile {
    /// True if an expression is 0/0 at the axis and has no series there.
    pub(crate) fn is_ragged(&self) -> bool {
        self.segments.iter().any(|segment| segment.ragged && segment.near.is_none())
    }

    /// True if a series replaces an inaccurate expression near the axis.
    pub(crate) fn is_mended(&self) -> bool {
        self.segments.iter().any(|segment| segment.near.is_some())
    }

    /// Adds a series near the axis if the expressions are 0/0 there; `whole` returns f, in r alone, for a given
    /// slope.
    pub(crate) fn mended(mut self, whole: impl Fn(&Expr) -> Option<Expr>) -> Self {
        let begins = |own: &NumericSegment| own.lower.value == 0.0;
        for segment in self.segments.iter_mut().filter(|own| own.ragged && begins(own)) {
            let Some((f_prime, lower)) = &segment.source else { continue };
            let Some(near) = whole(f_prime).and_then(|f| AxisSeries::of(&f)) else { continue };
            let Ok(tape) = compile_shifted(f_prime, lower) else { continue };
            segment.f_prime = Numbers::Removable(Box::new(Removable::f_prime(tape, &near)));
            segment.singular = near.has_fractions() || is_singular(&segment.f_prime, 0.0, segment.upper.map(|upper| upper.value));
            // The parity of the expression is unknown if it contains a root that vanishes at the axis.
            segment.odd = near.is_odd();
            segment.near = Some(near);
        }
        self
    }

    /// True if a series is used near the axis but is not analytic there.
    pub(crate) fn is_fractional(&self) -> bool {
        self.segments.iter().any(|segment| segment.near.as_ref().is_some_and(AxisSeries::has_fractions))
    }
}
