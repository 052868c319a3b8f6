//! Profiles given as tables of points: cubic pieces whose transforms are closed, summed in logarithmic time.

mod interpolation;
mod pressure;
mod profile;
pub(crate) mod smoothing;
mod sums;
mod tree;

use crate::derive::profile::Profile;
use crate::integrate::error::TransformError;
use crate::integrate::integral::NumericProfile;
use crate::integrate::source::f_prime::FPrimeSource;
use crate::integrate::table_error::TableError;
use crate::num::Bounded;

pub use interpolation::Interpolation;
use pressure::Bends;
pub use smoothing::Penalty;
use std::sync::{Arc, OnceLock};
use tree::{Moments, Tree};

/// A cubic on one piece: f = c₀ + c₁δ + c₂δ² + c₃δ³, δ = r − lower, for lower ≤ r ≤ upper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cubic {
    /// Lower end.
    pub lower: f64,
    /// Upper end.
    pub upper: f64,
    /// c₀ to c₃.
    pub coefficients: [f64; 4],
}

impl Cubic {
    /// f′ at δ.
    pub fn f_prime(&self, delta: f64) -> f64 {
        let [_, c1, c2, c3] = self.coefficients;
        c1 + delta * (2.0 * c2 + 3.0 * c3 * delta)
    }

    /// f″ at δ.
    pub fn second(&self, delta: f64) -> f64 {
        let [_, _, c2, c3] = self.coefficients;
        2.0 * c2 + 6.0 * c3 * delta
    }

    /// The sum of the magnitudes in f′, of which its rounding is a share.
    pub(crate) fn f_prime_size(&self, delta: f64) -> f64 {
        let [_, c1, c2, c3] = self.coefficients;
        c1.abs() + delta * (2.0 * c2.abs() + 3.0 * c3.abs() * delta)
    }

    pub(crate) fn second_size(&self, delta: f64) -> f64 {
        let [_, _, c2, c3] = self.coefficients;
        2.0 * c2.abs() + 6.0 * c3.abs() * delta
    }

    fn is_finite(&self) -> bool {
        self.coefficients.iter().all(|c| c.is_finite())
    }
}

/// A profile made of cubic pieces, as a table of points becomes by [`Interpolation`].
///
/// Errors of its quantities are those of evaluating the pieces as they stand; how far the pieces are from the true
/// surface is a matter of the points and of the interpolation. The first quantity asked for sums up the pieces
/// (10⁴ of them: some tenths of a second); every further value of g, F and G costs the logarithm of their number.
pub struct TableProfile {
    pieces: Vec<Cubic>,
    extrapolated: Option<f64>,
    tree: OnceLock<(Tree, Vec<Moments>)>,
    bends: OnceLock<Bends>,
}

impl Profile {
    /// f from points (r, z) with rising radii; f(0) is subtracted.
    ///
    /// The profile ends at the last radius. Where the first one lies beyond the axis, an even parabola leads there, and
    /// [`TableProfile::extrapolated`] says so.
    ///
    /// ```
    /// use sneddon::contact::Contact;
    /// use sneddon::transform::{Interpolation, Profile};
    /// let r: Vec<f64> = (0..=40).map(|i| 0.05 * f64::from(i)).collect();
    /// let z: Vec<f64> = r.iter().map(|r| r * r / 4.0).collect();
    /// let tip = Profile::from_points(&r, &z, Interpolation::MonotoneCubic).unwrap();
    /// let contact = Contact::new(tip, 1.0, None, 1e-12);
    /// // d = a²/2 for the paraboloid r²/4
    /// assert!((contact.depth(1.0).unwrap().estimate.value - 0.5).abs() < 1e-14);
    /// assert!(contact.force(2.5).is_err());
    /// ```
    ///
    /// # Errors
    /// [`TransformError::Table`] with the place and the reason.
    pub fn from_points(r: &[f64], z: &[f64], interpolation: Interpolation) -> Result<TableProfile, TransformError> {
        let pieces = interpolation::interpolate(r, z, interpolation)?;
        let extrapolated = r.first().copied().filter(|first| *first > 0.0 && pieces.first().is_some_and(|p| p.upper <= *first));
        Ok(TableProfile::new(pieces, extrapolated))
    }
}

impl TableProfile {
    fn new(pieces: Vec<Cubic>, extrapolated: Option<f64>) -> Self {
        Self { pieces, extrapolated, tree: OnceLock::new(), bends: OnceLock::new() }
    }

    /// A profile from cubic pieces, the first of which begins at the axis; each begins where the one before ends.
    ///
    /// f is taken to be continuous; where f′ jumps the profile has a kink.
    ///
    /// # Errors
    /// [`TableError::TooFew`] without pieces, [`TableError::Piece`] for one that is empty, not finite or does not join.
    pub fn from_cubics(pieces: Vec<Cubic>) -> Result<Self, TransformError> {
        let mut end = 0.0;
        for (index, piece) in pieces.iter().enumerate() {
            let joined = piece.lower == end && piece.upper > piece.lower && piece.upper.is_finite() && piece.is_finite();
            if !joined {
                return Err(TableError::Piece { index }.into());
            }
            end = piece.upper;
        }
        if pieces.is_empty() {
            return Err(TableError::TooFew { given: 0, needed: 1 }.into());
        }
        Ok(Self::new(pieces, None))
    }

    /// The cubic pieces, from the axis outward.
    pub fn pieces(&self) -> &[Cubic] {
        &self.pieces
    }

    /// The first radius of the table where it lies beyond the axis: below it f is an even parabola that no point supports.
    pub fn extrapolated(&self) -> Option<f64> {
        self.extrapolated
    }

    /// f′ on its pieces, for separate integration.
    pub fn numeric(&self) -> NumericProfile {
        let source = |piece: &Cubic| (piece.lower, Some(piece.upper), Arc::new(*piece) as Arc<dyn FPrimeSource>);
        NumericProfile::from_sources(self.pieces.iter().map(source))
    }

    /// A value with its size on the piece that has r, as a number with the rounding of its terms.
    pub(crate) fn at(&self, r: f64, value: impl Fn(&Cubic, f64) -> (f64, f64)) -> Bounded {
        let Some(piece) = self.piece(r).and_then(|index| self.pieces.get(index)) else { return Bounded::exact(0.0) };
        let (value, size) = value(piece, r - piece.lower);
        Bounded { value, error: 8.0 * f64::EPSILON * size }
    }

    /// The places where f′ jumps by more than rounding, and by how much.
    pub(crate) fn jumps(&self) -> Vec<(f64, f64)> {
        let own = (1..self.pieces.len()).filter_map(|index| {
            let (at, kink) = (self.pieces.get(index)?.lower, pressure::kink(&self.pieces, index));
            (kink != 0.0).then_some((at, kink / at))
        });
        own.collect()
    }

    /// The piece that has r, the later one where two meet.
    fn piece(&self, r: f64) -> Option<usize> {
        self.pieces.partition_point(|piece| piece.lower <= r).checked_sub(1)
    }
}

impl FPrimeSource for Cubic {
    fn f_prime(&self, delta: Bounded) -> Bounded {
        let [_, c1, c2, c3] = self.coefficients.map(Bounded::exact);
        c1 + delta * (Bounded::exact(2.0) * c2 + Bounded::exact(3.0) * c3 * delta)
    }

    fn bend(&self, delta: Bounded) -> Option<Bounded> {
        let [_, _, c2, c3] = self.coefficients.map(Bounded::exact);
        let second = Bounded::exact(2.0) * c2 + Bounded::exact(6.0) * c3 * delta;
        Some(FPrimeSource::f_prime(self, delta) + (Bounded::exact(self.lower) + delta) * second)
    }
}
