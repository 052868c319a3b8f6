//! Errors of the library as Python's `SneddonError`, with the place and what is accepted.

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use sneddon::contact::ContactError;
use sneddon::parse::ParseError;
use sneddon::scene::SceneError;
use sneddon::transform::TransformError;
use sneddon::validate::ValidationError;
use std::ops::Range;

/// An error before Python sees it.
pub(crate) struct Fault {
    message: String,
    more: Box<More>,
}

/// What many errors lack.
#[derive(Default)]
struct More {
    place: Option<String>,
    help: Option<String>,
    raised: Option<PyErr>,
}

impl Fault {
    /// An exception of a function of Python.
    pub(crate) fn raised(error: PyErr) -> Self {
        let more = More { raised: Some(error), ..More::default() };
        Self { message: String::new(), more: Box::new(more) }
    }

    pub(crate) fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), more: Box::default() }
    }

    /// Creates a fault from an error message; the text after its last semicolon becomes the help.
    fn split(text: &str) -> Self {
        match text.rsplit_once("; ") {
            Some((message, help)) => Self::new(message).help(help),
            None => Self::new(text),
        }
    }

    pub(crate) fn help(mut self, help: impl Into<String>) -> Self {
        self.more.help = Some(help.into());
        self
    }

    pub(crate) fn place(mut self, place: impl Into<String>) -> Self {
        self.more.place = Some(place.into());
        self
    }

    fn with_help(message: String, help: Option<&str>) -> Self {
        let own = Self::new(message);
        match help {
            Some(help) => own.help(help),
            None => own,
        }
    }

    /// Marks a part of a text, by line and column.
    fn at(self, name: &str, text: &str, span: &Range<usize>) -> Self {
        let before = text.get(..span.start).unwrap_or(text);
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().unwrap_or("").chars().count() + 1;
        let line = if text.contains('\n') { format!("line {line}, ") } else { String::new() };
        let marked = text.get(span.clone()).map(str::trim).filter(|own| !own.is_empty() && own.len() <= 60 && *own != text.trim());
        let marked = marked.map_or_else(String::new, |own| format!(": {own}"));
        self.place(format!("{name}, {line}column {column}{marked}"))
    }

    /// A text that could not be read.
    pub(crate) fn parse(name: &str, text: &str, error: &ParseError) -> Self {
        Self::new(error.reason().to_string()).help(error.accepted()).at(name, text, &error.span())
    }

    /// A scene that could not be read or solved.
    pub(crate) fn scene(text: &str, error: &SceneError) -> Self {
        let own = Self::with_help(error.to_string(), error.accepted());
        match error.span() {
            Some(span) => own.at("scene", text, &span),
            None => own,
        }
    }

    /// A file of points that could not be read.
    pub(crate) fn points(name: &str, text: &str, error: &SceneError) -> Self {
        let own = Self::with_help(error.to_string(), error.accepted());
        match error.span() {
            Some(span) => own.at(name, text, &span),
            None => own.place(name),
        }
    }

    /// Data that could not be read or compared.
    pub(crate) fn validation(text: &str, error: &ValidationError) -> Self {
        match error {
            ValidationError::Scene(error) => Self::scene(text, error),
            other => Self::with_help(other.to_string(), other.accepted()),
        }
    }
}

impl From<ContactError> for Fault {
    fn from(error: ContactError) -> Self {
        match error {
            ContactError::Transform(error) => error.into(),
            other => Self::split(&other.to_string()),
        }
    }
}

impl From<TransformError> for Fault {
    /// Errors of callables refer to the arguments of `Profile`.
    fn from(error: TransformError) -> Self {
        match error {
            TransformError::Seam { radius } => Self::new(format!(
                "the function is not smooth near r = {radius:?}, or oscillates too rapidly there for numerical differentiation"
            ))
            .help("pass the radii of kinks to Profile as kinks=[...], and the radius at which the function ends as end="),
            TransformError::Undefined { radius } => Self::new(format!("the function has no finite value at r = {radius:?}"))
                .help("pass the radius at which the function ends to Profile as end="),
            other => Self::split(&other.to_string()),
        }
    }
}

impl From<Fault> for PyErr {
    fn from(fault: Fault) -> Self {
        if let Some(error) = fault.more.raised {
            return error;
        }
        Python::attach(|py| {
            let made = py
                .import("sneddon._errors")
                .and_then(|own| own.getattr("SneddonError")?.call1((&fault.message, &fault.more.place, &fault.more.help)));
            match made {
                Ok(error) => PyErr::from_value(error),
                Err(_) => PyRuntimeError::new_err(fault.message),
            }
        })
    }
}
