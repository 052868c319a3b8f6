//! The option `--precision`, the number of digits in text and CSV output, and the parser of digit counts.

use super::Failure;
use crate::report::Digits;

#[derive(clap::Args)]
pub(super) struct PrecisionArguments {
    /// Significant digits of the values in text, CSV and pages [default: all, and 6 on pages]; error bounds include the rounding.
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    precision: Option<String>,
}

impl PrecisionArguments {
    /// Returns true if a number of digits is requested.
    pub(super) fn is_given(&self) -> bool {
        self.precision.is_some()
    }

    /// Returns the number of digits; `rounds` is true if the output format can be rounded.
    ///
    /// # Errors
    /// [`Failure`] unless the value is a whole number from 1 to 17, and for formats that are never rounded.
    pub(super) fn digits(&self, rounds: bool) -> Result<Digits, Failure> {
        let Some(text) = &self.precision else { return Ok(Digits::default()) };
        let digits = significant("--precision", text, |text| text.parse().ok().and_then(Digits::significant))?;
        if rounds {
            Ok(digits)
        } else {
            Err(Failure::new("--precision applies only to text and CSV; other formats contain all digits").help("omit --precision"))
        }
    }
}

/// Parses the number of digits of an option.
///
/// # Errors
/// [`Failure`] unless the value is a whole number from 1 to 17.
pub(super) fn significant<T>(option: &str, text: &str, read: impl Fn(&str) -> Option<T>) -> Result<T, Failure> {
    read(text.trim()).ok_or_else(|| {
        let fault = if text.trim().parse::<i64>().is_ok() { "is out of range" } else { "is not a whole number" };
        let help = format!("expected a whole number from 1 to {}", Digits::MAXIMUM);
        Failure::new(format!("{option} {} {fault}", text.trim())).help(help).at(option, text, 0..text.len())
    })
}
