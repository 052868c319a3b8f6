//! The variables in which f′(r)/√(x² − r²) becomes a smooth even function, r/x = cos τ.

use super::super::even::{Middles, Nodes};
use super::Radii;

/// Most places that are asked together.
pub(crate) const CHUNK: usize = 16;

/// Room for the places of one chunk.
pub(crate) struct Room {
    r: [f64; CHUNK],
    past: [f64; CHUNK],
    below: [f64; CHUNK],
    factor: [f64; CHUNK],
    sine: [f64; CHUNK],
    secant: [f64; CHUNK],
}

impl Room {
    #[inline(always)]
    pub(crate) const fn new() -> Self {
        const EMPTY: [f64; CHUNK] = [0.0; CHUNK];
        Self { r: EMPTY, past: EMPTY, below: EMPTY, factor: EMPTY, sine: EMPTY, secant: EMPTY }
    }
}

/// Places of f′, and the factor that makes an integrand of it; no factor is 1.
pub(crate) struct Placed<'a> {
    pub(crate) at: Radii<'a>,
    pub(crate) factor: Option<&'a [f64]>,
}

/// Where the piece lies.
#[derive(Clone, Copy)]
pub(crate) struct Extent {
    /// The upper end, where the integrand's singularity is.
    pub(crate) x: f64,
    /// limit − x, 0 without a limit.
    pub(crate) rest: f64,
    /// sin τ at the lower end: √((x − b)(x + b))/x, 1 at the axis.
    pub(crate) sine: f64,
    /// cos τ there: b/x.
    pub(crate) cosine: f64,
}

impl Extent {
    /// The piece from `lower` to `x`, both below `limit`.
    pub(crate) fn new(lower: f64, x: f64, limit: Option<f64>) -> Self {
        let rest = limit.map_or(0.0, |limit| limit - x);
        if lower == 0.0 {
            return Self { x, rest, sine: 1.0, cosine: 0.0 };
        }
        let root = ((x - lower) * (x + lower)).sqrt();
        Self { x, rest, sine: root / x, cosine: lower / x }
    }

    /// τ at the lower end.
    pub(crate) fn angle(&self) -> f64 {
        if self.cosine == 0.0 { std::f64::consts::FRAC_PI_2 } else { self.sine.atan2(self.cosine) }
    }
}

/// The variable.
#[derive(Clone, Copy)]
pub(crate) enum Form {
    /// From the axis, z = sin τ.
    AxisSine,
    /// From the axis, z = 2τ/π.
    AxisAngle,
    /// From a kink, z ~ sin τ.
    Sine,
    /// From a kink, z ~ τ.
    Angle { angle: f64 },
    /// Next to a limit: sin τ = ε sinh(reach·z), where f′ ~ 1/√(ε² + sin²τ) in general.
    NearSine { small: f64, reach: f64 },
    /// The same in τ itself.
    NearAngle { small: f64, reach: f64, angle: f64 },
}

impl Form {
    /// The variable for a piece that ends at x.
    pub(crate) fn choose(extent: &Extent, odd: bool, limit: Option<f64>) -> Self {
        if let Some(limit) = limit {
            // √(R² − x²)/x: where 1/√(R² − r²) has its branch points, ±i of it in sin τ.
            let small = (extent.rest * (limit + extent.x)).sqrt() / extent.x;
            if odd && small < NEAR {
                return Self::NearSine { small, reach: (extent.sine / small).asinh() };
            }
            if !odd && small < NEAR {
                let small = small.asinh();
                let angle = extent.angle();
                return Self::NearAngle { small, reach: (angle / small).asinh(), angle };
            }
        }
        match (odd, extent.cosine == 0.0) {
            (true, true) => Self::AxisSine,
            (false, true) => Self::AxisAngle,
            (true, false) => Self::Sine,
            (false, false) => Self::Angle { angle: extent.angle() },
        }
    }

    /// What the mean of the integrand is to be multiplied by.
    pub(crate) fn scale(self, extent: &Extent) -> f64 {
        match self {
            Self::AxisSine => 1.0,
            Self::AxisAngle => std::f64::consts::FRAC_PI_2,
            Self::Sine => extent.sine,
            Self::Angle { angle } => angle,
            Self::NearSine { reach, .. } | Self::NearAngle { reach, .. } => reach,
        }
    }

    /// Computes the places of a few nodes, at most [`CHUNK`]; `exact`: x − r with all its digits.
    #[inline(always)]
    pub(crate) fn place<'a>(self, extent: &Extent, nodes: Nodes<'a>, exact: bool, room: &'a mut Room) -> Option<Placed<'a>> {
        let Extent { x, rest, sine, cosine } = *extent;
        let count = nodes.z.len();
        let (r, below) = (room.r.get_mut(..count)?, room.below.get_mut(..count)?);
        let axis = |cosines: &[f64], versines: &[f64], r: &mut [f64], below: &mut [f64]| {
            for ((r, below), (c, versine)) in r.iter_mut().zip(below).zip(cosines.iter().zip(versines)) {
                *r = x * c;
                *below = rest + x * versine;
            }
        };
        match self {
            Self::AxisSine => {
                axis(nodes.cosine, nodes.sine_versine, r, below);
                return Some(Placed { at: Radii { r, past_start: r, below_limit: below }, factor: Some(nodes.secant) });
            }
            Self::AxisAngle => {
                axis(nodes.quarter, nodes.versine, r, below);
                return Some(Placed { at: Radii { r, past_start: r, below_limit: below }, factor: None });
            }
            _ => {}
        }
        let (past, factor) = (room.past.get_mut(..count)?, room.factor.get_mut(..count)?);
        let (sines, secants) = (room.sine.get_mut(..count)?, room.secant.get_mut(..count)?);
        let places = sines.iter_mut().zip(nodes.z);
        match self {
            Self::NearSine { small, reach } => places.for_each(|(s, z)| *s = (small * sinh(reach * z)).min(sine)),
            Self::NearAngle { small, reach, angle } => {
                for ((s, z), factor) in places.zip(&mut *factor) {
                    let tau = (small * sinh(reach * z)).min(angle);
                    *factor = (small * small + tau * tau).sqrt();
                    *s = tau.sin();
                }
            }
            Self::Angle { angle } => places.for_each(|(s, z)| *s = (angle * z).sin()),
            _ => places.for_each(|(s, z)| *s = sine * z),
        }
        let lower = x * cosine;
        let from_axis = cosine == 0.0;
        for ((((r, past), below), secant), s) in r.iter_mut().zip(&mut *past).zip(&mut *below).zip(&mut *secants).zip(&*sines) {
            let c = ((1.0 - s) * (1.0 + s)).sqrt();
            // cos τ − cos τ_b = (sin²τ_b − sin²τ)/(cos τ + cos τ_b), and 1/c by the same division.
            let over = 1.0 / (c * (c + cosine));
            let share = (sine - s) * (sine + s) * (over * c);
            *past = x * if from_axis { c } else { share };
            *r = lower + *past;
            *below = rest + (x - *r);
            *secant = over * (c + cosine);
        }
        if exact || matches!(self, Self::NearSine { .. } | Self::NearAngle { .. }) {
            for (below, s) in below.iter_mut().zip(&*sines) {
                *below = rest + x * (s * s / (1.0 + ((1.0 - s) * (1.0 + s)).sqrt()));
            }
        }
        let at = Radii { r, past_start: past, below_limit: below };
        match self {
            Self::Angle { .. } => Some(Placed { at, factor: None }),
            Self::NearAngle { .. } => Some(Placed { at, factor: Some(factor) }),
            Self::NearSine { small, .. } => {
                for ((factor, secant), s) in factor.iter_mut().zip(&*secants).zip(&*sines) {
                    *factor = (small * small + s * s).sqrt() * secant;
                }
                Some(Placed { at, factor: Some(factor) })
            }
            _ => Some(Placed { at, factor: Some(secants) }),
        }
    }

    /// r/x at nodes of the forms that begin at the axis.
    pub(crate) fn radii(self, nodes: Nodes<'_>) -> Option<&[f64]> {
        match self {
            Self::AxisSine => Some(nodes.cosine),
            Self::AxisAngle => Some(nodes.quarter),
            _ => None,
        }
    }

    /// What a relative rounding of every r by one unit does to the mean: ∫ |r df′/dr| dτ.
    #[inline]
    pub(crate) fn displacement(self, extent: &Extent, middles: Middles<'_>, values: &[f64]) -> f64 {
        let steps = values.iter().zip(values.get(1..).unwrap_or_default());
        let weighted = |cotangents: &[f64]| {
            let mut lanes = [0.0; 2];
            for (i, ((a, b), c)) in steps.clone().zip(cotangents).enumerate() {
                lanes[i & 1] += (b - a).abs() * c;
            }
            lanes[0] + lanes[1]
        };
        match self {
            Self::AxisSine => weighted(middles.cotangents),
            Self::AxisAngle => weighted(middles.quarter_cotangents) / std::f64::consts::FRAC_PI_2,
            // cot τ < 1/τ, and the ends of the piece are rounded too.
            Self::Sine => 4.0 * weighted(middles.reciprocals) / (extent.sine * extent.sine),
            Self::Angle { angle } => 4.0 * weighted(middles.reciprocals) / (angle * angle),
            // Next to a limit f′ is a function of the distance to it.
            Self::NearSine { .. } | Self::NearAngle { .. } => 0.0,
        }
    }
}

/// Below this distance of the branch points the integrand is stretched.
const NEAR: f64 = 2.5;

/// sinh v for v ≥ 0; next to 0 its last digits do not matter here.
fn sinh(v: f64) -> f64 {
    let e = v.exp();
    0.5 * (e - 1.0 / e)
}
