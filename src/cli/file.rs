//! Answers in files: whole or not at all.

use super::Failure;
use crate::num::work;
use std::fs;
use std::io::{self, BufWriter, Read, Seek, Write};
use std::path::{Path, PathBuf};

/// A file that will be written at the end; whatever fails before leaves it untouched.
pub(super) struct Target {
    path: PathBuf,
}

impl Target {
    /// Any file whose directory exists.
    pub(super) fn new(path: &Path) -> Result<Self, Failure> {
        let own = Self { path: path.to_owned() };
        if !own.directory().is_dir() {
            let message = format!("-o {}: there is no directory {}", path.display(), own.directory().display());
            return Err(Failure::new(message).help("a file in a directory that exists would be accepted"));
        }
        if path.is_dir() {
            return Err(Failure::new(format!("-o {} is a directory", path.display())).help("the name of a file would be accepted"));
        }
        Ok(own)
    }

    fn directory(&self) -> &Path {
        match self.path.parent() {
            Some(directory) if !directory.as_os_str().is_empty() => directory,
            _ => Path::new("."),
        }
    }

    /// Writes beside the file and puts the whole in its place at once, so that a reader never sees a part of it.
    ///
    /// What was written is gone where it ends early, be it by an error or by a signal.
    pub(super) fn fill(&self, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
        let done = self.replace(write);
        // An exhausted budget takes precedence over the error that it caused.
        work::check()?;
        done.map_err(|error| Failure::new(format!("-o {} cannot be written: {error}", self.path.display())))
    }

    fn replace(&self, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
        let known = fs::metadata(&self.path).ok();
        if known.as_ref().is_some_and(|own| !own.is_file()) {
            // A pipe or a device cannot be put in its place as a whole.
            let mut out = fs::OpenOptions::new().write(true).open(&self.path)?;
            return io::copy(&mut spooled(write)?, &mut out).map(drop);
        }
        if known.as_ref().is_some_and(|own| own.permissions().readonly()) {
            return Err(io::Error::new(io::ErrorKind::PermissionDenied, "it is read-only"));
        }
        // What a link points at is replaced, not the link.
        let place = if known.is_some() { fs::canonicalize(&self.path)? } else { self.path.clone() };
        let directory = place.parent().filter(|own| !own.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let beside = unfinished::create(|| builder().prefix(".sneddon-").tempfile_in(directory))?;
        if let Some(own) = known {
            beside.as_file().set_permissions(own.permissions())?;
        }
        let done = (|| {
            let mut out = BufWriter::new(beside.as_file());
            write(&mut out)?;
            out.flush()?;
            whole()
        })();
        unfinished::end(|| match done {
            // What a crash of the machine leaves is the old file or the new one, never an empty one.
            Ok(()) => beside.as_file().sync_all().and_then(|()| beside.persist(&place).map(drop).map_err(|error| error.error)),
            Err(error) => Err(error),
        })
    }
}

/// Buffers the whole answer, so that a pipe or a device receives all of it or nothing.
///
/// # Errors
/// As the writer, and where the budget of work was used up before the end.
pub(super) fn spooled(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<impl Read> {
    let mut kept = BufWriter::new(tempfile::spooled_tempfile(IN_MEMORY));
    write(&mut kept)?;
    let mut kept = kept.into_inner().map_err(io::IntoInnerError::into_error)?;
    kept.rewind()?;
    whole()?;
    Ok(kept)
}

/// Answers longer than this many bytes are buffered in a temporary file.
const IN_MEMORY: usize = 1 << 24;

/// Returns an error if the budget of work is exhausted, since the answer is then incomplete.
fn whole() -> io::Result<()> {
    work::check().map_err(io::Error::other)
}

pub(super) use unfinished::{answer_interrupts, remove as remove_unfinished};

/// The file that is being written: Ctrl-C takes it away.
mod unfinished {
    use std::fs;
    use std::io;
    use std::path::PathBuf;
    use std::process;
    use std::sync::{Mutex, MutexGuard, PoisonError};
    use tempfile::NamedTempFile;

    static FILE: Mutex<Option<PathBuf>> = Mutex::new(None);

    fn file() -> MutexGuard<'static, Option<PathBuf>> {
        FILE.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Ends the program at once when a signal asks for it, and takes the file that is being written away.
    ///
    /// The exit code is 128 and the number of the signal, as shells count: 130 after Ctrl-C, 143 after a plain `kill`.
    /// This runs before any other thread begins, so that every thread leaves the signals to the one that waits for them.
    #[cfg(unix)]
    pub(in crate::cli) fn answer_interrupts() {
        use nix::sys::signal::{SigSet, Signal};
        let mut signals = SigSet::empty();
        [Signal::SIGINT, Signal::SIGTERM, Signal::SIGHUP].into_iter().for_each(|own| signals.add(own));
        // Where nothing waits for them, signals end the program as well, but leave the file behind.
        if signals.thread_block().is_err() {
            return;
        }
        let wait = move || {
            if let Ok(signal) = signals.wait() {
                remove();
                process::exit(128 + signal as i32);
            }
        };
        if std::thread::Builder::new().name("signals".to_owned()).spawn(wait).is_err() {
            let _ = signals.thread_unblock();
        }
    }

    /// Ends the program at once when Ctrl-C asks for it, and takes the file that is being written away.
    #[cfg(not(unix))]
    pub(in crate::cli) fn answer_interrupts() {
        const INTERRUPTED: i32 = 130;
        // Without a handler Ctrl-C ends the program as well, but leaves the file behind.
        let _ = ctrlc::set_handler(|| {
            remove();
            process::exit(INTERRUPTED);
        });
    }

    /// Takes the file away; the lock stays so that no other one is begun.
    pub(in crate::cli) fn remove() {
        let own = file();
        if let Some(path) = own.as_ref() {
            let _ = fs::remove_file(path);
        }
        std::mem::forget(own);
    }

    /// Makes the file. While the lock is held the signal waits, so that no file is unknown to it.
    pub(super) fn create(make: impl FnOnce() -> io::Result<NamedTempFile>) -> io::Result<NamedTempFile> {
        let mut own = file();
        let made = make()?;
        *own = Some(made.path().to_owned());
        Ok(made)
    }

    /// Puts the file in its place, or drops it.
    pub(super) fn end<T>(finish: impl FnOnce() -> T) -> T {
        let mut own = file();
        let done = finish();
        *own = None;
        done
    }
}

/// A new file has the usual rights, not those of a secret.
fn builder() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    builder
}
