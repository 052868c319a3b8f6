//! Rounding to a number of significant digits, with error bounds that include the rounding error.

use crate::num::Estimate;

/// The number of significant digits of values in text and CSV; all digits by default.
///
/// Coordinates, loads and other inputs are always shown with all digits, because the values refer to them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Digits(Option<usize>);

impl Digits {
    /// The number of digits that identify every double.
    pub const MAXIMUM: usize = 17;

    /// Returns a rounding to `count` digits, from 1 to [`Self::MAXIMUM`]; `None` for any other number.
    ///
    /// ```
    /// use sneddon::report::Digits;
    /// assert_eq!(Digits::significant(3).unwrap().rounded(2.0 / 3.0), 0.667);
    /// assert_eq!(Digits::significant(0), None);
    /// ```
    pub fn significant(count: usize) -> Option<Self> {
        (1..=Self::MAXIMUM).contains(&count).then_some(Self(Some(count)))
    }

    /// Rounds a value and returns the double nearest to the result.
    pub fn rounded(self, value: f64) -> f64 {
        match self.0 {
            // Do not round the largest doubles to infinity.
            Some(count) => format!("{value:.*e}", count - 1).parse().ok().filter(|own: &f64| own.is_finite()).unwrap_or(value),
            None => value,
        }
    }

    /// Rounds a value and returns it with an error bound that includes the rounding; the bound is rounded up.
    pub fn shown(self, value: f64, error: f64) -> (f64, f64) {
        let shown = self.rounded(value);
        let error = if shown == value { error } else { (error + (shown - value).abs()).next_up() };
        (shown, self.rounded_up(error))
    }

    fn rounded_up(self, error: f64) -> f64 {
        let Some(count) = self.0 else { return error };
        let text = format!("{error:.*e}", count - 1);
        let Some((mantissa, exponent)) = text.split_once('e') else { return error };
        // Work in decimals, because rounding may lose a step of one double again.
        let digits = mantissa.replace('.', "").parse::<u64>().unwrap_or(u64::MAX);
        let scaled = |digits: u64| format!("{digits}e{}", exponent.parse::<i32>().unwrap_or(0) - (count as i32 - 1)).parse::<f64>().ok();
        let fits = |own: &f64| *own >= error && own.is_finite();
        scaled(digits).filter(fits).or_else(|| scaled(digits.saturating_add(1)).filter(fits)).unwrap_or(error)
    }

    /// Rounds the value of an estimate and its error bound.
    pub fn of(self, estimate: Estimate) -> Estimate {
        let (value, error) = self.shown(estimate.value, estimate.error);
        Estimate { value, error, ..estimate }
    }
}
