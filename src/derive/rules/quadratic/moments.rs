//! The recurrences of ∫ r^m Q^p K/√(x²−r²) dr with Q = ρ² + σr², in m and in p, with exact coefficients.

use super::laurent::{Laurent, Variable};
use Variable::{AtEnd, End, Length, Square, X};

/// A moment as a combination of the pieces that its family names: exact coefficients, one per [`Piece`].
#[derive(Clone, Debug)]
pub(super) struct Moment(pub(super) [Laurent; 5]);

/// The pieces, by their place in a [`Moment`]; the first two mean what the exponent's family and the parity of m say.
///
/// | exponent | m | `First` | `Second` |
/// |---|---|---|---|
/// | whole | odd | ∫ r Q⁻¹/√ dr | – |
/// | whole | even | ∫ Q⁻¹/√ dr | ∫ 1/√ dr |
/// | half | odd | ∫ r Q^(−1/2)/√ dr | ∫ r⁻¹ Q^(−1/2)/√ dr |
/// | half | even | ∫ Q^(−1/2)/√ dr | ∫ Q^(1/2)/√ dr |
#[derive(Clone, Copy)]
pub(super) enum Piece {
    First,
    Second,
    /// √(x²−e²) for whole exponents, √(x²−e²)·√Q(e) for half ones; the lower end's minus the upper end's.
    Root,
    /// √(x²−e²) K(e), likewise.
    KernelRoot,
    /// ∫ K/√ dr.
    Kernel,
}

impl Moment {
    fn of(piece: Piece) -> Self {
        Self(std::array::from_fn(|i| if i == piece as usize { Laurent::one() } else { Laurent::default() }))
    }

    pub(super) fn map(&self, change: impl Fn(&Laurent) -> Laurent) -> Self {
        Self(std::array::from_fn(|i| self.0.get(i).map(&change).unwrap_or_default()))
    }

    fn plus(&self, other: &Self) -> Self {
        Self(std::array::from_fn(|i| match (self.0.get(i), other.0.get(i)) {
            (Some(own), Some(more)) => own.plus(more),
            _ => Laurent::default(),
        }))
    }

    /// The coefficient of a piece.
    pub(super) fn at(&self, piece: Piece) -> Laurent {
        self.0.get(piece as usize).cloned().unwrap_or_default()
    }

    fn scaled(&self, p: i64, q: i64) -> Self {
        self.map(|own| own.scaled(p, q))
    }

    pub(super) fn times(&self, variable: Variable, power: i32) -> Self {
        self.map(|own| own.times(variable, power))
    }

    /// Σ of signed parts.
    fn sum(parts: &[Self]) -> Self {
        parts.iter().fold(Self::of(Piece::First).scaled(0, 1), |total, part| total.plus(part))
    }
}

/// Powers of Q = ρ² + σr² with one kind of exponent: whole, or whole and a half.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Family {
    /// σ, +1 or −1.
    pub(super) sigma: i64,
    /// True for exponents −1/2, −3/2, …
    pub(super) half: bool,
}

/// Beyond this m or exponent formulas fill pages and cancel; quadrature answers instead.
const HIGHEST: i64 = 40;

impl Family {
    /// ∫ r^m Q^p/√(x²−r²) dr with p = −k for whole and 1/2 − k for half exponents; `None` if it does not close.
    pub(super) fn moment(self, m: i64, k: i64) -> Option<Moment> {
        if !(0..=HIGHEST).contains(&k) || m.abs() > HIGHEST || (m < 0 && !self.half) {
            return None;
        }
        // Row by row from the mildest exponent: the row of k needs that of k − 1.
        let lowest = if self.half { 1 } else { 0 };
        let mut table: Vec<Vec<Option<Moment>>> = Vec::new();
        let to = m.max(1) + 2;
        for own in lowest..=k.max(lowest) {
            let mut row: Vec<Option<Moment>> = Vec::new();
            for power in 0..=to {
                let known = |back: i64| row.get(usize::try_from(power - back).ok()?).cloned().flatten();
                let above = |back: i64| {
                    table.last().and_then(|r: &Vec<Option<Moment>>| r.get(usize::try_from(power - back).ok()?).cloned().flatten())
                };
                let higher = |rows: usize| {
                    table.len().checked_sub(rows).and_then(|i| table.get(i)?.get(usize::try_from(power).ok()?).cloned().flatten())
                };
                row.push(if own == lowest { self.mildest(power, &known) } else { self.next(power, own, &known, &above, &higher) });
            }
            table.push(row);
        }
        if k < lowest {
            return None;
        }
        let last = table.last()?;
        if m >= 0 {
            return last.get(usize::try_from(m).ok()?).cloned().flatten();
        }
        if k == 1 { self.below(m, last) } else { None }
    }

    /// The row of exponent 0 or −1/2.
    fn mildest(self, m: i64, known: &dyn Fn(i64) -> Option<Moment>) -> Option<Moment> {
        let (sigma, root) = (self.sigma, Moment::of(Piece::Root));
        let end = |power: i64| root.times(End, power as i32);
        match (self.half, m) {
            (false, 0) => Some(Moment::of(Piece::Second)),
            (false, 1) => Some(root.clone()),
            // m J_m = (m−1) x² J_(m−2) + e^(m−1) √(x²−e²)
            (false, _) => Some(known(2)?.times(X, 2).scaled(m - 1, m).plus(&end(m - 1).scaled(1, m))),
            (true, 0 | 1) => Some(Moment::of(Piece::First)),
            // r² = σ(Q − ρ²)
            (true, 2) => Some(Moment::of(Piece::Second).plus(&known(2)?.times(Length, 2).scaled(-1, 1)).scaled(sigma, 1)),
            // σ(m−1) I_m = (m−2)(σx² − ρ²) I_(m−2) + (m−3) ρ²x² I_(m−4) + e^(m−3) √(x²−e²) √Q(e)
            (true, _) => {
                let before = known(2)?;
                let mut parts = vec![before.times(X, 2).scaled(sigma * (m - 2), 1), before.times(Length, 2).scaled(2 - m, 1), end(m - 3)];
                if m > 3 {
                    parts.push(known(4)?.times(Length, 2).times(X, 2).scaled(m - 3, 1));
                }
                Some(Moment::sum(&parts).scaled(sigma, m - 1))
            }
        }
    }

    /// A later row, its exponent being p − 1: 2p is −2k + 2 for whole and −2k + 3 for half exponents.
    fn next(
        self,
        m: i64,
        k: i64,
        known: &dyn Fn(i64) -> Option<Moment>,
        above: &dyn Fn(i64) -> Option<Moment>,
        higher: &dyn Fn(usize) -> Option<Moment>,
    ) -> Option<Moment> {
        let (sigma, twice) = (self.sigma, if self.half { 3 - 2 * k } else { 2 - 2 * k });
        // √(x²−e²) Q(e)^p in terms of the piece.
        let root = Moment::of(Piece::Root).times(AtEnd, if self.half { (twice - 1) / 2 } else { twice / 2 } as i32);
        match m {
            0 | 1 if twice == 0 => Some(Moment::of(Piece::First)),
            // 2p s² I^(p−1) = (2p+1) I^p − [√(x²−e²) Q^p]
            1 => Some(above(0)?.scaled(twice + 1, 1).plus(&root.scaled(-1, 1)).times(Square, -1).scaled(1, twice)),
            // 2p ρ² s² I^(p−1) = (2p+1)(s²+ρ²) I^p − (2p+2) I^(p+1) + σ [e √(x²−e²) Q^p]
            0 => {
                let own = above(0)?.scaled(twice + 1, 1);
                let mut parts = vec![own.times(Square, 1), own.times(Length, 2), root.times(End, 1).scaled(sigma, 1)];
                if twice + 2 != 0 {
                    // The row above the first half exponent is Q^(1/2).
                    let milder = if self.half && k == 2 { Moment::of(Piece::Second) } else { higher(2)? };
                    parts.push(milder.scaled(-(twice + 2), 1));
                }
                Some(Moment::sum(&parts).times(Length, -2).times(Square, -1).scaled(1, twice))
            }
            // r² = σ(Q − ρ²)
            _ => Some(above(2)?.plus(&known(2)?.times(Length, 2).scaled(-1, 1)).scaled(sigma, 1)),
        }
    }

    /// Negative m under Q^(−1/2): (m+1) ρ²x² I_m = σ(m+3) I_(m+4) − (m+2)(σx² − ρ²) I_(m+2) − e^(m+1) √(x²−e²) √Q(e).
    fn below(self, m: i64, row: &[Option<Moment>]) -> Option<Moment> {
        let sigma = self.sigma;
        let mut found: std::collections::BTreeMap<i64, Moment> = std::collections::BTreeMap::new();
        for (power, form) in row.iter().enumerate() {
            found.insert(power as i64, form.clone()?);
        }
        found.insert(-1, Moment::of(Piece::Second));
        let mut n = if m % 2 == 0 { -2 } else { -3 };
        while n >= m {
            let (far, near) = (found.get(&(n + 4))?, found.get(&(n + 2))?);
            let parts = [
                far.scaled(sigma * (n + 3), 1),
                near.times(X, 2).scaled(-sigma * (n + 2), 1),
                near.times(Length, 2).scaled(n + 2, 1),
                Moment::of(Piece::Root).times(End, (n + 1) as i32).scaled(-1, 1),
            ];
            found.insert(n, Moment::sum(&parts).times(Length, -2).times(X, -2).scaled(1, n + 1));
            n -= 2;
        }
        found.get(&m).cloned()
    }
}

/// A kernel K whose derivative is κ·r^ε·Q^p: 2σ r/Q for the logarithm, ρ/Q for the arctangents, Q^(−1/2) for the arcsines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kernel {
    /// ln(Q/ρ²).
    Logarithm,
    /// atan(r/ρ) for σ = 1, atanh(r/ρ) for σ = −1.
    Arctangent,
    /// asinh(r/ρ) for σ = 1, asin(r/ρ) for σ = −1.
    Arcsine,
}

impl Kernel {
    /// The family of K′.
    pub(super) fn family(self, sigma: i64) -> Family {
        Family { sigma, half: self == Self::Arcsine }
    }

    /// ∫ r^j K′/√(x²−r²) dr.
    fn derivative_moment(self, sigma: i64, j: i64) -> Option<Moment> {
        let family = self.family(sigma);
        match self {
            Self::Logarithm => Some(family.moment(j + 1, 1)?.scaled(2 * sigma, 1)),
            Self::Arctangent => Some(family.moment(j, 1)?.times(Length, 1)),
            Self::Arcsine => family.moment(j, 1),
        }
    }

    /// ∫ r^m K/√(x²−r²) dr by m I_m = (m−1)x² I_(m−2) + x² N_(m−1) − N_(m+1) + [e^(m−1) √(x²−e²) K(e)].
    pub(super) fn moment(self, sigma: i64, m: i64) -> Option<Moment> {
        // x² I_(−2) = x² N_(−1) − N_1, because ln(Q/ρ²) is of order r² at the axis.
        if self == Self::Logarithm && m == -2 {
            let far = self.derivative_moment(sigma, 1)?.times(X, -2).scaled(-1, 1);
            return Some(self.derivative_moment(sigma, -1)?.plus(&far));
        }
        if !(0..=HIGHEST).contains(&m) {
            return None;
        }
        let mut own = (m % 2 == 0).then(|| Moment::of(Piece::Kernel));
        let mut n = 2 - m % 2;
        if m == 0 {
            return own;
        }
        while n <= m {
            let mut parts = vec![
                self.derivative_moment(sigma, n - 1)?.times(X, 2),
                self.derivative_moment(sigma, n + 1)?.scaled(-1, 1),
                Moment::of(Piece::KernelRoot).times(End, (n - 1) as i32),
            ];
            if let Some(before) = &own {
                parts.push(before.times(X, 2).scaled(n - 1, 1));
            }
            own = Some(Moment::sum(&parts).scaled(1, n));
            n += 2;
        }
        own
    }
}
