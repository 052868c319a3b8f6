//! MATLAB and GNU Octave, with their own functions.

use super::{Target, Words, comment, decimal, head, parts};
use crate::code::accuracy::ELEMENTARY;
use crate::code::program::{Program, routine_name};
use crate::code::tree::{LENGTH, Routine};

pub(super) struct Matlab;

/// Non-elementary functions with their assumed accuracy.
const LIBRARY: [(&str, &str, f64); 4] =
    [("erf", "erf", 4.0), ("gamma", "gamma", 12.0), ("besselj", "besselj", 64.0), ("besseli", "besseli", 64.0)];

const RESERVED: &str = " break case catch classdef continue else elseif end for function global if otherwise parfor persistent return \
spmd switch try while do until unwind_protect endfunction endif endwhile endfor NaN Inf pi eps i j ans nan inf sqrt exp log log1p expm1 \
sin cos tan asin acos atan atan2 sinh cosh tanh asinh atanh abs max min floor erf gamma besselj besseli e true false nargin nargout ";

impl Target for Matlab {
    fn words(&self) -> Words {
        Words {
            comment: "% ",
            when: ("if ", ""),
            otherwise: "else",
            end_when: "end",
            during: ("while ", ""),
            end_during: "end",
            both: " && ",
            either: " || ",
            not: "~",
        }
    }

    fn number(&self, value: f64) -> String {
        decimal(value)
    }

    fn call(&self, name: &str, arguments: &[String]) -> String {
        let list = arguments.join(", ");
        match name {
            "nan" => "NaN".to_owned(),
            "inf" => "Inf".to_owned(),
            "pow" => match arguments {
                [base, exponent] => format!("(({base})^({exponent}))"),
                _ => list,
            },
            _ if ELEMENTARY.contains(&name) || self.library(name).is_some() => format!("{name}({list})"),
            _ => format!("{}({list})", self.spelled(name)),
        }
    }

    fn spelled(&self, routine: &str) -> String {
        if routine.starts_with("sneddon_") { routine.to_owned() } else { format!("sneddon_{routine}") }
    }

    fn is_reserved(&self, word: &str) -> bool {
        RESERVED.contains(&format!(" {word} "))
    }

    fn library(&self, name: &str) -> Option<(&'static str, f64)> {
        LIBRARY.iter().find(|(own, ..)| *own == name).map(|(_, written, ulps)| (*written, *ulps))
    }

    fn declare(&self, name: &str, value: &str, _changes: bool) -> String {
        format!("{name} = {value};")
    }

    fn array(&self, name: &str) -> String {
        format!("{name} = zeros(1, {LENGTH});")
    }

    fn table(&self, name: &str, _count: usize) -> (String, &'static str, &'static str) {
        (format!("{name} = ["), "];", " ...")
    }

    fn element(&self, name: &str, index: &str) -> String {
        format!("{name}({index} + 1)")
    }

    fn assign(&self, name: &str, value: &str) -> String {
        format!("{name} = {value};")
    }

    fn give(&self, value: &str) -> Vec<String> {
        vec![format!("t0 = {value};"), "return".to_owned()]
    }

    fn file(&self, program: &Program) -> String {
        let mut lines = head(program);
        lines.push("The functions take and return numbers, not arrays; outside the domain the result is NaN.".to_owned());
        let script = match program.quantities.as_slice() {
            [only] => {
                lines.push(format!("Save it as {}.m: MATLAB and Octave call a function by the name of its file.", routine_name(*only)));
                ""
            }
            _ => {
                lines.push(
                    "A script: Octave reads its functions with source(\"FILE.m\"); in MATLAB, insert the calls after \"1;\".".to_owned(),
                );
                lines.push("For functions that MATLAB calls from elsewhere, write one file for each quantity.".to_owned());
                // Octave takes a file that begins with a function for that function.
                "\n1;\n"
            }
        };
        let mut text = comment(&lines, "% ") + script;
        // What is called from outside comes first.
        let (public, inner): (Vec<&Routine>, Vec<&Routine>) = program.routines.iter().partition(|own| program.is_public(own));
        let rank =
            |own: &&Routine| program.quantities.iter().position(|quantity| routine_name(*quantity) == own.name).unwrap_or(usize::MAX);
        let mut public = public;
        public.sort_by_key(rank);
        for routine in public.into_iter().chain(inner) {
            let (list, body) = parts(routine, self);
            text.push_str(&format!(
                "\nfunction t0 = {}({list})\n{}{body}end\n",
                self.spelled(&routine.name),
                comment(&routine.comment, "% ")
            ));
        }
        text
    }
}
