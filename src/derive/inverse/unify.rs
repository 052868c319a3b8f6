//! Unification of a rule's kernel with a term's: which values of the rule's parameters make one the other.
//!
//! It only proposes values; whoever uses them compares the two recognition forms afterwards, so that a wrong proposal does no
//! harm.

use crate::expr::{Bindings, Expr, Node, Sign, Symbol, normal, sign};

/// Values of the unknown parameters with which the pattern's kernel may equal the target's up to a constant factor.
pub(super) fn unified(pattern: (&Expr, &Expr), target: (&Expr, &Expr), unknown: &[Symbol], known: &Bindings) -> Option<Bindings> {
    let mut own = Unifier { variable: Symbol::new("r"), unknown, bound: known.clone(), equations: Vec::new() };
    own.equations.push((pattern.0.clone(), target.0.clone()));
    (own.kernel(pattern.1, target.1) && own.settle()).then_some(own.bound)
}

struct Unifier<'a> {
    variable: Symbol,
    unknown: &'a [Symbol],
    bound: Bindings,
    /// Expressions free of the variable that must be equal.
    equations: Vec<(Expr, Expr)>,
}

impl Unifier<'_> {
    /// Products of factors, paired in any order.
    fn kernel(&mut self, pattern: &Expr, target: &Expr) -> bool {
        let (patterns, targets) = (pattern.factors(), target.factors());
        patterns.len() == targets.len() && self.pair(&patterns, &targets)
    }

    fn pair(&mut self, patterns: &[Expr], targets: &[Expr]) -> bool {
        let Some((first, rest)) = patterns.split_first() else { return true };
        for index in 0..targets.len() {
            let mut others = targets.to_vec();
            let target = others.remove(index);
            let (bound, equations) = (self.bound.clone(), self.equations.clone());
            if self.factor(first, &target) && self.pair(rest, &others) {
                return true;
            }
            (self.bound, self.equations) = (bound, equations);
        }
        false
    }

    /// A function with its arguments, or a power of a polynomial up to a constant factor.
    fn factor(&mut self, pattern: &Expr, target: &Expr) -> bool {
        match (pattern.node(), target.node()) {
            (Node::Function(f, these), Node::Function(g, those)) => {
                f == g && these.len() == those.len() && these.iter().zip(those).all(|(p, t)| self.argument(p, t))
            }
            (Node::Power(base, n), Node::Power(other, m)) => {
                self.equations.push((n.clone(), m.clone()));
                let functions = matches!((base.node(), other.node()), (Node::Function(..), Node::Function(..)));
                if functions { self.factor(base, other) } else { self.base(base, other) }
            }
            (Node::Sum(_), Node::Sum(_)) => self.base(pattern, target),
            (Node::Power(base, n), Node::Sum(_)) => {
                self.equations.push((n.clone(), Expr::one()));
                self.base(base, target)
            }
            _ => pattern == target,
        }
    }

    /// Polynomials in the variable that are proportional.
    fn base(&mut self, pattern: &Expr, target: &Expr) -> bool {
        let (Some(these), Some(those)) =
            (normal::polynomial_coefficients(pattern, &self.variable), normal::polynomial_coefficients(target, &self.variable))
        else {
            return false;
        };
        if these.len() != those.len() || these.iter().zip(&those).any(|(p, t)| p.is_zero() != t.is_zero()) {
            return false;
        }
        let fixed = these.iter().zip(&those).find(|(p, _)| !p.is_zero() && self.missing(p).is_empty());
        let scale = fixed.map_or_else(Expr::one, |(p, t)| t / p);
        self.equations.extend(these.iter().zip(&those).filter(|(p, _)| !p.is_zero()).map(|(p, t)| (p * &scale, t.clone())));
        true
    }

    /// Arguments: term by term in their recognition forms.
    fn argument(&mut self, pattern: &Expr, target: &Expr) -> bool {
        if !pattern.contains(&self.variable) {
            self.equations.push((pattern.clone(), target.clone()));
            return !target.contains(&self.variable);
        }
        let (Ok(these), Ok(those)) = (normal::normal_terms(pattern, &self.variable), normal::normal_terms(target, &self.variable)) else {
            return false;
        };
        these.len() == those.len()
            && these.iter().zip(&those).all(|(p, t)| {
                self.equations.push((p.exponent.clone(), t.exponent.clone()));
                self.equations.push((p.coefficient.clone(), t.coefficient.clone()));
                self.kernel(&p.kernel, &t.kernel)
            })
    }

    /// Unknowns of an expression that have no value yet.
    fn missing(&self, expr: &Expr) -> Vec<Symbol> {
        expr.symbols().into_iter().filter(|s| self.unknown.contains(s) && self.bound.get(s).is_none()).collect()
    }

    /// Solves the equations one by one; false if one cannot hold or is left.
    fn settle(&mut self) -> bool {
        // Each round settles at least one equation, or none is left that can be settled.
        for _ in 0..=self.equations.len() {
            let mut open = Vec::new();
            for (pattern, target) in std::mem::take(&mut self.equations) {
                match self.missing(&pattern).as_slice() {
                    [] => {
                        let difference = self.known(&pattern) - &target;
                        if !normal::is_proven_zero(&difference, &self.variable) {
                            return false;
                        }
                    }
                    [only] => {
                        let Some(value) = self.solved(&pattern, target, only) else { return false };
                        self.bound.insert(only.clone(), value);
                    }
                    _ => open.push((pattern, target)),
                }
            }
            if open.is_empty() {
                return true;
            }
            self.equations = open;
        }
        false
    }

    /// The pattern with the parameters that have values; unknowns without value keep their own names.
    fn known(&self, pattern: &Expr) -> Expr {
        self.bound.apply(pattern)
    }

    /// The value of an unknown that occurs once, under sums, products and powers.
    fn solved(&self, pattern: &Expr, target: Expr, unknown: &Symbol) -> Option<Expr> {
        let split = |list: &[Expr]| -> Option<(Expr, Vec<Expr>)> {
            let (with, without): (Vec<&Expr>, Vec<&Expr>) = list.iter().partition(|e| e.contains(unknown));
            let [only] = with.as_slice() else { return None };
            Some(((*only).clone(), without.into_iter().map(|e| self.known(e)).collect()))
        };
        match pattern.node() {
            Node::Symbol(_) => Some(target),
            Node::Sum(terms) => {
                let (own, others) = split(terms)?;
                self.solved(&own, target - Expr::sum(others), unknown)
            }
            Node::Product(factors) => {
                let (own, others) = split(factors)?;
                self.solved(&own, target / Expr::product(others), unknown)
            }
            Node::Power(base, exponent) if !exponent.contains(unknown) => {
                // Parameters are positive, and so are their powers.
                let real = sign(&target) != Sign::Negative;
                if real { self.solved(base, target.pow(&self.known(exponent).recip()), unknown) } else { None }
            }
            _ => None,
        }
    }
}
