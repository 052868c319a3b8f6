//! Reads a scene from the text of its file.

use crate::contact::ContactError;
use crate::expr::{Bindings, Expr, Formula, Symbol};
use crate::parse;
use crate::scene::body;
use crate::scene::body::Body;
use crate::scene::error::Reason;
use crate::scene::file::change::Change;
use crate::scene::file::check;
use crate::scene::file::check::Dimensions;
use crate::scene::file::declared::Typed;
use crate::scene::file::dimensioned::to_f64;
use crate::scene::file::document::{Entry, TABLES, Table, nearest, parsed};
use crate::scene::file::reading::Asked;
use crate::scene::measured;
use crate::scene::measured::Measured;
use crate::scene::punch::Punch;
use crate::scene::shape::{Shape, Way, known_shape};
use crate::scene::{Control, Dimension, DimensionedNumber, Quantity, Scene, SceneError, Simple, System, Unit};
use crate::transform::Profile;
use std::f64::consts::FRAC_PI_2;
use std::ops::Range;

/// Reads a scene.
///
/// ```
/// let text = r#"
/// [profile]
/// shape = "paraboloid"
/// parameters = { R = "10 um" }
/// [material]
/// effective_modulus = "3 GPa"
/// [load]
/// depth = "0.1 um"
/// "#;
/// assert_eq!(sneddon::scene::scene(text).unwrap().effective_modulus, 3e9);
/// assert_eq!(sneddon::scene::scene("[profil]").unwrap_err().accepted(), Some("did you mean profile? expected one of profile, material, counterbody, load, outputs, method, data"));
/// ```
///
/// # Errors
/// [`SceneError`] with the position in the text.
pub fn scene(text: &str) -> Result<Scene, SceneError> {
    let mut found = scene_for_grid(text)?;
    found.lacking.take().map_or(Ok(found), Err)
}

/// Reads a scene whose curves are evaluated on another grid, so that `at` may be missing.
///
/// # Errors
/// See [`scene`].
pub fn scene_for_grid(text: &str) -> Result<Scene, SceneError> {
    changed(text, true, &Change::None)
}

/// Reads a scene for data with loads and coordinates of their own, and applies a change.
///
/// # Errors
/// See [`scene`]; without `[load]` the scene has no loads.
pub fn scene_for_data(text: &str, change: &Change) -> Result<Scene, SceneError> {
    changed(text, false, change)
}

fn changed(text: &str, needs_load: bool, change: &Change) -> Result<Scene, SceneError> {
    let document = parsed(text)?;
    let root = Table::root(&document, text);
    root.allow(&TABLES)?;
    let complete = "expected [profile], [material] and [load]; `sneddon scene new sphere` creates an example";
    root.demand("profile", complete)?;
    root.demand("material", complete)?;
    if needs_load {
        root.demand("load", complete)?;
    }
    let (tables, load) = ((root.table("profile")?, root.table("material")?), root.table("load")?);
    let (Some(profile), Some(material)) = tables else { return Err(SceneError::missing(complete)) };
    let counterbody = root.table("counterbody")?;
    let outputs = root.table("outputs")?;

    let mut keys = vec!["f", "shape", "points", "parameters", "radius", "length_unit", "cross_section", "beta", "area"];
    keys.extend(measured::KEYS);
    profile.allow(&keys)?;
    let measured = Measured::read(&profile)?;
    let punch = Punch::read(&profile)?;
    if let (None, Some(area)) = (&punch, profile.get("area")) {
        return Err(SceneError::missing("area requires a cross_section")
            .help("expected a cross-section as well, such as cross_section = \"square\"")
            .at(area.span()));
    }
    material.allow(&body::KEYS)?;
    let flat = || punch.as_ref().map(|_| Tip::flat(profile.span()));
    let tip = Tip::read(&profile, change)?.or_else(flat).ok_or_else(|| {
        SceneError::missing("[profile] has no shape")
            .help("expected f = \"r^2/(2*R)\", shape = \"sphere\" or points = \"tip.csv\"")
            .at(profile.span())
    })?;
    if let (Some(_), Some(shape)) = (&punch, counterbody.as_ref().and_then(|table| ["f", "shape"].iter().find_map(|key| table.get(key)))) {
        return Err(SceneError::value("a punch with a non-circular cross-section requires a flat counterbody")
            .help("expected a counterbody without a shape")
            .at(shape.span()));
    }
    let mut first = Body::read(&material, false)?;
    let (mut second, mut other) = (Body::rigid(), None);
    if let Some(table) = &counterbody {
        keys = vec!["f", "shape", "parameters", "socket"];
        keys.extend(body::KEYS);
        table.allow(&keys)?;
        second = Body::read(table, true)?;
        other = Tip::read(table, &Change::None)?;
    }
    if matches!(change, Change::NoPoisson) {
        first.forget_poisson()?;
        second.forget_poisson()?;
    }
    let asked = Asked::read(load.as_ref(), outputs.as_ref(), root.table("method")?.as_ref())?;
    let declared = root.table("data")?.map(|table| Typed::read(&table)).transpose()?;
    let mut named = asked.units.clone();
    if let Some(entry) = profile.get("length_unit") {
        named.profile_length = Some(length_unit(&entry)?);
    }
    let radius =
        profile.get("radius").map(|entry| Ok::<_, SceneError>((change.of("radius", &entry.quantity()?), entry.span()))).transpose()?;

    let tips = std::iter::once(&tip).chain(other.iter());
    let typed = tips.flat_map(|tip| tip.parameters.iter().map(|own| &own.quantity));
    let typed = typed.chain(first.quantities()).chain(second.quantities()).chain(asked.quantities()).chain(radius.iter().map(|own| &own.0));
    let typed = typed.chain(punch.iter().map(|own| &own.area)).chain(measured.iter().flat_map(Measured::quantities));
    let mut typed = typed.chain(declared.iter().filter_map(Typed::side));
    let names_units = named.profile_length.is_some() || measured.as_ref().is_some_and(Measured::names_units);
    let has_units = names_units || typed.any(|own| own.dimension().is_some_and(|own| !own.is_none()));
    drop(typed);
    let system = System::new(has_units, &named)?;

    measured.iter().try_for_each(|own| own.check(&system))?;
    let strict = has_units && named.profile_length.is_none();
    let mut formula = tip.formula(&system, strict)?;
    let read = |formula: &Formula, place: &Range<usize>| {
        Profile::new(formula).map_err(|error| SceneError::from(ContactError::from(error)).at(place.clone()))
    };
    let mut bodies = Vec::new();
    if let Some(other) = &other {
        let own = other.formula(&system, strict)?;
        let own = if counter_is_socket(counterbody.as_ref())? { own.scaled(&Expr::integer(-1)) } else { own };
        bodies = vec![read(&formula, &tip.span)?, read(&own, &other.span)?];
        formula = Formula::sum([formula, own]);
    }
    let rim = match (&radius, &tip.rim) {
        (Some((_, span)), Some((name, _))) if tip.parameters.iter().any(|own| own.symbol.name() == *name && own.span != *span) => {
            let message = format!("the radius of the indenter is given twice: as radius and as the parameter {name}");
            return Err(SceneError::value(message).help("expected only one of them").at(span.clone()));
        }
        (Some((quantity, span)), _) => Some(positive(system.number(quantity, Dimension::LENGTH, "radius"), "radius", quantity, span)?),
        (None, Some((_, quantity))) => Some(system.number(quantity, Dimension::LENGTH, "the radius of the indenter")?),
        (None, None) => None,
    };
    let rim = match &punch {
        Some(punch) => Some(punch.radius(&system)?),
        None => rim,
    };
    let bound = read(&formula, &tip.span)?;
    if rim.is_none() && bound.is_flat() && measured.is_none() {
        return Err(SceneError::missing("a flat punch requires a radius")
            .help("expected radius = \"2 um\" in [profile]")
            .at(tip.span.clone()));
    }
    let effective_modulus = body::together(first.modulus(&system)?, second.modulus(&system)?, material.span())?;
    let length = tip.length(&system);
    let relatives = if other.is_none() { Simple::relatives(tip.name, &tip.values(&system)) } else { Vec::new() };
    let parameters = tip.parameters.iter().map(|own| (own.symbol.name().to_owned(), own.quantity.text().to_owned())).collect();
    let is_symbolic = other.is_none() && measured.is_none() && named.profile_length.is_none();
    let symbolic = is_symbolic.then(|| tip.formula.clone());
    let data = declared.map(|own| own.declared(&system)).transpose()?;
    let place = Some(tip.span);
    let scene = Scene {
        bodies,
        measured,
        relatives,
        rim,
        effective_modulus,
        system,
        place,
        length,
        parameters,
        symbolic,
        data,
        ..Scene::of(bound)
    };
    let mut scene = asked.scene(scene)?;
    if scene.outputs.curves.contains(&Quantity::AxialStress)
        && let Some(body) = [&first, &second].into_iter().find(|own| !own.is_isotropic())
    {
        return Err(SceneError::value("sigma_zz is available only for isotropic bodies, but this one is transversely isotropic")
            .help("expected a material given by E and nu, or quantities without sigma_zz")
            .at(body.span()));
    }
    if punch.is_some() {
        scene.round = false;
        if outputs.as_ref().is_none_or(|table| table.get("quantities").is_none()) {
            scene.outputs.data.retain(|own| *own != Quantity::Radius || scene.control == Control::ContactRadius);
        }
        Punch::refuse(&scene, outputs.as_ref())?;
    }
    Ok(scene)
}

fn counter_is_socket(table: Option<&Table<'_>>) -> Result<bool, SceneError> {
    table.and_then(|table| table.get("socket")).map_or(Ok(false), |entry| entry.boolean())
}

fn length_unit(entry: &Entry<'_>) -> Result<Unit, SceneError> {
    let unit = Unit::parse(entry.string()?).map_err(|error| error.at(entry.span()))?;
    if unit.dimension() == Dimension::LENGTH {
        return Ok(unit);
    }
    Err(SceneError::unit(format!("{} is {}, not a length", unit.name(), unit.dimension())).at(entry.span()))
}

/// Returns a value, or an error with the typed text unless the value is positive.
fn positive(value: Result<f64, SceneError>, what: &str, typed: &DimensionedNumber, span: &Range<usize>) -> Result<f64, SceneError> {
    match value {
        Ok(value) if value > 0.0 => Ok(value),
        Ok(_) => {
            Err(SceneError::value(format!("{what} = {} is not positive", typed.text())).help("expected a positive number").at(span.clone()))
        }
        Err(error) => Err(error.at(span.clone())),
    }
}

/// The shape of one body: a formula with its parameters, as typed.
struct Tip {
    formula: Formula,
    parameters: Vec<Parameter>,
    rim: Option<(&'static str, DimensionedNumber)>,
    /// The name of the shape; empty for a formula.
    name: &'static str,
    span: Range<usize>,
}

struct Parameter {
    symbol: Symbol,
    quantity: DimensionedNumber,
    span: Range<usize>,
}

impl Tip {
    /// Creates the profile f = 0.
    fn flat(span: Range<usize>) -> Self {
        Self { formula: Formula::zero(), parameters: Vec::new(), rim: None, name: "", span }
    }

    /// Returns the parameter R, or c of a cylinder, with its value.
    fn length(&self, system: &System) -> Option<(String, f64)> {
        let own = self.parameters.iter().find(|own| own.symbol.name() == "R").or_else(|| {
            let rim = self.rim.as_ref()?.0;
            self.parameters.iter().find(|own| own.symbol.name() == rim)
        })?;
        let exact = system.exact(&own.quantity, Dimension::LENGTH, own.symbol.name()).ok()?;
        Some((own.symbol.name().to_owned(), to_f64(&exact).ok()?))
    }

    /// Reads f or shape with their parameters; `None` if the table has neither.
    fn read(table: &Table<'_>, change: &Change) -> Result<Option<Self>, SceneError> {
        let ways = ["f", "shape", "points"].map(|key| table.get(key));
        if ways.iter().flatten().count() > 1 {
            let second = ways.iter().flatten().nth(1).map_or(table.span(), |entry| table.key_span(entry.key()));
            return Err(SceneError::value(format!("{} contains more than one of f, shape and points", table.name()))
                .help("expected only one of them")
                .at(second));
        }
        let [f, shape, points] = ways;
        // A parameter that cancels from the formula may still have a value.
        let typed = f.as_ref().and_then(|own| own.string().ok()).map(parse::parameters).unwrap_or_default();
        let mut parameters = Self::parameters(table, change)?;
        let (formula, rim, name, span) = match (f, shape) {
            (Some(f), _) => {
                let text = f.string()?;
                let formula = parse::profile(text).map_err(|error| {
                    let part = f.part(error.span());
                    SceneError::from(error).at(part)
                })?;
                (formula, None, "", f.span())
            }
            (None, Some(entry)) => {
                let (shape, way) = Self::named(&entry, &mut parameters, table)?;
                let rim = shape
                    .rim
                    .and_then(|name| parameters.iter().find(|own| own.symbol.name() == name).map(|own| (name, own.quantity.clone())));
                (parse::profile(way.f).map_err(SceneError::from)?, rim, shape.name, entry.span())
            }
            // The points of a measured tip are read later and added to this.
            (None, None) => match points {
                Some(points) => (Formula::zero(), None, "", points.span()),
                None => return Ok(None),
            },
        };
        let wanted: Vec<Symbol> = formula.symbols().into_iter().filter(|own| own.name() != "r").collect();
        // The radius of a flat cylinder does not appear in f = 0.
        let known = |own: &Symbol| wanted.contains(own) || typed.contains(own) || rim.as_ref().is_some_and(|(name, _)| *name == own.name());
        let names: Vec<&str> = wanted.iter().map(Symbol::name).collect();
        if let Some(unknown) = parameters.iter().find(|own| !known(&own.symbol)) {
            let near = nearest(unknown.symbol.name(), &names).map_or(String::new(), |near| format!("did you mean {near}? "));
            let own = if names.is_empty() { "it has no parameters".to_owned() } else { format!("its parameters are {}", names.join(", ")) };
            return Err(SceneError::value(format!("f has no parameter {}", unknown.symbol))
                .help(format!("{near}{own}"))
                .at(unknown.span.clone()));
        }
        if let Some(missing) = wanted.iter().find(|own| parameters.iter().all(|known| known.symbol != **own)) {
            let help = format!("expected a value, such as parameters = {{ {missing} = … }} in {}", table.name());
            return Err(SceneError::missing(format!("the parameter {missing} of f has no value")).help(help).at(span));
        }
        Ok(Some(Self { formula, parameters, rim, name, span }))
    }

    fn parameters(table: &Table<'_>, change: &Change) -> Result<Vec<Parameter>, SceneError> {
        let Some(entry) = table.get("parameters") else { return Ok(Vec::new()) };
        let own = entry.table("parameters".to_owned())?;
        let mut list = Vec::new();
        for entry in own.entries() {
            // Parse the name as an expression, so that theta and θ are the same name.
            let symbol =
                parse::formula(entry.key()).ok().and_then(|formula| formula.as_closed().and_then(|expr| expr.as_symbol().cloned()));
            let symbol = symbol
                .ok_or_else(|| SceneError::value(format!("{:?} is not a valid name of a parameter", entry.key())).at(entry.span()))?;
            let quantity = change.of(symbol.name(), &entry.quantity()?);
            positive(to_f64(&quantity.in_base()), symbol.name(), &quantity, &entry.span())?;
            list.push(Parameter { symbol, quantity, span: entry.span() });
        }
        Ok(list)
    }

    /// Returns the named shape, and the parametrization that matches the given parameters.
    fn named(entry: &Entry<'_>, parameters: &mut Vec<Parameter>, table: &Table<'_>) -> Result<(&'static Shape, &'static Way), SceneError> {
        let text = entry.string()?;
        let found = known_shape(text).map_err(|error| error.at(entry.span()))?;
        // The radius of a cylinder may be a parameter or the radius of [profile].
        if let (Some(rim), Some(radius)) = (found.rim, table.get("radius"))
            && parameters.iter().all(|own| own.symbol.name() != rim)
            && found.ways.first().is_some_and(|way| way.f.contains(rim))
        {
            parameters.push(Parameter { symbol: Symbol::new(rim), quantity: radius.quantity()?, span: radius.span() });
        }
        let way = found.way(&parameters.iter().map(|own| own.symbol.name()).collect::<Vec<_>>());
        for own in parameters.iter() {
            let is_angle = way.is_some_and(|way| way.parameters.iter().any(|known| known.is_angle() && known.name == own.symbol.name()));
            if is_angle && to_f64(&own.quantity.in_base()).is_ok_and(|angle| angle >= FRAC_PI_2) {
                return Err(SceneError::value(format!("{} = {} is not a valid angle of a cone", own.symbol, own.quantity.text()))
                    .help("expected an angle above 0 and below 90 deg, such as \"12 deg\"; a number without a unit is in radians")
                    .at(own.span.clone()));
            }
        }
        way.map(|way| (found, way)).ok_or_else(|| SceneError::missing(format!("{} has no formula", found.name)))
    }

    /// Returns the values of the parameters in the units of the scene.
    fn values(&self, system: &System) -> Bindings {
        let mut values = Bindings::default();
        for own in &self.parameters {
            let dimension = own.quantity.dimension().unwrap_or(Dimension::NONE);
            let value = if own.quantity.unit().is_some() { system.own(own.quantity.in_base(), dimension) } else { own.quantity.in_base() };
            values.insert(own.symbol.clone(), value);
        }
        values
    }

    /// Returns f with the values of its parameters in the units of the scene.
    fn formula(&self, system: &System, strict: bool) -> Result<Formula, SceneError> {
        let (mut numbers, mut values, mut known) = (Bindings::default(), Bindings::default(), Dimensions::new());
        for own in &self.parameters {
            let dimension = own.quantity.dimension().unwrap_or(Dimension::NONE);
            let value = if own.quantity.unit().is_some() { system.own(own.quantity.in_base(), dimension) } else { own.quantity.in_base() };
            if dimension.is_none() {
                numbers.insert(own.symbol.clone(), value.clone());
            }
            known.insert(own.symbol.clone(), dimension);
            values.insert(own.symbol.clone(), value);
        }
        if strict {
            check::refuse_other_than_length(&self.formula.substitute(&numbers), &known).map_err(|error| match error.reason() {
                Reason::Dimension(_) => error.at(self.span.clone()),
                _ => error,
            })?;
        }
        Ok(self.formula.substitute(&values))
    }
}
