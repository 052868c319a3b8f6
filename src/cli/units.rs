//! Numbers on the command line, with or without units, and the units in which a call computes.

use super::Failure;
use super::failure::warn;
use crate::eval::constant_value;
use crate::expr::{Bindings, Expr, Formula, Symbol};
use crate::num::DoubleDouble;
use crate::parse;
use crate::scene::{Counting, Dimension, DimensionedNumber, SceneError, to_double_double};

/// The units of one call, taken from its first length and its modulus; empty if no number has a unit.
pub struct CallUnits(Counting);

impl CallUnits {
    /// Determines the units from the parameter values, other lengths and lists of lengths, and the modulus.
    pub fn of(set: &[String], lengths: &[Option<&str>], modulus: Option<&str>) -> Self {
        let set = set.iter().filter_map(|item| item.split_once('=')).map(|(_, value)| value);
        let others = lengths.iter().flatten().flat_map(|text| text.split([',', ':']));
        Self(Counting::of(set.chain(others), modulus))
    }

    /// Returns the unit of a dimension; empty if numbers have no units.
    pub(super) fn name(&self, dimension: Dimension) -> String {
        self.0.name(dimension)
    }

    /// Prints the units as a warning, for output that does not contain them.
    pub(super) fn tell(&self) {
        let (length, pressure) = (self.name(Dimension::LENGTH), self.name(Dimension::PRESSURE));
        if !length.is_empty() {
            let moduli = if pressure == "E*" { String::new() } else { format!(", pressures in {pressure}") };
            warn(&format!("lengths are in {length}{moduli}, angles in radians"));
        }
    }

    /// Parses a finite length.
    pub(super) fn length(&self, place: &str, text: &str) -> Result<f64, Failure> {
        self.number(place, text, Dimension::LENGTH)
    }

    /// Parses an end point of a range; a fraction keeps 31 digits.
    pub(super) fn end(&self, place: &str, text: &str, dimension: Dimension) -> Result<DoubleDouble, Failure> {
        let (exact, _) = self.exact(place, text, dimension)?;
        to_double_double(&exact).map_err(|error| failure(place, text, &error))
    }

    /// Parses a positive length.
    pub(super) fn positive_length(&self, place: &str, text: &str) -> Result<f64, Failure> {
        positive(place, text, self.length(place, text)?)
    }

    /// Parses the depth of a punch with a rim as an expression; the symbol d is an arbitrary depth.
    pub(super) fn depth(&self, text: &str) -> Result<Expr, Failure> {
        if text.trim() == "d" {
            return Ok(Expr::symbol("d"));
        }
        self.exact("--depth", text, Dimension::LENGTH).map(|(exact, _)| exact)
    }

    /// Parses a positive modulus; 1 needs no unit.
    pub(super) fn modulus(&self, place: &str, text: &str) -> Result<f64, Failure> {
        let is_any = text.trim() == "1";
        let wanted = if is_any { Dimension::NONE } else { Dimension::PRESSURE };
        positive(place, text, self.number(place, text, wanted)?)
    }

    /// Parses a parameter value and its dimension; without a unit it is a plain number.
    pub(super) fn parameter(&self, place: &str, text: &str) -> Result<(Expr, f64, Dimension), Failure> {
        let quantity = quantity(place, text)?;
        let exact = self.0.own(place, &quantity).map_err(|error| failure(place, text, &error))?;
        let value = finite(place, text, &exact)?;
        Ok((exact, value, quantity.dimension().unwrap_or(Dimension::NONE)))
    }

    /// Returns an error if the profile is not a length for these dimensions of its parameters.
    pub(super) fn check(&self, text: &str, profile: &Formula, parameters: Vec<(Symbol, Dimension)>) -> Result<(), Failure> {
        self.0.check(profile, parameters).map_err(|error| {
            let message = error.to_string();
            let help = if message.ends_with("not a plain number") {
                "expected a plain number there, or an angle such as --set theta='20 deg'"
            } else {
                "give every length parameter a unit, such as --set R='20 nm'"
            };
            Failure::new(message).help(help).at("PROFILE", text, 0..text.len())
        })
    }

    /// Parses a finite number of a dimension.
    pub(super) fn number(&self, place: &str, text: &str, wanted: Dimension) -> Result<f64, Failure> {
        self.exact(place, text, wanted).map(|(_, value)| value)
    }

    fn exact(&self, place: &str, text: &str, wanted: Dimension) -> Result<(Expr, f64), Failure> {
        let quantity = quantity(place, text)?;
        let exact = self.0.number(place, &quantity, wanted).map_err(|error| failure(place, text, &error))?;
        let value = finite(place, text, &exact)?;
        Ok((exact, value))
    }
}

fn positive(place: &str, text: &str, value: f64) -> Result<f64, Failure> {
    if value > 0.0 {
        return Ok(value);
    }
    Err(Failure::new(format!("{} is not positive", text.trim())).help("expected a positive number").at(place, text, 0..text.len()))
}

/// Parses a number with or without a unit.
fn quantity(place: &str, text: &str) -> Result<DimensionedNumber, Failure> {
    let plain = match parse::constant(text) {
        Ok(_) => return DimensionedNumber::plain(text).map_err(|error| failure(place, text, &error)),
        Err(error) => error,
    };
    let with_unit = text.trim_start().starts_with(|first: char| first.is_ascii_digit() || first == '.')
        && text.trim_end().ends_with(|own: char| own.is_alphabetic() || own.is_ascii_digit());
    DimensionedNumber::parse(text)
        .map_err(|error| if with_unit { failure(place, text, &error) } else { Failure::parse(place, text, &plain) })
}

fn failure(place: &str, text: &str, error: &SceneError) -> Failure {
    let own = Failure::new(error.to_string());
    let own = match error.accepted() {
        Some(help) => own.help(help),
        None => own,
    };
    own.at(place, text, 0..text.len())
}

/// Returns the value of an expression without symbols, which must be finite.
pub(super) fn finite(place: &str, text: &str, exact: &Expr) -> Result<f64, Failure> {
    let value = match exact.as_number() {
        Some(number) => number.to_f64(),
        None => constant_value(exact, &Bindings::default()).map_or(f64::NAN, |bounded| bounded.value),
    };
    let lost = value == 0.0 && !exact.is_zero();
    if !value.is_finite() || lost {
        let message = format!("{} is outside the range of 64-bit floating-point numbers", text.trim());
        return Err(Failure::new(message).help("expected a finite number such as 0.5, 3/2 or 1e-6").at(place, text, 0..text.len()));
    }
    Ok(value)
}
