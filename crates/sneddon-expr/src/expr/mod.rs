//! Symbolic expressions: exact numbers, canonical trees, the function table, differentiation and the recognition form.
//!
//! Constructors are local and cheap: they flatten, sort by content, collect and fold, and never expand.
//! Every symbol represents a positive real number; [`sign`] returns the signs that follow from this assumption, else `Unknown`.

mod balanced;
mod build;
mod collected;
mod compare;
mod derivative;
mod divisor;
mod error;
mod formula;
pub mod function;
mod leading;
mod node;
pub mod normal;
mod number;
mod shown;
mod sign;
mod substitute;

pub use balanced::balanced;
pub use collected::{collected, in_lowest_terms, joined_powers, multiplied_out, over_one_denominator};
pub use derivative::derivative;
pub use error::ExprError;
pub use formula::{Condition, Formula, Relation};
pub(crate) use function::has_value;
pub use function::{Function, Growth, Row, SliceLaw, undefined_constant};
pub use leading::{FirstPower, LeadingTerm, leading_term};
pub use node::{Constant, Expr, Node, Symbol};
pub use number::Number;
pub use shown::{has_30_digits, shown, shown_as_mathematics, shown_to_30_digits, shown_with_logarithms};
pub use sign::{Sign, sign};
pub(crate) use sign::{is_known_below, known_sign};
pub use substitute::{Bindings, Rewriting, RewritingRule, rewritten};
