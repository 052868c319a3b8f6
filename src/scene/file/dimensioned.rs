//! Numbers with or without a unit: `250 nm`, `72 GPa`, `12 deg`, `0.3`, `pi/6`.

use crate::eval::constant_value;
use crate::expr::{Bindings, Expr};
use crate::num::DoubleDouble;
use crate::parse;
use crate::scene::{Dimension, SceneError, Unit};
use num_rational::BigRational;
use num_traits::ToPrimitive;

/// An exact number, with a unit or without.
#[derive(Clone, Debug, PartialEq)]
pub struct DimensionedNumber {
    text: String,
    number: Expr,
    unit: Option<Unit>,
}

impl DimensionedNumber {
    /// Parses a number with or without a unit.
    ///
    /// ```
    /// use sneddon::scene::{Dimension, DimensionedNumber};
    /// let length = DimensionedNumber::parse("250 nm").unwrap();
    /// assert_eq!(length.dimension(), Some(Dimension::LENGTH));
    /// assert_eq!(DimensionedNumber::parse("pi/6").unwrap().dimension(), None);
    /// ```
    ///
    /// # Errors
    /// [`SceneError`] if the text is neither.
    pub fn parse(text: &str) -> Result<Self, SceneError> {
        let trimmed = text.trim();
        let split = number_length(trimmed);
        let (number, unit) = trimmed.split_at(split);
        // Without leading digits or a trailing unit, the text is a constant such as pi/6.
        if split == 0 || unit.trim().is_empty() {
            return Self::plain(trimmed);
        }
        let number = constant(number)?;
        match Unit::parse(unit) {
            Ok(unit) => Ok(Self { text: trimmed.to_owned(), number, unit: Some(unit) }),
            // 2*pi is a constant, not a number with a unit.
            Err(error) => Self::plain(trimmed).map_err(|_| error),
        }
    }

    /// Parses a number without a unit.
    ///
    /// # Errors
    /// [`SceneError`] if the text is not a number.
    pub fn plain(text: &str) -> Result<Self, SceneError> {
        Ok(Self { text: text.trim().to_owned(), number: constant(text.trim())?, unit: None })
    }

    /// Returns the text as typed.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Returns the dimension of the unit; `None` without a unit.
    pub fn dimension(&self) -> Option<Dimension> {
        self.unit.as_ref().map(Unit::dimension)
    }

    /// Returns the unit, if there is one.
    pub fn unit(&self) -> Option<&Unit> {
        self.unit.as_ref()
    }

    /// Returns the number in m and N, or the number itself without a unit.
    pub fn in_base(&self) -> Expr {
        match &self.unit {
            Some(unit) => &self.number * unit.factor(),
            None => self.number.clone(),
        }
    }

    /// Returns the quantity multiplied by a number.
    #[must_use]
    pub(in crate::scene) fn times(&self, factor: &Expr) -> Self {
        Self { number: &self.number * factor, ..self.clone() }
    }

    /// Returns the complement of an angle, in radians.
    #[must_use]
    pub(in crate::scene) fn complement(&self) -> Self {
        Self { text: self.text.clone(), number: Expr::pi() / Expr::integer(2) - self.in_base(), unit: None }
    }

    /// Returns the angle times a power of 180/π without a unit, so that it cannot be used as a length in a scene with units.
    pub(in crate::scene) fn turned(&self, power: i64) -> Self {
        let turn = Expr::integer(180) / Expr::pi();
        Self { text: self.text.clone(), number: self.in_base() * turn.power(power), unit: None }
    }

    /// Returns true for 0 in any unit.
    pub fn is_zero(&self) -> bool {
        self.number.is_zero()
    }
}

/// Returns the nearest `f64` of an exact number.
///
/// # Errors
/// [`SceneError`] if it overflows or underflows.
pub(in crate::scene) fn to_f64(number: &Expr) -> Result<f64, SceneError> {
    let value = match number.as_number() {
        Some(number) => number.to_f64(),
        None => constant_value(number, &Bindings::default()).map_or(f64::NAN, |own| own.value),
    };
    if !value.is_finite() || (value == 0.0 && !number.is_zero()) {
        return Err(SceneError::value("the number is outside the range of 64-bit floating-point numbers")
            .help("expected a number such as 0.5, 3/2 or 1e-6"));
    }
    Ok(value)
}

/// Returns the number with 31 digits if it is a fraction, else like [`to_f64`].
///
/// # Errors
/// See [`to_f64`].
pub(crate) fn to_double_double(number: &Expr) -> Result<DoubleDouble, SceneError> {
    let nearest = to_f64(number)?;
    let rest = number.as_number().zip(BigRational::from_float(nearest)).and_then(|(exact, near)| (exact.value() - near).to_f64());
    Ok(DoubleDouble { hi: nearest, lo: rest.unwrap_or(0.0) })
}

fn constant(text: &str) -> Result<Expr, SceneError> {
    let text = text.trim();
    let own = parse::constant(text.strip_prefix('+').unwrap_or(text));
    own.map_err(|error| {
        SceneError::value(format!("{text:?} is not a number: {}", error.reason()))
            .help("expected a number such as 0.5, 3/2 or 1e-6, with or without a unit, such as \"250 nm\"")
    })
}

/// Returns the number of leading bytes that form a decimal number, or a fraction of two.
fn number_length(text: &str) -> usize {
    let one = decimal_length(text);
    let behind = text.get(one..).unwrap_or_default();
    if one > 0
        && let Some(below) = behind.strip_prefix('/')
        && below.starts_with(|c: char| c.is_ascii_digit())
    {
        return one + 1 + decimal_length(below);
    }
    one
}

fn decimal_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits = |from: usize| bytes.iter().skip(from).take_while(|byte| byte.is_ascii_digit()).count();
    let mut at = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let whole = digits(at);
    at += whole;
    let mut fraction = 0;
    if bytes.get(at) == Some(&b'.') {
        fraction = digits(at + 1);
        at += 1 + fraction;
    }
    if whole + fraction == 0 {
        return 0;
    }
    if matches!(bytes.get(at), Some(b'e' | b'E')) {
        let signed = usize::from(matches!(bytes.get(at + 1), Some(b'+' | b'-')));
        let exponent = digits(at + 1 + signed);
        if exponent > 0 {
            at += 1 + signed + exponent;
        }
    }
    at
}
