//! The variables in which f′(r)/√(x² − r²) becomes a smooth even function, r/x = cos τ.

use super::super::even::{Middles, Nodes};
use super::Radii;
use crate::stable::{halves, leg};

/// Most radii evaluated together.
pub const CHUNK: usize = 16;

/// The extent of a piece.
#[derive(Clone, Copy)]
pub struct Extent {
    /// The upper end, where the integrand's singularity is.
    pub x: f64,
    /// limit − x, 0 without a limit.
    pub rest: f64,
    /// sin τ at the lower end: √((x − b)(x + b))/x, 1 at the axis.
    pub sine: f64,
    /// cos τ there: b/x.
    pub cosine: f64,
}

impl Extent {
    /// The piece from `lower` to `x`, both below `limit`.
    pub fn new(lower: f64, x: f64, limit: Option<f64>) -> Self {
        let rest = limit.map_or(0.0, |limit| limit - x);
        if lower == 0.0 {
            return Self { x, rest, sine: 1.0, cosine: 0.0 };
        }
        let root = leg(x, lower);
        Self { x, rest, sine: root / x, cosine: lower / x }
    }

    /// τ at the lower end.
    pub fn angle(&self) -> f64 {
        if self.cosine == 0.0 { std::f64::consts::FRAC_PI_2 } else { self.sine.atan2(self.cosine) }
    }
}

/// The variable.
#[derive(Clone, Copy)]
pub enum Form {
    /// From the axis, z = sin τ.
    AxisSine,
    /// From the axis, z = 2τ/π.
    AxisAngle,
    /// From a kink, z ~ sin τ.
    Sine,
    /// From a kink, z ~ τ.
    Angle {
        /// τ at the kink.
        angle: f64,
    },
    /// Next to a limit: sin τ = ε sinh(reach·z), where f′ ~ 1/√(ε² + sin²τ) in general.
    NearSine {
        /// ε.
        small: f64,
        /// The range of the variable.
        reach: f64,
    },
    /// Next to a limit, as [`Self::NearSine`] but in τ.
    NearAngle {
        /// ε, as an angle.
        small: f64,
        /// The range of the variable.
        reach: f64,
        /// τ at the lower end.
        angle: f64,
    },
}

impl Form {
    /// The variable for a piece that ends at x.
    pub fn choose(extent: &Extent, odd: bool, limit: Option<f64>) -> Self {
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

    /// The largest x for which an odd f′ that ends at the limit needs no special variable.
    pub fn plain_below(limit: f64) -> f64 {
        limit / NEAR.hypot(1.0)
    }

    /// The factor between the mean of the integrand and the integral.
    pub fn scale(self, extent: &Extent) -> f64 {
        match self {
            Self::AxisSine => 1.0,
            Self::AxisAngle => std::f64::consts::FRAC_PI_2,
            Self::Sine => extent.sine,
            Self::Angle { angle } => angle,
            Self::NearSine { reach, .. } | Self::NearAngle { reach, .. } => reach,
        }
    }

    /// Shows the places of a few nodes, at most `N`, and the factor that makes an integrand of f′ there; no factor is 1.
    ///
    /// `exact`: x − r with all its digits.
    #[inline(always)]
    pub fn visit<const N: usize>(self, extent: &Extent, nodes: Nodes<'_>, exact: bool, show: impl FnOnce(Radii<'_>, Option<&[f64]>)) {
        let (cosines, versines, factor) = match self {
            Self::AxisSine => (nodes.cosine, nodes.sine_versine, Some(nodes.secant)),
            Self::AxisAngle => (nodes.quarter, nodes.versine, None),
            Self::Angle { angle } => return from_a_kink::<N>(extent, nodes, 0.5 * angle, show),
            Self::Sine => return from_a_kink_by_sine::<N>(extent, nodes, exact, show),
            Self::NearSine { small, reach } => return near_a_limit::<N>(extent, nodes, (small, reach, None), show),
            Self::NearAngle { small, reach, angle } => return near_a_limit::<N>(extent, nodes, (small, reach, Some(angle)), show),
        };
        let (mut r, mut below) = ([0.0; N], [0.0; N]);
        for ((r, below), (cosine, versine)) in r.iter_mut().zip(&mut below).zip(cosines.iter().zip(versines)) {
            *r = extent.x * cosine;
            *below = extent.rest + extent.x * versine;
        }
        if let Self::AxisSine = self {
            // x times the cosine with one rounding: of a wave, every rounding of r shows.
            let (high, low) = halves(extent.x);
            for (r, (cosine, rest)) in r.iter_mut().zip(nodes.split.0.iter().zip(nodes.split.1)) {
                *r = high * cosine + (low * cosine + extent.x * rest);
            }
        }
        if let (Some(r), Some(below)) = (r.get(..nodes.z.len()), below.get(..nodes.z.len())) {
            show(Radii { r, past_start: r, below_limit: below }, factor);
        }
    }

    /// r/x at nodes of the forms that begin at the axis.
    pub fn radii(self, nodes: Nodes<'_>) -> Option<&[f64]> {
        match self {
            Self::AxisSine => Some(nodes.cosine),
            Self::AxisAngle => Some(nodes.quarter),
            _ => None,
        }
    }

    /// The change of the mean when every r is rounded by one relative unit: ∫ |r df′/dr| dτ.
    #[inline(always)]
    pub fn displacement(self, extent: &Extent, middles: Middles<'_>, values: &[f64]) -> f64 {
        let (cotangents, by) = match self {
            Self::AxisSine => (middles.cotangents, 1.0),
            Self::AxisAngle => (middles.quarter_cotangents, std::f64::consts::FRAC_2_PI),
            // cot τ < 1/τ, and the ends of the piece are rounded too.
            Self::Sine => (middles.reciprocals, 4.0 / (extent.sine * extent.sine)),
            Self::Angle { angle } => (middles.reciprocals, 4.0 / (angle * angle)),
            // Next to a limit f′ is a function of the distance to it.
            Self::NearSine { .. } | Self::NearAngle { .. } => return 0.0,
        };
        const LANES: usize = 4;
        let mut lanes = [0.0; LANES];
        let next = values.get(1..).unwrap_or_default();
        let whole = values.as_chunks::<LANES>().0.iter().zip(next.as_chunks::<LANES>().0).zip(cotangents.as_chunks::<LANES>().0);
        for ((a, b), c) in whole {
            for i in 0..LANES {
                lanes[i] += (b[i] - a[i]).abs() * c[i];
            }
        }
        let (rest, from) = (cotangents.as_chunks::<LANES>().1, cotangents.len() - cotangents.len() % LANES);
        for ((a, b), c) in values.iter().skip(from).zip(next.iter().skip(from)).zip(rest) {
            lanes[0] += (b - a).abs() * c;
        }
        by * ((lanes[0] + lanes[1]) + (lanes[2] + lanes[3]))
    }
}

/// Below this distance of the branch points the integrand is stretched.
const NEAR: f64 = 2.5;

/// The places r = x cos τ at angles τ = 2·`half`·z: by h = sin(τ/2), x − r = 2x h² and r − b = 2x(h_b − h)(h_b + h).
///
/// Next to the kink h_b − h is taken from 1 − z: sin u − sin v = 2 cos((u + v)/2) sin((u − v)/2).
#[inline]
fn from_a_kink<const N: usize>(extent: &Extent, nodes: Nodes<'_>, half: f64, show: impl FnOnce(Radii<'_>, Option<&[f64]>)) {
    let Extent { x, rest, cosine, .. } = *extent;
    let (mut r, mut below, mut past) = ([0.0; N], [0.0; N], [0.0; N]);
    let (lower, end) = (x * cosine, short_sine(half));
    let z = nodes.z;
    for (((r, past), below), (z, c)) in r.iter_mut().zip(&mut past).zip(&mut below).zip(z.iter().zip(nodes.cosine)) {
        let h = short_sine(half * z);
        let quarter = short_sine(0.25 * half * (1.0 + z));
        let rise = 2.0 * (1.0 - 2.0 * (quarter * quarter)) * short_sine(0.5 * half * (c * c / (1.0 + z)));
        *past = 2.0 * x * (rise * (end + h));
        *r = lower + *past;
        *below = rest + 2.0 * x * (h * h);
    }
    if let (Some(r), Some(past_start), Some(below_limit)) = (r.get(..z.len()), past.get(..z.len()), below.get(..z.len())) {
        show(Radii { r, past_start, below_limit }, None);
    }
}

/// The places next to a limit: sin τ, or τ where the angle of the lower end is given, is ε sinh(reach·z).
#[inline(never)]
fn near_a_limit<const N: usize>(
    extent: &Extent,
    nodes: Nodes<'_>,
    (small, reach, angle): (f64, f64, Option<f64>),
    show: impl FnOnce(Radii<'_>, Option<&[f64]>),
) {
    let Extent { x, rest, sine, cosine } = *extent;
    let (mut r, mut below, mut past, mut factor) = ([0.0; N], [0.0; N], [0.0; N], [0.0; N]);
    let (lower, from_axis, count) = (x * cosine, cosine == 0.0, nodes.z.len());
    let lists = r.iter_mut().zip(&mut past).zip(below.iter_mut().zip(&mut factor));
    for (((r, past), (below, factor)), (z, rest_of_z)) in lists.zip(nodes.z.iter().zip(nodes.cosine)) {
        let stretched = (small * sinh(reach * z)).min(angle.unwrap_or(sine));
        let s = if angle.is_some() { stretched.sin() } else { stretched };
        let c = if from_axis {
            let c = ((1.0 - s) * (1.0 + s)).sqrt();
            *past = x * c;
            c
        } else {
            // What the variable lacks at its end, from 1 − z: the difference of both would be rounding alone next to the kink.
            let short = reach * (rest_of_z * rest_of_z / (1.0 + z));
            let gap = 2.0 * small * (reach - 0.5 * short).cosh() * (0.5 * short).sinh();
            // sin²τ_b − sin²τ
            let share = angle.map_or(gap * (sine + s), |angle| gap.sin() * (angle + stretched).sin());
            let c = (cosine * cosine + share).sqrt();
            // cos τ − cos τ_b = (sin²τ_b − sin²τ)/(cos τ + cos τ_b)
            *past = x * (share / (c + cosine));
            c
        };
        *r = lower + *past;
        *below = rest + x * (s * s / (1.0 + c));
        let stretch = (small * small + stretched * stretched).sqrt();
        *factor = if angle.is_some() { stretch } else { stretch / c };
    }
    if let (Some(r), Some(past_start), Some(below_limit), factor) =
        (r.get(..count), past.get(..count), below.get(..count), factor.get(..count))
    {
        show(Radii { r, past_start, below_limit }, factor);
    }
}

/// The places r = x cos τ with sin τ = z sin τ_b, where the factor is 1/cos τ.
#[inline]
fn from_a_kink_by_sine<const N: usize>(extent: &Extent, nodes: Nodes<'_>, exact: bool, show: impl FnOnce(Radii<'_>, Option<&[f64]>)) {
    let Extent { x, rest, sine, cosine } = *extent;
    let (mut r, mut below, mut past, mut secants) = ([0.0; N], [0.0; N], [0.0; N], [0.0; N]);
    let (lower, count) = (x * cosine, nodes.z.len());
    let lists = r.iter_mut().zip(&mut past).zip(below.iter_mut().zip(&mut secants));
    for (((r, past), (below, secant)), (z, rest_of_z)) in lists.zip(nodes.z.iter().zip(nodes.cosine)) {
        let s = sine * z;
        // sin²τ_b − sin²τ = sin²τ_b (1 − z²): next to the kink the difference of both sines would be rounding alone.
        let share = (sine * rest_of_z) * (sine * rest_of_z);
        // Of positive parts: far beyond the kink sin τ is next to 1 there, and 1 − sin²τ would have few digits.
        let c = (cosine * cosine + share).sqrt();
        // cos τ − cos τ_b = share/(cos τ + cos τ_b), and 1/cos τ by the same division.
        let over = 1.0 / (c * (c + cosine));
        *past = x * (share * (over * c));
        *r = lower + *past;
        *below = rest + if exact { x * (s * s / (1.0 + c)) } else { x - *r };
        *secant = over * (c + cosine);
    }
    if let (Some(r), Some(past_start), Some(below_limit), factor) =
        (r.get(..count), past.get(..count), below.get(..count), secants.get(..count))
    {
        show(Radii { r, past_start, below_limit }, factor);
    }
}

/// sin v for 0 ≤ v ≤ π/4, without a call: sin v/v in powers of v², which leave out 3e−18.
#[inline(always)]
fn short_sine(v: f64) -> f64 {
    const POWERS: [f64; 7] = [
        1.0,
        -0.166_666_666_666_666_16,
        0.008_333_333_333_320_363,
        -0.000_198_412_698_286_503,
        2.755_731_337_640_013e-6,
        -2.505_071_697_410_274_5e-8,
        1.589_473_665_184_909_4e-10,
    ];
    let y = v * v;
    let [one, a, b, c, d, e, f] = POWERS;
    v * (one + y * (a + y * (b + y * (c + y * (d + y * (e + y * f))))))
}

/// sinh v for v ≥ 0; next to 0 its last digits do not matter here.
fn sinh(v: f64) -> f64 {
    let e = v.exp();
    0.5 * (e - 1.0 / e)
}
