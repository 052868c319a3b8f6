//! Answers on stdout: buffered, and quiet when the reader has gone.

use super::Failure;
use std::io::{self, BufWriter, Write};

/// Writes the answer; a closed pipe means that the reader has enough.
pub(super) fn print(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
    let mut out = BufWriter::new(io::stdout().lock());
    match write(&mut out).and_then(|()| out.flush()) {
        Ok(()) => Ok(()),
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        Err(error) => Err(Failure::new(format!("the answer cannot be written: {error}"))),
    }
}
