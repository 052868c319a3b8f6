//! NumPy's formats: arrays in NPY, version 1.0, and archives of arrays in NPZ.

use rawzip::ZipArchiveWriter;
use rawzip::time::UtcDateTime;
use std::io::{self, Write};

/// The header of an array: magic bytes, length, and a Python literal that is padded to 64 bytes and ends with a line feed.
pub fn header(kind: &str, shape: &[usize]) -> Vec<u8> {
    const BEFORE: usize = 10;
    let shape: String = shape.iter().map(|own| format!("{own}, ")).collect();
    let mut text = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({shape}), }}");
    let rest = (BEFORE + text.len() + 1) % 64;
    text.push_str(&" ".repeat((64 - rest) % 64));
    text.push('\n');
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    // With few dimensions, the header is much shorter than 65536 bytes.
    bytes.extend((text.len() as u16).to_le_bytes());
    bytes.extend(text.as_bytes());
    bytes
}

/// An archive of named arrays: a ZIP file whose members are not compressed, as `numpy.savez` writes it.
pub(super) struct Archive(ZipArchiveWriter<Vec<u8>>);

/// 1 January 1980, the earliest date in ZIP, so that equal arrays give equal files.
const FIRST_DATE: i64 = 315_532_800;

impl Archive {
    /// Creates an empty archive.
    pub(super) fn new() -> Self {
        Self(ZipArchiveWriter::new(Vec::new()))
    }

    /// Adds an array of doubles.
    pub(super) fn numbers(&mut self, name: &str, shape: &[usize], values: &[f64]) -> io::Result<()> {
        let mut array = header("<f8", shape);
        array.extend(values.iter().flat_map(|value| value.to_le_bytes()));
        self.add(name, &array)
    }

    /// Adds an array of booleans.
    pub(super) fn flags(&mut self, name: &str, shape: &[usize], values: &[bool]) -> io::Result<()> {
        let mut array = header("|b1", shape);
        array.extend(values.iter().map(|value| u8::from(*value)));
        self.add(name, &array)
    }

    /// Adds a text as a zero-dimensional array.
    pub(super) fn text(&mut self, name: &str, text: &str) -> io::Result<()> {
        let mut array = header(&format!("<U{}", text.chars().count().max(1)), &[]);
        let empty = if text.is_empty() { "\0" } else { "" };
        array.extend(text.chars().chain(empty.chars()).flat_map(|c| u32::from(c).to_le_bytes()));
        self.add(name, &array)
    }

    fn add(&mut self, name: &str, array: &[u8]) -> io::Result<()> {
        let name = format!("{name}.npy");
        let (mut member, head) =
            self.0.new_file(&name).last_modified(UtcDateTime::from_unix(FIRST_DATE)).start().map_err(io::Error::other)?;
        let mut content = head.wrap(&mut member);
        content.write_all(array)?;
        let (_, end) = content.finish().map_err(io::Error::other)?;
        member.finish(end).map_err(io::Error::other)?;
        Ok(())
    }

    /// Writes the archive.
    pub(super) fn write(self, out: &mut dyn Write) -> io::Result<()> {
        out.write_all(&self.0.finish().map_err(io::Error::other)?)
    }
}
