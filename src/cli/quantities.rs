//! The option `--quantity`.

use super::Failure;
use crate::contact::Quantity;
use clap::builder::{PossibleValue, TypedValueParser};
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, Command};
use std::ffi::OsStr;

/// Checks whether a command supports a quantity; the error is the reason why it does not.
pub(super) type Answered = fn(Quantity) -> Result<(), &'static str>;

/// Parses the key of any quantity; the help lists the supported ones.
#[derive(Clone)]
pub(super) struct Quantities(pub(super) Answered);

impl TypedValueParser for Quantities {
    type Value = Quantity;

    fn parse_ref(&self, command: &Command, argument: Option<&Arg>, value: &OsStr) -> Result<Quantity, clap::Error> {
        let typed = value.to_string_lossy();
        Quantity::of(&typed).ok_or_else(|| {
            let mut error = clap::Error::new(ErrorKind::InvalidValue).with_cmd(command);
            if let Some(argument) = argument {
                error.insert(ContextKind::InvalidArg, ContextValue::String(argument.to_string()));
            }
            error.insert(ContextKind::InvalidValue, ContextValue::String(typed.to_string()));
            let known = self.possible_values().into_iter().flatten().map(|own| own.get_name().to_owned());
            error.insert(ContextKind::ValidValue, ContextValue::Strings(known.collect()));
            if let Some(meant) = self.meant(&typed) {
                error.insert(ContextKind::SuggestedValue, ContextValue::String(meant.key().to_owned()));
            }
            error
        })
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        let known = Quantity::ALL.iter().filter(|own| (self.0)(**own).is_ok());
        Some(Box::new(known.map(|own| PossibleValue::new(own.key()).help(format!("{} {}", own.title(), own.left(false))))))
    }
}

impl Quantities {
    /// Returns the quantity with a key or a left side in other letters, such as `F_of_D` or `F(d)`, or else that with the shortest title
    /// that contains every word of a text, such as `force` or `contact_radius`.
    fn meant(&self, typed: &str) -> Option<Quantity> {
        let letters = |text: &str| text.chars().filter(char::is_ascii_alphanumeric).collect::<String>();
        let plain = letters(typed);
        let all = || Quantity::ALL.iter().copied().filter(|own| (self.0)(*own).is_ok());
        let of_side = all().find(|own| letters(own.left(false)) == plain);
        if let Some(own) = of_side.or_else(|| all().find(|own| letters(own.key()).eq_ignore_ascii_case(&plain))) {
            return Some(own);
        }
        let typed = typed.to_lowercase();
        let words = || typed.split(|own: char| !own.is_alphanumeric()).filter(|own| !own.is_empty());
        let has = |own: &Quantity| words().next().is_some() && words().all(|word| own.title().split(' ').any(|other| other == word));
        all().filter(has).min_by_key(|own| own.title().len())
    }
}

/// Returns an error with the first unsupported quantity and the reason.
pub(super) fn demand(asked: &[Quantity], answered: Answered) -> Result<(), Failure> {
    let refused = |own: &Quantity| answered(*own).err().map(|why| Failure::new(format!("--quantity {}: {why}", own.key())));
    asked.iter().find_map(refused).map_or(Ok(()), Err)
}
