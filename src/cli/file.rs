//! Output files, which are either written completely or left untouched.

use super::Failure;
use crate::num::work;
use std::fs;
use std::io::{self, BufWriter, Read, Seek, Write};
use std::path::{Path, PathBuf};

/// A file that is written at the end of a command; an earlier error leaves it untouched.
pub(super) struct Target {
    path: PathBuf,
}

impl Target {
    /// Creates a target; its directory must exist.
    pub(super) fn new(path: &Path) -> Result<Self, Failure> {
        let own = Self { path: path.to_owned() };
        if !own.directory().is_dir() {
            let message = format!("-o {}: the directory {} does not exist", path.display(), own.directory().display());
            return Err(Failure::new(message).help("expected a file in an existing directory"));
        }
        if path.is_dir() {
            return Err(Failure::new(format!("-o {} is a directory", path.display())).help("expected the name of a file"));
        }
        Ok(own)
    }

    fn directory(&self) -> &Path {
        match self.path.parent() {
            Some(directory) if !directory.as_os_str().is_empty() => directory,
            _ => Path::new("."),
        }
    }

    /// Writes to a temporary file next to the target and renames it, so that readers never see a partial file.
    ///
    /// The temporary file is removed if an error or a signal ends the program early.
    pub(super) fn fill(&self, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
        let done = self.replace(write);
        // An exhausted budget takes precedence over the error that it caused.
        work::check()?;
        done.map_err(|error| Failure::new(format!("cannot write to -o {}: {error}", self.path.display())))
    }

    fn replace(&self, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
        let known = fs::metadata(&self.path).ok();
        if known.as_ref().is_some_and(|own| !own.is_file()) {
            // A pipe or a device cannot be replaced by renaming.
            let mut out = fs::OpenOptions::new().write(true).open(&self.path)?;
            return io::copy(&mut spooled(write)?, &mut out).map(drop);
        }
        if known.as_ref().is_some_and(|own| own.permissions().readonly()) {
            return Err(io::Error::new(io::ErrorKind::PermissionDenied, "the file is read-only"));
        }
        // For a symbolic link, replace the file that it points to.
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
            // After a crash, the old or the new file exists, never an empty one.
            Ok(()) => beside.as_file().sync_all().and_then(|()| beside.persist(&place).map(drop).map_err(|error| error.error)),
            Err(error) => Err(error),
        })
    }
}

/// Buffers the complete output, so that a pipe or a device receives all of it or nothing.
///
/// # Errors
/// Returns the errors of the writer, and an error if the work budget is exhausted.
pub(super) fn spooled(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<impl Read> {
    let mut kept = BufWriter::new(tempfile::spooled_tempfile(IN_MEMORY));
    write(&mut kept)?;
    let mut kept = kept.into_inner().map_err(io::IntoInnerError::into_error)?;
    kept.rewind()?;
    whole()?;
    Ok(kept)
}

/// Output longer than this many bytes is buffered in a temporary file.
const IN_MEMORY: usize = 1 << 24;

/// Returns an error if the work budget is exhausted, since the output is then incomplete.
fn whole() -> io::Result<()> {
    work::check().map_err(io::Error::other)
}

pub(super) use unfinished::{answer_interrupts, remove as remove_unfinished};

/// The unfinished temporary file, which is removed on Ctrl-C.
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

    /// On a termination signal, removes the unfinished file and ends the program.
    ///
    /// The exit code is 128 plus the signal number, as in shells: 130 after Ctrl-C, 143 after `kill`.
    /// Must run before any other thread starts, so that all threads block these signals and only the waiting thread receives them.
    #[cfg(unix)]
    pub(in crate::cli) fn answer_interrupts() {
        use nix::sys::signal::{SigSet, Signal};
        let mut signals = SigSet::empty();
        [Signal::SIGINT, Signal::SIGTERM, Signal::SIGHUP].into_iter().for_each(|own| signals.add(own));
        // If blocking fails, signals still end the program, but the file remains.
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

    /// On Ctrl-C, removes the unfinished file and ends the program.
    #[cfg(not(unix))]
    pub(in crate::cli) fn answer_interrupts() {
        const INTERRUPTED: i32 = 130;
        // Without a handler Ctrl-C still ends the program, but the file remains.
        let _ = ctrlc::set_handler(|| {
            remove();
            process::exit(INTERRUPTED);
        });
    }

    /// Removes the unfinished file. The lock is never released, so that no other file is created.
    pub(in crate::cli) fn remove() {
        let own = file();
        if let Some(path) = own.as_ref() {
            let _ = fs::remove_file(path);
        }
        std::mem::forget(own);
    }

    /// Creates the temporary file. A signal waits for the lock, so that the file cannot be missed.
    pub(super) fn create(make: impl FnOnce() -> io::Result<NamedTempFile>) -> io::Result<NamedTempFile> {
        let mut own = file();
        let made = make()?;
        *own = Some(made.path().to_owned());
        Ok(made)
    }

    /// Finishes the temporary file: renames or drops it.
    pub(super) fn end<T>(finish: impl FnOnce() -> T) -> T {
        let mut own = file();
        let done = finish();
        *own = None;
        done
    }
}

/// Temporary files are private by default; the output gets the usual permissions.
fn builder() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    builder
}
