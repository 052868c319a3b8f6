//! Requests for quantities of a profile, and the ways to compute their integrals.

use crate::integrate::error::TransformError;
use crate::num::Estimate;
use crate::num::quadrature::Rule;

/// One number of a profile, in units in which E* = 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Ask {
    /// g(x).
    Equivalent(f64),
    /// F(a)/(2E*) under a smooth edge.
    Force(f64),
    /// G(a) = ∫₀^a g dx.
    Integral(f64),
    /// p·π/E* at r under a smooth edge of radius a.
    Pressure {
        /// r.
        r: f64,
        /// a.
        a: f64,
    },
    /// u_z at r outside a smooth edge of radius a.
    Outside {
        /// r.
        r: f64,
        /// a.
        a: f64,
    },
    /// f(r) − f(0).
    Height(f64),
    /// −σ_zz·π/E* at the depth z > 0 on the axis under a smooth edge of radius a.
    Axial {
        /// z.
        z: f64,
        /// a.
        a: f64,
    },
}

impl Ask {
    /// The key of the quantity.
    pub(crate) fn key(self) -> &'static str {
        match self {
            Self::Equivalent(_) => "g",
            Self::Force(_) => "F",
            Self::Integral(_) => "G",
            Self::Pressure { .. } => "p",
            Self::Outside { .. } => "u",
            Self::Height(_) => "f",
            Self::Axial { .. } => "sigma_zz",
        }
    }

    /// The coordinates: r (or z) and a; twice the same where there is one only.
    pub(crate) fn coordinates(self) -> [f64; 2] {
        match self {
            Self::Pressure { r, a } | Self::Outside { r, a } => [r, a],
            Self::Axial { z, a } => [z, a],
            Self::Equivalent(own) | Self::Force(own) | Self::Integral(own) | Self::Height(own) => [own, own],
        }
    }

    /// How far out f′ is needed.
    pub(crate) fn reach(self) -> f64 {
        let [_, end] = self.coordinates();
        end
    }
}

/// How the integrals of f′ are found.
#[derive(Clone, Copy, Debug)]
pub(crate) enum By {
    /// On each interval in the cheapest way that meets the tolerance.
    Cheapest,
    /// By bisection with this rule.
    Rule(Rule),
    /// On all intervals in the way of this key.
    Only(&'static str),
}

/// The key of the one Gauss rule that an enclosure of f′ proves to suffice …
pub(crate) const GAUSS: &str = "gauss";
/// … of pieces, each with such a rule …
pub(crate) const PIECES: &str = "pieces";
/// … of nested rules over the angle …
pub(crate) const NESTED: &str = "nested";
/// … of adaptive Gauss–Kronrod quadrature …
pub(crate) const BISECTION: &str = "bisection";
/// … and, for pressures, of one kernel and one integral for every kink between straight pieces …
pub(crate) const STRAIGHT: &str = "straight";
/// … of the expansion of f′ in Legendre polynomials with a proven number of terms …
pub(crate) const LEGENDRE: &str = "legendre";
/// … of ∫ g′(r cosh u) du with proven rules …
pub(crate) const OVER_U: &str = "over-u";
/// … of the same two where values judge the rules …
pub(crate) const LEGENDRE_SAMPLED: &str = "legendre-sampled";
pub(crate) const OVER_U_SAMPLED: &str = "over-u-sampled";
/// … and of one integral over r with the elliptic kernel.
pub(crate) const ELLIPTIC: &str = "elliptic";

/// The error of a way that has no answer; its list says why.
pub(crate) fn not_this_way(way: &'static str) -> TransformError {
    TransformError::NotThisWay { way, reason: "" }
}

/// The estimate, found in the way of this key.
pub(crate) fn by(way: &'static str, found: Result<Option<Estimate>, TransformError>) -> Result<Option<Estimate>, TransformError> {
    Ok(found?.map(|own| own.by(way)))
}
