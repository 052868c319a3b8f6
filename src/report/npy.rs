//! NumPy's formats: arrays in NPY, version 1.0, and archives of them in NPZ.

use std::io::{self, Write};

/// The head of an array: magic, length, and a Python literal that is padded to 64 bytes and ends with a line feed.
pub fn header(kind: &str, shape: &[usize]) -> Vec<u8> {
    const BEFORE: usize = 10;
    let shape: String = shape.iter().map(|own| format!("{own}, ")).collect();
    let mut text = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({shape}), }}");
    let rest = (BEFORE + text.len() + 1) % 64;
    text.push_str(&" ".repeat((64 - rest) % 64));
    text.push('\n');
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    // Few numbers of a shape stay far below 65536 bytes.
    bytes.extend((text.len() as u16).to_le_bytes());
    bytes.extend(text.as_bytes());
    bytes
}

/// An archive of named arrays: a ZIP file whose members are not compressed, as `numpy.savez` writes it.
#[derive(Default)]
pub(super) struct Archive {
    bytes: Vec<u8>,
    directory: Vec<u8>,
    members: u16,
}

/// The version of ZIP that plain members need.
const VERSION: u16 = 20;
/// 1 January 1980, the first date of ZIP: the same numbers give the same file.
const DATE: u32 = 0x0021_0000;

impl Archive {
    /// Adds an array of doubles.
    pub(super) fn numbers(&mut self, name: &str, shape: &[usize], values: &[f64]) -> io::Result<()> {
        let mut array = header("<f8", shape);
        array.extend(values.iter().flat_map(|value| value.to_le_bytes()));
        self.add(name, &array)
    }

    /// Adds an array of truth values.
    pub(super) fn flags(&mut self, name: &str, values: &[bool]) -> io::Result<()> {
        let mut array = header("|b1", &[values.len()]);
        array.extend(values.iter().map(|value| u8::from(*value)));
        self.add(name, &array)
    }

    /// Adds a text as an array without dimensions.
    pub(super) fn text(&mut self, name: &str, text: &str) -> io::Result<()> {
        let mut array = header(&format!("<U{}", text.chars().count().max(1)), &[]);
        let empty = if text.is_empty() { "\0" } else { "" };
        array.extend(text.chars().chain(empty.chars()).flat_map(|c| u32::from(c).to_le_bytes()));
        self.add(name, &array)
    }

    fn add(&mut self, name: &str, array: &[u8]) -> io::Result<()> {
        let name = format!("{name}.npy");
        let (offset, size) = (position(self.bytes.len())?, position(array.len())?);
        let mut entry = Vec::new();
        for number in [VERSION, 0, 0] {
            entry.extend(number.to_le_bytes());
        }
        for number in [DATE, checksum(array), size, size] {
            entry.extend(number.to_le_bytes());
        }
        entry.extend((name.len() as u16).to_le_bytes());
        entry.extend([0, 0]);
        self.bytes.extend(b"PK\x03\x04");
        self.bytes.extend(&entry);
        self.bytes.extend(name.as_bytes());
        self.bytes.extend(array);
        self.directory.extend(b"PK\x01\x02");
        self.directory.extend(VERSION.to_le_bytes());
        self.directory.extend(&entry);
        // No comment, the first disk, no attributes.
        self.directory.extend([0; 10]);
        self.directory.extend(offset.to_le_bytes());
        self.directory.extend(name.as_bytes());
        self.members += 1;
        Ok(())
    }

    /// Writes the archive.
    pub(super) fn write(self, out: &mut dyn Write) -> io::Result<()> {
        let (offset, size) = (position(self.bytes.len())?, position(self.directory.len())?);
        out.write_all(&self.bytes)?;
        out.write_all(&self.directory)?;
        out.write_all(b"PK\x05\x06\0\0\0\0")?;
        out.write_all(&[self.members.to_le_bytes(), self.members.to_le_bytes()].concat())?;
        out.write_all(&[size.to_le_bytes(), offset.to_le_bytes()].concat())?;
        out.write_all(&[0, 0])
    }
}

/// A place in the archive, which has at most 4 GiB.
fn position(bytes: usize) -> io::Result<u32> {
    let large = || io::Error::new(io::ErrorKind::InvalidData, "an NPZ file holds at most 4 GiB; CSV and JSON have no limit");
    u32::try_from(bytes).map_err(|_| large())
}

/// The cyclic redundancy check of ZIP: the reflected polynomial 0xEDB88320.
pub fn checksum(bytes: &[u8]) -> u32 {
    const TABLE: [u32; 256] = {
        let mut table = [0; 256];
        let mut index = 0;
        while index < 256 {
            let (mut value, mut bit) = (index as u32, 0);
            while bit < 8 {
                value = if value & 1 == 1 { (value >> 1) ^ 0xEDB8_8320 } else { value >> 1 };
                bit += 1;
            }
            table[index] = value;
            index += 1;
        }
        table
    };
    !bytes.iter().fold(u32::MAX, |sum, byte| {
        let index = (sum as u8 ^ byte) as usize;
        (sum >> 8) ^ TABLE.get(index).copied().unwrap_or_default()
    })
}
