//! How far the functions of the table are from 30-digit values.

use crate::decimal::Decimal;
use crate::rows::rows;
use sneddon::expr::Function;
use std::collections::BTreeMap;

/// The errors of one function.
#[derive(Clone, Copy, Default)]
pub struct Tally {
    pub count: usize,
    /// Largest and mean error in units in the last place.
    pub largest: f64,
    pub mean: f64,
}

/// Measures every function of the table at the places of files that the scripts in `tests/oracle` wrote.
///
/// # Errors
/// A row that cannot be read.
pub fn measure<'a>(tables: impl IntoIterator<Item = &'a str>) -> Result<BTreeMap<&'static str, Tally>, String> {
    let mut figures: BTreeMap<&'static str, Tally> = BTreeMap::new();
    for row in tables.into_iter().flat_map(rows) {
        let [name, arguments, truth] = row[..] else { return Err(format!("{row:?} has not three fields")) };
        let mut parts = name.split(' ');
        let name = parts.next().unwrap_or_default();
        let Ok(mut point) = parts.map(str::parse::<f64>).collect::<Result<Vec<_>, _>>() else { continue };
        // Arguments with more digits than a double belong to the thirty-digit values.
        let Ok(own) = arguments.split([' ', ';']).map(str::parse::<f64>).collect::<Result<Vec<_>, _>>() else { continue };
        point.extend(own);
        let Some(function) = function(name, &mut point) else { continue };
        let (lowest, highest) = function.row().arity;
        let value = (function.row().value)(&point);
        if value.is_finite() && (lowest..=highest).contains(&point.len()) {
            let (ulps, entry) = (Decimal::read(truth).ulps(value), figures.entry(function.name()).or_default());
            *entry = Tally { count: entry.count + 1, largest: entry.largest.max(ulps), mean: entry.mean + ulps };
        }
    }
    figures.values_mut().for_each(|own| own.mean /= own.count as f64);
    Ok(figures)
}

/// The function of a name; one over a segment without an end is one from its beginning on.
fn function(name: &str, point: &mut Vec<f64>) -> Option<Function> {
    let segments = ["shifted_power", "shifted_power_force"];
    if !segments.contains(&name) || point.len() != 4 {
        return Function::named(name);
    }
    if point[2].is_infinite() {
        point.remove(2);
        return Function::named(name);
    }
    Function::named(&format!("{name}_between"))
}
