//! The first pass over a file: its contents, the range of its coordinates, and the inferred pixel.

use crate::contact::Load;
use crate::scene::Scene;
use crate::validate::diagnosis::placing::Extent;
use crate::validate::file::column::{Column, Kind};
use crate::validate::file::data::Data;
use crate::validate::file::lattice;
use crate::validate::file::lattice::{Lattice, Offset};
use crate::validate::file::layout::{Averaging, Layout, Origin};
use crate::validate::file::row::Row;
use crate::validate::file::table::Table;
use crate::validate::file::units::DataUnits;
use crate::validate::{FileReport, ValidationError};
use std::collections::BTreeSet;

/// The kind of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::validate) enum Content {
    /// One load per row.
    Loads,
    /// One point per row, all under one load.
    Field,
}

impl Content {
    /// True if a column of this kind says something in such a file.
    fn reads(self, kind: Kind, data: &Data<'_>) -> bool {
        let of_loads = matches!(kind, Kind::Depth | Kind::Force | Kind::ContactRadius | Kind::Energy | Kind::Stiffness);
        match self {
            Self::Loads => of_loads,
            Self::Field => !of_loads || data.load_kinds().contains(&kind),
        }
    }
}

/// The results of the first pass; lengths are in computing units.
pub(in crate::validate) struct Survey<'s> {
    pub(in crate::validate) data: Data<'s>,
    /// The coordinates of the axis in both directions.
    axis: f64,
    pub(in crate::validate) content: Content,
    /// Factors that convert the columns to computing units.
    pub(in crate::validate) factors: Vec<f64>,
    pub(in crate::validate) columns: Vec<Column>,
    pub(in crate::validate) rows: u64,
    pub(in crate::validate) largest: Vec<f64>,
    pub(in crate::validate) lattice: Option<Lattice>,
    /// The range of x and y, relative to the axis.
    pub(in crate::validate) extent: Extent,
    /// The meaning of the pressures, if the user, the file or the scene declares it.
    pub(in crate::validate) averaging: Option<Averaging>,
    /// The pixel inferred from contact radii.
    pub(in crate::validate) counted: Option<f64>,
    pub(in crate::validate) notes: Vec<String>,
    /// The names of all columns.
    pub(in crate::validate) names: Vec<String>,
    /// The names of the ignored columns.
    pub(in crate::validate) unread: Vec<String>,
}

/// Maximum number of smallest distances and of distinct contact radii.
const KEPT: usize = 400;
const RADII: usize = 40;
const HELP: &str = "expected columns such as d_um,F_mN,a_um for loads, or r_um,p_GPa (or x_um,y_um,p_GPa) for fields";

impl<'s> Survey<'s> {
    /// Reads a file once.
    pub(in crate::validate) fn new(data: Data<'s>, scene: &Scene, units: &mut DataUnits) -> Result<Self, ValidationError> {
        let (source, layout) = (data.source, data.layout);
        let mut table = Table::open(&data)?;
        let content = content(&source.name, &table).map_err(|error| layout.without_column(&table.names).unwrap_or(error))?;
        let columns = table.columns.clone();
        let mut factors = Vec::new();
        for column in &columns {
            factors.push(units.factor(scene, &source.name, column)?);
        }
        let axis = axis(&table, layout)?;
        let places = Places { axis, ..Places::of(&table) };
        let a = table.index(Kind::ContactRadius);
        let load = table.index(Kind::Depth).or(table.index(Kind::Force));
        let (mut rows, mut largest) = (0, vec![0.0_f64; columns.len()]);
        let (mut nearest, mut xs, mut radii) = (Nearest::default(), BTreeSet::new(), Vec::new());
        let (mut row, mut extent) = (Vec::new(), Extent::NONE);
        while table.next(&mut row)?.is_some() {
            rows += 1;
            for ((value, factor), most) in row.iter_mut().zip(&factors).zip(&mut largest) {
                *value *= factor;
                *most = most.max(value.abs());
            }
            if content == Content::Field {
                for (direction, column) in [places.x, places.y].into_iter().enumerate() {
                    if let Some(own) = column.and_then(|own| row.get(own)) {
                        extent.take(direction, own - axis);
                    }
                }
                if let Some(r) = places.distance(&row) {
                    nearest.take(r.abs());
                }
                if let (Some(x), true) = (places.x.and_then(|x| row.get(x)), xs.len() < 20 * KEPT) {
                    xs.insert(Ordered(*x));
                }
            } else if let (Some(a), Some(load), true) = (a.and_then(|a| row.get(a)), load.and_then(|own| row.get(own)), radii.len() < RADII)
                // A row before contact has no area to count.
                && *a > 0.0
                && radii.iter().all(|own: &(f64, f64)| own.0 != *a)
            {
                radii.push((*a, *load));
            }
        }
        let mut notes = std::mem::take(&mut table.notes);
        let mut unread = std::mem::take(&mut table.unread);
        unread.extend(columns.iter().filter(|own| !content.reads(own.kind, &data)).map(|own| own.name.clone()));
        let names = std::mem::take(&mut table.names);
        if rows == 0 {
            return Err(ValidationError::data(
                &source.name,
                None,
                "the file contains a header but no rows",
                "expected at least one row of numbers",
            ));
        }
        notes.extend(table.skipped());
        let mut lattice = lattice::of_distances(&nearest.distinct());
        if let (Some(gap), true) = (gap(&xs), places.x.is_some()) {
            lattice = Some(Lattice { pixel: gap, offset: lattice.map_or(Offset::Centre, |own| own.offset) });
        }
        let counted = lattice::of_areas(&radii);
        drop(table);
        let own = data.arrays.as_ref().and_then(|own| own.averaging).or_else(|| names.iter().find_map(|own| Averaging::named(own)));
        let squares = |cells: bool| if cells { Averaging::OverSquares } else { Averaging::Values };
        let averaging = match layout.cells {
            Some(true) => own.filter(|own| *own != Averaging::Values).or(Some(Averaging::OverSquares)),
            Some(false) => Some(Averaging::Values),
            None => own.or_else(|| scene.data.as_ref().and_then(|own| own.cells).map(squares)),
        };
        Ok(Self { data, axis, averaging, content, factors, columns, rows, largest, lattice, extent, counted, notes, names, unread })
    }

    /// Returns the side of the square that the points fill, if there is a row for every pixel.
    pub(in crate::validate) fn filled_square(&self) -> Option<f64> {
        const FEWEST: f64 = 8.0;
        let pixel = self.lattice?.pixel;
        let [x, y] = [0, 1].map(|axis: usize| {
            let (low, high) = (self.extent.low.get(axis)?, self.extent.high.get(axis)?);
            Some(((high - low) / pixel).round() + 1.0).filter(|own| own.is_finite())
        });
        let count = x.filter(|own| Some(*own) == y && *own >= FEWEST)?;
        (count * count == self.rows as f64).then_some(count * pixel)
    }

    /// Returns a report of this file without columns and plots.
    pub(in crate::validate) fn report(&self, scene: &Scene, grid: Option<f64>) -> FileReport {
        let (name, notes) = (self.name(scene), self.notes.clone());
        FileReport { name, grid, pixel: None, rows: self.rows, columns: Vec::new(), notes, plots: Vec::new() }
    }

    /// Returns the name of the file, with the load of the rows.
    pub(in crate::validate) fn name(&self, scene: &Scene) -> String {
        let file = &self.data.source.name;
        self.load_name(scene).map_or_else(|| file.clone(), |load| format!("{file}, {load}"))
    }

    /// Returns the load of the rows as text, such as `d = 0.4 um`.
    pub(in crate::validate) fn load_name(&self, scene: &Scene) -> Option<String> {
        let (kind, load) = self.data.load?;
        Some(format!("{} = {load} {}", kind.symbol(), self.unit(kind, scene)).trim_end().to_owned())
    }

    /// Returns the load of the rows in computing units.
    pub(in crate::validate) fn load_value(&self) -> Option<f64> {
        let (kind, load) = self.data.load?;
        Some(load * self.factors.get(self.index(kind)?)?)
    }

    /// Returns the load of the rows; `None` if it is the load of the scene.
    pub(in crate::validate) fn load(&self) -> Option<Load> {
        let value = self.load_value()?;
        Some(match self.data.load?.0 {
            Kind::Force => Load::Force(value),
            Kind::ContactRadius => Load::Radius(value),
            _ => Load::Depth(value),
        })
    }

    /// Returns the index of a kind of column.
    pub(in crate::validate) fn index(&self, kind: Kind) -> Option<usize> {
        self.columns.iter().position(|own| own.kind == kind)
    }

    /// Returns the largest absolute value of a kind of column.
    pub(in crate::validate) fn largest(&self, kind: Kind) -> Option<f64> {
        self.index(kind).and_then(|own| self.largest.get(own)).copied()
    }

    /// Converts a number to the unit of the data.
    pub(in crate::validate) fn shown(&self, kind: Kind, computed: f64) -> f64 {
        self.index(kind).and_then(|own| self.factors.get(own)).map_or(computed, |factor| computed / factor)
    }

    /// Returns the unit of a kind of column as named in the file.
    pub(in crate::validate) fn unit(&self, kind: Kind, scene: &Scene) -> String {
        let own = self.columns.iter().find(|own| own.kind == kind);
        own.and_then(|own| own.unit.as_ref()).map_or_else(|| scene.system.unit_name(kind.dimension()), |unit| unit.name().to_owned())
    }

    /// Returns the symbols of the columns, their names in a sentence and their units; an array without coordinates has its box instead of r.
    pub(in crate::validate) fn labels(&self, scene: &Scene) -> Vec<(&'static str, &'static str, String)> {
        let label = |kind: Kind| (kind.symbol(), kind.symbol(), self.unit(kind, scene));
        let placed = self.data.arrays.as_ref().is_some_and(|own| own.placed);
        let distance =
            if placed { ("r", "the box", String::new()) } else { ("r", self.distance().symbol(), self.unit(self.distance(), scene)) };
        [Kind::Depth, Kind::Force, Kind::ContactRadius, Kind::Pressure].map(label).into_iter().chain([distance]).collect()
    }

    /// Returns a number of the data with its symbol and unit, such as `d = 60 nm`.
    pub(in crate::validate) fn place(&self, kind: Kind, at: f64, scene: &Scene) -> String {
        format!("{} = {at} {}", kind.symbol(), self.unit(kind, scene)).trim_end().to_owned()
    }

    /// Returns the column of the coordinates: r, or x next to y.
    pub(in crate::validate) fn distance(&self) -> Kind {
        if self.index(Kind::Distance).is_some() { Kind::Distance } else { Kind::X }
    }

    /// Returns the factors that convert the columns d, F and a to computing units.
    pub(in crate::validate) fn row_factors(&self) -> Row {
        let factor = |kind: Kind| self.index(kind).and_then(|own| self.factors.get(own)).copied().unwrap_or(1.0);
        Row { depth: factor(Kind::Depth), force: factor(Kind::Force), radius: factor(Kind::ContactRadius) }
    }

    /// Returns the factors that convert the columns r (or x) and p to computing units.
    pub(in crate::validate) fn place_factors(&self) -> (f64, f64) {
        let factor = |kind: Kind| self.index(kind).and_then(|own| self.factors.get(own)).copied();
        (factor(Kind::Distance).or(factor(Kind::X)).unwrap_or(1.0), factor(Kind::Pressure).unwrap_or(1.0))
    }

    /// Returns the cell over which the pressures are means, for a pixel of this size.
    pub(in crate::validate) fn cell(&self, pixel: Option<f64>) -> Option<Cell> {
        match (self.averaging?, pixel?) {
            (Averaging::Values, _) => None,
            (Averaging::OverSquares, side) => Some(Cell::Square { side }),
            (Averaging::OverRings, width) => Some(Cell::Ring { width }),
        }
    }

    /// The source of the distances to the axis.
    pub(in crate::validate) fn places(&self) -> Places {
        Places { r: self.index(Kind::Distance), x: self.index(Kind::X), y: self.index(Kind::Y), axis: self.axis }
    }
}

/// A cell around a point, over which a pressure is a mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::validate) enum Cell {
    Square { side: f64 },
    Ring { width: f64 },
}

impl Cell {
    /// Returns two radii at which a pressure equals the mean over the cell around r to third order in the width, by Gauss's rule: two points
    /// along each side of a square, and two in r² across a ring.
    pub(in crate::validate) fn radii(self, r: f64) -> [f64; 2] {
        let gauss = 1.0 / 12f64.sqrt();
        match self {
            Self::Square { side } => [(r + gauss * side).hypot(gauss * side), (r - gauss * side).hypot(gauss * side)],
            Self::Ring { width } => {
                let (inner, outer) = ((r - 0.5 * width).max(0.0), r + 0.5 * width);
                [0.5 - gauss, 0.5 + gauss].map(|share| (inner * inner + share * (outer - inner) * (outer + inner)).sqrt())
            }
        }
    }
}

/// The columns with the coordinates of a row.
#[derive(Clone, Copy)]
pub(in crate::validate) struct Places {
    pub(in crate::validate) r: Option<usize>,
    pub(in crate::validate) x: Option<usize>,
    pub(in crate::validate) y: Option<usize>,
    /// The coordinates of the axis in both directions.
    pub(in crate::validate) axis: f64,
}

impl Places {
    fn of(table: &Table<'_>) -> Self {
        Self { r: table.index(Kind::Distance), x: table.index(Kind::X), y: table.index(Kind::Y), axis: 0.0 }
    }

    /// Returns the distance between a row and the axis.
    pub(in crate::validate) fn distance(&self, row: &[f64]) -> Option<f64> {
        match (self.r, self.x, self.y) {
            (Some(r), _, _) => row.get(r).copied(),
            (None, Some(x), Some(y)) => Some((row.get(x)? - self.axis).hypot(row.get(y)? - self.axis)),
            (None, Some(x), None) => row.get(x).map(|x| (x - self.axis).abs()),
            _ => None,
        }
    }
}

/// Returns the coordinate of the axis if coordinates begin in a corner of the box.
fn axis(table: &Table<'_>, layout: &Layout) -> Result<f64, ValidationError> {
    if layout.origin != Some(Origin::Corner) || table.placed || table.index(Kind::X).is_none() {
        return Ok(0.0);
    }
    layout.side.map(|side| 0.5 * side).ok_or_else(|| {
        let message = "coordinates that begin in a corner require the box, since the axis is in the middle";
        ValidationError::request(message, "expected the side of the domain, such as box = \"8 um\" in [data]")
    })
}

fn content(file: &str, table: &Table<'_>) -> Result<Content, ValidationError> {
    let has = |kind: Kind| table.index(kind).is_some();
    let names: Vec<&str> = table.columns.iter().map(|own| own.name.as_str()).collect();
    let found =
        if names.is_empty() { "no column was recognized".to_owned() } else { format!("the recognized columns are {}", names.join(", ")) };
    let missing = |what: &str| ValidationError::data(file, None, format!("{what}: {found}"), HELP);
    let place = has(Kind::Distance) || has(Kind::X);
    let values = table.columns.iter().any(|own| own.kind.is_field());
    let loads = [Kind::Depth, Kind::Force, Kind::ContactRadius].into_iter().filter(|own| has(*own)).count();
    match (place, values, loads) {
        (true, true, _) => Ok(Content::Field),
        (false, true, 0) => Err(missing("missing column r, or x and y, for the points of the pressures")),
        (true, false, 0) => Err(missing("missing column p or u")),
        (_, _, 0) => Err(missing("there is nothing to compare")),
        (_, _, 1) => Err(missing("at least two of d, F and a are required")),
        _ => Ok(Content::Loads),
    }
}

/// A number in a sorted set.
#[derive(Clone, Copy, PartialEq)]
struct Ordered(f64);

impl Eq for Ordered {}

impl PartialOrd for Ordered {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Ordered {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

/// The smallest distances of a file, up to a maximum number.
#[derive(Default)]
struct Nearest {
    kept: BTreeSet<Ordered>,
}

impl Nearest {
    fn take(&mut self, r: f64) {
        let full = self.kept.len() >= KEPT;
        if full && self.kept.last().is_some_and(|last| r >= last.0) {
            return;
        }
        self.kept.insert(Ordered(r));
        if self.kept.len() > KEPT {
            self.kept.pop_last();
        }
    }

    /// Removes values that differ only by rounding.
    fn distinct(&self) -> Vec<f64> {
        let scale = self.kept.last().map_or(0.0, |own| own.0);
        let mut all: Vec<f64> = self.kept.iter().map(|own| own.0).collect();
        all.dedup_by(|one, other| (*one - *other).abs() <= 1e-7 * scale);
        if let Some(first) = all.first_mut()
            && *first <= 1e-9 * scale
        {
            *first = 0.0;
        }
        all
    }
}

/// Returns the smallest distance between two coordinates if all others are multiples of it.
fn gap(xs: &BTreeSet<Ordered>) -> Option<f64> {
    // Coordinates may be printed with few digits.
    const OFF: f64 = 0.2;
    let scale = xs.first()?.0.abs().max(xs.last()?.0.abs());
    let all: Vec<f64> = xs.iter().map(|own| own.0).collect();
    let gaps = || all.windows(2).map(|pair| pair[1] - pair[0]).filter(|own| *own > 1e-7 * scale);
    let least = gaps().min_by(f64::total_cmp)?;
    // The mean distance between neighbours is more accurate than the smallest one.
    let near: Vec<f64> = gaps().filter(|own| *own < 1.5 * least).collect();
    let mean = near.iter().sum::<f64>() / near.len() as f64;
    gaps().all(|own| (own / mean - (own / mean).round()).abs() <= OFF).then_some(mean)
}
