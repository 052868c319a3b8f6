//! The routine that solves g(a) = d for the contact radius: outward to the first bracket, then secants.

use super::build::Builder;
use super::tree::{Statement, Value};
use super::{CodeError, read};
use crate::expr::Expr;
use crate::transform::Superposed;

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
        let domain = "if !(d >= 0 && d <= 1.7976931348623157e308) { return nan(); } if d == 0 { return _low; }";
        let (last, at_end) = match limit {
            Some(limit) => {
                body.push(Statement::Let("_end".to_owned(), limit));
                ("_end * 0.99999999999999989", AT_END)
            }
            None => ("1e300", ""),
        };
        let list = self.arguments.join(", ");
        let comma = if list.is_empty() { "" } else { ", " };
        let profile_at = |at: &str| format!("sneddon_g({at}{comma}{list})");
        let text = format!("fn search() {{ {domain} let _last = {last}; {narrow} {SEARCH_OUTWARD} {SEARCH} }}").replace("AT_END", at_end);
        let text = places.iter().fold(text, |text, at| text.replace(&format!("g({at})"), &profile_at(at)));
        let routine = read::routines(&text).and_then(|list| list.into_iter().next()).ok_or(CodeError::Forms)?;
        body.extend(routine.body);
        // No parameter begins with an underscore; the variables of the search do, until they are numbered.
        Ok(self.numbered(body))
    }
}

/// Halves inward until |g| has been below d six times, then steps outward to the first radius with g ≥ d: by factors of two while g is small,
/// else by a quarter; a maximum of g that was passed, or that may lie before the end, is searched by golden sections.
const SEARCH_OUTWARD: &str = "let _reach = min(d, _last - _low); let _below = 0;
    while _below < 6 && _reach > 1e-300 {
      if abs(g(_low + _reach)) < d { _below = _below + 1; }
      _reach = 0.5 * _reach;
    }
    let _inner = _low; let _left = _low; let _mid = _low; let _high = _low + _reach; let _found = 0; let _passed = 0;
    let _at_left = 0; let _at_low = 0; let _at_high = g(_high);
    if _at_high >= d { _found = 1; }
    while _found == 0 && _high < _last {
      _left = _low; _low = _high; _at_left = _at_low; _at_low = _at_high;
      if _at_high < 0.0625 * d { _reach = 2 * _reach; } else { _reach = 1.25 * _reach; }
      _high = min(_inner + _reach, _last);
      _at_high = g(_high);
      if _at_high >= d { _found = 1; }
      _passed = 0;
      if _high >= _last { _passed = 1; }
      if _at_low > _at_high && _at_left <= _at_low { _passed = 1; }
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
