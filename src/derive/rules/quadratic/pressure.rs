//! Pressures that close: under odd m and half exponents, and under g = x times odd powers of √(ρ² + σx²).

use super::laurent::{Laurent, Values, Variable};
use super::moments::{Moment, Piece};
use super::pieces::{Field, artanh_of_legs};
use crate::derive::rule::{Branches, Pair};
use crate::expr::{Expr, normal};
use Variable::{AtEnd, Length, Square};

/// ∫_r^a g′/√(x²−r²) dx for g = x·(moment) with the moment A(x²) K(x) + x B(x², 1/s²), K = atan(x/ρ) or artanh(x/ρ).
///
/// Elementary where A is zero; else with the pressure under a hyperboloid or a sphere, which are dilogarithms.
pub(super) fn rooted(form: &Moment, field: &Field) -> Option<Branches> {
    let sigma = field.sigma;
    let mut total = Rooted::default();
    for (power, coefficient) in form.at(Piece::First).at_axis().in_x()? {
        let power = i64::from(power);
        // (x^(n+1) K)′ = (n+1) xⁿ K + x^(n+1) ρ/Q
        total.add(&Rooted::with_kernel(power, sigma)?, &coefficient.scaled(power + 1, 1));
        total.add(&Rooted::over_quadratic(power + 1, sigma), &coefficient.times(Length, 1));
    }
    // The root at the axis is xρ; one x more makes g of it.
    let equivalent = form.at(Piece::Root).at_axis().times(Variable::X, 2).times(Length, 1);
    for (power, coefficient) in equivalent.in_square(sigma)? {
        // (s^(−2k))′ = −2kσ x s^(−2k−2)
        let k = -i64::from(power);
        total.add(&Rooted::over_power(k + 1), &coefficient.scaled(-2 * k * sigma, 1));
    }
    let (r, a, length) = (Expr::symbol("r"), Expr::symbol("a"), field.square_length.sqrt());
    let c = (&field.square_length + Expr::integer(sigma) * r.power(2)).sqrt();
    let known = if sigma > 0 { "hyperboloid_pressure" } else { "sphere_pressure" };
    let (arc, end) = if sigma > 0 {
        (Expr::call("atan", [leg() / &c]), Expr::call("atan", [&a / &length]))
    } else {
        (artanh_of_legs(&r, &a, length.clone()), artanh_of_legs(&Expr::zero(), &a, length.clone()))
    };
    let terms = [
        expression(&total.known, field) * Expr::call(known, [r, a, length]),
        expression(&total.arc, field) * arc / c,
        expression(&total.root, field) * leg(),
        expression(&total.end, field) * leg() * end,
    ];
    Some(collected(&terms))
}

/// Multiples of four pieces, with w = √(a²−r²), c² = Q(r), S² = Q(a).
#[derive(Clone, Default)]
struct Rooted {
    /// The pressure under a hyperboloid or a sphere, ∫_r^a (xK)′/√(x²−r²) dx.
    known: Laurent,
    /// atan(w/c)/c or artanh(w/c)/c.
    arc: Laurent,
    /// w.
    root: Laurent,
    /// w K(a).
    end: Laurent,
}

impl Rooted {
    fn add(&mut self, other: &Self, factor: &Laurent) {
        let sum = |own: &Laurent, more: &Laurent| own.plus(&product(more, factor));
        *self = Self {
            known: sum(&self.known, &other.known),
            arc: sum(&self.arc, &other.arc),
            root: sum(&self.root, &other.root),
            end: sum(&self.end, &other.end),
        };
    }

    /// T_k = ∫ x s^(−2k)/√(x²−r²) dx by 2k c² T_(k+1) = w/S^(2k) + (2k−1) T_k.
    fn over_power(k: i64) -> Self {
        let square = |own: i64| Laurent::one().times(Square, -own as i32);
        let mut result = Self { arc: Laurent::one(), ..Self::default() };
        for own in 1..k {
            let step = |part: &Laurent| part.times(AtEnd, -1).scaled(1, 2 * own);
            result.root = step(&result.root.scaled(2 * own - 1, 1).plus(&square(own)));
            result.arc = step(&result.arc.scaled(2 * own - 1, 1));
        }
        for own in (k..=0).rev() {
            let step = |part: &Laurent| part.times(AtEnd, 1).scaled(2 * own, 2 * own - 1);
            result.root = step(&result.root).plus(&square(own).scaled(-1, 2 * own - 1));
            result.arc = step(&result.arc);
        }
        result
    }

    /// The factor of w in S_n = ∫ xⁿ/√(x²−r²) dx for odd n: n S_n = a^(n−1) w + (n−1) r² S_(n−2).
    fn power(n: i64) -> Laurent {
        (3..=n).step_by(2).fold(Laurent::one(), |before, own| {
            let first = Laurent::one().times(Variable::X, (own - 1) as i32);
            first.plus(&before.times(Variable::End, 2).scaled(own - 1, 1)).scaled(1, own)
        })
    }

    /// M_n = ∫ xⁿ/(Q√(x²−r²)) dx for odd n: M_(n+2) = σ(S_n − ρ² M_n).
    fn over_quadratic(n: i64, sigma: i64) -> Self {
        let mut result = Self { arc: Laurent::one(), ..Self::default() };
        for own in (1..n).step_by(2) {
            result.root = Self::power(own).plus(&result.root.times(Length, 2).scaled(-1, 1)).scaled(sigma, 1);
            result.arc = result.arc.times(Length, 2).scaled(-sigma, 1);
        }
        result
    }

    /// D_n = ∫ xⁿ K/√(x²−r²) dx for even n ≥ 0: n D_n = (n−1) r² D_(n−2) + a^(n−1) w K(a) − σρ(S_(n−1) − c² M_(n−1)).
    fn with_kernel(n: i64, sigma: i64) -> Option<Self> {
        if n < 0 || n % 2 != 0 {
            return None;
        }
        let mut result = Self { known: Laurent::one(), arc: Laurent::one().times(Length, 1).scaled(-1, 1), ..Self::default() };
        for own in (2..=n).step_by(2) {
            let before = |part: &Laurent| part.times(Variable::End, 2).scaled(own - 1, 1);
            let below = Self::over_quadratic(own - 1, sigma);
            let inner = |part: &Laurent| part.times(AtEnd, 1).times(Length, 1).scaled(sigma, 1);
            let power = Self::power(own - 1).times(Length, 1).scaled(-sigma, 1);
            result = Self {
                known: before(&result.known).scaled(1, own),
                arc: before(&result.arc).plus(&inner(&below.arc)).scaled(1, own),
                root: before(&result.root).plus(&power).plus(&inner(&below.root)).scaled(1, own),
                end: before(&result.end).plus(&Laurent::one().times(Variable::X, (own - 1) as i32)).scaled(1, own),
            };
        }
        Some(result)
    }
}

/// ∫_r^a g′/√(x²−r²) dx for g = x·(moment) with the moment A(x²) π/(2ρs) + B(x²) π/2: elliptic integrals and powers.
pub(super) fn elliptic(form: &Moment, field: &Field) -> Option<Branches> {
    let sigma = field.sigma;
    let mut total: [Laurent; 3] = std::array::from_fn(|_| Laurent::default());
    let mut add = |n: i64, coefficient: &Laurent| {
        for (own, part) in total.iter_mut().zip(elliptic_moment(n, sigma)) {
            *own = own.plus(&product(&part, coefficient));
        }
    };
    for (power, coefficient) in form.at(Piece::First).at_axis().in_square(sigma)? {
        // (x s^(−n))′ = (1−n) s^(−n) + n ρ² s^(−n−2)
        let n = 1 - 2 * i64::from(power);
        add(n, &coefficient.scaled(1 - n, 1));
        add(n + 2, &coefficient.times(Length, 2).scaled(n, 1));
    }
    let [first, second, root] = &total;
    let (r, a, length) = (Expr::symbol("r"), Expr::symbol("a"), field.square_length.sqrt());
    let at = |end: &Expr| &field.square_length + Expr::integer(sigma) * end.power(2);
    let (angle, parameter) = if sigma > 0 {
        (leg() / at(&r).sqrt(), -(&field.square_length / r.power(2)))
    } else {
        (leg() / at(&a).sqrt(), Expr::one() - &field.square_length / r.power(2))
    };
    let angle = Expr::call("atan", [angle]);
    let factor = Expr::pi() / (Expr::integer(2) * length);
    let mut terms = vec![
        expression(first, field) / &r * Expr::call("ellipf", [angle.clone(), parameter.clone()]) * &factor,
        expression(second, field) * &r * Expr::call("ellipe", [angle, parameter]) * &factor,
        expression(root, field) * &a * leg() / at(&a).sqrt() * &factor,
    ];
    // (x^(2k+1))′ = (2k+1) x^(2k)
    for (power, coefficient) in form.at(Piece::Second).at_axis().in_x()? {
        let moment = Expr::call("pressure_power", [Expr::integer(i64::from(power)), r.clone(), a.clone()]);
        let coefficient = expression(&coefficient, field) * Expr::integer(i64::from(power) + 1) * Expr::pi() / Expr::integer(2);
        terms.push(coefficient * moment);
    }
    Some(collected(&terms))
}

/// E_n = ∫_r^a s^(−n)/√(x²−r²) dx for odd n as multiples of F/r, r E and a w/S.
///
/// n ρ²c² E_(n+2) = (2−n) E_(n−2) + (n−1)(ρ²+c²) E_n − σ a w S^(−n).
fn elliptic_moment(n: i64, sigma: i64) -> [Laurent; 3] {
    let none = Laurent::default;
    let one = [Laurent::one(), none(), none()];
    // E_(−1): c² F/r − r E + a w/S for σ = 1, R² F/r − r E for σ = −1.
    let minus_one = if sigma > 0 {
        [Laurent::one().times(AtEnd, 1), Laurent::ratio(-1, 1), Laurent::one()]
    } else {
        [Laurent::one().times(Length, 2), Laurent::ratio(-1, 1), none()]
    };
    let combine = |(old, p): (&[Laurent; 3], i64), (near, q): (&[Laurent; 3], i64), (own, end): (i64, i64)| {
        let mut next: [Laurent; 3] = std::array::from_fn(|_| none());
        for ((slot, old), near) in next.iter_mut().zip(old).zip(near) {
            let middle = near.times(Length, 2).plus(&near.times(AtEnd, 1));
            *slot = old.scaled(p, 1).plus(&middle.scaled(q, 1));
        }
        if let Some(root) = next.last_mut() {
            // a w S^(−n) = (a w/S) S^(1−n)
            *root = root.plus(&Laurent::ratio(end * sigma, 1).times(Square, ((1 - own) / 2) as i32));
        }
        next
    };
    if n >= 1 {
        let (mut before, mut now) = (minus_one, one);
        for own in (1..n).step_by(2) {
            let next = combine((&before, 2 - own), (&now, own - 1), (own, -1));
            before = std::mem::replace(&mut now, next.map(|part| part.times(Length, -2).times(AtEnd, -1).scaled(1, own)));
        }
        return now;
    }
    let (mut before, mut now, mut own) = (one, minus_one, -1);
    while own > n {
        let far = before.map(|part| part.times(Length, 2).times(AtEnd, 1));
        let next = combine((&far, own), (&now, 1 - own), (own, 1));
        before = std::mem::replace(&mut now, next.map(|part| part.scaled(1, 2 - own)));
        own -= 2;
    }
    now
}

/// The product of a coefficient with one in powers of ρ alone.
fn product(part: &Laurent, factor: &Laurent) -> Laurent {
    factor.monomials().fold(Laurent::default(), |total, (length, number)| total.plus(&part.times(Length, length).times_number(number)))
}

/// √(a² − r²).
fn leg() -> Expr {
    (Expr::symbol("a").power(2) - Expr::symbol("r").power(2)).sqrt()
}

/// With x for a and e for r.
fn expression(part: &Laurent, field: &Field) -> Expr {
    let values = Values { x: Expr::symbol("a"), square_length: field.square_length.clone(), end: Expr::symbol("r"), sigma: field.sigma };
    part.to_expr(&values)
}

fn collected(terms: &[Expr]) -> Branches {
    let (content, rest) = normal::common_content(terms);
    Branches::endless(Pair::same(content * Expr::sum(rest)))
}
