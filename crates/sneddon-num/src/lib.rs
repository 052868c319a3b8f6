//! Numbers without symbols: special functions, quadrature, root finding and values that carry their error.

pub mod bounded;
pub mod chebyshev;
pub mod double_double;
pub mod error;
pub mod estimate;
pub mod forms;
pub mod kappa;
pub mod legendre;
pub mod precise;
pub mod quadrature;
mod real_power;
mod region;
pub mod roots;
pub mod special;
pub mod spectral;
pub mod stable;
mod wide;
pub mod work;

pub use bounded::Bounded;
pub use double_double::{DoubleDouble, Precise};
pub use error::NumError;
pub use estimate::{Bound, Estimate};
pub use real_power::real_power;
pub use real_power::{corrected_power, real_power_part};
pub use region::Region;
pub use wide::Wide;
pub use work::{Budget, Exhausted};
