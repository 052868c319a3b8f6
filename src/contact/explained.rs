//! The result of every way to a number of a contact.

use super::{Contact, ContactError, Measured, Quantity};
use crate::expr::Bindings;
use crate::num::{Estimate, work};
use crate::transform::{Evaluator, Method, Solution, TransformError, WAYS, Way};

/// Steps of work that one way may take for one point, about a tenth of a second.
const MOST_STEPS: u64 = 10_000_000;
/// Steps of work that stay for the rest of the command, such as writing the answer.
const RESERVE: u64 = 1_000_000;

/// The result of one way.
#[derive(Clone, Debug, PartialEq)]
pub struct WayResult {
    /// The key of the way.
    pub way: &'static str,
    /// The number, or the reason why it is missing.
    pub found: Result<Estimate, String>,
    /// Steps of work that it took; compiling the formulas counts at the first point.
    pub steps: u64,
}

impl WayResult {
    /// Returns true for a way that was not asked because the work limit was reached.
    pub fn is_cut(&self) -> bool {
        self.found.as_ref().is_err_and(|why| why == NOT_ASKED)
    }
}

const NOT_ASKED: &str = "not asked: the work limit is reached";

/// A contact whose numbers are computed by each of [`WAYS`] separately.
pub struct Explained<'a> {
    contacts: Vec<(&'static Way, Contact<'a>)>,
}

impl<'a> Explained<'a> {
    /// The contact of [`Contact::new`], once for each way.
    ///
    /// ```
    /// use sneddon::{contact::{Explained, Quantity}, expr::Bindings, parse, transform::{Profile, derive}};
    /// let solution = derive(&Profile::new(&parse::profile("r^2/4").unwrap()).unwrap()).unwrap();
    /// let explained = Explained::new(&solution, &Bindings::default(), 1.0, None, 1e-13).unwrap();
    /// let asked = explained.ask(Quantity::Force, 1.0, 1.0);
    /// // F = (4/3) a³/R with R = 2
    /// assert!(asked.iter().filter_map(|own| own.found.as_ref().ok()).all(|own| (own.value - 2.0 / 3.0).abs() <= own.error));
    /// ```
    ///
    /// # Errors
    /// As [`Evaluator::new`].
    pub fn new(
        solution: &'a Solution,
        bindings: &Bindings,
        effective_modulus: f64,
        depth: Option<f64>,
        tolerance: f64,
    ) -> Result<Self, ContactError> {
        let contact = |way| {
            let evaluator = Evaluator::new(solution, bindings, Method::Only(way), tolerance)?;
            Ok((way, Contact::new(evaluator, effective_modulus, depth, tolerance)))
        };
        Ok(Self { contacts: WAYS.iter().map(contact).collect::<Result<_, ContactError>>()? })
    }

    /// The results of all ways that compute the quantity, at a place or load; `radius` is the contact radius of a field.
    pub fn ask(&self, quantity: Quantity, at: f64, radius: f64) -> Vec<WayResult> {
        self.contacts.iter().filter_map(|(way, contact)| asked(way, contact, quantity, at, radius)).collect()
    }
}

/// The result of one way; `None` if the way does not apply to the quantity.
fn asked(way: &'static Way, contact: &Contact<'_>, quantity: Quantity, at: f64, radius: f64) -> Option<WayResult> {
    let share = MOST_STEPS.min(work::left().saturating_sub(RESERVE));
    if share == 0 {
        return Some(WayResult { way: way.key, found: Err(NOT_ASKED.to_owned()), steps: 0 });
    }
    let (answer, steps, whole) = work::apart(share, || quantity.number(contact, at, radius));
    work::spend(steps);
    let found = match answer {
        _ if !whole => Err(format!("it takes more than {steps} steps of work")),
        Err(ContactError::Transform(TransformError::NoSuchWay { .. })) => return None,
        Err(ContactError::Transform(TransformError::NotThisWay { reason, .. })) => Err(reason.to_owned()),
        Err(error) => Err(error.to_string()),
        Ok(Measured::Err(reason)) => Err(reason.text().to_owned()),
        Ok(Measured::Ok(own)) if own.estimate.way == way.key => Ok(own.estimate),
        Ok(Measured::Ok(_)) => return None,
    };
    Some(WayResult { way: way.key, found, steps })
}
