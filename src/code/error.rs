//! Errors of code generation.

use crate::contact::ContactError;
use crate::eval::EvalError;
use crate::transform::TransformError;

/// Why no code can be generated for a quantity.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CodeError {
    /// The formula contains an integral.
    #[error("the formula of {quantity} contains an integral, and code is written for closed forms only")]
    NotClosed {
        /// The symbol of the quantity.
        quantity: &'static str,
    },
    /// The language has no such function, and no substitute is available.
    #[error("{quantity} calls the function {function}, which cannot be written in {language}")]
    Function {
        /// Whether the library of another language has the function.
        elsewhere: bool,
        /// The symbol of the quantity.
        quantity: &'static str,
        /// The function.
        function: String,
        /// The language.
        language: &'static str,
    },
    /// The generated function would be inaccurate.
    #[error("{quantity} at {coordinate} = {at:.1e} would be off by {ulps:.0e} units in the last place times its condition number")]
    Inaccurate {
        /// The symbol of the quantity.
        quantity: &'static str,
        /// The symbol of its coordinate.
        coordinate: &'static str,
        /// The value of the coordinate.
        at: f64,
        /// The bound.
        ulps: f64,
    },
    /// g is negative or 0.
    #[error("{quantity} is a function of the depth d > 0, and g is positive at none of the radii that were tried")]
    NoDepth {
        /// The symbol of the quantity.
        quantity: &'static str,
    },
    /// The values of the code could not be compared.
    #[error("the accuracy of {quantity} is unknown, because it has no value with a bound at any of the points that were tried")]
    NoValue {
        /// The symbol of the quantity.
        quantity: &'static str,
    },
    /// The profile has no contact of this kind.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// The profile cannot be transformed.
    #[error(transparent)]
    Transform(#[from] TransformError),
    /// An expression that cannot be evaluated.
    #[error(transparent)]
    Evaluation(#[from] EvalError),
    /// An internal error: the text of the stable forms cannot be parsed.
    #[error("the stable forms cannot be read; this is a fault of the program")]
    Forms,
}

impl CodeError {
    /// Advice on how to proceed.
    pub fn accepted(&self) -> &'static str {
        match self {
            Self::NotClosed { .. } => "choose quantities that derive shows without an integral, or compute with eval",
            Self::Function { elsewhere: true, .. } => "choose a language that has the function, such as Python, or compute with eval",
            Self::Function { elsewhere: false, .. } => "compute it with eval, in Python with sneddon.Contact, or choose other quantities",
            Self::NoDepth { .. } => "choose quantities that are functions of the contact radius: g, F, p, d",
            Self::Inaccurate { .. } | Self::NoValue { .. } => {
                "compute it with eval, in Python with sneddon.Contact, or choose other quantities"
            }
            _ => "expected a profile with a closed form",
        }
    }
}
