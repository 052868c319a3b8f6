//! The transcendental pieces that the recurrences end in, on a segment and beyond it.

use super::moments::{Family, Kernel};
use crate::expr::Expr;

/// Q = ρ² + σr², by σ and ρ².
#[derive(Clone, Debug)]
pub(super) struct Field {
    pub(super) sigma: i64,
    pub(super) square_length: Expr,
}

/// Where a moment is taken: from b to x, or from b to c with x beyond c.
pub(super) struct MomentRange<'a> {
    pub(super) field: &'a Field,
    pub(super) x: Expr,
    pub(super) lower: &'a Expr,
    pub(super) upper: Option<&'a Expr>,
    /// True for the form that is computed, false for the one that is printed.
    pub(super) stable: bool,
}

impl MomentRange<'_> {
    pub(super) fn length(&self) -> Expr {
        self.field.square_length.sqrt()
    }

    /// Q(e) = ρ² + σe².
    fn at(&self, end: &Expr) -> Expr {
        if end.is_zero() {
            return self.field.square_length.clone();
        }
        &self.field.square_length + Expr::integer(self.field.sigma) * end.power(2)
    }

    /// √(x² − e²).
    pub(super) fn leg(&self, end: &Expr) -> Expr {
        if end.is_zero() { self.x.clone() } else { (self.x.power(2) - end.power(2)).sqrt() }
    }

    /// √Q(e).
    pub(super) fn root(&self, end: &Expr) -> Expr {
        self.at(end).sqrt()
    }

    /// s = √Q(x).
    fn s(&self) -> Expr {
        self.root(&self.x)
    }

    fn plus(&self) -> bool {
        self.field.sigma > 0
    }

    /// Value at the lower end minus value at the upper one, where there is one.
    fn difference(&self, value: impl Fn(&Expr) -> Expr) -> Expr {
        match self.upper {
            None => value(self.lower),
            Some(upper) => value(self.lower) - value(upper),
        }
    }

    /// The first piece of a family: see [`super::moments::Piece`].
    pub(super) fn first(&self, family: Family, odd: bool) -> Expr {
        match (family.half, odd) {
            (false, true) => self.odd_pole(),
            (false, false) => self.even_pole(),
            (true, true) => self.arc(),
            (true, false) => match self.carlson() {
                Some((first, _)) => first,
                None => self.elliptic("ellipk", "ellipf") / self.length(),
            },
        }
    }

    /// The second piece.
    pub(super) fn second(&self, family: Family, odd: bool) -> Expr {
        match (family.half, odd) {
            (false, true) => Expr::zero(),
            (false, false) => self.angle(),
            (true, true) => self.inverse_arc(),
            (true, false) => match self.carlson() {
                Some((first, square)) => &self.field.square_length * first + Expr::integer(self.field.sigma) * square,
                None => self.elliptic("ellipe", "ellipe") * self.length(),
            },
        }
    }

    /// ∫ r/(Q√(x²−r²)) dr.
    fn odd_pole(&self) -> Expr {
        if let Some(upper) = self.upper
            && (self.stable || !self.plus())
        {
            // Real on both sides of x = ρ; w_b − w_c without cancellation.
            let (b, c, sigma) = (self.leg(self.lower), self.leg(upper), Expr::integer(self.field.sigma));
            let spread = (upper.power(2) - self.lower.power(2)) / (&b + &c);
            let first = self.at(&self.x) - sigma * b * c;
            return spread * Expr::call("elliprc", [first.power(2), self.at(self.lower) * self.at(upper)]);
        }
        let name = if self.plus() { "asinh" } else { "asin" };
        self.difference(|end| Expr::call(name, [self.leg(end) / self.root(end)])) / self.s()
    }

    /// ∫ 1/(Q√(x²−r²)) dr.
    fn even_pole(&self) -> Expr {
        if let Some(upper) = self.upper
            && (self.stable || !self.plus())
        {
            let (b, c) = (self.leg(self.lower), self.leg(upper));
            let spread = self.x.power(2) * (upper.power(2) - self.lower.power(2)) / (upper * &b + self.lower * &c);
            let first = &self.field.square_length * b * c + self.at(&self.x) * self.lower * upper;
            return spread * Expr::call("elliprc", [first.power(2), self.x.power(4) * self.at(self.lower) * self.at(upper)]);
        }
        let angle = match self.upper {
            Some(upper) if self.lower.is_zero() => Expr::call("atan", [upper * self.s() / (self.length() * self.leg(upper))]),
            _ => self.difference(|end| self.elliptic_angle(end)),
        };
        angle / (self.length() * self.s())
    }

    /// atan(ρ√(x²−e²)/(e s)), which is π/2 at the axis; the amplitude of the elliptic integrals too.
    fn elliptic_angle(&self, end: &Expr) -> Expr {
        if end.is_zero() {
            return Expr::pi() / Expr::integer(2);
        }
        Expr::call("atan", [self.length() * self.leg(end) / (end * self.s())])
    }

    /// ∫ 1/√(x²−r²) dr.
    fn angle(&self) -> Expr {
        let arc = |end: &Expr| Expr::call("acos", [end / &self.x]);
        match (self.lower.is_zero(), self.upper) {
            (true, None) => Expr::pi() / Expr::integer(2),
            (true, Some(upper)) => Expr::call("asin", [upper / &self.x]),
            (false, Some(upper)) if self.stable => {
                let (b, c) = (self.leg(self.lower), self.leg(upper));
                let sine = self.x.power(2) * (upper.power(2) - self.lower.power(2)) / (upper * &b + self.lower * &c);
                Expr::call("atan", [sine / (self.lower * upper + b * c)])
            }
            (false, None) if self.stable => Expr::call("angle_from", [self.lower.clone(), self.x.clone()]),
            (false, _) => self.difference(arc),
        }
    }

    /// ∫ r/(√Q √(x²−r²)) dr.
    fn arc(&self) -> Expr {
        match self.upper {
            Some(upper) if !self.plus() => {
                // Real on both sides of x = ρ.
                let side = |end: &Expr| self.root(end) + self.leg(end);
                if !self.stable {
                    return Expr::call("ln", [side(self.lower) / side(upper)]);
                }
                // Both squares shrink by c² − b², so that side(b) − side(c) is a sum of positive terms.
                let shrinking = |value: fn(&Self, &Expr) -> Expr| (value(self, self.lower) + value(self, upper)).recip();
                let drop = (upper.power(2) - self.lower.power(2)) * (shrinking(Self::root) + shrinking(Self::leg));
                Expr::call("ln", [Expr::one() + drop / side(upper)])
            }
            _ if self.plus() => self.difference(|end| Expr::call("atan", [self.leg(end) / self.root(end)])),
            _ => artanh_of_legs(self.lower, &self.x, self.length()),
        }
    }

    /// ∫ 1/(r √Q √(x²−r²)) dr; only from b > 0.
    fn inverse_arc(&self) -> Expr {
        let (x, length) = (&self.x, self.length());
        let value = match self.upper {
            None => Expr::call("atanh", [&length * self.leg(self.lower) / (x * self.root(self.lower))]),
            Some(upper) => {
                let side = |end: &Expr| (x * self.root(end) + &length * self.leg(end)) / end;
                Expr::call("ln", [side(self.lower) / side(upper)])
            }
        };
        value / (length * x)
    }

    /// An elliptic integral of parameter −σx²/ρ², complete on the whole axis.
    ///
    /// From b to x its amplitude φ turns E(m) − E(θ|m) into E(φ|m) and the term of [`Self::needs_algebraic_term`].
    fn elliptic(&self, complete: &'static str, incomplete: &'static str) -> Expr {
        let parameter = Expr::integer(-self.field.sigma) * self.x.power(2) / &self.field.square_length;
        let from = |end: &Expr| Expr::call(incomplete, [Expr::call("asin", [end / &self.x]), parameter.clone()]);
        match (self.lower.is_zero(), self.upper) {
            (true, None) => Expr::call(complete, [parameter]),
            (false, None) => Expr::call(incomplete, [self.elliptic_angle(self.lower), parameter]),
            (true, Some(upper)) => from(upper),
            (false, Some(upper)) => from(upper) - from(self.lower),
        }
    }

    /// ∫ 1/√(Q (x²−r²)) dr and ∫ r²/√(Q (x²−r²)) dr from b to c, real on both sides of x = ρ and free of cancellation.
    ///
    /// Source: DLMF 19.29.4 and 19.29.7 in r².
    fn carlson(&self) -> Option<(Expr, Expr)> {
        let upper = self.upper.filter(|_| self.stable || !self.plus())?;
        let (b, c) = (self.lower, upper);
        let (big, small) = ([self.root(b), self.leg(b)], [self.root(c), self.leg(c)]);
        let ([root_b, leg_b], [root_c, leg_c]) = (&big, &small);
        let spread = c.power(2) - b.power(2);
        let first = (c * root_c * leg_b + b * root_b * leg_c) / &spread;
        let second = (c * leg_c * root_b + b * leg_b * root_c) / &spread;
        let third = (c * root_b * leg_b + b * root_c * leg_c) / &spread;
        let squares = [first.power(2), second.power(2), third.power(2)];
        let scale = &self.field.square_length * self.x.power(2) / Expr::integer(3);
        let square = scale * Expr::call("elliprd", squares.clone()) + b * c / third;
        Some((Expr::call("elliprf", squares), square))
    }

    /// True if ∫ √Q/√(x²−r²) dr is ρ E(φ|m) + σ b √(x²−b²)/√Q(b).
    pub(super) fn needs_algebraic_term(&self) -> bool {
        self.upper.is_none() && !self.lower.is_zero()
    }

    /// K(e).
    pub(super) fn kernel(&self, kernel: Kernel, end: &Expr) -> Expr {
        let ratio = end / self.length();
        let name = match (kernel, self.plus()) {
            (Kernel::Logarithm, _) => {
                let square = Expr::integer(self.field.sigma) * end.power(2) / &self.field.square_length;
                return Expr::call("ln", [Expr::one() + square]);
            }
            (Kernel::Arctangent, true) => "atan",
            (Kernel::Arctangent, false) => return artanh_of_legs(&Expr::zero(), end, self.length()),
            (Kernel::Arcsine, true) => "asinh",
            (Kernel::Arcsine, false) => "asin",
        };
        Expr::call(name, [ratio])
    }

    /// ∫₀ˣ K/√(x²−r²) dr.
    pub(super) fn whole_kernel(&self, kernel: Kernel) -> Expr {
        let (x, length) = (&self.x, self.length());
        let two = Expr::integer(2);
        match (kernel, self.plus()) {
            (Kernel::Logarithm, _) => Expr::pi() * Expr::call("ln", [(&length + self.s()) / (two * length)]),
            (Kernel::Arctangent, true) => two * Expr::call("legendre_chi2", [x / (length + self.s())]),
            (Kernel::Arctangent, false) => two * Expr::call("inverse_tangent_integral", [x / (length + self.s())]),
            (Kernel::Arcsine, true) => Expr::call("inverse_tangent_integral", [x / length]),
            (Kernel::Arcsine, false) => Expr::call("legendre_chi2", [x / length]),
        }
    }
}

/// artanh(√(x²−b²)/√(ρ²−b²)), accurate next to x = ρ.
pub(super) fn artanh_of_legs(b: &Expr, x: &Expr, length: Expr) -> Expr {
    if b.is_zero() {
        return Expr::call("artanh_ratio", [x.clone(), length]);
    }
    Expr::call("worn_sphere_slope", [b.clone(), x.clone(), length])
}
