//! Functions computed as sums at run time: power series near the axis, quadrature beyond it, and Gaussian terms at every radius.

mod quadrature;

use super::accuracy::Machine;
use super::build::{Builder, coordinates, when};
use super::lower::{Names, lowered};
use super::program::{Sum, routine_name};
use super::tree::{Comparison, Operator, Routine, Statement, Test, Value};
use super::{CodeError, gaussian, read, series};
use crate::contact::Quantity;
use crate::expr::{Expr, Number, Symbol, collected, over_one_denominator};
use crate::transform::Sampler;
use std::f64::consts::FRAC_1_PI;

/// The number of the first variable for a sum.
const FIRST_SUM: usize = 1000;

/// The statements of a body.
fn read_body(text: &str) -> Result<Vec<Statement>, CodeError> {
    let routine = read::routines(&format!("fn sum() {{ {text} }}")).and_then(|list| list.into_iter().next());
    Ok(routine.ok_or(CodeError::Forms)?.body)
}

impl Builder<'_> {
    /// Adds the routines that sum the series of a quantity, or its quadrature, and returns the statements that use them in this order.
    pub(super) fn summed(&mut self, quantity: Quantity, ways: &[Sum]) -> Result<Vec<Statement>, CodeError> {
        let coordinate = coordinates(quantity).last().copied().unwrap_or("a");
        let profile = Expr::sum(self.solution.profile.chains.iter().filter_map(|own| own.pieces.first().cloned()));
        let is_force = quantity == Quantity::Force;
        let places = coordinates(quantity).into_iter().map(str::to_owned);
        let parameters: Vec<String> = places.chain(self.arguments.iter().cloned()).collect();
        let mut used = Vec::new();
        for way in ways {
            self.counter = 0;
            let body = match way {
                Sum::Series => self.series(&profile, quantity, *ways == [Sum::Series])?,
                Sum::Quadrature if quantity == Quantity::Pressure => None,
                Sum::Quadrature => self.quadrature(coordinate, is_force)?,
            };
            let Some(body) = body else { continue };
            let of = match quantity {
                Quantity::Force => "F/(2 E)",
                Quantity::Pressure => "pi p/E",
                _ => "g",
            };
            let (ending, comment) = match way {
                Sum::Series => (
                    "series",
                    format!(
                        "The power series of {of} at {coordinate} = 0; NaN where it does not converge fast and another formula is used."
                    ),
                ),
                Sum::Quadrature => (
                    "quadrature",
                    format!("The integral for {of} by a Gauss-Kronrod rule; NaN where it is not accurate and another formula is used."),
                ),
            };
            let routine = Routine {
                name: format!("{}_{ending}", routine_name(quantity)),
                parameters: parameters.clone(),
                body: self.numbered(body),
                comment: vec![comment],
            };
            self.needed(&routine, quantity)?;
            let call = Value::Call(routine.name.clone(), parameters.iter().map(|own| Value::name(own)).collect());
            self.routines.push(routine);
            // These names are reserved, so no parameter has them.
            let name = format!("t{}", FIRST_SUM + *way as usize);
            let times = |left: Value, right: Value| Value::binary(Operator::Multiply, left, right);
            let value = Value::name(&name);
            let result = match quantity {
                Quantity::Force => times(times(Value::Number(2.0, true), Value::name("E")), value.clone()),
                Quantity::Pressure => times(times(Value::Number(FRAC_1_PI, false), Value::name("E")), value.clone()),
                _ => value.clone(),
            };
            let is_finite = Test::Compare(Comparison::LessOrEqual, Value::call("abs", vec![value]), Value::Number(f64::MAX, true));
            let statements = vec![Statement::Let(name, call), when(is_finite, result)];
            self.counter = 0;
            used.extend(if *way == Sum::Series { self.in_first_pieces(coordinate, statements)? } else { statements });
        }
        self.counter = 0;
        Ok(used)
    }

    /// The statements, executed where the coordinate lies in the first piece of every chain.
    fn in_first_pieces(&mut self, coordinate: &str, list: Vec<Statement>) -> Result<Vec<Statement>, CodeError> {
        let (mut tests, mut statements) = (Vec::new(), Vec::new());
        for chain in &self.solution.profile.chains {
            let Some(end) = chain.breakpoints.first() else { continue };
            let (before, end) = self.lowered(end)?;
            statements.extend(before);
            tests.push(Test::Compare(Comparison::LessOrEqual, Value::name(coordinate), end));
        }
        match tests.is_empty() {
            true => statements.extend(list),
            false => statements.push(Statement::If(Test::All(tests), list, Vec::new())),
        }
        Ok(statements)
    }

    /// The body of the routine that sums a series; `None` if no recurrence of its coefficients is known.
    fn series(&mut self, profile: &Expr, quantity: Quantity, is_alone: bool) -> Result<Option<Vec<Statement>>, CodeError> {
        let coordinate = coordinates(quantity).last().copied().unwrap_or("a");
        let Some(sample) = Sampler::new(1).parameters(self.solution) else { return Ok(None) };
        let Some(found) = series::text(profile, coordinate, quantity, is_alone, &sample) else { return Ok(None) };
        let (mut body, mut renaming) = (Vec::new(), Names::new());
        for (name, constant) in &found.constants {
            let (statements, value) = self.lowered(constant)?;
            body.extend(statements);
            match value {
                Value::Name(own) => drop(renaming.insert(name.clone(), own)),
                value => body.push(Statement::Let(name.clone(), value)),
            }
        }
        body.extend(read_body(&found.body)?.iter().map(|own| own.renamed(&renaming)));
        Ok(Some(body))
    }

    /// The body of the routine that integrates f′ over every piece; `None` if f′ is not a formula.
    fn quadrature(&mut self, coordinate: &str, is_force: bool) -> Result<Option<Vec<Statement>>, CodeError> {
        let mut names = self.names.clone();
        names.insert("r".to_owned(), "_r".to_owned());
        let zero = |own: &str| Statement::Let(own.to_owned(), Value::Number(0.0, true));
        let mut body: Vec<Statement> = quadrature::VARIABLES.map(zero).to_vec();
        for chain in &self.solution.profile.chains {
            let Ok(slopes) = chain.f_primes() else { return Ok(None) };
            let mut ends = Vec::new();
            for own in &chain.breakpoints {
                let (statements, value) = self.lowered(own)?;
                self.counter += 1;
                ends.push(format!("t{}", self.counter));
                body.extend(statements.into_iter().chain(ends.last().map(|name| Statement::Let(name.clone(), value))));
            }
            for (index, f_prime) in slopes.iter().enumerate().filter(|own| !own.1.is_zero()) {
                let (statements, value) = self.f_prime(f_prime, &names)?;
                let lower = index.checked_sub(1).and_then(|before| ends.get(before)).cloned();
                let extent = quadrature::Extent { lower, upper: ends.get(index).cloned() };
                let mut piece = read_body(&quadrature::piece(coordinate, is_force, &extent))?;
                for own in &mut piece {
                    own.replace(&Value::name(quadrature::PLACEHOLDER), &statements, &value);
                }
                body.extend(piece);
            }
        }
        body.extend(read_body(&quadrature::result(coordinate, is_force))?);
        Ok(Some(body))
    }

    /// The statements that compute f′ at `_r`, and its value: from the derivative with its factors collected, as it is, or over one
    /// denominator, whichever has the smallest running bounds over six decades.
    fn f_prime(&mut self, f_prime: &Expr, names: &Names) -> Result<(Vec<Statement>, Value), CodeError> {
        let sample = Sampler::new(1).parameters(self.solution).unwrap_or_default();
        let number = |own: &Symbol| sample.apply(&Expr::from(own.clone())).as_number().map_or(f64::NAN, Number::to_f64);
        let numbers: Vec<f64> = self.solution.profile.parameters().iter().map(number).collect();
        let parameters: Vec<String> = std::iter::once("_r".to_owned()).chain(self.arguments.iter().cloned()).collect();
        let mut best: Option<(f64, usize, (Vec<Statement>, Value))> = None;
        for own in [collected(f_prime), f_prime.clone()].into_iter().chain(over_one_denominator(f_prime)) {
            let mut counter = self.counter;
            let (statements, value) = lowered(&own, names, &mut counter)?;
            let body = statements.iter().cloned().chain([Statement::Return(value.clone())]).collect();
            let routine = Routine { name: "f_prime".to_owned(), parameters: parameters.clone(), body, comment: Vec::new() };
            let bound = self.bound(routine, &numbers);
            if best.as_ref().is_none_or(|(least, ..)| bound < *least) {
                best = Some((bound, counter, (statements, value)));
            }
        }
        let (_, counter, found) = best.ok_or(CodeError::Forms)?;
        self.counter = counter;
        Ok(found)
    }

    /// The sum of the logarithms of relative running bounds of a routine of r.
    fn bound(&self, routine: Routine, numbers: &[f64]) -> f64 {
        let name = routine.name.clone();
        let routines: Vec<Routine> = self.forms.iter().cloned().chain([routine]).collect();
        let library = |name: &str| self.language.target().library(name).map(|(_, ulps)| ulps);
        let mut machine = Machine::new(&routines, &library);
        let relative = |r: f64| {
            machine.start_record();
            let own = machine.traced(&name, &[&[r], numbers].concat())?;
            Some((machine.error(&[(own, 1.0)]) / own.bounded.value.abs()).clamp(f64::EPSILON, 1.0).ln())
        };
        (-12..=12).map(|step| 10f64.powf(0.25 * f64::from(step))).filter_map(relative).filter(|own| own.is_finite()).sum()
    }

    /// Returns the statements that sum Gaussian terms, if the profile has no other terms; `None` for g without powers of r, whose
    /// closed form is accurate.
    pub(super) fn sum_of_gaussians(&mut self, quantity: Quantity, factor: &Expr) -> Result<Option<Vec<Statement>>, CodeError> {
        let [chain] = self.solution.profile.chains.as_slice() else { return Ok(None) };
        let ([profile], []) = (chain.pieces.as_slice(), chain.breakpoints.as_slice()) else { return Ok(None) };
        let Some(list) = gaussian::gaussians(profile) else { return Ok(None) };
        let is_force = quantity == Quantity::Force;
        if !is_force && list.iter().any(|own| own.j == 0) {
            return Ok(None);
        }
        self.counter = 0;
        let coordinate = Expr::symbol(coordinates(quantity).last().copied().unwrap_or("a"));
        let (mut body, mut total): (Vec<Statement>, Option<Value>) = (Vec::new(), None);
        for own in list {
            let order = 2 * i64::from(own.j) + i64::from(is_force);
            let (before, front) = self.lowered(&(own.factor * own.kappa.power(-order) * factor))?;
            let (more, argument) = self.lowered(&(own.kappa * &coordinate))?;
            body.extend(before.into_iter().chain(more));
            let form = if is_force { "gaussian_force" } else { "gaussian_equivalent" };
            let part = Value::binary(Operator::Multiply, front, Value::call(form, vec![Value::Number(f64::from(own.j), true), argument]));
            total = Some(match total {
                None => part,
                Some(sum) => Value::binary(Operator::Add, sum, part),
            });
        }
        body.extend(total.map(Statement::Return));
        Ok(Some(body))
    }
}
