//! Expressions to numbers: one walk over the tree that computes, bounds, differentiates or records, depending on the algebra.
//!
//! The same walk that evaluates a tree also records the [`Tape`], so both do the same operations in the same order, bit for bit.

mod algebra;
mod blocks;
mod cost;
mod error;
mod second;
mod series;
mod tape;
mod third;
mod walk;

pub use algebra::{
    Algebra, BoundedAlgebra, ComplexAlgebra, FloatAlgebra, IntervalAlgebra, Kept, KeptValues, RegionAlgebra, RoundingAlgebra,
};
pub use blocks::{BlockInput, BlockScratch};
pub use cost::Cost;
pub use error::EvalError;
pub use second::PreciseAlgebra;
pub use series::{Series, SeriesError, power_series};
pub use tape::Tape;
pub use third::WideAlgebra;
pub use walk::{constant_value, first_double_from, last_double_up_to, precise_value, walk};

/// Private parts that tests in `tests/` look at; not part of the interface.
#[doc(hidden)]
pub mod inner {
    pub use super::blocks::bounded::above_inverse;
}
