//! The units in which a scene computes, and its output units.

use super::{Dimension, DimensionedNumber, SceneError, Unit};
use crate::expr::Expr;
use crate::scene::file::dimensioned::to_f64;
use num_traits::{One, Zero};
use std::ops::Range;

/// The output units; names are empty if the system has none.
#[derive(Clone, Debug, PartialEq)]
pub struct Names {
    /// The unit of length.
    pub length: String,
    /// The unit of force.
    pub force: String,
    /// The unit of pressure.
    pub pressure: String,
}

/// The unit of pressure in dimensionless output.
const DIMENSIONLESS: &str = "E*";

/// Units of input and output. Lengths and pressures are computed in `length` and `pressure`, forces in their product.
#[derive(Clone, Debug)]
pub struct System {
    /// False if no number has a unit.
    has_units: bool,
    /// The factors of the computing units.
    length: Expr,
    pressure: Expr,
    /// The factors that convert computed lengths, pressures and forces to output units.
    out_length: f64,
    out_pressure: f64,
    out_force: f64,
    /// The factors of the output units.
    shown_length: Expr,
    shown_force: Expr,
    names: Option<Names>,
}

/// The units named in `[outputs]` and `[profile]`.
#[derive(Clone, Debug, Default)]
pub(super) struct Named {
    pub(super) length: Option<(Unit, Range<usize>)>,
    pub(super) force: Option<(Unit, Range<usize>)>,
    pub(super) pressure: Option<(Unit, Range<usize>)>,
    pub(super) profile_length: Option<Unit>,
}

impl System {
    /// Returns a consistent system without unit names.
    pub fn bare() -> Self {
        Self {
            has_units: false,
            length: Expr::one(),
            pressure: Expr::one(),
            out_length: 1.0,
            out_pressure: 1.0,
            out_force: 1.0,
            shown_length: Expr::one(),
            shown_force: Expr::one(),
            names: None,
        }
    }

    /// Returns the same system with names of its units of length, force and pressure, which must be consistent; empty names stay empty.
    pub fn counted([length, force, pressure]: [String; 3]) -> Self {
        let has_names = !length.is_empty() || !pressure.is_empty();
        Self { names: has_names.then_some(Names { length, force, pressure }), ..Self::bare() }
    }

    /// Determines the system of a scene; `has_units` is true if any number has a unit.
    ///
    /// # Errors
    /// [`SceneError`] if the given output units are inconsistent for numbers without units.
    pub(super) fn new(has_units: bool, named: &Named) -> Result<Self, SceneError> {
        let name = |own: &Option<(Unit, Range<usize>)>| own.as_ref().map(|(unit, _)| unit.name().to_owned());
        let (length, force, pressure) = (name(&named.length), name(&named.force), name(&named.pressure));
        if !has_units {
            let mut own = Self::bare();
            if let (Some((l, _)), Some((f, at)), Some((p, _))) = (&named.length, &named.force, &named.pressure)
                && *f.factor() != p.factor() * l.factor().power(2)
            {
                let message = format!("{} is not {}*{}^2", f.name(), p.name(), l.name());
                return Err(SceneError::unit(message)
                    .help("numbers without units must be consistent, with force = pressure * length^2; add units to the inputs, or change one of the three")
                    .at(at.clone()));
            }
            if length.is_some() || force.is_some() || pressure.is_some() {
                let length = length.unwrap_or_default();
                let force = force.unwrap_or_else(|| pressure.as_ref().map_or(String::new(), |p| format!("{p}*{length}^2")));
                let pressure = pressure.unwrap_or_else(|| if force.is_empty() { String::new() } else { format!("{force}/{length}^2") });
                own.names = Some(Names { length, force, pressure });
            }
            return Ok(own);
        }
        let factor = |own: &Option<(Unit, Range<usize>)>| own.as_ref().map_or_else(Expr::one, |(unit, _)| unit.factor().clone());
        let (wanted_length, out_pressure, wanted_force) = (factor(&named.length), factor(&named.pressure), factor(&named.force));
        // The unit of numbers in f is also the unit of length; else use the output unit, in which typed values remain exact.
        let own_length = named.profile_length.as_ref().map_or_else(|| wanted_length.clone(), |unit| unit.factor().clone());
        let out_force = to_f64(&(&out_pressure * own_length.power(2) / &wanted_force))?;
        Ok(Self {
            has_units: true,
            out_length: to_f64(&(&own_length / &wanted_length))?,
            shown_length: wanted_length,
            shown_force: wanted_force,
            out_pressure: 1.0,
            out_force,
            length: own_length,
            pressure: out_pressure,
            names: Some(Names {
                length: length.unwrap_or_else(|| "m".to_owned()),
                force: force.unwrap_or_else(|| "N".to_owned()),
                pressure: pressure.unwrap_or_else(|| "Pa".to_owned()),
            }),
        })
    }

    /// Returns the same system with dimensionless output d/R, F/(E* R²), p/E*.
    #[must_use]
    pub fn dimensionless(&self, name: &str, length: f64, effective_modulus: f64) -> Self {
        let names = Names { length: name.to_owned(), force: format!("(E* {name}^2)"), pressure: DIMENSIONLESS.to_owned() };
        let (out_length, out_pressure) = (1.0 / length, 1.0 / effective_modulus);
        Self { out_length, out_pressure, out_force: out_pressure * out_length * out_length, names: Some(names), ..self.clone() }
    }

    /// Returns true if numbers have units.
    pub fn has_units(&self) -> bool {
        self.has_units
    }

    /// Returns the names of the output units.
    pub fn names(&self) -> Option<&Names> {
        self.names.as_ref()
    }

    /// Returns the exact value of a quantity, which must have the given dimension.
    pub(super) fn exact(&self, quantity: &DimensionedNumber, wanted: Dimension, what: &str) -> Result<Expr, SceneError> {
        match quantity.dimension() {
            Some(own) if own != wanted => {
                let unit = quantity.unit().map_or("", Unit::name);
                Err(SceneError::unit(format!("{what} is given in {unit}, which is {own}, not {wanted}")).help(if wanted.is_none() {
                    "expected a number without a unit".to_owned()
                } else {
                    format!("expected {wanted} with its unit, as in {}", example(wanted))
                }))
            }
            None if self.has_units && !wanted.is_none() && !quantity.is_zero() => {
                Err(SceneError::unit(format!("{what} has no unit, but other numbers of the scene have one"))
                    .help(format!("add a unit, as in {}", example(wanted))))
            }
            Some(_) => Ok(self.own(quantity.in_base(), wanted)),
            None => Ok(quantity.in_base()),
        }
    }

    /// Converts a number in m and N to computing units.
    pub(super) fn own(&self, base: Expr, dimension: Dimension) -> Expr {
        let force = &self.pressure * self.length.power(2);
        match dimension {
            own if own == Dimension::LENGTH => base / &self.length,
            own if own == Dimension::PRESSURE => base / &self.pressure,
            own if own == Dimension::FORCE => base / force,
            other => {
                let (length, force_power) = other.exponents();
                base / (self.length.pow(&length) * force.pow(&force_power))
            }
        }
    }

    /// Returns the same value as the nearest `f64`.
    pub(super) fn number(&self, quantity: &DimensionedNumber, wanted: Dimension, what: &str) -> Result<f64, SceneError> {
        to_f64(&self.exact(quantity, wanted, what)?)
    }

    /// Converts a length or a force to output units.
    pub(super) fn shown(&self, quantity: &DimensionedNumber, dimension: Dimension) -> Expr {
        match quantity.dimension() {
            None => quantity.in_base(),
            Some(_) if dimension == Dimension::FORCE => quantity.in_base() / &self.shown_force,
            Some(_) => quantity.in_base() / &self.shown_length,
        }
    }

    /// Returns the factor that converts computed values of a dimension to output units.
    pub fn out(&self, dimension: Dimension) -> f64 {
        // The unit of pressure is independent of the unit of force.
        if dimension == Dimension::PRESSURE { self.out_pressure } else { dimension.product(self.out_length, self.out_force) }
    }

    /// Returns the factor that converts a value in this unit to computing units; `None` if the numbers of the scene have no units.
    pub fn computed(&self, unit: &Unit) -> Option<f64> {
        if self.has_units {
            return to_f64(&self.own(unit.factor().clone(), unit.dimension())).ok();
        }
        let own = Unit::parse(&self.unit_name(unit.dimension())).ok()?;
        to_f64(&(unit.factor() / own.factor())).ok()
    }

    /// Returns the name of the output unit of a dimension; empty if there is none.
    pub fn unit_name(&self, dimension: Dimension) -> String {
        let Some(Names { length, force, pressure }) = &self.names else { return String::new() };
        match dimension {
            own if own == Dimension::LENGTH => length.clone(),
            own if own == Dimension::FORCE => force.clone(),
            own if own == Dimension::PRESSURE => pressure.clone(),
            own if own == Dimension::AREA && !length.is_empty() => format!("{length}^2"),
            own if own == Dimension::STIFFNESS && pressure == DIMENSIONLESS => format!("({pressure} {length})"),
            own if own == Dimension::ENERGY && pressure == DIMENSIONLESS => format!("({pressure} {length}^3)"),
            own if own == Dimension::STIFFNESS && !force.is_empty() => format!("{force}/{length}"),
            own if own == Dimension::ENERGY && !force.is_empty() => format!("{force}*{length}"),
            _ => String::new(),
        }
    }
}

fn example(dimension: Dimension) -> String {
    match dimension {
        own if own == Dimension::LENGTH => "\"250 nm\"".to_owned(),
        own if own == Dimension::FORCE => "\"3 uN\"".to_owned(),
        own if own == Dimension::PRESSURE => "\"72 GPa\"".to_owned(),
        own => {
            let (length, force) = own.exponents();
            let power = |unit: &str, exponent: &Expr| match exponent.as_number()?.value() {
                zero if zero.is_zero() => None,
                one if one.is_one() => Some(unit.to_owned()),
                whole if whole.is_integer() => Some(format!("{unit}^{whole}")),
                ratio => Some(format!("{unit}^({ratio})")),
            };
            let units: Vec<String> = [power("uN", &force), power("um", &length)].into_iter().flatten().collect();
            format!("\"0.1 {}\"", units.join("*"))
        }
    }
}
