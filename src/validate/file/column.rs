//! Columns of a data file: quantities and units from their names.

use crate::contact::Quantity;
use crate::scene::{Dimension, Unit};

/// The quantity in a column.
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

/// Names of columns with contact areas, from which contact radii are computed.
const AREAS: &[&str] = &["A", "area", "contact_area"];

/// Names of columns; the first name of each quantity is its symbol.
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
    /// Returns the symbol used in reports.
    pub(in crate::validate) fn symbol(self) -> &'static str {
        NAMES.iter().find(|(kind, _)| *kind == self).and_then(|(_, names)| names.first()).copied().unwrap_or("")
    }

    /// Returns true for fields on the surface.
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
        let name = &joined(name);
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

/// Returns the words of a name with underscores between them, as `Contact_radius` for `Contact radius`.
fn joined(name: &str) -> String {
    name.split([' ', '-', '_']).filter(|own| !own.is_empty()).collect::<Vec<_>>().join("_")
}

/// Returns the name without the suffix of `u+c`, which marks a column known up to a constant; `None` without it.
fn up_to_a_constant(name: &str) -> Option<&str> {
    name.strip_suffix("+c").map(str::trim_end)
}

/// Returns true if the names are equal; case matters only for single letters, to distinguish F from f.
fn is(own: &str, name: &str) -> bool {
    own == name || (own.len() > 1 && own.eq_ignore_ascii_case(name))
}

fn is_area(name: &str) -> bool {
    AREAS.iter().any(|own| is(own, name))
}

/// Returns true if a column contains error bounds or their kind, as named by `reference` and `solve`: `p_error`, `p_error_GPa`, `p_bound`,
/// `p_proven`.
pub(in crate::validate) fn is_bound(name: &str) -> bool {
    bounded_quantity(name).is_some()
}

/// Returns true if a column contains the error bounds of a field.
pub(in crate::validate) fn is_bound_of_field(name: &str) -> bool {
    bounded_quantity(name).and_then(Kind::of).is_some_and(Kind::is_field)
}

/// Returns the quantity whose error bounds a column contains.
fn bounded_quantity(name: &str) -> Option<&'static str> {
    let is_kind = |rest: &str| matches!(rest, "bound" | "error" | "proven") || rest.starts_with("error_");
    Quantity::ALL
        .iter()
        .map(|own| own.key())
        .find(|own| name.trim().strip_prefix(own).and_then(|rest| rest.strip_prefix('_')).is_some_and(is_kind))
}

/// A recognized column.
#[derive(Clone, Debug)]
pub(in crate::validate) struct Column {
    pub(in crate::validate) kind: Kind,
    pub(in crate::validate) unit: Option<Unit>,
    pub(in crate::validate) name: String,
    pub(in crate::validate) index: usize,
    /// True if the column contains contact areas; `unit` is then the unit of length whose square they are given in.
    pub(in crate::validate) is_area: bool,
    /// True if the column is known up to a constant.
    pub(in crate::validate) free_constant: bool,
}

/// The result of reading a name.
pub(in crate::validate) enum Reading {
    Known(Column),
    /// A known symbol with an unknown or unsuitable unit.
    BadUnit(String),
    Unknown,
}

/// Parses the symbol that a column with another name is mapped to, with the unit of the symbol or else of the name: `d` for `h_um` is in
/// micrometres.
pub(in crate::validate) fn read_mapped(symbol: &str, name: &str, index: usize) -> Reading {
    let own = read(symbol, index);
    match &own {
        Reading::Known(column) if column.unit.is_none() => {
            let with_unit = |(_, unit): (&str, &str)| match read(&format!("{symbol} ({})", unit.trim().trim_end_matches([')', ']'])), index)
            {
                Reading::Known(column) => Some(Reading::Known(column)),
                _ => None,
            };
            splits(name).into_iter().flatten().find_map(with_unit).unwrap_or(own)
        }
        _ => own,
    }
}

/// Returns the name without its unit and the unit, for each way to write a unit.
fn splits(name: &str) -> [Option<(&str, &str)>; 3] {
    [name.split_once(['(', '[']), name.rsplit_once('_'), name.split_once('/')]
}

/// Parses a name: `d`, `d_um`, `d (um)`, `d [um]`, `Contact radius / um`.
pub(in crate::validate) fn read(name: &str, index: usize) -> Reading {
    let name = name.trim();
    let built = |symbol: &str, kind, unit| {
        let symbol = &joined(symbol);
        let free_constant = up_to_a_constant(symbol).is_some();
        Reading::Known(Column { kind, unit, name: name.to_owned(), index, is_area: is_area(symbol), free_constant })
    };
    if let Some(kind) = Kind::of(name) {
        return built(name, kind, None);
    }
    let found = splits(name).into_iter().flatten().find_map(|(symbol, unit)| Some((symbol.trim(), unit, Kind::of(symbol.trim())?)));
    let Some((symbol, unit, kind)) = found else { return Reading::Unknown };
    let unit = unit.trim().trim_end_matches([')', ']']);
    if is_bound(name) || unit.eq_ignore_ascii_case("error") {
        return Reading::Unknown;
    }
    let squared = ["^2", "²", "2"].into_iter().find_map(|power| unit.strip_suffix(power));
    let unit = match squared.filter(|_| is_area(&joined(symbol))) {
        Some(root) => root,
        None if is_area(&joined(symbol)) => return Reading::BadUnit(format!("{unit} is not the square of a length")),
        None => unit,
    };
    match Unit::parse(unit) {
        Ok(unit) if unit.dimension() == kind.dimension() => built(symbol, kind, Some(unit)),
        Ok(other) => Reading::BadUnit(format!("{} is {}, not {}", other.name(), other.dimension(), kind.dimension())),
        Err(error) => Reading::BadUnit(error.to_string()),
    }
}
