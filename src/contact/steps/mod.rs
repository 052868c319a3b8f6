//! The way from f to every result as steps, each with its formula, its reason and its source: a tree, or one step per quantity.

mod equivalent;
mod inverse;
mod limit;
mod results;
mod short;

pub use inverse::inverse_steps;
pub use short::{short_inverse_steps, short_steps};

use super::{Edge, Relations};
use crate::expr::Formula;
use crate::print::Prose;
use crate::transform::{Solution, TransformError};

/// One step of a derivation.
#[derive(Clone, Debug)]
pub struct Step {
    /// The title of the step.
    pub title: String,
    /// The left side of its equation, a name such as g(x); `None` if the step states no equation.
    pub left: Option<String>,
    /// The right side.
    pub right: Option<Formula>,
    /// Why it is allowed.
    pub reason: Prose,
    /// The equations of the source.
    pub reference: Vec<&'static str>,
    /// The steps within it.
    pub steps: Vec<Step>,
}

impl Step {
    fn new(title: &str, left: &str, right: Formula, reason: Prose) -> Self {
        Self { title: title.to_owned(), left: Some(left.to_owned()), right: Some(right), reason, reference: Vec::new(), steps: Vec::new() }
    }

    /// A step without an equation.
    fn remark(title: &str, reason: Prose) -> Self {
        Self { title: title.to_owned(), left: None, right: None, reason, reference: Vec::new(), steps: Vec::new() }
    }

    fn from(mut self, reference: &[&'static str]) -> Self {
        self.reference = reference.to_vec();
        self
    }

    fn with(mut self, steps: Vec<Step>) -> Self {
        self.steps = steps;
        self
    }
}

/// The steps from f, as typed, to g, d, F, p, k, a(d) and F(d).
///
/// ```
/// use sneddon::contact::{Edge, relations, steps};
/// use sneddon::{parse, print, transform::{Profile, derive}};
/// let f = parse::profile("r^2/(2*R)").unwrap();
/// let solution = derive(&Profile::new(&f).unwrap()).unwrap();
/// let found = relations(&solution, &Edge::Smooth).unwrap();
/// let steps = steps(&f, &solution, &Edge::Smooth, &found).unwrap();
/// assert_eq!(print::text(steps[1].right.as_ref().unwrap()), "r/R");
/// ```
///
/// # Errors
/// [`TransformError`] if f has no derivative.
pub fn steps(typed: &Formula, solution: &Solution, edge: &Edge, relations: &Relations) -> Result<Vec<Step>, TransformError> {
    let mut list = equivalent::steps(typed, solution, relations)?;
    list.extend(results::steps(solution, edge, relations));
    list.extend(limit::step(solution, edge));
    Ok(list)
}
