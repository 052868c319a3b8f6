//! C99 with the mathematics of its standard library, and of GSL where that is not enough.

use super::{Target, Words, comment, decimal, head, parts, whole};
use crate::code::accuracy::ELEMENTARY;
use crate::code::program::Program;
use crate::code::tree::{LENGTH, Routine};

pub(super) struct C;

/// Functions of the GNU Scientific Library with their assumed accuracy.
const GSL: [(&str, &str, f64); 4] =
    [("erf", "erf", 2.0), ("gamma", "tgamma", 12.0), ("besselj", "gsl_sf_bessel_Jn", 32.0), ("besseli", "gsl_sf_bessel_In", 32.0)];

const RESERVED: &str = " auto break case char const continue default do double else enum extern float for goto if inline int long register \
restrict return short signed sizeof static struct switch typedef union unsigned void volatile while alignas alignof bool constexpr false \
nullptr static_assert thread_local true typeof typeof_unqual asm fortran near far huge linux unix i386 vax sun mips sparc NAN INFINITY \
HUGE_VAL DOMAIN SING OVERFLOW UNDERFLOW PLOSS TLOSS MATH_ERRNO MATH_ERREXCEPT I complex imaginary class delete explicit export friend \
mutable namespace new operator private protected public template this throw try typeid typename using virtual and or not xor bitand \
bitor compl and_eq or_eq xor_eq not_eq catch min max isnan isinf isfinite isnormal signbit fpclassify isgreater isless isunordered \
isgreaterequal islessequal islessgreater math_errhandling main sqrt exp log log1p expm1 sin cos tan asin acos atan atan2 sinh cosh tanh \
asinh atanh fabs fmax fmin pow floor erf tgamma ";

impl Target for C {
    fn words(&self) -> Words {
        Words {
            comment: "// ",
            when: ("if (", ") {"),
            otherwise: "} else {",
            end_when: "}",
            during: ("while (", ") {"),
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
        match name {
            "nan" => "NAN".to_owned(),
            "inf" => "INFINITY".to_owned(),
            "abs" => format!("fabs({list})"),
            "max" => format!("fmax({list})"),
            "min" => format!("fmin({list})"),
            "besselj" | "besseli" => match (arguments, self.library(name)) {
                ([order, at], Some((written, _))) => format!("{written}((int)({order}), {at})"),
                _ => list,
            },
            _ => match self.library(name) {
                Some((written, _)) => format!("{written}({list})"),
                None if ELEMENTARY.contains(&name) => format!("{name}({list})"),
                None => format!("{}({list})", self.spelled(name)),
            },
        }
    }

    fn spelled(&self, routine: &str) -> String {
        if routine.starts_with("sneddon_") { routine.to_owned() } else { format!("sneddon_{routine}") }
    }

    fn is_reserved(&self, word: &str) -> bool {
        // Names that headers may define as macros begin like this; none of them ends with an underscore.
        let is_macro = |prefix: &&str| word.starts_with(*prefix) && !word.ends_with('_');
        RESERVED.contains(&format!(" {word} ")) || ["FP_", "M_", "gsl_", "HUGE_", "MATH_"].iter().any(is_macro)
    }

    fn library(&self, name: &str) -> Option<(&'static str, f64)> {
        GSL.iter().find(|(own, ..)| *own == name).map(|(_, written, ulps)| (*written, *ulps))
    }

    fn declare(&self, name: &str, value: &str, changes: bool) -> String {
        if changes { format!("double {name} = {value};") } else { format!("const double {name} = {value};") }
    }

    fn array(&self, name: &str) -> String {
        format!("double {name}[{LENGTH}] = {{0.0}};")
    }

    fn table(&self, name: &str, count: usize) -> (String, &'static str, &'static str) {
        (format!("static const double {name}[{count}] = {{"), "};", "")
    }

    fn element(&self, name: &str, index: &str) -> String {
        match whole(index) {
            Some(whole) => format!("{name}[{whole}]"),
            None => format!("{name}[(int)({index})]"),
        }
    }

    fn assign(&self, name: &str, value: &str) -> String {
        format!("{name} = {value};")
    }

    fn give(&self, value: &str) -> Vec<String> {
        vec![format!("return {value};")]
    }

    fn file(&self, program: &Program) -> String {
        let gsl = program.library.iter().any(|own| self.library(own).is_some_and(|(written, _)| written.starts_with("gsl_")));
        let mut lines = head(program);
        lines.push("Outside the domain the result is NAN.".to_owned());
        lines.push(if gsl {
            "Compile with: cc -c FILE.c; link with -lgsl -lgslcblas -lm.".to_owned()
        } else {
            "Compile with: cc -c FILE.c; link with -lm.".to_owned()
        });
        lines.push("The language is C99. In C++, declare the functions as extern \"C\":".to_owned());
        let list = |routine: &Routine| routine.parameters.iter().map(|own| format!("double {own}")).collect::<Vec<_>>().join(", ");
        let public = program.routines.iter().filter(|own| program.is_public(own));
        lines.extend(public.map(|own| format!("double {}({});", self.spelled(&own.name), list(own))));
        let mut text = comment(&lines, self.words().comment);
        text.push_str("#include <math.h>\n");
        if gsl {
            text.push_str("#include <gsl/gsl_sf_bessel.h>\n");
        }
        for routine in &program.routines {
            let (_, body) = parts(routine, self);
            let public = program.is_public(routine);
            let place = if public { "" } else { "static " };
            let unread: Vec<String> =
                routine.parameters.iter().filter(|own| !routine.reads(own)).map(|own| format!("    (void){own};\n")).collect();
            text.push_str(&format!(
                "\n{}{place}double {}({})\n{{\n{}{body}}}\n",
                comment(&routine.comment, self.words().comment),
                self.spelled(&routine.name),
                list(routine),
                unread.concat(),
            ));
        }
        text
    }
}
