//! Formulas: what `sneddon derive`, `compare`, `invert` and `rules` print, as JSON documents.

use crate::error::Fault;
use crate::interrupt::{interruptible, written};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use sneddon::contact::{self, Edge, Setting, relations};
use sneddon::expr::{Bindings, Expr, Formula, Number, Symbol};
use sneddon::num::work::{self, Budget};
use sneddon::num::{Bound as Ground, Estimate};
use sneddon::parse;
use sneddon::print::Presentation;
use sneddon::report::{self, Compared, Derivation, Inversion, Unchecked, Wanted, inversion};
use sneddon::transform::{self, FromPressure, Inverse, InverseNumbers, Method, Profile, TransformError};

/// Steps of work that each radius of an inverted profile may take, beyond those of the call.
const STEPS: u64 = 300_000;

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
        let mut relations = relations(&solution, &edge)?;
        let check = transform::check(&solution).map_err(Unchecked::from);
        check.iter().for_each(|check| relations.confirm(check));
        let record = Derivation {
            solution: &solution,
            typed: &typed,
            edge: &edge,
            relations: &relations,
            asked: &[],
            presentation: &Presentation::of(&typed),
            check,
        };
        written(|out| report::json::derivation(&record, None, out))
    });
    Ok(document??)
}

/// The document that `sneddon compare --json` prints.
#[pyfunction]
#[pyo3(signature = (text, names, values, radius, depth, tolerance))]
pub(crate) fn compare(
    py: Python<'_>,
    text: &str,
    names: Vec<String>,
    values: Vec<String>,
    radius: Option<f64>,
    depth: Option<f64>,
    tolerance: Option<f64>,
) -> PyResult<String> {
    for (name, value) in [("radius", radius), ("depth", depth), ("tolerance", tolerance)] {
        if value.is_some_and(|own| !own.is_finite() || own < 0.0 || (own == 0.0 && name != "depth")) {
            let help = if name == "depth" { "a finite number from 0 on is accepted" } else { "a positive finite number is accepted" };
            return Err(Fault::new(format!("{name} = {} is not accepted", value.unwrap_or_default())).help(help).place(name).into());
        }
    }
    let typed = formula(text, &names, &values)?;
    let document = interruptible(py, || -> Result<String, Fault> {
        let place = |fault: Fault| fault.place(format!("profile {text}"));
        let profile = Profile::new(&typed).map_err(|error| place(error.into()))?;
        if profile.is_flat() && depth.is_none() {
            return Err(place(Fault::new("a flat profile without a rim does not define a contact").help("depth= makes it a punch")));
        }
        let solution = transform::derive(&profile).map_err(|error| place(error.into()))?;
        let comparisons = contact::compare(&solution, &Setting { radius, depth, tolerance }).map_err(|error| place(error.into()))?;
        written(|out| report::json::comparison(&Compared { profile: &typed, comparisons: &comparisons }, out))
    });
    Ok(document??)
}

/// What has a profile as its answer: g as typed, or the g of a wanted pressure.
struct Asked {
    equivalent: Formula,
    pressure: Option<(Expr, FromPressure)>,
}

impl Asked {
    fn read(text: &str, is_pressure: bool) -> Result<Self, Fault> {
        if !is_pressure {
            let equivalent = parse::equivalent(text).map_err(|error| Fault::parse("g", text, &error))?;
            return Ok(Self { equivalent, pressure: None });
        }
        let pressure = parse::pressure(text).map_err(|error| Fault::parse("pressure", text, &error))?;
        let found = transform::equivalent_of_pressure(&pressure)
            .map_err(|error| Fault::new(error.to_string()).place(format!("pressure {text}")))?;
        Ok(Self { equivalent: Formula::Closed(found.equivalent.clone()), pressure: Some((pressure, found)) })
    }
}

fn refusal(error: &TransformError) -> String {
    inversion::refusal(error, |text| parse::formula(text).ok()).unwrap_or_else(|| error.to_string())
}

fn inverse(text: &str, equivalent: &Formula) -> Result<Inverse, Fault> {
    transform::invert(equivalent, |text| parse::formula(text).ok()).map_err(|error| Fault::new(refusal(&error)).place(format!("g {text}")))
}

/// The document that `sneddon invert --json` prints.
#[pyfunction]
pub(crate) fn invert(py: Python<'_>, text: &str, pressure: bool) -> PyResult<String> {
    let document = interruptible(py, || -> Result<String, Fault> {
        let asked = Asked::read(text, pressure)?;
        let found = inverse(text, &asked.equivalent)?;
        let check = transform::check_inverse(&found).map_err(Unchecked::from);
        let wanted = asked.pressure.as_ref();
        let record = Inversion {
            pressure: wanted.map(|(pressure, own)| Wanted { pressure, depth: &own.depth, force: &own.force }),
            equivalent: &asked.equivalent,
            profile: found.profile(),
            at_axis: found.at_axis(),
            conditions: found.conditions.clone(),
            check,
            at: Vec::new(),
            readings: Vec::new(),
        };
        written(|out| inversion::json(&record, None, &Presentation::of(&asked.equivalent), out))
    });
    Ok(document??)
}

/// f at every radius, the bounds of its errors, and whether they are proven, for values of the parameters.
type Heights<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, Vec<bool>);

#[pyfunction]
pub(crate) fn inverted<'py>(
    py: Python<'py>,
    text: &str,
    pressure: bool,
    names: Vec<String>,
    values: Vec<f64>,
    radii: PyReadonlyArray1<'py, f64>,
) -> PyResult<Heights<'py>> {
    let radii = radii.as_slice()?.to_vec();
    let found = interruptible(py, || -> Result<Vec<Estimate>, Fault> {
        let bindings: Bindings = names
            .iter()
            .zip(&values)
            .map(|(name, value)| match Number::from_f64(*value).filter(|_| *value > 0.0) {
                Some(number) => Ok((name.as_str(), Expr::number(number))),
                None => Err(Fault::new(format!("{name} = {value} is not positive and finite")).place(format!("parameter {name}"))),
            })
            .collect::<Result<_, Fault>>()?;
        let typed = Asked::read(text, pressure)?.equivalent;
        let equivalent = typed.substitute(&bindings);
        let coordinate = Symbol::new("x");
        let known: Vec<Symbol> = typed.symbols().into_iter().filter(|own| *own != coordinate).collect();
        // What cancels on the way to g was typed; pressures know a and E.
        let is_typed = |name: &String| {
            pressure && matches!(name.as_str(), "a" | "E") || known.iter().chain(&parse::parameters(text)).any(|own| own.name() == name)
        };
        if let Some(name) = names.iter().find(|own| !is_typed(own)) {
            return Err(Fault::new(format!("the formula has no parameter {name}")).place(format!("parameter {name}")));
        }
        let open: Vec<&str> = known.iter().map(Symbol::name).filter(|own| names.iter().all(|name| name != own)).collect();
        if !open.is_empty() {
            return Err(Fault::new(format!("the parameter {} has no value", open.join(", "))).help("give it by keyword, such as R=2.0"));
        }
        let refused = |error: TransformError| Fault::new(refusal(&error)).place(format!("g {text}"));
        let numbers = InverseNumbers::new(&inverse(text, &equivalent)?, &Bindings::default(), Method::Auto, 1e-13).map_err(refused)?;
        let steps = Budget::DEFAULT.count().saturating_add(STEPS.saturating_mul(radii.len() as u64));
        work::within(Budget::steps(steps), || {
            let value = |(index, r): (usize, &f64)| {
                if !(r.is_finite() && *r >= 0.0) {
                    return Err(Fault::new(format!("r = {r} is not a number from 0 on")).place(format!("r, flat index {index}")));
                }
                work::check()?;
                numbers.value(*r).map(|own| own.estimate).map_err(refused)
            };
            radii.iter().enumerate().map(value).collect()
        })
    })??;
    let (heights, errors): (Vec<f64>, Vec<f64>) = found.iter().map(|own| (own.value, own.error)).unzip();
    let proven = found.iter().map(|own| own.bound == Ground::Proven).collect();
    Ok((heights.into_pyarray(py), errors.into_pyarray(py), proven))
}

/// The document that `sneddon rules --json` prints.
#[pyfunction]
pub(crate) fn rules() -> PyResult<String> {
    Ok(written(|out| report::json::rules(transform::rules::RULES, out))?)
}
