//! Columns of a data file: what their names mean, and in which unit they count.

use crate::contact::Quantity;
use crate::scene::{Dimension, Unit};

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::validate) enum Kind {
    Depth,
    Force,
    ContactRadius,
    Energy,
    Stiffness,
    Distance,
    X,
    Y,
    Pressure,
    Displacement,
    Profile,
    Equivalent,
}

/// Names of columns that hold areas of contact, from which their radii follow.
const AREAS: &[&str] = &["A", "area", "contact_area"];

/// Names of columns; the first one of each is its symbol.
const NAMES: &[(Kind, &[&str])] = &[
    (Kind::Depth, &["d", "depth", "indentation", "indentation_depth", "penetration", "delta"]),
    (Kind::Force, &["F", "force", "load", "normal_force", "normal_load", "Fn", "F_n", "Fz", "P"]),
    (Kind::ContactRadius, &["a", "contact_radius"]),
    (Kind::Energy, &["U", "energy", "elastic_energy", "stored_energy"]),
    (Kind::Stiffness, &["k", "stiffness", "contact_stiffness"]),
    (Kind::Distance, &["r", "radius"]),
    (Kind::X, &["x", "X"]),
    (Kind::Y, &["y", "Y"]),
    (Kind::Pressure, &["p", "pressure", "contact_pressure", "normal_pressure", "traction", "tractions"]),
    (Kind::Displacement, &["u", "displacement", "uz", "u_z"]),
    (Kind::Profile, &["f"]),
    (Kind::Equivalent, &["g"]),
];

impl Kind {
    /// The symbol in answers.
    pub(in crate::validate) fn symbol(self) -> &'static str {
        NAMES.iter().find(|(kind, _)| *kind == self).and_then(|(_, names)| names.first()).copied().unwrap_or("")
    }

    /// Returns true for quantities of a place of the surface.
    pub(in crate::validate) fn is_field(self) -> bool {
        matches!(self, Self::Pressure | Self::Displacement | Self::Profile | Self::Equivalent)
    }

    pub(in crate::validate) fn dimension(self) -> Dimension {
        match self {
            Self::Force => Dimension::FORCE,
            Self::Pressure => Dimension::PRESSURE,
            Self::Energy => Dimension::ENERGY,
            Self::Stiffness => Dimension::STIFFNESS,
            _ => Dimension::LENGTH,
        }
    }

    fn of(name: &str) -> Option<Self> {
        if is_area(name) {
            return Some(Self::ContactRadius);
        }
        if let Some(name) = up_to_a_constant(name) {
            return Self::of(name).filter(|own| *own == Self::Displacement);
        }
        let same = |own: &&str| is(own, name);
        NAMES.iter().find(|(_, names)| names.iter().any(&same)).map(|(kind, _)| *kind)
    }
}

/// The name of a column that is known up to a constant, as in `u+c`.
fn up_to_a_constant(name: &str) -> Option<&str> {
    name.strip_suffix("+c").map(str::trim_end)
}

/// F and f differ; longer words do not.
fn is(own: &str, name: &str) -> bool {
    own == name || (own.len() > 1 && own.eq_ignore_ascii_case(name))
}

fn is_area(name: &str) -> bool {
    AREAS.iter().any(|own| is(own, name))
}

/// Returns true if a column holds error bounds, or what they rest on, as `reference` and `solve` name it: `p_error`, `p_error_GPa`, `p_bound`,
/// `p_proven`.
pub(in crate::validate) fn is_bound(name: &str) -> bool {
    bounded_quantity(name).is_some()
}

/// Returns true if a column holds the error bounds of a field.
pub(in crate::validate) fn is_bound_of_field(name: &str) -> bool {
    bounded_quantity(name).and_then(Kind::of).is_some_and(Kind::is_field)
}

/// Returns the quantity whose error bounds a column holds.
fn bounded_quantity(name: &str) -> Option<&'static str> {
    let is_kind = |rest: &str| matches!(rest, "bound" | "error" | "proven") || rest.starts_with("error_");
    Quantity::ALL
        .iter()
        .map(|own| own.key())
        .find(|own| name.trim().strip_prefix(own).and_then(|rest| rest.strip_prefix('_')).is_some_and(is_kind))
}

/// A column that is understood.
#[derive(Clone, Debug)]
pub(in crate::validate) struct Column {
    pub(in crate::validate) kind: Kind,
    pub(in crate::validate) unit: Option<Unit>,
    pub(in crate::validate) name: String,
    pub(in crate::validate) index: usize,
    /// True where it holds the area of a contact of this radius; its unit is that of a length all the same.
    pub(in crate::validate) is_area: bool,
    /// True where it is known up to a constant.
    pub(in crate::validate) free_constant: bool,
}

/// How a name can be read.
pub(in crate::validate) enum Reading {
    Known(Column),
    /// A symbol that is known, with something behind it that is no unit of its kind.
    BadUnit(String),
    Unknown,
}

/// Reads a name: `d`, `d_um`, `d (um)`, `d [um]`.
pub(in crate::validate) fn read(name: &str, index: usize) -> Reading {
    let name = name.trim();
    let built = |symbol: &str, kind, unit| {
        let symbol = symbol.trim();
        let free_constant = up_to_a_constant(symbol).is_some();
        Reading::Known(Column { kind, unit, name: name.to_owned(), index, is_area: is_area(symbol), free_constant })
    };
    if let Some(kind) = Kind::of(name) {
        return built(name, kind, None);
    }
    let split = name.rsplit_once('_').or_else(|| name.split_once(['(', '[', '/']));
    let Some((symbol, unit)) = split else { return Reading::Unknown };
    let Some(kind) = Kind::of(symbol.trim()) else { return Reading::Unknown };
    let unit = unit.trim().trim_end_matches([')', ']']);
    if is_bound(name) || unit.eq_ignore_ascii_case("error") {
        return Reading::Unknown;
    }
    let squared = ["^2", "²", "2"].into_iter().find_map(|power| unit.strip_suffix(power));
    let unit = match squared.filter(|_| is_area(symbol.trim())) {
        Some(root) => root,
        None if is_area(symbol.trim()) => return Reading::BadUnit(format!("{unit} is not the square of a length")),
        None => unit,
    };
    match Unit::parse(unit) {
        Ok(unit) if unit.dimension() == kind.dimension() => built(symbol, kind, Some(unit)),
        Ok(other) => Reading::BadUnit(format!("{} is {}, not {}", other.name(), other.dimension(), kind.dimension())),
        Err(error) => Reading::BadUnit(error.to_string()),
    }
}
