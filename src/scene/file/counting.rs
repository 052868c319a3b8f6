//! The units of a call without a scene, taken from its first length and its modulus.

use crate::expr::{Expr, Formula, Symbol};
use crate::scene::file::check::{Dimensions, refuse_other_than_length};
use crate::scene::{Dimension, DimensionedNumber, SceneError, Unit};

/// The units of a call; both are `None` if no number has a unit.
///
/// ```
/// use sneddon::scene::{Counting, Dimension, DimensionedNumber};
/// let own = Counting::of(["20 nm", "0.1 um"], Some("70 GPa"));
/// assert_eq!(own.number("x", &DimensionedNumber::parse("0.1 um")?, Dimension::LENGTH)?.as_integer(), Some(100));
/// assert_eq!(own.name(Dimension::FORCE), "nN");
/// # Ok::<(), sneddon::scene::SceneError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Counting {
    length: Option<Unit>,
    pressure: Option<Unit>,
}

/// Names of forces and energies: the symbol and the exponents of ten of its factors.
const PREFIXES: [(&str, i64); 12] =
    [("f", -15), ("p", -12), ("n", -9), ("u", -6), ("m", -3), ("", 0), ("k", 3), ("M", 6), ("G", 9), ("T", 12), ("a", -18), ("z", -21)];

impl Counting {
    /// Determines the units from the first length among the texts and from the modulus.
    pub fn of<'a>(texts: impl IntoIterator<Item = &'a str>, modulus: Option<&str>) -> Self {
        let unit = |text: &str| DimensionedNumber::parse(text).ok().and_then(|own| own.unit().cloned());
        let length = texts.into_iter().filter_map(unit).find(|own| own.dimension() == Dimension::LENGTH);
        Self { length, pressure: modulus.and_then(unit).filter(|own| own.dimension() == Dimension::PRESSURE) }
    }

    /// Returns true if any number has a unit.
    pub fn has_units(&self) -> bool {
        self.length.is_some() || self.pressure.is_some()
    }

    /// Returns the value of a quantity with the wanted dimension in these units.
    ///
    /// # Errors
    /// [`SceneError`] for another dimension, and for a number without a unit if other numbers have one.
    pub fn number(&self, name: &str, quantity: &DimensionedNumber, wanted: Dimension) -> Result<Expr, SceneError> {
        match quantity.dimension() {
            None if !self.has_units() || wanted.is_none() || quantity.is_zero() => Ok(quantity.in_base()),
            None => Err(SceneError::unit(format!("{name} = {} has no unit, but other numbers have one", quantity.text()))
                .help(self.with_modulus(wanted, &format!("add a unit, such as \"{} {}\"", quantity.text(), self.example(wanted))))),
            Some(own) if own != wanted => Err(SceneError::unit(format!("{name} = {} is {own}, not {wanted}", quantity.text()))
                .help(self.with_modulus(wanted, &format!("expected a number with a unit such as {}", self.example(wanted))))),
            Some(_) => self.own(name, quantity),
        }
    }

    /// Returns the value of a quantity of any dimension in these units.
    ///
    /// # Errors
    /// [`SceneError`] if the unit contains a force and the modulus has no unit, or contains a length and no length has a unit.
    pub fn own(&self, name: &str, quantity: &DimensionedNumber) -> Result<Expr, SceneError> {
        let Some(dimension) = quantity.dimension() else { return Ok(quantity.in_base()) };
        if dimension.is_none() {
            return Ok(quantity.in_base());
        }
        let (length, force) = dimension.exponents();
        let unknown = || {
            SceneError::unit(format!("{name} = {} has a unit of force or pressure, but the effective modulus has no unit", quantity.text()))
                .help("expected a length or a plain number; for forces and pressures, add a unit to the effective modulus, such as \"70 GPa\"")
        };
        let no_length = || {
            SceneError::unit(format!("{name} = {} has a unit, but no length does", quantity.text()))
                .help("give every length a unit, such as R = \"1 um\"")
        };
        // The unit of force is pressure · length².
        let mut factor = Expr::one();
        if !force.is_zero() {
            factor = self.pressure.as_ref().ok_or_else(unknown)?.factor().pow(&force);
        }
        let lengths = length + Expr::integer(2) * force;
        if !lengths.is_zero() {
            factor = factor * self.length.as_ref().ok_or_else(no_length)?.factor().pow(&lengths);
        }
        Ok(quantity.in_base() / factor)
    }

    /// Returns an error if the profile is not a length for these dimensions of its parameters.
    ///
    /// # Errors
    /// [`SceneError`] with the term.
    pub fn check(&self, profile: &Formula, parameters: impl IntoIterator<Item = (Symbol, Dimension)>) -> Result<(), SceneError> {
        if self.length.is_none() {
            return Ok(());
        }
        let known: Dimensions = parameters.into_iter().collect();
        refuse_other_than_length(profile, &known)
    }

    /// Returns the name of the unit of a dimension; empty if numbers have no units.
    pub fn name(&self, dimension: Dimension) -> String {
        let length = self.length.as_ref().map_or("", Unit::name);
        let pressure = self.pressure.as_ref().map_or("E*", Unit::name);
        if !self.has_units() || dimension.is_none() {
            return String::new();
        }
        if dimension == Dimension::LENGTH || length.is_empty() {
            return length.to_owned();
        }
        if dimension == Dimension::PRESSURE {
            return pressure.to_owned();
        }
        if dimension == Dimension::AREA {
            return format!("{length}^2");
        }
        let power = [(Dimension::STIFFNESS, 1, "N/m"), (Dimension::FORCE, 2, "N"), (Dimension::ENERGY, 3, "J")];
        let Some((_, power, symbol)) = power.into_iter().find(|(own, ..)| *own == dimension) else { return String::new() };
        let product = if power == 1 { format!("{pressure} {length}") } else { format!("{pressure} {length}^{power}") };
        self.known_name(power, symbol).unwrap_or(product)
    }

    /// Completes the advice to add a unit; a unit of force or pressure requires that the effective modulus has one.
    fn with_modulus(&self, wanted: Dimension, advice: &str) -> String {
        if self.pressure.is_some() || wanted.exponents().1.is_zero() {
            return advice.to_owned();
        }
        format!("{advice}; the effective modulus needs a unit as well, such as \"70 GPa\"")
    }

    /// Returns an example of a unit of a dimension, for help lines.
    fn example(&self, wanted: Dimension) -> String {
        match self.name(wanted) {
            name if name.is_empty() && wanted == Dimension::FORCE => "mN".to_owned(),
            name if name.is_empty() && wanted == Dimension::PRESSURE => "GPa".to_owned(),
            name if name.is_empty() => "um".to_owned(),
            // Input cannot contain E*, which is the unit of output without a unit of pressure.
            name if name.starts_with("E*") && wanted == Dimension::FORCE => "mN".to_owned(),
            name if name.starts_with("E*") => "GPa".to_owned(),
            name => name,
        }
    }

    /// Returns pressure · length^power in newtons or joules if a prefix fits.
    fn known_name(&self, power: i64, symbol: &str) -> Option<String> {
        let factor = self.pressure.as_ref()?.factor() * self.length.as_ref()?.factor().pow(&Expr::integer(power));
        let ten = Expr::integer(10);
        PREFIXES.iter().find(|(_, exponent)| ten.pow(&Expr::integer(*exponent)) == factor).map(|(prefix, _)| format!("{prefix}{symbol}"))
    }
}
