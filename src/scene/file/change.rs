//! One thing of a scene taken for another, as it happens to people: a radius for a diameter, an angle for its complement.

use crate::expr::Expr;
use crate::scene::DimensionedNumber;

/// What is changed while a scene is read; everything else stays as it was typed.
#[derive(Clone, Debug, PartialEq)]
pub enum Change {
    /// Nothing.
    None,
    /// A parameter of the profile, or its `radius`, multiplied by a fraction.
    Times {
        /// The name of the parameter.
        name: String,
        /// Numerator and denominator.
        ratio: (i64, i64),
    },
    /// An angle multiplied by a power of 180/π.
    Turn {
        /// The name of the parameter.
        name: String,
        /// 1 where radians were taken for degrees, −1 the other way round.
        degrees: i8,
    },
    /// An angle in place of what it lacks of a right one.
    Complement {
        /// The name of the parameter.
        name: String,
    },
    /// Poisson's ratios of 0: E stands for E*.
    NoPoisson,
}

impl Change {
    /// A quantity after the change.
    pub(in crate::scene) fn of(&self, name: &str, quantity: &DimensionedNumber) -> DimensionedNumber {
        match self {
            Self::Times { name: own, ratio } if own == name => quantity.times(&Expr::ratio(ratio.0, ratio.1)),
            Self::Turn { name: own, degrees } if own == name => quantity.turned(i64::from(*degrees)),
            Self::Complement { name: own } if own == name => quantity.complement(),
            _ => quantity.clone(),
        }
    }
}
