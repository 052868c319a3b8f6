//! Numbers: the quantities of a contact over flat arrays, each value with its error bound.

use crate::error::Fault;
use crate::formulas::formula;
use crate::interrupt::interruptible;
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::{PyArithmeticError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use self_cell::self_cell;
use sneddon::contact::{Absence, Contact, ContactError, Indentation, Kind, Load, Measured, Part, Quantity, Setup, each_point, explicit};
use sneddon::expr::{Bindings, Expr, Number};
use sneddon::num::work::{self, Budget};
use sneddon::num::{Bound as Ground, Estimate};
use sneddon::parse;
use sneddon::transform::{self, Closure, ClosureProfile, Evaluator, Interpolation, Method, Profile, Slice, TableProfile};
use std::ops::Range;
use std::sync::{Arc, Mutex};

type FormulaContact<'a> = Contact<'a>;

self_cell!(
    /// A solution with the contact that borrows it.
    struct Solved {
        owner: transform::Solution,
        #[not_covariant]
        dependent: FormulaContact,
    }
);

/// What answers.
enum Shape {
    Formula {
        solved: Solved,
        /// True where the depth is given and the contact ends at a rim.
        has_rim: bool,
    },
    Table(Contact<'static, TableProfile>),
    /// A function of Python, with the first exception that it raised.
    Function {
        contact: Contact<'static, ClosureProfile>,
        raised: Raised,
    },
}

type Raised = Arc<Mutex<Option<PyErr>>>;

/// The quantity with a key.
fn quantity(key: &str) -> Result<Quantity, Fault> {
    Quantity::of(key).ok_or_else(|| Fault::new(format!("{key} is not a quantity")))
}

/// Every quantity: its key, what it is a function of, the name of its coordinate, and its title.
#[pyfunction]
pub(crate) fn quantities() -> Vec<(&'static str, &'static str, &'static str, &'static str)> {
    let kind = |own: Quantity| match own.kind() {
        Kind::Shape => "shape",
        Kind::Number => "number",
        Kind::Inverse => "inverse",
        Kind::Field => "field",
    };
    Quantity::ALL.iter().map(|own| (own.key(), kind(*own), argument(*own), own.title())).collect()
}

/// The name of the argument that belongs to a coordinate.
fn argument(quantity: Quantity) -> &'static str {
    match quantity.coordinate() {
        "a" => "radius",
        "d" => "depth",
        "F" => "force",
        place => place,
    }
}

/// A contact with numbers for all parameters.
#[pyclass(frozen, module = "sneddon._sneddon")]
pub(crate) struct Engine {
    shape: Shape,
    tolerance: f64,
    method: Method,
}

/// Steps of work that each point may take, beyond those of the call.
const STEPS: u64 = 300_000;

#[pymethods]
impl Engine {
    /// The engine of a formula; values of parameters are 64-bit floats, and so is the depth of a punch with a rim.
    ///
    /// `exact` holds the names and the texts of parameters that are substituted without rounding.
    #[staticmethod]
    #[allow(clippy::too_many_arguments)]
    fn formula(
        py: Python<'_>,
        text: &str,
        names: Vec<String>,
        values: Vec<f64>,
        exact: (Vec<String>, Vec<String>),
        effective_modulus: f64,
        method: &str,
        tolerance: f64,
        depth: Option<f64>,
    ) -> PyResult<Self> {
        let method = match method {
            "auto" => Method::Auto,
            "exact" => Method::Exact,
            "quadrature" => Method::Quadrature,
            other => {
                return Err(Fault::new(format!("method {other:?} is not known")).help("auto, exact and quadrature are accepted").into());
            }
        };
        let made = interruptible(py, || -> Result<Self, Fault> {
            let typed = formula(text, &exact.0, &exact.1)?;
            let nearest = |value: f64| Number::from_f64(value).map(Expr::number);
            let mut bindings = Vec::new();
            for (name, value) in names.iter().zip(&values) {
                let number = nearest(*value).filter(|_| *value > 0.0);
                let Some(number) = number else {
                    return Err(Fault::new(format!("{name} = {value} is not positive and finite"))
                        .help("parameters are positive; the sign belongs into the profile")
                        .place(format!("parameter {name}")));
                };
                if !exact.0.contains(name) {
                    bindings.push((name.as_str(), number));
                }
            }
            let known = parse::parameters(text);
            if let Some(name) = names.iter().find(|own| known.iter().all(|known| known.name() != own.as_str())) {
                return Err(Fault::new(format!("the profile has no parameter {name}")).place(format!("parameter {name}")));
            }
            let bound = typed.substitute(&bindings.into_iter().collect::<Bindings>());
            let about = |fault: Fault| fault.place(format!("profile {text}"));
            let profile = Profile::new(&bound).map_err(|error| about(error.into()))?;
            let free: Vec<String> = profile.parameters().iter().map(|own| own.name().to_owned()).collect();
            if !free.is_empty() {
                return Err(
                    Fault::new(format!("the parameter {} has no value", free.join(", "))).help("give it by keyword: Profile(text, R=2.0)")
                );
            }
            if profile.is_flat() && depth.is_none() {
                return Err(Fault::new("a flat profile without a rim does not define a contact")
                    .help("sneddon.solve takes a punch: a profile with a radius"));
            }
            let solution = transform::derive(&profile).map_err(|error| about(error.into()))?;
            let solved = Solved::try_new(solution, |solution| {
                let evaluator = Evaluator::new(solution, &Bindings::default(), method, tolerance).map_err(Fault::from)?;
                let contact = Contact::new(evaluator, effective_modulus, depth, tolerance);
                let is_searched = method == Method::Quadrature || depth.is_some();
                Ok::<_, Fault>(if is_searched { contact } else { contact.with_explicit(explicit(solution), false) })
            })?;
            Ok(Self { shape: Shape::Formula { solved, has_rim: depth.is_some() }, tolerance, method })
        });
        Ok(made??)
    }

    /// The engine of a measured tip: heights z over radii r, joined by a cubic spline without overshoot.
    #[staticmethod]
    fn points(
        py: Python<'_>,
        r: PyReadonlyArray1<'_, f64>,
        z: PyReadonlyArray1<'_, f64>,
        effective_modulus: f64,
        tolerance: f64,
    ) -> PyResult<Self> {
        let (r, z) = (r.as_slice()?.to_vec(), z.as_slice()?.to_vec());
        let made = interruptible(py, || -> Result<Self, Fault> {
            let profile = Profile::from_points(&r, &z, Interpolation::MonotoneCubic)?;
            Ok(Self { shape: Shape::Table(Contact::new(profile, effective_modulus, None, tolerance)), tolerance, method: Method::Auto })
        });
        Ok(made??)
    }

    /// The engine of a function of Python: f of one 64-bit float, with the radii of its kinks and the end of its domain.
    #[staticmethod]
    fn function(f: Py<PyAny>, kinks: Vec<f64>, end: Option<f64>, effective_modulus: f64, tolerance: f64) -> PyResult<Self> {
        let raised = Raised::default();
        let kept = Arc::clone(&raised);
        let call = move |r: f64| {
            if work::is_exhausted() {
                return f64::NAN;
            }
            Python::attach(|py| {
                // A function that raised an exception is not called again.
                if kept.lock().is_ok_and(|own| own.as_ref().is_some_and(|error| !is_numeric(error))) {
                    return f64::NAN;
                }
                let found = f.call1(py, (r,)).and_then(|own| own.extract::<f64>(py));
                found.unwrap_or_else(|error| {
                    if let Ok(mut own) = kept.lock() {
                        own.get_or_insert(error);
                    }
                    f64::NAN
                })
            })
        };
        let mut closure = Closure::real(call).breakpoints(kinks).tolerance(tolerance.max(1e-10));
        if let Some(end) = end {
            closure = closure.limit(end);
        }
        let made = closure.profile();
        // Where the function has no value, as beyond the end of a sphere, nothing is wrong with it.
        if let Some(error) = taken(&raised).filter(|error| made.is_err() || !is_numeric(error)) {
            return Err(error);
        }
        let contact = Contact::new(made.map_err(Fault::from)?, effective_modulus, None, tolerance.max(1e-10));
        Ok(Self { shape: Shape::Function { contact, raised }, tolerance: tolerance.max(1e-10), method: Method::Auto })
    }

    /// One value, its bound, and whether the bound is proven.
    #[pyo3(signature = (key, at, radius=None))]
    fn one(&self, py: Python<'_>, key: &str, at: f64, radius: Option<f64>) -> PyResult<(f64, f64, bool)> {
        let wanted = quantity(key)?;
        check(wanted, at, None)?;
        if let Some(a) = radius.filter(|_| wanted.needs_radius()) {
            check(Quantity::Depth, a, None)?;
        }
        let cheap = matches!(&self.shape, Shape::Formula { solved, .. } if solved.borrow_owner().is_closed());
        let read = || self.read(wanted, at, radius.unwrap_or(at));
        let found = if cheap { read() } else { interruptible(py, read)? }?;
        Ok((found.value, found.error, found.bound == Ground::Proven))
    }

    /// Whether each load is a valid contact: pressure and gap are nowhere negative. A load that cannot be reached is not.
    fn valid(&self, py: Python<'_>, name: &str, at: PyReadonlyArray1<'_, f64>) -> PyResult<Vec<bool>> {
        let (load, wanted): (fn(f64) -> Load, _) = match name {
            "depth" => (Load::Depth, Quantity::Radius),
            "force" => (Load::Force, Quantity::RadiusOfForce),
            "radius" => (Load::Radius, Quantity::Depth),
            other => return Err(Fault::new(format!("{other} is not a load")).into()),
        };
        let at = at.as_slice()?;
        for (index, value) in at.iter().enumerate() {
            check(wanted, *value, (at.len() > 1).then_some(index))?;
        }
        let steps = Budget::DEFAULT.count().saturating_mul(1 + at.len() as u64);
        let largest = load(at.iter().copied().fold(0.0, f64::max));
        Ok(interruptible(py, || {
            work::within(Budget::steps(steps), || self.verdicts(&at.iter().map(|own| load(*own)).collect::<Vec<_>>(), largest))
        })??)
    }

    /// Values, with bounds and whether they are proven where arrays are given for them, at every entry of `at`; arrays are contiguous and of
    /// one length.
    #[allow(clippy::too_many_arguments)]
    fn many(
        &self,
        py: Python<'_>,
        key: &str,
        at: PyReadonlyArray1<'_, f64>,
        radius: Option<PyReadonlyArray1<'_, f64>>,
        values: &Bound<'_, PyArray1<f64>>,
        bounds: Option<&Bound<'_, PyArray1<f64>>>,
        grounds: Option<&Bound<'_, PyArray1<bool>>>,
    ) -> PyResult<()> {
        let wanted = quantity(key)?;
        let at = at.as_slice()?;
        let radius = radius.as_ref().map(|own| own.as_slice()).transpose()?;
        let mut values = values.try_readwrite()?;
        let mut bounds = bounds.map(|own| own.try_readwrite()).transpose()?;
        let values = values.as_slice_mut()?;
        let mut bounds = bounds.as_mut().map(|own| own.as_slice_mut()).transpose()?;
        let mut grounds = grounds.map(|own| own.try_readwrite()).transpose()?;
        let mut grounds = grounds.as_mut().map(|own| own.as_slice_mut()).transpose()?;
        if at.len() != values.len() || radius.is_some_and(|own| own.len() != at.len()) {
            return Err(Fault::new("the arrays have different lengths").into());
        }
        interruptible(py, || {
            in_blocks(at.len(), |range| {
                let radius = radius.and_then(|own| own.get(range.clone()));
                let bounds = bounds.as_mut().and_then(|own| own.get_mut(range.clone()));
                let grounds = grounds.as_mut().and_then(|own| own.get_mut(range.clone()));
                match (at.get(range.clone()), values.get_mut(range.clone())) {
                    (Some(at), Some(values)) => self.block(wanted, range.start, at, radius, Out { values, bounds, grounds }),
                    _ => Ok(()),
                }
            })
        })??;
        Ok(())
    }
}

/// Runs over blocks, each with a budget of its own.
fn in_blocks(count: usize, mut run: impl FnMut(Range<usize>) -> Result<(), Fault>) -> Result<(), Fault> {
    const BLOCK: usize = 1 << 16;
    (0..count).step_by(BLOCK).try_for_each(|start| run(start..count.min(start + BLOCK)))
}

/// Refuses what is no radius, depth or force.
fn check(wanted: Quantity, value: f64, index: Option<usize>) -> Result<(), Fault> {
    if value.is_finite() && value >= 0.0 {
        return Ok(());
    }
    let name = argument(wanted);
    let place = index.map_or_else(|| name.to_owned(), |index| format!("{name}, flat index {index}"));
    Err(Fault::new(format!("{name} = {value} is not a number from 0 on")).help("finite numbers from 0 on are accepted").place(place))
}

/// Where the numbers of a block go.
struct Out<'a> {
    values: &'a mut [f64],
    bounds: Option<&'a mut [f64]>,
    grounds: Option<&'a mut [bool]>,
}

impl Engine {
    fn block(&self, wanted: Quantity, offset: usize, at: &[f64], radius: Option<&[f64]>, mut out: Out<'_>) -> Result<(), Fault> {
        for (index, value) in at.iter().enumerate() {
            check(wanted, *value, Some(offset + index))?;
        }
        for (index, value) in radius.unwrap_or_default().iter().enumerate() {
            check(Quantity::Depth, *value, Some(offset + index))?;
        }
        let steps = Budget::DEFAULT.count().saturating_add(STEPS.saturating_mul(at.len() as u64));
        work::within(Budget::steps(steps), || {
            // Closed forms at many places do not say what their bounds rest on, and their errors do not say at which place.
            if out.grounds.is_none() && matches!(self.slice(wanted, at, out.values, out.bounds.as_deref_mut()), Ok(true)) {
                return Ok(());
            }
            let points: Vec<(f64, f64)> = match radius {
                Some(radius) => at.iter().copied().zip(radius.iter().copied()).collect(),
                None => at.iter().map(|at| (*at, *at)).collect(),
            };
            for (index, found) in self.each(wanted, &points).into_iter().enumerate() {
                let found = found.map_err(|absence| match absence {
                    Absence::Failed(fault) => fault.place(format!("flat index {}", offset + index)),
                    Absence::Unfinished => Fault::from(work::exhausted()).place(format!("flat index {}", offset + index)),
                })?;
                if let Some(own) = out.values.get_mut(index) {
                    *own = found.value;
                }
                if let Some(own) = out.bounds.as_mut().and_then(|own| own.get_mut(index)) {
                    *own = found.error;
                }
                if let Some(own) = out.grounds.as_mut().and_then(|own| own.get_mut(index)) {
                    *own = found.bound == Ground::Proven;
                }
            }
            Ok(())
        })
    }

    /// The value at every place and contact radius, up to the first one without a value, which ends an array.
    fn each(&self, wanted: Quantity, points: &[(f64, f64)]) -> Vec<Result<Estimate, Absence<Fault>>> {
        let mut has_failed = false;
        let mut until = |read: &dyn Fn(f64, f64) -> Result<Estimate, Fault>| {
            each_point(points, 1, |block: &[(f64, f64)]| {
                let found = if has_failed { Err(work::exhausted().into()) } else { block.iter().map(|(at, a)| read(*at, *a)).collect() };
                has_failed |= found.is_err();
                found
            })
        };
        match (&self.shape, points) {
            (Shape::Formula { solved, .. }, [(_, a), ..]) if wanted == Quantity::Pressure && points.iter().all(|own| own.1 == *a) => solved
                .with_dependent(|_, contact| {
                    let contact = contact.for_pressures(*a, points.len());
                    until(&|at, a| told(wanted, wanted.number(&contact, at, a)?))
                }),
            _ => until(&|at, a| self.read(wanted, at, a)),
        }
    }

    /// Closed forms of one argument, straight into the buffers; false where there is no such way.
    fn slice(&self, wanted: Quantity, at: &[f64], values: &mut [f64], bounds: Option<&mut [f64]>) -> Result<bool, Fault> {
        let Shape::Formula { solved, has_rim: false, .. } = &self.shape else { return Ok(false) };
        if !matches!(wanted, Quantity::Profile | Quantity::Equivalent | Quantity::Depth | Quantity::Force) {
            return Ok(false);
        }
        solved.with_dependent(|_, contact| {
            let evaluator = contact.evaluator();
            let mut bounds = bounds;
            let out = Slice { errors: bounds.as_deref_mut(), ..Slice::values(values) };
            match wanted {
                Quantity::Profile => evaluator.heights(at, out)?,
                Quantity::Force => evaluator.forces(at, out)?,
                _ => evaluator.equivalents(at, out)?,
            }
            if wanted == Quantity::Force {
                let twice = 2.0 * contact.effective_modulus();
                for (index, value) in values.iter_mut().enumerate() {
                    *value *= twice;
                    if let Some(own) = bounds.as_mut().and_then(|own| own.get_mut(index)) {
                        *own = *own * twice + 0.5 * f64::EPSILON * value.abs();
                    }
                    if !value.is_finite() {
                        return Err(Fault::new(format!("F({}) is larger than a 64-bit float", at.get(index).unwrap_or(&f64::NAN))));
                    }
                }
            }
            Ok(true)
        })
    }

    fn verdicts(&self, loads: &[Load], largest: Load) -> Result<Vec<bool>, Fault> {
        let setup = |effective_modulus| Setup { effective_modulus, rim: None, tolerance: self.tolerance, method: self.method };
        let judge = |indentation: &Indentation<'_>| -> Result<Vec<bool>, ContactError> {
            loads.iter().map(|load| Ok(indentation.solve(*load)?.is_valid())).collect()
        };
        let of_part = |part: Part<'_>, modulus| judge(&Indentation::beside(None, vec![part], setup(modulus), largest)?);
        let found = match &self.shape {
            Shape::Formula { solved, .. } => {
                let modulus = solved.with_dependent(|_, contact| contact.effective_modulus());
                Indentation::new(solved.borrow_owner(), setup(modulus), largest).and_then(|own| judge(&own))
            }
            Shape::Table(contact) => of_part(Part::new(contact.shared_evaluator()), contact.effective_modulus()),
            Shape::Function { contact, raised } => {
                let found = of_part(Part::new(contact.shared_evaluator()), contact.effective_modulus());
                if let Some(error) = taken(raised).filter(|error| !is_numeric(error)) {
                    return Err(Fault::raised(error));
                }
                found
            }
        };
        Ok(found?)
    }

    fn read(&self, wanted: Quantity, at: f64, a: f64) -> Result<Estimate, Fault> {
        match &self.shape {
            Shape::Formula { solved, .. } => solved.with_dependent(|_, contact| told(wanted, wanted.number(contact, at, a)?)),
            Shape::Table(contact) => told(wanted, wanted.number(contact, at, a)?),
            Shape::Function { contact, raised } => {
                let found = wanted.number(contact, at, a).map_err(Fault::from).and_then(|own| told(wanted, own));
                match (taken(raised), found) {
                    // Where the function has no value, as beyond the end of a sphere, a search goes on without it.
                    (Some(error), found) if is_numeric(&error) => {
                        found.map_err(|fault| fault.help(format!("the function raised {error}; end= says where a profile ends")))
                    }
                    (Some(error), _) => Err(Fault::raised(error)),
                    // The slope at the apex is known from samples only.
                    (None, Ok(own)) if own.value.is_infinite() => Ok(Estimate { bound: Ground::Estimated, ..own }),
                    (None, found) => found,
                }
            }
        }
    }
}

/// The exception that was kept.
fn taken(raised: &Raised) -> Option<PyErr> {
    raised.lock().ok().and_then(|mut own| own.take())
}

/// Returns true for what functions of numbers raise where they have no value: a domain error, a division by zero, an overflow, or a
/// complex number, which Python returns for roots of negative ones.
fn is_numeric(error: &PyErr) -> bool {
    Python::attach(|py| {
        let is_complex = || {
            error.is_instance_of::<PyTypeError>(py)
                && [" not complex", "'complex'"].iter().any(|own| error.value(py).to_string().contains(own))
        };
        error.is_instance_of::<PyValueError>(py) || error.is_instance_of::<PyArithmeticError>(py) || is_complex()
    })
}

/// A value with its bound; infinite by theory is infinite without an error.
fn told(wanted: Quantity, measured: Measured) -> Result<Estimate, Fault> {
    match measured {
        Ok(own) => Ok(own.estimate),
        // σ_zz on the surface is −p.
        Err(reason) => match reason.infinite_pressure() {
            Some(own) => Ok(Estimate::exact(if wanted == Quantity::AxialStress { -own } else { own })),
            None => Err(Fault::new(reason.text())),
        },
    }
}
