//! The variables in which f′(r)/√(x² − r²) becomes a smooth even function, r/x = cos τ.

use super::super::even::{Nodes, Stage};
use super::Radii;

/// Places that are asked together.
pub(crate) const CHUNK: usize = 16;

/// Room for the places of one chunk.
pub(crate) struct Room {
    r: [f64; CHUNK],
    past: [f64; CHUNK],
    below: [f64; CHUNK],
    factor: [f64; CHUNK],
}

impl Room {
    pub(crate) const fn new() -> Self {
        Self { r: [0.0; CHUNK], past: [0.0; CHUNK], below: [0.0; CHUNK], factor: [0.0; CHUNK] }
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
    /// τ there.
    pub(crate) angle: f64,
}

impl Extent {
    /// The piece from `lower` to `x`, both below `limit`.
    pub(crate) fn new(lower: f64, x: f64, limit: Option<f64>) -> Self {
        let rest = limit.map_or(0.0, |limit| limit - x);
        if lower == 0.0 {
            return Self { x, rest, sine: 1.0, cosine: 0.0, angle: std::f64::consts::FRAC_PI_2 };
        }
        let root = ((x - lower) * (x + lower)).sqrt();
        Self { x, rest, sine: root / x, cosine: lower / x, angle: root.atan2(lower) }
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
    Angle,
    /// Next to a limit: sin τ = ε sinh(reach·z), where f′ ~ 1/√(ε² + sin²τ) in general.
    NearSine { small: f64, reach: f64 },
    /// The same in τ itself.
    NearAngle { small: f64, reach: f64 },
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
                return Self::NearAngle { small, reach: (extent.angle / small).asinh() };
            }
        }
        match (odd, extent.cosine == 0.0) {
            (true, true) => Self::AxisSine,
            (false, true) => Self::AxisAngle,
            (true, false) => Self::Sine,
            (false, false) => Self::Angle,
        }
    }

    /// What the mean of the integrand is to be multiplied by.
    pub(crate) fn scale(self, extent: &Extent) -> f64 {
        match self {
            Self::AxisSine => 1.0,
            Self::AxisAngle => std::f64::consts::FRAC_PI_2,
            Self::Sine => extent.sine,
            Self::Angle => extent.angle,
            Self::NearSine { reach, .. } | Self::NearAngle { reach, .. } => reach,
        }
    }

    /// Computes the places of nodes `from` … `to` of a list, at most [`CHUNK`]; `exact`: x − r with all its digits.
    #[inline]
    pub(crate) fn place<'a>(
        self,
        extent: &Extent,
        nodes: &'a Nodes,
        (from, to): (usize, usize),
        exact: bool,
        room: &'a mut Room,
    ) -> Option<Placed<'a>> {
        let near = matches!(self, Self::NearSine { .. } | Self::NearAngle { .. });
        let Extent { x, rest, sine, cosine, angle } = *extent;
        let count = to - from;
        let (r, below) = (room.r.get_mut(..count)?, room.below.get_mut(..count)?);
        let axis = |cosines: &[f64], versines: &[f64], r: &mut [f64], below: &mut [f64]| {
            for ((r, below), (c, versine)) in r.iter_mut().zip(below).zip(cosines.iter().zip(versines)) {
                *r = x * c;
                *below = rest + x * versine;
            }
        };
        match self {
            Self::AxisSine => {
                axis(nodes.cosine.get(from..to)?, nodes.sine_versine.get(from..to)?, r, below);
                Some(Placed { at: Radii { r, past_start: r, below_limit: below }, factor: Some(nodes.secant.get(from..to)?) })
            }
            Self::AxisAngle => {
                axis(nodes.quarter.get(from..to)?, nodes.versine.get(from..to)?, r, below);
                Some(Placed { at: Radii { r, past_start: r, below_limit: below }, factor: None })
            }
            _ => {
                let (past, factor) = (room.past.get_mut(..count)?, room.factor.get_mut(..count)?);
                let z = nodes.z.get(from..to)?;
                for ((((r, past), below), factor), z) in r.iter_mut().zip(&mut *past).zip(&mut *below).zip(&mut *factor).zip(z) {
                    let s = match self {
                        Self::Sine => sine * z,
                        Self::NearSine { small, reach } => (small * sinh(reach * z)).min(sine),
                        Self::NearAngle { small, reach } => {
                            let tau = (small * sinh(reach * z)).min(angle);
                            *factor = (small * small + tau * tau).sqrt();
                            tau.sin()
                        }
                        _ => (angle * z).sin(),
                    };
                    let c = ((1.0 - s) * (1.0 + s)).sqrt();
                    // cos τ − cos τ_b = (sin²τ_b − sin²τ)/(cos τ + cos τ_b), and 1/c by the same division.
                    let over = 1.0 / (c * (c + cosine));
                    if cosine == 0.0 {
                        *past = x * c;
                        *r = *past;
                    } else {
                        *past = x * ((sine - s) * (sine + s) * (over * c));
                        *r = x * cosine + *past;
                    }
                    match self {
                        Self::Sine => *factor = over * (c + cosine),
                        Self::NearSine { small, .. } => *factor = (small * small + s * s).sqrt() * (over * (c + cosine)),
                        Self::NearAngle { .. } => {}
                        _ => *factor = 1.0,
                    }
                    *below = if near || exact { rest + x * (s * s / (1.0 + c)) } else { rest + (x - *r) };
                }
                Some(Placed { at: Radii { r, past_start: past, below_limit: below }, factor: Some(factor) })
            }
        }
    }

    /// r/x at nodes of the forms that begin at the axis.
    pub(crate) fn radii(self, nodes: &Nodes) -> Option<&[f64]> {
        match self {
            Self::AxisSine => Some(&nodes.cosine),
            Self::AxisAngle => Some(&nodes.quarter),
            _ => None,
        }
    }

    /// What a relative rounding of every r by one unit does to the mean: ∫ |r df′/dr| dτ.
    #[inline]
    pub(crate) fn displacement(self, extent: &Extent, stage: &Stage, values: &[f64]) -> f64 {
        let steps = values.iter().zip(values.get(1..).unwrap_or_default());
        let weighted = |cotangents: &[f64]| {
            let mut lanes = [0.0; 2];
            for (i, ((a, b), c)) in steps.clone().zip(cotangents).enumerate() {
                lanes[i & 1] += (b - a).abs() * c;
            }
            lanes[0] + lanes[1]
        };
        match self {
            Self::AxisSine => weighted(&stage.cotangents),
            Self::AxisAngle => weighted(&stage.quarter_cotangents) / std::f64::consts::FRAC_PI_2,
            // cot τ < 1/τ, and the ends of the piece are rounded too.
            Self::Sine => 4.0 * weighted(&stage.reciprocals) / (extent.sine * extent.sine),
            Self::Angle => 4.0 * weighted(&stage.reciprocals) / (extent.angle * extent.angle),
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
