//! Definitions of the special functions in a formula, with the convention of their arguments.

use crate::expr::{Condition, Expr, Formula, Node, Symbol, shown_as_mathematics};
use crate::print::Prose;
use std::collections::BTreeSet;

/// Returns a sentence for every special function without a universal definition.
pub(super) fn of(formulas: &[Formula]) -> Vec<Prose> {
    let mut found = BTreeSet::new();
    for expr in formulas.iter().flat_map(Formula::expressions) {
        in_expression(expr, &mut found);
    }
    found.into_iter().filter_map(|(name, sizes)| definition(name, sizes)).collect()
}

/// Adds the names of the functions in an expression as shown, and how many parameters a hypergeometric function has.
fn in_expression(expr: &Expr, found: &mut BTreeSet<(&'static str, [i64; 2])>) {
    for own in shown_as_mathematics(expr).parts() {
        if let Node::Function(function, arguments) = own.node() {
            // E of two arguments is the incomplete integral.
            let is_incomplete = function.name() == "ellipe" && arguments.len() > 1;
            let size = |place: usize| arguments.get(place).filter(|_| function.name() == HYPERGEOMETRIC).and_then(Expr::as_integer);
            found.insert((if is_incomplete { INCOMPLETE } else { function.name() }, [0, 1].map(|place| size(place).unwrap_or(0))));
        }
    }
}

/// The incomplete elliptic integral of the second kind, which shares the name of the complete one.
const INCOMPLETE: &str = "ellipe of two arguments";

/// The function whose first two arguments are the numbers of its parameters.
const HYPERGEOMETRIC: &str = "hyper";

/// The definition of a function, with its equation in the Digital Library of Mathematical Functions.
fn definition(name: &str, [above, below]: [i64; 2]) -> Option<Prose> {
    let symbols = ["m", "n", "p", "t", "x", "y", "z", "phi", "alpha", "beta", "gamma"].map(Expr::symbol);
    let [m, n, p, t, x, y, z, phi, alpha, beta, gamma] = symbols;
    let (one, two) = (Expr::one(), Expr::integer(2));
    let call = |name: &'static str, arguments: &[&Expr]| Expr::call(name, arguments.iter().map(|own| (*own).clone()));
    let is = |function: Expr, what: &str| Prose::default().formula(function).then(" is ").then(what);
    let as_in = |own: Prose, place: &str| own.then(&format!(" (DLMF {place})"));
    let integral = |own: Prose, factor: &Expr, integrand: Expr, lower: &Expr, upper: &Expr| {
        let integral = Formula::Integral {
            integrand: Box::new(integrand.into()),
            variable: Symbol::new("t"),
            lower: lower.clone(),
            upper: upper.clone(),
        };
        own.then(": ").formula(integral.scaled(factor))
    };
    let elliptic = |function: Expr, kind: &str, integrand: Expr, upper: &Expr| {
        let parameter = Condition::equal(m.clone(), Expr::symbol("k").power(2));
        let own = is(function, &format!("the {kind} kind of parameter ")).condition(parameter);
        integral(own, &one, integrand, &Expr::zero(), upper)
    };
    let root = (&one - &m * call("sin", &[&t]).power(2)).sqrt();
    let (zero, right, square) = (Expr::zero(), Expr::pi() / &two, t.power(2));
    let gauss = &two / Expr::pi().sqrt();
    let quadratic = Expr::pi() * &square / &two;
    Some(match name {
        "ellipk" => as_in(elliptic(call("ellipk", &[&m]), "complete elliptic integral of the first", &one / root, &right), "19.2.8"),
        "ellipe" => as_in(elliptic(call("ellipe", &[&m]), "complete elliptic integral of the second", root, &right), "19.2.8"),
        "ellipf" => as_in(elliptic(call("ellipf", &[&phi, &m]), "incomplete elliptic integral of the first", &one / root, &phi), "19.2.4"),
        INCOMPLETE => as_in(elliptic(call("ellipe", &[&phi, &m]), "incomplete elliptic integral of the second", root, &phi), "19.2.5"),
        "elliprf" => as_in(is(call("elliprf", &[&x, &y, &z]), "Carlson's symmetric elliptic integral of the first kind"), "19.16.1"),
        "elliprd" => as_in(is(call("elliprd", &[&x, &y, &z]), "Carlson's symmetric elliptic integral of the second kind"), "19.16.5"),
        "elliprj" => as_in(is(call("elliprj", &[&x, &y, &z, &p]), "Carlson's symmetric elliptic integral of the third kind"), "19.16.2"),
        "elliprc" => as_in(is(call("elliprc", &[&x, &y]), "Carlson's degenerate elliptic integral"), "19.2.17"),
        "erf" => as_in(integral(is(call("erf", &[&z]), "the error function"), &gauss, call("exp", &[&-&square]), &zero, &z), "7.2.1"),
        "erfi" => integral(is(call("erfi", &[&z]), "the imaginary error function"), &gauss, call("exp", &[&square]), &zero, &z),
        "dawson" => {
            let factor = call("exp", &[&-z.power(2)]);
            as_in(integral(is(call("dawson", &[&z]), "Dawson's integral"), &factor, call("exp", &[&square]), &zero, &z), "7.2.5")
        }
        "fresnelc" => {
            as_in(integral(is(call("fresnelc", &[&z]), "a Fresnel integral"), &one, call("cos", &[&quadratic]), &zero, &z), "7.2.7")
        }
        "fresnels" => {
            as_in(integral(is(call("fresnels", &[&z]), "a Fresnel integral"), &one, call("sin", &[&quadratic]), &zero, &z), "7.2.8")
        }
        "besselj" => as_in(is(call("besselj", &[&n, &z]), "the Bessel function of the first kind"), "10.2.2"),
        "besseli" => as_in(is(call("besseli", &[&n, &z]), "the modified Bessel function of the first kind"), "10.25.2"),
        "struveh" => as_in(is(call("struveh", &[&n, &z]), "the Struve function"), "11.2.1"),
        "struvel" => as_in(is(call("struvel", &[&n, &z]), "the modified Struve function"), "11.2.2"),
        "gamma" => as_in(is(call("gamma", &[&z]), "the Gamma function"), "5.2.1"),
        "digamma" => as_in(is(call("digamma", &[&z]), "the logarithmic derivative of the Gamma function"), "5.2.2"),
        "polygamma" => as_in(is(call("polygamma", &[&n, &z]), "the polygamma function of this order"), "5.15.1"),
        "betainc" => {
            let integrand = t.pow(&(&alpha - &one)) * (&one - &t).pow(&(&beta - &one));
            let own = is(call("betainc", &[&alpha, &beta, &x, &y]), "the incomplete Beta function");
            as_in(integral(own, &one, integrand, &x, &y), "8.17.1")
        }
        "hyp2f1" => as_in(is(call("hyp2f1", &[&alpha, &beta, &gamma, &z]), "Gauss's hypergeometric function"), "15.2.1"),
        "hyp1f1" => as_in(is(call("hyp1f1", &[&alpha, &gamma, &z]), "Kummer's hypergeometric function"), "13.2.2"),
        HYPERGEOMETRIC => {
            let numbered = |letter: &'static str, count: i64| (1..=count).map(move |place| Expr::symbol(&format!("{letter}_{place}")));
            let parameters = numbered("alpha", above).chain(numbered("beta", below));
            let arguments = [above, below].map(Expr::integer).into_iter().chain(parameters).chain([z]);
            as_in(is(Expr::call(HYPERGEOMETRIC, arguments), "the generalized hypergeometric function"), "16.2.1")
        }
        "polylog" => as_in(
            is(call("polylog", &[&two, &z]), "the dilogarithm, the sum of ").formula(z.pow(&n) / n.power(2)).then(" over $n$ from 1"),
            "25.12.1",
        ),
        "clsin" => {
            let term = call("sin", &[&(&n * &z)]) / n.power(2);
            as_in(is(call("clsin", &[&two, &z]), "Clausen's function, the sum of ").formula(term).then(" over $n$ from 1"), "25.12.9")
        }
        "legendre_chi2" => {
            let term = z.pow(&(&two * &n + &one)) / (&two * &n + &one).power(2);
            let own =
                is(call("legendre_chi2", &[&z]), "Legendre's chi function, the sum of ").formula(term).then(" over $n$ from 0, which is ");
            let [plus, minus] = [&z, &-&z].map(|own| call("polylog", &[&two, own]));
            as_in(own.formula((plus - minus) / &two), "25.12.1")
        }
        "inverse_tangent_integral" => {
            let own = is(call("inverse_tangent_integral", &[&z]), "the inverse tangent integral");
            as_in(
                integral(own, &one, call("atan", &[&t]) / &t, &zero, &z).then(", the imaginary part of the dilogarithm of $i$ $z$"),
                "25.12.1",
            )
        }
        _ => return None,
    })
}
