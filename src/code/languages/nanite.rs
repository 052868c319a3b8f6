//! A model file for nanite and PyJibe: F over the indentation, with lmfit's parameters; it imports no part of this program.

use super::python::{Python, imports, routines};
use super::{Target, comment, decimal, head};
use crate::code::build::ParameterDimension;
use crate::code::program::{Program, routine_name};
use crate::contact::Quantity;

/// The model file of a program that has F(d).
pub(super) fn file(program: &Program) -> String {
    let mut text = comment(&head(program), "# ");
    text.push_str("# Load it in nanite with nanite.model.load_model_from_file, in PyJibe with Preferences, Extensions.\n");
    text.push_str(&imports(program));
    text.push_str("\nimport lmfit\nimport numpy as np\n");
    text.push_str(&routines(program));
    let identifiers: Vec<&str> = program.parameters.iter().map(|(_, own)| own.as_str()).collect();
    let listed = |own: &dyn Fn(&str) -> String| identifiers.iter().map(|name| own(name)).collect::<String>();
    let keys = listed(&|name| format!(" {name},"));
    let strings = listed(&|name| format!(" \"{name}\","));
    let own: Vec<Shown<'_>> = shown(program);
    let of_all = |write: &dyn Fn(&Shown<'_>) -> String| own.iter().map(write).collect::<String>();
    let defaults = of_all(&|own| {
        let most = if own.unit == "rad" { ", max=1.57" } else { "" };
        format!("    params.add(\"{}\", value={}, min=1e-12{most}, vary=False)\n", own.identifier, decimal(own.starting_value))
    });
    let units = of_all(&|own| format!(" \"{}\",", own.unit));
    let titles = of_all(&|own| format!(" \"{}\",", own.title()));
    let documented = of_all(&|own| {
        let unit = if own.unit.is_empty() { "no unit" } else { &own.unit };
        format!("    {}: float\n        {} [{unit}]\n", own.identifier, own.meaning.unwrap_or("Parameter of the shape"))
    });
    // E of the function is the effective modulus, and that of the model Young's modulus.
    let described: Vec<String> = program
        .routines
        .iter()
        .filter(|own| own.name == routine_name(Quantity::ForceOfDepth))
        .flat_map(|own| own.comment.clone())
        .filter(|own| !own.starts_with("Units: "))
        .collect();
    let described = comment(&described, "    ").replace('"', " ");
    let arguments = identifiers.iter().map(|own| format!(", {own}")).collect::<String>();
    let force = Python.spelled(&routine_name(Quantity::ForceOfDepth));
    text.push_str(&format!(
        "

def get_parameter_defaults():
    \"\"\"Return the default model parameters\"\"\"
    params = lmfit.Parameters()
    params.add(\"E\", value=3e3, min=0)
{defaults}    params.add(\"nu\", value=0.5, min=0, max=0.5, vary=False)
    params.add(\"contact_point\", value=0)
    params.add(\"baseline\", value=0)
    return params


def _force_at(depth, modulus{arguments}):
    try:
        return {force}(depth, modulus{arguments})
    except (ArithmeticError, ValueError):
        return math.nan


def indentation_force(delta, E,{keys} nu, contact_point=0, baseline=0):
    r\"\"\"Force of a rigid indenter: {title}

{described}
    Parameters
    ----------
    delta: 1d ndarray
        Indentation [m]
    E: float
        Young's modulus [N/m²]
{documented}    nu: float
        Poisson's ratio
    contact_point: float
        Indentation offset [m]
    baseline: float
        Force offset [N]

    Returns
    -------
    F: float
        Force [N]; NaN where the profile ends before g reaches the depth
    \"\"\"
    modulus = E/(1 - nu**2)
    depth = np.asarray(contact_point - delta, dtype=float)
    force = np.zeros_like(depth)
    inside = depth > 0
    force[inside] = [_force_at(float(own), modulus{arguments}) for own in depth[inside]]
    return force + baseline


model_doc = indentation_force.__doc__
model_func = indentation_force
model_key = \"{key}\"
model_name = \"{name}\"
parameter_keys = [\"E\",{strings} \"nu\", \"contact_point\", \"baseline\"]
parameter_names = [\"Young's Modulus\",{titles} \"Poisson's Ratio\", \"Contact Point\", \"Force Baseline\"]
parameter_units = [\"Pa\",{units} \"\", \"m\", \"N\"]
valid_axes_x = [\"tip position\"]
valid_axes_y = [\"force\"]
",
        title = title(program),
        key = key(program),
        name = name(program),
    ));
    text
}

/// A parameter as a model shows it.
struct Shown<'a> {
    identifier: &'a str,
    meaning: Option<&'a str>,
    unit: String,
    starting_value: f64,
}

impl Shown<'_> {
    /// The description in the manner of other models, or the identifier.
    fn title(&self) -> String {
        let Some(meaning) = self.meaning else { return self.identifier.to_owned() };
        let mut letters = meaning.chars();
        letters.next().map(|own| own.to_uppercase().chain(letters).collect()).unwrap_or_default()
    }
}

fn shown(program: &Program) -> Vec<Shown<'_>> {
    let meaning = |symbol: &str| {
        let meanings = program.shape.iter().flat_map(|own| &own.meanings);
        meanings.into_iter().find(|(name, _)| name == symbol).map(|(_, own)| own.as_str())
    };
    let all = program.parameters.iter().zip(&program.dimensions).zip(&program.starting_values);
    all.map(|(((symbol, identifier), dimension), starting_value)| Shown {
        identifier,
        meaning: meaning(symbol),
        unit: unit(dimension),
        starting_value: *starting_value,
    })
    .collect()
}

fn unit(dimension: &ParameterDimension) -> String {
    match dimension {
        ParameterDimension::Angle => "rad".to_owned(),
        ParameterDimension::Open => "SI".to_owned(),
        ParameterDimension::Length(0.0) => String::new(),
        ParameterDimension::Length(1.0) => "m".to_owned(),
        ParameterDimension::Length(exponent) => format!("m^{exponent}"),
    }
}

/// The longest name that is shown.
const LONGEST_NAME: usize = 60;

/// The name that programs show.
fn name(program: &Program) -> String {
    let own = if program.shape.is_some() { " (sneddon)" } else { "" };
    format!("{}{own}", title(program))
}

/// The title of the shape, else the shape as typed, without what would end a string.
fn title(program: &Program) -> String {
    if let Some(shape) = &program.shape {
        return shape.title.clone();
    }
    let plain = program.profile.chars().filter(|own| own.is_ascii_graphic() && !matches!(own, '"' | '\\') || *own == ' ');
    format!("f(r) = {}", plain.take(LONGEST_NAME).collect::<String>())
}

/// A key of the model: the name of the shape, else a number that differs from profile to profile.
fn key(program: &Program) -> String {
    if let Some(shape) = &program.shape {
        return format!("sneddon_{}", shape.name.replace('-', "_"));
    }
    // FNV-1a.
    let hash = program.profile.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |own, byte| (own ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
    format!("sneddon_{:08x}", hash >> 32)
}
