//! Sums in the form of a textbook: one coefficient for each root or function, common factors in front.

use super::{Expr, Node, Number, Symbol, rewritten};
use num_bigint::BigInt;
use num_traits::One;
use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};

/// Larger sums are left unchanged.
const TERMS: usize = 120;
/// Larger denominators are not multiplied out.
const LONGEST: u32 = 1000;
/// Sizes are compared up to this number of nodes.
const SIZE: usize = 20_000;

/// The sum with its products multiplied out and collected again by roots and functions, where that is clearly shorter.
///
/// ```
/// use sneddon_expr::expr::{Expr, collected};
/// let (x, b) = (Expr::symbol("x"), Expr::symbol("b"));
/// let root = (x.power(2) - b.power(2)).sqrt();
/// // x² w + x (b w − x) + x² = x w (x + b)
/// let sum = x.power(2) * &root + &x * (&b * &root - &x) + x.power(2);
/// assert_eq!(collected(&sum), &x * (&x + &b) * &root);
/// ```
pub fn collected(expr: &Expr) -> Expr {
    if !matches!(expr.node(), Node::Sum(_)) {
        return expr.clone();
    }
    let Some(terms) = products(expr, &|_| true) else { return expr.clone() };
    let size = |own: &Expr| own.size_up_to(SIZE);
    let mut result = grouped(&terms);
    if let Some(other) = over_one_root(&terms, false).map(|terms| grouped(&terms)).filter(|other| size(other) < size(&result)) {
        result = other;
    }
    // Keep the form stated by the rule unless the result is shorter by at least an eleventh, as E a (2 d + 4 h/3).
    if 11 * size(&result) <= 10 * size(expr) { result } else { expr.clone() }
}

/// The sum over one denominator, with its numerator multiplied out and collected; `None` if it has one already, or would be too long.
///
/// Where fractions cancel, the numerator shows what is left:
/// ```
/// use sneddon_expr::expr::{Expr, over_one_denominator};
/// let r = Expr::symbol("r");
/// // 1 - 1/(1+r) = r/(1+r)
/// let sum = Expr::one() - (Expr::one() + &r).power(-1);
/// assert_eq!(over_one_denominator(&sum), Some(&r / (Expr::one() + &r)));
/// ```
pub fn over_one_denominator(expr: &Expr) -> Option<Expr> {
    let terms = products(expr, &|_| true)?;
    over_one_root(&terms, true).map(|terms| grouped(&terms))
}

/// Moves common numeric factors of sums to the front where the result is shorter, and common powers out of roots.
///
/// ```
/// use sneddon_expr::expr::{Expr, in_lowest_terms};
/// let (a, b) = (Expr::symbol("a"), Expr::symbol("b"));
/// let halves = Expr::ratio(1, 2) * &a + Expr::ratio(3, 2) * &b;
/// assert_eq!(in_lowest_terms(&(Expr::integer(2) * &halves)), &a + Expr::integer(3) * &b);
/// let half = Expr::integer(2).sqrt() * (Expr::integer(2) * &a + Expr::integer(2) * &b).sqrt();
/// assert_eq!(in_lowest_terms(&half), Expr::integer(2) * (&a + &b).sqrt());
/// let root = (Expr::integer(4) * (a.power(2) * b.power(2)) + Expr::integer(4) * a.power(4)).sqrt();
/// assert_eq!(in_lowest_terms(&root), Expr::integer(2) * &a * (a.power(2) + b.power(2)).sqrt());
/// ```
pub fn in_lowest_terms(expr: &Expr) -> Expr {
    let digits = Digits::default();
    rewritten(expr, &|own, again| match own.node() {
        Node::Power(base, exponent) => Some(digits.out_of_power(&again(base), exponent)),
        Node::Product(factors) => {
            let product = Expr::product(factors.iter().map(again));
            // The result may contain new sums with common factors.
            Some(digits.shorter_product(&product).map_or(product, |other| again(&other)))
        }
        _ => None,
    })
}

/// How much there is to read in the parts of an expression, many of which occur repeatedly: the digits of all numbers but 1, and
/// the symbols.
///
/// The keys are addresses, because a test of equality compares whole expressions. Each part is kept, so that its address is not reused.
#[derive(Default)]
struct Digits(RefCell<HashMap<usize, (Expr, usize)>>);

impl Digits {
    /// The product with the common numeric factor of one of its sums in front, if that is shorter.
    fn shorter_product(&self, product: &Expr) -> Option<Expr> {
        let number = Expr::number(product.split_coefficient().0);
        let mut others = Vec::new();
        for factor in product.factors() {
            let rest = || product / &factor;
            match factor.node() {
                // Keep halves and thirds apart, with the number in front multiplied into the sum, unless the result is longer.
                Node::Sum(terms) => {
                    let inside = Expr::sum(terms.iter().map(|term| term * &number));
                    let outside = in_front(&inside);
                    if !outside.factors().contains(&factor) {
                        others.push(rest() / &number * outside);
                    }
                    let outside = shared_in_front(&factor);
                    if outside != factor {
                        others.push(rest() * outside);
                    }
                }
                // 1/√2 and √(2hR + 2R²) have a factor in common.
                Node::Power(base, exponent) if matches!(base.node(), Node::Sum(_)) => {
                    let inner = shared_in_front(base);
                    if inner != *base && inner.split_coefficient().0.is_positive() {
                        others.push(rest() * inner.pow(exponent));
                    }
                }
                _ => {}
            }
        }
        let shortest = others.into_iter().min_by_key(|own| self.of(own))?;
        (self.of(&shortest) < self.of(product)).then_some(shortest)
    }

    /// The power of a sum with the common factor of its terms outside, unless a root of a number would remain.
    fn out_of_power(&self, base: &Expr, exponent: &Expr) -> Expr {
        let plain = base.pow(exponent);
        let inner = if matches!(base.node(), Node::Sum(_)) { shared_in_front(base) } else { base.clone() };
        if inner == *base {
            return plain;
        }
        let (number, _) = inner.split_coefficient();
        let in_front = number.is_positive() && Expr::number(number).pow(exponent).as_number().is_some();
        // Only positive factors leave the root.
        let other = inner.pow(exponent);
        if in_front && self.of(&other) < self.of(&plain) { other } else { plain }
    }

    fn of(&self, expr: &Expr) -> usize {
        if let Some((_, known)) = self.0.borrow().get(&expr.address()) {
            return *known;
        }
        let found = match expr.node() {
            Node::Number(number) => {
                let length = |own: &BigInt| if own.magnitude().is_one() { 0 } else { own.to_string().len() };
                length(number.value().numer()) + length(number.value().denom())
            }
            Node::Constant(_) | Node::Symbol(_) => 1,
            Node::Function(..) => 1 + self.of_all(expr),
            Node::Sum(_) | Node::Product(_) | Node::Power(..) => self.of_all(expr),
        };
        self.0.borrow_mut().insert(expr.address(), (expr.clone(), found));
        found
    }

    fn of_all(&self, expr: &Expr) -> usize {
        expr.children().into_iter().map(|own| self.of(own)).sum()
    }
}

/// The largest number of which all are integer multiples; negative if all of them are negative.
fn shared_number(numbers: &[Number]) -> Number {
    let [first, others @ ..] = numbers else { return Number::integer(1) };
    // Decimals are shown as they were typed, and long fractions come from them.
    let is_plain = |own: &Number| !own.has_decimals() && *own.value().denom() <= BigInt::from(LONGEST);
    if !numbers.iter().all(is_plain) {
        return Number::integer(1);
    }
    let shared = others.iter().fold(first.abs(), |all, own| all.common_factor(own));
    if numbers.iter().all(Number::is_negative) { -&shared } else { shared }
}

/// Collects one coefficient for each product of kernels and takes the common factor out of the sum.
fn grouped(terms: &[Expr]) -> Expr {
    let mut groups: BTreeMap<Expr, Vec<Expr>> = BTreeMap::new();
    for term in terms {
        let (kernels, plain): (Vec<Expr>, Vec<Expr>) = term.factors().into_iter().partition(is_kernel);
        groups.entry(Expr::product(kernels)).or_default().push(Expr::product(plain));
    }
    let parts: Vec<Expr> = groups.into_iter().map(|(kernel, list)| kernel * in_front(&Expr::sum(list))).collect();
    in_front(&Expr::sum(parts))
}

/// The terms with every power of a sum lowered by whole steps to the lowest that occurs: q^(−1/2) is q q^(−3/2), and if `all` of the
/// terms get the denominator, 1 is q q^(−1).
///
/// `None` if nothing is lowered, or the terms would be too many.
fn over_one_root(terms: &[Expr], all: bool) -> Option<Vec<Expr>> {
    let powers = |term: &Expr| -> Vec<(Expr, Expr)> {
        let pairs = term.factors().iter().map(Expr::split_power).collect::<Vec<_>>();
        pairs.into_iter().filter(|(base, power)| matches!(base.node(), Node::Sum(_)) && power.as_number().is_some()).collect()
    };
    let mut lowest: Vec<(Expr, Expr)> = Vec::new();
    for (base, power) in terms.iter().flat_map(powers) {
        match lowest.iter_mut().find(|(own, least)| *own == base && (least as &Expr - &power).as_integer().is_some()) {
            Some((_, least)) if (least as &Expr - &power).as_integer().is_some_and(|steps| steps > 0) => *least = power,
            Some(_) => {}
            None => lowest.push((base, power)),
        }
    }
    let mut lowered = Vec::new();
    let mut changed = false;
    for term in terms {
        let mut products = vec![term.clone()];
        let own_powers = powers(term);
        for (base, least) in &lowest {
            let own = own_powers.iter().filter(|(own, _)| own == base).find_map(|(_, power)| (power - least).as_integer());
            let absent = if all { least.as_integer().map_or(0, |least| -least) } else { 0 };
            let steps = own.unwrap_or(absent);
            changed |= steps > 0;
            for _ in 0..steps {
                let inner = base.terms();
                products = products.iter().flat_map(|left| inner.iter().map(|right| left / base * right).collect::<Vec<_>>()).collect();
                if products.len() + lowered.len() > TERMS {
                    return None;
                }
            }
        }
        lowered.append(&mut products);
    }
    changed.then_some(lowered)
}

/// The sum with every factor that is a sum distributed, or as it is where that would be too long.
///
/// ```
/// use sneddon_expr::expr::{Expr, multiplied_out};
/// let r = Expr::symbol("r");
/// assert_eq!(multiplied_out(&(&r * (Expr::one() + r.power(-1)))), Expr::one() + &r);
/// ```
pub fn multiplied_out(expr: &Expr) -> Expr {
    products(expr, &|_| true).map_or_else(|| expr.clone(), Expr::sum)
}

/// Joins powers of one symbol that would be infinite separately: factors that are sums with roots or poles of the symbol are
/// distributed.
///
/// Polynomials remain factors: a factor r − b keeps its digits near b, whereas the difference of two products cancels there.
///
/// ```
/// use sneddon_expr::expr::{Expr, Symbol, joined_powers};
/// let r = Expr::symbol("r");
/// let radius = Symbol::new("r");
/// assert_eq!(joined_powers(&(&r * (Expr::one() + r.power(-1))), &radius), Expr::one() + &r);
/// let factored = &r * (&r - Expr::integer(3));
/// assert_eq!(joined_powers(&factored, &radius), factored);
/// ```
pub fn joined_powers(expr: &Expr, symbol: &Symbol) -> Expr {
    let singular = |factor: &Expr| {
        let (base, exponent) = factor.split_power();
        base.as_symbol() == Some(symbol) && exponent.as_integer().is_none_or(|n| n < 0)
    };
    products(expr, &|sum| sum.terms().iter().any(|term| term.factors().iter().any(singular))).map_or_else(|| expr.clone(), Expr::sum)
}

/// True for roots, functions and sums, including those in denominators; false for plain monomials.
fn is_kernel(factor: &Expr) -> bool {
    match factor.node() {
        Node::Function(..) | Node::Sum(_) => true,
        Node::Power(base, exponent) => exponent.as_integer().is_none() || !matches!(base.node(), Node::Symbol(_) | Node::Constant(_)),
        Node::Number(_) | Node::Constant(_) | Node::Symbol(_) | Node::Product(_) => false,
    }
}

/// The terms of the sum with every such factor that is a sum distributed; `None` if they would be too many.
fn products(expr: &Expr, is_distributed: &dyn Fn(&Expr) -> bool) -> Option<Vec<Expr>> {
    let mut done = Vec::new();
    for term in expr.terms() {
        let mut list = vec![Expr::one()];
        for factor in term.factors() {
            let distributed = matches!(factor.node(), Node::Sum(_)) && is_distributed(&factor);
            let inner = if distributed { products(&factor, is_distributed)? } else { vec![factor] };
            list = list.iter().flat_map(|left| inner.iter().map(move |right| left * right)).collect();
            if list.len() + done.len() > TERMS {
                return None;
            }
        }
        done.append(&mut list);
    }
    Some(done)
}

/// The common factor of the terms in front: of every base that all of them have, the power nearest to zero, and the greatest common
/// divisor of their coefficients where these have one denominator.
fn in_front(sum: &Expr) -> Expr {
    with_in_front(sum, number_in_front)
}

/// The same with the greatest common divisor of the coefficients also where their denominators differ.
fn shared_in_front(sum: &Expr) -> Expr {
    with_in_front(sum, shared_number)
}

fn with_in_front(sum: &Expr, shared: fn(&[Number]) -> Number) -> Expr {
    let terms = sum.terms();
    let [first, others @ ..] = terms.as_slice() else { return sum.clone() };
    if others.is_empty() {
        return sum.clone();
    }
    let mut common: Vec<(Expr, Expr)> =
        first.factors().iter().map(Expr::split_power).filter(|(base, p)| base.as_number().is_none() && p.as_number().is_some()).collect();
    for term in others {
        let own: Vec<(Expr, Expr)> = term.factors().iter().map(Expr::split_power).collect();
        common = common
            .into_iter()
            .filter_map(|(base, power)| {
                let (_, other) = own.iter().find(|(own, _)| *own == base)?;
                Some((base, lower(power, other)?))
            })
            .collect();
    }
    let number = shared(&terms.iter().map(|term| term.split_coefficient().0).collect::<Vec<_>>());
    let content = Expr::number(number) * Expr::product(common.into_iter().map(|(base, power)| base.pow(&power)));
    if content.is_one() {
        return sum.clone();
    }
    &content * Expr::sum(terms.iter().map(|term| term / &content))
}

/// The common factor of the numeric factors that makes none of them longer: halves and thirds are kept apart.
fn number_in_front(numbers: &[Number]) -> Number {
    let [first, others @ ..] = numbers else { return Number::integer(1) };
    let alike = others.iter().all(|own| own.value().denom() == first.value().denom());
    let one = if numbers.iter().all(Number::is_negative) { -1 } else { 1 };
    if alike { shared_number(numbers) } else { Number::integer(one) }
}

/// The exponent nearer to zero if both have the same sign, or the common exponent if they are equal.
fn lower(one: Expr, two: &Expr) -> Option<Expr> {
    if one == *two {
        return Some(one);
    }
    let (a, b) = (one.as_number()?, two.as_number()?);
    if a.is_negative() != b.is_negative() {
        return None;
    }
    let first_is_lower = (b - a).is_negative() == a.is_negative();
    Some(if first_is_lower { one } else { two.clone() })
}
