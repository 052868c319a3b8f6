//! Error functions and Dawson's integral of r/w times odd powers of r.

use super::gaussian;
use super::laurent::{Combination, Laurent, Member, member};
use super::moments::{self, Moments};
use super::reading;
use crate::derive::rule::{Answer, Parameter, Rule};
use crate::derive::term::Term;
use crate::expr::Expr;

const PARAMETERS: &[Parameter] = &[Parameter { name: "h", lowest: 0.1, highest: 2.0 }, Parameter { name: "w", lowest: 1.0, highest: 3.0 }];

pub(super) static ERROR_FUNCTION: Rule = Rule {
    id: "error-function",
    title: "Error function, real or imaginary, times an odd power",
    pattern: "h*(r^2*erf(r/w)+w*r/sqrt(pi)*exp(-r^2/w^2)-w^2/2*erf(r/w))",
    equivalent: "sqrt(pi)*h*x^3/w*exp(-x^2/(2*w^2))*(besseli(0,x^2/(2*w^2))+besseli(1,x^2/(2*w^2)))",
    force: "2/3*sqrt(pi)*E*h*a^2/w*exp(-a^2/(2*w^2))*(2*a^2*besseli(0,a^2/(2*w^2))+(2*a^2+w^2)*besseli(1,a^2/(2*w^2)))",
    pressure: None,
    parameters: PARAMETERS,
    guard: "f′ = c r^m erf(r/w) or c r^m erfi(r/w), odd m ≥ 1",
    reference: &["general formula, Popov & Heß (3.27)", "DLMF 7.2.1 and 10.32.2"],
    specializes: None,
    apply: error_function,
};

pub(super) static DAWSON: Rule = Rule {
    id: "dawson",
    title: "Dawson's integral times an odd power",
    pattern: "h*(r/w-dawson(r/w))",
    equivalent: "pi/2*h*x/w*(1-exp(-x^2/w^2))",
    force: "pi/2*E*h*(w+a^2/w-(w+2*a^2/w)*exp(-a^2/w^2))",
    pressure: None,
    parameters: PARAMETERS,
    guard: "f′ = c r^m dawson(r/w), also as exp(−r²/w²) erfi(r/w), or c r^m exp(r²/w²) erf(r/w), odd m ≥ 1",
    reference: &["general formula, Popov & Heß (3.27)", "DLMF 7.5.1"],
    specializes: None,
    apply: dawson,
};

/// κ of erf(κr) or another odd function of κr, and the sign of its argument.
fn odd_argument(kernel: &Expr, name: &str) -> Option<(Expr, Expr)> {
    let [argument] = reading::call(kernel, name)? else { return None };
    let (scale, negative) = moments::wavenumber(argument)?;
    Some((scale, Expr::integer(if negative { -1 } else { 1 })))
}

/// f′ = c·r^m·erf(κr) or c·r^m·erfi(κr).
fn error_function(term: &Term) -> Option<Answer> {
    let (part, m) = moments::whole(term).filter(|(_, m)| m % 2 == 1)?;
    let read = |name| odd_argument(&part.kernel, name);
    let ((scale, sign), decay) = read("erf").map(|own| (own, true)).or_else(|| read("erfi").map(|own| (own, false)))?;
    let moment = |m: i64| error_moment(m, decay);
    let members = |_: i64, y: &Expr| over_root(gaussian::even_members(y, decay));
    let shown = |_: i64, y: &Expr| over_root(gaussian::even_shown(y, decay));
    Some(moments::answer(
        &(&part.coefficient * sign),
        m,
        &Moments { scale, moment: &moment, members: &members, shown: &shown, apart: false },
    ))
}

/// m M_m = (m − 1) y² M_(m−2) + y² N_(m−1) − N_(m+1) with the moments N of the Gaussian (2/√π) e^(∓u²).
fn error_moment(m: i64, decay: bool) -> Combination {
    let mut moment = Combination::default();
    for order in (1..=m).step_by(2) {
        let gaussian = |m: i64| gaussian::even_moment(m, decay);
        let edge = gaussian(order - 1).scaled(1, order, 2).minus(&gaussian(order + 1).scaled(1, order, 0));
        moment = moment.scaled(order - 1, order, 2).plus(&edge);
    }
    moment
}

/// The functions of the Gaussian times 2/√π.
fn over_root(members: Vec<Member>) -> Vec<Member> {
    let factor = Expr::integer(2) / Expr::pi().sqrt();
    members.into_iter().map(|own| member(own.factor * &factor, own.function)).collect()
}

/// f′ = c·r^m·D(κr) with D(y) = e^(−y²) ∫₀^y e^(t²) dt, or the same with e^(y²) ∫₀^y e^(−t²) dt.
fn dawson(term: &Term) -> Option<Answer> {
    let (part, m) = moments::whole(term).filter(|(_, m)| m % 2 == 1)?;
    let (scale, coefficient, decay) = if let Some((scale, sign)) = odd_argument(&part.kernel, "dawson") {
        (scale, &part.coefficient * sign, true)
    } else {
        let (gaussian, odd) = reading::exponential_pair(&part.kernel)?;
        let (scale, decay) = gaussian::scale(gaussian)?;
        let (own, sign) = odd_argument(odd, if decay { "erfi" } else { "erf" })?;
        if own != scale {
            return None;
        }
        (scale, Expr::integer(2) / Expr::pi().sqrt() * &part.coefficient * sign, decay)
    };
    let moment = |m: i64| dawson_moment(m, if decay { 1 } else { -1 });
    let members = |_: i64, y: &Expr| {
        let square = y.power(2);
        let exponential = Expr::call("exp", [if decay { -square } else { square }]);
        [Expr::one(), exponential].map(|function| member(Expr::pi() / Expr::integer(2), function)).into()
    };
    Some(moments::answer(&coefficient, m, &Moments { scale, moment: &moment, members: &members, shown: &members, apart: true }))
}

/// M_1 = ±(π/4)(1 − e^(∓y²)) and, from D′ = 1 ∓ 2yD,
/// 2 M_(m+2) = (2y² ± m) M_m ∓ (m − 1) y² M_(m−2) ∓ (π/2) y^(m+1) (m−2)!!/((m−1)!! (m+1)).
fn dawson_moment(m: i64, sign: i64) -> Combination {
    let single = Combination::single;
    let (mut before, mut own) = (Combination::default(), single(0, sign, 2, 0).plus(&single(1, -sign, 2, 0)));
    let mut wallis = Laurent::term(1, 1, 0);
    for order in (1..m).step_by(2) {
        if order > 1 {
            wallis = wallis.times(&Laurent::term(order - 2, order - 1, 0));
        }
        let outer = own.times(&Laurent::term(1, 1, 2).plus(&Laurent::term(sign * order, 2, 0)));
        let edge = single(0, sign, 2 * (order + 1), order + 1).times(&wallis);
        let next = outer.minus(&before.scaled(sign * (order - 1), 2, 2)).minus(&edge);
        before = std::mem::replace(&mut own, next);
    }
    own
}
