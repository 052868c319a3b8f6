//! Tokens to what was typed: operator precedence with an explicit stack, which counts the depth of nesting.

use super::error::Repair;
use super::lexer::{Lexer, Token};
use super::lower::is_function;
use super::syntax::{Item, Kind};
use super::{ParseError, Reason, limits};
use std::ops::Range;

/// Reads a whole text as one expression.
///
/// The text may begin with a left-hand side such as `f(r) =`, as the program prints it.
pub(super) fn parse(text: &str, left: Option<Left>) -> Result<Vec<Item>, ParseError> {
    let mut lexer = Lexer::from(text, left.map_or(0, |left| left.length(text)))?;
    let (token, span) = lexer.next()?;
    if token == Token::End {
        return Err(ParseError::new(0..text.len(), Reason::Empty, "expected an expression such as r^2/(2*R)"));
    }
    let mut parser = Parser { lexer, token, span, last: 0..0, open: Vec::new(), depth: 0, nested_bytes: 0, items: Vec::new() };
    loop {
        parser.operand()?;
        if parser.operator()? {
            return Ok(parser.items);
        }
    }
}

/// The optional left-hand side of an equation: a function's name and its variable.
#[derive(Debug, Clone, Copy)]
pub(super) struct Left(pub(super) &'static str, pub(super) &'static str);

impl Left {
    /// The length in bytes of `f(r) =` or `f =` at the beginning of a text; 0 if the text begins with neither.
    fn length(self, text: &str) -> usize {
        let Some(rest) = text.trim_start().strip_prefix(self.0) else { return 0 };
        let rest = rest.trim_start();
        let behind = rest.strip_prefix('(').and_then(|rest| rest.trim_start().strip_prefix(self.1)?.trim_start().strip_prefix(')'));
        let Some(right) = behind.unwrap_or(rest).trim_start().strip_prefix('=') else { return 0 };
        text.len() - right.len()
    }
}

/// An incomplete construct that waits for its last operand.
struct Frame {
    kind: Waiting,
    start: usize,
}

enum Waiting {
    Sum(Vec<bool>),
    Product(Vec<bool>),
    Power,
    /// A sign; a tight sign is an operand of a product or power and does not extend over a product: 2/-r*3 is (2/(−r))·3.
    Sign {
        negative: bool,
        tight: bool,
    },
    Parenthesis,
    Call {
        name: String,
        name_span: Range<usize>,
        done: usize,
        comparison: Option<Comparison>,
    },
    List {
        done: usize,
    },
}

struct Comparison {
    reversed: bool,
    start: usize,
}

/// How tightly the operator after an operand binds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Nothing,
    Sum,
    Product,
}

const OPERAND: &str = "expected a number, a name, a function or (";

struct Parser<'t> {
    lexer: Lexer<'t>,
    token: Token,
    span: Range<usize>,
    /// The place of the last complete operand.
    last: Range<usize>,
    open: Vec<Frame>,
    depth: usize,
    nested_bytes: usize,
    items: Vec<Item>,
}

impl Parser<'_> {
    fn advance(&mut self) -> Result<(Token, Range<usize>), ParseError> {
        let (token, span) = self.lexer.next()?;
        Ok((std::mem::replace(&mut self.token, token), std::mem::replace(&mut self.span, span)))
    }

    fn emit(&mut self, kind: Kind, span: Range<usize>) {
        self.last = span.clone();
        self.items.push(Item { kind, span });
    }

    /// Begins a level of nesting.
    fn deepen(&mut self, kind: Waiting, start: usize, at: Range<usize>) -> Result<(), ParseError> {
        self.depth += 1;
        if self.depth > limits::DEPTH {
            return Err(ParseError::new(at, Reason::TooDeep, "expected fewer nested parentheses, calls, powers or signs"));
        }
        self.open.push(Frame { kind, start });
        Ok(())
    }

    /// Ends a level of nesting.
    fn rise(&mut self, kind: Kind, span: Range<usize>) -> Result<(), ParseError> {
        self.depth -= 1;
        // Later stages take time proportional to this sum, because every level processes everything inside it.
        self.nested_bytes += span.len();
        if self.nested_bytes > limits::NESTED_BYTES {
            return Err(ParseError::new(span, Reason::TooIntricate, "expected a shorter or less nested expression"));
        }
        self.emit(kind, span);
        Ok(())
    }

    /// Reads up to the end of the next number, name or empty argument list, opening signs, parentheses and calls on the way.
    fn operand(&mut self) -> Result<(), ParseError> {
        loop {
            match self.token {
                Token::Plus | Token::Minus => {
                    let (sign, at) = self.advance()?;
                    let top = self.open.last().map(|frame| &frame.kind);
                    let tight = matches!(top, Some(Waiting::Product(_) | Waiting::Power | Waiting::Sign { tight: true, .. }));
                    self.deepen(Waiting::Sign { negative: sign == Token::Minus, tight }, at.start, at)?;
                }
                Token::Open => {
                    let (_, at) = self.advance()?;
                    self.deepen(Waiting::Parenthesis, at.start, at)?;
                }
                Token::OpenList if self.begins_argument() => {
                    let (_, at) = self.advance()?;
                    self.deepen(Waiting::List { done: 0 }, at.start, at)?;
                    if self.token == Token::CloseList {
                        return Ok(());
                    }
                }
                Token::Number(_) | Token::Name(_) => match self.advance()? {
                    (Token::Number(number), span) => {
                        self.emit(Kind::Number(number), span);
                        return Ok(());
                    }
                    (Token::Name(name), span) if self.token == Token::Open => {
                        let (_, at) = self.advance()?;
                        let (start, at) = (span.start, span.start..at.end);
                        self.deepen(Waiting::Call { name, name_span: span, done: 0, comparison: None }, start, at)?;
                        if self.token == Token::Close {
                            return Ok(());
                        }
                    }
                    (Token::Name(name), span) => {
                        self.emit(Kind::Name(name), span);
                        return Ok(());
                    }
                    _ => return Err(self.unexpected()),
                },
                _ => return Err(self.unexpected()),
            }
        }
    }

    /// True at the beginning of an argument of a call.
    fn begins_argument(&self) -> bool {
        matches!(self.open.last(), Some(Frame { kind: Waiting::Call { comparison: None, .. }, .. }))
    }

    /// Reads what follows an operand; true at the end of the text, false where another operand must follow.
    fn operator(&mut self) -> Result<bool, ParseError> {
        loop {
            match self.token {
                Token::Caret => {
                    let start = self.last.start;
                    let (_, at) = self.advance()?;
                    self.deepen(Waiting::Power, start, at)?;
                    return Ok(false);
                }
                Token::Times | Token::Divide => {
                    self.reduce(Binding::Product)?;
                    let divides = self.advance()?.0 == Token::Divide;
                    match self.open.last_mut() {
                        Some(Frame { kind: Waiting::Product(factors), .. }) => factors.push(divides),
                        _ => self.open.push(Frame { kind: Waiting::Product(vec![false, divides]), start: self.last.start }),
                    }
                    return Ok(false);
                }
                Token::Plus | Token::Minus => {
                    self.reduce(Binding::Sum)?;
                    let subtracted = self.advance()?.0 == Token::Minus;
                    match self.open.last_mut() {
                        Some(Frame { kind: Waiting::Sum(terms), .. }) => terms.push(subtracted),
                        _ => self.open.push(Frame { kind: Waiting::Sum(vec![false, subtracted]), start: self.last.start }),
                    }
                    return Ok(false);
                }
                _ if self.token.begins_operand() => return Err(self.missing_operator()),
                Token::Close | Token::CloseList => {
                    self.reduce(Binding::Nothing)?;
                    self.close()?;
                }
                Token::Comma | Token::Below | Token::Above => {
                    self.reduce(Binding::Nothing)?;
                    self.separate()?;
                    return Ok(false);
                }
                _ => {
                    self.reduce(Binding::Nothing)?;
                    return self.end().map(|()| true);
                }
            }
        }
    }

    /// Completes every operator that binds its operand more tightly than what follows.
    fn reduce(&mut self, next: Binding) -> Result<(), ParseError> {
        while let Some(frame) = self.open.pop() {
            let span = frame.start..self.last.end;
            match frame.kind {
                Waiting::Power => self.rise(Kind::Power, span)?,
                Waiting::Sign { negative, tight } if tight || next < Binding::Product => {
                    self.rise(if negative { Kind::Negation } else { Kind::Group }, span)?;
                }
                Waiting::Product(factors) if next < Binding::Product => self.emit(Kind::Product(factors), span),
                Waiting::Sum(terms) if next < Binding::Sum => self.emit(Kind::Sum(terms), span),
                kind => {
                    self.open.push(Frame { kind, start: frame.start });
                    break;
                }
            }
        }
        Ok(())
    }

    /// Closes a parenthesis, a call or a list.
    fn close(&mut self) -> Result<(), ParseError> {
        let span = self.open.last().map_or(0, |frame| frame.start)..self.span.end;
        // An empty list of arguments closes right after it was opened: nothing has been read since.
        let one_more = |done: usize, last: &Range<usize>| done + usize::from(done > 0 || last.start >= span.start && last.end > span.start);
        let kind = match (self.open.pop().map(|frame| frame.kind), &self.token) {
            (Some(Waiting::Parenthesis), Token::Close) => Kind::Group,
            (Some(Waiting::Call { name, name_span, done, comparison }), Token::Close) => {
                self.compare(comparison);
                Kind::Call { name, name_span, arguments: one_more(done, &self.last) }
            }
            (Some(Waiting::List { done }), Token::CloseList) => Kind::List(one_more(done, &self.last)),
            _ => return Err(self.unexpected()),
        };
        self.advance()?;
        self.rise(kind, span)
    }

    /// Reads a comma between arguments, or a comparison inside one.
    fn separate(&mut self) -> Result<(), ParseError> {
        let start = self.last.start;
        let mut finished = None;
        match (self.open.last_mut().map(|frame| &mut frame.kind), &self.token) {
            (Some(Waiting::Call { done, comparison, .. }), Token::Comma) => {
                *done += 1;
                finished = comparison.take();
            }
            (Some(Waiting::List { done }), Token::Comma) => *done += 1,
            (Some(Waiting::Call { comparison: comparison @ None, .. }), Token::Below | Token::Above) => {
                *comparison = Some(Comparison { reversed: self.token == Token::Above, start });
            }
            _ => return Err(self.unexpected()),
        }
        self.compare(finished);
        self.advance().map(drop)
    }

    fn compare(&mut self, comparison: Option<Comparison>) {
        if let Some(Comparison { reversed, start }) = comparison {
            self.emit(Kind::Comparison(reversed), start..self.last.end);
        }
    }

    fn end(&self) -> Result<(), ParseError> {
        let Some(frame) = self.open.last() else { return Ok(()) };
        let (span, bracket, accepted) = match &frame.kind {
            Waiting::Call { name_span, .. } => (name_span.clone(), '(', "close it with )"),
            Waiting::List { .. } => (frame.start..frame.start + 1, '[', "close it with ]"),
            _ => (frame.start..frame.start + 1, '(', "close it with )"),
        };
        Err(ParseError::new(span, Reason::Unclosed { bracket }, accepted))
    }

    /// True within parentheses that are an argument of `piecewise`, as SymPy writes its pairs of value and condition.
    fn is_a_pair_of_piecewise(&self) -> bool {
        let mut frames =
            self.open.iter().rev().map(|own| &own.kind).filter(|own| matches!(own, Waiting::Parenthesis | Waiting::Call { .. }));
        let inner = frames.next();
        matches!(inner, Some(Waiting::Parenthesis)) && matches!(frames.next(), Some(Waiting::Call { name, .. }) if name == "piecewise")
    }

    fn unexpected(&self) -> ParseError {
        let accepted = match self.token {
            Token::End => return ParseError::new(self.span.clone(), Reason::End, OPERAND),
            Token::Close | Token::CloseList if self.open.is_empty() => "remove it, or open it first",
            Token::Comma if self.is_a_pair_of_piecewise() => {
                "write piecewise(v0, r<b, v1): without parentheses around a pair, and the last value without a condition"
            }
            Token::Comma => "write decimals with a point, as in 0.3; commas separate the arguments of a function",
            Token::Below | Token::Above => {
                "conditions such as r<b are allowed only between the values of piecewise(v0, r<b, v1), one comparison each"
            }
            Token::OpenList => "lists are allowed only in hyper([a], [b], z)",
            _ => OPERAND,
        };
        let found = format!("{:?}", self.lexer.slice(self.span.clone()));
        ParseError::new(self.span.clone(), Reason::Unexpected { found }, accepted)
    }

    /// Two operands side by side: the advice spells out the corrected text, so that it can be followed literally.
    fn missing_operator(&self) -> ParseError {
        let (first, second) = (self.lexer.slice(self.last.clone()), self.lexer.slice(self.span.clone()));
        let reason = Reason::MissingOperator { found: format!("{second:?}") };
        let error = |repair: Repair| {
            let local = repair.local(self.lexer.text(), &self.last, &self.span);
            ParseError::new(self.span.clone(), reason.clone(), local).with_repair(repair)
        };
        let end = group_end(self.lexer.text(), self.span.start);
        if is_function(first) {
            return error(Repair::Enclose { from: self.span.start, to: end, at: None });
        }
        // The divisor, with the powers and signs that are open in it.
        let mut start = self.last.start;
        let mut frames = self.open.iter().rev();
        let product = loop {
            match frames.next() {
                Some(Frame { kind: Waiting::Power | Waiting::Sign { tight: true, .. }, start: begun }) => start = *begun,
                Some(Frame { kind: Waiting::Product(divides), start: begun }) => break Some((divides, *begun)),
                _ => break None,
            }
        };
        let at = self.span.start;
        match product {
            Some((divides, begun)) if divides.last() == Some(&true) => {
                let above = self.lexer.slice(begun..start).trim_end().trim_end_matches('/').trim_end();
                let is_number = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
                let apart = self.last.end < at;
                // 1/2 r^2 means (1/2)·r^2: a fraction of numbers multiplies the factor after it.
                if is_number(above) && is_number(first) && (apart || second == "r" || second == "x") {
                    return error(Repair::Insert { at });
                }
                error(Repair::Enclose { from: start, to: end, at: Some(at) })
            }
            _ => error(Repair::Insert { at }),
        }
    }
}

/// Where a run of factors side by side ends: at the next operator, comma or closing parenthesis.
fn group_end(text: &str, from: usize) -> usize {
    let Ok(mut lexer) = Lexer::from(text, from) else { return text.len() };
    let (mut depth, mut end, mut raised) = (0_usize, from, false);
    while let Ok((token, span)) = lexer.next() {
        match token {
            Token::End => break,
            Token::Open | Token::OpenList => depth += 1,
            Token::Close | Token::CloseList if depth == 0 => break,
            Token::Close | Token::CloseList => depth -= 1,
            Token::Plus | Token::Minus if depth == 0 && !raised => break,
            Token::Times | Token::Divide | Token::Comma | Token::Below | Token::Above if depth == 0 => break,
            _ => {}
        }
        raised = token == Token::Caret;
        end = span.end.max(end);
    }
    end
}
