//! From a solution to a program: a routine for every quantity, with its domain, its pieces and its comment.

mod dimensions;

pub(super) use dimensions::ParameterDimension;

use super::accuracy::ELEMENTARY;
use super::claim;
use super::lower::{Names, lowered};
use super::program::{Claim, Language, Program, QUANTITIES, STEP, Sum, is_of_depth, needs_modulus, routine_name, series_of, unit};
use super::tree::{Comparison, NAN, Operator, Routine, Statement, Test, Value};
use super::truth::References;
use super::{CodeError, FORMS, names, read};
use crate::contact::{Edge, Explicit, Quantity, explicit, relations};
use crate::expr::{Bindings, Condition, Expr, Node, Relation, Symbol};
use crate::print;
use crate::transform::{Derived, EvaluatedChain, Solution, Superposed};

/// The coordinates of a quantity, in the order of the arguments.
pub(super) fn coordinates(quantity: Quantity) -> Vec<&'static str> {
    let radius = quantity.needs_radius().then_some("a");
    std::iter::once(quantity.coordinate()).chain(radius).collect()
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
/// [`CodeError`] if a quantity is not closed, or if a function cannot be written in the language.
pub fn program(solution: &Solution, quantities: &[Quantity], language: Language, profile: &str) -> Result<Program, CodeError> {
    let solution = &with_acute_angles(solution);
    let symbols = solution.profile.parameters();
    let forms = FORMS.as_deref().ok_or(CodeError::Forms)?;
    let target = language.target();
    let mut taken: Vec<String> = ["x", "a", "r", "d", "E"].map(str::to_owned).to_vec();
    taken.extend(QUANTITIES.iter().flat_map(|own| [target.spelled(&routine_name(*own)), own.key().to_owned()]));
    taken.push(target.spelled(STEP));
    taken.extend(forms.iter().map(|own| target.spelled(&own.name)));
    let mut names = names::identifiers(&symbols, target.ignores_case(), &|word| target.is_reserved(word), &taken);
    let parameters: Vec<(String, String)> =
        symbols.iter().map(|own| (own.name().to_owned(), names.get(own.name()).cloned().unwrap_or_default())).collect();
    for own in ["x", "a", "r", "d", "E"] {
        names.insert(own.to_owned(), own.to_owned());
    }
    let arguments: Vec<String> = parameters.iter().map(|(_, own)| own.clone()).collect();
    let chains = &solution.profile.chains;
    let lengths: Vec<&Expr> = chains.iter().flat_map(|own| own.pieces.iter().chain(&own.breakpoints)).collect();
    let dimensions = dimensions::dimensions(&lengths, &symbols);
    let starting_values = dimensions::starting_values(&dimensions, &symbols, &solution.conditions);
    let build = |sums: &[(Quantity, Sum)]| {
        let (names, arguments, sums) = (names.clone(), arguments.clone(), sums.to_vec());
        let mut builder =
            Builder { solution, names, arguments, dimensions: &dimensions, counter: 0, routines: Vec::new(), forms, language, sums };
        for quantity in quantities {
            builder.quantity(*quantity)?;
        }
        let library = builder.library();
        let (routines, quantities, profile, parameters) = (builder.routines, quantities.to_vec(), profile.to_owned(), parameters.clone());
        let (shape, claims) = (None, Vec::new());
        let program = Program {
            language,
            routines,
            quantities,
            parameters,
            library,
            dimensions: dimensions.clone(),
            starting_values: starting_values.clone(),
            profile,
            shape,
            claims,
        };
        Ok::<Program, CodeError>(program)
    };
    // Use sums only where they improve the accuracy, because they cost code and time.
    let references = References::default();
    let claimed = |own: Program, other: Option<&Program>| claim::claimed(own, solution, &references, other);
    let mut best = claimed(build(&[])?, None);
    let mut sums: Vec<(Quantity, Sum)> = Vec::new();
    for sum in [Sum::Series, Sum::Quadrature] {
        let mut poor: Vec<Quantity> = best.poor().into_iter().flat_map(series_of).copied().collect();
        poor.sort_by_key(|own| own.key());
        poor.dedup();
        let with = |list: &[Quantity]| sums.iter().copied().chain(list.iter().map(|own| (*own, sum))).collect::<Vec<_>>();
        let other = build(&with(&poor))?;
        if other.computes_as(&best) {
            continue;
        }
        let other = claimed(other, Some(&best));
        let better: Vec<Quantity> = poor.iter().copied().filter(|own| other.has_smaller_claims(&best, *own)).collect();
        if better.is_empty() {
            continue;
        }
        sums = with(&better);
        best = if better.len() == poor.len() { other } else { claimed(build(&sums)?, None) };
    }
    best.honest()
}

/// The solution with the conditions that slope angles are acute, from which tan θ > 0 follows.
fn with_acute_angles(solution: &Solution) -> Solution {
    let mut solution = solution.clone();
    let angles = solution.profile.angle_conditions();
    let follows = |own: &Condition| match own.right.node() {
        Node::Function(function, arguments) if matches!(function.name(), "sin" | "cos" | "tan") => {
            own.left.is_zero() && arguments.iter().all(|angle| angles.contains(&Condition::less(Expr::zero(), angle.clone())))
        }
        _ => false,
    };
    solution.conditions.retain(|own| !follows(own));
    solution.conditions.extend(angles);
    solution.conditions.sort();
    solution.conditions.dedup();
    solution
}

/// The largest radius: the squares and cubes of larger ones overflow.
const LARGEST: f64 = 1e100;

pub(super) struct Builder<'a> {
    pub(super) solution: &'a Solution,
    pub(super) names: Names,
    pub(super) arguments: Vec<String>,
    /// What each argument measures.
    pub(super) dimensions: &'a [ParameterDimension],
    pub(super) counter: usize,
    pub(super) routines: Vec<Routine>,
    pub(super) forms: &'static [Routine],
    pub(super) language: Language,
    /// The quantities that are computed by sums where these converge fast.
    sums: Vec<(Quantity, Sum)>,
}

impl Builder<'_> {
    /// Adds the routine of a quantity and the routines that it calls.
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
                    // A worn tip touches with its flat, for which the formula has a value.
                    if self.solution.profile.chains.iter().all(|own| own.breakpoints.is_empty()) {
                        body.push(when(compare(Comparison::Equal, "d", 0.0), Value::Number(0.0, true)));
                    }
                    let value = self.explicit(&found, &mut body)?;
                    body.push(Statement::Return(value));
                }
                None => {
                    references = vec!["g(a) = d solved for a by a bracketed search"];
                    self.quantity(Quantity::Equivalent)?;
                    body = self.guard(domain.0.clone());
                    body.extend(self.search()?);
                }
            },
            Quantity::Depth => {
                self.quantity(Quantity::Equivalent)?;
                let mut values: Vec<Value> = vec![Value::name("a")];
                values.extend(self.arguments.iter().map(|own| Value::name(own)));
                body.push(Statement::Return(Value::Call(routine_name(Quantity::Equivalent), values)));
            }
            Quantity::ForceOfDepth => {
                if shown.is_none() {
                    references.push("g(a) = d solved for a by a bracketed search");
                }
                body = self.force_of_depth(&mut domain)?;
            }
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
                let sums: Vec<Sum> = self.sums.iter().filter(|own| own.0 == quantity).map(|own| own.1).collect();
                let gaussians = if sums.is_empty() { None } else { self.sum_of_gaussians(quantity, &factor)? };
                if let Some(gaussians) = gaussians {
                    body.extend(gaussians);
                } else {
                    body.extend(self.summed(quantity, &sums)?);
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
            let has_waves = self.routines.iter().any(|own| own.name == STEP);
            let within = if has_waves { "within five hundred waves of f, and beyond them " } else { "" };
            comment.push(format!("a is the first root of g(a) = d {within}if g has no waves shorter than a/4."));
        }
        comment.push(format!("Source: {}.", references.join("; ")));
        comment.push(format!("Domain: {}.", domain.1.join(", ")));
        let infinite = if quantity == Quantity::Pressure { self.solution.profile.jumps() } else { Vec::new() };
        if !infinite.is_empty() {
            let radii: Vec<String> = infinite.iter().map(|own| format!("r = {}", print::text_expr(own))).collect();
            comment.push(format!("The pressure is infinite at {}, where the result is infinite or not a number.", radii.join(" and at ")));
        }
        comment.push(unit(quantity, None));
        let mut routine = Routine { name: routine_name(quantity), parameters: arguments, body, comment };
        if quantity == Quantity::ForceOfDepth && routine.calls().contains(&routine_name(Quantity::Force)) {
            routine.comment.push("Computed as F(a) + 2*E*a*(d - g(a)), in which an error of a counts in second order only.".to_owned());
        }
        self.needed(&routine, quantity)?;
        self.routines.push(routine);
        Ok(())
    }

    /// The body of F(d): the formula if it is a product, which does not cancel, else F(a) + 2 E* a (d − g(a)) at the radius
    /// a(d): because F′ = 2 E* a g′, the result depends on an error of a only in second order.
    fn force_of_depth(&mut self, domain: &mut (Vec<Test>, Vec<String>)) -> Result<Vec<Statement>, CodeError> {
        if let Some(found) = explicit(self.solution).filter(|own| !has_sum(&own.force)) {
            self.conditions(&found.conditions, "d", &mut domain.0, &mut domain.1)?;
            let mut body = self.guard(domain.0.clone());
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
        let list: String = self.arguments.iter().map(|own| format!(", {own}")).collect();
        let text = format!(
            "fn composed() {{ let _at = sneddon_a(d{list}); \
             return sneddon_F(_at, E{list}) + 2 * E * _at * (d - sneddon_g(_at{list})); }}"
        );
        let routine = read::routines(&text).and_then(|list| list.into_iter().next()).ok_or(CodeError::Forms)?;
        self.counter = 0;
        Ok(self.numbered(routine.body))
    }

    /// The formula with its sources; `None` if the contact radius is not explicit.
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

    /// The conditions of validity, as tests and in words.
    fn domain(&mut self, quantity: Quantity) -> Result<(Vec<Test>, Vec<String>), CodeError> {
        let (mut tests, mut words) = (Vec::new(), Vec::new());
        let at_most = |name: &str, largest: f64| Test::Compare(Comparison::LessOrEqual, Value::name(name), Value::Number(largest, true));
        for own in coordinates(quantity) {
            let (largest, range) = match own {
                "d" => (f64::MAX, "d >= 0".to_owned()),
                _ => (LARGEST, format!("0 <= {own} <= {LARGEST:e}")),
            };
            tests.extend([compare(Comparison::GreaterOrEqual, own, 0.0), at_most(own, largest)]);
            words.push(range);
        }
        if is_of_depth(quantity) && explicit(self.solution).is_none() {
            words.push(self.largest_depth());
        }
        let mut positive = self.arguments.clone();
        if needs_modulus(quantity) {
            positive.insert(0, "E".to_owned());
        }
        for own in &positive {
            tests.extend([compare(Comparison::Greater, own, 0.0), at_most(own, f64::MAX)]);
            words.push(format!("{own} > 0"));
        }
        // Conditions on the radius do not apply to a depth; those on the parameters, as b < R, do.
        let radius = Symbol::new("r");
        let applies = |own: &&Condition| !is_of_depth(quantity) || !(own.left.contains(&radius) || own.right.contains(&radius));
        let is_new = |own: &&Condition| !(own.left.is_zero() && own.relation == Relation::Less && own.right.as_symbol().is_some());
        let conditions: Vec<Condition> = self.solution.conditions.iter().filter(applies).filter(is_new).cloned().collect();
        let coordinate = coordinates(quantity).last().copied().unwrap_or("a");
        self.conditions(&conditions, coordinate, &mut tests, &mut words)?;
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
                // Do not test equality of doubles; state the condition in words only.
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

    /// The sum of the chains; if there are several, each chain with breakpoints becomes a separate routine.
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

    /// The pieces of a chain, selected by the interval that contains the end of the contact.
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

    /// Renames the variables of a body to t1, t2, …, which are not names of parameters.
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

    /// Adds the stable forms that a routine calls, after their dependencies.
    pub(super) fn needed(&mut self, routine: &Routine, quantity: Quantity) -> Result<(), CodeError> {
        for name in routine.calls() {
            if ELEMENTARY.contains(&name.as_str()) || self.routines.iter().any(|own| own.name == name) {
                continue;
            }
            if self.language.target().library(&name).is_some() {
                continue;
            }
            let Some(form) = self.forms.iter().find(|own| own.name == name).cloned() else {
                let elsewhere = Language::ALL.iter().any(|own| own.target().library(&name).is_some());
                return Err(CodeError::Function { elsewhere, quantity: quantity.key(), function: name, language: self.language.title() });
            };
            self.needed(&form, quantity)?;
            self.routines.push(form);
        }
        Ok(())
    }

    /// The called functions of the language's library.
    fn library(&self) -> Vec<String> {
        let mut all: Vec<String> = self.routines.iter().flat_map(Routine::calls).collect();
        all.sort();
        all.dedup();
        all.retain(|name| !ELEMENTARY.contains(&name.as_str()) && !self.routines.iter().any(|own| own.name == *name));
        all
    }
}

fn has_sum(expr: &Expr) -> bool {
    expr.parts().any(|own| matches!(own.node(), Node::Sum(_)))
}

fn compare(comparison: Comparison, name: &str, number: f64) -> Test {
    Test::Compare(comparison, Value::name(name), Value::Number(number, true))
}

pub(super) fn when(test: Test, value: Value) -> Statement {
    Statement::If(test, vec![Statement::Return(value)], Vec::new())
}

impl Program {
    /// The accuracy claim for each quantity, and for g if another quantity is found by a search; `None` if no point with a bound was
    /// found.
    pub fn claims(&self) -> &[(Quantity, Option<Claim>)] {
        &self.claims
    }
}

impl Program {
    /// Whether the quantity is computed from a radius that solves g(a) = d, through which running bounds do not propagate.
    pub(super) fn is_solved(&self, quantity: Quantity) -> bool {
        let calls = |own: &Routine| own.calls().iter().any(|name| *name == routine_name(Quantity::Equivalent));
        is_of_depth(quantity) && self.routines.iter().any(|own| own.name == routine_name(quantity) && calls(own))
    }
}

impl Program {
    /// The requested quantities, and g if one of them is found by a search, which depends on g at all radii up to the root and beyond.
    pub(super) fn judged(&self) -> Vec<Quantity> {
        let is_searched = self.quantities.iter().any(|own| self.is_solved(*own)) && !self.quantities.contains(&Quantity::Equivalent);
        self.quantities.iter().copied().chain(is_searched.then_some(Quantity::Equivalent)).collect()
    }

    /// Whether a routine was requested by the caller.
    pub(super) fn is_public(&self, routine: &Routine) -> bool {
        self.quantities.iter().any(|own| routine_name(*own) == routine.name)
    }
}
