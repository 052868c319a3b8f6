//! Columns of a data file: what their names mean, and in which unit they count.

use crate::scene::{Dimension, Unit};

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Depth,
    Force,
    ContactRadius,
    Distance,
    X,
    Y,
    Pressure,
    Displacement,
}

/// Names of columns; the first one of each is its symbol.
const NAMES: &[(Kind, &[&str])] = &[
    (Kind::Depth, &["d", "depth", "indentation", "penetration", "delta"]),
    (Kind::Force, &["F", "force", "load", "normal_force", "Fn", "P"]),
    (Kind::ContactRadius, &["a", "contact_radius"]),
    (Kind::Distance, &["r", "radius"]),
    (Kind::X, &["x", "X"]),
    (Kind::Y, &["y", "Y"]),
    (Kind::Pressure, &["p", "pressure", "traction"]),
    (Kind::Displacement, &["u", "displacement"]),
];

impl Kind {
    /// The symbol in answers.
    pub(super) fn symbol(self) -> &'static str {
        NAMES.iter().find(|(kind, _)| *kind == self).and_then(|(_, names)| names.first()).copied().unwrap_or("")
    }

    pub(super) fn dimension(self) -> Dimension {
        match self {
            Self::Force => Dimension::FORCE,
            Self::Pressure => Dimension::PRESSURE,
            _ => Dimension::LENGTH,
        }
    }

    fn of(name: &str) -> Option<Self> {
        // F and f differ; longer words do not.
        let same = |own: &&str| **own == *name || (own.len() > 1 && own.eq_ignore_ascii_case(name));
        NAMES.iter().find(|(_, names)| names.iter().any(&same)).map(|(kind, _)| *kind)
    }
}

/// A column that is understood.
#[derive(Clone, Debug)]
pub(super) struct Column {
    pub(super) kind: Kind,
    pub(super) unit: Option<Unit>,
    pub(super) name: String,
    pub(super) index: usize,
}

/// How a name can be read.
pub(super) enum Reading {
    Known(Column),
    /// A symbol that is known, with something behind it that is no unit of its kind.
    BadUnit(String),
    Unknown,
}

/// Reads a name: `d`, `d_um`, `d (um)`, `d [um]`.
pub(super) fn read(name: &str, index: usize) -> Reading {
    let name = name.trim();
    let built = |kind, unit| Reading::Known(Column { kind, unit, name: name.to_owned(), index });
    if let Some(kind) = Kind::of(name) {
        return built(kind, None);
    }
    let split = name.rsplit_once('_').or_else(|| name.split_once(['(', '[', '/']));
    let Some((symbol, unit)) = split else { return Reading::Unknown };
    let Some(kind) = Kind::of(symbol.trim()) else { return Reading::Unknown };
    let unit = unit.trim().trim_end_matches([')', ']']);
    match Unit::parse(unit) {
        Ok(unit) if unit.dimension() == kind.dimension() => built(kind, Some(unit)),
        Ok(other) => Reading::BadUnit(format!("{} is {}, not {}", other.name(), other.dimension(), kind.dimension())),
        Err(error) => Reading::BadUnit(error.to_string()),
    }
}
