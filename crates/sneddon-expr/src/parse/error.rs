//! Parse errors: the place, the reason, and what was expected.

use super::limits;
use std::ops::Range;
use thiserror::Error;

/// Why a text is not a valid expression.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Reason {
    /// The text is longer than the limit.
    #[error("the text has {bytes} bytes, the limit is {}", limits::TEXT_BYTES)]
    TextTooLong {
        /// Its length.
        bytes: usize,
    },
    /// Parentheses, calls, powers or signs are nested too deeply.
    #[error("the expression is nested more than {} levels deep", limits::DEPTH)]
    TooDeep,
    /// Length times nesting is too large.
    #[error("the expression is too long for the depth of its nesting")]
    TooIntricate,
    /// A number has too many digits.
    #[error("this number has {digits} digits, the limit is {}", limits::DIGITS)]
    TooManyDigits {
        /// The number of digits.
        digits: usize,
    },
    /// The exponent of a decimal number is too large.
    #[error("the exponent of this number lies beyond ±{}", limits::DECIMAL_EXPONENT)]
    DecimalExponent,
    /// A numeric exponent is too large.
    #[error("this exponent lies beyond ±{}", limits::EXPONENT)]
    Exponent,
    /// Folding gives a number with too many digits.
    #[error("the numbers here grow beyond {} digits", limits::DIGITS)]
    NumberTooLarge,
    /// The numbers together take too long to compute with.
    #[error("the numbers of this expression have too many digits in total")]
    NumberWork,
    /// Too many breakpoints.
    #[error("the expression has more than {} breakpoints", limits::BREAKPOINTS)]
    TooManyBreakpoints,
    /// A character that belongs to no token.
    #[error("{character} is not allowed here")]
    Character {
        /// The character as it can be shown, with its code point.
        character: String,
    },
    /// A malformed number.
    #[error("invalid number")]
    Number,
    /// The text ends where more input is expected.
    #[error("unexpected end of expression")]
    End,
    /// The text is empty.
    #[error("the expression is empty")]
    Empty,
    /// A token where another kind of token is expected.
    #[error("unexpected {found}")]
    Unexpected {
        /// The token.
        found: String,
    },
    /// Two operands without an operator between them.
    #[error("an operator is missing before {found}")]
    MissingOperator {
        /// The second operand's first token.
        found: String,
    },
    /// A parenthesis or bracket that is never closed.
    #[error("this {bracket} is never closed")]
    Unclosed {
        /// `(` or `[`.
        bracket: char,
    },
    /// A reserved name used as a parameter.
    #[error("{name} is a reserved name: {meaning}")]
    Reserved {
        /// The name.
        name: String,
        /// The meaning of the reserved name.
        meaning: &'static str,
    },
    /// A function's name without its arguments.
    #[error("{name} is a function and needs its arguments in parentheses")]
    FunctionWithoutArguments {
        /// The function.
        name: String,
    },
    /// A name before a parenthesis that is not a function.
    #[error("unknown function {name}")]
    UnknownFunction {
        /// The name.
        name: String,
    },
    /// The wrong number of arguments.
    #[error("{name} takes {expected}, got {found}")]
    Arguments {
        /// The function.
        name: String,
        /// The expected number of arguments, in words.
        expected: String,
        /// The number of arguments found.
        found: usize,
    },
    /// A name where a constant is expected.
    #[error("{name} is not a constant")]
    NotConstant {
        /// The name.
        name: String,
    },
    /// A part of the grammar that this kind of text may not use.
    #[error("{what} cannot be used in {place}")]
    NotHere {
        /// The part.
        what: &'static str,
        /// Where it was used.
        place: &'static str,
    },
    /// Division by zero.
    #[error("this divisor is 0")]
    DivisionByZero,
    /// 0 to a negative power.
    #[error("0 to a negative power has no value")]
    ZeroToNegative,
    /// A root or fractional power of a negative quantity.
    #[error("the base is negative, and its {power} is not real")]
    NegativeBase {
        /// `square root` or `fractional power`.
        power: &'static str,
    },
    /// An argument outside the domain of its function.
    #[error("{name} has no real value here")]
    Domain {
        /// The function.
        name: String,
    },
    /// An invalid condition of `piecewise`.
    #[error("this is not a condition of piecewise")]
    Condition,
    /// A condition that bounds its variable from below.
    #[error("a condition of piecewise must be an upper bound of its variable, such as r<b")]
    LowerBound,
    /// Conditions on different variables.
    #[error("this condition is on {found}, the others are on {expected}")]
    OtherVariable {
        /// The variable of the other conditions.
        expected: String,
        /// The variable of this one.
        found: String,
    },
    /// A breakpoint that depends on its own variable.
    #[error("this breakpoint contains {variable} itself")]
    BreakpointContainsVariable {
        /// The variable.
        variable: String,
    },
    /// A breakpoint that is zero or negative.
    #[error("this breakpoint is not positive")]
    BreakpointNotPositive,
    /// Breakpoints that do not increase.
    #[error("the breakpoints do not increase: this breakpoint is not above the previous one")]
    BreakpointsNotRising,
    /// Breakpoints of two piecewise expressions whose order is not known.
    #[error("two piecewise expressions meet here, and the order of their breakpoints {left} and {right} is not known")]
    UnknownOrder {
        /// One breakpoint, as typed.
        left: String,
        /// The other one.
        right: String,
    },
    /// Piecewise expressions in two variables that would have to be merged.
    #[error("piecewise expressions in different variables meet here")]
    MixedPieces,
    /// An integral inside a function, a power or another integral's factor.
    #[error("an integral is not allowed here")]
    IntegralInside,
}

/// A parse error: the place, the reason, and what was expected.
///
/// ```
/// use sneddon_expr::parse::{self, Reason};
/// let error = parse::profile("r^2/(2R)").unwrap_err();
/// assert_eq!(error.span(), 6..7);
/// assert!(matches!(error.reason(), Reason::MissingOperator { .. }));
/// assert_eq!(error.accepted(), "write r^2/(2*R)");
/// assert_eq!(error.to_string(), "an operator is missing before \"R\"; write r^2/(2*R)");
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{}; {}", .0.reason, .0.accepted)]
pub struct ParseError(Box<Details>);

#[derive(Debug, Clone, PartialEq, Eq)]
struct Details {
    span: Range<usize>,
    reason: Reason,
    accepted: String,
    repair: Option<Repair>,
}

impl ParseError {
    pub(super) fn new(span: Range<usize>, reason: Reason, accepted: impl Into<String>) -> Self {
        Self(Box::new(Details { span, reason, accepted: accepted.into(), repair: None }))
    }

    /// Adds the edit that repairs the text.
    pub(super) fn with_repair(mut self, repair: Repair) -> Self {
        self.0.repair = Some(repair);
        self
    }

    pub(super) fn repair(&self) -> Option<Repair> {
        self.0.repair
    }

    /// Replaces the advice.
    pub(super) fn advising(mut self, accepted: String) -> Self {
        self.0.accepted = accepted;
        self
    }

    /// The place, as a range of bytes of the text; empty at the end of the text.
    pub fn span(&self) -> Range<usize> {
        self.0.span.clone()
    }

    /// Why the text is not a valid expression.
    pub fn reason(&self) -> &Reason {
        &self.0.reason
    }

    /// What was expected, as a clause such as `write 2*r`.
    pub fn accepted(&self) -> &str {
        &self.0.accepted
    }
}

/// One edit of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Repair {
    /// A `*` between two factors.
    Insert {
        /// Where the second factor begins.
        at: usize,
    },
    /// Parentheses, with a `*` inside where two factors meet.
    Enclose { from: usize, to: usize, at: Option<usize> },
}
