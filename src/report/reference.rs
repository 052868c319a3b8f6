//! Exact fields on the grid of a solver as CSV, JSON and NPY, load by load; only one field is stored at a time.

use crate::contact::State;
use crate::num::Bound;
use crate::report::digits::Digits;
use crate::report::solved::json::CompletionOf;
use crate::scene::{Dimension, Field, Grid, Quantity, Run, infinite_value};
use serde::Serialize;
use serde::ser::{SerializeSeq, Serializer};
use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};

/// The requested fields under all loads of a run on one grid.
pub struct Reference<'a, 'r> {
    /// The run.
    pub run: &'a Run<'r>,
    /// The grid.
    pub grid: &'a Grid,
    /// The fields.
    pub curves: &'a [Quantity],
    /// True if pressures are means over cells.
    pub cells: bool,
    /// The number of digits of the values in CSV.
    pub digits: Digits,
}

impl Reference<'_, '_> {
    fn states(&self) -> impl Iterator<Item = (usize, Option<State>)> + '_ {
        (0..self.run.scene().loads.len()).map(|index| (index, self.run.state(index, false)))
    }

    fn field(&self, curve: Quantity, state: Option<&State>) -> Field {
        self.run.field(self.grid, curve, state, self.cells)
    }

    /// Returns all points of the grid; in a square, the row is the first index.
    fn places(&self) -> Vec<usize> {
        self.grid.shape()
    }

    /// Writes one line per point and load, with the depth of the load if there are several; every field has its error bound
    /// in the next column, and then the kind of bound. If pressures are means, the last column, `cell` or `ring`, contains the widths of the cells.
    ///
    /// Returns the number of loads without a valid contact.
    ///
    /// # Errors
    /// Returns the errors of the writer.
    pub fn csv(&self, out: &mut dyn Write) -> io::Result<usize> {
        let scene = self.run.scene();
        let (length, factor) = (scene.system.unit_name(Dimension::LENGTH), scene.system.out(Dimension::LENGTH));
        let named = |name: &str, unit: &str| if unit.is_empty() { name.to_owned() } else { format!("{name}_{unit}") };
        let several = scene.loads.len() > 1;
        let mut header = if several { vec![named("d", &length)] } else { Vec::new() };
        let square = matches!(self.grid, Grid::Square { .. });
        let planar = square || matches!(self.grid, Grid::Points { y: Some(_), .. });
        header.extend(if planar { ["x", "y", "r"].as_slice() } else { &["r"] }.iter().map(|own| named(own, &length)));
        for curve in self.curves {
            let unit = scene.system.unit_name(curve.dimension());
            let (error, bound) = (format!("{}_error", curve.key()), format!("{}_bound", curve.key()));
            header.extend([named(curve.key(), &unit), named(&error, &unit), bound]);
        }
        if self.cells {
            header.push(named(if square { "cell" } else { "ring" }, &length));
        }
        writeln!(out, "{}", header.join(","))?;
        let cell = |index: usize| self.cells.then(|| self.grid.cell_width(index));
        let mut missing = 0;
        for (index, state) in self.states() {
            missing += usize::from(state.is_none());
            let fields: Vec<Field> = self.curves.iter().map(|curve| self.field(*curve, state.as_ref())).collect();
            let depth = super::solved::text::depth(self.run, index, state.as_ref(), self.digits).unwrap_or_default();
            let mut line = |coordinates: &[f64], place: &[usize], cell: Option<f64>| -> io::Result<()> {
                if several {
                    write!(out, "{depth},")?;
                }
                let numbers: Vec<String> = coordinates.iter().map(|own| format!("{:?}", own * factor)).collect();
                write!(out, "{}", numbers.join(","))?;
                for field in &fields {
                    match field.at(place).map(|(value, error)| self.digits.shown(value, error)) {
                        Ok((value, error)) => write!(out, ",{value:?},{error:?},{}", field.bound().name())?,
                        Err(_) => write!(out, ",,,")?,
                    }
                }
                if let Some(width) = cell {
                    write!(out, ",{:?}", width * factor)?;
                }
                writeln!(out)
            };
            match self.places().as_slice() {
                [count] => (0..*count).try_for_each(|i| line(&self.grid.place(i), &[i], cell(i)))?,
                [rows, columns] => {
                    for i in 0..*rows {
                        let y = self.grid.coordinate(i);
                        for j in 0..*columns {
                            let x = self.grid.coordinate(j);
                            line(&[x, y, x.hypot(y)], &[i, j], cell(j))?;
                        }
                    }
                }
                _ => {}
            }
        }
        Ok(missing)
    }

    /// Writes one JSON document: coordinates, then per load and field the values and their error bounds, row by row.
    ///
    /// Returns the number of loads without a valid contact.
    ///
    /// # Errors
    /// Returns the errors of the writer.
    pub fn json(&self, out: &mut dyn Write) -> io::Result<usize> {
        #[derive(Serialize)]
        struct Document<'a, 'b, 'r> {
            units: Option<UnitNames<'a>>,
            effective_modulus: f64,
            grid: GridEntry,
            loads: Loads<'a, 'b, 'r>,
            #[serde(flatten)]
            completion: CompletionOf<'b, 'r>,
        }
        #[derive(Serialize)]
        struct UnitNames<'a> {
            length: &'a str,
            force: &'a str,
            pressure: &'a str,
        }
        #[derive(Serialize)]
        #[serde(tag = "kind", rename_all = "lowercase")]
        enum GridEntry {
            Radial { r: Vec<f64>, cells: bool },
            Square { count: usize, side: f64, x: Vec<f64>, y: Vec<f64>, cells: bool },
            Points { x: Vec<f64>, y: Vec<f64>, cells: bool },
        }
        let scene = self.run.scene();
        let units = scene.system.names().map(|own| UnitNames { length: &own.length, force: &own.force, pressure: &own.pressure });
        let factor = scene.system.out(Dimension::LENGTH);
        let coordinates = |count: usize| (0..count).map(|index| self.grid.coordinate(index) * factor).collect::<Vec<_>>();
        let grid = match self.grid {
            Grid::Radial(r) => GridEntry::Radial { r: coordinates(r.len()), cells: self.cells },
            Grid::Points { x, y: None } => GridEntry::Radial { r: coordinates(x.len()), cells: false },
            Grid::Points { x, y: Some(y) } => {
                GridEntry::Points { x: coordinates(x.len()), y: y.iter().map(|own| own * factor).collect(), cells: false }
            }
            Grid::Square { side, count, .. } => {
                let x = coordinates(*count);
                GridEntry::Square { count: *count, side: side * factor, y: x.clone(), x, cells: self.cells }
            }
        };
        let missing = Cell::new(0);
        let loads = Loads { own: self, missing: &missing };
        let document = Document {
            units,
            effective_modulus: scene.effective_modulus * scene.system.out(Dimension::PRESSURE),
            grid,
            loads,
            completion: CompletionOf(self.run),
        };
        super::json::write("reference", &document, out)?;
        Ok(missing.get())
    }

    /// Writes a NumPy array of little-endian doubles of the shape (loads, quantities, 2, …grid): value, then error.
    ///
    /// A theoretically infinite value is infinite with an infinite error; any other missing value is an error.
    ///
    /// Returns the quantities whose error bounds are estimated, which an array of numbers cannot record.
    ///
    /// # Errors
    /// Returns the errors of the writer, and [`io::ErrorKind::InvalidData`] with the reason for a missing value.
    pub fn npy(&self, out: &mut dyn Write) -> io::Result<BTreeSet<&'static str>> {
        let grid = self.places();
        let shape = [&[self.run.scene().loads.len(), self.curves.len(), 2], grid.as_slice()].concat();
        out.write_all(&super::npy::header("<f8", &shape))?;
        let mut estimated = BTreeSet::new();
        for (index, state) in self.states() {
            for curve in self.curves {
                let field = self.field(*curve, state.as_ref());
                if field.bound() == Bound::Estimated {
                    estimated.insert(curve.key());
                }
                for part in 0..2 {
                    let mut write = |place: &[usize]| match field.at(place) {
                        Ok((value, error)) => out.write_all(&if part == 0 { value } else { error }.to_le_bytes()),
                        Err(why) if infinite_value(*curve, why).is_some() => {
                            let value = infinite_value(*curve, why).filter(|_| part == 0).unwrap_or(f64::INFINITY);
                            out.write_all(&value.to_le_bytes())
                        }
                        Err(why) => {
                            let message =
                                format!("load {}, {}: {why}; use CSV or JSON, which can contain missing values", index + 1, curve.key());
                            Err(io::Error::new(io::ErrorKind::InvalidData, message))
                        }
                    };
                    match grid.as_slice() {
                        [count] => (0..*count).try_for_each(|i| write(&[i]))?,
                        [rows, columns] => (0..*rows).try_for_each(|i| (0..*columns).try_for_each(|j| write(&[i, j])))?,
                        _ => {}
                    }
                }
            }
        }
        Ok(estimated)
    }
}

struct Loads<'a, 'b, 'r> {
    own: &'a Reference<'b, 'r>,
    missing: &'a Cell<usize>,
}

#[derive(Serialize)]
struct LoadEntry {
    d: Option<f64>,
    #[serde(rename = "F")]
    force: Option<f64>,
    a: Option<f64>,
    error_estimates: BTreeMap<&'static str, f64>,
    bounds: BTreeMap<&'static str, &'static str>,
    fields: Vec<FieldEntry>,
}

#[derive(Serialize)]
struct FieldEntry {
    quantity: &'static str,
    values: Rows,
    error_estimates: Rows,
    bound: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    why: Option<&'static str>,
}

/// Returns a list, or a list of rows.
#[derive(Serialize)]
#[serde(untagged)]
enum Rows {
    Line(Vec<Option<f64>>),
    Square(Vec<Vec<Option<f64>>>),
}

impl Loads<'_, '_, '_> {
    fn entry(&self, index: usize) -> LoadEntry {
        let own = self.own;
        let state = own.run.state(index, false);
        let system = &own.run.scene().system;
        let estimates = state.map(|state| own.run.state_estimates(index, &state)).unwrap_or_default();
        let shape = own.places();
        let fields = own.curves.iter().map(|curve| {
            let field = own.field(*curve, state.as_ref());
            let mut why = None;
            let mut rows = |pick: fn((f64, f64)) -> f64| match shape.as_slice() {
                [count] => Rows::Line((0..*count).map(|i| field.at(&[i]).map_err(|own| why = why.or(Some(own))).ok().map(pick)).collect()),
                [rows, columns] => {
                    let row = |i: usize| (0..*columns).map(|j| field.at(&[i, j]).ok().map(pick)).collect();
                    let first = (0..*rows).flat_map(|i| (0..*columns).map(move |j| [i, j])).find_map(|place| field.at(&place).err());
                    why = why.or(first);
                    Rows::Square((0..*rows).map(row).collect())
                }
                _ => Rows::Line(Vec::new()),
            };
            let (values, error_estimates) = (rows(|own| own.0), rows(|own| own.1));
            FieldEntry { quantity: curve.key(), values, error_estimates, bound: field.bound().name(), why }
        });
        LoadEntry {
            fields: fields.collect(),
            d: state.map(|state| own.run.shown_depth(index, &state)),
            force: state.map(|own| own.force * system.out(Dimension::FORCE)),
            a: state.map(|own| own.radius * system.out(Dimension::LENGTH)),
            error_estimates: estimates.iter().map(|(quantity, own)| (quantity.key(), own.error)).collect(),
            bounds: estimates.iter().map(|(quantity, own)| (quantity.key(), own.bound.name())).collect(),
        }
    }
}

impl Serialize for Loads<'_, '_, '_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let count = self.own.run.scene().loads.len();
        let mut list = serializer.serialize_seq(Some(count))?;
        for index in 0..count {
            let entry = self.entry(index);
            self.missing.set(self.missing.get() + usize::from(entry.d.is_none()));
            list.serialize_element(&entry)?;
        }
        list.end()
    }
}
