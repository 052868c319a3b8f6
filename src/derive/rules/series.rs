//! Kernels as hypergeometric series: K(r) = factor · r^offset · pFq(upper; lower; z r^step).

use super::combination::tidy;
use super::reading;
use crate::expr::{Condition, Expr, Node, Sign, Symbol, normal, sign};
use num_integer::Integer;

/// factor · r^offset · Σ Π (upper)_k/Π (lower)_k (z r^step)^k, k! among the lower parameters as 1.
#[derive(Clone)]
pub(super) struct Series {
    /// The factor, free of r.
    pub(super) factor: Expr,
    /// The power of r of the first term.
    pub(super) offset: Expr,
    upper: Vec<Expr>,
    lower: Vec<Expr>,
    z: Expr,
    /// (p, q) of the rational p/q.
    step: (i64, i64),
    /// The conditions of validity.
    pub(super) conditions: Vec<Condition>,
}

/// Largest number of series into which a series is split.
const MOST_PARTS: i64 = 4;
/// The highest power of r as a step.
const HIGHEST_STEP: i64 = 24;

fn half() -> Expr {
    Expr::ratio(1, 2)
}

fn positive(expr: &Expr) -> Option<&Expr> {
    (sign(expr) == Sign::Positive).then_some(expr)
}

impl Series {
    /// The series of a kernel that is one function or one power; `None` if it is not in the table.
    pub(super) fn of(kernel: &Expr) -> Option<Self> {
        match kernel.node() {
            Node::Function(function, arguments) if function.name() == "ln" => Self::logarithm(arguments.first()?),
            Node::Function(function, arguments) => Self::function(function.name(), arguments),
            Node::Power(base, exponent) => Self::binomial(base, exponent),
            Node::Sum(_) => Self::binomial(kernel, &Expr::one()),
            _ => None,
        }
    }

    /// (α + β r^μ)^p = α^p 1F0(−p; −β/α r^μ).
    fn binomial(base: &Expr, p: &Expr) -> Option<Self> {
        let terms = normal::normal_terms(base, &Symbol::new("r")).ok()?;
        let [one, two] = terms.as_slice() else { return None };
        if p.contains(&Symbol::new("r")) {
            return None;
        }
        let (constant, other) = if one.exponent.is_zero() { (one, two) } else { (two, one) };
        if !constant.exponent.is_zero() || !constant.kernel.is_one() || !other.kernel.is_one() {
            return None;
        }
        let conditions = reading::positive(&constant.coefficient)?;
        let z = -(&other.coefficient / &constant.coefficient);
        let mut series = Self::new(vec![-p], vec![], &z, &other.exponent)?;
        // Expand exponents, so that R^(4(p−1)) and the factor before it combine into one power.
        let (root, power) = constant.coefficient.split_power();
        series.factor = root.pow(&tidy(&(power * p)));
        series.conditions = conditions;
        Some(series)
    }

    /// ln(1 + u) = u 2F1(1, 1; 2; −u).
    fn logarithm(argument: &Expr) -> Option<Self> {
        let (k, alpha) = reading::monomial(&(argument - Expr::one()))?;
        let mut series = Self::new(vec![Expr::one(), Expr::one()], vec![Expr::integer(2)], &-&k, &alpha)?;
        series.factor = k;
        series.offset = alpha;
        Some(series)
    }

    /// pFq(upper; lower; z r^step), k! added to the lower parameters.
    fn new(upper: Vec<Expr>, mut lower: Vec<Expr>, z: &Expr, step: &Expr) -> Option<Self> {
        let number = step.as_number()?.value();
        let (p, q) = (i64::try_from(number.numer()).ok()?, i64::try_from(number.denom()).ok()?);
        lower.push(Expr::one());
        let series = Self { factor: Expr::one(), offset: Expr::zero(), upper, lower, z: z.clone(), step: (p, q), conditions: vec![] };
        (p > 0).then_some(series)
    }

    /// A function of u = k r^α, from its series in u or u².
    fn function(name: &str, arguments: &[Expr]) -> Option<Self> {
        let (argument, orders) = arguments.split_last()?;
        let (k, alpha) = reading::monomial(argument)?;
        if orders.iter().any(|order| order.contains(&Symbol::new("r"))) {
            return None;
        }
        let one = Expr::one;
        let square = |scale: Expr| (scale * k.power(2), &alpha * Expr::integer(2));
        let ratio = Expr::ratio;
        let fourth = |scale: Expr| (scale * k.power(4), &alpha * Expr::integer(4));
        let plain = || (k.clone(), alpha.clone());
        let (gauss, quarter) = (Expr::integer(2) / Expr::pi().sqrt(), Expr::pi() / Expr::integer(2));
        let fresnel = -Expr::pi().power(2) / Expr::integer(16);
        // Upper and lower parameters, argument with its step, the leading factor, and the leading power of u.
        let (upper, lower, (z, step), front, leading) = match (name, orders) {
            ("exp", []) => (vec![], vec![], plain(), one(), Expr::zero()),
            ("sin", []) => (vec![], vec![ratio(3, 2)], square(ratio(-1, 4)), one(), one()),
            ("cos", []) => (vec![], vec![half()], square(ratio(-1, 4)), one(), Expr::zero()),
            ("sinh", []) => (vec![], vec![ratio(3, 2)], square(ratio(1, 4)), one(), one()),
            ("cosh", []) => (vec![], vec![half()], square(ratio(1, 4)), one(), Expr::zero()),
            ("atan", []) => (vec![half(), one()], vec![ratio(3, 2)], square(-one()), one(), one()),
            ("atanh", []) => (vec![half(), one()], vec![ratio(3, 2)], square(one()), one(), one()),
            ("asinh", []) => (vec![half(), half()], vec![ratio(3, 2)], square(-one()), one(), one()),
            ("asin", []) => (vec![half(), half()], vec![ratio(3, 2)], square(one()), one(), one()),
            ("erf", []) => (vec![half()], vec![ratio(3, 2)], square(-one()), gauss, one()),
            ("erfi", []) => (vec![half()], vec![ratio(3, 2)], square(one()), gauss, one()),
            ("dawson", []) => (vec![one()], vec![ratio(3, 2)], square(-one()), one(), one()),
            ("fresnelc", []) => (vec![ratio(1, 4)], vec![half(), ratio(5, 4)], fourth(fresnel), one(), one()),
            ("fresnels", []) => {
                (vec![ratio(3, 4)], vec![ratio(3, 2), ratio(7, 4)], fourth(fresnel), Expr::pi() / Expr::integer(6), Expr::integer(3))
            }
            ("ellipk", []) => (vec![half(), half()], vec![one()], plain(), quarter, Expr::zero()),
            ("ellipe", []) => (vec![-half(), half()], vec![one()], plain(), quarter, Expr::zero()),
            ("besselj" | "besseli", [nu]) => {
                let (next, sign) = (nu + one(), if name == "besselj" { -1 } else { 1 });
                let front = half().pow(nu) / Expr::call("gamma", [positive(&next)?.clone()]);
                (vec![], vec![next], square(ratio(sign, 4)), front, nu.clone())
            }
            ("struveh" | "struvel", [nu]) => {
                let (next, sign) = (nu + ratio(3, 2), if name == "struveh" { -1 } else { 1 });
                let front = half().pow(nu) / (Expr::pi().sqrt() * Expr::call("gamma", [positive(&next)?.clone()]));
                (vec![one()], vec![ratio(3, 2), next], square(ratio(sign, 4)), front, nu + one())
            }
            ("hyp1f1", [a, b]) => (vec![a.clone()], vec![b.clone()], plain(), one(), Expr::zero()),
            ("hyp2f1", [a, b, c]) => (vec![a.clone(), b.clone()], vec![c.clone()], plain(), one(), Expr::zero()),
            _ => return None,
        };
        let mut series = Self::new(upper, lower, &z, &step)?;
        series.factor = front * k.pow(&leading);
        series.offset = alpha * leading;
        Some(series)
    }

    /// The same as a sum of series whose steps are even integers; `None` if that is not allowed.
    ///
    /// k = s i + j, j = 0 … s−1, with (A)_(si+j) = (A)_j s^(si) Π_t ((A+j+t)/s)_i. With as many upper as lower parameters the
    /// parts have singularities where z^s r^(s·step) is 1, which coincide with the singularities of the kernel only for z > 0.
    pub(super) fn with_even_step(&self) -> Option<Vec<Self>> {
        let (p, q) = self.step;
        let parts = (2 * q) / (2 * q).gcd(&p);
        let step = p * parts / q;
        if parts > MOST_PARTS || step > HIGHEST_STEP {
            return None;
        }
        let entire = self.upper.len() < self.lower.len();
        if !entire && parts % 2 == 0 && sign(&self.z) != Sign::Positive {
            return None;
        }
        let count = Expr::integer(parts);
        let excess = self.upper.len() as i64 - self.lower.len() as i64;
        let part = |j: i64| {
            let rising = |list: &[Expr]| Expr::product(list.iter().flat_map(|a| (0..j).map(move |t| a + Expr::integer(t))));
            let spread = |list: &[Expr]| {
                list.iter().flat_map(|a| (0..parts).map(|t| (a + Expr::integer(j + t)) / &count).collect::<Vec<_>>()).collect()
            };
            Self {
                factor: rising(&self.upper) / rising(&self.lower) * self.z.power(j),
                offset: Expr::ratio(p * j, q),
                upper: spread(&self.upper),
                lower: spread(&self.lower),
                z: self.z.power(parts) * count.power(parts * excess),
                step: (step, 1),
                conditions: Vec::new(),
            }
        };
        Some((0..parts).map(part).filter(|part| !part.factor.is_zero()).collect())
    }

    /// The series with every r^(n−1+step·k) replaced by its integral relative to the integral of r^(n−1), which is
    /// (n/2)_(step k/2)/(n/2+1/2)_(step k/2).
    pub(super) fn transformed(&self, n: &Expr, x: &Expr) -> Expr {
        let mu = self.step.0 / 2;
        let spread = |first: Expr| (0..mu).map(|j| (&first + Expr::integer(j)) / Expr::integer(mu)).collect::<Vec<_>>();
        let mut lower = self.lower.clone();
        lower.extend(spread(n / Expr::integer(2) + half()));
        let mut upper = Vec::new();
        for parameter in self.upper.iter().cloned().chain(spread(n / Expr::integer(2))) {
            match lower.iter().position(|own| *own == parameter) {
                Some(place) => drop(lower.swap_remove(place)),
                None => upper.push(parameter),
            }
        }
        // k! of the definition: one of the lower parameters is 1, or 1 is added above.
        match lower.iter().position(Expr::is_one) {
            Some(place) => drop(lower.swap_remove(place)),
            None => upper.push(Expr::one()),
        }
        upper.sort();
        lower.sort();
        &self.factor * named(&upper, &lower, self.z.clone() * x.power(self.step.0))
    }
}

/// pFq by its shortest name.
fn named(upper: &[Expr], lower: &[Expr], z: Expr) -> Expr {
    match (upper, lower) {
        ([], []) => Expr::call("exp", [z]),
        ([a], []) => (Expr::one() - z).pow(&-a),
        ([a], [b]) => Expr::call("hyp1f1", [a.clone(), b.clone(), z]),
        ([a, b], [c]) => Expr::call("hyp2f1", [a.clone(), b.clone(), c.clone(), z]),
        _ => {
            let counts = [upper.len(), lower.len()].map(|count| Expr::integer(count as i64));
            Expr::call("hyper", counts.into_iter().chain(upper.iter().cloned()).chain(lower.iter().cloned()).chain([z]))
        }
    }
}
