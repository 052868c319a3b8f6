//! Compares an indenter with the simple shape that often replaces it, such as a sphere with its paraboloid or a worn cone with a cone.

use super::{Dimension, System};
use crate::expr::Bindings;
use crate::parse;
use crate::scene::file::dimensioned::to_f64;
use std::f64::consts::PI;

/// A shape whose force has a textbook formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Simple {
    /// r²/(2R).
    Paraboloid {
        /// R.
        radius: f64,
    },
    /// A cone with the given slope, the tangent of the angle to the surface.
    Cone {
        /// The slope.
        slope: f64,
    },
    /// A flat cylinder.
    Flat {
        /// Its radius.
        radius: f64,
    },
}

/// The simple shape with the closest force at the depth of a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Regime {
    /// The shape, with its length in computing units.
    pub simple: Simple,
    /// The ratio of its force to the force of the indenter at the same depth, minus 1.
    pub force_error: f64,
    /// True if both depths are measured from a first touch away from the axis.
    pub since_touch: bool,
}

/// Forces that agree to this relative accuracy belong to the same shape.
pub(super) const SAME_SHAPE: f64 = 1e-13;
/// Percentages below this value are not resolved with three decimals.
const LEAST_PERCENT: f64 = 0.001;

/// Returns the simple shapes that a named shape approximates for its parameters.
const RELATIVES: &[(&str, &[(Kind, &str)])] = &[
    ("sphere", &[(Kind::Paraboloid, "R")]),
    ("ellipsoid", &[(Kind::Paraboloid, "c^2/b")]),
    ("hyperboloid", &[(Kind::Paraboloid, "b^2/h"), (Kind::Cone, "h/b")]),
    ("truncated-cone", &[(Kind::Cone, "tan(theta)"), (Kind::Flat, "b")]),
    ("truncated-paraboloid", &[(Kind::Paraboloid, "R"), (Kind::Flat, "b")]),
    ("worn-sphere", &[(Kind::Paraboloid, "R"), (Kind::Flat, "b")]),
    ("cone-with-spherical-cap", &[(Kind::Cone, "tan(theta)"), (Kind::Paraboloid, "R")]),
    ("cone-with-parabolic-cap", &[(Kind::Cone, "tan(theta)"), (Kind::Paraboloid, "R"), (Kind::Paraboloid, "b/tan(theta)")]),
    ("paraboloid-with-parabolic-cap", &[(Kind::Paraboloid, "P"), (Kind::Paraboloid, "R")]),
    ("flat-with-rounded-edge", &[(Kind::Flat, "b")]),
    ("concave-paraboloid", &[(Kind::Flat, "c")]),
    ("wavy-paraboloid", &[(Kind::Paraboloid, "R")]),
];

#[derive(Clone, Copy)]
enum Kind {
    Paraboloid,
    Cone,
    Flat,
}

impl Simple {
    /// Returns the shapes related to a named shape; a formula that needs other parameters is omitted.
    pub(super) fn relatives(shape: &str, values: &Bindings) -> Vec<Self> {
        let list = RELATIVES.iter().find(|(name, _)| *name == shape).map_or(&[][..], |(_, list)| *list);
        let number = |text: &str| {
            let formula = parse::formula(text).ok()?.substitute(values);
            let known = formula.symbols().is_empty();
            to_f64(formula.as_closed().filter(|_| known)?).ok()
        };
        list.iter()
            .filter_map(|(kind, text)| {
                let value = number(text)?;
                Some(match kind {
                    Kind::Paraboloid => Self::Paraboloid { radius: value },
                    Kind::Cone => Self::Cone { slope: value },
                    Kind::Flat => Self::Flat { radius: value },
                })
            })
            .collect()
    }

    /// Returns the paraboloid or cone that approximates a profile at its tip; `None` if there is none or the profile is one itself.
    pub(super) fn tip(profile: impl Fn(f64) -> Option<f64>, scale: f64) -> Option<Self> {
        const NEAR: f64 = 1e-6;
        let (small, large) = (NEAR * scale, 10.0 * NEAR * scale);
        let (low, high) = (profile(small)?, profile(large)?);
        if low == 0.0 && high == 0.0 {
            // The flat part of a flat-ended profile.
            let (mut flat, mut risen) = (large, scale);
            for _ in 0..60 {
                let middle = 0.5 * (flat + risen);
                if profile(middle)? == 0.0 { flat = middle } else { risen = middle }
            }
            return Some(Self::Flat { radius: flat });
        }
        let exponent = (high / low).log10();
        let (simple, whole) = if (exponent - 2.0).abs() < 1e-3 {
            (Self::Paraboloid { radius: shortened(small * small / (2.0 * low)) }, low / NEAR / NEAR)
        } else if (exponent - 1.0).abs() < 1e-3 {
            (Self::Cone { slope: shortened(low / small) }, low / NEAR)
        } else {
            return None;
        };
        let itself = (profile(scale)? / whole - 1.0).abs() < 1e-12;
        (low > 0.0 && !itself).then_some(simple)
    }

    /// Returns F at a depth (Popov & Heß (3.13), (3.44), (3.1)).
    pub fn force(self, effective_modulus: f64, depth: f64) -> f64 {
        match self {
            Self::Paraboloid { radius } => 4.0 / 3.0 * effective_modulus * (radius * depth).sqrt() * depth,
            Self::Cone { slope } => 2.0 * effective_modulus * depth * depth / PI / slope,
            Self::Flat { radius } => 2.0 * effective_modulus * radius * depth,
        }
    }

    /// Returns the name of the shape.
    pub fn name(self) -> &'static str {
        match self {
            Self::Paraboloid { .. } => "paraboloid",
            Self::Cone { .. } => "cone",
            Self::Flat { .. } => "flat",
        }
    }

    /// Returns a phrase for the shape with its length or slope.
    pub fn phrase(self, system: &System) -> String {
        let length = |own: f64| crate::contact::in_unit(own, &(system.out(Dimension::LENGTH), system.unit_name(Dimension::LENGTH)));
        match self {
            Self::Paraboloid { radius } => format!("a paraboloid of R = {}", length(radius)),
            Self::Cone { slope } => format!("a cone of slope {slope:?}"),
            Self::Flat { radius } => format!("a flat punch of radius {}", length(radius)),
        }
    }
}

/// Rounds to nine digits; extrapolation from a millionth of the radius is accurate to about twelve.
fn shortened(value: f64) -> f64 {
    format!("{value:.8e}").parse().unwrap_or(value)
}

impl Regime {
    /// Returns a sentence about the comparison.
    pub fn sentence(&self, system: &System) -> String {
        let percent = 100.0 * self.force_error.abs();
        let way = if self.force_error < 0.0 { "small" } else { "large" };
        let percent = if percent < LEAST_PERCENT { format!("less than {LEAST_PERCENT} %") } else { format!("{percent:.3} %") };
        let depth = if self.since_touch { "depth since the first touch" } else { "depth" };
        format!("treating the indenter as {} gives a force {percent} too {way} at the same {depth}", self.simple.phrase(system))
    }
}
