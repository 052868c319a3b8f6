//! Common mistakes applied to a scene, such as a diameter used as a radius or an angle replaced by its complement.

use crate::expr::Expr;
use crate::scene::DimensionedNumber;

/// The change to apply while a scene is read; all other values stay as typed.
#[derive(Clone, Debug, PartialEq)]
pub enum Change {
    /// No change.
    None,
    /// A parameter of the profile, or its `radius`, is multiplied by a fraction.
    Times {
        /// The name of the parameter.
        name: String,
        /// Numerator and denominator.
        ratio: (i64, i64),
    },
    /// An angle is multiplied by a power of 180/π.
    Turn {
        /// The name of the parameter.
        name: String,
        /// 1 if radians are replaced by degrees, −1 for the reverse.
        degrees: i8,
    },
    /// An angle is replaced by its complement.
    Complement {
        /// The name of the parameter.
        name: String,
    },
    /// Poisson's ratios are set to 0, so that E is used as E*.
    NoPoisson,
}

impl Change {
    /// Returns the quantity after the change.
    pub(in crate::scene) fn of(&self, name: &str, quantity: &DimensionedNumber) -> DimensionedNumber {
        match self {
            Self::Times { name: own, ratio } if own == name => quantity.times(&Expr::ratio(ratio.0, ratio.1)),
            Self::Turn { name: own, degrees } if own == name => quantity.turned(i64::from(*degrees)),
            Self::Complement { name: own } if own == name => quantity.complement(),
            _ => quantity.clone(),
        }
    }
}
