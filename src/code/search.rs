//! The routine that solves g(a) = d for the contact radius: outward to the first bracket, then secants.

use super::build::Builder;
use super::build::ParameterDimension;
use super::program::STEP;
use super::tree::{Operator, Routine, Statement, Value};
use super::{CodeError, read};
use crate::contact::Quantity;
use crate::expr::Expr;
use crate::print;
use crate::transform::{Superposed, wave_numbers};
use std::f64::consts::FRAC_PI_4;

/// The search ends at this multiple of the smallest length among the parameters: claims hold up to 3e12 for lengths between 1/4 and 4.
const FARTHEST: f64 = 2e13;

impl Builder<'_> {
    /// The body of a(d): the first root of g(a) = d.
    pub(super) fn search(&mut self) -> Result<Vec<Statement>, CodeError> {
        self.counter = 0;
        let chains = self.solution.evaluated(Superposed::Equivalent).ok_or(CodeError::NotClosed { quantity: "g" })?;
        // The flat part of a worn tip carries no depth: the root lies beyond it.
        let flat = match chains.as_slice() {
            [only] => only.values.iter().zip(&only.breakpoints).take_while(|(value, _)| value.is_zero()).last().map(|(_, end)| end.clone()),
            _ => None,
        };
        let limits: Vec<Expr> = self.solution.profile.limits().cloned().collect();
        let mut body = Vec::new();
        let (statements, flat) = self.lowered(&flat.unwrap_or_else(Expr::zero))?;
        body.extend(statements);
        body.push(Statement::Let("_low".to_owned(), flat));
        let mut limit: Option<Value> = None;
        for own in &limits {
            let (statements, value) = self.lowered(own)?;
            body.extend(statements);
            limit = Some(match limit {
                None => value,
                Some(other) => Value::call("min", vec![other, value]),
            });
        }
        // g may decrease beyond a kink: the search ends at the first kink with g ≥ d.
        let mut places: Vec<String> = ["_high", "_low", "_mid", "_one", "_two", "_low + _reach"].map(str::to_owned).to_vec();
        let mut narrow = String::new();
        let kinks = chains.iter().flat_map(|chain| chain.breakpoints.iter().zip(&chain.values)).filter(|(_, before)| !before.is_zero());
        for (index, (kink, _)) in kinks.enumerate() {
            let (statements, value) = self.lowered(kink)?;
            body.extend(statements);
            let name = format!("_kink{index}");
            body.push(Statement::Let(name.clone(), value));
            narrow.push_str(&format!("if g({name}) >= d {{ _last = min(_last, {name}); }} "));
            places.push(name);
        }
        let domain = "if d == 0 { return _low; }";
        let (last, at_end) = match limit {
            Some(limit) => {
                body.push(Statement::Let("_end".to_owned(), limit));
                ("_end * 0.99999999999999989", AT_END)
            }
            None => {
                let farthest = self.farthest();
                body.push(Statement::Let("_farthest".to_owned(), farthest));
                ("_farthest", "")
            }
        };
        let (count, step, is_reachable) = if self.step()? { (COUNT, WITHIN_WAVES, REACHABLE) } else { ("", "", "") };
        let list = self.arguments.join(", ");
        let comma = if list.is_empty() { "" } else { ", " };
        let profile_at = |at: &str| format!("sneddon_g({at}{comma}{list})");
        let text = format!("fn search() {{ {domain} let _last = {last}; {narrow} {SEARCH_OUTWARD} {SEARCH} }}");
        let text = text.replace("AT_END", at_end).replace("COUNT", count).replace("WITHIN_WAVES", step).replace("REACHABLE", is_reachable);
        let text = text.replace("step(_high)", &format!("{STEP}(_high{comma}{list})"));
        let text = places.iter().fold(text, |text, at| text.replace(&format!("g({at})"), &profile_at(at)));
        let routine = read::routines(&text).and_then(|list| list.into_iter().next()).ok_or(CodeError::Forms)?;
        body.extend(routine.body);
        // No parameter begins with an underscore; the variables of the search do, until they are numbered.
        Ok(self.numbered(body))
    }

    /// The parameters with a dimension of length, with its exponent.
    fn lengths(&self) -> impl Iterator<Item = (&String, f64)> {
        self.arguments.iter().zip(self.dimensions).filter_map(|(name, own)| match own {
            ParameterDimension::Length(power) if *power != 0.0 => Some((name, *power)),
            _ => None,
        })
    }

    /// [`FARTHEST`] times the smallest length among the parameters, or times 1 if no parameter has a dimension of length.
    fn farthest(&self) -> Value {
        let length = |(name, power): (&String, f64)| match power {
            1.0 => Value::name(name),
            _ => Value::Call("pow".to_owned(), vec![Value::name(name), Value::Number(1.0 / power, true)]),
        };
        let smallest = self.lengths().map(length).reduce(|one, other| Value::call("min", vec![one, other]));
        let farthest = Value::Number(FARTHEST, true);
        smallest.map_or_else(|| farthest.clone(), |own| Value::binary(Operator::Multiply, farthest.clone(), own))
    }

    /// The depths for which the search looks for a radius, in words.
    pub(super) fn largest_depth(&self) -> String {
        let limits: Vec<String> = self.solution.profile.limits().map(print::text_expr).collect();
        let length = |(name, power): (&String, f64)| if power == 1.0 { name.clone() } else { format!("{name}^({:?})", 1.0 / power) };
        let lengths: Vec<String> = self.lengths().map(length).collect();
        let end = match (limits.as_slice(), lengths.as_slice()) {
            ([], []) => format!(" for a up to {FARTHEST:e}"),
            ([], [only]) => format!(" for a up to {FARTHEST:e}*{only}"),
            ([], many) => format!(" for a up to {FARTHEST:e}*min({})", many.join(", ")),
            _ => String::new(),
        };
        format!("d at most the largest value of g{end}")
    }

    /// Adds the routine for the steps of the search, an eighth of the shortest wave of f at a radius; false if f has no waves.
    fn step(&mut self) -> Result<bool, CodeError> {
        let numbers = wave_numbers(&self.solution.profile);
        if numbers.is_empty() {
            return Ok(false);
        }
        let mut body = Vec::new();
        let mut largest = Value::Number(f64::MIN_POSITIVE, true);
        for own in numbers {
            let (statements, value) = self.lowered(&own)?;
            body.extend(statements);
            largest = Value::call("max", vec![largest, Value::call("abs", vec![value])]);
        }
        body.push(Statement::Return(Value::binary(Operator::Divide, Value::Number(FRAC_PI_4, true), largest)));
        let parameters = std::iter::once("r".to_owned()).chain(self.arguments.iter().cloned()).collect();
        let comment = vec!["An eighth of the shortest wave of f at the radius r.".to_owned()];
        let routine = Routine { name: STEP.to_owned(), parameters, body, comment };
        self.needed(&routine, Quantity::Radius)?;
        self.routines.push(routine);
        Ok(true)
    }
}

/// Counts the steps within the first five hundred waves.
const COUNT: &str = "let _steps = 0;";
/// Limits a step to an eighth of a wave.
const WITHIN_WAVES: &str = "if _steps < 4000 { _reach = min(_reach, _high - _inner + step(_high)); _steps = _steps + 1; }";
/// Among the values at three radii an eighth of a wave apart, the middle one is less below the crest than four times their second
/// difference.
const REACHABLE: &str = "if _steps < 4000 && _high < _last && _at_low + 4 * (2 * _at_low - _at_left - _at_high) < d { _passed = 0; }";

/// Halves inward until |g| has been below d six times, then steps outward to the first radius with g ≥ d: by factors of two while g is small,
/// else by a quarter, and not beyond an eighth of a wave; a maximum of g that was passed, or that may lie before the end, is searched by
/// golden sections.
const SEARCH_OUTWARD: &str = "let _reach = max(1e-300, min(d, _last - _low)); let _below = 0; COUNT
    while _below < 6 && _reach > 1e-300 {
      if abs(g(_low + _reach)) < d { _below = _below + 1; }
      _reach = 0.5 * _reach;
    }
    let _inner = _low; let _left = _low; let _mid = _low; let _high = min(_low + _reach, _last); let _found = 0; let _passed = 0;
    let _at_left = 0; let _at_low = 0; let _at_high = g(_high);
    if _at_high >= d { _found = 1; }
    while _found == 0 && _high < _last {
      _left = _low; _low = _high; _at_left = _at_low; _at_low = _at_high;
      if _at_high < 0.0625 * d { _reach = 2 * _reach; } else { _reach = 1.25 * _reach; }
      WITHIN_WAVES
      _high = min(_inner + _reach, _last);
      _at_high = g(_high);
      if _at_high >= d { _found = 1; }
      _passed = 0;
      if _high >= _last { _passed = 1; }
      if _at_low > _at_high && _at_left <= _at_low { _passed = 1; }
      REACHABLE
      if _found == 0 && _passed > 0 {
        let _from = _left; let _to = _high; let _k = 0;
        while _found == 0 && _k < 60 {
          let _one = _from + 0.38196601125010515 * (_to - _from);
          let _two = _from + 0.61803398874989485 * (_to - _from);
          _mid = _one;
          if g(_one) < g(_two) { _from = _one; _mid = _two; } else { _to = _two; }
          if g(_mid) >= d { _found = 1; }
          _k = _k + 1;
        }
        if _found > 0 { _low = _left; _high = _mid; }
      }
    }
    if _found == 0 {
      AT_END
      return nan();
    }";

/// At the end of the domain g may be rounded to less than the depth that belongs to it.
const AT_END: &str = "if _at_high * 1.0000000000000036 >= d { return _high; }";

/// Illinois steps; the end of the bracket whose g is nearer to d is the radius.
const SEARCH: &str = "_below = g(_low) - d; let _above = g(_high) - d; let _n = 0; let _side = 0;
    if _above == 0 { return _high; }
    while _n < 400 && _high - _low > 2.2e-16 * _high {
      _n = _n + 1;
      _mid = (_low * _above - _high * _below) / (_above - _below);
      if !(_mid > _low && _mid < _high) || _n > 60 { _mid = _low + 0.5 * (_high - _low); }
      if _mid > _low && _mid < _high {
        let _rest = g(_mid) - d;
        if _rest == 0 { return _mid; }
        if _rest > 0 { _high = _mid; _above = _rest; if _side > 0 { _below = 0.5 * _below; } _side = 1; }
        else { _low = _mid; _below = _rest; if _side < 0 { _above = 0.5 * _above; } _side = -1; }
      } else { _n = 400; }
    }
    if d - g(_low) < g(_high) - d { return _low; }
    return _high;";
