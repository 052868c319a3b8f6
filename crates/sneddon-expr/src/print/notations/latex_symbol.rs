//! Names of parameters, variables and functions in LaTeX.

use crate::expr::function::{Font, Letters};
use crate::print::named;

/// A name: Greek letters as such, indices below, words upright, the effective modulus with its star.
pub(in crate::print) fn symbol(name: &str) -> String {
    if name == "E" {
        return "E^{*}".to_owned();
    }
    if let Some((function, primes, argument)) = named::parts(name) {
        return format!("{}{}({})", symbol(function), "'".repeat(primes), named::arguments(argument, ", ", str::to_owned, symbol));
    }
    let (letter, indices) = parts(name);
    // The components of a stress, as in sigma_zz.
    let components = |index: &str| index.chars().all(|c| matches!(c, 'r' | 'x' | 'y' | 'z')).then(|| index.to_owned());
    let indices: Vec<String> = indices.into_iter().map(|own| components(own).unwrap_or_else(|| word(own))).collect();
    if indices.is_empty() { word(letter) } else { format!("{}_{{{}}}", word(letter), indices.join(",")) }
}

/// The letter or word of a name and the parts of its index.
pub(in crate::print) fn parts(name: &str) -> (&str, Vec<&str>) {
    let (letter, index) = name.split_once('_').unwrap_or_else(|| {
        let end = name.trim_end_matches(|c: char| c.is_ascii_digit()).len();
        (name.get(..end).unwrap_or(name), name.get(end..).unwrap_or(""))
    });
    (letter, index.split('_').filter(|part| !part.is_empty()).collect())
}

/// The name of a function.
pub(in crate::print) fn letters(letters: Letters) -> String {
    /// Names that LaTeX has a command for.
    const COMMANDS: [&str; 13] = ["ln", "sin", "cos", "tan", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "exp", "max", "min"];
    let name = match (letters.text, letters.font) {
        ("Γ", _) => "\\Gamma".to_owned(),
        ("ψ", _) => "\\psi".to_owned(),
        ("κ", _) => "\\kappa".to_owned(),
        ("χ", _) => "\\chi".to_owned(),
        (text, Font::Bold) => format!("\\mathbf{{{text}}}"),
        (text, Font::Italic) => text.to_owned(),
        (text, Font::Upright) if COMMANDS.contains(&text) => format!("\\{text}"),
        // Without the space of an operator, which would part F from its index in front.
        (text, Font::Upright) if text.len() == 1 => format!("\\mathrm{{{text}}}"),
        (text, Font::Upright) => format!("\\operatorname{{{text}}}"),
    };
    if letters.index.is_empty() { name } else { format!("{name}_{{{}}}", letters.index) }
}

/// True for a letter that is named in full, as `theta`.
pub(in crate::print) fn is_greek(name: &str) -> bool {
    GREEK.contains(&name) || LATIN_LOOKING.iter().any(|(greek, _)| *greek == name)
}

/// One part of a name.
fn word(word: &str) -> String {
    if GREEK.contains(&word) {
        return format!("\\{word}");
    }
    if let Some((_, letter)) = LATIN_LOOKING.iter().find(|(greek, _)| *greek == word) {
        return (*letter).to_owned();
    }
    if let Some(letter) = word.strip_prefix("Delta").filter(|rest| rest.len() == 1) {
        return format!("\\Delta {letter}");
    }
    let single = word.chars().count() == 1 || word.chars().all(|c| c.is_ascii_digit());
    if single { word.to_owned() } else { format!("\\mathrm{{{word}}}") }
}

const GREEK: [&str; 34] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu", "nu", "xi", "pi", "rho",
    "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega", "Gamma", "Delta", "Theta", "Lambda", "Xi", "Pi", "Sigma", "Upsilon", "Phi",
    "Psi", "Omega",
];

/// Greek letters that look like Latin letters and have no LaTeX command.
const LATIN_LOOKING: [(&str, &str); 14] = [
    ("omicron", "o"),
    ("Alpha", "\\mathrm{A}"),
    ("Beta", "\\mathrm{B}"),
    ("Epsilon", "\\mathrm{E}"),
    ("Zeta", "\\mathrm{Z}"),
    ("Eta", "\\mathrm{H}"),
    ("Iota", "\\mathrm{I}"),
    ("Kappa", "\\mathrm{K}"),
    ("Mu", "\\mathrm{M}"),
    ("Nu", "\\mathrm{N}"),
    ("Omicron", "\\mathrm{O}"),
    ("Rho", "\\mathrm{P}"),
    ("Tau", "\\mathrm{T}"),
    ("Chi", "\\mathrm{X}"),
];
