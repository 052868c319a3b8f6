//! Reads the profile, parameter values and other numbers from the command line.

use super::Failure;
use super::failure::warn;
use super::units::{CallUnits, finite};
use crate::contact::rim_radius;
use crate::expr::{Bindings, Expr, Formula, Node, Number, Symbol};
use crate::parse::{self, ParseError};
use crate::scene::{Dimension, DimensionedNumber, Shape, known_shape};
use crate::transform::{Profile, TransformError};
use std::f64::consts::FRAC_PI_2;
use std::io::{self, Read};

/// A profile as typed and as parsed.
pub(super) struct Typed {
    pub(super) text: String,
    pub(super) formula: Formula,
}

/// The profile of a command, as an expression or a named shape, with parameter values.
#[derive(clap::Args)]
pub(super) struct ProfileArguments {
    /// Shape f(r), such as r^2/(2*R); - reads it from stdin.
    #[arg(value_name = "PROFILE", allow_hyphen_values = true, required_unless_present = "shape")]
    profile: Option<String>,
    /// Named shape, such as cone, instead of PROFILE; `sneddon scene new` lists all shapes.
    #[arg(long, value_name = "NAME", conflicts_with = "profile")]
    shape: Option<String>,
    /// Sets the value of a parameter, with or without a unit: R=2, R='20 nm', theta='20 deg'; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,
}

impl ProfileArguments {
    /// Returns the units of the parameter values, of other lengths, and of the modulus.
    pub(super) fn units(&self, lengths: &[Option<&str>], modulus: Option<&str>) -> CallUnits {
        CallUnits::of(&self.set, lengths, modulus)
    }

    /// Reads the profile and the parameter values.
    pub(super) fn read(&self, units: &CallUnits) -> Result<(Typed, Settings), Failure> {
        self.read_with(parse::profile, units)
    }

    /// Reads a punch with a rim; its radius a may appear in f.
    pub(super) fn read_punch(&self, units: &CallUnits) -> Result<(Typed, Settings), Failure> {
        // In f, the radius of the rim is a constant that --set does not change; in the formulas it is the contact radius.
        let named = |text: &str| Ok(parse::punch(text)?.substitute(&Bindings::one("a", rim_radius().into())));
        self.read_with(named, units)
    }

    fn read_with(&self, read: impl Fn(&str) -> Result<Formula, ParseError>, units: &CallUnits) -> Result<(Typed, Settings), Failure> {
        let text = match &self.shape {
            Some(name) => self.formula_of(shape(name)?).to_owned(),
            None => text(self.profile.as_deref().unwrap_or_default())?,
        };
        profile_of(text, &self.set, read, units)
    }

    /// Returns f(r) of a named shape, in the form whose parameters were set.
    fn formula_of(&self, shape: &Shape) -> &'static str {
        let names: Vec<Symbol> = self.set.iter().filter_map(|item| symbol(item.split_once('=')?.0)).collect();
        let names: Vec<&str> = names.iter().map(Symbol::name).collect();
        shape.way(&names).map_or("", |way| way.f)
    }
}

/// Reads one of several profiles, with those of the settings that belong to its parameters.
pub(super) fn one_profile(argument: &str, set: &[String], units: &CallUnits) -> Result<(Typed, Settings), Failure> {
    let text = text(argument)?;
    let own: Vec<String> = set.iter().filter(|item| is_about(item, &text)).cloned().collect();
    profile_of(text, &own, parse::profile, units)
}

/// Returns true if the setting belongs to a parameter in the text.
pub(super) fn is_about(item: &str, text: &str) -> bool {
    let name = item.split_once('=').and_then(|(name, _)| symbol(name));
    name.is_some_and(|name| parse::parameters(text).contains(&name))
}

fn profile_of(
    text: String,
    set: &[String],
    read: impl Fn(&str) -> Result<Formula, ParseError>,
    units: &CallUnits,
) -> Result<(Typed, Settings), Failure> {
    let formula = read(&text).map_err(|error| Failure::parse("PROFILE", &text, &error))?;
    let typed = Typed { text, formula };
    let settings = Settings::read(set, &typed, units)?;
    Ok((typed, settings))
}

/// Returns the shape with this name.
pub(super) fn shape(name: &str) -> Result<&'static Shape, Failure> {
    known_shape(name).map_err(|error| {
        let failure = Failure::new(error.to_string());
        match error.accepted() {
            Some(help) => failure.help(help),
            None => failure,
        }
    })
}

/// Parses a parameter name as an expression, so that theta and θ are the same name.
fn symbol(name: &str) -> Option<Symbol> {
    parse::formula(name).ok().and_then(|formula| formula.as_closed().and_then(|expr| expr.as_symbol().cloned()))
}

/// Returns the text of an expression: the argument itself, or stdin for `-`.
pub(super) fn text(argument: &str) -> Result<String, Failure> {
    let text = if argument == "-" { from_stdin()? } else { argument.to_owned() };
    if looks_like_an_option(&text) {
        return Err(Failure::new(format!("unknown option {text}"))
            .help("run with --help for the list of options; a profile may begin with a single minus, such as -(-r)"));
    }
    Ok(text)
}

/// A mistyped option would otherwise be parsed as a parameter with two signs.
fn looks_like_an_option(text: &str) -> bool {
    text.strip_prefix("--").is_some_and(|name| {
        name.len() > 1 && name.starts_with(char::is_alphabetic) && name.chars().all(|c| c.is_alphanumeric() || c == '-' || c == '_')
    })
}

fn from_stdin() -> Result<String, Failure> {
    let limit = parse::limits::TEXT_BYTES;
    let mut bytes = Vec::new();
    let read = io::stdin().lock().take(limit as u64 + 1).read_to_end(&mut bytes);
    read.map_err(|error| Failure::new(format!("cannot read stdin: {error}")))?;
    if bytes.len() > limit {
        return Err(Failure::new(format!("the profile on stdin is longer than {limit} bytes")).help("expected a shorter expression"));
    }
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        Failure::new(format!("stdin is not text: byte {} is not valid UTF-8", at + 1)).help("expected an expression in UTF-8")
    })
}

/// The parameter values that were set.
pub(super) struct Settings(Vec<Setting>);

struct Setting {
    symbol: Symbol,
    exact: Expr,
    value: f64,
    dimension: Dimension,
}

impl Settings {
    /// Parses `--set NAME=VALUE`; every name must be a parameter of the profile, and every value must be positive.
    pub(super) fn read(list: &[String], typed: &Typed, units: &CallUnits) -> Result<Self, Failure> {
        let parameters = parameters(&typed.formula);
        let mut settings: Vec<Setting> = Vec::new();
        for item in list {
            let form = "expected --set NAME=VALUE, such as --set R=2";
            let Some((name, text)) = item.split_once('=') else {
                return Err(Failure::new(format!("--set {item} has no value")).help(form));
            };
            if name.trim().is_empty() {
                return Err(Failure::new(format!("--set {item} has no name")).help(form));
            }
            // A parameter that cancels from the formula may still be set.
            let known = |symbol: &Symbol| parameters.contains(symbol) || parse::parameters(&typed.text).contains(symbol);
            let Some(symbol) = symbol(name).filter(known) else {
                let own = match parameters.as_slice() {
                    [] => "it has no parameters".to_owned(),
                    [only] => format!("it has {only}"),
                    many => format!("it has {}", many.iter().map(Symbol::name).collect::<Vec<_>>().join(", ")),
                };
                let failure = Failure::new(format!("the profile has no parameter {}; {own}", name.trim()));
                return Err(match name.trim() {
                    "E" => failure
                        .help("E is the effective modulus, and not a parameter of the shape; generated functions have it as an argument"),
                    _ if parameters.is_empty() => failure,
                    _ => failure.help(form),
                });
            };
            if settings.iter().any(|known| known.symbol == symbol) {
                return Err(Failure::new(format!("{symbol} is set twice")).help("remove one of the two settings"));
            }
            let place = format!("--set {symbol}");
            let (exact, value, dimension) = units.parameter(&place, text)?;
            if value <= 0.0 {
                let message = format!("{symbol} = {} is not positive", text.trim());
                return Err(Failure::new(message).help("parameters are positive; include the sign in the profile").at(
                    &place,
                    text,
                    0..text.len(),
                ));
            }
            if value >= FRAC_PI_2 && dimension.is_none() && typed.formula.expressions().into_iter().any(|expr| has_angle(expr, &symbol)) {
                let bare = DimensionedNumber::parse(text).is_ok_and(|own| own.unit().is_none());
                let unit = if bare { "; a number without a unit is in radians" } else { "" };
                warn(&format!("{symbol} = {} is not below 90 deg{unit}", text.trim()));
            }
            settings.push(Setting { symbol, exact, value, dimension });
        }
        // A parameter without a value may have any dimension.
        if settings.len() == parameters.len() {
            units.check(&typed.text, &typed.formula, settings.iter().map(|own| (own.symbol.clone(), own.dimension)).collect())?;
        }
        Ok(Self(settings))
    }

    /// Returns the values exactly as typed.
    pub(super) fn exact(&self) -> Bindings {
        self.0.iter().map(|own| (own.symbol.name(), own.exact.clone())).collect()
    }

    /// Returns the values rounded to `f64`, as exact expressions; angles that are rational multiples of π remain exact, because
    /// the tangent of an angle near 90 deg changes strongly with its last digit.
    pub(super) fn rounded(&self) -> Bindings {
        let is_angle = |own: &Setting| (&own.exact / Expr::pi()).as_number().is_some();
        let number = |own: &Setting| Number::from_f64(own.value).filter(|_| !is_angle(own)).map_or_else(|| own.exact.clone(), Expr::number);
        self.0.iter().map(|own| (own.symbol.name(), number(own))).collect()
    }

    /// Returns the profile with the values exactly as typed.
    pub(super) fn exact_profile(&self, typed: &Typed) -> Result<Profile, TransformError> {
        Profile::new(&typed.formula.substitute(&self.exact()))
    }

    /// Returns the profile with the values rounded to `f64`, or, if its pieces then do not meet,
    /// with the values exactly as typed.
    pub(super) fn bound_profile(&self, typed: &Typed) -> Result<Profile, Failure> {
        let rounded = Profile::new(&typed.formula.substitute(&self.rounded()));
        rounded.or_else(|first| self.exact_profile(typed).map_err(|_| Failure::profile(&typed.text, &first.into())))
    }

    /// Returns names and values.
    pub(super) fn values(&self) -> Vec<(String, f64)> {
        self.0.iter().map(|own| (own.symbol.name().to_owned(), own.value)).collect()
    }

    /// Returns the units of the values, in the same order.
    pub(super) fn units(&self, units: &CallUnits) -> Vec<String> {
        self.0.iter().map(|own| units.name(own.dimension)).collect()
    }

    /// Returns an error that names the parameters without a value, if there are any.
    pub(super) fn demand_all(&self, typed: &Typed) -> Result<(), Failure> {
        let missing: Vec<Symbol> = parameters(&typed.formula).into_iter().filter(|p| self.0.iter().all(|own| own.symbol != *p)).collect();
        let names = missing.iter().map(Symbol::name).collect::<Vec<_>>().join(", ");
        let options = missing.iter().map(|name| format!("--set {name}=VALUE")).collect::<Vec<_>>().join(" ");
        match missing.len() {
            0 => Ok(()),
            1 => Err(Failure::new(format!("the parameter {names} has no value")).help(format!("set its value with {options}"))),
            _ => Err(Failure::new(format!("the parameters {names} have no values")).help(format!("set their values with {options}"))),
        }
    }
}

/// Returns true if a parameter is the argument of a sine, cosine or tangent, which are of slope angles.
fn has_angle(expr: &Expr, symbol: &Symbol) -> bool {
    match expr.node() {
        Node::Function(function, arguments)
            if matches!(function.name(), "sin" | "cos" | "tan") && arguments.iter().any(|own| own.as_symbol() == Some(symbol)) =>
        {
            true
        }
        _ => expr.children().into_iter().any(|child| has_angle(child, symbol)),
    }
}

/// Returns the parameters of a profile, or of an equivalent profile g(x), by name.
fn parameters(formula: &Formula) -> Vec<Symbol> {
    formula.symbols().into_iter().filter(|symbol| !matches!(symbol.name(), "r" | "x") && *symbol != rim_radius()).collect()
}

/// Parses a finite number; also returns it as an exact expression.
pub(super) fn constant(place: &str, text: &str) -> Result<(Expr, f64), Failure> {
    let exact = parse::constant(text).map_err(|error| Failure::parse(place, text, &error))?;
    let value = finite(place, text, &exact)?;
    Ok((exact, value))
}

/// Parses a positive finite number.
pub(super) fn positive(place: &str, text: &str) -> Result<f64, Failure> {
    let (_, value) = constant(place, text)?;
    if value > 0.0 {
        return Ok(value);
    }
    Err(Failure::new(format!("{} is not positive", text.trim())).help("expected a positive number").at(place, text, 0..text.len()))
}

/// Parses a tolerance between 0 and 1.
pub(super) fn tolerance(text: &str) -> Result<f64, Failure> {
    let value = positive("--tol", text)?;
    if value < 1.0 {
        return Ok(value);
    }
    let fault = Failure::new(format!("{} is not below 1", text.trim())).help("expected a relative tolerance such as 1e-10");
    Err(fault.at("--tol", text, 0..text.len()))
}
