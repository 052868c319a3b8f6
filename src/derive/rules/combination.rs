//! Sums of a few basis functions with rational coefficients, as recurrences over exponents produce them.

use crate::expr::{Expr, Symbol, normal};

/// How an end of a segment enters: as a reader sees it, or free of cancellation.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// √(x²−b²), acos(b/x).
    Shown,
    /// √((x−b)(x+b)), 2 asin √((x−b)/(2x)).
    Evaluated,
}

impl Form {
    /// √(x²−e²).
    pub(super) fn root(self, x: &Expr, e: &Expr) -> Expr {
        match self {
            _ if e.is_zero() => x.clone(),
            Self::Shown => (x.power(2) - e.power(2)).sqrt(),
            Self::Evaluated => ((x - e) * (x + e)).sqrt(),
        }
    }

    /// acos(e/x) = ∫_e^x dr/√(x²−r²).
    pub(super) fn arc(self, x: &Expr, e: &Expr) -> Expr {
        match self {
            _ if e.is_zero() => Expr::pi() / Expr::integer(2),
            Self::Shown => Expr::call("acos", [e / x]),
            Self::Evaluated => Expr::call("shifted_power", [Expr::zero(), e.clone(), x.clone()]),
        }
    }
}

/// Σ c_i·(the i-th function of a basis).
#[derive(Clone)]
pub(super) struct Combination(Vec<Expr>);

impl Combination {
    /// Nothing.
    pub(super) fn zero(len: usize) -> Self {
        Self(vec![Expr::zero(); len])
    }

    /// The i-th of `len` basis functions.
    pub(super) fn unit(i: usize, len: usize) -> Self {
        Self((0..len).map(|k| if k == i { Expr::one() } else { Expr::zero() }).collect())
    }

    /// The same over a basis with one more function.
    pub(super) fn extended(&self) -> Self {
        Self(self.0.iter().cloned().chain([Expr::zero()]).collect())
    }

    /// The sum of two combinations over one basis.
    pub(super) fn plus(&self, other: &Self) -> Self {
        Self(self.0.iter().zip(&other.0).map(|(one, two)| one + two).collect())
    }

    /// The combination times a factor.
    pub(super) fn times(&self, factor: &Expr) -> Self {
        Self(self.0.iter().map(|own| factor * own).collect())
    }

    /// The same with coefficients expanded, which keeps a recurrence short.
    pub(super) fn tidied(&self) -> Self {
        Self(self.0.iter().map(tidy).collect())
    }

    /// The sum itself.
    pub(super) fn over(&self, basis: &[Expr]) -> Expr {
        Expr::sum(self.0.iter().zip(basis).map(|(coefficient, function)| coefficient * function))
    }
}

/// Expanded, then over one whole denominator.
pub(super) fn tidy(expr: &Expr) -> Expr {
    let expanded = normal::expanded(expr, &Symbol::new("x")).unwrap_or_else(|_| expr.clone());
    normal::over_whole_denominator(&expanded)
}
