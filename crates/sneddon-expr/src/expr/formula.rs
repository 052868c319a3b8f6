//! Formulas: plain expressions, piecewise expressions, integrals, and sums of these.

use super::{Bindings, Expr, Sign, Symbol, derivative::derivative, error::ExprError, sign};

/// A formula: a closed expression, a case distinction, an integral, or a sum or multiple of formulas.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Formula {
    /// A closed expression.
    Closed(Expr),
    /// A sum of formulas, read in order.
    Sum(Vec<Formula>),
    /// An expression times a formula.
    Scaled(Expr, Box<Formula>),
    /// Values up to rising breakpoints of one variable: `pieces[i].0` holds below `pieces[i].1`, `last` beyond all.
    Piecewise {
        /// The variable that is compared with the breakpoints.
        variable: Symbol,
        /// Values with the breakpoint at which each ends.
        pieces: Vec<(Formula, Expr)>,
        /// The value beyond the last breakpoint.
        last: Box<Formula>,
    },
    /// ∫ from `lower` to `upper` of `integrand` over `variable`.
    Integral {
        /// The integrand.
        integrand: Box<Formula>,
        /// The bound variable.
        variable: Symbol,
        /// Lower limit.
        lower: Expr,
        /// Upper limit.
        upper: Expr,
    },
}

/// How the sides of a condition compare.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Relation {
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
    /// `=`
    Equal,
}

/// A condition that travels with an answer, e.g. r < R.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Condition {
    /// Left side.
    pub left: Expr,
    /// Comparison.
    pub relation: Relation,
    /// Right side.
    pub right: Expr,
}

impl Condition {
    /// left < right.
    pub fn less(left: Expr, right: Expr) -> Self {
        Self { left, relation: Relation::Less, right }
    }

    /// left = right.
    pub fn equal(left: Expr, right: Expr) -> Self {
        Self { left, relation: Relation::Equal, right }
    }

    /// The condition with symbols replaced.
    pub fn substitute(&self, bindings: &Bindings) -> Self {
        Self { left: bindings.apply(&self.left), relation: self.relation, right: bindings.apply(&self.right) }
    }

    /// True or false where both sides are rational numbers; `None` where a symbol is left.
    pub fn decided(&self) -> Option<bool> {
        let (left, right) = (self.left.as_number()?, self.right.as_number()?);
        Some(match self.relation {
            Relation::Less => left < right,
            Relation::LessOrEqual => left <= right,
            Relation::Equal => left == right,
        })
    }
}

impl From<Expr> for Formula {
    fn from(expr: Expr) -> Self {
        Self::Closed(expr)
    }
}

impl Formula {
    /// 0.
    pub fn zero() -> Self {
        Self::Closed(Expr::zero())
    }

    /// True for the closed 0, and for pieces that are all 0.
    pub fn is_zero(&self) -> bool {
        match self {
            Self::Closed(expr) => expr.is_zero(),
            Self::Piecewise { pieces, last, .. } => last.is_zero() && pieces.iter().all(|(value, _)| value.is_zero()),
            _ => false,
        }
    }

    /// The closed expression, where the formula is one.
    pub fn as_closed(&self) -> Option<&Expr> {
        match self {
            Self::Closed(expr) => Some(expr),
            _ => None,
        }
    }

    /// The sum: closed parts are added up, piecewise parts with the same breakpoints joined, the rest kept in order.
    pub fn sum(parts: impl IntoIterator<Item = Formula>) -> Self {
        let mut closed = Vec::new();
        let mut rest: Vec<Formula> = Vec::new();
        let mut pending: Vec<Formula> = parts.into_iter().collect();
        pending.reverse();
        while let Some(part) = pending.pop() {
            match part {
                Self::Closed(expr) => closed.push(expr),
                Self::Sum(inner) => pending.extend(inner.into_iter().rev()),
                nothing if nothing.is_zero() => {}
                other => {
                    if let Some(joined) = rest.iter_mut().find(|own| own.same_breakpoints(&other)) {
                        let left = std::mem::replace(joined, Self::zero());
                        *joined = left.join(other);
                    } else {
                        rest.push(other);
                    }
                }
            }
        }
        let closed = Expr::sum(closed);
        if !closed.is_zero() {
            rest.insert(0, Self::Closed(closed));
        }
        match rest.len() {
            0 => Self::zero(),
            1 => rest.swap_remove(0),
            _ => Self::Sum(rest),
        }
    }

    /// `factor` times the formula; pieces and sums take the factor inside, integrals keep it in front.
    pub fn scaled(self, factor: &Expr) -> Self {
        if factor.is_one() {
            return self;
        }
        if factor.is_zero() {
            return Self::zero();
        }
        match self {
            Self::Closed(expr) => Self::Closed(factor * expr),
            Self::Sum(parts) => Self::Sum(parts.into_iter().map(|part| part.scaled(factor)).collect()),
            Self::Scaled(own, inner) => inner.scaled(&(own * factor)),
            Self::Piecewise { variable, pieces, last } => Self::Piecewise {
                variable,
                pieces: pieces.into_iter().map(|(value, end)| (value.scaled(factor), end)).collect(),
                last: Box::new(last.scaled(factor)),
            },
            integral @ Self::Integral { .. } => Self::Scaled(factor.clone(), Box::new(integral)),
        }
    }

    /// Applies `change` to every expression outside bound variables' reach, breakpoints and limits included.
    pub fn map(&self, change: &impl Fn(&Expr) -> Expr) -> Self {
        match self {
            Self::Closed(expr) => Self::Closed(change(expr)),
            Self::Sum(parts) => Self::sum(parts.iter().map(|part| part.map(change))),
            Self::Scaled(factor, inner) => inner.map(change).scaled(&change(factor)),
            Self::Piecewise { variable, pieces, last } => Self::Piecewise {
                variable: variable.clone(),
                pieces: pieces.iter().map(|(value, end)| (value.map(change), change(end))).collect(),
                last: Box::new(last.map(change)),
            },
            Self::Integral { integrand, variable, lower, upper } => Self::Integral {
                integrand: Box::new(integrand.map(change)),
                variable: variable.clone(),
                lower: change(lower),
                upper: change(upper),
            },
        }
    }

    /// The formula with the constant factors of closed integrands in front of their integrals.
    pub fn with_constants_in_front(self) -> Self {
        match self {
            Self::Closed(_) => self,
            Self::Sum(parts) => Self::sum(parts.into_iter().map(Self::with_constants_in_front)),
            Self::Scaled(factor, inner) => inner.with_constants_in_front().scaled(&factor),
            Self::Piecewise { variable, pieces, last } => Self::Piecewise {
                variable,
                pieces: pieces.into_iter().map(|(value, end)| (value.with_constants_in_front(), end)).collect(),
                last: Box::new(last.with_constants_in_front()),
            },
            Self::Integral { integrand, variable, lower, upper } => {
                let Self::Closed(expr) = integrand.as_ref() else { return Self::Integral { integrand, variable, lower, upper } };
                let (inside, outside): (Vec<Expr>, Vec<Expr>) = expr.factors().into_iter().partition(|own| own.contains(&variable));
                let integrand = Box::new(Self::Closed(Expr::product(inside)));
                Self::Integral { integrand, variable, lower, upper }.scaled(&Expr::product(outside))
            }
        }
    }

    /// The formula without pieces that are known to lie on one side of the variable, which a breakpoint may contain after a
    /// substitution, as in a < a/2.
    pub fn without_decided_pieces(self) -> Self {
        match self {
            Self::Sum(parts) => Self::sum(parts.into_iter().map(Self::without_decided_pieces)),
            Self::Scaled(factor, inner) => inner.without_decided_pieces().scaled(&factor),
            Self::Piecewise { variable, pieces, mut last } => {
                let mut left = Vec::new();
                for (value, end) in pieces {
                    match sign(&(&end - Expr::from(variable.clone()))) {
                        Sign::Negative | Sign::Zero => {}
                        Sign::Positive => {
                            *last = value;
                            break;
                        }
                        Sign::Unknown => left.push((value, end)),
                    }
                }
                if left.is_empty() { *last } else { Self::Piecewise { variable, pieces: left, last } }
            }
            Self::Closed(_) | Self::Integral { .. } => self,
        }
    }

    /// The integrals of the formula, each as its integrand and its variable; not those within an integrand.
    pub fn integrals(&self) -> Vec<(&Self, &Symbol)> {
        match self {
            Self::Closed(_) => Vec::new(),
            Self::Sum(parts) => parts.iter().flat_map(Self::integrals).collect(),
            Self::Scaled(_, inner) => inner.integrals(),
            Self::Piecewise { pieces, last, .. } => {
                pieces.iter().map(|own| &own.0).chain([last.as_ref()]).flat_map(Self::integrals).collect()
            }
            Self::Integral { integrand, variable, .. } => vec![(integrand.as_ref(), variable)],
        }
    }

    /// Every expression in the formula: closed parts, factors, breakpoints and limits.
    pub fn expressions(&self) -> Vec<&Expr> {
        match self {
            Self::Closed(expr) => vec![expr],
            Self::Sum(parts) => parts.iter().flat_map(Self::expressions).collect(),
            Self::Scaled(factor, inner) => inner.expressions().into_iter().chain([factor]).collect(),
            Self::Piecewise { pieces, last, .. } => {
                let before = pieces.iter().flat_map(|(value, end)| value.expressions().into_iter().chain([end]));
                before.chain(last.expressions()).collect()
            }
            Self::Integral { integrand, lower, upper, .. } => integrand.expressions().into_iter().chain([lower, upper]).collect(),
        }
    }

    /// Every symbol that occurs free.
    pub fn symbols(&self) -> std::collections::BTreeSet<Symbol> {
        match self {
            Self::Closed(expr) => expr.symbols(),
            Self::Sum(parts) => parts.iter().flat_map(Self::symbols).collect(),
            Self::Scaled(factor, inner) => factor.symbols().into_iter().chain(inner.symbols()).collect(),
            Self::Piecewise { variable, pieces, last } => {
                let mut found = last.symbols();
                found.insert(variable.clone());
                for (value, end) in pieces {
                    found.extend(value.symbols());
                    found.extend(end.symbols());
                }
                found
            }
            Self::Integral { integrand, variable, lower, upper } => {
                let mut found = integrand.symbols();
                found.remove(variable);
                found.extend(lower.symbols());
                found.extend(upper.symbols());
                found
            }
        }
    }

    /// True if an integral is left anywhere.
    pub fn has_integral(&self) -> bool {
        match self {
            Self::Closed(_) => false,
            Self::Integral { .. } => true,
            Self::Sum(parts) => parts.iter().any(Self::has_integral),
            Self::Scaled(_, inner) => inner.has_integral(),
            Self::Piecewise { pieces, last, .. } => last.has_integral() || pieces.iter().any(|(value, _)| value.has_integral()),
        }
    }

    /// Replaces free symbols; a piecewise whose variable is bound to a number, or whose breakpoints leave no choice, is kept as
    /// pieces.
    pub fn substitute(&self, bindings: &Bindings) -> Self {
        self.map(&|expr| bindings.apply(expr))
    }

    /// The derivative with respect to `symbol`, piece by piece; jumps and kinks are the caller's to judge.
    ///
    /// # Errors
    /// As [`derivative`]; integrals are not differentiated.
    pub fn derivative(&self, symbol: &Symbol) -> Result<Self, ExprError> {
        match self {
            Self::Closed(expr) => Ok(Self::Closed(derivative(expr, symbol)?)),
            Self::Sum(parts) => Ok(Self::sum(parts.iter().map(|part| part.derivative(symbol)).collect::<Result<Vec<_>, _>>()?)),
            Self::Scaled(factor, inner) => {
                let first = inner.clone().scaled(&derivative(factor, symbol)?);
                Ok(Self::sum([first, inner.derivative(symbol)?.scaled(factor)]))
            }
            Self::Piecewise { variable, pieces, last } => Ok(Self::Piecewise {
                variable: variable.clone(),
                pieces: pieces
                    .iter()
                    .map(|(value, end)| Ok((value.derivative(symbol)?, end.clone())))
                    .collect::<Result<Vec<_>, ExprError>>()?,
                last: Box::new(last.derivative(symbol)?),
            }),
            Self::Integral { .. } => Err(ExprError::NoDerivative { function: "integral", argument: 1 }),
        }
    }

    fn same_breakpoints(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Piecewise { variable: v, pieces: p, .. }, Self::Piecewise { variable: w, pieces: q, .. }) => {
                v == w && p.len() == q.len() && p.iter().zip(q).all(|((_, b), (_, c))| b == c)
            }
            _ => false,
        }
    }

    fn join(self, other: Self) -> Self {
        match (self, other) {
            (Self::Piecewise { variable, pieces, last }, Self::Piecewise { pieces: others, last: other_last, .. }) => Self::Piecewise {
                variable,
                pieces: pieces.into_iter().zip(others).map(|((u, end), (v, _))| (Self::sum([u, v]), end)).collect(),
                last: Box::new(Self::sum([*last, *other_last])),
            },
            (left, right) => Self::Sum(vec![left, right]),
        }
    }
}
