//! `sneddon eval`: the numbers of one quantity.

use crate::cli::failure::warn;
use crate::cli::output::{OutputArguments, Tabular};
use crate::cli::precision::PrecisionArguments;
use crate::cli::quantities::Quantities;
use crate::cli::{Failure, Outcome, budget, curve, input, points, series};
use crate::contact::{self, Contact, ContactError, Explained, Measured, Quantity, WayResult};
use crate::eval::constant_value;
use crate::expr::Bindings;
use crate::num::{Estimate, work};
use crate::report::{self, Evaluation, Shift, UnitNames};
use crate::scene::Dimension;
use crate::transform::{self, Evaluator, Method, Profile, Reading, TransformError, WAYS, Way};
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::error::ErrorKind;
use clap::{Arg, Command};
use std::ffi::OsStr;

/// Computes the numbers of a contact, each with an error bound.
///
/// The points are values of the coordinate in parentheses after each quantity: r, x or z, the contact radius a, the depth d or the
/// force F. The quantities p, u, q, u_1d and sigma_zz also require --radius.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(in crate::cli) struct Arguments {
    #[command(flatten)]
    profile: input::ProfileArguments,
    /// Quantity to compute.
    #[arg(long, value_parser = Quantities(any))]
    quantity: Quantity,
    /// Points: 0.1,0.5 or start:stop:count or log:start:stop:count, with or without units, such as "0:100 nm:11".
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    at: String,
    /// Contact radius, for p, u, q, u_1d and sigma_zz.
    #[arg(long, value_name = "A", allow_hyphen_values = true)]
    radius: Option<String>,
    /// Depth of a punch whose rim is at the contact radius.
    #[arg(long, value_name = "D", allow_hyphen_values = true)]
    depth: Option<String>,
    /// Effective modulus E* of the two bodies.
    #[arg(long, value_name = "VALUE", default_value = "1", allow_hyphen_values = true)]
    effective_modulus: String,
    /// Method; `auto` picks the cheapest that meets the tolerance.
    #[arg(long, value_parser = Methods, default_value = "auto")]
    method: Chosen,
    /// Shows the result of every method for each number, with its steps of work; not with --csv.
    #[arg(long, conflicts_with = "csv")]
    explain: bool,
    /// Highest power of r in the series of --method series [default: 24, and 64 for p].
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    order: Option<String>,
    /// Relative tolerance [default: 1e-13].
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    tol: Option<String>,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArguments<Tabular>,
    #[command(flatten)]
    precision: PrecisionArguments,
    #[command(flatten)]
    pub(in crate::cli) budget: budget::BudgetArguments,
}

const EXAMPLES: &str = "Examples:
  sneddon eval 'r^2/(2*R)' --quantity F --at 0.1,0.5 --set R=2
  sneddon eval 'R-sqrt(R^2-r^2)' --quantity p --at 0:0.5:6 --radius 0.5 --set R=2 --json
  sneddon eval 'h*ln(1+r/w)' --quantity g --at log:0.01:1:5 --set h=0.4 --set w=1.3
  sneddon eval 'ln(cosh(r))' --quantity p --at 0:2.9:30 --radius 3 --method curve";

/// Steps of work that are allowed for each further point.
const STEPS_PER_POINT: u64 = 100_000;
/// The default relative tolerance.
const TOLERANCE: f64 = 1e-13;
/// The relative error above which a warning is given if no tolerance was requested.
const FEW_DIGITS: f64 = 1e-8;
/// Number of radii at which g is compared with its neighbours.
const LOOKS: u32 = 48;

#[derive(Clone, Copy, PartialEq)]
enum Chosen {
    /// One way, or the best of several, at each point.
    Method(Method),
    /// The power series at r = 0, term by term.
    Series,
    /// One piecewise expansion of f′ for all points, checked against quadrature: for many points.
    Curve,
}

/// Reads a method or the key of a way.
#[derive(Clone)]
struct Methods;

/// The methods beside the ways; `series` here gives the series term by term.
const METHODS: [(&str, &str, Chosen); 5] = [
    ("auto", "the cheapest method that meets the tolerance", Chosen::Method(Method::Auto)),
    ("exact", "closed forms only", Chosen::Method(Method::Exact)),
    ("quadrature", "quadrature of the profile as typed", Chosen::Method(Method::Quadrature)),
    ("series", "the power series at r = 0, term by term", Chosen::Series),
    ("curve", "one piecewise expansion of f′ for all points, checked against quadrature: for many points", Chosen::Curve),
];

impl TypedValueParser for Methods {
    type Value = Chosen;

    fn parse_ref(&self, command: &Command, argument: Option<&Arg>, value: &OsStr) -> Result<Chosen, clap::Error> {
        let known = PossibleValuesParser::new(self.possible_values().into_iter().flatten());
        let key = known.parse_ref(command, argument, value)?;
        let method = METHODS.iter().find(|(own, ..)| *own == key).map(|(.., chosen)| *chosen);
        let chosen = method.or_else(|| Way::of(&key).map(|way| Chosen::Method(Method::Only(way))));
        chosen.ok_or_else(|| clap::Error::new(ErrorKind::InvalidValue).with_cmd(command))
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        let ways = WAYS.iter().filter(|way| METHODS.iter().all(|(own, ..)| *own != way.key)).map(|way| (way.key, way.title));
        let all = METHODS.iter().map(|(key, title, _)| (*key, *title)).chain(ways);
        Some(Box::new(all.map(|(key, title)| PossibleValue::new(key).help(title))))
    }
}

pub(in crate::cli) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let answer = arguments.output.destination()?;
    if arguments.explain && answer.format() == Tabular::Csv {
        return Err(Failure::new("CSV has no place for the ways of --explain").help("expected -o FILE.txt or FILE.json"));
    }
    let digits = arguments.precision.digits(answer.format() != Tabular::Json)?;
    let quantity = arguments.quantity;
    let dimension = quantity.coordinate_dimension();
    let lengths =
        [Some(arguments.at.as_str()).filter(|_| dimension == Dimension::LENGTH), arguments.radius.as_deref(), arguments.depth.as_deref()];
    let units = arguments.profile.units(&lengths, Some(&arguments.effective_modulus));
    let at = points::read(&arguments.at, &units, dimension)?;
    budget::allow(at.len() as u64, STEPS_PER_POINT);
    let radius = arguments.radius.as_deref().map(|text| units.positive_length("--radius", text)).transpose()?;
    let depth = arguments.depth.as_deref().map(|text| units.length("--depth", text)).transpose()?;
    let effective_modulus = units.modulus("--effective-modulus", &arguments.effective_modulus)?;
    let demanded = arguments.tol.as_deref().map(input::tolerance).transpose()?;
    let (chosen, tolerance) = (arguments.method, demanded.unwrap_or(TOLERANCE));
    let by_series = chosen == Chosen::Series && (arguments.order.is_some() || (depth.is_none() && series::answers(quantity)));
    let method = match chosen {
        Chosen::Method(method) => method,
        // Other numbers follow from those that the series has.
        Chosen::Series if !by_series => Way::of("series").map_or(Method::Quadrature, Method::Only),
        // Series and curve have their own ways; what they share with the others is cheap.
        Chosen::Series | Chosen::Curve => Method::Quadrature,
    };
    if by_series {
        series::refuse_rim(depth)?;
    } else {
        series::refuse_order(arguments.order.as_deref())?;
    }
    let order = series::order(arguments.order.as_deref(), quantity)?;
    if quantity.needs_radius() && radius.is_none() {
        let message = format!("--quantity {} needs the contact radius", quantity.key());
        return Err(Failure::new(message).help("give it with --radius A"));
    }
    if !quantity.needs_radius() && radius.is_some() {
        warn(&format!("the radius is not used: {} does not depend on it", quantity.key()));
    }
    let by_load = matches!(quantity.coordinate(), "d" | "F");
    if by_load && depth.is_some() {
        return Err(Failure::new("under a rim the contact radius does not depend on the load")
            .help("leave out --depth, or ask for another quantity"));
    }
    let (typed, settings) = arguments.profile.read(&units)?;
    settings.demand_all(&typed)?;
    let failed = |error: ContactError| match error {
        ContactError::Transform(TransformError::NotThisWay { .. } | TransformError::NoSuchWay { .. }) => {
            Failure::new(error.to_string()).help("--explain shows which methods have a value here")
        }
        error => Failure::profile(&typed.text, &error),
    };
    let profile = settings.bound_profile(&typed)?;
    if profile.is_flat() && by_load {
        let message = format!("{} of a flat punch depends on the radius of its rim", quantity.left(false));
        return Err(
            Failure::new(message).help("use --quantity F with the radius in --at and the depth in --depth, or solve a scene with a radius")
        );
    }
    if profile.is_flat() && depth.is_none() && quantity.needs_contact() {
        return Err(failed(TransformError::Flat.into()));
    }
    let solution = transform::derive(&profile).map_err(|error| failed(error.into()))?;
    solution.warnings().iter().for_each(|text| warn(text));
    let evaluator = Evaluator::new(&solution, &Bindings::default(), method, tolerance);
    let contact = Contact::new(evaluator.map_err(|error| failed(error.into()))?, effective_modulus, depth, tolerance);
    // The contact radius belongs to all points.
    if let Some(a) = radius.filter(|_| quantity.needs_radius()) {
        contact.evaluator().check_domain("a", a).map_err(|error| failed(error.into()))?;
    }
    let contact = if quantity.coordinate() == "d" && matches!(method, Method::Auto | Method::Exact) {
        contact.with_explicit(contact::explicit(&solution), method == Method::Exact)
    } else {
        contact
    };
    if quantity == Quantity::Energy && method == Method::Exact {
        return Err(failed(TransformError::NoClosedForm { quantity: "U" }.into()));
    }
    // Before the points, which may use up the budget.
    let shift = shift(&profile, &settings.exact_profile(&typed).unwrap_or_else(|_| profile.clone()));
    let readings = if by_series {
        series::readings(quantity, &profile, order, &at, radius, &contact)?
    } else if chosen == Chosen::Curve {
        let radius = radius.filter(|_| quantity.needs_radius());
        let own = curve::Asked { quantity, at: &at, radius, depth, effective_modulus, tolerance: demanded };
        curve::readings(&contact, &own, failed)?
    } else {
        contact.numbers(quantity, &at, radius).map_err(failed)?
    };
    if depth.is_none() {
        work::part(|| warn_of_falls(&contact, quantity, &at, &readings, radius));
    }
    warn_of_invalid_contact(quantity, &readings);
    warn_of_few_digits(demanded.unwrap_or(FEW_DIGITS), &readings);
    let ways = if arguments.explain {
        let explained = Explained::new(&solution, &Bindings::default(), effective_modulus, depth, tolerance).map_err(failed)?;
        let own = |(at, reading): (&f64, &Measured)| {
            let mut list = with_the_answer(explained.ask(quantity, *at, radius.unwrap_or(*at)), reading);
            list.iter_mut().for_each(|row| row.found = row.found.clone().map(|found| digits.of(found)));
            list
        };
        Some(at.iter().zip(&readings).map(own).collect())
    } else {
        None
    };
    let record = Evaluation {
        quantity: quantity.key(),
        coordinate: quantity.coordinate(),
        profile: &typed.formula,
        parameters: settings.values(),
        effective_modulus,
        radius: radius.filter(|_| quantity.needs_radius()),
        depth,
        shift,
        at,
        ways,
        readings: readings.into_iter().map(|own| own.map(|own| Reading { estimate: digits.of(own.estimate), ..own })).collect(),
        units: UnitNames {
            at: units.name(quantity.coordinate_dimension()),
            value: units.name(quantity.dimension()),
            modulus: units.name(Dimension::PRESSURE),
            parameters: settings.units(&units),
        },
    };
    answer.write(|format, out| match format {
        Tabular::Json => report::json::evaluation(&record, out),
        Tabular::Csv => report::text::evaluation_as_csv(&record, out),
        Tabular::Text => report::text::evaluation(&record, out),
    })?;
    points::warn_of_missing_values(&record.readings);
    if record.ways.iter().flatten().flatten().any(WayResult::is_cut) {
        warn("the work limit was reached before every way was asked; raise it with --budget SECONDS");
    }
    if record.is_cut() {
        return Ok(Outcome::Failed);
    }
    Ok(Outcome::Done)
}

/// Every value tells its error; this tells that one is larger than what was asked for.
fn warn_of_few_digits(limit: f64, readings: &[Measured]) {
    let estimates = readings.iter().flatten().map(|reading| reading.estimate);
    let missed =
        estimates.filter(|estimate| estimate.error.is_nan() || estimate.error > limit * estimate.value.abs() + f64::MIN_POSITIVE).count();
    if missed > 0 {
        warn(&format!("the relative error is larger than {limit:?} at {missed} of {} points; see the error estimates", readings.len()));
    }
}

/// f(0), where it is not zero: the number, and the expression that it was typed as.
fn shift(profile: &Profile, typed: &Profile) -> Option<Shift> {
    let number = || constant_value(&profile.shift, &Bindings::default()).map_or(f64::NAN, |bounded| bounded.value);
    (!profile.shift.is_zero()).then(|| Shift { expr: typed.shift.clone(), value: number() })
}

/// Warns if g decreases before the largest contact radius, because larger contacts may not exist; the verdict belongs to `solve`.
fn warn_of_falls(contact: &Contact<'_>, quantity: Quantity, at: &[f64], readings: &[Measured], radius: Option<f64>) {
    let known = || at.iter().zip(readings).filter_map(|(at, reading)| Some((*at, reading.as_ref().ok()?.estimate.value)));
    let coordinate = || known().map(|(at, _)| at).fold(0.0, f64::max);
    let value = || known().map(|(_, value)| value).fold(0.0, f64::max);
    let of_depth = |depth: f64| contact.contact_radius(depth).map(|own| own.estimate.value);
    let largest = match quantity {
        _ if !quantity.needs_contact() => return,
        _ if quantity.needs_radius() => Ok(radius.unwrap_or(0.0)),
        Quantity::Radius | Quantity::RadiusOfForce => Ok(value()),
        Quantity::DepthOfForce => of_depth(value()),
        _ if quantity.coordinate() == "d" => of_depth(coordinate()),
        _ => Ok(coordinate()),
    };
    let Ok(largest) = largest else { return };
    let places = (1..=LOOKS).map(|step| largest * f64::from(step) / f64::from(LOOKS));
    let known = places.map_while(|x| Some((x, contact.evaluator().equivalent(x).ok()?.estimate)));
    let known: Vec<(f64, Estimate)> = std::iter::once((0.0, Estimate::exact(0.0))).chain(known).collect();
    let falls = |pair: &&[(f64, Estimate)]| matches!(pair, [(_, one), (_, other)] if other.value + other.error < one.value - one.error);
    if let Some([(x, _), _]) = known.windows(2).find(falls) {
        let from = if *x == 0.0 { "from x = 0 on".to_owned() } else { format!("beyond x = {x:.3e}") };
        warn(&format!("g decreases {from}: larger contacts may not be valid; the values of the formula follow"));
    }
}

/// A falling g shows as a negative depth, force or pressure; the verdict itself belongs to `solve`.
fn warn_of_invalid_contact(quantity: Quantity, readings: &[Measured]) {
    let telling = matches!(quantity, Quantity::Equivalent | Quantity::Depth | Quantity::Force | Quantity::Pressure | Quantity::Integral);
    let negative = readings.iter().flatten().any(|reading| reading.estimate.value < -reading.estimate.error);
    if telling && negative {
        warn(&format!("{} is negative at some points: no valid contact; the values of the formula follow", quantity.key()));
    }
}

/// The list, with the answer itself in front if its way gives another number alone, or is not in the list.
///
/// A depth, radius or force that follows from others is `auto`: its way is the way of the numbers that it follows from.
fn with_the_answer(mut asked: Vec<WayResult>, reading: &Measured) -> Vec<WayResult> {
    let Ok(own) = reading else { return asked };
    let alike = asked.iter().find(|other| other.way == own.way());
    if !alike.is_some_and(|other| other.found.as_ref().is_ok_and(|found| found.value == own.estimate.value)) {
        let way = if alike.is_some() { "auto" } else { own.way() };
        asked.insert(0, WayResult { way, found: Ok(own.estimate), steps: 0 });
    }
    asked
}

/// `eval` has a number for every quantity.
fn any(_: Quantity) -> Result<(), &'static str> {
    Ok(())
}
