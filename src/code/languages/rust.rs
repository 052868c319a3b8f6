//! Rust with its standard library.

use super::{Target, Words, comment, decimal, head, parts, whole};
use crate::code::accuracy::ELEMENTARY;
use crate::code::program::Program;
use crate::code::tree::LENGTH;

pub(super) struct Rust;

const RESERVED: &str = " as async await break const continue crate dyn else enum extern false fn for gen if impl in let loop match mod move \
mut pub ref return self Self static struct super trait true type unsafe use where while abstract become box do final macro override priv \
try typeof unsized virtual yield union raw safe f64 f32 bool str value Result Ok Err Option Some None String Vec ";

impl Target for Rust {
    fn words(&self) -> Words {
        Words {
            comment: "// ",
            when: ("if ", " {"),
            otherwise: "} else {",
            end_when: "}",
            during: ("while ", " {"),
            end_during: "}",
            both: " && ",
            either: " || ",
            not: "!",
        }
    }

    fn number(&self, value: f64) -> String {
        decimal(value)
    }

    fn call(&self, name: &str, arguments: &[String]) -> String {
        let list = arguments.join(", ");
        let method = match name {
            "nan" => return "f64::NAN".to_owned(),
            "inf" => return "f64::INFINITY".to_owned(),
            "log" => "ln",
            "log1p" => "ln_1p",
            "expm1" => "exp_m1",
            "pow" => "powf",
            _ if ELEMENTARY.contains(&name) => name,
            _ => return format!("{}({list})", self.spelled(name)),
        };
        format!("f64::{method}({list})")
    }

    /// The names of the inner routines end with an underscore: those without are the functions that check.
    fn spelled(&self, routine: &str) -> String {
        if routine.starts_with("sneddon_") { format!("{routine}_") } else { format!("sneddon_{routine}_") }
    }

    fn is_reserved(&self, word: &str) -> bool {
        RESERVED.contains(&format!(" {word} "))
    }

    fn declare(&self, name: &str, value: &str, changes: bool) -> String {
        let change = if changes { "mut " } else { "" };
        format!("let {change}{name}: f64 = {value};")
    }

    fn array(&self, name: &str) -> String {
        format!("let mut {name} = [0.0_f64; {LENGTH}];")
    }

    fn table(&self, name: &str, _count: usize) -> (String, &'static str, &'static str) {
        (format!("let {name} = ["), "];", "")
    }

    fn element(&self, name: &str, index: &str) -> String {
        match whole(index) {
            Some(whole) => format!("{name}[{whole}]"),
            None => format!("{name}[({index}) as usize]"),
        }
    }

    fn assign(&self, name: &str, value: &str) -> String {
        format!("{name} = {value};")
    }

    fn give(&self, value: &str) -> Vec<String> {
        vec![format!("return {value};")]
    }

    fn file(&self, program: &Program) -> String {
        let mut lines = head(program);
        lines.push("Outside the domain the result is an error.".to_owned());
        let mut text = comment(&lines, "// ");
        const ALLOWED: &str = "#[allow(non_snake_case, unused_variables, unused_assignments, unused_parens, clippy::all)]\n";
        for routine in &program.routines {
            let (_, body) = parts(routine, self);
            let list: Vec<String> = routine.parameters.iter().map(|own| format!("{own}: f64")).collect();
            let (list, name) = (list.join(", "), self.spelled(&routine.name));
            if program.is_public(routine) {
                let arguments = routine.parameters.join(", ");
                let outer = &routine.name;
                text.push_str(&format!(
                    "\n{}{ALLOWED}pub fn {outer}({list}) -> Result<f64, &'static str> {{\n    let value = {name}({arguments});\n    \
                     if value.is_finite() {{ Ok(value) }} else {{ Err(\"{outer} has no finite value here\") }}\n}}\n",
                    comment(&routine.comment, "/// "),
                ));
                text.push_str(&format!("\n{ALLOWED}fn {name}({list}) -> f64 {{\n{body}}}\n"));
            } else {
                text.push_str(&format!("\n{}{ALLOWED}fn {name}({list}) -> f64 {{\n{body}}}\n", comment(&routine.comment, "// ")));
            }
        }
        text
    }
}
