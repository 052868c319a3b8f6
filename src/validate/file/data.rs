//! The data to compare: a file, or the rows of one load in a file.

use crate::scene::Scene;
use crate::validate::ValidationError;
use crate::validate::file::array::{NPY, NPZ, NUMPY, arrays};
use crate::validate::file::column::Kind;
use crate::validate::file::layout::{Columns, Layout, columns};
use crate::validate::file::stacked;
use crate::validate::file::table::{Table, unreadable};
use std::io::{self, BufRead, BufReader, Read};
use std::rc::Rc;

/// A data file that can be opened more than once.
pub struct Source<'a> {
    /// The name in errors and reports.
    pub name: String,
    /// Opens the file at its beginning.
    pub open: Box<dyn Fn() -> io::Result<Box<dyn Read>> + 'a>,
}

/// A file, or the rows of one load in a file with fields under several loads.
pub(in crate::validate) struct Data<'s> {
    pub(in crate::validate) source: &'s Source<'s>,
    pub(in crate::validate) layout: &'s Layout,
    /// The arrays of a file that is not text.
    pub(in crate::validate) arrays: Option<Rc<Columns>>,
    /// The column of loads, and the load in the unit of the file.
    pub(in crate::validate) load: Option<(Kind, f64)>,
}

/// Maximum size of a file that is read as a whole, in bytes.
const LARGEST: u64 = 1_000_000_000;
/// Maximum number of loads in a file with fields.
const MOST_LOADS: usize = 1000;

impl<'s> Data<'s> {
    /// Returns the data of a file, split by loads if it contains fields under several loads.
    pub(in crate::validate) fn of(source: &'s Source<'s>, layout: &'s Layout, scene: &Scene) -> Result<Vec<Self>, ValidationError> {
        let mut whole = Self { source, layout, arrays: None, load: None };
        let mut file = whole.reader()?;
        let begin = file.fill_buf().map_err(|error| unreadable(&source.name, None, &error))?;
        let is_numpy = begin.starts_with(NPY) || begin.starts_with(NPZ);
        let is_json = begin.trim_ascii_start().starts_with(b"{");
        let ending = std::path::Path::new(&source.name).extension().and_then(|own| own.to_str()).unwrap_or_default();
        let (is_npy, is_npz) = (ending.eq_ignore_ascii_case("npy"), ending.eq_ignore_ascii_case("npz"));
        if (is_npy || is_npz) && !is_numpy {
            let kind = if is_npy { "NPY" } else { "NPZ" };
            let message = format!("this is not an {kind} file: its first bytes are others");
            return Err(ValidationError::data(&source.name, None, message, NUMPY));
        }
        if is_numpy || is_json {
            let mut bytes = Vec::new();
            file.take(LARGEST + 1).read_to_end(&mut bytes).map_err(|error| unreadable(&source.name, None, &error))?;
            if bytes.len() as u64 > LARGEST {
                let message = format!("the file is longer than {LARGEST} bytes, the limit for JSON and NumPy files");
                return Err(ValidationError::data(&source.name, None, message, "expected a CSV file, which may have any length"));
            }
            let own = if is_json { stacked::json(&source.name, &bytes, layout)? } else { of_numpy(&source.name, bytes, layout, scene)? };
            whole.arrays = Some(Rc::new(own));
        }
        let Some((kind, loads)) = whole.loads()? else { return Ok(vec![whole]) };
        if loads.len() < 2 && scene.loads.len() == 1 {
            return Ok(vec![whole]);
        }
        Ok(loads.into_iter().map(|load| Self { arrays: whole.arrays.clone(), load: Some((kind, load)), ..whole }).collect())
    }

    /// Opens the file at its beginning.
    pub(in crate::validate) fn reader(&self) -> Result<BufReader<Box<dyn Read>>, ValidationError> {
        let file = (self.source.open)().map_err(|error| unreadable(&self.source.name, None, &error))?;
        Ok(BufReader::with_capacity(1 << 16, file))
    }

    /// Returns the kinds of columns that give the load of a field.
    pub(in crate::validate) fn load_kinds(&self) -> &'static [Kind] {
        if self.arrays.is_some() { &[Kind::Depth, Kind::Force, Kind::ContactRadius] } else { &[Kind::Depth] }
    }

    /// Returns the loads of a file with fields, each with several consecutive rows; `None` for other files.
    fn loads(&self) -> Result<Option<(Kind, Vec<f64>)>, ValidationError> {
        let mut table = Table::open(self)?;
        let has = |kind: Kind| table.index(kind).is_some();
        let places = (has(Kind::Distance) || has(Kind::X)) && table.columns.iter().any(|own| own.kind.is_field());
        let found = self.load_kinds().iter().find_map(|kind| Some((*kind, table.index(*kind)?)));
        let (true, Some((kind, index))) = (places, found) else { return Ok(None) };
        let (mut loads, mut rows, mut row): (Vec<f64>, usize, _) = (Vec::new(), 0, Vec::new());
        while table.next(&mut row)?.is_some() {
            let load = row.get(index).copied().unwrap_or(f64::NAN);
            rows += 1;
            if loads.last() == Some(&load) {
                continue;
            }
            // A column of this name that changes from point to point is not a load.
            if loads.contains(&load) || rows < 2 * loads.len() {
                return Ok(None);
            }
            loads.push(load);
            if loads.len() > MOST_LOADS {
                let message = format!("the file contains fields under more than {MOST_LOADS} loads");
                return Err(ValidationError::data(&self.source.name, None, message, "expected a file with fewer loads"));
            }
        }
        Ok((!loads.is_empty() && rows >= 2 * loads.len()).then_some((kind, loads)))
    }
}

fn of_numpy(name: &str, bytes: Vec<u8>, layout: &Layout, scene: &Scene) -> Result<Columns, ValidationError> {
    let stem = std::path::Path::new(name).file_stem().and_then(|own| own.to_str()).unwrap_or("array");
    let arrays = arrays(name, stem, bytes)?;
    match arrays.as_slice() {
        [only] if stacked::is_reference(&only.shape) => stacked::npy(name, only, layout, scene),
        [only] if stacked::is_stack(&only.shape, layout, scene) => stacked::stack(name, only, layout, scene),
        _ => columns(name, arrays, layout),
    }
}
