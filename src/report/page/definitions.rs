//! Definitions of the special functions in a formula, with the convention of their arguments.

use crate::expr::{Expr, Formula, Node, shown_as_mathematics};
use crate::print::Prose;
use std::collections::BTreeSet;

/// Returns a sentence for every special function without a universal definition.
pub(super) fn of(formulas: &[Formula]) -> Vec<Prose> {
    let mut found = BTreeSet::new();
    for expr in formulas.iter().flat_map(Formula::expressions) {
        in_expression(expr, &mut found);
    }
    let occur = |names: &[&str]| names.iter().any(|name| found.contains(name));
    DEFINITIONS.iter().filter(|(names, _)| occur(names)).map(|(_, sentence)| Prose::words(sentence)).collect()
}

/// Adds the names of the functions in an expression as shown.
fn in_expression(expr: &Expr, found: &mut BTreeSet<&'static str>) {
    /// Larger expressions are not searched.
    const SIZE: usize = 10_000;
    fn every(expr: &Expr, found: &mut BTreeSet<&'static str>) {
        if let Node::Function(function, arguments) = expr.node() {
            // E of two arguments is the incomplete integral.
            let is_incomplete = function.name() == "ellipe" && arguments.len() > 1;
            found.insert(if is_incomplete { INCOMPLETE } else { function.name() });
        }
        expr.children().into_iter().for_each(|child| every(child, found));
    }
    let shown = shown_as_mathematics(expr);
    if shown.size_up_to(SIZE) < SIZE {
        every(&shown, found);
    }
}

/// The incomplete elliptic integral of the second kind, which shares the name of the complete one.
const INCOMPLETE: &str = "ellipe of two arguments";

/// Functions, and the sentence that defines them.
const DEFINITIONS: [(&[&str], &str); 18] = [
    (&["ellipk"], "K(m) is the complete elliptic integral of the first kind of parameter m = k²: ∫ dt/√(1 - m sin² t), t from 0 to π/2"),
    (&["ellipe"], "E(m) is the complete elliptic integral of the second kind of parameter m = k²: ∫ √(1 - m sin² t) dt, t from 0 to π/2"),
    (
        &["ellipf"],
        "F(φ | m) is the incomplete elliptic integral of the first kind of parameter m = k²: ∫ dt/√(1 - m sin² t), t from 0 to φ",
    ),
    (
        &[INCOMPLETE],
        "E(φ | m) is the incomplete elliptic integral of the second kind of parameter m = k²: ∫ √(1 - m sin² t) dt, t from 0 to φ",
    ),
    (
        &["elliprf", "elliprd", "elliprj", "elliprc"],
        "R_F, R_D, R_J and R_C are Carlson's symmetric elliptic integrals, as in the Digital Library of Mathematical Functions, 19.16",
    ),
    (&["dawson"], "D(z) is Dawson's integral: exp(-z²) times the integral of exp(t²), t from 0 to z"),
    (&["erf"], "erf(z) is 2/√π times the integral of exp(-t²), t from 0 to z"),
    (&["erfi"], "erfi(z) is 2/√π times the integral of exp(t²), t from 0 to z"),
    (&["struveh"], "H_n is the Struve function, in bold to distinguish it from the Hankel function"),
    (&["struvel"], "L_n is the modified Struve function"),
    (&["besselj"], "J_n is the Bessel function of the first kind"),
    (&["besseli"], "I_n is the modified Bessel function of the first kind"),
    (&["hyp2f1"], "2F1(a, b; c; z) is Gauss's hypergeometric function"),
    (&["hyp1f1"], "1F1(a; b; z) is Kummer's hypergeometric function"),
    (&["polylog"], "Li_2(z) is the dilogarithm: the sum of zⁿ/n², n from 1"),
    (&["clsin"], "Cl_2(z) is Clausen's function: the sum of sin(n z)/n², n from 1"),
    (&["fresnelc", "fresnels"], "C(z) and S(z) are the Fresnel integrals of cos(π t²/2) and sin(π t²/2), t from 0 to z"),
    (
        &["digamma", "polygamma"],
        "ψ is the logarithmic derivative of the Gamma function, and ψ with an order in parentheses its derivatives",
    ),
];
