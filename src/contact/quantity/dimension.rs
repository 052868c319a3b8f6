//! Dimensions: products of powers of a length and a force, with rational exponents.

use crate::expr::Expr;
use num_rational::Ratio;
use num_traits::{CheckedAdd, CheckedMul, CheckedSub, Zero};
use std::fmt;

/// Powers of length and force; a pressure is force/length².
///
/// ```
/// use sneddon::contact::Dimension;
/// assert_eq!(Dimension::PRESSURE.times(Dimension::LENGTH).unwrap().to_string(), "force/length");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension {
    length: Ratio<i64>,
    force: Ratio<i64>,
}

impl Dimension {
    /// A plain number, or an angle.
    pub const NONE: Self = Self::whole(0, 0);
    /// A length.
    pub const LENGTH: Self = Self::whole(1, 0);
    /// An area.
    pub const AREA: Self = Self::whole(2, 0);
    /// A force.
    pub const FORCE: Self = Self::whole(0, 1);
    /// A pressure.
    pub const PRESSURE: Self = Self::whole(-2, 1);
    /// A stiffness.
    pub const STIFFNESS: Self = Self::whole(-1, 1);
    /// An energy.
    pub const ENERGY: Self = Self::whole(1, 1);

    const fn whole(length: i64, force: i64) -> Self {
        Self { length: Ratio::new_raw(length, 1), force: Ratio::new_raw(force, 1) }
    }

    /// The dimension of a product; `None` if an exponent overflows.
    pub fn times(self, other: Self) -> Option<Self> {
        Some(Self { length: self.length.checked_add(&other.length)?, force: self.force.checked_add(&other.force)? })
    }

    /// The dimension of a quotient.
    pub fn over(self, other: Self) -> Option<Self> {
        Some(Self { length: self.length.checked_sub(&other.length)?, force: self.force.checked_sub(&other.force)? })
    }

    /// The dimension of a power.
    pub fn power(self, exponent: Ratio<i64>) -> Option<Self> {
        Some(Self { length: self.length.checked_mul(&exponent)?, force: self.force.checked_mul(&exponent)? })
    }

    /// The product of the powers of a length and a force.
    pub fn product(self, length: f64, force: f64) -> f64 {
        let power = |base: f64, exponent: Ratio<i64>| match exponent.numer() {
            own if *exponent.denom() != 1 => base.powf(*own as f64 / *exponent.denom() as f64),
            // Products and quotients round once.
            0 => 1.0,
            1 => base,
            2 => base * base,
            -1 => 1.0 / base,
            own => base.powf(*own as f64),
        };
        if self.length == Ratio::from_integer(-1) {
            power(force, self.force) / length
        } else {
            power(force, self.force) * power(length, self.length)
        }
    }

    /// The powers of length and force.
    pub fn exponents(self) -> (Expr, Expr) {
        let exact = |own: Ratio<i64>| Expr::ratio(*own.numer(), *own.denom());
        (exact(self.length), exact(self.force))
    }

    /// True for plain numbers.
    pub fn is_none(self) -> bool {
        self == Self::NONE
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (name, own) in
            [("a plain number", Self::NONE), ("a length", Self::LENGTH), ("a force", Self::FORCE), ("a pressure", Self::PRESSURE)]
        {
            if *self == own {
                return out.write_str(name);
            }
        }
        let part = |name: &str, exponent: Ratio<i64>| match exponent {
            one if one == Ratio::from_integer(1) => name.to_owned(),
            whole if whole.is_integer() => format!("{name}^{whole}"),
            other => format!("{name}^({other})"),
        };
        let parts = [("force", self.force), ("length", self.length)];
        let above: Vec<String> = parts.iter().filter(|(_, e)| *e > Ratio::zero()).map(|(n, e)| part(n, *e)).collect();
        let below: Vec<String> = parts.iter().filter(|(_, e)| *e < Ratio::zero()).map(|(n, e)| part(n, -*e)).collect();
        let above = if above.is_empty() { "1".to_owned() } else { above.join("*") };
        match below.as_slice() {
            [] => out.write_str(&above),
            [only] => write!(out, "{above}/{only}"),
            many => write!(out, "{above}/({})", many.join("*")),
        }
    }
}
