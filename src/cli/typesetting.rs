//! Options for typesetting formulas: complete documents, line width, symbol names, number of digits, and logarithms.

use super::Failure;
use super::output::{Endings, OutputFormat};
use super::precision::significant;
use crate::contact::Quantity;
use crate::expr::Formula;
use crate::parse;
use crate::print::{Presentation, Renaming};
use crate::report::{Digits, page};
use clap::ValueEnum;

/// The output formats of derivations and inversions.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(super) enum Format {
    Text,
    Unicode,
    Latex,
    Markdown,
    Typst,
    Mathml,
    Json,
}

/// The level of detail of a derivation.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(super) enum Steps {
    /// One step per quantity: its result, its definition and the rules of its closed form.
    Short,
    /// A tree of steps: the definition, and within it every term, substitution and result.
    Full,
}

impl OutputFormat for Format {
    const ENDINGS: &'static Endings<Self> = &[
        ("txt", Self::Text),
        ("tex", Self::Latex),
        ("md", Self::Markdown),
        ("typ", Self::Typst),
        ("html", Self::Mathml),
        ("json", Self::Json),
    ];
    const USUAL: Self = Self::Text;
}

impl Format {
    /// Returns the format of a page; `None` for JSON.
    pub(super) fn page(self) -> Option<page::Format> {
        Some(match self {
            Self::Text => page::Format::Text,
            Self::Unicode => page::Format::Unicode,
            Self::Latex => page::Format::Latex,
            Self::Markdown => page::Format::Markdown,
            Self::Typst => page::Format::Typst,
            Self::Mathml => page::Format::Mathml,
            Self::Json => return None,
        })
    }
}

/// The options of a page.
#[derive(clap::Args)]
pub(super) struct PageArguments {
    /// Writes a complete document that compiles, for latex, typst, markdown or mathml.
    #[arg(long)]
    standalone: bool,
    /// Width of a column in characters, from 20 to 1000, or with a unit, as 246pt or 8.5cm; 51 suits a paper in two columns [default: 72; text is not broken].
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    width: Option<String>,
}

impl PageArguments {
    /// Returns the style of a page; `None` is a format without formulas.
    pub(super) fn style(&self, format: Option<page::Format>) -> Result<page::Style, Failure> {
        let has_document = !matches!(format, None | Some(page::Format::Text | page::Format::Unicode));
        if self.standalone && !has_document {
            return Err(Failure::new("--standalone requires a document format, not text or data")
                .help("add --format latex, typst, markdown or mathml"));
        }
        let width = self.width.as_deref().map(characters).transpose()?;
        Ok(page::Style { standalone: self.standalone, width })
    }
}

#[derive(clap::Args)]
pub(super) struct TypesettingArguments {
    #[command(flatten)]
    page: PageArguments,
    /// Renames symbols in the output, such as E=E_r,d=\delta.
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    symbols: Vec<String>,
    /// Rounds decimals and long fractions in formulas to N significant digits, from 1 to 17 [default: exact].
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    digits: Option<String>,
    /// Form of inverse hyperbolic functions: arsinh, arcosh and artanh, or logarithms.
    #[arg(long, value_name = "FORM", value_enum, default_value = "ar")]
    inverse_hyperbolic: InverseHyperbolic,
}

/// The form of inverse hyperbolic functions.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum InverseHyperbolic {
    /// As functions: arsinh z, arcosh z, artanh z; in text asinh(z), acosh(z), atanh(z).
    Ar,
    /// As logarithms: ln(z + sqrt(z^2 + 1)), ln(z + sqrt(z^2 - 1)), ln((1 + z)/(1 - z))/2.
    Log,
}

impl TypesettingArguments {
    /// Returns the style of a page; `None` is JSON.
    pub(super) fn style(&self, format: Option<page::Format>) -> Result<page::Style, Failure> {
        self.page.style(format)
    }

    /// Returns the changes to the formulas in the output for a profile; `quantities` are those in the output, `None` for all.
    pub(super) fn presentation(&self, profile: &Formula, quantities: Option<&[Quantity]>) -> Result<Presentation, Failure> {
        let count = |text: &str| text.parse().ok().filter(|own: &u32| (1..=Digits::MAXIMUM).contains(&(*own as usize)));
        let digits = self.digits.as_deref().map(|text| significant("--digits", text, count)).transpose()?;
        let logarithms = self.inverse_hyperbolic == InverseHyperbolic::Log;
        Ok(Presentation { names: self.names(profile, quantities)?, digits, logarithms, ..Presentation::of(profile) })
    }

    /// Returns the new symbol names; two symbols never get the same name.
    fn names(&self, profile: &Formula, quantities: Option<&[Quantity]>) -> Result<Renaming, Failure> {
        const HELP: &str =
            "expected NAME=NAME, such as --symbols 'E=E_r,d=\\delta'; a name is a letter or a word, with an optional index after _";
        let mut pairs: Vec<(String, String)> = Vec::new();
        for item in &self.symbols {
            let Some((old, new)) = item.split_once('=') else {
                return Err(Failure::new(format!("--symbols {item} has no new name")).help(HELP));
            };
            let (old, new) = (symbol(old), symbol(new));
            let (Some(old), Some(new)) = (old, new) else {
                return Err(Failure::new(format!("--symbols {item} does not contain two symbol names")).help(HELP));
            };
            if pairs.iter().any(|(known, _)| *known == old) {
                return Err(Failure::new(format!("--symbols renames {old} twice")).help(HELP));
            }
            pairs.push((old, new));
        }
        let parameters: Vec<String> = profile.symbols().iter().map(|own| own.name().to_owned()).collect();
        for (at, (old, new)) in pairs.iter().enumerate() {
            let known = OWN.contains(&old.as_str()) || parameters.contains(old);
            if !known {
                return Err(Failure::new(format!("--symbols renames {old}, which does not appear in the output")).help(HELP));
            }
            let in_output = |name: &str| match quantities {
                _ if ALWAYS.contains(&name) => true,
                Some(list) => list.iter().any(|own| own.left(false).split('(').next() == Some(name) || own.coordinate() == name),
                None => OWN.contains(&name),
            };
            let stays = |name: &String| (in_output(name) || parameters.contains(name)) && !pairs.iter().any(|(own, _)| own == name);
            let is_taken = stays(new) || pairs.iter().take(at).any(|(_, own)| own == new);
            if is_taken || FIXED.contains(&new.as_str()) {
                return Err(Failure::new(format!("--symbols would rename {old} to {new}, which is already in use")).help(HELP));
            }
        }
        Ok(Renaming::new(pairs))
    }
}

/// Reads the width of a column in characters, of which a column of 345 pt has 72.
fn characters(text: &str) -> Result<usize, Failure> {
    const UNITS: [(&str, f64); 5] = [("pt", 1.0), ("mm", 72.27 / 25.4), ("cm", 72.27 / 2.54), ("in", 72.27), ("", 345.0 / 72.0)];
    let typed = text.trim();
    let points = UNITS.iter().find_map(|(unit, points)| Some(typed.strip_suffix(unit)?.trim().parse::<f64>().ok()? * points));
    // Room for rounding: 95.83 pt are 20 characters.
    let count = points.map(|points| (points / (345.0 / 72.0) + 1e-3).floor()).filter(|count| (20.0..=1000.0).contains(count));
    count.map(|count| count as usize).ok_or_else(|| {
        Failure::new(format!("--width {typed} is not a valid width"))
            .help("expected 20 to 1000 characters, or a width such as 246pt, 86mm, 8.6cm or 3.4in")
            .at("--width", text, 0..text.len())
    })
}

/// The symbols in the output of the program.
const OWN: [&str; 15] = ["r", "x", "a", "d", "E", "f", "g", "F", "p", "k", "u", "U", "G", "q", "z"];
/// The symbols in the output for all quantities.
const ALWAYS: [&str; 6] = ["r", "x", "a", "d", "E", "f"];
/// Names of constants.
const FIXED: [&str; 2] = ["pi", "e"];

/// Normalizes a symbol name; the LaTeX backslash before a Greek letter and braces around an index are removed.
fn symbol(text: &str) -> Option<String> {
    let text = text.trim();
    if text.matches('{').count() != text.matches('}').count() || text.find('}') < text.find('{') {
        return None;
    }
    let plain: String = text.trim_start_matches('\\').chars().filter(|own| !matches!(own, '{' | '}')).collect();
    // The effective modulus already has a star.
    if matches!(plain.as_str(), "E^*" | "E*") {
        return Some("E".to_owned());
    }
    let is_word = plain.chars().all(|own| own.is_alphanumeric() || own == '_') && plain.starts_with(char::is_alphabetic);
    if !is_word {
        return None;
    }
    // Letters are parsed by the grammar, so that α and alpha are the same name.
    let read = parse::formula(&plain)
        .ok()
        .and_then(|formula| formula.as_closed().and_then(|own| own.as_symbol().map(|own| own.name().to_owned())));
    Some(read.unwrap_or(plain))
}
