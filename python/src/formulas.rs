//! Formulas: what `sneddon derive` and `sneddon rules` print, as JSON documents.

use crate::error::Fault;
use crate::interrupt::interruptible;
use pyo3::prelude::*;
use sneddon::contact::{Edge, relations};
use sneddon::expr::{Bindings, Expr, Formula};
use sneddon::parse;
use sneddon::print::Renaming;
use sneddon::report::{self, Derivation, Unchecked};
use sneddon::transform::{self, Profile};

/// The profile of a text, with the values of its parameters as texts.
pub(crate) fn formula(text: &str, names: &[String], values: &[String]) -> Result<Formula, Fault> {
    let typed = parse::profile(text).map_err(|error| Fault::parse("profile", text, &error))?;
    let known = parse::parameters(text);
    let mut bindings = Vec::new();
    for (name, value) in names.iter().zip(values) {
        if !known.iter().any(|own| own.name() == name) {
            let list = known.iter().map(|own| own.name()).collect::<Vec<_>>().join(", ");
            let own = if list.is_empty() { "it has none".to_owned() } else { format!("it has {list}") };
            return Err(Fault::new(format!("the profile has no parameter {name}; {own}")).place(format!("parameter {name}")));
        }
        let place = format!("parameter {name}");
        let exact = parse::constant(value).map_err(|error| Fault::parse(&place, value, &error))?;
        bindings.push((name.as_str(), exact));
    }
    let bindings: Bindings = bindings.into_iter().collect();
    Ok(typed.substitute(&bindings))
}

/// The names of the parameters of a profile.
#[pyfunction]
pub(crate) fn parameters(text: &str) -> PyResult<Vec<String>> {
    let typed = parse::profile(text).map_err(|error| Fault::parse("profile", text, &error))?;
    drop(typed);
    Ok(parse::parameters(text).iter().map(|own| own.name().to_owned()).filter(|own| own != "r").collect())
}

/// The document that `sneddon derive --json` prints.
#[pyfunction]
pub(crate) fn derive(py: Python<'_>, text: &str, names: Vec<String>, values: Vec<String>, depth: Option<&str>) -> PyResult<String> {
    let rim = depth.map(|own| match own.trim() {
        "d" => Ok(Expr::symbol("d")),
        other => parse::constant(other).map_err(|error| Fault::parse("depth", other, &error)),
    });
    let edge = rim.transpose()?.map_or(Edge::Smooth, Edge::Rim);
    let typed = formula(text, &names, &values)?;
    let document = interruptible(py, || -> Result<String, Fault> {
        let place = |fault: Fault| fault.place(format!("profile {text}"));
        let profile = Profile::new(&typed).map_err(|error| place(error.into()))?;
        let solution = transform::derive(&profile).map_err(|error| place(error.into()))?;
        let relations = relations(&solution, &edge)?;
        let check = transform::check(&solution).map_err(Unchecked::from);
        let record = Derivation {
            profile: &profile,
            typed: &typed,
            edge: &edge,
            relations: &relations,
            asked: &[],
            names: &Renaming::default(),
            check,
        };
        let mut out = Vec::new();
        report::json::derivation(&record, None, &mut out).map_err(|error| Fault::new(error.to_string()))?;
        Ok(String::from_utf8_lossy(&out).into_owned())
    });
    Ok(document??)
}

/// The document that `sneddon rules --json` prints.
#[pyfunction]
pub(crate) fn rules() -> PyResult<String> {
    let mut out = Vec::new();
    report::json::rules(transform::rules::RULES, &mut out).map_err(|error| Fault::new(error.to_string()))?;
    Ok(String::from_utf8_lossy(&out).into_owned())
}
