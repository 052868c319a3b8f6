//! What a name means: a constant, a variable, a parameter, or an error with a better name.

use super::super::{ParseError, Reason};
use crate::expr::{Expr, Function};
use std::ops::Range;

/// Which names a text may use.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::parse) enum Names {
    /// `r` and parameters.
    Profile,
    /// `r`, `a` and parameters.
    Punch,
    /// `x` and parameters.
    Equivalent,
    /// `r`, `a`, `E` and parameters.
    Pressure,
    /// Every variable and parameter.
    Formula,
    /// Constants alone.
    None,
}

/// Functions of the grammar that have no row in the function table.
const BUILT_IN: [&str; 7] = ["sqrt", "piecewise", "integral", "J0", "J1", "I0", "I1"];

/// Functions of other languages, and how a profile has them.
const FOREIGN: [(&str, &str); 11] = [
    ("csc", "1/sin(…)"),
    ("sec", "1/cos(…)"),
    ("cot", "1/tan(…)"),
    ("coth", "1/tanh(…)"),
    ("lg", "ln(…)/ln(10)"),
    ("if", "piecewise(value, r<b, other value)"),
    ("where", "piecewise(value, r<b, other value)"),
    ("step", "piecewise(0, r<b, value)"),
    ("heaviside", "piecewise(0, r<b, value)"),
    ("sign", "piecewise(-value, r<b, value)"),
    ("sgn", "piecewise(-value, r<b, value)"),
];

/// Function names that are Greek letters too; without parentheses they are parameters.
const GREEK: [&str; 4] = ["beta", "zeta", "kappa", "chi"];

const CONSTANTS: &str = "expected a constant such as 0.3, 3/2, 1e-6, -1, pi/6 or sqrt(2)";

impl Names {
    /// The expression that a name without parentheses denotes.
    pub(in crate::parse) fn resolve(self, name: &str, span: &Range<usize>) -> Result<Expr, ParseError> {
        let error = |reason, accepted: String| Err(ParseError::new(span.clone(), reason, accepted));
        match name {
            "pi" => return Ok(Expr::pi()),
            "e" => return Ok(Expr::euler()),
            _ => {}
        }
        let owned = name.to_owned();
        if is_function(name) {
            let accepted = match name {
                "gamma" => "write gamma(…) for the function, or call the parameter gamma_0".to_owned(),
                _ => format!("write {name}(…), or give a parameter another name, such as {name}_0"),
            };
            return error(Reason::FunctionWithoutArguments { name: owned }, accepted);
        }
        match self {
            Self::None => error(Reason::NotConstant { name: owned }, CONSTANTS.to_owned()),
            Self::Profile | Self::Punch | Self::Equivalent | Self::Pressure => match self.reserved(name) {
                Some((meaning, accepted)) => error(Reason::Reserved { name: owned, meaning }, accepted.to_owned()),
                None => Ok(Expr::symbol(name)),
            },
            Self::Formula => Ok(Expr::symbol(name)),
        }
    }

    /// True for a name that conditions of `piecewise` may compare.
    pub(super) fn is_variable(self, name: &str) -> bool {
        match self {
            Self::Formula => matches!(name, "r" | "x" | "a" | "d"),
            Self::Equivalent => name == "x",
            Self::Profile | Self::Punch | Self::Pressure | Self::None => name == "r",
        }
    }

    /// Meaning and better names of the names that this kind of text may not use.
    fn reserved(self, name: &str) -> Option<(&'static str, &'static str)> {
        match (self, name) {
            (Self::Equivalent, "x") | (Self::Pressure, "a" | "E") | (Self::Punch, "a") => None,
            (Self::Equivalent, "r") => Some(("the radius", "the coordinate of g is x; for a parameter write r_0")),
            _ => reserved(name),
        }
    }

    /// The advice for an unknown function name.
    pub(super) fn nearest(self, name: &str) -> String {
        if let Some((_, written)) = FOREIGN.iter().find(|(known, _)| *known == name.to_ascii_lowercase()) {
            return format!("write {written}");
        }
        let rows = Function::all().filter(|function| function.row().shown.is_none());
        let names = rows.flat_map(|f| std::iter::once(f.name()).chain(f.row().spellings.iter().copied()));
        let known = names.chain(BUILT_IN).filter(|known| self == Self::Formula || *known != "integral");
        let mut near: Vec<(usize, &str)> =
            known.map(|known| (distance(name, known), known)).filter(|(d, known)| *d <= known.len() / 3).collect();
        near.sort_unstable();
        near.dedup();
        let near: Vec<&str> = near.into_iter().take(3).map(|(_, known)| known).collect();
        match near.as_slice() {
            [] if name.chars().count() <= 2 => format!("write {name}*(…) for a product"),
            [] => "expected a function such as sqrt, exp, ln, sin, cos, tan, atan, sinh, abs, erf, min, max or piecewise".to_owned(),
            [only] => format!("expected {only}, or {name}*(…) for a product"),
            [names @ .., last] => format!("expected {} or {last}", names.join(", ")),
        }
    }
}

/// True for a name that needs parentheses.
pub(in crate::parse) fn is_function(name: &str) -> bool {
    let built_in = matches!(name, "sqrt" | "piecewise" | "integral");
    built_in || (!GREEK.contains(&name) && Function::named(name).is_some())
}

/// Meaning and better names of the names that a profile may not use.
fn reserved(name: &str) -> Option<(&'static str, &'static str)> {
    Some(match name {
        "x" => ("the coordinate of the transformed profile g(x)", "the radius is r; for a parameter write x_0"),
        "a" => (
            "the contact radius",
            "the radius is r; for a parameter write a_0 or b; a is allowed as the radius of a rim if the depth is given",
        ),
        "d" => ("the depth", "for a parameter write d_0 or h"),
        "E" => ("the effective modulus", "for a parameter write E_0; Euler's number is e"),
        _ => return None,
    })
}

/// The number of insertions, deletions and replacements between two names; long names are far from all others.
fn distance(left: &str, right: &str) -> usize {
    if left.len() > 20 {
        return usize::MAX;
    }
    let left = left.to_ascii_lowercase();
    let mut row: Vec<usize> = (0..=right.len()).collect();
    for (i, l) in left.bytes().enumerate() {
        let mut next = vec![i + 1];
        for ((above_left, above), r) in row.iter().zip(row.iter().skip(1)).zip(right.bytes()) {
            let side = next.last().copied().unwrap_or(0);
            next.push((above_left + usize::from(l != r.to_ascii_lowercase())).min(above + 1).min(side + 1));
        }
        row = next;
    }
    row.last().copied().unwrap_or(usize::MAX)
}
