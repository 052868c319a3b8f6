//! Numbers: the quantities of a contact over flat arrays, each value with its error bound.

use crate::error::Fault;
use crate::formulas::formula;
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;
use self_cell::self_cell;
use sneddon::contact::{Contact, ContactError, Explicit, Measured, Reason, explicit};
use sneddon::expr::{Bindings, Expr, Number};
use sneddon::num::roots::{RootOptions, bracketed};
use sneddon::num::work::{self, Budget};
use sneddon::parse;
use sneddon::transform::{self, Closure, ClosureProfile, Evaluator, Interpolation, Method, Profile, Quantities, Slice, TableProfile};
use std::ops::Range;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

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
        inverse: Option<Explicit>,
    },
    Table(Contact<'static, TableProfile>),
    /// A function of Python, with the first exception that it raised.
    Function {
        contact: Contact<'static, ClosureProfile>,
        raised: Raised,
    },
}

type Raised = Arc<Mutex<Option<PyErr>>>;

/// A quantity by its key.
#[derive(Clone, Copy, PartialEq)]
enum Wanted {
    Profile,
    Equivalent,
    Integral,
    Depth,
    Force,
    Stiffness,
    Energy,
    MeanPressure,
    RadiusOfDepth,
    RadiusOfForce,
    ForceOfDepth,
    DepthOfForce,
    Pressure,
    Displacement,
    AxialStress,
}

impl Wanted {
    fn of(key: &str) -> Result<Self, Fault> {
        Ok(match key {
            "f" => Self::Profile,
            "g" => Self::Equivalent,
            "G" => Self::Integral,
            "d" => Self::Depth,
            "F" => Self::Force,
            "k" => Self::Stiffness,
            "U" => Self::Energy,
            "p_mean" => Self::MeanPressure,
            "a_of_d" => Self::RadiusOfDepth,
            "a_of_F" => Self::RadiusOfForce,
            "F_of_d" => Self::ForceOfDepth,
            "d_of_F" => Self::DepthOfForce,
            "p" => Self::Pressure,
            "u" => Self::Displacement,
            "sigma_zz" => Self::AxialStress,
            other => return Err(Fault::new(format!("{other} is not a quantity"))),
        })
    }

    /// Whether values belong to a place and a contact radius.
    fn has_radius(self) -> bool {
        matches!(self, Self::Pressure | Self::Displacement | Self::AxialStress)
    }

    /// The symbol of the argument.
    fn argument(self) -> &'static str {
        match self {
            Self::Profile | Self::Pressure | Self::Displacement => "r",
            Self::Equivalent | Self::Integral => "x",
            Self::AxialStress => "z",
            Self::RadiusOfDepth | Self::ForceOfDepth => "depth",
            Self::RadiusOfForce | Self::DepthOfForce => "force",
            _ => "radius",
        }
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
    /// The engine of a formula; values of parameters are 64-bit floats.
    #[staticmethod]
    fn formula(
        py: Python<'_>,
        text: &str,
        names: Vec<String>,
        values: Vec<f64>,
        effective_modulus: f64,
        method: &str,
        tolerance: f64,
    ) -> PyResult<Self> {
        let method = match method {
            "auto" => Method::Auto,
            "exact" => Method::Exact,
            "quadrature" => Method::Quadrature,
            other => {
                return Err(Fault::new(format!("method {other:?} is not known")).help("auto, exact and quadrature are accepted").into());
            }
        };
        let made = py.detach(|| -> Result<Self, Fault> {
            let typed = formula(text, &[], &[])?;
            let exact = |value: f64| Number::from_f64(value).map(Expr::number);
            let mut bindings = Vec::new();
            for (name, value) in names.iter().zip(&values) {
                let number = exact(*value).filter(|_| *value > 0.0);
                let Some(number) = number else {
                    return Err(Fault::new(format!("{name} = {value} is not positive and finite"))
                        .help("parameters are positive; the sign belongs into the profile")
                        .place(format!("parameter {name}")));
                };
                bindings.push((name.as_str(), number));
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
            if profile.is_flat() {
                return Err(Fault::new("a flat profile with a smooth edge has no contact problem")
                    .help("sneddon.solve takes a punch: a profile with a radius"));
            }
            let solution = transform::derive(&profile).map_err(|error| about(error.into()))?;
            let inverse = if method == Method::Quadrature { None } else { explicit(&solution) };
            let solved = Solved::try_new(solution, |solution| {
                let evaluator = Evaluator::new(solution, &Bindings::default(), method, tolerance).map_err(Fault::from)?;
                Ok::<_, Fault>(Contact::new(evaluator, effective_modulus, None, tolerance))
            })?;
            Ok(Self { shape: Shape::Formula { solved, inverse }, tolerance, method })
        });
        Ok(made?)
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
        let made = py.detach(|| -> Result<Self, Fault> {
            let profile = Profile::from_points(&r, &z, Interpolation::MonotoneCubic)?;
            Ok(Self { shape: Shape::Table(Contact::new(profile, effective_modulus, None, tolerance)), tolerance, method: Method::Auto })
        });
        Ok(made?)
    }

    /// The engine of a function of Python: f of one 64-bit float, with the radii of its kinks and the end of its domain.
    #[staticmethod]
    fn function(f: Py<PyAny>, kinks: Vec<f64>, end: Option<f64>, effective_modulus: f64, tolerance: f64) -> PyResult<Self> {
        let raised = Raised::default();
        let kept = Arc::clone(&raised);
        let call = move |r: f64| {
            Python::attach(|py| {
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
        if let Some(error) = raised.lock().ok().and_then(|mut own| own.take()) {
            return Err(error);
        }
        let contact = Contact::new(made.map_err(Fault::from)?, effective_modulus, None, tolerance.max(1e-10));
        Ok(Self { shape: Shape::Function { contact, raised }, tolerance: tolerance.max(1e-10), method: Method::Auto })
    }

    /// One value and its bound.
    #[pyo3(signature = (key, at, radius=None))]
    fn one(&self, py: Python<'_>, key: &str, at: f64, radius: Option<f64>) -> PyResult<(f64, f64)> {
        let wanted = Wanted::of(key)?;
        check(wanted, at, None)?;
        if let Some(a) = radius.filter(|_| wanted.has_radius()) {
            check(Wanted::Depth, a, None)?;
        }
        let cheap = matches!(&self.shape, Shape::Formula { solved, .. } if solved.borrow_owner().is_closed());
        let read = || self.read(wanted, at, radius.unwrap_or(at));
        Ok(if cheap { read() } else { py.detach(read) }?)
    }

    /// Values, and bounds where an array is given for them, at every entry of `at`; arrays are contiguous and of one length.
    fn many(
        &self,
        py: Python<'_>,
        key: &str,
        at: PyReadonlyArray1<'_, f64>,
        radius: Option<PyReadonlyArray1<'_, f64>>,
        values: &Bound<'_, PyArray1<f64>>,
        bounds: Option<&Bound<'_, PyArray1<f64>>>,
    ) -> PyResult<()> {
        let wanted = Wanted::of(key)?;
        let at = at.as_slice()?;
        let radius = radius.as_ref().map(|own| own.as_slice()).transpose()?;
        let mut values = values.try_readwrite()?;
        let mut bounds = bounds.map(|own| own.try_readwrite()).transpose()?;
        let values = values.as_slice_mut()?;
        let mut bounds = bounds.as_mut().map(|own| own.as_slice_mut()).transpose()?;
        if at.len() != values.len() || radius.is_some_and(|own| own.len() != at.len()) {
            return Err(Fault::new("the arrays have different lengths").into());
        }
        blocks(py, at.len(), |range| {
            let radius = radius.and_then(|own| own.get(range.clone()));
            let bounds = bounds.as_mut().and_then(|own| own.get_mut(range.clone()));
            match (at.get(range.clone()), values.get_mut(range.clone())) {
                (Some(at), Some(values)) => self.block(wanted, range.start, at, radius, values, bounds),
                _ => Ok(()),
            }
        })
    }
}

/// Runs over blocks that grow while they are quick, without the lock of the interpreter; between them signals are looked at.
pub(crate) fn blocks(py: Python<'_>, count: usize, mut run: impl FnMut(Range<usize>) -> Result<(), Fault> + Send) -> PyResult<()> {
    const MOST: usize = 1 << 18;
    const QUICK: Duration = Duration::from_millis(20);
    let (mut start, mut size) = (0, 256);
    while start < count {
        let end = count.min(start + size);
        let clock = Instant::now();
        py.detach(|| run(start..end))?;
        py.check_signals()?;
        size = if clock.elapsed() < QUICK { (4 * size).min(MOST) } else { (size / 2).max(1) };
        start = end;
    }
    Ok(())
}

/// Refuses what is no radius, depth or force.
fn check(wanted: Wanted, value: f64, index: Option<usize>) -> Result<(), Fault> {
    if value.is_finite() && value >= 0.0 {
        return Ok(());
    }
    let name = wanted.argument();
    let place = index.map_or_else(|| name.to_owned(), |index| format!("{name}, flat index {index}"));
    Err(Fault::new(format!("{name} = {value} is not a number from 0 on")).help("finite numbers from 0 on are accepted").place(place))
}

impl Engine {
    fn block(
        &self,
        wanted: Wanted,
        offset: usize,
        at: &[f64],
        radius: Option<&[f64]>,
        values: &mut [f64],
        mut bounds: Option<&mut [f64]>,
    ) -> Result<(), Fault> {
        for (index, value) in at.iter().enumerate() {
            check(wanted, *value, Some(offset + index))?;
        }
        for (index, value) in radius.unwrap_or_default().iter().enumerate() {
            check(Wanted::Depth, *value, Some(offset + index))?;
        }
        let steps = Budget::DEFAULT.count().saturating_add(STEPS.saturating_mul(at.len() as u64));
        work::within(Budget::steps(steps), || {
            if self.slice(wanted, at, values, bounds.as_deref_mut())? {
                return Ok(());
            }
            for (index, x) in at.iter().enumerate() {
                let a = radius.and_then(|own| own.get(index)).copied().unwrap_or(*x);
                let (value, bound) = self.read(wanted, *x, a).map_err(|fault| fault.place(format!("flat index {}", offset + index)))?;
                if let Some(own) = values.get_mut(index) {
                    *own = value;
                }
                if let Some(own) = bounds.as_mut().and_then(|own| own.get_mut(index)) {
                    *own = bound;
                }
            }
            Ok(())
        })
    }

    /// Closed forms of one argument, straight into the buffers; false where there is no such way.
    fn slice(&self, wanted: Wanted, at: &[f64], values: &mut [f64], bounds: Option<&mut [f64]>) -> Result<bool, Fault> {
        let Shape::Formula { solved, .. } = &self.shape else { return Ok(false) };
        if !matches!(wanted, Wanted::Profile | Wanted::Equivalent | Wanted::Depth | Wanted::Force) {
            return Ok(false);
        }
        solved.with_dependent(|_, contact| {
            let evaluator = contact.evaluator();
            let mut bounds = bounds;
            let out = Slice { errors: bounds.as_deref_mut(), ..Slice::values(values) };
            match wanted {
                Wanted::Profile => evaluator.heights(at, out)?,
                Wanted::Force => evaluator.forces(at, out)?,
                _ => evaluator.slopes(at, out)?,
            }
            if wanted == Wanted::Force {
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

    fn read(&self, wanted: Wanted, at: f64, a: f64) -> Result<(f64, f64), Fault> {
        match &self.shape {
            Shape::Formula { solved, inverse } => {
                let inverse = inverse.as_ref().filter(|_| self.method != Method::Quadrature);
                solved.with_dependent(|_, contact| read(contact, inverse, self.tolerance, wanted, at, a))
            }
            Shape::Table(contact) => read(contact, None, self.tolerance, wanted, at, a),
            Shape::Function { contact, raised } => {
                let found = read(contact, None, self.tolerance, wanted, at, a);
                match raised.lock().ok().and_then(|mut own| own.take()) {
                    Some(error) => Err(Fault::raised(error)),
                    None => found,
                }
            }
        }
    }
}

/// A value with its bound; infinite by theory is infinite without an error.
fn told(measured: Measured) -> Result<(f64, f64), Fault> {
    match measured {
        Ok(own) => Ok((own.estimate.value, own.estimate.error)),
        Err(Reason::Apex | Reason::Kink | Reason::Rim) => Ok((f64::INFINITY, 0.0)),
        Err(other) => Err(Fault::new(other.text())),
    }
}

fn read<P: Quantities>(
    contact: &Contact<'_, P>,
    inverse: Option<&Explicit>,
    tolerance: f64,
    wanted: Wanted,
    at: f64,
    a: f64,
) -> Result<(f64, f64), Fault> {
    let one = |own: sneddon::transform::Reading| (own.estimate.value, own.estimate.error);
    let radius_of_depth = || radius_of_depth(contact, inverse, tolerance, at);
    let radius_of_force = || radius_of_force(contact, at);
    Ok(match wanted {
        Wanted::Profile => one(contact.profile(at)?),
        Wanted::Equivalent => one(contact.evaluator().slope(at)?),
        Wanted::Integral => one(contact.integral(at)?),
        Wanted::Depth => one(contact.depth(at)?),
        Wanted::Force => one(contact.force(at)?),
        Wanted::Stiffness => one(contact.stiffness(at)?),
        Wanted::Energy => one(contact.energy(at)?),
        Wanted::MeanPressure => told(contact.mean_pressure(at)?)?,
        Wanted::Pressure => told(contact.pressure(at, a)?)?,
        Wanted::Displacement => one(contact.displacement(at, a)?),
        Wanted::AxialStress => told(contact.axial_stress(at, a)?)?,
        Wanted::RadiusOfDepth => radius_of_depth()?,
        Wanted::RadiusOfForce => radius_of_force()?,
        Wanted::ForceOfDepth => through(radius_of_depth()?, |a| Ok(one(contact.force(a)?)))?,
        Wanted::DepthOfForce => through(radius_of_force()?, |a| Ok(one(contact.depth(a)?)))?,
    })
}

/// A quantity at a radius that is known to an error: what it changes within that error is added to its own.
fn through((a, error): (f64, f64), quantity: impl Fn(f64) -> Result<(f64, f64), ContactError>) -> Result<(f64, f64), Fault> {
    let (value, own) = quantity(a)?;
    if a == 0.0 || error == 0.0 {
        return Ok((value, own));
    }
    let moved = |place: f64| quantity(place).map(|found| (found.0 - value).abs() + found.1);
    // Next to the end of the profile there may be one side only.
    let below = moved((a - error).max(0.0))?;
    let above = moved(a + error).unwrap_or(2.0 * below);
    Ok((value, own + below.max(above)))
}

fn radius_of_depth<P: Quantities>(
    contact: &Contact<'_, P>,
    inverse: Option<&Explicit>,
    tolerance: f64,
    depth: f64,
) -> Result<(f64, f64), Fault> {
    // Beyond the largest depth the formula has no value, and the root tells why.
    if let Some(closed) = inverse.and_then(|own| own.contact_radius_at(depth).ok())
        && closed.estimate.value.is_finite()
        && closed.estimate.relative_error() <= tolerance
    {
        return Ok((closed.estimate.value, closed.estimate.error));
    }
    let found = contact.contact_radius(depth)?;
    Ok((found.estimate.value, found.estimate.error))
}

/// The radius whose force is F, between 0 and the end of the profile.
fn radius_of_force<P: Quantities>(contact: &Contact<'_, P>, force: f64) -> Result<(f64, f64), Fault> {
    if force == 0.0 {
        return Ok((contact.evaluator().flat_radius()?, 0.0));
    }
    let unreachable = || Fault::new(format!("the force {force} is not reached on the profile")).help("a smaller force is accepted");
    let gap = |a: f64| -> Result<f64, ContactError> { Ok(contact.force(a)?.estimate.value - force) };
    let limit = contact.evaluator().limit();
    let mut upper = if limit.is_finite() { limit.next_down() } else { 1.0 };
    if limit.is_finite() {
        if gap(upper)? < 0.0 {
            return Err(unreachable());
        }
    } else {
        while gap(upper).map_err(|_| unreachable())? < 0.0 {
            upper *= 4.0;
            if upper > 1e30 {
                return Err(unreachable());
            }
        }
    }
    let mut lower = upper / 4.0;
    while gap(lower)? >= 0.0 {
        (lower, upper) = (lower / 4.0, lower);
        if lower < 1e-300 {
            return Err(Fault::new(format!("the radius of the force {force} lies below the smallest number")));
        }
    }
    let a = bracketed(&mut |a: f64| gap(a), lower, upper, &RootOptions::default())?.x;
    let reading = contact.force(a)?.estimate;
    // F′ is the slope between two places up to a share of about the step.
    let step = 1e-5 * a;
    let slope = (reading.value - contact.force(a - step)?.estimate.value) / step;
    let residual = (reading.value - force).abs() + reading.error;
    Ok((a, 1.1 * (residual / slope).abs() + 2.0 * f64::EPSILON * a))
}
