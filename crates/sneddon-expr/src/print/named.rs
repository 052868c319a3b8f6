//! Names with an argument and primes, such as g(x) and f'(r): values of functions that a derivation speaks of.

/// The name of a function, its primes and its argument, for a name of the form `f'(r)`.
pub(super) fn parts(name: &str) -> Option<(&str, usize, &str)> {
    let (function, argument) = name.strip_suffix(')')?.split_once('(')?;
    let letter = function.trim_end_matches('\'');
    Some((letter, function.len() - letter.len(), argument))
}

/// The list of arguments, numbers written by `number` and names by `name`.
pub(super) fn arguments(list: &str, separator: &str, number: impl Fn(&str) -> String, name: impl Fn(&str) -> String) -> String {
    list.split(',').map(str::trim).map(|own| if is_number(own) { number(own) } else { name(own) }).collect::<Vec<_>>().join(separator)
}

fn is_number(text: &str) -> bool {
    !text.is_empty() && text.chars().all(|own| own.is_ascii_digit())
}
