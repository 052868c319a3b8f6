//! Errors of a scene: the reason, what was expected, and the position in the file.

use crate::contact::ContactError;
use crate::parse::ParseError;
use std::ops::Range;
use thiserror::Error;

/// The reason why a scene cannot be read or solved.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Reason {
    /// The file is not valid TOML.
    #[error("invalid TOML: {0}")]
    Syntax(String),
    /// A key that does not exist.
    #[error("unknown key {key} in {table}")]
    UnknownKey {
        /// The key.
        key: String,
        /// The table that contains it.
        table: String,
    },
    /// A key is missing.
    #[error("{0}")]
    Missing(String),
    /// A value of the wrong type.
    #[error("{key} is {found}, not {expected}")]
    Kind {
        /// The key.
        key: String,
        /// The type of the value.
        found: &'static str,
        /// The expected type.
        expected: &'static str,
    },
    /// A value that is not allowed.
    #[error("{0}")]
    Value(String),
    /// A unit that is unknown or has the wrong dimension.
    #[error("{0}")]
    Unit(String),
    /// The profile does not have the dimension of a length.
    #[error("{0}")]
    Dimension(String),
    /// An expression that cannot be parsed.
    #[error("{0}")]
    Expression(String),
    /// The contact problem has no solution.
    #[error(transparent)]
    Contact(#[from] ContactError),
}

/// An error with its position in the file.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{reason}")]
pub struct SceneError {
    reason: Reason,
    help: Option<String>,
    span: Option<Range<usize>>,
}

impl SceneError {
    /// Creates an error without a position.
    pub fn new(reason: Reason) -> Self {
        Self { reason, help: None, span: None }
    }

    /// Adds what was expected, or what to do.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Adds the range of bytes in the file, unless the error already has one.
    #[must_use]
    pub fn at(mut self, span: Range<usize>) -> Self {
        self.span.get_or_insert(span);
        self
    }

    /// Returns the reason.
    pub fn reason(&self) -> &Reason {
        &self.reason
    }

    /// Returns what was expected, or what to do.
    pub fn accepted(&self) -> Option<&str> {
        self.help.as_deref()
    }

    /// Returns the range of bytes in the file.
    pub fn span(&self) -> Option<Range<usize>> {
        self.span.clone()
    }

    /// Creates an error for a value that is not allowed.
    pub fn value(message: impl Into<String>) -> Self {
        Self::new(Reason::Value(message.into()))
    }

    pub(super) fn missing(message: impl Into<String>) -> Self {
        Self::new(Reason::Missing(message.into()))
    }

    pub(super) fn unit(message: impl Into<String>) -> Self {
        Self::new(Reason::Unit(message.into()))
    }
}

impl From<ParseError> for SceneError {
    fn from(error: ParseError) -> Self {
        Self::new(Reason::Expression(error.reason().to_string())).help(error.accepted())
    }
}

impl From<ContactError> for SceneError {
    fn from(error: ContactError) -> Self {
        Self::new(Reason::Contact(error))
    }
}
