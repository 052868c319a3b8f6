//! Fortran 2008 in free form, as a module; log1p and expm1 are those of C.

use super::{Target, Words, comment, decimal, head, parts, whole};
use crate::code::accuracy::ELEMENTARY;
use crate::code::program::{Program, routine_name};
use crate::code::tree::LENGTH;

pub(super) struct Fortran;

/// Non-elementary intrinsic functions with their assumed accuracy.
const LIBRARY: [(&str, &str, f64); 3] = [("erf", "erf", 2.0), ("gamma", "gamma", 12.0), ("besselj", "bessel_jn", 64.0)];

const RESERVED: &str = " dp sneddon if then else end endif do while enddo return function result module contains implicit none use \
only real integer logical character complex type class call pure elemental intent in out parameter interface bind c print stop sqrt exp \
log sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh abs max min floor log1p expm1 erf gamma bessel_jn ieee_value \
ieee_quiet_nan ieee_positive_inf c_double c_int ";

/// The longest line of the standard, with room for the sign of continuation.
const LINE: usize = 120;

impl Target for Fortran {
    fn words(&self) -> Words {
        Words {
            comment: "! ",
            when: ("if (", ") then"),
            otherwise: "else",
            end_when: "end if",
            during: ("do while (", ")"),
            end_during: "end do",
            both: " .and. ",
            either: " .or. ",
            not: ".not. ",
        }
    }

    fn number(&self, value: f64) -> String {
        format!("{}_dp", decimal(value))
    }

    fn call(&self, name: &str, arguments: &[String]) -> String {
        let list = arguments.join(", ");
        match name {
            "nan" => "ieee_value(1.0_dp, ieee_quiet_nan)".to_owned(),
            "inf" => "ieee_value(1.0_dp, ieee_positive_inf)".to_owned(),
            "pow" => match arguments {
                [base, exponent] => format!("(({base})**({exponent}))"),
                _ => list,
            },
            "floor" => format!("aint({list})"),
            "besselj" => match arguments {
                [order, at] => format!("bessel_jn(int({order}), {at})"),
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

    fn ignores_case(&self) -> bool {
        true
    }

    fn library(&self, name: &str) -> Option<(&'static str, f64)> {
        LIBRARY.iter().find(|(own, ..)| *own == name).map(|(_, written, ulps)| (*written, *ulps))
    }

    fn declare(&self, name: &str, value: &str, _changes: bool) -> String {
        format!("{name} = {value}")
    }

    fn array(&self, name: &str) -> String {
        format!("{name} = 0.0_dp")
    }

    fn table(&self, name: &str, _count: usize) -> (String, &'static str, &'static str) {
        (format!("{name} = ["), "]", " &")
    }

    fn element(&self, name: &str, index: &str) -> String {
        match whole(index) {
            Some(whole) => format!("{name}({whole})"),
            None => format!("{name}(int({index}))"),
        }
    }

    fn assign(&self, name: &str, value: &str) -> String {
        format!("{name} = {value}")
    }

    fn give(&self, value: &str) -> Vec<String> {
        vec![format!("t0 = {value}"), "return".to_owned()]
    }

    fn file(&self, program: &Program) -> String {
        let mut lines = head(program);
        lines.push("Outside the domain the result is a quiet NaN.".to_owned());
        let mut text = comment(&lines, "! ");
        let public: Vec<String> = program.quantities.iter().map(|own| self.spelled(&routine_name(*own))).collect();
        text.push_str(&format!("module sneddon\n{HEAD}    public :: {}\n{INTERFACE}contains\n", public.join(", ")));
        for routine in &program.routines {
            let (list, body) = parts(routine, self);
            let name = self.spelled(&routine.name);
            let mut declared = format!("    real(dp), intent(in) :: {list}\n    real(dp) :: t0\n");
            let variables = routine.variables();
            if !variables.is_empty() {
                declared.push_str(&format!("    real(dp) :: {}\n", variables.join(", ")));
            }
            for own in routine.arrays() {
                declared.push_str(&format!("    real(dp) :: {own}(0:{})\n", LENGTH - 1));
            }
            for (own, count) in routine.tables() {
                declared.push_str(&format!("    real(dp) :: {own}(0:{})\n", count - 1));
            }
            text.push_str(&format!(
                "\n{}pure recursive function {name}({list}) result(t0)\n{declared}{body}end function {name}\n",
                comment(&routine.comment, "! ")
            ));
        }
        text.push_str("\nend module sneddon\n");
        text.lines().map(broken).collect()
    }
}

/// A line that is too long, continued on others; comments have any length.
fn broken(line: &str) -> String {
    if line.chars().count() <= LINE || line.trim_start().starts_with('!') {
        return format!("{line}\n");
    }
    let indent: String = line.chars().take_while(|c| *c == ' ').collect();
    let (mut text, mut current) = (String::new(), String::new());
    // Between two signs a line may always be continued.
    for piece in line.split_inclusive(['*', '/', ',', ' ']) {
        if current.chars().count() + piece.chars().count() > LINE && !current.trim().is_empty() {
            text.push_str(&format!("{current}&\n"));
            current = format!("{indent}    &");
        }
        current.push_str(piece);
    }
    format!("{text}{current}\n")
}

const HEAD: &str = "    use, intrinsic :: iso_c_binding, only: c_double
    use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan, ieee_positive_inf
    implicit none
    private
    integer, parameter :: dp = c_double
";

const INTERFACE: &str = "
    interface
        pure function log1p(x) bind(c, name=\"log1p\") result(y)
            import :: c_double
            real(c_double), value :: x
            real(c_double) :: y
        end function log1p
        pure function expm1(x) bind(c, name=\"expm1\") result(y)
            import :: c_double
            real(c_double), value :: x
            real(c_double) :: y
        end function expm1
    end interface

";
