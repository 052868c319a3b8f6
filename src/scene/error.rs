//! What can be wrong with a scene: the reason, what would be accepted, and the place in the file.

use crate::contact::ContactError;
use crate::parse::ParseError;
use std::ops::Range;
use thiserror::Error;

/// Why a scene cannot be read or solved.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Reason {
    /// The file is no TOML.
    #[error("this is no TOML: {0}")]
    Syntax(String),
    /// A key that no scene has.
    #[error("there is no key {key} in {table}")]
    UnknownKey {
        /// The key.
        key: String,
        /// Where it stands.
        table: String,
    },
    /// A key is missing.
    #[error("{0}")]
    Missing(String),
    /// A value of the wrong kind.
    #[error("{key} is {found}, not {expected}")]
    Kind {
        /// The key.
        key: String,
        /// What stands there.
        found: &'static str,
        /// What should.
        expected: &'static str,
    },
    /// A value that is not possible.
    #[error("{0}")]
    Value(String),
    /// A unit that is not known, or of another kind.
    #[error("{0}")]
    Unit(String),
    /// The profile does not come out as a length.
    #[error("{0}")]
    Dimension(String),
    /// An expression that cannot be read.
    #[error("{0}")]
    Expression(String),
    /// The contact problem has no answer.
    #[error(transparent)]
    Contact(#[from] ContactError),
}

/// A reason with its place in the file.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{reason}")]
pub struct SceneError {
    reason: Reason,
    help: Option<String>,
    span: Option<Range<usize>>,
}

impl SceneError {
    /// An error without a place.
    pub fn new(reason: Reason) -> Self {
        Self { reason, help: None, span: None }
    }

    /// Adds what would be accepted.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Adds the bytes of the file that are meant, unless they are known already.
    #[must_use]
    pub fn at(mut self, span: Range<usize>) -> Self {
        self.span.get_or_insert(span);
        self
    }

    /// The reason.
    pub fn reason(&self) -> &Reason {
        &self.reason
    }

    /// What would be accepted.
    pub fn accepted(&self) -> Option<&str> {
        self.help.as_deref()
    }

    /// The bytes of the file that are meant.
    pub fn span(&self) -> Option<Range<usize>> {
        self.span.clone()
    }

    /// A value that is not possible.
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
