//! ∫ g′(x)/√(x²−r²) dx for the closed terms of g′; the other terms remain an integral.

use crate::derive::engine::expanded_or_same;
use crate::expr::normal::{self, NormalTerm};
use crate::expr::{Expr, Function, Node, Number, Sign, Symbol, derivative, shown, sign};

/// Maximum number of nodes of a g′ that is split.
const LONGEST: usize = 500;

/// ∫ g′(x)/√(x²−r²) dx from max(b, r) to a for a g that begins at b, if all of it closes.
pub(super) fn beyond_kink(g: &Expr, b: &Expr) -> Option<Expr> {
    let g_prime = derivative(&shown(g), &Symbol::new("x")).ok()?;
    let found = split(&g_prime, std::slice::from_ref(b), Some(b), &Expr::symbol("a"))?;
    found.rest.is_zero().then_some(found.closed)
}

/// The closed part of ∫ g′(x)/√(x²−r²) dx from `lower` to `upper`, and the remaining terms of g′.
pub(crate) struct Split {
    /// The sum of the integrals that close, over r.
    pub(crate) closed: Expr,
    /// The remaining part of g′, over x.
    pub(crate) rest: Expr,
}

/// A function whose integral over x, from where its root begins to a radius above r, is known.
enum Known<'a> {
    /// x^m, from r on.
    Power(Expr),
    /// x^m ln x for odd whole m, from r on.
    Logarithm(i64),
    /// x exp(κx²), from r on.
    Gaussian(Expr),
    /// x^(2k)/√(x²−b²), from max(b, r) on.
    OverRoot(i64, &'a Expr),
    /// x arcosh(x/b), from max(b, r) on.
    Arcosh(&'a Expr),
    /// x/(x²+q)^k for q of either sign, from r on.
    Pole(Expr, i64),
    /// Σ c (x²+q)^n/√(x²−b²) over pairs of n = −2, −1 or 0 and c, from max(b, r) on.
    PoleOverRoot(&'a Expr, Expr, Vec<(i64, Expr)>),
}

/// Splits ∫ `g_prime`/√(x²−r²) dx into a closed part and a remaining integral.
///
/// Returns `None` if no term of `g_prime` has a closed integral, if the remaining terms are longer than `g_prime`, or if one of them
/// contains a special function. Its derivative contains powers that cancel with it, so they are kept in one integral.
///
/// The limits are max(`lower`, r), or r where there is none, and max(`upper`, r). Roots √(x²−b²) are read for the places b in
/// `kinks`. Powers are those of (3.37) under a power (Popov & Heß 3.20–3.24), x^(2k)/√(x²−b²) leads to incomplete elliptic
/// integrals, and x exp(κx²) with t² = x² − r² to the error function.
pub(crate) fn split(g_prime: &Expr, kinks: &[Expr], lower: Option<&Expr>, upper: &Expr) -> Option<Split> {
    if g_prime.size_up_to(LONGEST) >= LONGEST || !may_close(g_prime) {
        return None;
    }
    let (mut closed, mut open) = (Vec::new(), Vec::new());
    // Beside R_C(x², b²), poles at x = b cancel.
    let is_removable = g_prime.parts().any(|own| matches!(own.node(), Node::Function(function, _) if function.name() == "elliprc"));
    for term in normal::normal_terms(g_prime, &Symbol::new("x")).ok()? {
        let mut known = known(&term, kinks);
        if is_removable && known.iter().any(|(_, own)| matches!(own, Known::Pole(q, _) if sign(q) == Sign::Negative)) {
            known.clear();
        }
        // A contact beyond a piece that ends may reach beyond the pole.
        let is_below = |own: &Known| matches!(own, Known::PoleOverRoot(_, q, _) if sign(q) == Sign::Negative);
        if *upper != Expr::symbol("a") && known.iter().any(|(_, own)| is_below(own)) {
            known.clear();
        }
        if known.is_empty() {
            open.push(term);
        }
        closed.extend(known);
    }
    complement(&mut closed, &mut open);
    let (with_poles, closed): (Vec<_>, Vec<_>) = closed.into_iter().partition(|(_, own)| matches!(own, Known::PoleOverRoot(..)));
    if closed.is_empty() && with_poles.is_empty() || !open.iter().all(|term| is_elementary(&term.kernel)) {
        return None;
    }
    let ends = |(coefficient, known): &(Expr, Known)| {
        [coefficient * known.up_to(upper), lower.map_or_else(Expr::zero, |lower| -coefficient * known.up_to(lower))]
    };
    let rest = Expr::sum(open.iter().map(|term| term.to_expr(&Symbol::new("x"))));
    let is_shorter = rest.size_up_to(LONGEST) < g_prime.size_up_to(LONGEST);
    is_shorter.then(|| {
        let poles = poles_over_roots(&with_poles, upper) - lower.map_or_else(Expr::zero, |lower| poles_over_roots(&with_poles, lower));
        Split { closed: Expr::sum(closed.iter().flat_map(ends)) + poles, rest }
    })
}

/// ∫ Σ c (x²+q)^n/√(x²−b²)/√(x²−r²) dx up to max(`end`, r), by the integral J with n = −1.
///
/// With B = q + b², C = q + r² and the root Q = √((x²−b²)(x²−r²)), the derivative of xQ/(x²+q) takes n = −2 to the others:
/// 2qBC I_(−2) = xQ/(x²+q) − E_1 − q E_0 + (BC + qB + qC) J.
fn poles_over_roots(list: &[(Expr, Known<'_>)], end: &Expr) -> Expr {
    let r = Expr::symbol("r");
    let top = beyond(end, &r);
    let mut rest: Vec<_> = list.iter().collect();
    let mut total = Expr::zero();
    while let Some((factor, Known::PoleOverRoot(b, q, _))) = rest.first().copied() {
        let is_own = |own: &&(Expr, Known<'_>)| matches!(&own.1, Known::PoleOverRoot(other, pole, _) if other == b && pole == q);
        let (own, others): (Vec<_>, Vec<_>) = rest.into_iter().partition(is_own);
        rest = others;
        if *b == end {
            continue;
        }
        // In units of the first coefficient.
        let of_order = |n: i64| {
            let parts = own.iter().map(|(coefficient, known)| match known {
                Known::PoleOverRoot(.., list) => {
                    coefficient / factor * Expr::sum(list.iter().filter(|(k, _)| *k == n).map(|(_, own)| own.clone()))
                }
                _ => Expr::zero(),
            });
            expanded_or_same(&Expr::sum(parts), "r")
        };
        let moment = |k: i64| Expr::call("elliptic_moment", [Expr::integer(k), (*b).clone(), r.clone(), top.clone()]);
        let (beside_b, beside_r) = (q + b.power(2), q + r.power(2));
        let share = of_order(-2) / (Expr::integer(2) * q * &beside_b * &beside_r);
        // What J has besides qB of the share does not depend on r, and often cancels.
        let constant = of_order(-1) + &share * &beside_r * (&beside_b + q);
        let constant = if normal::is_proven_zero(&constant, &Symbol::new("r")) { Expr::zero() } else { constant };
        let edge = &top * (top.power(2) - b.power(2)).sqrt() * (top.power(2) - r.power(2)).sqrt() / (top.power(2) + q);
        let (sign, w) = match sign(q) {
            Sign::Negative => (-1, (-q).sqrt()),
            _ => (1, q.sqrt()),
        };
        let third = Expr::call("elliptic_pole", [Expr::integer(sign), w, (*b).clone(), r.clone(), top.clone()]);
        let by_parts = edge - moment(1) - q * moment(0) + q * &beside_b * &third;
        total = total + factor * share * by_parts + factor * (of_order(0) * moment(0) + constant * third);
    }
    total
}

/// Replaces asin u by π/2 − acos u if this cancels a power of x.
fn complement(closed: &mut Vec<(Expr, Known)>, open: &mut [NormalTerm]) {
    let variable = Symbol::new("x");
    closed.retain(|(coefficient, known)| {
        let Known::Power(m) = known else { return true };
        let arcsine = |term: &NormalTerm| match term.kernel.node() {
            Node::Function(function, arguments) if function.name() == "asin" && term.exponent == *m => arguments.first().cloned(),
            _ => None,
        };
        let sum = Expr::sum(open.iter().filter(|term| arcsine(term).is_some()).map(|term| term.coefficient.clone()));
        let is_complement = !sum.is_zero() && normal::is_proven_zero(&(coefficient + Expr::pi() / Expr::integer(2) * sum), &variable);
        if is_complement {
            for term in open.iter_mut() {
                if let Some(argument) = arcsine(term) {
                    (term.coefficient, term.kernel) = (-&term.coefficient, Expr::call("acos", [argument]));
                }
            }
        }
        !is_complement
    });
}

impl Known<'_> {
    /// The integral up to max(`end`, r).
    fn up_to(&self, end: &Expr) -> Expr {
        let r = Expr::symbol("r");
        let top = beyond(end, &r);
        let root = (top.power(2) - r.power(2)).sqrt();
        let elliptic = |k: i64, b: &Expr| Expr::call("elliptic_moment", [Expr::integer(k), b.clone(), r.clone(), top.clone()]);
        match self {
            Self::OverRoot(_, b) | Self::Arcosh(b) if *b == end => Expr::zero(),
            Self::OverRoot(k, b) => elliptic(*k, b),
            // Integration by parts leaves ∫ √(x²−r²)/√(x²−b²) dx; the boundary term is 0 at max(b, r).
            Self::Arcosh(b) => root * Expr::call("acosh", [&top / *b]) - elliptic(1, b) + r.power(2) * elliptic(0, b),
            Self::Power(m) => Expr::call("pressure_power", [m.clone(), r.clone(), top]),
            // All of them together, in `poles_over_roots`.
            Self::PoleOverRoot(..) => Expr::zero(),
            Self::Logarithm(m) => logarithm(*m, &r, &top, &root),
            Self::Gaussian(kappa) => {
                let (name, scale) = if sign(kappa) == Sign::Negative { ("erf", (-kappa).sqrt()) } else { ("erfi", kappa.sqrt()) };
                let exponential = Expr::call("exp", [kappa * r.power(2)]);
                Expr::pi().sqrt() / (Expr::integer(2) * &scale) * exponential * Expr::call(name, [scale * root])
            }
            Self::Pole(q, k) => {
                // t² = x² − r² gives J_k = ∫ dt/(t² + c²)^k with c² = r² + q, and 2k c² J_(k+1) = w/(w² + c²)^k + (2k − 1) J_k.
                let (square, sum) = (r.power(2) + q, top.power(2) + q);
                let (name, length, sign) = match sign(q) {
                    Sign::Negative => ("atanh", (-&square).sqrt(), Expr::integer(-1)),
                    _ => ("atan", square.sqrt(), Expr::one()),
                };
                let first = sign * Expr::call(name, [&root / &length]) / length;
                let next = |own: Expr, k: i64| (&root / sum.power(k) + Expr::integer(2 * k - 1) * own) / (Expr::integer(2 * k) * &square);
                (1..*k).fold(first, next)
            }
        }
    }
}

/// I_m = ∫_r^e x^m ln x/√(x²−r²) dx for odd m, with w = √(e²−r²) and S_m the integral without ln:
/// m I_m = (m−1) r² I_(m−2) + e^(m−1) w ln e − S_m + r² S_(m−2), where S_(−1) = acos(r/e)/r.
fn logarithm(m: i64, r: &Expr, end: &Expr, root: &Expr) -> Expr {
    let plain = |m: i64| match m {
        -1 => Expr::call("acos", [r / end]) / r,
        _ => Expr::call("pressure_power", [Expr::integer(m), r.clone(), end.clone()]),
    };
    (1..=m).step_by(2).fold(Expr::zero(), |before, m| {
        let edge = end.power(m - 1) * root * Expr::call("ln", [end.clone()]);
        (Expr::integer(m - 1) * r.power(2) * before + edge - plain(m) + r.power(2) * plain(m - 2)) / Expr::integer(m)
    })
}

/// max(end, r); the contact radius a is above r.
fn beyond(end: &Expr, r: &Expr) -> Expr {
    if *end == Expr::symbol("a") { end.clone() } else { Expr::call("max", [end.clone(), r.clone()]) }
}

/// The term as a sum of coefficients times known functions; empty if it is not such a sum.
fn known<'a>(term: &NormalTerm, kinks: &'a [Expr]) -> Vec<(Expr, Known<'a>)> {
    /// Higher powers are long.
    const HIGHEST: i64 = 12;
    let coefficient = &term.coefficient;
    let only = |known| vec![(coefficient.clone(), known)];
    let whole = term.exponent.as_integer();
    if term.kernel.is_one() {
        let is_plain = !term.exponent.contains(&Symbol::new("x")) && whole.is_none_or(|m| (0..=HIGHEST).contains(&m));
        return if is_plain { only(Known::Power(term.exponent.clone())) } else { Vec::new() };
    }
    let Some(m) = whole.filter(|m| (0..=HIGHEST).contains(m)) else { return Vec::new() };
    if m % 2 == 1 {
        let arcosh = || arcosh(&term.kernel, kinks).filter(|_| m == 1).map(Known::Arcosh);
        let gaussian = || exponent_of_square(&term.kernel).filter(|_| m == 1).map(Known::Gaussian);
        let logarithm = || (term.kernel == Expr::call("ln", [Expr::symbol("x")])).then_some(Known::Logarithm(m));
        if let Some(found) = arcosh().or_else(gaussian).or_else(logarithm) {
            return only(found);
        }
        return pole(m, term).unwrap_or_default();
    }
    if let Some(found) = pole_over_root(m, term, kinks) {
        return found;
    }
    let (base, exponent) = super::reading::power(&term.kernel);
    let is_half = |sign: i64| exponent.as_number() == Some(&Number::ratio(sign, 2));
    if !is_half(1) && !is_half(-1) {
        return Vec::new();
    }
    let Some((b, factor)) = root(&base, kinks) else { return Vec::new() };
    let coefficient = coefficient * factor.pow(&exponent);
    if is_half(-1) {
        return vec![(coefficient, Known::OverRoot(m / 2, b))];
    }
    // √Q = Q/√Q
    vec![(coefficient.clone(), Known::OverRoot(m / 2 + 1, b)), (-coefficient * b.power(2), Known::OverRoot(m / 2, b))]
}

/// x^m/(α+βx²)^k times √(x²−b²) or its inverse, for even m and k = 1 or 2, by powers of x² + q; `None` if one is above 0.
fn pole_over_root<'a>(m: i64, term: &NormalTerm, kinks: &'a [Expr]) -> Option<Vec<(Expr, Known<'a>)>> {
    let (mut pole, mut over, mut coefficient) = (None, None, term.coefficient.clone());
    for factor in term.kernel.factors() {
        let (base, exponent) = super::reading::power(&factor);
        if let Some(k) = exponent.as_integer() {
            let (q, scale) = quadratic(&base)?;
            coefficient = coefficient * scale.power(k);
            pole = Some((q, -k)).filter(|(_, k)| pole.is_none() && (1..=2).contains(k));
            pole.as_ref()?;
        } else {
            let (b, scale) = root(&base, kinks)?;
            let half = [1, -1].into_iter().find(|sign| exponent.as_number() == Some(&Number::ratio(*sign, 2)))?;
            coefficient = coefficient * scale.pow(&exponent);
            over = Some((b, (half + 1) / 2)).filter(|_| over.is_none());
            over?;
        }
    }
    let ((q, k), (b, roots)) = (pole?, over?);
    let beside = &q + b.power(2);
    // (D − q)^(m/2) (D − B)^roots/D^k, D = x² + q.
    let mut list = vec![Expr::one()];
    let by_linear = |list: Vec<Expr>, from: &Expr| {
        let mut next: Vec<Expr> = list.iter().map(|own| -(own * from)).chain([Expr::zero()]).collect();
        next.iter_mut().skip(1).zip(&list).for_each(|(slot, own)| *slot = &*slot + own);
        next
    };
    for _ in 0..m / 2 {
        list = by_linear(list, &q);
    }
    for _ in 0..roots {
        list = by_linear(list, &beside);
    }
    let orders = (0_i64..).map(|n| n - k);
    let found: Vec<_> = list.into_iter().zip(orders).filter(|(c, _)| !c.is_zero()).collect();
    // The highest order would be an elliptic moment of a higher kind.
    let is_low = found.iter().all(|(_, n)| *n <= 0);
    is_low.then(|| vec![(coefficient, Known::PoleOverRoot(b, q, found.into_iter().map(|(c, n)| (n, c)).collect()))])
}

/// Returns q of known sign and c of c (x² + q).
fn quadratic(base: &Expr) -> Option<(Expr, Expr)> {
    let [constant, linear, factor] = <[Expr; 3]>::try_from(normal::polynomial_coefficients(base, &Symbol::new("x"))?).ok()?;
    let q = constant / &factor;
    (linear.is_zero() && matches!(sign(&q), Sign::Positive | Sign::Negative)).then_some((q, factor))
}

/// x^m/(α+βx²)^k for odd m as poles and powers.
fn pole<'a>(m: i64, term: &NormalTerm) -> Option<Vec<(Expr, Known<'a>)>> {
    /// Higher orders are long.
    const HIGHEST: i64 = 4;
    let (base, exponent) = super::reading::power(&term.kernel);
    let k = -exponent.as_integer().filter(|k| (-HIGHEST..=-1).contains(k))?;
    let (q, factor) = quadratic(&base)?;
    let mut found = Vec::new();
    reduced(m, k, &(&term.coefficient * factor.power(-k)), &q, &mut found);
    Some(found)
}

/// Adds c x^m/(x²+q)^k, by x² = (x²+q) − q.
fn reduced(m: i64, k: i64, c: &Expr, q: &Expr, found: &mut Vec<(Expr, Known<'_>)>) {
    match (m, k) {
        (_, 0) => found.push((c.clone(), Known::Power(Expr::integer(m)))),
        (1, _) => found.push((c.clone(), Known::Pole(q.clone(), k))),
        _ => {
            reduced(m - 2, k - 1, c, q, found);
            reduced(m - 2, k, &-(c * q), q, found);
        }
    }
}

/// Returns b of arcosh(x/b) if b is one of `kinks`.
fn arcosh<'a>(kernel: &Expr, kinks: &'a [Expr]) -> Option<&'a Expr> {
    kinks.iter().find(|b| *kernel == Expr::call("acosh", [Expr::symbol("x") / *b]))
}

/// Returns b and c of c (x² − b²) if b is one of `kinks`.
fn root<'a>(base: &Expr, kinks: &'a [Expr]) -> Option<(&'a Expr, Expr)> {
    let variable = Symbol::new("x");
    let [constant, linear, factor] = <[Expr; 3]>::try_from(normal::polynomial_coefficients(base, &variable)?).ok()?;
    let is_root = |b: &&Expr| normal::is_proven_zero(&(&constant + &factor * b.power(2)), &variable);
    let b = kinks.iter().find(is_root).filter(|_| linear.is_zero() && sign(&factor) == Sign::Positive)?;
    Some((b, factor))
}

/// Returns κ of exp(κx²) if its sign is known.
fn exponent_of_square(kernel: &Expr) -> Option<Expr> {
    let variable = Symbol::new("x");
    let exponent = match kernel.node() {
        Node::Power(base, exponent) if *base == Expr::euler() => exponent,
        Node::Function(function, arguments) if function.name() == "exp" => arguments.first()?,
        _ => return None,
    };
    let [constant, linear, kappa] = <[Expr; 3]>::try_from(normal::polynomial_coefficients(exponent, &variable)?).ok()?;
    (constant.is_zero() && linear.is_zero() && matches!(sign(&kappa), Sign::Positive | Sign::Negative)).then_some(kappa)
}

/// Returns false if `g_prime` contains special functions, or inverse functions with roots in their arguments.
///
/// The recognition form of such functions is expensive to compute and longer than `g_prime`.
fn may_close(g_prime: &Expr) -> bool {
    g_prime.parts().filter(|own| own.contains(&Symbol::new("x"))).all(|own| match own.node() {
        Node::Function(function, arguments) => {
            function.name() == "exp" || is_logarithm_or_inverse(function) && !arguments.iter().any(has_root)
        }
        _ => true,
    })
}

fn has_root(expr: &Expr) -> bool {
    expr.parts().any(|own| matches!(own.node(), Node::Power(_, exponent) if exponent.as_integer().is_none()))
}

fn is_logarithm_or_inverse(function: &Function) -> bool {
    matches!(function.name(), "ln" | "asin" | "acos" | "atan" | "atan2" | "asinh" | "acosh" | "atanh" | "elliprc")
}

/// Returns true if `kernel` consists of powers, roots, logarithms and inverse functions of x.
fn is_elementary(kernel: &Expr) -> bool {
    kernel.parts().filter(|own| own.contains(&Symbol::new("x"))).all(|own| match own.node() {
        Node::Function(function, _) => is_logarithm_or_inverse(function),
        Node::Power(_, exponent) => exponent.as_number().is_some(),
        _ => true,
    })
}
