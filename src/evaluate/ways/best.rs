//! The best of several results: ways are tried in turn until one meets the tolerance.

use crate::evaluate::evaluator::Reading;
use crate::integrate::error::TransformError;
use crate::num::Estimate;

/// The result of a way: a number; `None` if it is theoretically infinite.
pub(crate) type Answer = Result<Option<Reading>, TransformError>;

/// The best answer so far.
pub(crate) struct Best {
    tolerance: f64,
    found: Answer,
}

impl Best {
    /// The answer of the first way.
    pub(crate) fn of(tolerance: f64, found: Answer) -> Self {
        Self { tolerance, found }
    }

    /// Asks another way if the answer misses the tolerance, or if f′ has no digits or no value in the way before; keeps the
    /// better one, as [`Estimate::is_better_than`] has it.
    pub(crate) fn or(self, ask: impl FnOnce() -> Answer) -> Self {
        let is_open = match &self.found {
            Ok(Some(own)) => !own.estimate.meets(self.tolerance),
            Ok(None) => false,
            Err(error) => is_lost(error),
        };
        if !is_open {
            return self;
        }
        let found = match (self.found, ask()) {
            (Ok(Some(own)), Ok(Some(other))) if other.estimate.is_better_than(own.estimate) => Ok(Some(other)),
            (Ok(Some(own)), Ok(Some(other))) => Ok(Some(Reading { estimate: own.estimate.sharpened_by(other.estimate), ..own })),
            (Ok(Some(own)), Ok(None)) if own.estimate.value.is_nan() => Ok(None),
            (Ok(Some(own)), Err(error)) if !own.estimate.error.is_finite() => Err(error),
            (Err(_), Ok(Some(other))) => Ok(Some(other)),
            (own, _) => own,
        };
        Self { found, ..self }
    }

    /// The best of all answers.
    pub(crate) fn answer(self) -> Answer {
        self.found
    }
}

/// True for what another way may answer: an integral without digits, or without a value in double precision.
pub(crate) fn is_lost(error: &TransformError) -> bool {
    matches!(error, TransformError::NoDigits { .. } | TransformError::NotComputable { .. })
}

/// The number as one that quadrature found.
pub(crate) fn by_quadrature(found: Result<Option<Estimate>, TransformError>) -> Answer {
    Ok(found?.map(|estimate| Reading { estimate, method: "quadrature" }))
}
