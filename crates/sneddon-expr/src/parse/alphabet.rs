//! Greek letters as names, and hints for characters that are not accepted.

/// The name of a Greek letter, e.g. `theta` for θ; variants of a letter have one name.
pub(super) fn greek(letter: char) -> Option<&'static str> {
    Some(match letter {
        'α' => "alpha",
        'β' | 'ϐ' => "beta",
        'γ' => "gamma",
        'δ' => "delta",
        'ε' | 'ϵ' => "epsilon",
        'ζ' => "zeta",
        'η' => "eta",
        'θ' | 'ϑ' => "theta",
        'ι' => "iota",
        'κ' | 'ϰ' => "kappa",
        'λ' => "lambda",
        'μ' | '\u{b5}' => "mu",
        'ν' => "nu",
        'ξ' => "xi",
        'ο' => "omicron",
        'π' => "pi",
        'ρ' | 'ϱ' => "rho",
        'σ' | 'ς' => "sigma",
        'τ' => "tau",
        'υ' => "upsilon",
        'φ' | 'ϕ' => "phi",
        'χ' => "chi",
        'ψ' => "psi",
        'ω' => "omega",
        'Α' => "Alpha",
        'Β' => "Beta",
        'Γ' => "Gamma",
        'Δ' | '\u{2206}' => "Delta",
        'Ε' => "Epsilon",
        'Ζ' => "Zeta",
        'Η' => "Eta",
        'Θ' => "Theta",
        'Ι' => "Iota",
        'Κ' => "Kappa",
        'Λ' => "Lambda",
        'Μ' => "Mu",
        'Ν' => "Nu",
        'Ξ' => "Xi",
        'Ο' => "Omicron",
        'Π' => "Pi",
        'Ρ' => "Rho",
        'Σ' => "Sigma",
        'Τ' => "Tau",
        'Υ' => "Upsilon",
        'Φ' => "Phi",
        'Χ' => "Chi",
        'Ψ' => "Psi",
        'Ω' | '\u{2126}' => "Omega",
        _ => return None,
    })
}

/// The plain character of a superscript.
pub(super) fn raised(character: char) -> Option<char> {
    Some(match character {
        '⁰' => '0',
        '¹' => '1',
        '²' => '2',
        '³' => '3',
        '⁴'..='⁹' => char::from_digit(u32::from(character) - 0x2070, 10)?,
        '⁻' => '-',
        'ⁿ' => 'n',
        _ => return None,
    })
}

/// Advice for a character that is not allowed.
pub(super) fn instead_of(character: char) -> &'static str {
    match character {
        '₀'..='₉' => "write an index with _, as in c_1",
        '½' | '¼' | '¾' => "write a fraction with /, as in 1/2",
        '∞' => "use finite numbers",
        '|' => "write a magnitude as abs(r)",
        '≤' | '≥' => "write <= or >=",
        '–' | '—' => "write a minus as -",
        '÷' => "write a division as /",
        '{' | '}' => "group with parentheses ( )",
        '!' => "write a factorial as gamma(n+1)",
        ';' => "separate arguments by ,",
        '=' => "write only the right-hand side of f(r) = ..., such as r^2",
        '%' => "write 1 % as 0.01",
        '"' | '\'' => "use letters, digits, + - * / ^ and parentheses, without quotation marks",
        _ => "use letters, digits, _ . + - * / ^ , < > and parentheses",
    }
}

/// A character as an error shows it: with its code point where it is not plain ASCII.
pub(super) fn describe(character: char) -> String {
    if character.is_ascii_graphic() {
        format!("{character:?}")
    } else if character.is_control() || character.is_whitespace() {
        format!("U+{:04X}", u32::from(character))
    } else {
        format!("{character:?} (U+{:04X})", u32::from(character))
    }
}
