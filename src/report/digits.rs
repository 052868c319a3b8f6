//! How many digits of a number are shown.

use crate::num::Estimate;

/// The digits of the values in text and CSV: all of them, or a number of significant ones.
///
/// Coordinates, loads and other inputs are always shown with all their digits, because the values belong to them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Digits(Option<usize>);

impl Digits {
    /// The most digits that a double needs.
    pub const MOST: usize = 17;

    /// So many significant digits, from 1 to [`Self::MOST`]; `None` for other numbers.
    ///
    /// ```
    /// use sneddon::report::Digits;
    /// assert_eq!(Digits::significant(3).unwrap().rounded(2.0 / 3.0), 0.667);
    /// assert_eq!(Digits::significant(0), None);
    /// ```
    pub fn significant(count: usize) -> Option<Self> {
        (1..=Self::MOST).contains(&count).then_some(Self(Some(count)))
    }

    /// The double nearest to the value rounded to so many digits.
    pub fn rounded(self, value: f64) -> f64 {
        match self.0 {
            // A number next to the largest one may have no neighbour of so few digits.
            Some(count) => format!("{value:.*e}", count - 1).parse().ok().filter(|own: &f64| own.is_finite()).unwrap_or(value),
            None => value,
        }
    }

    /// The value as it is shown, and a bound of the error of what is shown, rounded up.
    pub fn shown(self, value: f64, error: f64) -> (f64, f64) {
        let shown = self.rounded(value);
        let error = if shown == value { error } else { (error + (shown - value).abs()).next_up() };
        (shown, self.rounded_up(error))
    }

    fn rounded_up(self, error: f64) -> f64 {
        let rounded = self.rounded(error);
        let text = format!("{rounded:e}");
        match (self.0, text.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok())) {
            (Some(count), Some(exponent)) if rounded < error => self.rounded(rounded + 10_f64.powi(exponent + 1 - count as i32)),
            _ => rounded,
        }
    }

    /// The same for an estimate.
    pub fn of(self, estimate: Estimate) -> Estimate {
        let (value, error) = self.shown(estimate.value, estimate.error);
        Estimate { value, error, ..estimate }
    }
}
