//! Reads a data file row by row: text with column names in the first line and numbers below, which is not stored, or columns of arrays.

use crate::validate::ValidationError;
use crate::validate::file::column::{Column, Kind, Reading, is_bound, is_bound_of_field};
use crate::validate::file::data::Data;
use crate::validate::file::layout::{Averaging, Columns, Layout};
use std::io::{self, BufRead, BufReader, Read};
use std::rc::Rc;

/// A file that is being read.
pub(in crate::validate) struct Table<'s> {
    name: &'s str,
    pub(in crate::validate) columns: Vec<Column>,
    pub(in crate::validate) notes: Vec<String>,
    /// The names of the ignored columns.
    pub(in crate::validate) unread: Vec<String>,
    /// The names of all columns.
    pub(in crate::validate) names: Vec<String>,
    body: Body,
    skipped: Skipped,
    /// True if coordinates were generated from the box, centred on the axis.
    pub(in crate::validate) placed: bool,
    /// The index of the column of loads, and the load whose rows are read.
    only: Option<(usize, f64)>,
}

/// The source of the numbers.
enum Body {
    Text(Box<Text>),
    Arrays { columns: Rc<Columns>, next: usize },
}

/// Lines of numbers.
struct Text {
    reader: csv::Reader<BufReader<Box<dyn Read>>>,
    record: csv::ByteRecord,
    skipped: u64,
    decimal_commas: bool,
}

/// Maximum length of a line before the numbers.
const LONGEST: u64 = 1 << 16;
/// Characters that begin a comment.
const COMMENTS: [char; 2] = ['#', '%'];
const FINITE: &str = "expected a finite number such as 1.5e-6";
/// Formats that a line of Python converts: magic bytes, name, and code.
const FOREIGN: &[(&[u8], &str, &str)] = &[
    (b"\x89HDF\r\n\x1a\n", "an HDF5 file", HDF5),
    (b"CDF\x01", "a NetCDF file", NETCDF),
    (b"CDF\x02", "a NetCDF file", NETCDF),
    (b"CDF\x05", "a NetCDF file", NETCDF),
];
const HDF5: &str =
    "import h5py, numpy; f = h5py.File('data.h5'); numpy.savez('data.npz', **{k: f[k][()] for k in f if hasattr(f[k], 'shape')})";
const NETCDF: &str =
    "import netCDF4, numpy; f = netCDF4.Dataset('data.nc'); numpy.savez('data.npz', **{k: v[:] for k, v in f.variables.items()})";
const NAMES: &str = "expected a first line such as d_um,F_mN,a_um or r_um,p_GPa";

impl<'s> Table<'s> {
    /// Opens data at the first row.
    pub(in crate::validate) fn open(data: &'s Data<'_>) -> Result<Self, ValidationError> {
        let mut table = match &data.arrays {
            Some(columns) => Self::of_arrays(&data.source.name, columns, data.layout)?,
            None => Self::of_text(&data.source.name, data.reader()?, data.layout)?,
        };
        table.only = data.load.and_then(|(kind, load)| Some((table.index(kind)?, load)));
        Ok(table)
    }

    fn of_text(name: &'s str, mut file: BufReader<Box<dyn Read>>, layout: &Layout) -> Result<Self, ValidationError> {
        let begin = file.fill_buf().map_err(|error| unreadable(name, None, &error))?;
        if let Some((_, format, convert)) = FOREIGN.iter().find(|own| begin.starts_with(own.0)) {
            return Err(ValidationError::data(
                name,
                None,
                format!("{format} is not supported"),
                format!("convert the file with python -c \"{convert}\""),
            ));
        }
        let header = Header::read(name, &mut file, layout)?;
        let blanks = header.delimiter == b' ';
        let rows: Box<dyn Read> = if blanks { Box::new(Blanks { inner: file, pending: None, at_start: true }) } else { Box::new(file) };
        let reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .comment(Some(b'#'))
            .delimiter(header.delimiter)
            .trim(csv::Trim::None)
            .from_reader(BufReader::with_capacity(1 << 16, rows));
        let (columns, unread) = understood(name, Some(header.lines), &header.names, layout)?;
        let empty_is_infinite = header.names.iter().any(|own| is_bound_of_field(own));
        let mut notes: Vec<String> = unread.iter().map(|name| format!("column {name:?} is ignored")).collect();
        if header.commented {
            notes.push("the column names were read from a comment".to_owned());
        }
        let body = Body::Text(Box::new(Text {
            reader,
            record: csv::ByteRecord::new(),
            skipped: header.lines,
            decimal_commas: header.delimiter != b',',
        }));
        let skipped = Skipped { empty_is_infinite, ..Skipped::default() };
        Ok(Self { name, columns, notes, unread, names: header.names, body, skipped, placed: false, only: None })
    }

    fn of_arrays(name: &'s str, own: &Rc<Columns>, layout: &Layout) -> Result<Self, ValidationError> {
        let (columns, unread) = understood(name, None, &own.names, layout)?;
        let mut notes = own.notes.clone();
        notes.extend(unread.iter().map(|name| format!("array {name:?} is ignored")));
        let skipped = Skipped { empty_is_infinite: own.names.iter().any(|own| is_bound_of_field(own)), ..Skipped::default() };
        let body = Body::Arrays { columns: Rc::clone(own), next: 0 };
        Ok(Self { name, columns, notes, unread, names: own.names.clone(), body, skipped, placed: own.placed, only: None })
    }

    /// Returns the index of a kind of column among the recognized ones.
    pub(in crate::validate) fn index(&self, kind: Kind) -> Option<usize> {
        self.columns.iter().position(|own| own.kind == kind)
    }

    /// Reads the next row into one number per recognized column; `None` at the end.
    pub(in crate::validate) fn next(&mut self, out: &mut Vec<f64>) -> Result<Option<u64>, ValidationError> {
        let more = loop {
            let more = self.next_of_any_load(out)?;
            let is_wanted = |(index, load): (usize, f64)| out.get(index).is_some_and(|own| *own == load);
            if more.is_none() || self.only.is_none_or(is_wanted) {
                break more;
            }
        };
        for (value, column) in out.iter_mut().zip(&self.columns).filter(|own| own.1.is_area) {
            if *value < 0.0 {
                let message = format!("column {}: the area {value} is negative", column.name);
                return Err(ValidationError::data(self.name, more, message, "expected areas of at least 0"));
            }
            *value = (*value / std::f64::consts::PI).sqrt();
        }
        Ok(more)
    }

    fn next_of_any_load(&mut self, out: &mut Vec<f64>) -> Result<Option<u64>, ValidationError> {
        match &mut self.body {
            Body::Text(own) => own.next(self.name, &self.names, &self.columns, &mut self.skipped, out),
            Body::Arrays { columns, next } => {
                out.clear();
                let numbers = self.columns.iter().filter_map(|column| columns.values.get(column.index));
                out.extend(numbers.map_while(|own| own.get(*next).copied()));
                *next += 1;
                if let Some((value, column)) = out.iter().zip(&self.columns).find(|own| !own.0.is_finite()) {
                    let message = format!("row {next} of array {}: {value} is not finite", column.name);
                    return Err(ValidationError::data(self.name, None, message, FINITE));
                }
                Ok((!out.is_empty() && out.len() == self.columns.len()).then_some(*next as u64))
            }
        }
    }

    /// Describes the skipped rows.
    pub(in crate::validate) fn skipped(&self) -> Vec<String> {
        let Skipped { repeated, empty, .. } = self.skipped;
        let repeated = (repeated > 0).then(|| format!("the first line is repeated {repeated} times among the rows and was skipped there"));
        let empty = (empty > 0)
            .then(|| format!("{empty} rows with an empty field are skipped, as for an infinite pressure or beyond the end of the profile"));
        repeated.into_iter().chain(empty).collect()
    }
}

/// Rows that are skipped.
#[derive(Clone, Copy, Default)]
struct Skipped {
    /// Number of repetitions of the first line among the rows.
    repeated: u64,
    /// Number of rows with an empty field.
    empty: u64,
    /// True for a file with error bounds, as written by `reference`, in which values that are not finite are empty.
    empty_is_infinite: bool,
}

impl Text {
    fn next(
        &mut self,
        file: &str,
        names: &[String],
        columns: &[Column],
        skipped: &mut Skipped,
        out: &mut Vec<f64>,
    ) -> Result<Option<u64>, ValidationError> {
        loop {
            let more = self.reader.read_byte_record(&mut self.record);
            let line = self.skipped + self.record.position().map_or(0, csv::Position::line);
            match more {
                Ok(false) => return Ok(None),
                Ok(true) => {}
                Err(error) => {
                    return Err(ValidationError::data(file, Some(line), error.to_string(), "expected rows of numbers"));
                }
            }
            let first = self.record.get(0).unwrap_or_default().trim_ascii_start();
            if first.first().is_some_and(|own| COMMENTS.contains(&char::from(*own))) {
                continue;
            }
            if self.record.len() == 1 && first.is_empty() {
                continue;
            }
            if self.record.len() != names.len() {
                return Err(self.wrong_count(file, names.len(), line));
            }
            if self.is_header(names) {
                skipped.repeated += 1;
                continue;
            }
            let is_empty = |own: &Column| self.record.get(own.index).unwrap_or_default().trim_ascii().is_empty();
            if skipped.empty_is_infinite && columns.iter().any(|own| own.kind.is_field() && is_empty(own)) {
                skipped.empty += 1;
                continue;
            }
            out.clear();
            for column in columns {
                out.push(self.number(file, column, line)?);
            }
            return Ok(Some(line));
        }
    }

    fn is_header(&self, names: &[String]) -> bool {
        let first = self.record.get(0).unwrap_or_default();
        // A quick check first: numbers do not begin with these characters.
        first.first().is_some_and(u8::is_ascii_alphabetic)
            && self.record.iter().zip(names).all(|(field, name)| field.trim_ascii() == name.as_bytes())
    }

    fn number(&self, file: &str, column: &Column, line: u64) -> Result<f64, ValidationError> {
        let field = self.record.get(column.index).unwrap_or_default().trim_ascii();
        let text = std::str::from_utf8(field).unwrap_or("\u{fffd}");
        let parsed = match self.decimal_commas && field.contains(&b',') {
            true => text.replacen(',', ".", 1).parse::<f64>(),
            false => text.parse::<f64>(),
        };
        let shown: String = text.chars().take(40).collect();
        let fault = |message: String| Err(ValidationError::data(file, Some(line), message, FINITE));
        match parsed {
            Ok(value) if value.is_finite() => Ok(value),
            Ok(_) => fault(format!("column {}: {shown} is not finite", column.name)),
            Err(_) if field.is_empty() => fault(format!("column {} is empty", column.name)),
            Err(_) => fault(format!("column {}: {shown:?} is not a number", column.name)),
        }
    }

    fn wrong_count(&self, file: &str, wanted: usize, line: u64) -> ValidationError {
        let found = self.record.len();
        let message = format!("{found} fields, but the first line has {wanted} column names");
        let help = if !self.decimal_commas && found == 2 * wanted {
            "with decimal commas, separate the columns by another character, such as a semicolon"
        } else {
            "expected one number per column"
        };
        ValidationError::data(file, Some(line), message, help)
    }
}

/// The first line.
struct Header {
    names: Vec<String>,
    delimiter: u8,
    /// Number of lines up to and including the header.
    lines: u64,
    commented: bool,
}

impl Header {
    fn read(name: &str, file: &mut BufReader<Box<dyn Read>>, layout: &Layout) -> Result<Self, ValidationError> {
        let (mut lines, mut comment) = (0, None);
        loop {
            let mut bytes = Vec::new();
            let read = file.by_ref().take(LONGEST).read_until(b'\n', &mut bytes);
            if read.map_err(|error| unreadable(name, Some(lines + 1), &error))? == 0 {
                return Err(ValidationError::data(name, None, "the file contains neither a header nor rows", NAMES));
            }
            lines += 1;
            let text = String::from_utf8_lossy(&bytes);
            let text = text.trim_start_matches('\u{feff}').trim();
            if let Some(own) = text.strip_prefix(COMMENTS) {
                comment = Some(own.trim().to_owned());
                continue;
            }
            if text.is_empty() {
                continue;
            }
            if bytes.contains(&0) || text.contains('\u{fffd}') {
                return Err(ValidationError::data(name, Some(lines), "the file is not UTF-8 text", "expected a CSV file in UTF-8"));
            }
            let own = Self::split(text, lines, false);
            let numeric = own.names.iter().all(|field| field.replacen(',', ".", 1).parse::<f64>().is_ok());
            if !numeric {
                return Ok(own);
            }
            // The line is a row: put it back, and use the names in the last comment, or numbers if the user maps columns by number.
            let count = own.names.len();
            let named = comment
                .map(|own| Self::split(&own, 0, true).names)
                .filter(|names| names.len() == count && names.iter().any(|name| matches!(layout.read(name, 0), Reading::Known(_))));
            let commented = named.is_some();
            let numbered = || layout.by_number().then(|| (1..=count).map(|own| own.to_string()).collect());
            let Some(names) = named.or_else(numbered) else {
                let help = format!("{NAMES}, which may be a comment beginning with #, or map the columns by number, such as d=1 and F=2");
                let message = "the first line contains numbers instead of column names";
                return Err(ValidationError::data(name, Some(lines), message, help));
            };
            let rest = std::mem::replace(file, BufReader::new(Box::new(io::empty())));
            *file = BufReader::with_capacity(1 << 16, Box::new(io::Cursor::new(bytes).chain(rest)));
            return Ok(Self { names, delimiter: own.delimiter, lines: lines - 1, commented });
        }
    }

    fn split(text: &str, lines: u64, commented: bool) -> Self {
        let found = [b';', b'\t', b','].into_iter().find(|own| text.as_bytes().contains(own));
        if found.is_none() && text.contains(' ') {
            let names = blank_separated(text);
            return Self { names, delimiter: b' ', lines, commented };
        }
        let delimiter = found.unwrap_or(b',');
        let mut reader = csv::ReaderBuilder::new().has_headers(false).delimiter(delimiter).from_reader(text.as_bytes());
        let mut record = csv::StringRecord::new();
        let read = reader.read_record(&mut record).unwrap_or(false);
        let names = if read { record.iter().map(|own| own.trim().to_owned()).collect() } else { Vec::new() };
        Self { names, delimiter, lines, commented }
    }
}

/// Splits a line at blanks; a unit in brackets belongs to the preceding word, as in `d (um)`.
fn blank_separated(text: &str) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match names.last_mut().filter(|_| word.starts_with(['(', '['])) {
            Some(last) => *last = format!("{last} {word}"),
            None => names.push(word.to_owned()),
        }
    }
    names
}

/// A reader that replaces every run of blanks by a single blank and removes blanks at the ends of lines.
struct Blanks<R> {
    inner: R,
    /// A byte that was read after a blank that was already returned.
    pending: Option<u8>,
    at_start: bool,
}

impl<R: BufRead> Read for Blanks<R> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        let mut count = 0;
        for place in out.iter_mut() {
            if let Some(own) = self.pending.take() {
                (*place, count) = (own, count + 1);
                continue;
            }
            let (mut blank, mut next) = (false, None);
            while next.is_none() {
                let bytes = self.inner.fill_buf()?;
                if bytes.is_empty() {
                    break;
                }
                let blanks = bytes.iter().take_while(|own| matches!(own, b' ' | b'\t')).count();
                blank |= blanks > 0;
                next = bytes.get(blanks).copied();
                self.inner.consume(blanks + usize::from(next.is_some()));
            }
            let Some(own) = next else { break };
            let ends = matches!(own, b'\n' | b'\r');
            if blank && !ends && !self.at_start {
                self.pending = Some(own);
                *place = b' ';
            } else {
                *place = own;
            }
            self.at_start = ends;
            count += 1;
        }
        Ok(count)
    }
}

/// Returns the recognized columns, and the names of the others.
fn understood(file: &str, line: Option<u64>, names: &[String], layout: &Layout) -> Result<(Vec<Column>, Vec<String>), ValidationError> {
    let fault = |message: String, help: &str| ValidationError::data(file, line, message, help);
    let (mut columns, mut unread): (Vec<Column>, Vec<String>) = (Vec::new(), Vec::new());
    for (index, name) in names.iter().enumerate() {
        match layout.read(name, index) {
            Reading::Known(column) => match columns.iter_mut().find(|own| own.kind == column.kind) {
                // A contact radius is preferred to an area.
                Some(other) if other.is_area != column.is_area => {
                    let less = if column.is_area { column } else { std::mem::replace(other, column) };
                    unread.push(less.name);
                }
                Some(other) => {
                    return Err(fault(
                        format!("the columns {} and {name} contain the same quantity", other.name),
                        "expected each quantity only once; map the quantity to the column to be used",
                    ));
                }
                None => columns.push(column),
            },
            Reading::BadUnit(why) => {
                return Err(fault(format!("column {name}: {why}"), "expected a name such as d_um, F_mN or p_GPa"));
            }
            Reading::Unknown if is_bound(name) || Averaging::named(name).is_some() => {}
            Reading::Unknown => unread.push(name.clone()),
        }
    }
    Ok((columns, unread))
}

pub(in crate::validate) fn unreadable(name: &str, line: Option<u64>, error: &io::Error) -> ValidationError {
    ValidationError::data(name, line, format!("cannot read the file: {error}"), "expected a CSV file")
}
