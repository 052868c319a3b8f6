//! Answers in files: whole or not at all.

use super::Failure;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// A file that will be written at the end; whatever fails before leaves it untouched.
pub(super) struct Target {
    path: PathBuf,
}

impl Target {
    /// A file for a plot.
    pub(super) fn svg(path: &Path) -> Result<Self, Failure> {
        let fits = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("svg"));
        if !fits {
            return Err(
                Failure::new(format!("-o {}: the plot is an SVG file", path.display())).help("a name that ends in .svg would be accepted")
            );
        }
        Self::new(path)
    }

    /// Any file whose directory exists.
    fn new(path: &Path) -> Result<Self, Failure> {
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

    /// Writes beside the file and renames, so that a reader never sees a part of it.
    pub(super) fn write(&self, bytes: &[u8]) -> Result<(), Failure> {
        self.replace(bytes).map_err(|error| Failure::new(format!("-o {} cannot be written: {error}", self.path.display())))
    }

    fn replace(&self, bytes: &[u8]) -> io::Result<()> {
        let mut beside = builder().tempfile_in(self.directory())?;
        beside.write_all(bytes)?;
        beside.persist(&self.path).map_err(|error| error.error)?;
        Ok(())
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
