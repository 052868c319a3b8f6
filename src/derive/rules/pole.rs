//! Integrals of powers of w ± r over √(x²−r²), shared by the linear families.

use super::combination::{Combination, Form};
use crate::derive::domain::above_zero::above_zero;
use crate::derive::domain::decided::decided_for_all;
use crate::expr::{Condition, Expr, Relation, Sign, sign};
use crate::integrate::segment::Segment;
use std::cell::RefCell;

/// A zero of w + r below the segment (w may be negative), or of w − r above it.
pub(super) struct Pole {
    /// w.
    pub(super) w: Expr,
    /// True for w − r.
    pub(super) above: bool,
    /// True for half-odd exponents.
    pub(super) half: bool,
    /// The moments computed so far; shown and evaluated forms often share one.
    known: RefCell<Vec<(Moment, Combination)>>,
}

/// The arguments that determine a moment.
#[derive(PartialEq, Eq)]
struct Moment {
    m: i64,
    n: i64,
    end: Expr,
    x: Expr,
    reach: Reach,
    /// True if levels above 1 are numerators over a common denominator.
    lifted: bool,
}

/// The kind of integral that a basis represents.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Reach {
    /// From an end e to x.
    ToRim,
    /// An antiderivative, used only for differences between ends below x.
    Between,
}

/// Levels up to this one are evaluated without a common denominator.
const GENTLE: i64 = 4;
/// Functions in a basis.
const LENGTH: usize = 4;

impl Pole {
    /// The pole of α + βr relative to the segment, with its conditions; `None` if its position is not known.
    pub(super) fn new(alpha: &Expr, beta: &Expr, half: bool, segment: &Segment) -> Option<(Self, Vec<Condition>)> {
        let offset = alpha / beta;
        let mut conditions = Vec::new();
        let above = match sign(&offset) {
            Sign::Positive => false,
            Sign::Negative => match sign(&(&segment.lower + &offset)) {
                _ if segment.lower.is_zero() => true,
                Sign::Positive => false,
                Sign::Negative => true,
                Sign::Zero | Sign::Unknown => return None,
            },
            // Assume that the constant term is positive: R − b − r and R − b + r are usually meant for b < R.
            Sign::Unknown if sign(beta) != Sign::Unknown => sign(beta) == Sign::Negative,
            Sign::Unknown | Sign::Zero => return None,
        };
        let w = if above { -offset } else { offset };
        if sign(&w) == Sign::Unknown {
            conditions.push(above_zero(&w)?);
        }
        if above {
            // A root may vanish at the end of its segment.
            let relation = if half && segment.upper.is_some() { Relation::LessOrEqual } else { Relation::Less };
            let left = segment.upper.clone().unwrap_or_else(|| Expr::symbol("r"));
            conditions.push(Condition { left, relation, right: w.clone() });
        }
        conditions.retain(|condition| decided_for_all(condition) != Some(true));
        if conditions.iter().any(|condition| decided_for_all(condition) == Some(false)) {
            return None;
        }
        Some((Self { w, above, half, known: RefCell::default() }, conditions))
    }

    /// w + r or w − r at r = e.
    fn at(&self, e: &Expr) -> Expr {
        if self.above { &self.w - e } else { &self.w + e }
    }

    fn orientation(&self) -> Expr {
        Expr::integer(if self.above { -1 } else { 1 })
    }

    /// κ of the n-th level: n, or n − 1/2.
    fn exponent(&self, n: i64) -> Expr {
        if self.half { Expr::ratio(2 * n - 1, 2) } else { Expr::integer(n) }
    }

    /// L_κ = ∫ u^(−κ)/√(x²−r²) dr with u = w ± r, for the levels κ of n = lowest … highest.
    ///
    /// (κ−1) L_(κ−1) − (2κ−1) w L_κ − κ (x²−w²) L_(κ+1) = ∓√(x²−e²) u_e^(−κ), by parts; the basis is √(x²−e²) (times √u_e
    /// for half-odd κ), the integral of level 0 or its part independent of level 1, and the integral of level 1.
    /// Lifted levels are numerators over (x²−w²)^(n−1).
    fn levels(&self, lowest: i64, highest: i64, e: &Expr, x: &Expr, reach: Reach, lifted: bool) -> Vec<(i64, Combination)> {
        let unit = |i| Combination::unit(i, LENGTH);
        let (one, two, w, orientation, end) = (Expr::one(), Expr::integer(2), &self.w, self.orientation(), self.at(e));
        let difference = x.power(2) - w.power(2);
        let zeroth = match (self.half, self.above && reach == Reach::ToRim) {
            (false, _) => unit(1),
            // ∫ √(w−r) = (w−x) ∫ 1/√(w−r) + ∫ (x−r)/√(w−r); else with w+x and a minus.
            (true, true) => unit(2).times(&(w - x)).plus(&unit(1)),
            (true, false) => unit(2).times(&(w + x)).plus(&unit(1).times(&Expr::integer(-1))),
        };
        let mut list = vec![(0, zeroth.clone()), (1, unit(2))];
        let (mut above, mut here) = (unit(2), zeroth.clone());
        for n in (lowest..0).rev() {
            let kappa = self.exponent(n + 1);
            let boundary = unit(0).times(&(-&orientation * end.power(-n - 1)));
            let sum = here.times(&((&two * &kappa - &one) * w)).plus(&above.times(&(&kappa * &difference))).plus(&boundary);
            let next = sum.times(&(&kappa - &one).recip()).tidied();
            list.push((n, next.clone()));
            above = std::mem::replace(&mut here, next);
        }
        let (lift, over) = if lifted { (difference.clone(), one.clone()) } else { (one.clone(), difference.recip()) };
        let (mut below, mut here) = (zeroth, unit(2));
        for n in 2..=highest {
            let kappa = self.exponent(n - 1);
            let boundary = unit(0).times(&(&orientation * end.power(1 - n) * lift.power(n - 2)));
            let before = below.times(&((&kappa - &one) * lift.power((n - 2).min(1))));
            let sum = before.plus(&here.times(&((&one - &two * &kappa) * w))).plus(&boundary);
            let next = match sum.times(&(&over / kappa)) {
                _ if n == 2 && !lifted && self.has_second(e, reach) => unit(3),
                next if lifted => next.tidied(),
                next => next,
            };
            list.push((n, next.clone()));
            below = std::mem::replace(&mut here, next);
        }
        list
    }

    /// ∫ r^m u^(−κ)/√(x²−r²) dr with κ of level n, over [`Self::basis`].
    pub(super) fn moment(&self, m: i64, n: i64, e: &Expr, x: &Expr, reach: Reach, form: Form) -> Combination {
        // Without a common denominator the recurrence is more stable, but every level doubles the length of the formula.
        let lifted = n > 1 && (form == Form::Shown || n > GENTLE);
        let moment = Moment { m, n, end: e.clone(), x: x.clone(), reach, lifted };
        if let Some((_, found)) = self.known.borrow().iter().find(|(known, _)| *known == moment) {
            return found.clone();
        }
        let found = self.computed(&moment);
        self.known.borrow_mut().push((moment, found.clone()));
        found
    }

    fn computed(&self, moment: &Moment) -> Combination {
        let Moment { m, n, end: e, x, reach, lifted } = moment;
        let (m, n, lifted) = (*m, *n, *lifted);
        let levels = self.levels(n - m, n, e, x, *reach, lifted);
        let difference = x.power(2) - self.w.power(2);
        let lift = if lifted { difference } else { Expr::one() };
        // r = ±(u − w)
        let mut sum = Combination::zero(LENGTH);
        let mut binomial = self.orientation().power(m);
        for j in 0..=m {
            let missing = (n - 1).max(0) - (n - j - 1).max(0);
            let factor = &binomial * (-&self.w).power(m - j) * lift.power(missing);
            if let Some((_, level)) = levels.iter().find(|(own, _)| *own == n - j) {
                sum = sum.plus(&level.times(&factor));
            }
            binomial = binomial * Expr::ratio(m - j, j + 1);
        }
        if lifted || n < 2 { sum.tidied().times(&lift.power((1 - n).min(0))) } else { sum }
    }

    /// From the axis the integral of level 2 has no removable singularity at x = w.
    fn has_second(&self, e: &Expr, reach: Reach) -> bool {
        !self.half && !self.above && e.is_zero() && reach == Reach::ToRim
    }

    /// The basis of one end.
    pub(super) fn basis(&self, e: &Expr, x: &Expr, reach: Reach, form: Form) -> [Expr; LENGTH] {
        let end = self.at(e);
        let root = form.root(x, e);
        if self.half {
            let (second, first) = self.elliptic(e, x, reach);
            return [root * end.sqrt(), second, first, Expr::zero()];
        }
        let second = if self.has_second(e, reach) {
            let square = self.w.power(2);
            Expr::ratio(2, 3) * &self.w * Expr::call("elliprd", [x.power(2), square.clone(), square])
        } else {
            Expr::zero()
        };
        [root, form.arc(x, e), self.elementary(e, x, reach, form), second]
    }

    /// ∫_e 1/(w ± r)/√(x²−r²) dr by Carlson's R_C, or −∫^e if only differences are used.
    fn elementary(&self, e: &Expr, x: &Expr, reach: Reach, form: Form) -> Expr {
        let (w, two) = (&self.w, Expr::integer(2));
        let carlson = |one: Expr, other: Expr| Expr::call("elliprc", [one, other]);
        match (self.above, reach) {
            (true, Reach::ToRim) if e.is_zero() => {
                let (shown, root) = (Expr::call("asin", [x / w]), (w.power(2) - x.power(2)).sqrt());
                let stable = ((w - x) * (w + x)).sqrt();
                match form {
                    Form::Shown => (Expr::pi() / two + shown) / root,
                    Form::Evaluated => (Expr::pi() / two + Expr::call("atan2", [x.clone(), stable.clone()])) / stable,
                }
            }
            (false, _) if e.is_zero() => carlson(x.power(2), w.power(2)),
            (true, Reach::Between) if e.is_zero() => -carlson(x.power(2), w.power(2)),
            (false, _) => &two * ((x - e) / (x + w)).sqrt() * carlson((x + e) * (x + w), &two * x * (e + w)),
            (true, Reach::ToRim) => &two * ((x - e) / (w - x)).sqrt() * carlson((x + e) * (w - x), &two * x * (w - e)),
            (true, Reach::Between) => -&two * ((x + e) / (x + w)).sqrt() * carlson((x - e) * (x + w), &two * x * (w - e)),
        }
    }

    /// D and F: F = ∫ 1/√(w ± r), and D is the part of ∫ √(w ± r) independent of F, by Carlson's R_F and R_D.
    fn elliptic(&self, e: &Expr, x: &Expr, reach: Reach) -> (Expr, Expr) {
        let (w, two) = (&self.w, Expr::integer(2));
        let (near, far) = if self.above && reach == Reach::Between { (x + e, x - e) } else { (x - e, x + e) };
        let other = if self.above && reach == Reach::ToRim { w - x } else { w + x };
        let sign = Expr::integer(if self.above && reach == Reach::Between { -1 } else { 1 });
        let list =
            if e.is_zero() { [other.clone(), &two * w, &two * &other] } else { [far * &other, &two * x * self.at(e), &two * x * &other] };
        let (first, second) = if e.is_zero() { (Expr::one(), Expr::one()) } else { (near.sqrt(), near.pow(&Expr::ratio(3, 2))) };
        let integral = &sign * &two * first * Expr::call("elliprf", list.clone());
        let rest = sign * Expr::ratio(4, 3) * x * other * second * Expr::call("elliprd", list);
        (rest, integral)
    }
}
