//! Why data cannot be validated: bad data with their place, or a bad scene.

use crate::contact::ContactError;
use crate::scene::SceneError;
use thiserror::Error;

/// Bad input of a validation.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ValidationError {
    /// A data file that cannot be read as one.
    #[error("{file}{}: {message}", place(*.line))]
    Data {
        /// The name of the file.
        file: String,
        /// The line, counted from 1.
        line: Option<u64>,
        /// The reason.
        message: String,
        /// What would be accepted.
        help: Option<String>,
    },
    /// A request that does not fit together.
    #[error("{message}")]
    Request {
        /// The reason.
        message: String,
        /// What would be accepted.
        help: String,
    },
    /// The scene.
    #[error(transparent)]
    Scene(#[from] SceneError),
}

fn place(line: Option<u64>) -> String {
    line.map_or_else(String::new, |line| format!(", line {line}"))
}

impl ValidationError {
    /// A fault of a data file.
    pub(super) fn data(file: &str, line: Option<u64>, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Data { file: file.to_owned(), line, message: message.into(), help: Some(help.into()) }
    }

    /// A fault of the request.
    pub(super) fn request(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Request { message: message.into(), help: help.into() }
    }

    /// What would be accepted.
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
