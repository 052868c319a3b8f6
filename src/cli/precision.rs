//! How many digits text and CSV have.

use super::Failure;
use crate::report::Digits;

#[derive(clap::Args)]
pub(super) struct PrecisionArguments {
    /// Number of significant digits of values in text and CSV [default: all]; their error bounds include the rounding.
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    precision: Option<String>,
}

impl PrecisionArguments {
    /// The digits; `rounds` says whether the format is one of those that can have fewer.
    ///
    /// # Errors
    /// [`Failure`] for a number that is none of digits, and for a format that always has all of them.
    pub(super) fn digits(&self, rounds: bool) -> Result<Digits, Failure> {
        let Some(text) = &self.precision else { return Ok(Digits::default()) };
        let digits = text.trim().parse().ok().and_then(Digits::significant).ok_or_else(|| {
            Failure::new(format!("--precision {} is no number of digits", text.trim()))
                .help(format!("a whole number from 1 to {} would be accepted", Digits::MOST))
                .at("--precision", text, 0..text.len())
        })?;
        if rounds {
            Ok(digits)
        } else {
            Err(Failure::new("--precision is for text and CSV; other formats have all digits").help("leave it out"))
        }
    }
}
