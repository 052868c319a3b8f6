//! Bytes to tokens, one at a time.

use super::alphabet::{describe, greek, instead_of, raised};
use super::{ParseError, Reason, limits};
use crate::expr::Number;
use std::ops::Range;

/// One token.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Token {
    Number(Number),
    /// A name with Greek letters spelled out.
    Name(String),
    Plus,
    Minus,
    Times,
    Divide,
    Caret,
    Open,
    Close,
    OpenList,
    CloseList,
    Comma,
    /// `<` or `<=`.
    Below,
    /// `>` or `>=`.
    Above,
    End,
}

impl Token {
    /// True if an operand can begin with this token.
    pub(super) fn begins_operand(&self) -> bool {
        matches!(self, Self::Number(_) | Self::Name(_) | Self::Open | Self::OpenList)
    }
}

/// The tokens of a text, with the budget for long numbers.
pub(super) struct Lexer<'t> {
    text: &'t str,
    at: usize,
    /// The pending tokens of a character that expands to several, in reverse order, with the span of the character.
    pending: Vec<(Token, Range<usize>)>,
    number_work: u64,
}

impl<'t> Lexer<'t> {
    /// Starts reading tokens at a byte offset of the text.
    pub(super) fn from(text: &'t str, at: usize) -> Result<Self, ParseError> {
        if text.len() > limits::TEXT_BYTES {
            let end = text.char_indices().map(|(at, _)| at).find(|at| *at >= limits::TEXT_BYTES).unwrap_or(text.len());
            let reason = Reason::TextTooLong { bytes: text.len() };
            return Err(ParseError::new(end..text.len(), reason, "expected a shorter expression"));
        }
        Ok(Self { text, at, pending: Vec::new(), number_work: 0 })
    }

    /// The whole text.
    pub(super) fn text(&self) -> &'t str {
        self.text
    }

    /// The text of a span.
    pub(super) fn slice(&self, span: Range<usize>) -> &'t str {
        self.text.get(span).unwrap_or("")
    }

    /// The next token and its place.
    pub(super) fn next(&mut self) -> Result<(Token, Range<usize>), ParseError> {
        if let Some(token) = self.pending.pop() {
            return Ok(token);
        }
        let rest = self.slice(self.at..self.text.len());
        let start = self.text.len() - rest.trim_start().len();
        let mut characters = self.slice(start..self.text.len()).chars();
        let Some(first) = characters.next() else {
            self.at = self.text.len();
            return Ok((Token::End, self.at..self.at));
        };
        let second = characters.next();
        self.at = start + first.len_utf8();
        let token = match first {
            '0'..='9' | '.' => return self.number(start),
            _ if first.is_ascii_alphabetic() || greek(first).is_some() => return Ok(self.name(start)),
            '+' => Token::Plus,
            '-' | '−' => Token::Minus,
            '*' if second == Some('*') => {
                return Err(self.unknown(start..start + 2, "\"**\"".into(), "write a power with ^, as in r^2"));
            }
            '*' | '·' | '⋅' | '×' => Token::Times,
            '/' => Token::Divide,
            '^' => Token::Caret,
            '√' => return self.root(start),
            _ if raised(first).is_some() => return self.raised(start),
            '(' => Token::Open,
            ')' => Token::Close,
            '[' => Token::OpenList,
            ']' => Token::CloseList,
            ',' => Token::Comma,
            '<' | '>' => {
                if second == Some('=') {
                    self.at += 1;
                }
                if first == '<' { Token::Below } else { Token::Above }
            }
            other => return Err(self.unknown(start..self.at, describe(other), instead_of(other))),
        };
        Ok((token, start..self.at))
    }

    fn unknown(&self, span: Range<usize>, character: String, accepted: &str) -> ParseError {
        ParseError::new(span, Reason::Character { character }, accepted)
    }

    /// `²` for `^2`, `⁻¹` for `^-1`: a caret followed by the exponent.
    fn raised(&mut self, start: usize) -> Result<(Token, Range<usize>), ParseError> {
        let rest = self.slice(start..self.text.len());
        let length = rest.find(|c| raised(c).is_none()).unwrap_or(rest.len());
        let (span, text) =
            (start..start + length, rest.chars().take_while(|c| raised(*c).is_some()).filter_map(raised).collect::<String>());
        self.at = span.end;
        let (negative, digits) = text.strip_prefix('-').map_or((false, text.as_str()), |digits| (true, digits));
        let exponent = match digits {
            "n" => Token::Name("n".to_owned()),
            _ if digits.len() <= 9 => match Number::parse_decimal(digits).filter(|_| digits.bytes().all(|byte| byte.is_ascii_digit())) {
                Some(number) => Token::Number(number),
                None => return Err(self.unknown(span.clone(), format!("{:?}", self.slice(span)), "write a power with ^, as in r^2")),
            },
            _ => return Err(self.unknown(span.clone(), format!("{:?}", self.slice(span)), "write a power with ^, as in r^2")),
        };
        self.pending.push((exponent, span.clone()));
        if negative {
            self.pending.push((Token::Minus, span.clone()));
        }
        Ok((Token::Caret, span))
    }

    /// `√(…)`, or `√2` and `√R` where nothing behind could belong under the root as well.
    fn root(&mut self, start: usize) -> Result<(Token, Range<usize>), ParseError> {
        const WRITE: &str = "write the argument of the root in parentheses, as in sqrt(r)";
        let sign = start..self.at;
        let call = Token::Name("sqrt".to_owned());
        if self.slice(self.at..self.text.len()).trim_start().starts_with('(') {
            return Ok((call, sign));
        }
        // A root of a root needs its parentheses; so no run of signs nests calls of this function.
        if self.slice(self.at..self.text.len()).trim_start().starts_with('√') {
            return Err(self.unknown(sign, describe('√'), WRITE));
        }
        let (operand, span) = self.next()?;
        let behind = self.slice(self.at..self.text.len()).trim_start().chars().next();
        let ends = behind.is_none_or(|c| !c.is_alphanumeric() && greek(c).is_none() && raised(c).is_none() && !"^(√_.".contains(c));
        if !ends || !matches!(operand, Token::Number(_) | Token::Name(_)) {
            return Err(self.unknown(sign, describe('√'), WRITE));
        }
        let end = span.end..span.end;
        self.pending.extend([(Token::Close, end), (operand, span.clone()), (Token::Open, span.start..span.start)]);
        Ok((call, sign))
    }

    fn name(&mut self, start: usize) -> (Token, Range<usize>) {
        let mut name = String::new();
        self.at = self.text.len();
        for (offset, character) in self.slice(start..self.text.len()).char_indices() {
            match greek(character) {
                Some(letter) => name.push_str(letter),
                None if character.is_ascii_alphanumeric() || character == '_' => name.push(character),
                None => {
                    self.at = start + offset;
                    break;
                }
            }
        }
        (Token::Name(name), start..self.at)
    }

    fn number(&mut self, start: usize) -> Result<(Token, Range<usize>), ParseError> {
        let bytes = self.text.as_bytes();
        let is_digit = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_digit);
        let digits_from = |mut at: usize| {
            while is_digit(at) {
                at += 1;
            }
            at
        };
        let mut end = digits_from(start);
        let mut digits = end - start;
        if bytes.get(end) == Some(&b'.') {
            let fraction = end + 1;
            end = digits_from(fraction);
            digits += end - fraction;
        }
        if digits == 0 || bytes.get(end) == Some(&b'.') {
            return Err(ParseError::new(start..end.max(start + 1), Reason::Number, "a number has digits and at most one point, as in 0.3"));
        }
        let mut exponent = 0..0;
        if matches!(bytes.get(end), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
            // `2e` without digits is the number 2 before the constant e; the parser reports the missing operator.
            if is_digit(end + 1 + sign) {
                let last = digits_from(end + 1 + sign);
                exponent = end + 1..last;
                end = last;
            }
        }
        self.at = end;
        let span = start..end;
        if digits > limits::DIGITS {
            let accepted = "expected a number with fewer digits, or an exponent as in 1e-6";
            return Err(ParseError::new(span, Reason::TooManyDigits { digits }, accepted));
        }
        let magnitude = match self.slice(exponent.clone()).parse::<i64>() {
            Ok(value) => value.saturating_abs(),
            Err(_) if exponent.is_empty() => 0,
            Err(_) => i64::MAX,
        };
        if magnitude > limits::DECIMAL_EXPONENT {
            return Err(ParseError::new(span, Reason::DecimalExponent, "expected a smaller exponent, as in 1e-6"));
        }
        let words = (digits as u64 + magnitude.unsigned_abs()) / 19 + 1;
        self.number_work += words * words;
        if self.number_work > limits::NUMBER_WORK {
            return Err(ParseError::new(span, Reason::NumberWork, "expected fewer or shorter numbers"));
        }
        match Number::parse_decimal(self.slice(span.clone())) {
            Some(number) => Ok((Token::Number(number), span)),
            None => Err(ParseError::new(span, Reason::Number, "expected a number such as 3, 0.3 or 1e-6")),
        }
    }
}
