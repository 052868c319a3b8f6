//! The program's own grammar; what is written here reads back as an equal expression.

use crate::expr::function::Setting;
use crate::expr::{Constant, Relation};
use crate::print::math::{Call, Math};
use crate::print::signed_terms;

/// How tightly an operator binds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Relation,
    Sum,
    Product,
    Power,
    Unit,
}

/// Writes a formula in the grammar.
pub(in crate::print) fn write(math: &Math) -> String {
    match math {
        Math::Number { mantissa, exponent: None } => mantissa.clone(),
        Math::Number { mantissa, exponent: Some(exponent) } => format!("{mantissa}e{exponent}"),
        Math::Name(name) => name.clone(),
        Math::Constant(Constant::Pi) => "pi".to_owned(),
        Math::Constant(Constant::Euler) => "e".to_owned(),
        Math::Constant(Constant::Cut) => "?".to_owned(),
        Math::Sum(terms) => signed_terms(terms, "-", |term| at_least(term, Binding::Product)),
        Math::Negative(inner) => format!("-{}", at_least(inner, Binding::Product)),
        Math::Product(factors) => factors.iter().map(|factor| at_least(factor, Binding::Product)).collect::<Vec<_>>().join("*"),
        Math::Fraction(upper, lower) | Math::Slash(upper, lower) => {
            format!("{}/{}", at_least(upper, Binding::Product), at_least(lower, Binding::Power))
        }
        Math::Root(2, inner) => format!("sqrt({})", write(inner)),
        Math::Root(degree, inner) => format!("{}^(1/{degree})", at_least(inner, Binding::Unit)),
        Math::Power(base, exponent) => format!("{}^{}", at_least(base, Binding::Unit), at_least(exponent, Binding::Unit)),
        Math::Parentheses(inner) => format!("({})", write(inner)),
        Math::Call(call) => {
            let call_text = write_call(call);
            call.power.as_ref().map_or(call_text.clone(), |power| format!("{call_text}^{}", at_least(power, Binding::Unit)))
        }
        Math::Cases { variable, pieces, last } => {
            let pieces: String = pieces.iter().map(|(value, end)| format!("{}, {variable} < {}, ", write(value), write(end))).collect();
            format!("piecewise({pieces}{})", write(last))
        }
        Math::Integral { integrand, variable, lower, upper } => {
            // Parentheses around the whole integrand are redundant here.
            let integrand = match integrand.as_deref() {
                None => "1".to_owned(),
                Some(Math::Parentheses(inner)) => write(inner),
                Some(other) => write(other),
            };
            format!("integral({integrand}, {variable}, {}, {})", write(lower), write(upper))
        }
        Math::Relation(left, relation, right) => format!("{} {} {}", write(left), sign(*relation), write(right)),
    }
}

fn sign(relation: Relation) -> &'static str {
    match relation {
        Relation::Less => "<",
        Relation::LessOrEqual => "<=",
        Relation::Equal => "=",
    }
}

/// The text, in parentheses where it binds less tightly.
fn at_least(math: &Math, least: Binding) -> String {
    let text = write(math);
    if binding(math) < least { format!("({text})") } else { text }
}

fn binding(math: &Math) -> Binding {
    match math {
        Math::Relation(..) => Binding::Relation,
        Math::Sum(_) | Math::Negative(_) => Binding::Sum,
        Math::Product(_) | Math::Fraction(..) | Math::Slash(..) => Binding::Product,
        Math::Power(..) | Math::Root(3.., _) => Binding::Power,
        Math::Call(call) if call.power.is_some() => Binding::Power,
        _ => Binding::Unit,
    }
}

fn write_call(call: &Call) -> String {
    let list = |group: &Vec<Math>| group.iter().map(write).collect::<Vec<_>>().join(", ");
    let counted = call.function.row().typeset.setting == Setting::CountedGroups;
    let arguments = call.index.iter().map(|index| write(index)).chain(
        call.groups.iter().enumerate().map(|(place, group)| if counted && place < 2 { format!("[{}]", list(group)) } else { list(group) }),
    );
    format!("{}({})", call.function.name(), arguments.collect::<Vec<_>>().join(", "))
}
