//! The leading terms of an expression at r → 0, with exact coefficients: r^s (A₀ + A₁ r + …), A₀ ≠ 0.
//!
//! Arithmetic on truncated power series decides what substitution cannot: limits such as sin(k r)/(k r), and whether the
//! slopes of several terms cancel at the axis.

use super::function::has_value;
use super::{Bindings, Expr, Node, Number, Sign, Symbol, derivative, normal, sign};

/// The leading power of r of an expression at the axis, and its coefficient.
#[derive(Clone, Debug, PartialEq)]
pub struct LeadingTerm {
    /// The coefficient, which is not zero for parameters in general position.
    pub coefficient: Expr,
    /// The power of r.
    pub exponent: Number,
}

/// Coefficients that are computed at first, and at most.
const LENGTHS: [usize; 2] = [6, 14];
/// Larger expressions are not expanded.
const LARGEST: usize = 400;

/// The leading term of an expression at r → 0; `None` if it has none that this arithmetic finds, as for ln r.
///
/// ```
/// use sneddon_expr::expr::{Expr, Number, leading_term};
/// let (k, r) = (Expr::symbol("k"), Expr::symbol("r"));
/// let term = leading_term(&(Expr::call("sin", [&k * &r]) / &r)).unwrap();
/// assert_eq!((term.coefficient, term.exponent), (k, Number::integer(0)));
/// ```
pub fn leading_term(expr: &Expr) -> Option<LeadingTerm> {
    if expr.size_up_to(LARGEST) >= LARGEST {
        return None;
    }
    LENGTHS.iter().find_map(|length| {
        let own = Expansion { length: *length, radius: Symbol::new("r") }.series(expr)?.stripped()?;
        Some(LeadingTerm { coefficient: own.coefficients.first()?.clone(), exponent: own.shift })
    })
}

/// How many coefficients are computed, and of which symbol the powers are.
struct Expansion {
    length: usize,
    radius: Symbol,
}

/// r^shift (A₀ + A₁ r + …) as far as the coefficients are known.
struct Series {
    shift: Number,
    coefficients: Vec<Expr>,
}

impl Expansion {
    fn series(&self, expr: &Expr) -> Option<Series> {
        if !expr.contains(&self.radius) {
            return Some(self.constant(expr.clone()));
        }
        match expr.node() {
            Node::Symbol(_) => Some(Series { shift: Number::integer(1), ..self.constant(Expr::one()) }),
            Node::Sum(terms) => {
                let first = self.constant(Expr::zero());
                terms.iter().try_fold(first, |total, term| self.sum(total, self.series(term)?))
            }
            Node::Product(factors) => {
                let first = self.constant(Expr::one());
                factors.iter().try_fold(first, |total, factor| Some(self.product(&total, &self.series(factor)?)))
            }
            Node::Power(base, exponent) if !exponent.contains(&self.radius) => self.power(self.series(base)?, exponent),
            Node::Function(function, arguments) => match arguments.as_slice() {
                [argument] => self.composed(|inner| Expr::function(*function, vec![inner]), self.series(argument)?),
                [order, argument] => self.in_powers(&FirstPower::new(function.name(), order)?, self.series(argument)?),
                _ => None,
            },
            Node::Power(..) | Node::Number(_) | Node::Constant(_) => None,
        }
    }

    fn constant(&self, value: Expr) -> Series {
        let mut coefficients = vec![Expr::zero(); self.length];
        if let Some(first) = coefficients.first_mut() {
            *first = value;
        }
        Series { shift: Number::integer(0), coefficients }
    }

    /// The sum as far as both are known; between powers that differ by a fraction only what lies below the higher one counts.
    fn sum(&self, u: Series, v: Series) -> Option<Series> {
        if u.vanishes() {
            return Some(v);
        }
        if v.vanishes() {
            return Some(u);
        }
        let (low, high) = if u.shift <= v.shift { (u, v) } else { (v, u) };
        let gap = &high.shift - &low.shift;
        let Some(places) = gap.to_i64().and_then(|places| usize::try_from(places).ok()) else {
            let known = gap.to_f64().ceil() as usize;
            let coefficients: Vec<Expr> = low.coefficients.into_iter().take(known).collect();
            // Where the lower one has no term below the higher one, nothing is known of how they mix.
            return coefficients.iter().any(|own| !own.is_zero()).then_some(Series { shift: low.shift, coefficients });
        };
        let known = low.coefficients.len().min(places + high.coefficients.len());
        let other = |n: usize| n.checked_sub(places).and_then(|n| high.coefficients.get(n)).cloned().unwrap_or_else(Expr::zero);
        let coefficients = low.coefficients.iter().take(known).enumerate().map(|(n, own)| own + other(n)).collect();
        Some(Series { shift: low.shift, coefficients })
    }

    fn product(&self, u: &Series, v: &Series) -> Series {
        let known = u.coefficients.len().min(v.coefficients.len());
        let term = |n: usize| {
            let pairs = u.coefficients.iter().take(n + 1).zip(v.coefficients.iter().take(n + 1).rev());
            Expr::sum(pairs.map(|(a, b)| a * b))
        };
        Series { shift: &u.shift + &v.shift, coefficients: (0..known).map(term).collect() }
    }

    /// A₀^c r^(s c) (1 + u₁ r + …)^c by the recurrence n b_n = Σ (k c − (n − k)) u_k b_{n−k}.
    fn power(&self, base: Series, exponent: &Expr) -> Option<Series> {
        let base = base.stripped()?;
        let shift = match exponent.as_number() {
            Some(own) => &base.shift * own,
            None if base.shift.is_zero() => Number::integer(0),
            None => return None,
        };
        let first = base.coefficients.first()?.clone();
        if exponent.as_integer().is_none() && sign(&first) == Sign::Negative {
            return None;
        }
        let relative: Vec<Expr> = base.coefficients.iter().map(|own| own / &first).collect();
        let mut powers = vec![Expr::one()];
        for n in 1..relative.len() {
            let terms = relative.iter().enumerate().take(n + 1).skip(1).filter(|(_, own)| !own.is_zero()).filter_map(|(k, own)| {
                let whole = |n: usize| i64::try_from(n).map(Expr::integer).ok();
                Some((whole(k)? * exponent - whole(n - k)?) * own * powers.get(n - k)?)
            });
            powers.push(Expr::sum(terms) * Expr::ratio(1, i64::try_from(n).ok()?));
        }
        let scale = first.pow(exponent);
        Some(Series { shift, coefficients: powers.into_iter().map(|own| own * &scale).collect() })
    }

    /// A function with known powers of a series that vanishes at the axis.
    fn in_powers(&self, first: &FirstPower, argument: Series) -> Option<Series> {
        let u = argument.stripped()?;
        if u.shift <= Number::integer(0) {
            return None;
        }
        let square = self.product(&u, &u);
        let (mut coefficient, mut exponent) = (first.coefficient.clone(), first.exponent);
        let mut power = (0..exponent).fold(self.constant(Expr::one()), |power, _| self.product(&power, &u));
        let mut total = self.constant(Expr::zero());
        for _ in 0..self.length {
            let coefficients = power.coefficients.iter().map(|own| own * &coefficient).collect();
            total = self.sum(total, Series { shift: power.shift.clone(), coefficients })?;
            exponent += 2;
            coefficient = coefficient * Expr::ratio(first.sign, exponent * exponent - first.order * first.order);
            power = self.product(&power, &square);
        }
        Some(total)
    }

    /// Σ F⁽ⁿ⁾(c₀)/n! (u − c₀)ⁿ, c₀ the value of u at the axis.
    fn composed(&self, function: impl Fn(Expr) -> Expr, argument: Series) -> Option<Series> {
        let mut inner = argument;
        let constant = if inner.shift.is_zero() {
            let first = inner.coefficients.first_mut()?;
            std::mem::replace(first, Expr::zero())
        } else if inner.shift.is_negative() {
            // A pole that only seems to be one shows when its leading zeros are gone.
            let own = inner.stripped()?;
            return if own.shift.is_negative() { None } else { self.composed(function, own) };
        } else {
            Expr::zero()
        };
        let place = Symbol::new("expansion place");
        let here = Bindings::one(place.name(), constant);
        let mut outer = function(Expr::from(place.clone()));
        let first = here.apply(&outer);
        if !is_finite(&first) {
            return None;
        }
        let (mut total, mut power) = (self.constant(first), self.constant(Expr::one()));
        let mut factor = Expr::one();
        for n in 1..self.length {
            power = self.product(&power, &inner);
            outer = derivative(&outer, &place).ok()?;
            factor = factor * Expr::ratio(1, i64::try_from(n).ok()?);
            let value = here.apply(&outer);
            if !is_finite(&value) {
                return None;
            }
            let scaled = &factor * &value;
            let term = Series { shift: power.shift.clone(), coefficients: power.coefficients.iter().map(|own| own * &scaled).collect() };
            total = self.sum(total, term)?;
        }
        Some(total)
    }
}

/// What a Bessel or Struve function of a whole order ν is next to z = 0: c z^e, e its exponent, plus further powers e + 2, e + 4, …
///
/// The coefficient of every power j follows from that of j − 2 by the factor ±1/(j² − ν²), with the sign given here
/// (DLMF 10.2.2, 10.25.2, 11.2.1 and 11.2.2).
#[derive(Clone, Debug, PartialEq)]
pub struct FirstPower {
    /// The order ν ≥ 0.
    pub order: i64,
    /// The least power of z.
    pub exponent: i64,
    /// Its coefficient.
    pub coefficient: Expr,
    /// The sign of the factor: −1 for J and H, 1 for I and L.
    pub sign: i64,
}

/// Functions of larger orders are not expanded.
const LARGEST_ORDER: i64 = 32;

impl FirstPower {
    /// The first power of the function with this name; `None` for other functions and other orders.
    ///
    /// ```
    /// use sneddon_expr::expr::{Expr, FirstPower};
    /// let first = FirstPower::new("struveh", &Expr::zero()).unwrap();
    /// assert_eq!((first.coefficient, first.exponent), (Expr::integer(2) / Expr::pi(), 1));
    /// ```
    pub fn new(name: &str, order: &Expr) -> Option<Self> {
        let order = order.as_integer().filter(|n| (0..=LARGEST_ORDER).contains(n))?;
        let is_bessel = matches!(name, "besselj" | "besseli");
        let exponent = match name {
            "besselj" | "besseli" => order,
            "struveh" | "struvel" => order + 1,
            _ => return None,
        };
        // 2^e ν!, or 2^e Γ(3/2) Γ(ν + 3/2).
        let below: Vec<Expr> = match is_bessel {
            true => (1..=order).map(Expr::integer).collect(),
            false => (0..=order).map(|i| Expr::ratio(2 * i + 1, 2)).chain([Expr::pi() / Expr::integer(2)]).collect(),
        };
        let coefficient = Expr::one() / (Expr::integer(2).power(exponent) * Expr::product(below));
        Some(Self { order, exponent, coefficient, sign: if name.ends_with(['j', 'h']) { -1 } else { 1 } })
    }
}

impl Series {
    fn vanishes(&self) -> bool {
        self.coefficients.iter().all(Expr::is_zero)
    }

    /// The same with leading zeros taken into the shift; `None` if no coefficient is known not to vanish.
    fn stripped(mut self) -> Option<Self> {
        let zeros = self.coefficients.iter().take_while(|own| is_zero(own)).count();
        if zeros == self.coefficients.len() {
            return None;
        }
        self.coefficients.drain(..zeros);
        self.shift = &self.shift + &Number::integer(i64::try_from(zeros).ok()?);
        Some(self)
    }
}

fn is_zero(expr: &Expr) -> bool {
    expr.is_zero() || (expr.as_number().is_none() && normal::is_proven_zero(expr, &Symbol::new("r")))
}

/// False if a derivative at the place divides by zero, takes the logarithm of zero, or has another constant without a value in it.
fn is_finite(expr: &Expr) -> bool {
    expr.parts().all(|own| match own.node() {
        Node::Power(base, exponent) => !base.is_zero() || sign(exponent) == Sign::Positive,
        Node::Function(function, arguments) => {
            !(function.name() == "ln" && arguments.iter().any(Expr::is_zero)) && has_value(*function, arguments)
        }
        _ => true,
    })
}
