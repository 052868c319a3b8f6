//! Identifiers: converts names of parameters to valid names in a language.

use super::lower::Names;
use crate::expr::Symbol;
use std::collections::BTreeSet;

/// The longest identifier: Fortran 2003 accepts 63 characters.
const LONGEST: usize = 48;

/// An identifier for every symbol: its name where that is free, else with `_` behind it.
///
/// `reserved` recognizes the reserved words of the language; `taken` are names that the program itself uses. A language that
/// ignores case compares in lower case.
pub fn identifiers(symbols: &[Symbol], ignores_case: bool, reserved: &dyn Fn(&str) -> bool, taken: &[String]) -> Names {
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
