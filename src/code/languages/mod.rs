//! The languages: a common walk that writes a program, and the syntax of every language.

mod c;
mod fortran;
mod matlab;
mod nanite;
mod python;
mod rust;

use super::program::{Language, Program};
use super::tree::{Comparison, Operator, Routine, Statement, Test, Value};

impl Language {
    /// Its name.
    pub fn title(self) -> &'static str {
        match self {
            Self::C => "C",
            Self::Fortran => "Fortran",
            Self::Python => "Python",
            Self::Matlab => "MATLAB",
            Self::Rust => "Rust",
            Self::Nanite => "Python for nanite",
        }
    }

    pub(super) fn target(self) -> &'static dyn Target {
        match self {
            Self::C => &c::C,
            Self::Fortran => &fortran::Fortran,
            Self::Python | Self::Nanite => &python::Python,
            Self::Matlab => &matlab::Matlab,
            Self::Rust => &rust::Rust,
        }
    }
}

/// The program as a file.
pub fn write(program: &Program) -> String {
    match program.language {
        Language::Nanite => nanite::file(program),
        other => other.target().file(program),
    }
}

/// The syntax of tests and blocks.
pub(super) struct Words {
    pub(super) comment: &'static str,
    pub(super) when: (&'static str, &'static str),
    pub(super) otherwise: &'static str,
    pub(super) end_when: &'static str,
    pub(super) during: (&'static str, &'static str),
    pub(super) end_during: &'static str,
    pub(super) both: &'static str,
    pub(super) either: &'static str,
    pub(super) not: &'static str,
}

/// A language.
pub(super) trait Target: Sync {
    /// Its syntax.
    fn words(&self) -> Words;
    /// A literal.
    fn number(&self, value: f64) -> String;
    /// A call of an elementary function, of the library, or of a routine.
    fn call(&self, name: &str, arguments: &[String]) -> String;
    /// The name under which a routine appears.
    fn spelled(&self, routine: &str) -> String;
    /// Whether a word cannot be the name of a variable; in lower case where the language ignores case.
    fn is_reserved(&self, word: &str) -> bool;
    fn ignores_case(&self) -> bool {
        false
    }
    /// The name of a function of the table in the library, and its accuracy in ulps.
    fn library(&self, _name: &str) -> Option<(&'static str, f64)> {
        None
    }
    fn declare(&self, name: &str, value: &str, changes: bool) -> String;
    /// A new array of zeros; empty if arrays are declared at the beginning.
    fn array(&self, name: &str) -> String;
    /// What precedes and follows the numbers of a constant array with this many elements, and what continues a line.
    fn table(&self, name: &str, count: usize) -> (String, &'static str, &'static str);
    fn element(&self, name: &str, index: &str) -> String;
    fn assign(&self, name: &str, value: &str) -> String;
    /// The lines that return a value.
    fn give(&self, value: &str) -> Vec<String>;
    /// The whole file.
    fn file(&self, program: &Program) -> String;
}

/// Spaces of one level.
const INDENT: &str = "    ";
/// Numbers of a table in one line.
const PER_LINE: usize = 4;
/// Maximum width of comments.
const WIDTH: usize = 110;

/// A value in the syntax of a language.
pub(super) fn value(own: &Value, target: &dyn Target) -> String {
    match own {
        Value::Number(number, _) => target.number(*number),
        Value::Name(name) => name.clone(),
        Value::Element(name, index) => target.element(name, &value(index, target)),
        Value::Call(name, arguments) => {
            let arguments: Vec<String> = arguments.iter().map(|own| value(own, target)).collect();
            target.call(name, &arguments)
        }
        Value::Binary(Operator::Subtract, left, right) if **left == Value::Number(0.0, true) => {
            format!("-{}", operand(right, target))
        }
        Value::Binary(operator, left, right) => {
            let product = matches!(operator, Operator::Multiply | Operator::Divide);
            let sign = match operator {
                Operator::Add => " + ",
                Operator::Subtract => " - ",
                Operator::Multiply => "*",
                Operator::Divide => "/",
            };
            // A left operand of equal rank needs no parentheses; a right one does, because the order of operations affects the
            // accuracy.
            let left = if rank(left) > 0 && (rank(left) == 2 || !product) { value(left, target) } else { operand(left, target) };
            let right = if !product && matches!(**right, Value::Binary(Operator::Multiply | Operator::Divide, ..)) {
                value(right, target)
            } else {
                operand(right, target)
            };
            format!("{left}{sign}{right}")
        }
    }
}

/// 2 for products and atoms, 1 for sums, 0 for negatives and other values that always need parentheses.
fn rank(own: &Value) -> u8 {
    match own {
        Value::Binary(Operator::Subtract, left, _) if **left == Value::Number(0.0, true) => 0,
        Value::Binary(Operator::Multiply | Operator::Divide, ..) => 2,
        Value::Binary(..) => 1,
        Value::Number(number, _) if *number < 0.0 => 0,
        _ => 2,
    }
}

fn operand(own: &Value, target: &dyn Target) -> String {
    let text = value(own, target);
    let bare = match own {
        Value::Binary(..) => false,
        Value::Number(number, _) => *number >= 0.0,
        _ => true,
    };
    if bare { text } else { format!("({text})") }
}

fn test(own: &Test, target: &dyn Target) -> String {
    let words = target.words();
    let joined = |list: &[Test], word: &str| {
        let parts: Vec<String> = list
            .iter()
            .map(|own| match own {
                Test::All(_) | Test::Any(_) => format!("({})", test(own, target)),
                _ => test(own, target),
            })
            .collect();
        parts.join(word)
    };
    match own {
        Test::Compare(comparison, left, right) => {
            let sign = match comparison {
                Comparison::Less => "<",
                Comparison::LessOrEqual => "<=",
                Comparison::Greater => ">",
                Comparison::GreaterOrEqual => ">=",
                Comparison::Equal => "==",
            };
            format!("{} {sign} {}", value(left, target), value(right, target))
        }
        Test::All(list) => joined(list, words.both),
        Test::Any(list) => joined(list, words.either),
        Test::Not(own) => format!("{}({})", words.not, test(own, target)),
    }
}

/// The statements of a routine at a level of indentation.
pub(super) fn block(list: &[Statement], level: usize, changed: &[String], target: &dyn Target) -> String {
    let (words, space) = (target.words(), INDENT.repeat(level));
    let mut text = String::new();
    let mut line = |own: &str| {
        if !own.is_empty() {
            text.push_str(&format!("{space}{own}\n"));
        }
    };
    for own in list {
        match own {
            Statement::Let(name, own) => line(&target.declare(name, &value(own, target), changed.contains(name))),
            Statement::Set(name, own) => line(&target.assign(name, &value(own, target))),
            Statement::Array(name) => line(&target.array(name)),
            Statement::Table(name, values) => {
                let (begin, end, continued) = target.table(name, values.len());
                line(&format!("{begin}{continued}"));
                let rows: Vec<String> =
                    values.chunks(PER_LINE).map(|row| row.iter().map(|own| target.number(*own)).collect::<Vec<_>>().join(", ")).collect();
                for (index, row) in rows.iter().enumerate() {
                    let comma = if index + 1 < rows.len() { "," } else { "" };
                    line(&format!("{INDENT}{row}{comma}{continued}"));
                }
                line(end);
            }
            Statement::SetElement(name, index, own) => {
                line(&target.assign(&target.element(name, &value(index, target)), &value(own, target)))
            }
            Statement::Return(own) => target.give(&value(own, target)).iter().for_each(|own| line(own)),
            // Python rejects a block without statements.
            own if own.is_idle() => {}
            Statement::If(condition, yes, no) => {
                line(&format!("{}{}{}", words.when.0, test(condition, target), words.when.1));
                let inner = block(yes, level + 1, changed, target);
                line_block(&mut line, &inner, &space);
                if !no.is_empty() {
                    line(words.otherwise);
                    let inner = block(no, level + 1, changed, target);
                    line_block(&mut line, &inner, &space);
                }
                line(words.end_when);
            }
            Statement::While(condition, body) => {
                line(&format!("{}{}{}", words.during.0, test(condition, target), words.during.1));
                let inner = block(body, level + 1, changed, target);
                line_block(&mut line, &inner, &space);
                line(words.end_during);
            }
        }
    }
    text
}

/// Lines that are already indented.
fn line_block(line: &mut impl FnMut(&str), inner: &str, space: &str) {
    for own in inner.lines() {
        line(own.strip_prefix(space).unwrap_or(own));
    }
}

/// Comment lines, wrapped at spaces; their text cannot end the comment.
pub(super) fn comment(lines: &[String], mark: &str) -> String {
    let mut text = String::new();
    for own in lines {
        // A backslash at the end of a line would join the next one to the comment.
        let plain: String = own.chars().map(|c| if c.is_control() || c == '\\' || is_turning(c) { ' ' } else { c }).collect();
        let mut line = String::new();
        for word in plain.split_whitespace() {
            if !line.is_empty() && line.chars().count() + word.chars().count() >= WIDTH {
                text.push_str(&format!("{mark}{line}\n"));
                line = "   ".to_owned();
            }
            if !line.trim().is_empty() {
                line.push(' ');
            }
            line.push_str(word);
        }
        text.push_str(&format!("{mark}{line}\n"));
    }
    text
}

/// Bidirectional formatting characters, and line separators that are not control characters.
fn is_turning(c: char) -> bool {
    matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// The header of a file.
pub(super) fn head(program: &Program) -> Vec<String> {
    let mut lines = vec![
        format!("Contact of a rigid axisymmetric indenter with the shape f(r) = {}.", program.profile),
        format!(
            "Written by sneddon {} from closed forms of g and F, with operations in an order that avoids cancellation.",
            env!("CARGO_PKG_VERSION")
        ),
    ];
    let renamed: Vec<String> =
        program.parameters.iter().filter(|(symbol, own)| symbol != own).map(|(symbol, own)| format!("{own} is {symbol}")).collect();
    if !renamed.is_empty() {
        lines.push(format!("Names: {}.", renamed.join(", ")));
    }
    lines
}

/// A routine's parameters and body.
pub(super) fn parts(routine: &Routine, target: &dyn Target) -> (String, String) {
    (routine.parameters.join(", "), block(&routine.body, 1, &routine.changed(), target))
}

/// The digits of a literal that is a whole number.
pub(super) fn whole(literal: &str) -> Option<&str> {
    let digits = literal.strip_suffix("_dp").unwrap_or(literal).strip_suffix(".0")?;
    digits.bytes().all(|own| own.is_ascii_digit()).then_some(digits)
}

/// A decimal literal that reads back as the same double.
pub(super) fn decimal(value: f64) -> String {
    format!("{value:?}")
}
