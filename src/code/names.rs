//! Identifiers: the names of parameters as a language accepts them, so that nothing but a name can come out.

use super::lower::Names;
use crate::expr::Symbol;
use std::collections::BTreeSet;

/// The longest identifier: Fortran 2003 accepts 63 characters.
const LONGEST: usize = 48;

/// An identifier for every symbol: its name where that is free, else with `_` behind it.
///
/// `reserved` knows the words of the language; `taken` are names that the program itself uses. A language that ignores case
/// compares in lower case.
pub(super) fn identifiers(symbols: &[Symbol], ignores_case: bool, reserved: &dyn Fn(&str) -> bool, taken: &[String]) -> Names {
    let key = |name: &str| if ignores_case { name.to_lowercase() } else { name.to_owned() };
    let mut used: BTreeSet<String> = taken.iter().map(|own| key(own)).collect();
    let mut names = Names::new();
    for symbol in symbols {
        let mut name = spelled(symbol.name());
        while reserved(&key(&name)) || used.contains(&key(&name)) || is_variable(&name) {
            name.push('_');
        }
        used.insert(key(&name));
        names.insert(symbol.name().to_owned(), name);
    }
    names
}

/// The variables of generated routines are called t1, t2, …
fn is_variable(name: &str) -> bool {
    name.strip_prefix(['t', 'T']).is_some_and(|rest| !rest.is_empty() && rest.bytes().all(|byte| byte.is_ascii_digit()))
}

/// ASCII letters, digits and underscores, beginning with a letter; any other character becomes its code.
fn spelled(name: &str) -> String {
    let mut text = String::new();
    for character in name.chars() {
        if character.is_ascii_alphanumeric() || character == '_' {
            text.push(character);
        } else {
            text.push_str(&format!("u{:04x}", u32::from(character)));
        }
        if text.len() >= LONGEST {
            break;
        }
    }
    if text.starts_with(|c: char| c.is_ascii_alphabetic()) { text } else { format!("p{text}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_is_an_identifier_and_no_two_are_equal() {
        let symbols: Vec<Symbol> = ["R", "r_", "int", "t1", "_x", "é\n*/", "A", "a_0", "A_0"].map(Symbol::new).to_vec();
        let names = identifiers(&symbols, true, &|word| word == "int", &["r".to_owned(), "a".to_owned()]);
        let all: BTreeSet<String> = names.values().map(|own| own.to_lowercase()).collect();
        assert_eq!(all.len(), symbols.len());
        assert_eq!((names["R"].as_str(), names["int"].as_str(), names["t1"].as_str()), ("R_", "int_", "t1_"));
        let is_word =
            |own: &str| own.starts_with(|c: char| c.is_ascii_alphabetic()) && own.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        assert!(names.values().all(|own| is_word(own)), "{names:?}");
    }
}
