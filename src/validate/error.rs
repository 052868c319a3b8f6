//! Errors of a validation: invalid data with their position, or an invalid scene.

use crate::contact::ContactError;
use crate::scene::SceneError;
use thiserror::Error;

/// An error in the input of a validation.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ValidationError {
    /// A data file that cannot be read.
    #[error("{file}{}: {message}", place(*.line))]
    Data {
        /// The name of the file.
        file: String,
        /// The line, counted from 1.
        line: Option<u64>,
        /// The reason.
        message: String,
        /// What was expected, or what to do.
        help: Option<String>,
    },
    /// An inconsistent request.
    #[error("{message}")]
    Request {
        /// The reason.
        message: String,
        /// What was expected, or what to do.
        help: String,
    },
    /// An error in the scene.
    #[error(transparent)]
    Scene(#[from] SceneError),
}

fn place(line: Option<u64>) -> String {
    line.map_or_else(String::new, |line| format!(", line {line}"))
}

impl ValidationError {
    /// Creates an error in a data file.
    pub(super) fn data(file: &str, line: Option<u64>, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Data { file: file.to_owned(), line, message: message.into(), help: Some(help.into()) }
    }

    /// Creates an error in the request.
    pub(super) fn request(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Request { message: message.into(), help: help.into() }
    }

    /// Returns what was expected, or what to do.
    pub fn accepted(&self) -> Option<&str> {
        match self {
            Self::Data { help, .. } => help.as_deref(),
            Self::Request { help, .. } => Some(help),
            Self::Scene(error) => error.accepted(),
        }
    }
}

impl From<ContactError> for ValidationError {
    fn from(error: ContactError) -> Self {
        Self::Scene(error.into())
    }
}
