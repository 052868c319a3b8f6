//! How far an indenter is from the simple shape for which it is often taken: a sphere from its paraboloid, a worn cone from a cone.

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
    /// r times its slope, the tangent of the angle to the surface.
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

/// The simple shape that is nearest in force at the depth of a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Regime {
    /// The shape, its length in computed units.
    pub simple: Simple,
    /// Its force over that of the indenter at the same depth, less 1.
    pub force_error: f64,
    /// True where both depths count from the first touch, which is not at the axis.
    pub since_touch: bool,
}

/// Forces that agree to rounding are those of the same shape.
pub(super) const SAME_SHAPE: f64 = 1e-13;
/// Three decimals of a percentage show nothing below this.
const LEAST_PERCENT: f64 = 0.001;

/// What the parameters of a named shape make of its simple relatives.
const RELATIVES: &[(&str, &[(Kind, &str)])] = &[
    ("sphere", &[(Kind::Paraboloid, "R")]),
    ("ellipsoid", &[(Kind::Paraboloid, "c^2/b")]),
    ("hyperboloid", &[(Kind::Paraboloid, "b^2/h"), (Kind::Cone, "h/b")]),
    ("truncated-cone", &[(Kind::Cone, "tan(theta)"), (Kind::Flat, "b")]),
    ("truncated-paraboloid", &[(Kind::Paraboloid, "R"), (Kind::Flat, "b")]),
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
    /// The relatives of a named shape with these parameters; a formula that needs others is left out.
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

    /// The paraboloid or cone that a profile is at its tip; `None` where it is neither, or nothing else.
    pub(super) fn tip(profile: impl Fn(f64) -> Option<f64>, scale: f64) -> Option<Self> {
        const NEAR: f64 = 1e-6;
        let (small, large) = (NEAR * scale, 10.0 * NEAR * scale);
        let (low, high) = (profile(small)?, profile(large)?);
        if low == 0.0 && high == 0.0 {
            // A flat end: as far as the profile stays flat.
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

    /// F at a depth (Popov & Heß (3.13), (3.44), (3.1)).
    pub fn force(self, effective_modulus: f64, depth: f64) -> f64 {
        match self {
            Self::Paraboloid { radius } => 4.0 / 3.0 * effective_modulus * (radius * depth).sqrt() * depth,
            Self::Cone { slope } => 2.0 * effective_modulus * depth * depth / PI / slope,
            Self::Flat { radius } => 2.0 * effective_modulus * radius * depth,
        }
    }

    /// The name of the shape.
    pub fn name(self) -> &'static str {
        match self {
            Self::Paraboloid { .. } => "paraboloid",
            Self::Cone { .. } => "cone",
            Self::Flat { .. } => "flat",
        }
    }

    /// The shape with its length or slope, as a phrase.
    pub fn phrase(self, system: &System) -> String {
        let length = |own: f64| crate::contact::in_unit(own, &(system.out(Dimension::LENGTH), system.unit_name(Dimension::LENGTH)));
        match self {
            Self::Paraboloid { radius } => format!("a paraboloid of R = {}", length(radius)),
            Self::Cone { slope } => format!("a cone of slope {slope:?}"),
            Self::Flat { radius } => format!("a flat punch of radius {}", length(radius)),
        }
    }
}

/// Nine digits: what is seen a millionth of the way out is known to about twelve.
fn shortened(value: f64) -> f64 {
    format!("{value:.8e}").parse().unwrap_or(value)
}

impl Regime {
    /// The whole as a sentence.
    pub fn sentence(&self, system: &System) -> String {
        let percent = 100.0 * self.force_error.abs();
        let way = if self.force_error < 0.0 { "small" } else { "large" };
        let percent = if percent < LEAST_PERCENT { format!("less than {LEAST_PERCENT} %") } else { format!("{percent:.3} %") };
        let depth = if self.since_touch { "depth since the first touch" } else { "depth" };
        format!("taken for {}, the indenter's force would be {percent} too {way} at the same {depth}", self.simple.phrase(system))
    }
}
