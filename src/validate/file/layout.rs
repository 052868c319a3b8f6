//! User-defined layout of data files (meaning of columns, size of the box, position of the axis), and conversion of arrays to columns.

use crate::validate::ValidationError;
use crate::validate::file::array::Array;
use crate::validate::file::column::{Column, Kind, Reading, read, read_mapped};

/// The position of the axis in the domain of a solver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// Coordinates begin in a corner of the box; the axis is in the middle.
    Corner,
    /// The axis is in the middle of the box, between pixels.
    Centre,
    /// The axis is on the centre of the pixel in the middle of the box.
    Pixel,
}

/// The meaning of the pressures in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::validate) enum Averaging {
    /// Values at points.
    Values,
    /// Means over square pixels centred on the points.
    OverSquares,
    /// Means over rings that end halfway between neighbouring radii.
    OverRings,
}

impl Averaging {
    /// Returns the kind of mean if a column contains the widths of cells, as named by `reference`: `cell`, `cell_um`, `ring_m`.
    pub(in crate::validate) fn named(column: &str) -> Option<Self> {
        match column.trim().split_once('_').map_or(column.trim(), |own| own.0) {
            "cell" => Some(Self::OverSquares),
            "ring" => Some(Self::OverRings),
            _ => None,
        }
    }
}

/// User-defined layout of the files.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layout {
    /// Symbol of a quantity, optionally with a unit, and name of its column.
    pub map: Vec<(String, String)>,
    /// The side of the box, in computing units.
    pub side: Option<f64>,
    /// The side of the box, in the output unit of length of the scene.
    pub shown_side: Option<f64>,
    /// The position of the axis.
    pub origin: Option<Origin>,
    /// True if the user gives the radii of an array, which replace the radii in the outputs of the scene.
    pub radii: bool,
    /// True if pressures are means over cells; `None` if it follows from the files or the scene, or is unknown.
    pub cells: Option<bool>,
}

impl Layout {
    /// Checks the symbols of the map.
    ///
    /// # Errors
    /// [`ValidationError::Request`] for an unknown symbol, and for a column that is mapped twice.
    pub fn checked(self) -> Result<Self, ValidationError> {
        match self.map.iter().find(|(symbol, _)| !matches!(read(symbol, 0), Reading::Known(_))) {
            Some((symbol, column)) => Err(ValidationError::request(
                format!("the map {symbol}={column} is invalid: {symbol:?} is not a quantity that can be compared"),
                "expected one of d, F, a, A, U, k, r, x, y, p, u, u+c, f and g, optionally with a unit as in p_GPa",
            )),
            None => match self.map.iter().enumerate().find(|(index, own)| self.map.iter().take(*index).any(|other| other.1 == own.1)) {
                Some((_, (symbol, column))) => Err(ValidationError::request(
                    format!("the map {symbol}={column} is invalid: the column {column} is already mapped"),
                    "map each column only once",
                )),
                None => Ok(self),
            },
        }
    }

    /// Reads a column with this name.
    pub(in crate::validate) fn read(&self, name: &str, index: usize) -> Reading {
        match self.map.iter().find(|own| own.1 == name) {
            Some((symbol, _)) => match read_mapped(symbol, name, index) {
                Reading::Known(column) => Reading::Known(Column { name: name.to_owned(), ..column }),
                other => other,
            },
            None => match read(name, index) {
                // The map takes precedence over names.
                Reading::Known(column) if self.maps(column.kind) => Reading::Unknown,
                other => other,
            },
        }
    }

    /// Returns an error if the map names a column that does not exist.
    pub(in crate::validate) fn without_column(&self, names: &[String]) -> Option<ValidationError> {
        let (symbol, column) = self.map.iter().find(|own| !names.contains(&own.1))?;
        let help = match names {
            [] => "expected the name or the number of a column".to_owned(),
            names => format!("expected one of {}", names.join(", ")),
        };
        Some(ValidationError::request(format!("the map {symbol}={column} is invalid: no file contains a column {column:?}"), help))
    }

    fn maps(&self, kind: Kind) -> bool {
        self.map.iter().any(|own| matches!(read(&own.0, 0), Reading::Known(column) if column.kind == kind))
    }

    /// Returns true if the map only names the field in column 1; an array with two indices is then the field.
    fn names_the_whole(&self) -> bool {
        let is_field = |symbol: &str| matches!(read(symbol, 0), Reading::Known(column) if column.kind.is_field());
        matches!(self.map.as_slice(), [(symbol, column)] if column == "1" && is_field(symbol))
    }

    /// Returns true if columns are named by their numbers.
    pub(in crate::validate) fn by_number(&self) -> bool {
        self.map.iter().any(|own| own.1.parse::<usize>().is_ok())
    }
}

/// Columns of equal length.
pub(in crate::validate) struct Columns {
    pub(in crate::validate) names: Vec<String>,
    pub(in crate::validate) values: Vec<Vec<f64>>,
    pub(in crate::validate) notes: Vec<String>,
    /// True if coordinates were generated from the box, centred on the axis.
    pub(in crate::validate) placed: bool,
    /// The meaning of the pressures, if the file declares it.
    pub(in crate::validate) averaging: Option<Averaging>,
    /// True if the points are the radii in the outputs of the scene.
    pub(in crate::validate) radii: bool,
}

/// Minimum number of rows and columns of an array that is treated as a field by default.
const FIELD: usize = 9;

/// Converts the arrays of a file to columns.
pub(in crate::validate) fn columns(file: &str, mut arrays: Vec<Array>, layout: &Layout) -> Result<Columns, ValidationError> {
    for own in &mut arrays {
        if own.shape.len() > 1 {
            own.shape.retain(|size| *size != 1);
        }
    }
    let units: Vec<(String, String)> = arrays.iter().filter_map(|own| Some((own.name.clone(), own.text.clone()?))).collect();
    let mut notes = Vec::new();
    let mut numbers: Vec<Array> = arrays.into_iter().filter(|own| own.text.is_none() && !own.shape.is_empty()).collect();
    // Coordinates of the curves written by `solve -o x.npz`.
    if !numbers.iter().any(|own| matches!(own.name.as_str(), "r" | "x")) {
        for name in ["p", "u"] {
            if let Some(own) = numbers.iter_mut().find(|own| own.name == format!("{name}_at")) {
                own.name = "r".to_owned();
                break;
            }
        }
    }
    numbers.retain(|own| !(own.name.ends_with("_error") || own.name.ends_with("_at") || own.name == "valid"));
    if let [only] = numbers.as_slice()
        && only.shape.len() == 3
    {
        numbers = layers(only);
        if layout.map.is_empty() {
            let message = format!("the array contains {} fields without names", numbers.len());
            return Err(ValidationError::data(file, None, message, "map the fields by number, such as x=1, y=2 and p=3"));
        }
    }
    if let [only] = numbers.as_mut_slice()
        && let [rows, columns] = *only.shape
    {
        if rows.min(columns) >= FIELD && layout.names_the_whole() {
            only.name = "1".to_owned();
        }
        let read = match layout.read(&only.name, 0) {
            Reading::Known(column) => Some(column.kind),
            _ => None,
        };
        // A name such as force.npy does not make forces of the numbers of a grid.
        let known = read.is_some_and(|own| own.is_field() || rows.min(columns) < FIELD);
        if let Some(kind @ (Kind::Profile | Kind::Equivalent)) = read
            && layout.map.is_empty()
        {
            notes.push(format!("the array {:?} is read as {}; map p=1 to read it as p", only.name, kind.symbol()));
        }
        if !known && (rows.min(columns) < FIELD || layout.by_number()) {
            // An array with few rows and many columns was stacked; otherwise each column is a quantity.
            let stacked = rows < FIELD && rows < columns;
            let values = match stacked {
                true => only.values.chunks(columns).map(<[f64]>::to_vec).collect(),
                false => (0..columns).map(|column| only.values.iter().skip(column).step_by(columns).copied().collect()).collect(),
            };
            let names = (1..=if stacked { rows } else { columns }).map(|own| own.to_string()).collect();
            return Ok(Columns { names, values, notes, placed: false, averaging: None, radii: false });
        }
        if !known {
            notes.push(format!("the array {:?} is read as p; map u={} to read it as u", only.name, only.name));
            only.name = "p".to_owned();
        }
    }
    let kind = |own: &Array| match layout.read(&own.name, 0) {
        Reading::Known(column) => Some(column.kind),
        _ => None,
    };
    let field = numbers.iter().find(|own| own.shape.len() == 2 && kind(own).is_some_and(Kind::is_field));
    let mut columns = Columns { names: Vec::new(), values: Vec::new(), notes, placed: false, averaging: None, radii: false };
    let mut add = |name: &str, values: Vec<f64>| {
        let unit = units.iter().find(|own| own.0 == format!("{name}_unit")).map(|own| own.1.as_str()).filter(|own| !own.is_empty());
        columns.names.push(unit.map_or_else(|| name.to_owned(), |unit| format!("{name}_{unit}")));
        columns.values.push(values);
    };
    let Some(shape) = field.map(|own| own.shape.clone()) else {
        let length = numbers.iter().filter(|own| kind(own).is_some()).map(|own| own.values.len()).max().unwrap_or(0);
        for own in &numbers {
            if own.values.len() == length && own.shape.len() == 1 {
                add(&own.name, own.values.clone());
            } else if kind(own).is_some() {
                let shape = own.shape.iter().map(usize::to_string).collect::<Vec<_>>().join(" x ");
                return Err(ValidationError::data(
                    file,
                    None,
                    format!("array {} has the shape {shape}, but another array has {length} numbers", own.name),
                    "expected arrays of one length, or fields of one shape with x and y or a box",
                ));
            }
        }
        return Ok(columns);
    };
    let [rows, across] = *shape.as_slice() else { return Ok(columns) };
    let of = |wanted: Kind| numbers.iter().find(|own| kind(own) == Some(wanted));
    let (x, y, r) = (of(Kind::X), of(Kind::Y), of(Kind::Distance));
    let every = |place: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
        (0..rows).flat_map(|i| (0..across).map(move |j| (i, j))).map(|(i, j)| place(i, j)).collect()
    };
    let at = |own: &Array, index: usize| own.values.get(index).copied().unwrap_or(f64::NAN);
    match (x, y, r, layout.shown_side) {
        (Some(x), Some(y), _, _) if x.shape == shape && y.shape == shape => {
            add(&x.name, x.values.clone());
            add(&y.name, y.values.clone());
        }
        (Some(x), Some(y), _, _) if x.shape == [across] && y.shape == [rows] => {
            add(&x.name, every(&|_, j| at(x, j)));
            add(&y.name, every(&|i, _| at(y, i)));
        }
        (Some(x), Some(y), _, _) if x.shape == [rows] && y.shape == [across] => {
            add(&x.name, every(&|i, _| at(x, i)));
            add(&y.name, every(&|_, j| at(y, j)));
        }
        (_, _, Some(r), _) if r.shape == shape => add(&r.name, r.values.clone()),
        (None, None, None, Some(side)) => {
            let field = field.map_or(&[][..], |own| &own.values);
            let (up, right) = middle(field, rows, across, layout.origin);
            let pixel = side / rows.max(across) as f64;
            add("x", every(&|_, j| (j as f64 - right) * pixel));
            add("y", every(&|i, _| (i as f64 - up) * pixel));
            if rows != across {
                let [along_x, along_y] = [across, rows].map(|own| own as f64 * pixel);
                columns.notes.push(format!("assuming square pixels, the box is {along_x:.6} along x and {along_y:.6} along y"));
            }
            let pixel = right == (across / 2) as f64 && up == (rows / 2) as f64;
            let place = if pixel { "on the centre of a pixel" } else { "between pixels" };
            columns.placed = true;
            columns.notes.push(format!("the axis is assumed to be {place} in the middle of the box"));
        }
        _ => {
            let shape = format!("{rows} x {across}");
            return Err(ValidationError::data(
                file,
                None,
                format!("a field of {shape} numbers has no coordinates"),
                "expected x and y of this shape or along its sides, or the side of the domain, such as box = \"8 um\" in [data]",
            ));
        }
    }
    for own in &numbers {
        let placed = matches!(kind(own), Some(Kind::X | Kind::Y | Kind::Distance));
        if own.shape == shape && !placed {
            let unit = units.iter().find(|unit| unit.0 == format!("{}_unit", own.name)).map(|unit| unit.1.as_str());
            columns.names.push(unit.filter(|own| !own.is_empty()).map_or_else(|| own.name.clone(), |unit| format!("{}_{unit}", own.name)));
            columns.values.push(own.values.clone());
        }
    }
    Ok(columns)
}

/// Returns the fields in an array with three indices, named by their numbers from 1.
fn layers(array: &Array) -> Vec<Array> {
    let shape = array.shape.get(1..).unwrap_or_default();
    let each = shape.iter().product::<usize>().max(1);
    let layer = |(index, values): (usize, &[f64])| Array {
        name: (index + 1).to_string(),
        shape: shape.to_vec(),
        values: values.to_vec(),
        text: None,
    };
    array.values.chunks(each).enumerate().map(layer).collect()
}

/// Returns row and column of the axis as declared, or else the centre about which the field is more symmetric.
///
/// The centre of mass of displacements is not reliable, since they do not vanish at the edge of the box.
fn middle(field: &[f64], rows: usize, across: usize, origin: Option<Origin>) -> (f64, f64) {
    let pixel = ((rows / 2) as f64, (across / 2) as f64);
    let between = (0.5 * (rows as f64 - 1.0), 0.5 * (across as f64 - 1.0));
    match origin {
        Some(Origin::Centre) => return between,
        Some(Origin::Pixel | Origin::Corner) => return pixel,
        None => {}
    }
    // The mean difference of values at opposite points.
    let asymmetry = |(up, right): (f64, f64)| {
        let opposite = |middle: f64, index: usize, size: usize| {
            let other = (2.0 * middle) as usize;
            other.checked_sub(index).filter(|own| *own < size)
        };
        let (mut sum, mut pairs) = (0.0, 0_u32);
        for (index, value) in field.iter().enumerate() {
            let other = opposite(up, index / across, rows)
                .zip(opposite(right, index % across, across))
                .and_then(|(i, j)| field.get(i * across + j));
            if let Some(difference) = other.map(|other| (value - other).abs()).filter(|own| own.is_finite()) {
                sum += difference;
                pairs += 1;
            }
        }
        sum / f64::from(pairs)
    };
    if asymmetry(between) < asymmetry(pixel) { between } else { pixel }
}
