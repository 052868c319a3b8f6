//! Profiles given as Rust closures: their declared properties, and their quantities by quadrature.

pub(crate) mod cells;
mod profile;
mod source;
mod starts;

use crate::derive::profile::Profile;
use crate::integrate::error::TransformError;
use num_complex::Complex64;
pub use profile::ClosureProfile;
use source::{Function, Real};
use std::sync::Arc;

/// How f continues to negative radii.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parity {
    /// f(−r) = f(r).
    Even,
    /// f(−r) = −f(r).
    Odd,
}

/// A profile f(r) as Rust code with declared properties; [`Closure::profile`] converts it to a profile.
///
/// | constructor | f′ | f″, for the pressure |
/// |---|---|---|
/// | [`complex`](Self::complex) | complex step, as accurate as f | interpolation of f′: two to four digits are lost |
/// | [`with_f_primes`](Self::with_f_primes) | given | given |
/// | [`with_f_prime`](Self::with_f_prime) | given | interpolation of f′, as above |
/// | [`real`](Self::real) | interpolation of f: two to four digits are lost | interpolation: five to seven digits are lost |
///
/// The loss by interpolation is estimated from the coefficients and included in the error of every result.
/// A panic of the closure occurs in the caller's thread.
#[derive(Clone)]
pub struct Closure {
    function: Function,
    breakpoints: Vec<f64>,
    limit: f64,
    exponent: Option<f64>,
    parity: Option<Parity>,
    ulps: f64,
    tolerance: f64,
}

impl Profile {
    /// f as a function of a complex radius, analytic along r > 0: f′ is computed by a complex step without loss of digits.
    ///
    /// ```
    /// use sneddon::contact::Contact;
    /// use sneddon::transform::Profile;
    /// // f = ln cosh r, which has no closed form
    /// let tip = Profile::from_fn(|r| r.cosh().ln()).profile().unwrap();
    /// let contact = Contact::new(tip, 1.0, None, 1e-12);
    /// let d = contact.depth(1.0).unwrap().estimate;
    /// assert!((d.value - 0.830_719_5).abs() < 1e-7 && d.error < 1e-12);
    /// ```
    ///
    /// [`Closure`] has the other constructors and the properties that may be declared.
    pub fn from_fn(f: impl Fn(Complex64) -> Complex64 + Send + Sync + 'static) -> Closure {
        Closure::complex(f)
    }
}

impl Closure {
    fn new(function: Function) -> Self {
        Self { function, breakpoints: Vec::new(), limit: f64::INFINITY, exponent: None, parity: None, ulps: 8.0, tolerance: 1e-12 }
    }

    /// f as a function of a complex radius.
    ///
    /// f must be analytic along r > 0, piece by piece. `asin`, `acos` and `atan` of `num-complex` lose a small imaginary
    /// part, as `abs` does; [`Self::profile`] detects this and returns an error.
    pub fn complex(f: impl Fn(Complex64) -> Complex64 + Send + Sync + 'static) -> Self {
        Self::new(Function::Complex(Arc::new(f)))
    }

    /// f and f′.
    ///
    /// ```
    /// use sneddon::transform::{Closure, Quantities};
    /// let hertz = Closure::with_f_prime(|r| r * r / 4.0, |r| r / 2.0).profile().unwrap();
    /// let g = hertz.equivalent(3.0).unwrap().estimate;
    /// assert!((g.value - 4.5).abs() <= g.error && g.error < 1e-11);
    /// ```
    pub fn with_f_prime(f: impl Fn(f64) -> f64 + Send + Sync + 'static, f_prime: impl Fn(f64) -> f64 + Send + Sync + 'static) -> Self {
        Self::new(Function::FPrime(Arc::new(f), Arc::new(f_prime)))
    }

    /// f, f′ and f″.
    pub fn with_f_primes(
        f: impl Fn(f64) -> f64 + Send + Sync + 'static,
        f_prime: impl Fn(f64) -> f64 + Send + Sync + 'static,
        second: impl Fn(f64) -> f64 + Send + Sync + 'static,
    ) -> Self {
        let (f, f_prime): (Real, Real) = (Arc::new(f), Arc::new(f_prime));
        Self::new(Function::Bend(f, f_prime, Arc::new(second)))
    }

    /// f alone: f′ by interpolation, with two to four digits lost.
    pub fn real(f: impl Fn(f64) -> f64 + Send + Sync + 'static) -> Self {
        Self::new(Function::Real(Arc::new(f)))
    }

    /// The radii at which f is not smooth, in increasing order. Undeclared kinks reduce the accuracy.
    #[must_use]
    pub fn breakpoints(mut self, radii: impl IntoIterator<Item = f64>) -> Self {
        self.breakpoints = radii.into_iter().collect();
        self
    }

    /// The radius R at which the profile ends; f need not be defined at and beyond R.
    #[must_use]
    pub fn limit(mut self, limit: f64) -> Self {
        self.limit = limit;
        self
    }

    /// n of f ~ C rⁿ at the axis. By default, whether n is a whole number is determined from samples of f′.
    #[must_use]
    pub fn leading_exponent(mut self, n: f64) -> Self {
        self.exponent = Some(n);
        self
    }

    /// Declares f even or odd, for closures without a value at r < 0 or near the axis: an even f is smooth there
    /// and starts as r², an odd f as r, unless a leading exponent is given too. An even f needs fewer values.
    #[must_use]
    pub fn parity(mut self, parity: Parity) -> Self {
        let lowest = match parity {
            Parity::Even => 2.0,
            Parity::Odd => 1.0,
        };
        self.exponent = self.exponent.or(Some(lowest));
        self.parity = Some(parity);
        self
    }

    /// The error of the closure's values in units in the last place; 8 by default.
    #[must_use]
    pub fn ulps(mut self, ulps: f64) -> Self {
        self.ulps = ulps;
        self
    }

    /// The relative tolerance of the quadratures; 1e-12 by default.
    #[must_use]
    pub fn tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// Checks the declared properties, and f at a few radii, and returns the profile.
    ///
    /// # Errors
    /// [`TransformError::Statement`] for breakpoints that do not increase between 0 and the limit, and other numbers out of
    /// range; [`TransformError::Undefined`] if f is NaN or infinite; [`TransformError::Jump`] if f jumps at a breakpoint;
    /// [`TransformError::NotAnalytic`] if the complex step of f is not its slope.
    pub fn profile(self) -> Result<ClosureProfile, TransformError> {
        let refuse = |what, got, accepted| Err(TransformError::Statement { what, got, accepted });
        if self.limit.is_nan() || self.limit <= 0.0 {
            return refuse("the limit of r", self.limit, "a limit above 0");
        }
        let mut last = 0.0;
        for b in &self.breakpoints {
            if b.is_nan() || *b <= last || *b >= self.limit {
                return refuse("a breakpoint", *b, "increasing breakpoints between 0 and the limit");
            }
            last = *b;
        }
        if let Some(n) = self.exponent.filter(|n| n.is_nan() || *n <= 0.0 || n.is_infinite()) {
            return refuse("the leading exponent", n, "an exponent above 0");
        }
        if self.ulps.is_nan() || self.ulps < 0.0 {
            return refuse("the error in ulps", self.ulps, "a number from 0 on");
        }
        if self.tolerance.is_nan() || self.tolerance < 0.0 {
            return refuse("the tolerance", self.tolerance, "a number from 0 on");
        }
        ClosureProfile::new(self)
    }
}
