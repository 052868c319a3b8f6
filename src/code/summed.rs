//! Functions computed as sums at run time: power series near the axis, and Gaussian terms at every radius.

use super::build::{Builder, coordinates, when};
use super::lower::Names;
use super::program::routine_name;
use super::tree::{Comparison, Operator, Routine, Statement, Test, Value};
use super::{CodeError, gaussian, read, series};
use crate::contact::Quantity;
use crate::expr::Expr;
use crate::transform::Sampler;

/// The variable of the sum of a series; this name is reserved, so no parameter has it.
const SUM: &str = "t1000";

impl Builder<'_> {
    /// Adds the routine that sums the series of a quantity, and returns the statements that use it where it converges.
    pub(super) fn next_to_the_axis(&mut self, quantity: Quantity) -> Result<Vec<Statement>, CodeError> {
        let coordinate = coordinates(quantity).last().copied().unwrap_or("a");
        let profile = Expr::sum(self.solution.profile.chains.iter().filter_map(|own| own.pieces.first().cloned()));
        let is_force = quantity == Quantity::Force;
        let Some(sample) = Sampler::new(1).parameters(self.solution) else { return Ok(Vec::new()) };
        let Some(found) = series::text(&profile, coordinate, is_force, &sample) else { return Ok(Vec::new()) };
        self.counter = 0;
        let (mut body, mut renaming) = (Vec::new(), Names::new());
        for (name, constant) in &found.constants {
            let (statements, value) = self.lowered(constant)?;
            body.extend(statements);
            match value {
                Value::Name(own) => drop(renaming.insert(name.clone(), own)),
                value => body.push(Statement::Let(name.clone(), value)),
            }
        }
        let text = format!("fn series() {{ {} }}", found.body);
        let routine = read::routines(&text).and_then(|list| list.into_iter().next()).ok_or(CodeError::Forms)?;
        body.extend(routine.body.iter().map(|own| own.renamed(&renaming)));
        let parameters: Vec<String> = std::iter::once(coordinate.to_owned()).chain(self.arguments.iter().cloned()).collect();
        let what = if is_force { "The power series of F/(2 E)" } else { "The power series of g" };
        let routine = Routine {
            name: format!("{}_series", routine_name(quantity)),
            parameters: parameters.clone(),
            body: self.numbered(body),
            comment: vec![format!("{what} at {coordinate} = 0; NaN where it does not converge fast.")],
        };
        self.needed(&routine, quantity)?;
        let call = Value::Call(routine.name.clone(), parameters.iter().map(|own| Value::name(own)).collect());
        self.routines.push(routine);
        self.counter = 0;
        // Use the first pieces only.
        let mut tests = Vec::new();
        let mut statements = Vec::new();
        for chain in &self.solution.profile.chains {
            let Some(end) = chain.breakpoints.first() else { continue };
            let (before, end) = self.lowered(end)?;
            statements.extend(before);
            tests.push(Test::Compare(Comparison::LessOrEqual, Value::name(coordinate), end));
        }
        let times = |left: Value, right: Value| Value::binary(Operator::Multiply, left, right);
        let value = Value::name(SUM);
        let result = if is_force { times(times(Value::Number(2.0, true), Value::name("E")), value.clone()) } else { value.clone() };
        let is_finite = Test::Compare(Comparison::LessOrEqual, Value::call("abs", vec![value]), Value::Number(f64::MAX, true));
        let used = vec![Statement::Let(SUM.to_owned(), call), when(is_finite, result)];
        match tests.is_empty() {
            true => statements.extend(used),
            false => statements.push(Statement::If(Test::All(tests), used, Vec::new())),
        }
        Ok(statements)
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
