//! How f′ behaves at the ends of a piece: bounded, integrably large, or so large that g jumps there.

use crate::expr::{Bindings, Expr, Node, Sign, Symbol, normal, sign};
use crate::integrate::segment::Segment;

/// The growth of f′ towards an end, in rising order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Growth {
    /// f′ has a limit there.
    Bounded,
    /// f′ is infinite, but g is continuous: a logarithm, or a power of the distance above −1/2.
    Gentle,
    /// f′ is a power of the distance with an exponent of which nothing is known.
    Unproven,
    /// f′ is infinite like the distance to the power −1/2 or worse: g jumps there, or is infinite.
    Steep,
}

/// The largest growth of f′ towards the ends of its piece, the axis left out.
pub fn growth(f_prime: &Expr, segment: &Segment) -> Growth {
    let ends = [Some(&segment.lower), segment.upper.as_ref()].into_iter().flatten().filter(|end| !end.is_zero());
    ends.map(|end| towards(f_prime, &Bindings::one("r", end.clone()))).max().unwrap_or(Growth::Bounded)
}

fn towards(expr: &Expr, place: &Bindings) -> Growth {
    let radius = Symbol::new("r");
    if !expr.contains(&radius) {
        return Growth::Bounded;
    }
    let vanishes = |own: &Expr| own.contains(&radius) && normal::is_proven_zero(&place.apply(own), &radius);
    let largest = |parts: &mut dyn Iterator<Item = &Expr>| parts.map(|part| towards(part, place)).max().unwrap_or(Growth::Bounded);
    match expr.node() {
        Node::Number(_) | Node::Constant(_) | Node::Symbol(_) => Growth::Bounded,
        Node::Sum(parts) | Node::Product(parts) => largest(&mut parts.iter()),
        Node::Power(base, exponent) if vanishes(base) && sign(exponent) != Sign::Positive => {
            match (sign(exponent), sign(&(exponent + Expr::ratio(1, 2)))) {
                (_, Sign::Positive) if exponent.as_number().is_some() => Growth::Gentle,
                (Sign::Unknown, _) | (_, Sign::Unknown) => Growth::Unproven,
                (_, Sign::Positive) => Growth::Gentle,
                _ => Growth::Steep,
            }
        }
        Node::Power(base, exponent) => largest(&mut [base, exponent].into_iter()),
        Node::Function(function, arguments) => {
            let inner = largest(&mut arguments.iter());
            let singular = match (function.name(), arguments.as_slice()) {
                ("ln", [u]) => vanishes(u),
                ("atanh", [u]) => vanishes(&(u - Expr::one())) || vanishes(&(u + Expr::one())),
                _ => false,
            };
            if singular { inner.max(Growth::Gentle) } else { inner }
        }
    }
}
