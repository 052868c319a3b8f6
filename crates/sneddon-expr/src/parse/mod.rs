//! Text to formulas: lexer, operator precedence over byte spans, and the meaning of what was typed as canonical expressions.
//!
//! The entry points share one grammar and differ in the names that they accept: [`profile`], [`equivalent`] and [`pressure`] read
//! user input, [`formula`] reads everything that the program prints, and [`constant`] reads values of parameters.
//! Exceeding a limit is a typed error that names the place; no input exhausts the stack or takes long to process.

mod alphabet;
mod error;
mod lexer;
mod lower;
mod parser;
mod position;
mod repair;
mod syntax;

pub use error::{ParseError, Reason};
pub use position::position;

use crate::expr::{Expr, Formula, Symbol};
use lower::{Lowering, Names};
use parser::Left;

/// The parameters of a profile or an equivalent profile, including those that cancel, in order of appearance.
///
/// Empty for an invalid text.
///
/// ```
/// use sneddon_expr::{expr::Symbol, parse};
/// // f = r² for every h.
/// assert_eq!(parse::parameters("h*(r^2/h)"), [Symbol::new("h")]);
/// ```
pub fn parameters(text: &str) -> Vec<Symbol> {
    let items = parser::parse(text, Some(Left("f", "r"))).or_else(|_| parser::parse(text, Some(Left("g", "x"))));
    let mut found = Vec::new();
    for item in items.unwrap_or_default() {
        if let syntax::Kind::Name(name) = item.kind
            && let Ok(expr) = Names::Formula.resolve(&name, &item.span)
            && let Some(symbol) = expr.as_symbol()
            && !matches!(symbol.name(), "r" | "x")
            && !found.contains(symbol)
        {
            found.push(symbol.clone());
        }
    }
    found
}

/// The limits of the grammar; exceeding one is a typed error.
pub mod limits {
    /// Longest text, in bytes.
    pub const TEXT_BYTES: usize = 1 << 20;
    /// Deepest nesting of parentheses, function calls, right-nested powers and signs.
    pub const DEPTH: usize = 1000;
    /// Most digits of one number.
    pub const DIGITS: usize = 10_000;
    /// Largest magnitude of the exponent of a decimal number, as in `1e-6`.
    pub const DECIMAL_EXPONENT: i64 = 10_000;
    /// Largest magnitude of a numeric exponent, as in `r^6`.
    pub const EXPONENT: i64 = 1_000_000;
    /// Most breakpoints of all `piecewise` of one text.
    pub const BREAKPOINTS: usize = 1000;
    /// Most characters, each counted once per level of nesting that encloses it.
    pub(super) const NESTED_BYTES: usize = 1 << 24;
    /// Most work on long numbers: the sum of squared lengths, in words of 64 bits.
    pub(super) const NUMBER_WORK: u64 = 1 << 22;
}

/// Reads the shape f(r) of an indenter: `r` is the radius, other names are positive parameters.
///
/// # Errors
/// [`ParseError`] with the place, the reason and what was expected; also for the names `x`, `a`, `d`, `E`, which are reserved.
///
/// ```
/// use sneddon_expr::expr::Expr;
/// let (r, radius) = (Expr::symbol("r"), Expr::symbol("R"));
/// let f = sneddon_expr::parse::profile("r^2/(2*R)").unwrap();
/// assert_eq!(f.as_closed(), Some(&(r.power(2) / (Expr::integer(2) * radius))));
/// assert_eq!(sneddon_expr::parse::profile("2r").unwrap_err().span(), 1..2);
/// ```
pub fn profile(text: &str) -> Result<Formula, ParseError> {
    read_profile(text, Names::Profile)
}

/// Reads the shape of a punch with a rim: `a`, the radius of the rim, may occur in f as a constant.
///
/// # Errors
/// As [`profile`], with `a` among the names that f may have.
///
/// ```
/// assert!(sneddon_expr::parse::punch("-h*r^2/a^2").is_ok());
/// assert!(sneddon_expr::parse::profile("-h*r^2/a^2").is_err());
/// ```
pub fn punch(text: &str) -> Result<Formula, ParseError> {
    read_profile(text, Names::Punch)
}

fn read_profile(text: &str, names: Names) -> Result<Formula, ParseError> {
    repair::advised(text, |text| Lowering::new(names, text).formula(parser::parse(text, Some(Left("f", "r")))?))
}

/// Reads an equivalent profile g(x): `x` is the coordinate, other names are positive parameters.
///
/// # Errors
/// As [`profile`]; the reserved names are `r`, `a`, `d`, `E`.
///
/// ```
/// use sneddon_expr::expr::Expr;
/// let g = sneddon_expr::parse::equivalent("x^2/R").unwrap();
/// assert_eq!(g.as_closed(), Some(&(Expr::symbol("x").power(2) / Expr::symbol("R"))));
/// assert!(sneddon_expr::parse::equivalent("r^2").is_err());
/// ```
pub fn equivalent(text: &str) -> Result<Formula, ParseError> {
    repair::advised(text, |text| Lowering::new(Names::Equivalent, text).formula(parser::parse(text, Some(Left("g", "x")))?))
}

/// Reads a pressure p(r) in a contact of radius `a`, with `E` for the effective modulus.
///
/// # Errors
/// As [`profile`]; the reserved names are `x` and `d`, and pieces are refused.
///
/// ```
/// assert!(sneddon_expr::parse::pressure("p_0*sqrt(1-r^2/a^2)").is_ok());
/// assert!(sneddon_expr::parse::pressure("p_0*x").is_err());
/// ```
pub fn pressure(text: &str) -> Result<Expr, ParseError> {
    repair::advised(text, |text| Lowering::new(Names::Pressure, text).closed(parser::parse(text, Some(Left("p", "r")))?, "a pressure"))
}

/// Reads a formula as the program prints it: all variables, integrals and the functions of the table.
///
/// # Errors
/// As [`profile`], without reserved names.
///
/// ```
/// use sneddon_expr::{expr::Formula, parse};
/// let force = parse::formula("integral(2*E*r^2/sqrt(a^2 - r^2), r, 0, a)").unwrap();
/// assert!(matches!(force, Formula::Integral { .. }));
/// ```
pub fn formula(text: &str) -> Result<Formula, ParseError> {
    Lowering::new(Names::Formula, text).formula(parser::parse(text, None)?)
}

/// Reads a closed constant, as the value of a parameter: `0.3`, `3/2`, `1e-6`, `-1`, `pi/6`, `sqrt(2)`.
///
/// # Errors
/// As [`profile`]; also for every name that is not a constant.
///
/// ```
/// use sneddon_expr::{expr::Expr, parse};
/// assert_eq!(parse::constant("0.25").unwrap(), Expr::ratio(1, 4));
/// assert!(parse::constant("inf").is_err());
/// ```
pub fn constant(text: &str) -> Result<Expr, ParseError> {
    Lowering::new(Names::None, text).closed(parser::parse(text, None)?, "a constant")
}
