//! NumPy files: the named arrays of an NPY or NPZ file as doubles.

use crate::validate::ValidationError;
use flate2::read::DeflateDecoder;
use rawzip::{CompressionMethod, ZipArchive};
use std::fmt::Display;
use std::io::Read;

/// One array; the first index changes slowest.
#[derive(Clone, Debug, PartialEq)]
pub struct Array {
    /// The name of the array, or of the field of a structured array.
    pub name: String,
    /// The length along every index.
    pub shape: Vec<usize>,
    /// The numbers; empty for a text.
    pub values: Vec<f64>,
    /// The text, if the array is one.
    pub text: Option<String>,
}

/// Magic bytes of an NPY file.
pub(in crate::validate) const NPY: &[u8] = b"\x93NUMPY";
/// Magic bytes of an NPZ file, which is a ZIP archive.
pub(in crate::validate) const NPZ: &[u8] = b"PK\x03\x04";
/// Maximum total size of all arrays, in bytes.
const LONGEST: u64 = 1_000_000_000;
/// Maximum number of members of an archive.
const MOST_MEMBERS: usize = 1000;
pub(in crate::validate) const NUMPY: &str = "expected arrays of real numbers as written by numpy.save or numpy.savez";

/// Reads every array in the bytes of a file; `name` is the name of the file in errors, and `stem` the name of the array in an NPY file.
pub(in crate::validate) fn arrays(name: &str, stem: &str, bytes: Vec<u8>) -> Result<Vec<Array>, ValidationError> {
    let fault = |message: String| ValidationError::data(name, None, message, NUMPY);
    if bytes.starts_with(NPY) {
        return Ok(array(stem, &bytes).map_err(fault)?.into_iter().collect());
    }
    let archive = ZipArchive::from_slice(&bytes).map_err(|error| fault(format!("this is not an NPZ file: {error}")))?;
    let (mut list, mut total) = (Vec::new(), 0);
    for (index, member) in archive.entries().enumerate() {
        let part = |error: rawzip::Error| fault(format!("member {}: {error}", index + 1));
        if index == MOST_MEMBERS {
            return Err(fault(format!("the archive has more than {MOST_MEMBERS} members")));
        }
        let member = member.map_err(part)?;
        let name = String::from_utf8_lossy(member.file_path().as_bytes()).into_owned();
        let Some(own) = name.strip_suffix(".npy") else { continue };
        let whole = |error: &dyn Display| fault(format!("array {own}: {error}"));
        let packed = archive.get_entry(member.wayfinder()).map_err(part)?;
        let content = match member.compression_method() {
            CompressionMethod::STORE => content(packed.verifying_reader(packed.data()), LONGEST - total),
            CompressionMethod::DEFLATE => content(packed.verifying_reader(DeflateDecoder::new(packed.data())), LONGEST - total),
            other => {
                let name = other.name().unwrap_or("unknown");
                return Err(whole(&format_args!("unsupported compression method {name}; expected stored or deflated members")));
            }
        };
        let content = content.map_err(|error| whole(&error))?;
        total += content.len() as u64;
        if total > LONGEST {
            return Err(fault(format!("the arrays are longer than {LONGEST} bytes")));
        }
        list.extend(array(own, &content).map_err(|why| whole(&why))?);
    }
    Ok(list)
}

/// Reads a member to its end, which verifies its length and checksum, or one byte more than `most`.
fn content(member: impl Read, most: u64) -> std::io::Result<Vec<u8>> {
    let mut content = Vec::new();
    member.take(most + 1).read_to_end(&mut content)?;
    Ok(content)
}

/// The binary format of a number.
#[derive(Clone, Copy)]
struct Kind {
    letter: u8,
    size: usize,
    big: bool,
}

impl Kind {
    fn read(text: &str) -> Result<Self, String> {
        let fault = || format!("elements of the type {text:?} are not real numbers");
        let (order, rest) = text.split_at_checked(1).ok_or_else(fault)?;
        let (letter, size) = rest.split_at_checked(1).ok_or_else(fault)?;
        let size: usize = size.parse().map_err(|_| fault())?;
        let letter = *letter.as_bytes().first().ok_or_else(fault)?;
        let known = match letter {
            b'f' => matches!(size, 4 | 8),
            b'i' | b'u' => matches!(size, 1 | 2 | 4 | 8),
            b'b' => size == 1,
            b'U' => (1..=10_000).contains(&size),
            _ => false,
        };
        if !known || !matches!(order, "<" | ">" | "|" | "=") {
            return Err(fault());
        }
        Ok(Self { letter, size: if letter == b'U' { 4 * size } else { size }, big: order == ">" })
    }

    fn number(self, bytes: &[u8]) -> f64 {
        let mut own = [0_u8; 8];
        // Little-endian with sign extension.
        for (index, place) in own.iter_mut().enumerate().take(self.size) {
            *place = bytes.get(if self.big { self.size - 1 - index } else { index }).copied().unwrap_or(0);
        }
        let whole = u64::from_le_bytes(own);
        match (self.letter, self.size) {
            (b'f', 8) => f64::from_le_bytes(own),
            (b'f', _) => f64::from(f32::from_bits(whole as u32)),
            (b'i', 8) => whole as i64 as f64,
            (b'i', size) => {
                let unused = 64 - 8 * size as u32;
                ((whole << unused) as i64 >> unused) as f64
            }
            _ => whole as f64,
        }
    }

    fn text(self, bytes: &[u8]) -> String {
        let letters = bytes.chunks(4).filter_map(|own| {
            let own: [u8; 4] = own.try_into().ok()?;
            let code = if self.big { u32::from_be_bytes(own) } else { u32::from_le_bytes(own) };
            char::from_u32(code).filter(|c| *c != '\0')
        });
        letters.collect()
    }
}

/// The header of an array.
struct Head {
    /// Names and types: one unnamed type, or the fields of a structured array.
    fields: Vec<(String, Kind)>,
    fortran: bool,
    shape: Vec<usize>,
    /// The offset of the numbers.
    start: usize,
}

/// Reads the arrays of one NPY file: a single array, or one per field.
pub fn array(name: &str, bytes: &[u8]) -> Result<Vec<Array>, String> {
    let head = head(bytes)?;
    let count = head.shape.iter().try_fold(1_usize, |all, own| all.checked_mul(*own)).ok_or("the shape is too large")?;
    let width: usize = head.fields.iter().map(|own| own.1.size).sum();
    let data = bytes.get(head.start..).unwrap_or_default();
    if count.checked_mul(width).is_none_or(|most| data.len() < most) {
        return Err("the file is truncated: some numbers are missing".to_owned());
    }
    let mut list = Vec::new();
    let mut begin = 0;
    for (own, kind) in &head.fields {
        let offset = begin;
        begin += kind.size;
        let each = (0..count).map(|index| data.get(index * width + offset..index * width + offset + kind.size).unwrap_or_default());
        let name = if own.is_empty() { name.to_owned() } else { own.clone() };
        let (mut values, mut text) = (Vec::new(), None);
        if kind.letter == b'U' {
            text = each.map(|bytes| kind.text(bytes)).next();
        } else {
            values = each.map(|bytes| kind.number(bytes)).collect();
        }
        if head.fortran {
            values = turned(&values, &head.shape);
        }
        list.push(Array { name, shape: head.shape.clone(), values, text });
    }
    Ok(list)
}

/// Reorders numbers whose first index changes fastest.
fn turned(values: &[f64], shape: &[usize]) -> Vec<f64> {
    let count = values.len();
    let place = |mut index: usize| {
        let (mut at, mut step) = (0, count);
        // Start with the last index, which changes fastest in the result and slowest in the file.
        for own in shape.iter().rev().filter(|own| **own > 0) {
            step /= own;
            at += (index % own) * step;
            index /= own;
        }
        at
    };
    (0..count).filter_map(|index| values.get(place(index)).copied()).collect()
}

fn head(bytes: &[u8]) -> Result<Head, String> {
    let short = || "the file is truncated: the header is incomplete".to_owned();
    let major = *bytes.get(6).ok_or_else(short)?;
    let (size, start): (usize, usize) = if major == 1 { (2, 10) } else { (4, 12) };
    let length = bytes.get(8..8 + size).ok_or_else(short)?.iter().rev().fold(0_usize, |all, own| (all << 8) | usize::from(*own));
    let text = bytes.get(start..start.saturating_add(length)).ok_or_else(short)?;
    let text = std::str::from_utf8(text).map_err(|_| "the header is not text".to_owned())?;
    let value = |key: &str| text.split_once(&format!("'{key}':")).map(|own| own.1.trim_start());
    let bad = || "the header of the array is invalid".to_owned();
    let kind = value("descr").ok_or_else(bad)?;
    let quoted = |text: &str| -> Vec<String> { text.split('\'').skip(1).step_by(2).map(str::to_owned).collect() };
    let fields = if kind.starts_with('[') {
        let list = kind.split_once(']').ok_or_else(bad)?.0;
        if list.contains("))") || list.matches('[').count() > 1 {
            return Err("fields that contain arrays or records are not supported".to_owned());
        }
        let words = quoted(list);
        let pairs = words.chunks(2).map(|own| match own {
            [name, kind] => Ok((name.clone(), Kind::read(kind)?)),
            _ => Err(bad()),
        });
        pairs.collect::<Result<Vec<_>, String>>()?
    } else {
        vec![(String::new(), Kind::read(quoted(kind).first().ok_or_else(bad)?)?)]
    };
    let shape = value("shape").and_then(|own| own.strip_prefix('(')?.split_once(')')).ok_or_else(bad)?.0;
    let shape = shape.split(',').map(str::trim).filter(|own| !own.is_empty()).map(|own| own.parse::<usize>().map_err(|_| bad()));
    Ok(Head {
        fields,
        fortran: value("fortran_order").is_some_and(|own| own.starts_with("True")),
        shape: shape.collect::<Result<_, _>>()?,
        start: start + length,
    })
}
