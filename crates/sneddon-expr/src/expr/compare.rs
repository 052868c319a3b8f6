//! The order of expressions by content.

use super::{Expr, Node};
use crate::num::work;
use std::cmp::Ordering;

impl PartialEq for Expr {
    fn eq(&self, other: &Self) -> bool {
        self.content_hash() == other.content_hash() && compare::<false>(self, other) == Ordering::Equal
    }
}

impl Eq for Expr {}

impl PartialOrd for Expr {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Expr {
    fn cmp(&self, other: &Self) -> Ordering {
        compare::<true>(self, other)
    }
}

/// Trees of at most this many levels are ordered by content alone.
const SHALLOW: u32 = 32;

/// Kinds in the order of [`Node`], then operands one by one; a shared tree equals itself without a look inside, and deep trees are
/// ordered by their levels first: the factors of nested roots differ in their innermost parts only.
///
/// Comparisons of order count as work; tests of equality do not, because their number in a hash table is random.
/// One function and one frame per level, so that the deepest expression that is read compares on a small stack.
fn compare<const COUNTED: bool>(left: &Expr, right: &Expr) -> Ordering {
    if left.address() == right.address() {
        return Ordering::Equal;
    }
    if COUNTED {
        work::spend(2);
    }
    let levels = [left, right].map(|own| own.levels().max(SHALLOW));
    if levels[0] != levels[1] {
        return levels[0].cmp(&levels[1]);
    }
    let (left, right): (&[Expr], &[Expr]) = match (left.node(), right.node()) {
        (Node::Number(l), Node::Number(r)) => return l.cmp(r),
        (Node::Constant(l), Node::Constant(r)) => return l.cmp(r),
        (Node::Symbol(l), Node::Symbol(r)) => return l.cmp(r),
        (Node::Power(base, exponent), Node::Power(other_base, other_exponent)) => match compare::<COUNTED>(base, other_base) {
            Ordering::Equal => return compare::<COUNTED>(exponent, other_exponent),
            unequal => return unequal,
        },
        (Node::Function(l, inner), Node::Function(r, other_inner)) => match l.cmp(r) {
            Ordering::Equal => (inner, other_inner),
            unequal => return unequal,
        },
        (Node::Product(l), Node::Product(r)) | (Node::Sum(l), Node::Sum(r)) => (l, r),
        (l, r) => return rank(l).cmp(&rank(r)),
    };
    for (l, r) in left.iter().zip(right) {
        match compare::<COUNTED>(l, r) {
            Ordering::Equal => {}
            unequal => return unequal,
        }
    }
    left.len().cmp(&right.len())
}

fn rank(node: &Node) -> u8 {
    match node {
        Node::Number(_) => 0,
        Node::Constant(_) => 1,
        Node::Symbol(_) => 2,
        Node::Power(..) => 3,
        Node::Function(..) => 4,
        Node::Product(_) => 5,
        Node::Sum(_) => 6,
    }
}
