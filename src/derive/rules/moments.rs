//! Solutions for kernels whose moments ∫₀^x r^m k(r)/√(x²−r²) dr have closed forms for whole m.

use super::laurent::{Combination, Member};
use super::reading;
use crate::derive::rule::{Answer, Branches, Pair};
use crate::derive::term::Term;
use crate::expr::normal::NormalTerm;
use crate::expr::{Expr, Sign, sign};

/// Largest exponent; the formulas for larger exponents are too long.
pub(super) const HIGHEST: i64 = 40;

/// A kernel of y = scale·r with the moments scale^(−m)·Σ Λ_i(y) B_i(y).
pub(super) struct Moments<'a> {
    /// The factor of r in y.
    pub(super) scale: Expr,
    /// The parts Λ_i of the moment of order m.
    pub(super) moment: &'a dyn Fn(i64) -> Combination,
    /// The functions B_i at y, for the moment of order m.
    pub(super) members: &'a dyn Fn(i64, &Expr) -> Vec<Member>,
    /// The displayed functions, with common factors moved into the factors of the members.
    pub(super) shown: &'a dyn Fn(i64, &Expr) -> Vec<Member>,
    /// True if separate terms are written power by power, because they cancel with another term.
    pub(super) apart: bool,
}

/// The single part of a term on the whole axis, with its whole exponent in 0 … [`HIGHEST`].
pub(super) fn whole(term: &Term) -> Option<(&NormalTerm, i64)> {
    let part = term.single()?;
    if !term.segment.is_whole() || part.kernel.is_one() {
        return None;
    }
    Some((part, exponent(part)?))
}

/// The exponent of r, if it is whole and in 0 … [`HIGHEST`].
pub(super) fn exponent(part: &NormalTerm) -> Option<i64> {
    part.exponent.as_integer().filter(|m| (0..=HIGHEST).contains(m))
}

/// |k| and whether k is negative, for an argument k·r^power with k of proven sign.
pub(super) fn argument(u: &Expr, power: i64) -> Option<(Expr, bool)> {
    let (k, negative) = signed(u, power)?;
    Some((k, negative?))
}

/// As [`argument`], for an argument k·r of a function whose moments are analytic in k: k is unchanged if its sign is unknown.
pub(super) fn wavenumber(u: &Expr) -> Option<(Expr, bool)> {
    let (k, negative) = signed(u, 1)?;
    Some((k, negative.unwrap_or(false)))
}

fn signed(u: &Expr, power: i64) -> Option<(Expr, Option<bool>)> {
    let (k, _) = reading::monomial(u).filter(|(_, exponent)| *exponent == Expr::integer(power))?;
    match sign(&k) {
        Sign::Positive => Some((k, Some(false))),
        Sign::Negative => Some((-k, Some(true))),
        Sign::Unknown => Some((k, None)),
        Sign::Zero => None,
    }
}

/// g(x) = c x M_m(x) and F(a)/(2E*) = c M_(m+2)(a) for f′ = c·r^m·k(r).
pub(super) fn answer(coefficient: &Expr, m: i64, moments: &Moments) -> Answer {
    let (x, a) = (Expr::symbol("x"), Expr::symbol("a"));
    // Rewrite a factor q − k as minus the scale k − q.
    let opposite = -&moments.scale;
    let turned = |own: Expr| if own == opposite { vec![Expr::integer(-1), moments.scale.clone()] } else { vec![own] };
    let coefficients: Vec<Expr> = coefficient.factors().into_iter().flat_map(turned).collect();
    let written = |order: i64, factor: &Expr, at: &Expr| {
        let y = &moments.scale * at;
        let factor = Expr::product(coefficients.iter().cloned().chain([moments.scale.power(-order), factor.clone()]));
        let moment = (moments.moment)(order);
        let with = |members: &[Member]| {
            if moments.apart { moment.written_apart(&factor, &y, members) } else { moment.written(&factor, &y, members) }
        };
        Branches::endless(Pair { shown: with(&(moments.shown)(order, &y)), evaluated: with(&(moments.members)(order, &y)) })
    };
    Answer { equivalent: written(m, &x, &x), force: written(m + 2, &Expr::one(), &a), pressure: None, conditions: Vec::new() }
}
