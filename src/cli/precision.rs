//! The option `--precision`, the number of digits in text and CSV, and how numbers of digits are read.

use super::Failure;
use crate::report::Digits;

#[derive(clap::Args)]
pub(super) struct PrecisionArguments {
    /// Significant digits of the values in text and CSV [default: all]; error bounds include the rounding.
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    precision: Option<String>,
}

impl PrecisionArguments {
    /// Returns the digits; `rounds` says whether the format of the answer can be rounded.
    ///
    /// # Errors
    /// [`Failure`] for anything but a whole number from 1 to 17, and for formats that are never rounded.
    pub(super) fn digits(&self, rounds: bool) -> Result<Digits, Failure> {
        let Some(text) = &self.precision else { return Ok(Digits::default()) };
        let digits = significant("--precision", text, |text| text.parse().ok().and_then(Digits::significant))?;
        if rounds {
            Ok(digits)
        } else {
            Err(Failure::new("--precision rounds text and CSV; other formats have all digits").help("leave --precision out"))
        }
    }
}

/// Returns the number of digits that an option has.
///
/// # Errors
/// [`Failure`] for anything but a whole number from 1 to 17, of which `read` makes nothing.
pub(super) fn significant<T>(option: &str, text: &str, read: impl Fn(&str) -> Option<T>) -> Result<T, Failure> {
    read(text.trim()).ok_or_else(|| {
        Failure::new(format!("{option} {} is not a number of digits", text.trim()))
            .help(format!("expected a whole number from 1 to {}", Digits::MOST))
            .at(option, text, 0..text.len())
    })
}
