//! From a solution to a program: a routine for every quantity, with its domain, its pieces and its comment.

use super::accuracy::ELEMENTARY;
use super::claim;
use super::lower::{Names, lowered};
use super::program::Claim;
use super::program::Language;
use super::program::{Program, is_of_depth, needs_modulus, routine_name, series_of};
use super::tree::{Comparison, NAN, Operator, Routine, Statement, Test, Value};
use super::{CodeError, FORMS, names, read};
use crate::contact::{Edge, Explicit, Quantity, explicit, relations};
use crate::expr::{Bindings, Condition, Expr, Node, Relation};
use crate::print;
use crate::transform::{Derived, EvaluatedChain, Solution, Superposed};

/// The quantities that code can be written for.
pub const QUANTITIES: [Quantity; 6] =
    [Quantity::Equivalent, Quantity::Force, Quantity::Pressure, Quantity::Depth, Quantity::Radius, Quantity::ForceOfDepth];

/// The coordinates of a quantity, in the order of the arguments.
pub(super) fn coordinates(quantity: Quantity) -> Vec<&'static str> {
    let radius = quantity.needs_radius().then_some("a");
    std::iter::once(quantity.coordinate()).chain(radius).collect()
}

/// The unit, in words.
fn unit(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Force | Quantity::ForceOfDepth => {
            "Units: lengths in one unit, E a pressure; F in the unit of E times that of length squared."
        }
        Quantity::Pressure => "Units: lengths in one unit, E a pressure; p in the unit of E.",
        _ => "Units: lengths in one unit, which is that of the result.",
    }
}

/// Builds the program of a profile for a language.
///
/// ```
/// use sneddon::code::{Language, program, write};
/// use sneddon::contact::Quantity;
/// use sneddon::{parse, transform::{Profile, derive}};
/// let profile = Profile::new(&parse::profile("r^2/(2*R)").unwrap()).unwrap();
/// let program = program(&derive(&profile).unwrap(), &[Quantity::Force], Language::C, "r^2/(2*R)").unwrap();
/// assert!(write(&program).contains("double sneddon_F(double a, double E, double R)"));
/// ```
///
/// # Errors
/// [`CodeError`] where a quantity is not closed, or where a function cannot be written in the language.
pub fn program(solution: &Solution, quantities: &[Quantity], language: Language, profile: &str) -> Result<Program, CodeError> {
    let symbols = solution.profile.parameters();
    let forms = read::routines(FORMS).ok_or(CodeError::Forms)?;
    let target = language.target();
    let mut taken: Vec<String> = ["x", "a", "r", "d", "E"].map(str::to_owned).to_vec();
    taken.extend(QUANTITIES.iter().flat_map(|own| [target.spelled(&routine_name(*own)), own.key().to_owned()]));
    taken.extend(forms.iter().map(|own| target.spelled(&own.name)));
    let mut names = names::identifiers(&symbols, target.ignores_case(), &|word| target.is_reserved(word), &taken);
    let parameters: Vec<(String, String)> =
        symbols.iter().map(|own| (own.name().to_owned(), names.get(own.name()).cloned().unwrap_or_default())).collect();
    for own in ["x", "a", "r", "d", "E"] {
        names.insert(own.to_owned(), own.to_owned());
    }
    let arguments: Vec<String> = parameters.iter().map(|(_, own)| own.clone()).collect();
    let build = |in_series: &[Quantity]| {
        let (names, arguments, in_series) = (names.clone(), arguments.clone(), in_series.to_vec());
        let mut builder =
            Builder { solution, names, arguments, counter: 0, routines: Vec::new(), forms: forms.clone(), language, in_series };
        for quantity in quantities {
            builder.quantity(*quantity)?;
        }
        let library = builder.library();
        let angles = angles(solution, &parameters);
        let (routines, quantities, profile, parameters) = (builder.routines, quantities.to_vec(), profile.to_owned(), parameters.clone());
        let program = Program { language, routines, quantities, parameters, library, angles, profile, claims: Vec::new() };
        Ok::<Program, CodeError>(claim::claimed(program, solution))
    };
    let closed = build(&[])?;
    // A series next to the axis costs code and time: only where it keeps digits.
    let mut in_series: Vec<Quantity> = closed.poor().into_iter().flat_map(series_of).copied().collect();
    in_series.sort_by_key(|own| own.key());
    in_series.dedup();
    if in_series.is_empty() {
        return closed.honest();
    }
    let other = build(&in_series)?;
    let better: Vec<Quantity> = in_series.iter().copied().filter(|own| other.has_smaller_claims(&closed, *own)).collect();
    match better.len() {
        0 => closed.honest(),
        count if count == in_series.len() => other.honest(),
        _ => build(&better)?.honest(),
    }
}

/// Parameters of which a sine, cosine or tangent is taken.
fn angles(solution: &Solution, parameters: &[(String, String)]) -> Vec<String> {
    fn is_angle(expr: &Expr, name: &str) -> bool {
        match expr.node() {
            Node::Function(function, arguments) if matches!(function.name(), "sin" | "cos" | "tan") => {
                matches!(arguments.as_slice(), [only] if only.as_symbol().is_some_and(|own| own.name() == name))
            }
            _ => expr.children().into_iter().any(|own| is_angle(own, name)),
        }
    }
    let mut slopes = solution.chains.iter().flat_map(|chain| &chain.intervals).map(|interval| &interval.slope);
    let slopes: Vec<&Expr> = slopes.by_ref().collect();
    let found = parameters.iter().filter(|(symbol, _)| slopes.iter().any(|own| is_angle(own, symbol)));
    found.map(|(_, identifier)| identifier.clone()).collect()
}

pub(super) struct Builder<'a> {
    pub(super) solution: &'a Solution,
    names: Names,
    pub(super) arguments: Vec<String>,
    pub(super) counter: usize,
    pub(super) routines: Vec<Routine>,
    forms: Vec<Routine>,
    language: Language,
    /// The quantities that are a series next to the axis.
    in_series: Vec<Quantity>,
}

impl Builder<'_> {
    /// Adds the routine of a quantity and what it calls.
    fn quantity(&mut self, quantity: Quantity) -> Result<(), CodeError> {
        if self.routines.iter().any(|own| own.name == routine_name(quantity)) {
            return Ok(());
        }
        let shown = self.derived(quantity)?;
        let (mut body, mut comment) = (Vec::new(), Vec::new());
        let mut references: Vec<&'static str> = shown.as_ref().map(|own| own.reference.clone()).unwrap_or_default();
        let mut domain = self.domain(quantity)?;
        let arguments = self.parameters(quantity);
        match quantity {
            Quantity::Radius => match explicit(self.solution) {
                Some(found) => {
                    self.conditions(&found.conditions, "d", &mut domain.0, &mut domain.1)?;
                    body.extend(self.guard(domain.0));
                    body.push(when(compare(Comparison::Equal, "d", 0.0), Value::Number(0.0, true)));
                    let value = self.explicit(&found, &mut body)?;
                    body.push(Statement::Return(value));
                }
                None => {
                    references = vec!["g(a) = d solved for a by a bracketed search"];
                    self.quantity(Quantity::Equivalent)?;
                    body = self.search()?;
                }
            },
            Quantity::Depth => {
                self.quantity(Quantity::Equivalent)?;
                let mut values: Vec<Value> = vec![Value::name("a")];
                values.extend(self.arguments.iter().map(|own| Value::name(own)));
                body.push(Statement::Return(Value::Call(routine_name(Quantity::Equivalent), values)));
            }
            Quantity::ForceOfDepth => body = self.force_of_depth(shown.as_ref(), domain.0.clone(), &mut references)?,
            _ => {
                body.extend(self.guard(domain.0.clone()));
                let (kind, factor) = match quantity {
                    Quantity::Force => (Superposed::Force, Expr::integer(2) * Expr::symbol("E")),
                    Quantity::Pressure => (Superposed::Pressure, Expr::symbol("E") / Expr::pi()),
                    _ => (Superposed::Equivalent, Expr::one()),
                };
                let edge = match quantity {
                    Quantity::Pressure => Test::Compare(Comparison::GreaterOrEqual, Value::name("r"), Value::name("a")),
                    Quantity::Force => compare(Comparison::Equal, "a", 0.0),
                    _ => compare(Comparison::Equal, "x", 0.0),
                };
                body.push(when(edge, Value::Number(0.0, true)));
                let series = self.in_series.contains(&quantity);
                let gaussians = if series { self.sum_of_gaussians(quantity, &factor)? } else { None };
                if let Some(gaussians) = gaussians {
                    body.extend(gaussians);
                } else {
                    if series {
                        body.extend(self.next_to_the_axis(quantity)?);
                    }
                    let chains = self.solution.evaluated(kind).ok_or(CodeError::NotClosed { quantity: quantity.key() })?;
                    body.extend(self.chains(quantity, &chains, &factor)?);
                }
            }
        }
        let arguments_text = coordinates(quantity).join(", ");
        comment.push(format!("{}({arguments_text}): the {}.", quantity.key(), quantity.title()));
        if let Some(shown) = &shown {
            comment.push(format!("{} = {}", quantity.key(), print::text(&shown.formula)));
        } else {
            comment.push("a is the first root of g(a) = d, unless waves of g are shorter than a quarter of it.".to_owned());
        }
        comment.push(format!("Source: {}.", references.join("; ")));
        comment.push(format!("Domain: {}.", domain.1.join(", ")));
        comment.push(unit(quantity).to_owned());
        let mut routine = Routine { name: routine_name(quantity), parameters: arguments, body, comment };
        if quantity == Quantity::ForceOfDepth && routine.calls().contains(&routine_name(Quantity::Force)) {
            routine.comment.push("Computed as F(a) + 2*E*a*(d - g(a)), in which an error of a counts in second order only.".to_owned());
        }
        self.needed(&routine, quantity)?;
        self.routines.push(routine);
        Ok(())
    }

    /// The body of F(d): the formula where it is a product, in which nothing cancels, else F(a) + 2 E* a (d − g(a)) at the
    /// radius a(d): because F′ = 2 E* a g′, an error of a counts in second order only.
    fn force_of_depth(
        &mut self,
        shown: Option<&Derived>,
        tests: Vec<Test>,
        references: &mut Vec<&'static str>,
    ) -> Result<Vec<Statement>, CodeError> {
        if let Some(found) = explicit(self.solution).filter(|own| !has_sum(&own.force)) {
            let mut tests = tests;
            self.conditions(&found.conditions, "d", &mut tests, &mut Vec::new())?;
            let mut body = self.guard(tests);
            body.push(when(compare(Comparison::Equal, "d", 0.0), Value::Number(0.0, true)));
            self.counter = 0;
            let (statements, value) = self.lowered(&found.force)?;
            body.extend(statements);
            body.push(Statement::Return(value));
            return Ok(body);
        }
        for own in [Quantity::Equivalent, Quantity::Radius, Quantity::Force] {
            self.quantity(own)?;
        }
        if shown.is_none() {
            references.push("g(a) = d solved for a by a bracketed search");
        }
        let list: String = self.arguments.iter().map(|own| format!(", {own}")).collect();
        let text = format!(
            "fn composed() {{ let _at = sneddon_a(d{list}); \
             return sneddon_F(_at, E{list}) + 2 * E * _at * (d - sneddon_g(_at{list})); }}"
        );
        let routine = read::routines(&text).and_then(|list| list.into_iter().next()).ok_or(CodeError::Forms)?;
        self.counter = 0;
        Ok(self.numbered(routine.body))
    }

    /// The formula with its sources; `None` where the contact radius is not explicit.
    fn derived(&self, quantity: Quantity) -> Result<Option<Derived>, CodeError> {
        let found = match quantity {
            Quantity::Equivalent => Some(self.solution.equivalent_profile()),
            _ => {
                let all = relations(self.solution, &Edge::Smooth)?;
                match quantity {
                    Quantity::Force => Some(all.force),
                    Quantity::Pressure => Some(all.pressure.ok_or(CodeError::NotClosed { quantity: "p" })?),
                    Quantity::Depth => Some(all.d),
                    Quantity::ForceOfDepth => all.force_of_depth,
                    _ => {
                        if all.g.formula.has_integral() {
                            return Err(CodeError::NotClosed { quantity: "g" });
                        }
                        all.contact_radius_of_depth
                    }
                }
            }
        };
        if found.as_ref().is_some_and(|own| own.formula.has_integral()) {
            return Err(CodeError::NotClosed { quantity: quantity.key() });
        }
        Ok(found)
    }

    fn parameters(&self, quantity: Quantity) -> Vec<String> {
        let mut all: Vec<String> = coordinates(quantity).iter().map(|own| (*own).to_owned()).collect();
        if needs_modulus(quantity) {
            all.push("E".to_owned());
        }
        all.extend(self.arguments.iter().cloned());
        all
    }

    /// What must hold, as tests and in words.
    fn domain(&mut self, quantity: Quantity) -> Result<(Vec<Test>, Vec<String>), CodeError> {
        let (mut tests, mut words) = (Vec::new(), Vec::new());
        let largest = |name: &str| Test::Compare(Comparison::LessOrEqual, Value::name(name), Value::Number(f64::MAX, true));
        for own in coordinates(quantity) {
            tests.extend([compare(Comparison::GreaterOrEqual, own, 0.0), largest(own)]);
            words.push(format!("{own} >= 0"));
        }
        let mut positive = self.arguments.clone();
        if needs_modulus(quantity) {
            positive.insert(0, "E".to_owned());
        }
        for own in &positive {
            tests.extend([compare(Comparison::Greater, own, 0.0), largest(own)]);
            words.push(format!("{own} > 0"));
        }
        if !is_of_depth(quantity) {
            let coordinate = coordinates(quantity).last().copied().unwrap_or("a");
            self.conditions(&self.solution.conditions.clone(), coordinate, &mut tests, &mut words)?;
        }
        Ok((tests, words))
    }

    /// Conditions on the parameters, and on the radius, which is the outermost coordinate here.
    fn conditions(
        &mut self,
        list: &[Condition],
        coordinate: &str,
        tests: &mut Vec<Test>,
        words: &mut Vec<String>,
    ) -> Result<(), CodeError> {
        let place = Bindings::one("r", Expr::symbol(coordinate));
        for own in list {
            let own = own.substitute(&place);
            words.push(print::text_condition(&own));
            let comparison = match own.relation {
                Relation::Less => Comparison::Less,
                Relation::LessOrEqual => Comparison::LessOrEqual,
                // Doubles are seldom equal; the words say it.
                _ => continue,
            };
            let ((before, left), (more, right)) = (self.lowered(&own.left)?, self.lowered(&own.right)?);
            if before.is_empty() && more.is_empty() {
                tests.push(Test::Compare(comparison, left, right));
            }
        }
        Ok(())
    }

    fn guard(&self, tests: Vec<Test>) -> Vec<Statement> {
        if tests.is_empty() {
            return Vec::new();
        }
        vec![when(Test::Not(Box::new(Test::All(tests))), Value::call(NAN, Vec::new()))]
    }

    pub(super) fn lowered(&mut self, expr: &Expr) -> Result<(Vec<Statement>, Value), CodeError> {
        Ok(lowered(expr, &self.names, &mut self.counter)?)
    }

    /// The sum of the chains; one with breakpoints beside others is a routine of its own.
    fn chains(&mut self, quantity: Quantity, chains: &[EvaluatedChain], factor: &Expr) -> Result<Vec<Statement>, CodeError> {
        self.counter = 0;
        if let [only] = chains {
            return self.pieces(quantity, only, factor);
        }
        let parameters = self.parameters(quantity);
        let (mut body, mut total): (Vec<Statement>, Option<Value>) = (Vec::new(), None);
        for (index, chain) in chains.iter().enumerate() {
            let value = if let ([], [only]) = (chain.breakpoints.as_slice(), chain.values.as_slice()) {
                let (statements, value) = self.lowered(&(only * factor))?;
                body.extend(statements);
                value
            } else {
                let counter = std::mem::take(&mut self.counter);
                let name = format!("{}_{}", routine_name(quantity), index + 1);
                let routine = Routine {
                    name: name.clone(),
                    parameters: parameters.clone(),
                    body: self.pieces(quantity, chain, factor)?,
                    comment: vec![format!("A part of {}, piece by piece.", quantity.key())],
                };
                self.counter = counter;
                self.needed(&routine, quantity)?;
                self.routines.push(routine);
                Value::Call(name, parameters.iter().map(|own| Value::name(own)).collect())
            };
            total = Some(match total {
                None => value,
                Some(sum) => Value::binary(Operator::Add, sum, value),
            });
        }
        body.push(Statement::Return(total.unwrap_or(Value::Number(0.0, true))));
        Ok(body)
    }

    /// The pieces of a chain, each where the contact ends in it.
    fn pieces(&mut self, quantity: Quantity, chain: &EvaluatedChain, factor: &Expr) -> Result<Vec<Statement>, CodeError> {
        let coordinate = coordinates(quantity).last().copied().unwrap_or("a");
        let mut body = Vec::new();
        for (index, value) in chain.values.iter().enumerate() {
            let (mut piece, value) = self.lowered(&(value * factor))?;
            piece.push(Statement::Return(value));
            match chain.breakpoints.get(index) {
                Some(end) => {
                    let (statements, end) = self.lowered(end)?;
                    body.extend(statements);
                    body.push(Statement::If(Test::Compare(Comparison::LessOrEqual, Value::name(coordinate), end), piece, Vec::new()));
                }
                None => body.extend(piece),
            }
        }
        Ok(body)
    }

    fn explicit(&mut self, found: &Explicit, body: &mut Vec<Statement>) -> Result<Value, CodeError> {
        self.counter = 0;
        let (statements, value) = self.lowered(&found.contact_radius)?;
        body.extend(statements);
        Ok(value)
    }

    /// The root of g(a) = d between two radii: secants, and halves where these leave the bracket.
    fn search(&mut self) -> Result<Vec<Statement>, CodeError> {
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
        // g may fall behind a kink: the first kink at which it has reached d ends the bracket.
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
        let domain = "if !(d >= 0 && d <= 1e300) { return nan(); } if d == 0 { return _low; }";
        let last = match limit {
            Some(limit) => {
                body.push(Statement::Let("_end".to_owned(), limit));
                "_end * 0.99999999999999989"
            }
            None => "1e300",
        };
        let list = self.arguments.join(", ");
        let comma = if list.is_empty() { "" } else { ", " };
        let profile_at = |at: &str| format!("sneddon_g({at}{comma}{list})");
        let text = format!("fn search() {{ {domain} let _last = {last}; {narrow} {SEARCH_OUTWARD} {SEARCH} }}");
        let text = places.iter().fold(text, |text, at| text.replace(&format!("g({at})"), &profile_at(at)));
        let routine = read::routines(&text).and_then(|list| list.into_iter().next()).ok_or(CodeError::Forms)?;
        body.extend(routine.body);
        // No parameter begins with an underscore; the variables of the search do, until they are numbered.
        Ok(self.numbered(body))
    }

    /// Renames the variables of a body to t1, t2, …, which no parameter is called.
    pub(super) fn numbered(&mut self, body: Vec<Statement>) -> Vec<Statement> {
        let routine = Routine { name: String::new(), parameters: Vec::new(), body, comment: Vec::new() };
        let mut renaming = Names::new();
        for own in routine.variables().into_iter().chain(routine.arrays()) {
            if own.starts_with('_') {
                self.counter += 1;
                renaming.insert(own, format!("t{}", self.counter));
            }
        }
        routine.body.iter().map(|own| own.renamed(&renaming)).collect()
    }

    /// Adds the stable forms that a routine calls, those first that they call themselves.
    pub(super) fn needed(&mut self, routine: &Routine, quantity: Quantity) -> Result<(), CodeError> {
        for name in routine.calls() {
            if ELEMENTARY.contains(&name.as_str()) || self.routines.iter().any(|own| own.name == name) {
                continue;
            }
            if self.language.target().library(&name).is_some() {
                continue;
            }
            let Some(form) = self.forms.iter().find(|own| own.name == name).cloned() else {
                return Err(CodeError::Function { quantity: quantity.key(), function: name, language: self.language.title() });
            };
            self.needed(&form, quantity)?;
            self.routines.push(form);
        }
        Ok(())
    }

    /// The functions of the language's library that are called.
    fn library(&self) -> Vec<String> {
        let mut all: Vec<String> = self.routines.iter().flat_map(Routine::calls).collect();
        all.sort();
        all.dedup();
        all.retain(|name| !ELEMENTARY.contains(&name.as_str()) && !self.routines.iter().any(|own| own.name == *name));
        all
    }
}

/// Halves inward until |g| has been below d six times, then steps outward to the first radius with g ≥ d: by factors of two while g is small,
/// else by a quarter; a maximum of g that was passed is searched by golden sections.
const SEARCH_OUTWARD: &str = "let _reach = min(d, _last - _low); let _below = 0;
    while _below < 6 && _reach > 1e-300 {
      if abs(g(_low + _reach)) < d { _below = _below + 1; }
      _reach = 0.5 * _reach;
    }
    let _inner = _low; let _left = _low; let _mid = _low; let _high = _low + _reach; let _found = 0;
    let _at_left = 0; let _at_low = 0; let _at_high = g(_high);
    if _at_high >= d { _found = 1; }
    while _found == 0 && _high < _last {
      _left = _low; _low = _high; _at_left = _at_low; _at_low = _at_high;
      if _at_high < 0.0625 * d { _reach = 2 * _reach; } else { _reach = 1.25 * _reach; }
      _high = min(_inner + _reach, _last);
      _at_high = g(_high);
      if _at_high >= d { _found = 1; }
      if _found == 0 && _at_low > _at_high && _at_left <= _at_low {
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
    if _found == 0 { return nan(); }";

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

fn has_sum(expr: &Expr) -> bool {
    matches!(expr.node(), Node::Sum(_)) || expr.children().into_iter().any(has_sum)
}

fn compare(comparison: Comparison, name: &str, number: f64) -> Test {
    Test::Compare(comparison, Value::name(name), Value::Number(number, true))
}

pub(super) fn when(test: Test, value: Value) -> Statement {
    Statement::If(test, vec![Statement::Return(value)], Vec::new())
}

impl Program {
    /// What is claimed of each quantity; `None` where no point with a bound was found.
    pub fn claims(&self) -> &[(Quantity, Option<Claim>)] {
        &self.claims
    }
}

impl Program {
    /// Whether the quantity is computed from a radius that solves g(a) = d, whose errors running bounds do not follow.
    pub(super) fn is_solved(&self, quantity: Quantity) -> bool {
        let calls = |own: &Routine| own.calls().iter().any(|name| *name == routine_name(Quantity::Equivalent));
        is_of_depth(quantity) && self.routines.iter().any(|own| own.name == routine_name(quantity) && calls(own))
    }
}

impl Program {
    /// Whether a routine is one that was asked for.
    pub(super) fn is_public(&self, routine: &Routine) -> bool {
        self.quantities.iter().any(|own| routine_name(*own) == routine.name)
    }
}
