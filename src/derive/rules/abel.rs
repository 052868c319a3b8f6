//! ∫ g′(x)/√(x²−r²) dx for the terms of g′ that close, beside terms that stay an integral.

use crate::expr::normal::{self, NormalTerm};
use crate::expr::{Expr, Function, Node, Number, Sign, Symbol, sign};

/// Nodes of the longest g′ that is split.
const LONGEST: usize = 500;

/// What closes of ∫ g′(x)/√(x²−r²) dx from `lower` to `upper`, and the terms of g′ that stay.
pub(crate) struct Split {
    /// The sum of the integrals that close, over r.
    pub(crate) closed: Expr,
    /// What is left of g′, over x.
    pub(crate) rest: Expr,
}

/// A function whose integral over x, from where its root begins to a radius above r, is known.
enum Known<'a> {
    /// x^m for whole m ≥ 0, from r on.
    Power(i64),
    /// x^(2k)/√(x²−b²), from max(b, r) on.
    OverRoot(i64, &'a Expr),
    /// x^(2k+1) exp(κx²), from r on.
    Gaussian(i64, Expr),
}

/// Splits ∫ `slope`/√(x²−r²) dx; `None` where no term of `slope` closes, where the terms that stay are longer than all were together, or
/// where one of them has a special function: what closes beside that belongs to its derivative.
///
/// The limits are max(`lower`, r), or r where there is none, and max(`upper`, r). Roots √(x²−b²) are read for the places b in `kinks`.
/// Powers are those of (3.37) under a power (Popov & Heß 3.20–3.24), x^(2k)/√(x²−b²) leads to incomplete elliptic integrals, and
/// x^(2k+1) exp(κx²) with t² = x² − r² to the error function.
pub(crate) fn split(slope: &Expr, kinks: &[Expr], lower: Option<&Expr>, upper: &Expr) -> Option<Split> {
    if slope.size_up_to(LONGEST) >= LONGEST || !may_close(slope) {
        return None;
    }
    let (mut closed, mut open) = (Vec::new(), Vec::new());
    for term in normal::normal_terms(slope, &Symbol::new("x")).ok()? {
        let known = known(&term, kinks);
        if known.is_empty() {
            open.push(term);
        }
        closed.extend(known);
    }
    complement(&mut closed, &mut open);
    if closed.is_empty() || !open.iter().all(|term| is_elementary(&term.kernel)) {
        return None;
    }
    let ends = |(coefficient, known): &(Expr, Known)| {
        [coefficient * known.up_to(upper), lower.map_or_else(Expr::zero, |lower| -coefficient * known.up_to(lower))]
    };
    let rest = Expr::sum(open.iter().map(|term| term.to_expr(&Symbol::new("x"))));
    let is_shorter = rest.size_up_to(LONGEST) < slope.size_up_to(LONGEST);
    is_shorter.then(|| Split { closed: Expr::sum(closed.iter().flat_map(ends)), rest })
}

/// Writes acos for π/2 − asin where that takes a power of x away.
fn complement(closed: &mut Vec<(Expr, Known)>, open: &mut [NormalTerm]) {
    let variable = Symbol::new("x");
    closed.retain(|(coefficient, known)| {
        let Known::Power(m) = known else { return true };
        let arcsine = |term: &NormalTerm| match term.kernel.node() {
            Node::Function(function, arguments) if function.name() == "asin" && term.exponent == Expr::integer(*m) => {
                arguments.first().cloned()
            }
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
        match self {
            Self::OverRoot(_, b) if *b == end => Expr::zero(),
            Self::OverRoot(k, b) => Expr::call("elliptic_moment", [Expr::integer(*k), (*b).clone(), r.clone(), beyond(end, &r)]),
            Self::Power(m) => Expr::call("pressure_power", [Expr::integer(*m), r.clone(), beyond(end, &r)]),
            Self::Gaussian(k, kappa) => gaussian(*k, kappa, &r, &beyond(end, &r)),
        }
    }
}

/// J_k = ∫_r^e x^(2k+1) exp(κx²)/√(x²−r²) dx, from d(x^(2k) exp(κx²) √(x²−r²)):
/// 2κ J_(k+1) = x^(2k) exp(κx²) √(x²−r²) + (2κr² − 2k − 1) J_k + 2k r² J_(k−1).
fn gaussian(k: i64, kappa: &Expr, r: &Expr, end: &Expr) -> Expr {
    let (decays, two) = (sign(kappa) == Sign::Negative, Expr::integer(2));
    let (name, scale) = if decays { ("erf", (-kappa).sqrt()) } else { ("erfi", kappa.sqrt()) };
    let root = (end.power(2) - r.power(2)).sqrt();
    let exponential = |at: &Expr| Expr::call("exp", [kappa * at.power(2)]);
    let first = Expr::pi().sqrt() / (&two * &scale) * exponential(r) * Expr::call(name, [&scale * &root]);
    let (mut before, mut own) = (Expr::zero(), first);
    for j in 0..k {
        let edge = end.power(2 * j) * exponential(end) * &root;
        let sum = edge + (&two * kappa * r.power(2) - Expr::integer(2 * j + 1)) * &own + Expr::integer(2 * j) * r.power(2) * &before;
        before = std::mem::replace(&mut own, sum / (&two * kappa));
    }
    own
}

/// max(end, r); the contact radius a is above r.
fn beyond(end: &Expr, r: &Expr) -> Expr {
    if *end == Expr::symbol("a") { end.clone() } else { Expr::call("max", [end.clone(), r.clone()]) }
}

/// The term as a sum of coefficients times known functions; empty where it is none.
fn known<'a>(term: &NormalTerm, kinks: &'a [Expr]) -> Vec<(Expr, Known<'a>)> {
    /// Higher powers are long.
    const HIGHEST: i64 = 12;
    let Some(m) = term.exponent.as_integer().filter(|m| (0..=HIGHEST).contains(m)) else { return Vec::new() };
    if term.kernel.is_one() {
        return vec![(term.coefficient.clone(), Known::Power(m))];
    }
    if let (1, Some(kappa)) = (m % 2, exponent_of_square(&term.kernel)) {
        return vec![(term.coefficient.clone(), Known::Gaussian(m / 2, kappa))];
    }
    let (base, exponent) = super::reading::power(&term.kernel);
    let half = |sign: i64| exponent.as_number() == Some(&Number::ratio(sign, 2));
    let (true, Some((b, factor))) = (m % 2 == 0, root(&base, kinks)) else { return Vec::new() };
    let coefficient = &term.coefficient * factor.pow(&exponent);
    match (half(-1), half(1)) {
        (true, _) => vec![(coefficient, Known::OverRoot(m / 2, b))],
        // √Q = Q/√Q
        (_, true) => vec![(coefficient.clone(), Known::OverRoot(m / 2 + 1, b)), (-coefficient * b.power(2), Known::OverRoot(m / 2, b))],
        _ => Vec::new(),
    }
}

/// b and c of c (x² − b²), b one of the places.
fn root<'a>(base: &Expr, kinks: &'a [Expr]) -> Option<(&'a Expr, Expr)> {
    let variable = Symbol::new("x");
    let [constant, linear, factor] = <[Expr; 3]>::try_from(normal::polynomial_coefficients(base, &variable)?).ok()?;
    let is_root = |b: &&Expr| normal::is_proven_zero(&(&constant + &factor * b.power(2)), &variable);
    let b = kinks.iter().find(is_root).filter(|_| linear.is_zero() && sign(&factor) == Sign::Positive)?;
    Some((b, factor))
}

/// κ of exp(κx²), where its sign is known.
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

/// False where the terms that stay would have special functions, or inverse functions of roots, which the recognition form makes longer.
fn may_close(slope: &Expr) -> bool {
    let own = match slope.node() {
        Node::Function(function, arguments) => function.name() == "exp" || is_inverse(function) && !arguments.iter().any(has_root),
        _ => true,
    };
    own && slope.children().into_iter().all(may_close)
}

fn has_root(expr: &Expr) -> bool {
    matches!(expr.node(), Node::Power(_, exponent) if exponent.as_integer().is_none()) || expr.children().into_iter().any(has_root)
}

/// True for logarithms and inverse functions.
fn is_inverse(function: &Function) -> bool {
    matches!(function.name(), "ln" | "asin" | "acos" | "atan" | "atan2" | "asinh" | "acosh" | "atanh" | "elliprc")
}

/// True for roots, logarithms and inverse functions alone.
fn is_elementary(kernel: &Expr) -> bool {
    let own = match kernel.node() {
        Node::Function(function, _) => is_inverse(function),
        Node::Power(_, exponent) => exponent.as_number().is_some(),
        _ => true,
    };
    own && kernel.children().into_iter().all(is_elementary)
}
