//! Python 3 with its math module, and SciPy for other functions.

use super::{Target, Words, comment, decimal, head, parts, whole};
use crate::code::accuracy::ELEMENTARY;
use crate::code::program::{Program, routine_name};
use crate::code::tree::LENGTH;

pub(super) struct Python;

/// Non-elementary functions with their assumed accuracy.
const LIBRARY: [(&str, &str, f64); 9] = [
    ("erf", "math.erf", 2.0),
    ("gamma", "math.gamma", 12.0),
    ("besselj", "scipy.special.jv", 64.0),
    ("besseli", "scipy.special.iv", 64.0),
    ("besseli_scaled", "scipy.special.ive", 64.0),
    ("struveh", "scipy.special.struve", 64.0),
    ("struvel", "scipy.special.modstruve", 64.0),
    ("hyp1f1", "scipy.special.hyp1f1", 256.0),
    ("erfi", "scipy.special.erfi", 16.0),
];

/// Functions of `math` that raise `OverflowError` where the other languages return an infinity, as a search for a radius needs it.
const OVERFLOWING: [&str; 5] = ["exp", "expm1", "sinh", "cosh", "pow"];
const OR_INFINITE: &str = "_or_infinite";

const RESERVED: &str = " False None True and as assert async await break class continue def del elif else except finally for from global if \
import in is lambda nonlocal not or pass raise return try while with yield match case type _ math scipy abs max min float print range int \
np numpy lmfit delta force params contact_point baseline ";

impl Target for Python {
    fn words(&self) -> Words {
        Words {
            comment: "# ",
            when: ("if ", ":"),
            otherwise: "else:",
            end_when: "",
            during: ("while ", ":"),
            end_during: "",
            both: " and ",
            either: " or ",
            not: "not ",
        }
    }

    fn number(&self, value: f64) -> String {
        decimal(value)
    }

    fn call(&self, name: &str, arguments: &[String]) -> String {
        let list = arguments.join(", ");
        match name {
            "nan" => "math.nan".to_owned(),
            "inf" => "math.inf".to_owned(),
            "abs" | "max" | "min" => format!("{name}({list})"),
            // math.floor returns an int, which would change the type of subsequent results.
            "floor" => format!("float(math.floor({list}))"),
            _ => match self.library(name) {
                Some((written, _)) if written.starts_with("scipy") => format!("float({written}({list}))"),
                Some((written, _)) => format!("{written}({list})"),
                None if OVERFLOWING.contains(&name) => format!("{OR_INFINITE}(math.{name}, {list})"),
                None if ELEMENTARY.contains(&name) => format!("math.{name}({list})"),
                None => format!("{}({list})", self.spelled(name)),
            },
        }
    }

    /// A leading underscore, which no parameter name has.
    fn spelled(&self, routine: &str) -> String {
        format!("_{}", routine.strip_prefix("sneddon_").unwrap_or(routine))
    }

    fn is_reserved(&self, word: &str) -> bool {
        RESERVED.contains(&format!(" {word} "))
    }

    fn library(&self, name: &str) -> Option<(&'static str, f64)> {
        LIBRARY.iter().find(|(own, ..)| *own == name).map(|(_, written, ulps)| (*written, *ulps))
    }

    fn declare(&self, name: &str, value: &str, _changes: bool) -> String {
        format!("{name} = {value}")
    }

    fn array(&self, name: &str) -> String {
        format!("{name} = [0.0]*{LENGTH}")
    }

    fn table(&self, name: &str, _count: usize) -> (String, &'static str, &'static str) {
        (format!("{name} = ("), ")", "")
    }

    fn element(&self, name: &str, index: &str) -> String {
        match whole(index) {
            Some(whole) => format!("{name}[{whole}]"),
            None => format!("{name}[int({index})]"),
        }
    }

    fn assign(&self, name: &str, value: &str) -> String {
        format!("{name} = {value}")
    }

    fn give(&self, value: &str) -> Vec<String> {
        vec![format!("return {value}")]
    }

    fn file(&self, program: &Program) -> String {
        let mut lines = head(program);
        lines.push(
            "The functions take and return floats; outside the domain, and where the value is infinite, they raise ValueError.".to_owned(),
        );
        let mut text = comment(&lines, "# ");
        text.push_str(&imports(program));
        text.push_str(&routines(program));
        text.push_str(CHECKED);
        for quantity in &program.quantities {
            let name = routine_name(*quantity);
            let Some(routine) = program.routines.iter().find(|own| own.name == name) else { continue };
            let (list, _) = parts(routine, self);
            text.push_str(&format!(
                "\n\n{}def {}({list}):\n    return _checked({}, {list})\n",
                comment(&routine.comment, "# "),
                quantity.key(),
                self.spelled(&name)
            ));
        }
        text
    }
}

/// The modules that a program needs.
pub(super) fn imports(program: &Program) -> String {
    let scipy = program.library.iter().any(|own| Python.library(own).is_some_and(|(written, _)| written.starts_with("scipy")));
    format!("import math\n{}", if scipy { "\nimport scipy.special\n" } else { "" })
}

/// Every routine under its internal name; NaN outside the domain.
pub(super) fn routines(program: &Program) -> String {
    let mut text = String::new();
    for routine in &program.routines {
        let (list, body) = parts(routine, &Python);
        let lines = if program.is_public(routine) { Vec::new() } else { routine.comment.clone() };
        text.push_str(&format!("\n\n{}def {}({list}):\n{body}", comment(&lines, "# "), Python.spelled(&routine.name)));
    }
    if text.contains(OR_INFINITE) { format!("{DEFINED}{text}") } else { text }
}

const DEFINED: &str = "

def _or_infinite(function, x, *exponent):
    try:
        return function(x, *exponent)
    except OverflowError:
        is_odd = function is math.sinh or (function is math.pow and exponent[0] % 2.0 == 1.0)
        return -math.inf if x < 0.0 and is_odd else math.inf
";

const CHECKED: &str = "

def _checked(function, *arguments):
    try:
        value = function(*map(float, arguments))
    except (ArithmeticError, ValueError):
        value = math.nan
    if math.isfinite(value):
        return value
    raise ValueError(\"no finite value at \" + repr(arguments))
";
