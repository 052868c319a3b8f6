//! Explicit inversions: a(d) and F(d) where the equation g(a) = d solves in closed form.

mod kernels;

use crate::eval::{BoundedAlgebra, EvalError, constant_value, walk};
use crate::expr::{Bindings, Condition, Expr, Sign, Symbol, sign};
use crate::num::{Bounded, Estimate};
use crate::transform::{ClosedForm, Reading, Solution, Term, above_zero};

/// a(d) and F(d) of a smooth-edged contact, with their conditions.
#[derive(Clone, Debug)]
pub struct Explicit {
    /// The contact radius as a function of d.
    pub contact_radius: Expr,
    /// The force as a function of d and E.
    pub force: Expr,
    /// The kind of the equation g(a) = d, and the method of its solution.
    pub equation: &'static str,
    /// The equations of the source.
    pub reference: Vec<&'static str>,
    /// Conditions on the parameters.
    pub conditions: Vec<Condition>,
}

/// Solves g(a) = d where g is a single power, A a^(2n) + B aⁿ or that of a worn paraboloid, and where f is atan, artanh,
/// 1 − 1/√(1 + r²/b²), 1 − J₀ or I₀ − 1 (up to the first maximum of g); returns `None` otherwise.
///
/// ```
/// use sneddon::{contact::explicit, parse, print, transform::{Profile, derive}};
/// let paraboloid = Profile::new(&parse::profile("r^2/(2*R)").unwrap()).unwrap();
/// let found = explicit(&derive(&paraboloid).unwrap()).unwrap();
/// assert_eq!(print::text_expr(&found.contact_radius), "sqrt(R*d)");
/// ```
pub fn explicit(solution: &Solution) -> Option<Explicit> {
    let mut terms: Vec<(&Term, &crate::transform::Answer)> = Vec::new();
    for solved in solution.terms() {
        let (_, answer) = solved.answer.as_ref()?;
        terms.push((&solved.term, answer));
    }
    // Powers go on beyond the end that another argument of min or max gives the profile.
    let has_end = solution.profile.limits().next().is_some() || !solution.profile.demands.is_empty();
    let found = match terms.as_slice() {
        [(term, _)] if term.segment.is_whole() => {
            let power = if has_end { None } else { single_power(term) };
            power.or_else(|| kernels::single_kernel(term))?
        }
        _ if has_end => return None,
        [(one, _), (two, _)] if one.segment.is_whole() && two.segment.is_whole() => two_powers(one, two)?,
        [(term, _)] => worn_paraboloid(term)?,
        _ => return None,
    };
    found.admissible()
}

/// n and c = C κ_n of g = c xⁿ.
fn power(term: &Term) -> Option<(Expr, Expr)> {
    let part = term.single()?;
    if !part.kernel.is_one() {
        return None;
    }
    let n = &part.exponent + Expr::one();
    let kappa = crate::transform::rules::kappa(&n);
    Some((n.clone(), &part.coefficient / n * kappa))
}

/// c aⁿ = d: a = (d/c)^(1/n), F = 2E n/(n+1) c^(−1/n) d^((n+1)/n).
fn single_power(term: &Term) -> Option<Explicit> {
    let (n, c) = power(term)?;
    let (d, modulus, one) = (Expr::symbol("d"), Expr::symbol("E"), Expr::one());
    let force = Expr::integer(2) * modulus * &n / (&n + &one) * c.pow(&-n.recip()) * d.pow(&((&n + &one) / &n));
    Some(Explicit {
        contact_radius: (d / &c).pow(&n.recip()),
        force,
        equation: "One power of the contact radius: its root",
        reference: vec!["Popov & Heß (3.24)", "Popov & Heß (3.45)–(3.46)"],
        conditions: positive(&c)?,
    })
}

/// A a^(2n) + B aⁿ = d: aⁿ = 2d/(B + √(B² + 4Ad)), which does not cancel.
fn two_powers(one: &Term, two: &Term) -> Option<Explicit> {
    let ((n, b), (m, a)) = (power(one)?, power(two)?);
    let double = |n: &Expr| Expr::integer(2) * n;
    let (n, b, a) = if m == double(&n) {
        (n, b, a)
    } else if n == double(&m) {
        (m, a, b)
    } else {
        return None;
    };
    let (d, modulus) = (Expr::symbol("d"), Expr::symbol("E"));
    let two = Expr::integer(2);
    let root = (b.power(2) + Expr::integer(4) * &a * &d).sqrt();
    let contact_radius = (&two * &d / (&b + &root)).pow(&n.recip());
    let force = if n.is_one() {
        // q = √(1 + 4Ad/B²), q − 1 = 4Ad/(B²(1 + q)): F = E B³ (q−1)² (2q+1)/(12A²).
        let step = Expr::integer(4) * &a * &d / b.power(2);
        let q = (Expr::one() + &step).sqrt();
        let above = step / (Expr::one() + &q);
        modulus * b.power(3) * above.power(2) * (&two * q + Expr::one()) / (Expr::integer(12) * a.power(2))
    } else {
        let radius = &contact_radius;
        let next = &n + Expr::one();
        let twice = double(&n) + Expr::one();
        two * modulus * (&n * &b / &next * radius.pow(&next) + double(&n) * &a / &twice * radius.pow(&twice))
    };
    let mut conditions = positive(&a)?;
    conditions.extend(positive(&b)?);
    Some(Explicit {
        contact_radius,
        force,
        equation: "Quadratic in a power of the contact radius; of its two roots the positive one, in the form that does not cancel",
        reference: vec!["Popov & Heß (3.48)–(3.52)"],
        conditions,
    })
}

/// g = c x√(x²−b²): with S = √(b⁴ + 4d²/c²), a = √((b² + S)/2), F = (2√2/3) E d (2b² + S)/√(b² + S), which equals (3.35).
fn worn_paraboloid(term: &Term) -> Option<Explicit> {
    let [zero, c] = term.polynomial()?.try_into().ok()?;
    if !zero.is_zero() || term.segment.upper.is_some() || term.segment.lower.is_zero() {
        return None;
    }
    let (d, modulus) = (Expr::symbol("d"), Expr::symbol("E"));
    let (two, square) = (Expr::integer(2), term.segment.lower.power(2));
    let s = (square.power(2) + Expr::integer(4) * d.power(2) / c.power(2)).sqrt();
    let force = Expr::ratio(2, 3) * two.sqrt() * modulus * d * (&two * &square + &s) / (&square + &s).sqrt();
    Some(Explicit {
        contact_radius: ((square + s) / two).sqrt(),
        force,
        equation: "Squared, it is quadratic in the square of the contact radius; of its two roots the positive one",
        reference: vec!["Popov & Heß (3.32), (3.35)"],
        conditions: positive(&c)?,
    })
}

/// Nothing to demand for a positive expression, a condition for an unknown sign, `None` for anything else.
fn positive(expr: &Expr) -> Option<Vec<Condition>> {
    match sign(expr) {
        Sign::Positive => Some(Vec::new()),
        Sign::Unknown => above_zero(expr).map(|own| vec![own]),
        Sign::Zero | Sign::Negative => None,
    }
}

impl Explicit {
    /// a(d) as a number with its error; every parameter must have been replaced.
    ///
    /// # Errors
    /// [`EvalError::Unbound`] for a parameter that is left.
    pub fn contact_radius_at(&self, depth: f64) -> Result<Reading, EvalError> {
        let estimate = self.value(&self.contact_radius, Bounded::exact(depth), 1.0)?;
        Ok(Reading { estimate, method: "exact" })
    }

    /// One of the two expressions as a number, its parameters being set.
    pub(super) fn value(&self, expr: &Expr, depth: Bounded, effective_modulus: f64) -> Result<Estimate, EvalError> {
        if depth.error == 0.0 {
            let form = ClosedForm::new(expr, &[Symbol::new("d"), Symbol::new("E")])?;
            return Ok(Estimate::from_bounded(form.value(&[depth.value, effective_modulus]), 0));
        }
        let mut value_of = |symbol: &Symbol| match symbol.name() {
            "d" => Some(depth),
            "E" => Some(Bounded::exact(effective_modulus)),
            _ => None,
        };
        Ok(Estimate::from_bounded(walk(expr, &mut BoundedAlgebra, &mut value_of)?, 0))
    }

    /// The same with parameters replaced; `None` if these break a condition.
    pub(super) fn substitute(&self, bindings: &Bindings) -> Option<Self> {
        let own = Self {
            contact_radius: bindings.apply(&self.contact_radius),
            force: bindings.apply(&self.force),
            equation: self.equation,
            reference: self.reference.clone(),
            conditions: self.conditions.iter().map(|own| own.substitute(bindings)).collect(),
        };
        own.admissible()
    }

    /// Drops conditions that numbers decide; `None` if one fails.
    fn admissible(mut self) -> Option<Self> {
        let mut left = Vec::new();
        for condition in self.conditions {
            // A limit of d stays: it decides nothing about the parameters.
            if condition.left.is_zero() && condition.right.symbols().is_empty() {
                let value = constant_value(&condition.right, &Bindings::default()).ok()?;
                if value.value.is_nan() || value.value <= value.error {
                    return None;
                }
            } else {
                left.push(condition);
            }
        }
        self.conditions = left;
        Some(self)
    }
}
