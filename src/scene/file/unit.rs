//! Units: a table of names with exact factors, and products of their powers such as `um^-0.5` or `N/mm^2`.

use crate::expr::{Expr, Number};
use crate::scene::{Dimension, SceneError};
use num_rational::Ratio;
use num_traits::ToPrimitive;

/// A unit: its exact factor to m and N, and its dimension.
#[derive(Clone, Debug, PartialEq)]
pub struct Unit {
    name: String,
    factor: Expr,
    dimension: Dimension,
}

/// Name, numerator and denominator of the factor, power of ten, dimension, and whether prefixes are allowed.
type Row = (&'static str, i64, i64, i64, Dimension, bool);

/// The units that are not products of others.
const TABLE: &[Row] = &[
    ("m", 1, 1, 0, Dimension::LENGTH, true),
    ("N", 1, 1, 0, Dimension::FORCE, true),
    ("Pa", 1, 1, 0, Dimension::PRESSURE, true),
    ("J", 1, 1, 0, Dimension::ENERGY, true),
    ("angstrom", 1, 1, -10, Dimension::LENGTH, false),
    ("Å", 1, 1, -10, Dimension::LENGTH, false),
    ("in", 254, 1, -4, Dimension::LENGTH, false),
    ("mil", 254, 1, -7, Dimension::LENGTH, false),
    ("ft", 3048, 1, -4, Dimension::LENGTH, false),
    ("kgf", 980_665, 1, -5, Dimension::FORCE, false),
    ("gf", 980_665, 1, -8, Dimension::FORCE, false),
    ("dyn", 1, 1, -5, Dimension::FORCE, false),
    ("lbf", 44_482_216_152_605, 1, -13, Dimension::FORCE, false),
    ("bar", 1, 1, 5, Dimension::PRESSURE, true),
    ("atm", 101_325, 1, 0, Dimension::PRESSURE, false),
    // lbf/in²: 4.4482216152605/0.0254².
    ("psi", 44_482_216_152_605, 64_516, -5, Dimension::PRESSURE, false),
    ("ksi", 44_482_216_152_605, 64_516, -2, Dimension::PRESSURE, false),
    ("rad", 1, 1, 0, Dimension::NONE, true),
];

/// Prefixes with their powers of ten.
const PREFIXES: &[(&str, i64)] = &[
    ("f", -15),
    ("p", -12),
    ("n", -9),
    ("u", -6),
    ("µ", -6),
    ("μ", -6),
    ("m", -3),
    ("c", -2),
    ("d", -1),
    ("h", 2),
    ("k", 3),
    ("M", 6),
    ("G", 9),
    ("T", 12),
];

/// The units listed in error messages.
const KNOWN: &str = "expected m, N, Pa or J with a prefix (um, mN, GPa), in, mil, ft, lbf, kgf, dyn, psi, ksi, bar, atm, rad, deg, or a product such as N/mm^2";

impl Unit {
    /// Parses a unit.
    ///
    /// ```
    /// use sneddon::scene::{Dimension, Unit};
    /// let unit = Unit::parse("GPa*um^2").unwrap();
    /// assert_eq!(unit.dimension(), Dimension::FORCE);
    /// assert_eq!(unit.factor(), Unit::parse("mN").unwrap().factor());
    /// assert!(Unit::parse("parsec").is_err());
    /// ```
    ///
    /// # Errors
    /// [`SceneError`] for an unknown name.
    pub fn parse(text: &str) -> Result<Self, SceneError> {
        let bad = || {
            let shown: String = if text.trim().is_empty() { "an empty text".to_owned() } else { text.trim().chars().take(60).collect() };
            SceneError::unit(format!("{shown} is not a unit")).help(format!("{}{KNOWN}", suggestion(text)))
        };
        let (mut factor, mut dimension) = (Expr::one(), Dimension::NONE);
        let mut divide = false;
        let mut rest = text.trim();
        if rest.is_empty() || rest.len() > 200 {
            return Err(bad());
        }
        loop {
            let end = separator(rest);
            let (one, behind) = rest.split_at(end);
            let (own, power) = factor_of(one.trim()).ok_or_else(bad)?;
            let power = if divide { -power } else { power };
            let exponent = Expr::ratio(*power.numer(), *power.denom());
            factor = factor * own.factor.pow(&exponent);
            dimension = own.dimension.power(power).and_then(|own| dimension.times(own)).ok_or_else(bad)?;
            let behind = behind.trim_start();
            let Some(sign) = behind.chars().next() else { break };
            divide = sign == '/';
            rest = if matches!(sign, '*' | '·' | '/') { behind.get(sign.len_utf8()..).unwrap_or_default().trim_start() } else { behind };
        }
        Ok(Self { name: text.trim().to_owned(), factor, dimension })
    }

    /// Returns the name as typed.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns the factor that converts to m and N.
    pub fn factor(&self) -> &Expr {
        &self.factor
    }

    /// Returns the dimension.
    pub fn dimension(&self) -> Dimension {
        self.dimension
    }
}

/// Returns the number of bytes up to the first separator outside parentheses.
fn separator(text: &str) -> usize {
    let mut inside = false;
    let end = text.char_indices().find(|(_, c)| {
        inside = (inside || *c == '(') && *c != ')';
        !inside && matches!(c, '*' | '·' | '/' | ' ')
    });
    end.map_or(text.len(), |(at, _)| at)
}

/// Parses a factor such as `um^-0.5` into the unit and its power; `1` is dimensionless, as in `1/m`.
fn factor_of(text: &str) -> Option<(Unit, Ratio<i64>)> {
    let (name, power) = match text.split_once('^') {
        Some((name, power)) => (name.trim(), exponent(power.trim())?),
        None => (text, Ratio::from_integer(1)),
    };
    if name == "1" {
        return Some((Unit { name: String::new(), factor: Expr::one(), dimension: Dimension::NONE }, power));
    }
    Some((named(name)?, power))
}

/// Parses a whole, decimal or fractional exponent of moderate size.
fn exponent(text: &str) -> Option<Ratio<i64>> {
    let text = text.strip_prefix('(').and_then(|inner| inner.strip_suffix(')')).unwrap_or(text);
    let (above, below) = text.split_once('/').unwrap_or((text, "1"));
    let part = |text: &str| {
        let (negative, digits) = text.trim().strip_prefix('-').map_or((false, text.trim()), |digits| (true, digits));
        let number = Number::parse_decimal(digits).filter(|number| digits.len() <= 12 && number.to_f64().abs() <= 1e6)?;
        let (above, below) = (number.value().numer().to_i64()?, number.value().denom().to_i64()?);
        Some(Ratio::new(if negative { -above } else { above }, below))
    };
    let (above, below) = (part(above)?, part(below)?);
    (*below.numer() != 0).then(|| above / below)
}

/// Returns the units that were probably meant, spelled out or in other capitals.
fn suggestion(text: &str) -> String {
    const SPELLED: &[(&str, &str)] = &[
        ("meter", "m"),
        ("metre", "m"),
        ("micrometer", "um"),
        ("micrometre", "um"),
        ("nanometer", "nm"),
        ("nanometre", "nm"),
        ("millimeter", "mm"),
        ("millimetre", "mm"),
        ("micron", "um"),
        ("inch", "in"),
        ("foot", "ft"),
        ("newton", "N"),
        ("millinewton", "mN"),
        ("micronewton", "uN"),
        ("pascal", "Pa"),
        ("gigapascal", "GPa"),
        ("megapascal", "MPa"),
        ("kilopascal", "kPa"),
        ("joule", "J"),
        ("degree", "deg"),
        ("radian", "rad"),
    ];
    let wanted: String = text.trim().chars().take(60).collect::<String>().to_lowercase();
    let plain = wanted.strip_suffix('s').unwrap_or(&wanted);
    let spelled = SPELLED.iter().find(|(name, _)| *name == plain).map(|(_, unit)| (*unit).to_owned());
    let prefixes = PREFIXES.iter().map(|(prefix, _)| *prefix).filter(|prefix| prefix.is_ascii());
    let names = std::iter::once("")
        .chain(prefixes)
        .flat_map(|prefix| TABLE.iter().filter(move |row| prefix.is_empty() || row.5).map(move |row| format!("{prefix}{}", row.0)));
    let mut meant: Vec<String> = names.filter(|name| name.to_lowercase() == wanted).collect();
    meant.extend(spelled);
    if meant.is_empty() { String::new() } else { format!("did you mean {}? ", meant.join(" or ")) }
}

fn named(name: &str) -> Option<Unit> {
    let built = |factor: Expr, dimension| Some(Unit { name: name.to_owned(), factor, dimension });
    let ten = |power: i64| Expr::integer(10).power(power);
    match name {
        "deg" | "°" => return built(Expr::pi() / Expr::integer(180), Dimension::NONE),
        "arcmin" => return built(Expr::pi() / Expr::integer(10_800), Dimension::NONE),
        "micron" => return built(ten(-6), Dimension::LENGTH),
        _ => {}
    }
    let row = |name: &str| TABLE.iter().find(|row| row.0 == name);
    if let Some((_, above, below, power, dimension, _)) = row(name) {
        return built(Expr::ratio(*above, *below) * ten(*power), *dimension);
    }
    for (prefix, power) in PREFIXES {
        if let Some((_, above, below, own, dimension, true)) = name.strip_prefix(prefix).and_then(row) {
            return built(Expr::ratio(*above, *below) * ten(own + power), *dimension);
        }
    }
    None
}
