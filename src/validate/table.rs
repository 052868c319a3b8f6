//! A data file row by row: names in the first line, numbers below, nothing kept.

use super::ValidationError;
use super::column::{Column, Kind, Reading, read};
use std::io::{self, BufRead, BufReader, Read};

/// A file of data that can be opened more than once.
pub struct Source<'a> {
    /// Its name, for errors and answers.
    pub name: String,
    /// Opens it at its beginning.
    pub open: Box<dyn Fn() -> io::Result<Box<dyn Read>> + 'a>,
}

/// A file being read.
pub(super) struct Table<'s> {
    name: &'s str,
    pub(super) columns: Vec<Column>,
    pub(super) notes: Vec<String>,
    /// Names of the columns that are not read.
    pub(super) unread: Vec<String>,
    names: Vec<String>,
    reader: csv::Reader<BufReader<Box<dyn Read>>>,
    record: csv::ByteRecord,
    skipped: u64,
    decimal_commas: bool,
    repeated: u64,
}

/// The longest line before the numbers.
const LONGEST: u64 = 1 << 16;
const NAMES: &str = "a first line such as d_um,F_mN,a_um or r_um,p_GPa would be accepted";

impl<'s> Table<'s> {
    /// Opens a file and reads its header.
    pub(super) fn open(source: &'s Source<'_>) -> Result<Self, ValidationError> {
        let name = source.name.as_str();
        let file = (source.open)().map_err(|error| unreadable(name, None, &error))?;
        let mut file = BufReader::with_capacity(1 << 16, file);
        let header = Header::read(name, &mut file)?;
        let reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .comment(Some(b'#'))
            .delimiter(header.delimiter)
            .trim(csv::Trim::None)
            .from_reader(file);
        let (columns, unread) = understood(name, &header)?;
        let mut notes: Vec<String> = unread.iter().map(|name| format!("column {name:?} is not read")).collect();
        if header.commented {
            notes.push("the names of the columns stand in a comment".to_owned());
        }
        Ok(Self {
            name,
            columns,
            notes,
            unread,
            names: header.names,
            reader,
            record: csv::ByteRecord::new(),
            skipped: header.lines,
            decimal_commas: header.delimiter != b',',
            repeated: 0,
        })
    }

    /// The place of a kind of column among those that are understood.
    pub(super) fn index(&self, kind: Kind) -> Option<usize> {
        self.columns.iter().position(|own| own.kind == kind)
    }

    /// Reads the next row into one number per understood column; `None` at the end.
    pub(super) fn next(&mut self, out: &mut Vec<f64>) -> Result<Option<u64>, ValidationError> {
        loop {
            let more = self.reader.read_byte_record(&mut self.record);
            let line = self.skipped + self.record.position().map_or(0, csv::Position::line);
            match more {
                Ok(false) => return Ok(None),
                Ok(true) => {}
                Err(error) => {
                    return Err(ValidationError::data(self.name, Some(line), error.to_string(), "rows of numbers would be accepted"));
                }
            }
            if self.record.len() == 1 && self.record.iter().all(|field| field.trim_ascii().is_empty()) {
                continue;
            }
            if self.record.len() != self.names.len() {
                return Err(self.wrong_count(line));
            }
            if self.is_header() {
                self.repeated += 1;
                continue;
            }
            out.clear();
            for index in 0..self.columns.len() {
                let value = self.number(index, line)?;
                out.push(value);
            }
            return Ok(Some(line));
        }
    }

    /// How often the first line stood again among the rows.
    pub(super) fn repeated(&self) -> u64 {
        self.repeated
    }

    fn is_header(&self) -> bool {
        let first = self.record.get(0).unwrap_or_default();
        // A cheap look first: numbers begin with none of these.
        first.first().is_some_and(u8::is_ascii_alphabetic)
            && self.record.iter().zip(&self.names).all(|(field, name)| field.trim_ascii() == name.as_bytes())
    }

    fn number(&self, index: usize, line: u64) -> Result<f64, ValidationError> {
        let Some(column) = self.columns.get(index) else { return Ok(f64::NAN) };
        let field = self.record.get(column.index).unwrap_or_default().trim_ascii();
        let text = std::str::from_utf8(field).unwrap_or("\u{fffd}");
        let parsed = match self.decimal_commas && field.contains(&b',') {
            true => text.replacen(',', ".", 1).parse::<f64>(),
            false => text.parse::<f64>(),
        };
        let shown: String = text.chars().take(40).collect();
        let help = "a finite number such as 1.5e-6 would be accepted";
        match parsed {
            Ok(value) if value.is_finite() => Ok(value),
            Ok(_) => Err(ValidationError::data(self.name, Some(line), format!("column {}: {shown} is not finite", column.name), help)),
            Err(_) if field.is_empty() => {
                Err(ValidationError::data(self.name, Some(line), format!("column {} is empty", column.name), help))
            }
            Err(_) => Err(ValidationError::data(self.name, Some(line), format!("column {}: {shown:?} is no number", column.name), help)),
        }
    }

    fn wrong_count(&self, line: u64) -> ValidationError {
        let (found, wanted) = (self.record.len(), self.names.len());
        let message = format!("{found} fields where the first line names {wanted} columns");
        let help = if !self.decimal_commas && found == 2 * wanted {
            "decimal commas need another separator between the columns, such as a semicolon"
        } else {
            "one number per column would be accepted"
        };
        ValidationError::data(self.name, Some(line), message, help)
    }
}

/// The first line.
struct Header {
    names: Vec<String>,
    delimiter: u8,
    /// Lines up to and with it.
    lines: u64,
    commented: bool,
}

impl Header {
    fn read(name: &str, file: &mut BufReader<Box<dyn Read>>) -> Result<Self, ValidationError> {
        let (mut lines, mut comment) = (0, None);
        loop {
            let mut bytes = Vec::new();
            let read = file.by_ref().take(LONGEST).read_until(b'\n', &mut bytes);
            if read.map_err(|error| unreadable(name, Some(lines + 1), &error))? == 0 {
                return Err(ValidationError::data(name, None, "the file has no header and no rows", NAMES));
            }
            lines += 1;
            let text = String::from_utf8_lossy(&bytes);
            let text = text.trim_start_matches('\u{feff}').trim();
            if let Some(own) = text.strip_prefix('#') {
                comment = Some(own.trim().to_owned());
                continue;
            }
            if text.is_empty() {
                continue;
            }
            if bytes.contains(&0) || text.contains('\u{fffd}') {
                return Err(ValidationError::data(name, Some(lines), "this is no text in UTF-8", "a CSV file in UTF-8 would be accepted"));
            }
            let own = Self::split(text, lines, false);
            let numeric = own.names.iter().all(|field| field.replacen(',', ".", 1).parse::<f64>().is_ok());
            if !numeric {
                return Ok(own);
            }
            let help = format!("{NAMES}, also as a comment that begins with #");
            return Err(ValidationError::data(name, Some(lines), "the first line has numbers where the names of the columns belong", help))
                .or_else(|error| Self::commented(comment.as_deref(), lines, own.names.len(), file, &bytes).ok_or(error));
        }
    }

    /// A header in the last comment before the rows; the row that was read already is put back.
    fn commented(comment: Option<&str>, lines: u64, count: usize, file: &mut BufReader<Box<dyn Read>>, row: &[u8]) -> Option<Self> {
        let own = Self::split(comment?, lines - 1, true);
        let known = own.names.iter().any(|name| matches!(read(name, 0), Reading::Known(_)));
        if !known || own.names.len() != count {
            return None;
        }
        let rest = std::mem::replace(file, BufReader::new(Box::new(io::empty())));
        let again = io::Cursor::new(row.to_vec()).chain(rest);
        *file = BufReader::with_capacity(1 << 16, Box::new(again));
        Some(own)
    }

    fn split(text: &str, lines: u64, commented: bool) -> Self {
        let delimiter = [b';', b'\t', b','].into_iter().find(|own| text.as_bytes().contains(own)).unwrap_or(b',');
        let mut reader = csv::ReaderBuilder::new().has_headers(false).delimiter(delimiter).from_reader(text.as_bytes());
        let mut record = csv::StringRecord::new();
        let read = reader.read_record(&mut record).unwrap_or(false);
        let names = if read { record.iter().map(|own| own.trim().to_owned()).collect() } else { Vec::new() };
        Self { names, delimiter, lines, commented }
    }
}

/// The columns that are understood, and the names of the others.
fn understood(file: &str, header: &Header) -> Result<(Vec<Column>, Vec<String>), ValidationError> {
    let fault = |message: String, help: &str| ValidationError::data(file, Some(header.lines), message, help);
    let (mut columns, mut unread): (Vec<Column>, Vec<String>) = (Vec::new(), Vec::new());
    for (index, name) in header.names.iter().enumerate() {
        match read(name, index) {
            Reading::Known(column) => {
                if let Some(other) = columns.iter().find(|own| own.kind == column.kind) {
                    return Err(fault(
                        format!("the columns {} and {name} are the same quantity", other.name),
                        "each quantity once would be accepted",
                    ));
                }
                columns.push(column);
            }
            Reading::BadUnit(why) => {
                return Err(fault(format!("column {name}: {why}"), "a name such as d_um, F_mN or p_GPa would be accepted"));
            }
            Reading::Unknown => unread.push(name.clone()),
        }
    }
    Ok((columns, unread))
}

fn unreadable(name: &str, line: Option<u64>, error: &io::Error) -> ValidationError {
    ValidationError::data(name, line, format!("cannot be read: {error}"), "a CSV file would be accepted")
}
