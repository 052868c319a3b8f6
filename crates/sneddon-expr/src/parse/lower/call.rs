//! Calls: functions of the table by name, alternative spellings, and special forms such as `piecewise` and `integral`.

use super::super::{ParseError, Reason};
use super::{Lowering, Names, Operand, Value};
use crate::expr::{Expr, Formula, Function, has_value};
use std::ops::Range;

impl Lowering<'_> {
    pub(super) fn call(
        &mut self,
        name: &str,
        name_span: &Range<usize>,
        arguments: Vec<Operand>,
        span: &Range<usize>,
    ) -> Result<Formula, ParseError> {
        match (name, arguments.len()) {
            ("piecewise", _) => self.piecewise(arguments, span),
            ("integral", _) if self.names == Names::Formula => self.integral(arguments, span),
            ("integral", _) => {
                let reason = Reason::NotHere { what: "an integral", place: "a profile or constant" };
                Err(ParseError::new(name_span.clone(), reason, "expected an expression in r without integrals"))
            }
            ("sqrt", 1) => self.square_root(arguments),
            ("sqrt", found) => Err(wrong_count(name, "1 argument".to_owned(), found, span)),
            ("J0" | "J1" | "I0" | "I1", 1) => self.bessel(name, name_span, arguments, span),
            ("hyper", _) => self.hypergeometric(name_span, arguments, span),
            (_, found) => {
                let function = self.function(name, name_span)?;
                let (least, most) = function.row().arity;
                if !(least..=most).contains(&found) {
                    let expected = match (least, most) {
                        (1, 1) => "1 argument".to_owned(),
                        (least, most) if least == most => format!("{least} arguments"),
                        (least, most) => format!("{least} to {most} arguments"),
                    };
                    return Err(wrong_count(name, expected, found, span));
                }
                self.applied(function, Vec::new(), arguments, span)
            }
        }
    }

    fn function(&self, name: &str, name_span: &Range<usize>) -> Result<Function, ParseError> {
        Function::named(name).ok_or_else(|| {
            let reason = Reason::UnknownFunction { name: name.to_owned() };
            ParseError::new(name_span.clone(), reason, self.names.nearest(name))
        })
    }

    /// Builds a call from numbers that were not typed as arguments, followed by the typed arguments.
    fn applied(
        &mut self,
        function: Function,
        leading: Vec<Expr>,
        arguments: Vec<Operand>,
        span: &Range<usize>,
    ) -> Result<Formula, ParseError> {
        let place = match arguments.as_slice() {
            [only] => only.span.clone(),
            _ => span.clone(),
        };
        let mut values: Vec<Formula> = leading.into_iter().map(Formula::Closed).collect();
        for argument in arguments {
            values.push(argument.formula()?);
        }
        self.lifted(values, span, |_, values| {
            if has_value(function, values) {
                return Ok(Expr::function(function, values.to_vec()));
            }
            let reason = Reason::Domain { name: function.name().to_owned() };
            Err(ParseError::new(place.clone(), reason, "expected an argument inside the domain of the function"))
        })
    }

    fn square_root(&mut self, arguments: Vec<Operand>) -> Result<Formula, ParseError> {
        let span = arguments.first().map_or(0..0, |argument| argument.span.clone());
        let values = arguments.into_iter().map(Operand::formula).collect::<Result<Vec<_>, _>>()?;
        let half = Expr::ratio(1, 2);
        self.lifted(values, &span, |own, values| match values {
            [value] => own.arithmetic.power(value, &span, &half, &span),
            _ => Ok(Expr::zero()),
        })
    }

    /// `J0(z)` for `besselj(0, z)`, and similarly `J1`, `I0` and `I1`.
    fn bessel(
        &mut self,
        name: &str,
        name_span: &Range<usize>,
        arguments: Vec<Operand>,
        span: &Range<usize>,
    ) -> Result<Formula, ParseError> {
        let function = self.function(if name.starts_with('J') { "besselj" } else { "besseli" }, name_span)?;
        let order = Expr::integer(i64::from(name.ends_with('1')));
        self.applied(function, vec![order], arguments, span)
    }

    /// `hyper([a…], [b…], z)`: the row's arguments are the two lengths, the entries of both lists, and z.
    fn hypergeometric(&mut self, name_span: &Range<usize>, arguments: Vec<Operand>, span: &Range<usize>) -> Result<Formula, ParseError> {
        const FORM: &str = "write hyper([1/2, 1], [3/2], z), with both lists of parameters in brackets";
        let function = self.function("hyper", name_span)?;
        if arguments.len() != 3 {
            let reason = Reason::Arguments { name: "hyper".to_owned(), expected: "3 arguments".to_owned(), found: arguments.len() };
            return Err(ParseError::new(span.clone(), reason, FORM));
        }
        let (mut lengths, mut entries) = (Vec::new(), Vec::new());
        for (i, argument) in arguments.into_iter().enumerate() {
            match argument.value {
                Value::List(items) if i < 2 => {
                    lengths.push(Expr::integer(items.len().try_into().unwrap_or(i64::MAX)));
                    entries.extend(items);
                }
                Value::Formula(_) if i == 2 => entries.push(argument),
                _ => {
                    let reason = Reason::NotHere { what: "this", place: "this argument of hyper" };
                    return Err(ParseError::new(argument.span, reason, FORM));
                }
            }
        }
        self.applied(function, lengths, entries, span)
    }

    fn integral(&mut self, arguments: Vec<Operand>, span: &Range<usize>) -> Result<Formula, ParseError> {
        let found = arguments.len();
        let Ok([integrand, variable, lower, upper]) = <[Operand; 4]>::try_from(arguments) else {
            return Err(wrong_count("integral", "4 arguments".to_owned(), found, span));
        };
        let place = variable.span.clone();
        let Some(variable) = variable.formula()?.as_closed().and_then(Expr::as_symbol).cloned() else {
            let reason = Reason::NotHere { what: "this", place: "the second argument of integral, its variable" };
            return Err(ParseError::new(place, reason, "write integral(integrand, r, lower, upper)"));
        };
        Ok(Formula::Integral {
            integrand: Box::new(integrand.formula()?),
            variable,
            lower: lower.closed("the limit of an integral")?,
            upper: upper.closed("the limit of an integral")?,
        })
    }
}

fn wrong_count(name: &str, expected: String, found: usize, span: &Range<usize>) -> ParseError {
    let accepted = format!("write {name} with {expected}, separated by commas");
    let reason = Reason::Arguments { name: name.to_owned(), expected, found };
    ParseError::new(span.clone(), reason, accepted)
}
