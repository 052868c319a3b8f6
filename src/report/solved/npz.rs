//! A solved scene as NumPy arrays: one array per quantity, over loads, or over loads and coordinates.

use crate::contact::State;
use crate::num::Bound;
use crate::report::npy::Archive;
use crate::report::solved::Verdict;
use crate::scene::{Dimension, Quantity, Run, infinite_value};
use std::io::{self, Write};

/// Writes an NPZ archive: `d`, `F` and other quantities over the loads with `valid`, curves over loads and coordinates (`p`, `p_at`), with
/// error bounds (`F_error`), whether these are proven (`F_proven`), and the name of the unit (`F_unit`) of each.
///
/// A theoretically infinite value is infinite with an infinite error.
///
/// # Errors
/// Returns the errors of the writer, and [`io::ErrorKind::InvalidData`] for a missing value, which an array cannot represent.
pub fn npz(run: &Run<'_>, formally: bool, out: &mut dyn Write) -> io::Result<Verdict> {
    let scene = run.scene();
    let mut archive = Archive::new();
    let mut verdict = Verdict::default();
    let mut columns: Vec<Vec<f64>> = vec![Vec::new(); scene.outputs.data.len()];
    let mut bounds: Vec<(Vec<f64>, Vec<bool>)> = vec![(Vec::new(), Vec::new()); scene.outputs.data.len()];
    let (mut touch, mut valid) = (Vec::new(), Vec::new());
    for (index, row) in (0..scene.loads.len()).filter_map(|index| Some((index, run.row(index)?))) {
        verdict.take(&row);
        valid.push(row.is_valid());
        for (column, (datum, value)) in columns.iter_mut().zip(&row.values) {
            let controlled = *datum == scene.control.datum() && !scene.counts_from_touch();
            column.push(match value {
                _ if controlled => row.load,
                Ok(value) if formally || row.is_valid() => *value,
                Ok(_) => return Err(missing(index, datum.key(), row.why().unwrap_or("the row is not valid"))),
                Err(why) => return Err(missing(index, datum.key(), why)),
            });
        }
        for ((errors, proven), (_, estimate)) in bounds.iter_mut().zip(run.estimates(index, &row)) {
            errors.push(estimate.map_or(f64::INFINITY, |own| own.error));
            proven.push(estimate.is_some_and(|own| own.bound == Bound::Proven));
        }
        if scene.counts_from_touch() {
            touch.push(row.load);
        }
    }
    let count = scene.loads.len();
    for ((datum, column), (errors, proven)) in scene.outputs.data.iter().zip(&columns).zip(&bounds) {
        archive.numbers(datum.key(), &[count], column)?;
        archive.numbers(&format!("{}_error", datum.key()), &[count], errors)?;
        archive.flags(&format!("{}_proven", datum.key()), &[count], proven)?;
        archive.text(&format!("{}_unit", datum.key()), &scene.system.unit_name(datum.dimension()))?;
    }
    if scene.counts_from_touch() {
        archive.numbers("d_first_touch", &[count], &touch)?;
        archive.text("d_first_touch_unit", &scene.system.unit_name(Dimension::LENGTH))?;
    }
    archive.flags("valid", &[valid.len()], &valid)?;
    for curve in &scene.outputs.curves {
        curve_arrays(run, *curve, formally, &mut archive)?;
    }
    verdict.close(run);
    archive.write(out)?;
    Ok(verdict)
}

fn curve_arrays(run: &Run<'_>, curve: Quantity, formally: bool, archive: &mut Archive) -> io::Result<()> {
    let scene = run.scene();
    let places = run.grid(curve).len();
    let (mut at, mut values, mut errors, mut proven) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let mut take = |index: usize, state: Option<State>| -> io::Result<()> {
        at.clear();
        for (_, point) in run.curve(curve, state) {
            at.push(point.at);
            let (value, error) = match point.value {
                Ok(found) => found,
                Err(why) if infinite_value(curve, why).is_some() => (infinite_value(curve, why).unwrap_or(f64::NAN), f64::INFINITY),
                Err(why) => return Err(missing(index, curve.key(), why)),
            };
            values.push(value);
            errors.push(error);
            proven.push(point.bound == Bound::Proven);
        }
        Ok(())
    };
    let shape = if curve.needs_radius() {
        (0..scene.loads.len()).try_for_each(|index| take(index, run.state(index, formally)))?;
        vec![scene.loads.len(), places]
    } else {
        take(0, None)?;
        vec![places]
    };
    let name = curve.key();
    archive.numbers(name, &shape, &values)?;
    archive.numbers(&format!("{name}_error"), &shape, &errors)?;
    archive.flags(&format!("{name}_proven"), &shape, &proven)?;
    archive.numbers(&format!("{name}_at"), &[places], &at)?;
    archive.text(&format!("{name}_unit"), &scene.system.unit_name(curve.dimension()))?;
    archive.text(&format!("{name}_at_unit"), &scene.system.unit_name(Dimension::LENGTH))
}

fn missing(index: usize, name: &str, why: &str) -> io::Error {
    io::Error::new(
        io::ErrorKind::InvalidData,
        format!("load {}, {name}: {why}; use CSV or JSON, which can contain missing values", index + 1),
    )
}
