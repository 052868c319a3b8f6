//! Bounds on f′ and (r f′)′ in parts of the complex plane, by tapes that are compiled for enclosures.

use crate::eval::{IntervalAlgebra, RegionAlgebra, Tape};
use crate::expr::{Expr, Node, Symbol};
use crate::integrate::integral::{NumericProfile, NumericSegment, shifted};
use crate::integrate::source::f_prime::Numbers;
use crate::integrate::source::leading_power::LeadingPower;
use crate::num::{Region, work};

/// The fraction of a range that is examined.
const NEXT_TO_THE_END: f64 = 1e-3;

impl NumericSegment {
    /// A bound on |f′| for δ in a part of the complex plane where it is analytic; else infinite.
    pub(crate) fn largest_f_prime(&self, delta: Region, slots: &mut Vec<Region>) -> f64 {
        match &self.f_prime {
            Numbers::Tape(_) => enclosed(self.enclosing(), delta, slots),
            own => own.largest(delta, slots),
        }
    }

    /// Bounds on f′ for δ between two numbers; `None` if unknown.
    fn f_prime_over(&self, from: f64, to: f64) -> Option<(f64, f64)> {
        let (delta, mut slots) = (Region::interval(from, to), Vec::new());
        let own = self.enclosing()?.run(&mut IntervalAlgebra, &[delta], &mut slots)?;
        // Magnitudes have bounds where intermediate values leave the range of doubles.
        own.real_range().or_else(|| Some(self.largest_f_prime(delta, &mut slots)).filter(|most| most.is_finite()).map(|most| (-most, most)))
    }

    /// The same for (r f′)′.
    pub(crate) fn largest_bend(&self, delta: Region, slots: &mut Vec<Region>) -> f64 {
        match self.bend() {
            Ok(Numbers::Tape(_)) => enclosed(self.enclosing_bend(), delta, slots),
            Ok(own) => own.largest(delta, slots),
            Err(_) => f64::INFINITY,
        }
    }

    /// f′ over δ for enclosures; `None` if f′ is not an expression.
    fn enclosing(&self) -> Option<&Tape> {
        let tape = self.enclosing.get_or_init(|| {
            work::prepared(|| {
                let ((f_prime, lower), delta) = (self.source.as_ref()?, Symbol::new("δ"));
                Tape::for_enclosures(&[shifted(f_prime, lower, &Expr::from(delta.clone()))], &[delta]).ok()
            })
        });
        tape.as_ref()
    }

    /// The leading power of f′, if its enclosures near the lower end of a range up to x are unbounded.
    pub(crate) fn power_for(&self, x: f64) -> Option<&LeadingPower> {
        let unbounded = || !self.largest_f_prime(Region::interval(0.0, NEXT_TO_THE_END * x), &mut Vec::new()).is_finite();
        if self.singular || (self.lower.value == 0.0 && unbounded()) { self.leading_power() } else { None }
    }

    /// The leading power at the axis: `known`, or the one of an f′ that contains a fractional power of r.
    pub(crate) fn fractional_power<'a>(&'a self, known: Option<&'a LeadingPower>) -> Option<&'a LeadingPower> {
        if self.may_have_root() { known.or_else(|| self.leading_power()) } else { known.filter(|_| self.begins_at_axis()) }
    }

    fn begins_at_axis(&self) -> bool {
        self.lower.value == 0.0 && self.lower.error == 0.0
    }

    fn may_have_root(&self) -> bool {
        self.begins_at_axis() && self.source.as_ref().is_some_and(|(f_prime, _)| has_root(f_prime))
    }

    /// The leading power of (r f′)′, if its enclosures near the lower end of a range up to x are unbounded.
    pub(crate) fn power_of_bend_for(&self, x: f64) -> Option<&LeadingPower> {
        let unbounded = || !self.largest_bend(Region::interval(0.0, NEXT_TO_THE_END * x), &mut Vec::new()).is_finite();
        if self.singular || (self.lower.value == 0.0 && unbounded()) { self.leading_power_of_bend() } else { None }
    }

    /// The leading power of (r f′)′ at the axis, as [`Self::fractional_power`] for f′.
    pub(crate) fn fractional_power_of_bend<'a>(&'a self, known: Option<&'a LeadingPower>) -> Option<&'a LeadingPower> {
        if self.may_have_root() { known.or_else(|| self.leading_power_of_bend()) } else { known.filter(|_| self.begins_at_axis()) }
    }

    /// The leading power s > −1 of f′ at its lower end, and h = f′/δ^s for enclosures; `None` if unknown.
    pub(crate) fn leading_power(&self) -> Option<&LeadingPower> {
        let power = self.power.get_or_init(|| {
            work::prepared(|| {
                let (f_prime, lower) = self.source.as_ref()?;
                leading_power(f_prime, lower)
            })
        });
        power.as_ref()
    }

    /// The same for (r f′)′.
    pub(crate) fn leading_power_of_bend(&self) -> Option<&LeadingPower> {
        let power = self.bend_power.get_or_init(|| {
            work::prepared(|| {
                let (_, lower) = self.source.as_ref()?;
                leading_power(&self.bend_source()?, lower)
            })
        });
        power.as_ref()
    }

    /// (r f′)′ over δ for enclosures.
    fn enclosing_bend(&self) -> Option<&Tape> {
        let tape = self.bend_enclosing.get_or_init(|| {
            work::prepared(|| {
                let ((_, lower), delta) = (self.source.as_ref()?, Symbol::new("δ"));
                Tape::for_enclosures(&[shifted(&self.bend_source()?, lower, &Expr::from(delta.clone()))], &[delta]).ok()
            })
        });
        tape.as_ref()
    }
}

impl NumericProfile {
    /// Bounds on f′ between two radii that have no breakpoint between them; `None` if unknown.
    pub(crate) fn f_prime_over(&self, lower: f64, upper: f64) -> Option<(f64, f64)> {
        let reaches = |own: &&NumericSegment| own.lower.value < upper && own.upper.is_none_or(|end| end.value > lower);
        sum_of_ranges(self.segments.iter().filter(reaches).map(|own| {
            let start = own.lower.value;
            let (from, to) = (lower - start, upper - start);
            if start == 0.0 { own.f_prime_over(from, to) } else { own.f_prime_over(from.next_down().max(0.0), to.next_up()) }
        }))
    }

    /// Numbers s > −1 and M such that |f′| ≤ M r^s from the axis to a radius that no breakpoint precedes; `None` if unknown.
    pub(crate) fn power_at_axis(&self, radius: f64) -> Option<(f64, f64)> {
        let (near, mut slots) = (Region::interval(0.0, radius), Vec::new());
        let powers = self.segments.iter().filter(|own| own.lower.value < radius).map(|own| {
            let plain = (0.0, own.largest_f_prime(near, &mut slots));
            let power = if plain.1.is_finite() { None } else { own.leading_power() };
            let (s, most) = power.map_or(plain, |power| (power.exponent, power.rest_over(near, &mut slots)));
            most.is_finite().then_some((s, most))
        });
        sum_of_powers(powers, radius)
    }
}

/// Bounds on a sum from bounds on its terms, rounded outwards; `None` if one is unknown.
pub(crate) fn sum_of_ranges(ranges: impl Iterator<Item = Option<(f64, f64)>>) -> Option<(f64, f64)> {
    let sum = |one: (f64, f64), other: (f64, f64)| ((one.0 + other.0).next_down(), (one.1 + other.1).next_up());
    ranges.reduce(|one, other| Some(sum(one?, other?))).unwrap_or(Some((0.0, 0.0)))
}

/// Numbers s and M such that a sum is at most M r^s up to a radius, from such numbers for its terms; `None` if one is unknown.
pub(crate) fn sum_of_powers(powers: impl Iterator<Item = Option<(f64, f64)>>, radius: f64) -> Option<(f64, f64)> {
    let sum = |(s, most): (f64, f64), (power, own): (f64, f64)| {
        let least = s.min(power);
        (least, most * radius.powf(s - least) + own * radius.powf(power - least))
    };
    powers.reduce(|one, other| Some(sum(one?, other?))).unwrap_or(Some((0.0, 0.0)))
}

/// A bound on the magnitude by a tape for enclosures.
fn enclosed(tape: Option<&Tape>, delta: Region, slots: &mut Vec<Region>) -> f64 {
    tape.and_then(|tape| tape.run(&mut RegionAlgebra, &[delta], slots)).map_or(f64::INFINITY, Region::largest)
}

/// True for an expression with a fractional power of r itself.
fn has_root(expr: &Expr) -> bool {
    match expr.node() {
        Node::Power(base, exponent) => {
            let is_fraction = || exponent.as_number().is_some() && exponent.as_integer().is_none();
            (base.as_symbol().is_some_and(|symbol| symbol.name() == "r") && is_fraction()) || has_root(base) || has_root(exponent)
        }
        Node::Function(_, list) | Node::Product(list) | Node::Sum(list) => list.iter().any(has_root),
        Node::Number(_) | Node::Constant(_) | Node::Symbol(_) => false,
    }
}

fn leading_power(function: &Expr, lower: &Expr) -> Option<LeadingPower> {
    let delta = Symbol::new("δ");
    LeadingPower::of(&shifted(function, lower, &Expr::from(delta.clone())), &delta)
}
