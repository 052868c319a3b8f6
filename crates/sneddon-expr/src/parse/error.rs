//! What can go wrong while text is read: the place, the reason, and what would be accepted.

use super::limits;
use std::ops::Range;
use thiserror::Error;

/// Why a text is no expression.
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
        /// How many it has.
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
    /// All numbers together take too long to compute with.
    #[error("the numbers of this expression are too long, all together")]
    NumberWork,
    /// Too many breakpoints.
    #[error("the expression has more than {} breakpoints", limits::BREAKPOINTS)]
    TooManyBreakpoints,
    /// A character that belongs to no token.
    #[error("the character {character} is not known here")]
    Character {
        /// The character as it can be shown, with its code point.
        character: String,
    },
    /// A number that is written wrongly.
    #[error("this is no number")]
    Number,
    /// The text ends too soon.
    #[error("the expression ends too soon")]
    End,
    /// The text is empty.
    #[error("there is no expression")]
    Empty,
    /// A token where something else must stand.
    #[error("{found} cannot stand here")]
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
    /// A name with a meaning of its own, used as a parameter.
    #[error("{name} is a reserved name: {meaning}")]
    Reserved {
        /// The name.
        name: String,
        /// What it stands for.
        meaning: &'static str,
    },
    /// A function's name without its arguments.
    #[error("{name} is a function and needs its arguments in parentheses")]
    FunctionWithoutArguments {
        /// The function.
        name: String,
    },
    /// A name before a parenthesis that is no function.
    #[error("there is no function {name}")]
    UnknownFunction {
        /// The name.
        name: String,
    },
    /// The wrong number of arguments.
    #[error("{name} takes {expected}, here it has {found}")]
    Arguments {
        /// The function.
        name: String,
        /// How many it takes, in words.
        expected: String,
        /// How many it has.
        found: usize,
    },
    /// A name where only a constant may stand.
    #[error("{name} is no constant")]
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
    /// A root or broken power of something negative.
    #[error("the base is negative, and its {power} is not real")]
    NegativeBase {
        /// `square root` or `broken power`.
        power: &'static str,
    },
    /// An argument outside the domain of its function.
    #[error("{name} has no real value here")]
    Domain {
        /// The function.
        name: String,
    },
    /// A condition of `piecewise` that is none.
    #[error("this is no condition of piecewise")]
    Condition,
    /// A condition that compares downwards.
    #[error("conditions of piecewise bound their variable from above")]
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
    /// Breakpoints that do not rise.
    #[error("the breakpoints do not rise: this one is not above the one before")]
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
    #[error("an integral cannot stand here")]
    IntegralInside,
}

/// A text that could not be read: where, why, and what would be accepted.
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

    /// The same with the edit of the text that it calls for.
    pub(super) fn with_repair(mut self, repair: Repair) -> Self {
        self.0.repair = Some(repair);
        self
    }

    pub(super) fn repair(&self) -> Option<Repair> {
        self.0.repair
    }

    /// The same with other advice.
    pub(super) fn advising(mut self, accepted: String) -> Self {
        self.0.accepted = accepted;
        self
    }

    /// The place, as a range of bytes of the text; empty at the end of the text.
    pub fn span(&self) -> Range<usize> {
        self.0.span.clone()
    }

    /// Why the text is no expression.
    pub fn reason(&self) -> &Reason {
        &self.0.reason
    }

    /// What would be accepted instead, as a clause such as `write 2*r`.
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
