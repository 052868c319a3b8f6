//! Converts the units of data columns to the units of the scene.

use crate::scene::{Dimension, Scene, Unit};
use crate::validate::ValidationError;
use crate::validate::file::column::Column;

/// Units for a scene without units: the first units in the data are used.
#[derive(Default)]
pub(in crate::validate) struct DataUnits {
    length: Option<Unit>,
    force: Option<Unit>,
    pressure: Option<Unit>,
    pub(in crate::validate) note: Option<String>,
}

impl DataUnits {
    /// Returns the factor that converts a column to the units of the scene.
    pub(in crate::validate) fn factor(&mut self, scene: &Scene, file: &str, column: &Column) -> Result<f64, ValidationError> {
        let Some(unit) = &column.unit else { return Ok(1.0 / scene.system.out(column.kind.dimension())) };
        let bad = || {
            let message = format!("the unit of column {} over- or underflows in the units of the scene", column.name);
            ValidationError::data(file, None, message, "use units in the scene")
        };
        self.computed(scene, unit).filter(|own| own.is_finite() && *own > 0.0).ok_or_else(bad)
    }

    /// Returns the factor that converts a value in this unit to computing units.
    fn computed(&mut self, scene: &Scene, unit: &Unit) -> Option<f64> {
        let number = |own: &crate::expr::Expr| own.as_number().map(crate::expr::Number::to_f64);
        let dimension = unit.dimension();
        if let Some(factor) = scene.system.computed(unit) {
            return Some(factor);
        }
        let power = match dimension {
            own if own == Dimension::ENERGY => 1,
            own if own == Dimension::STIFFNESS => -1,
            _ => return number(&(unit.factor() / &self.own(unit, dimension)?)),
        };
        let (force, length) = (self.computed(scene, &Unit::parse("N").ok()?)?, self.computed(scene, &Unit::parse("m").ok()?)?);
        Some(number(unit.factor())? * force * length.powi(power))
    }

    /// Returns the unit of the scene for a dimension; the first unit in the data is used.
    fn own(&mut self, unit: &Unit, dimension: Dimension) -> Option<crate::expr::Expr> {
        let square = |own: &Unit| own.factor().power(2);
        let derived = match dimension {
            own if own == Dimension::FORCE => self.pressure.as_ref().zip(self.length.as_ref()).map(|(p, l)| p.factor() * square(l)),
            own if own == Dimension::PRESSURE => self.force.as_ref().zip(self.length.as_ref()).map(|(f, l)| f.factor() / square(l)),
            own if own == Dimension::LENGTH => None,
            _ => return None,
        };
        let place = match dimension {
            own if own == Dimension::FORCE => &mut self.force,
            own if own == Dimension::PRESSURE => &mut self.pressure,
            _ => &mut self.length,
        };
        if let Some(known) = place {
            return Some(known.factor().clone());
        }
        if let Some(derived) = derived {
            return Some(derived);
        }
        *place = Some(unit.clone());
        let named: Vec<&str> = [&self.length, &self.force, &self.pressure].into_iter().flatten().map(Unit::name).collect();
        self.note = Some(format!("the numbers of the scene have no units and are read in the units of the data: {}", named.join(", ")));
        Some(unit.factor().clone())
    }
}

/// Returns a symbol with its unit.
pub(in crate::validate) fn shown(symbol: &str, unit: &str) -> String {
    if unit.is_empty() { symbol.to_owned() } else { format!("{symbol} / {unit}") }
}
