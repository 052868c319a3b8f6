//! Error bounds of the rows of a solved scene: the largest bounds as a sentence, and columns of CSV.

use crate::num::{Bound, Estimate};
use crate::report::digits::Digits;
use crate::report::text::{marked, short};
use crate::scene::{Quantity, Row, Run};

/// The largest relative error bounds of all quantities over the rows.
#[derive(Default)]
pub(in crate::report) struct Largest(Vec<(Quantity, f64, Bound)>);

impl Largest {
    /// Adds a row.
    pub(in crate::report) fn take(&mut self, run: &Run<'_>, index: usize, row: &Row, digits: Digits) {
        for (datum, estimate) in estimates(run, index, row, digits) {
            let Some(own) = estimate.filter(|own| own.value != 0.0) else { continue };
            let relative = (own.error / own.value).abs();
            match self.0.iter_mut().find(|known| known.0 == datum) {
                Some((_, error, bound)) => {
                    *error = error.max(relative);
                    *bound = bound.and(own.bound);
                }
                None => self.0.push((datum, relative, own.bound)),
            }
        }
    }

    /// Returns the bounds as a sentence, such as `relative error bounds: F 4.2e-16, a ~1.0e-9 (~ marks estimates)`; `None` if there are none.
    pub(in crate::report) fn sentence(&self) -> Option<String> {
        let list: Vec<String> =
            self.0.iter().map(|(datum, error, bound)| format!("{} {}", datum.key(), marked(short(*error), *bound))).collect();
        let legend = if self.0.iter().any(|own| own.2 == Bound::Estimated) { " (~ marks estimates)" } else { "" };
        (!list.is_empty()).then(|| format!("relative error bounds: {}{legend}", list.join(", ")))
    }
}

/// Returns the names of the columns with the bounds: for each quantity its error bound and the kind of bound.
pub(in crate::report) fn header(run: &Run<'_>) -> Vec<String> {
    let system = &run.scene().system;
    let pair =
        |own: &Quantity| [named(&format!("{}_error", own.key()), &system.unit_name(own.dimension())), format!("{}_bound", own.key())];
    run.scene().outputs.data.iter().flat_map(pair).collect()
}

/// Returns the fields of these columns for a row; empty if no bound is known.
pub(in crate::report) fn fields(run: &Run<'_>, index: usize, row: &Row, digits: Digits) -> Vec<String> {
    let pair = |own: Option<crate::num::Estimate>| {
        own.map_or_else(Default::default, |own| [format!("{:?}", own.error), own.bound.name().to_owned()])
    };
    estimates(run, index, row, digits).flat_map(|(_, own)| pair(own)).collect()
}

/// Returns the estimates of a row, rounded as shown; the load is an input and is not rounded.
fn estimates(run: &Run<'_>, index: usize, row: &Row, digits: Digits) -> impl Iterator<Item = (Quantity, Option<Estimate>)> {
    let scene = run.scene();
    let load = scene.control.datum();
    let is_input = move |datum| datum == load && !scene.counts_from_touch();
    run.estimates(index, row)
        .into_iter()
        .map(move |(datum, own)| (datum, own.map(|own| if is_input(datum) { own } else { digits.of(own) })))
}

/// Returns a name with its unit, as in the column names of CSV.
pub(in crate::report) fn named(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.to_owned() } else { format!("{name}_{unit}") }
}
